# Why: a test that no change of a shader turns red holds nothing. This program changes the shaders of
# the brushes line by line, one line at a time and each line of code once, builds the tests of suite
# gl, runs them until one is red, and writes what it found. It takes an hour, so it is no
# test itself; mutants.md is what it found, sorted by hand.
#
# usage: mutate.py SOURCE BUILD > mutants.md
# SOURCE is a copy of the project to work in, which is changed and put back; BUILD its build.

import os
import re
import subprocess
import sys
import threading

SOURCE, BUILD = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
ONLY = sys.argv[3:]
SHADERS = os.path.join(SOURCE, "demo/sculpt/gpu")
# Tests, in this order, and how long each may take.
SECONDS = {"strokes": 200, "contract": 40, "history": 60, "quiet": 40}

# An operator becomes another; the first that a line has.
COMPARISONS = [(" != ", " == "), (" == ", " != "), (" <= ", " > "), (" >= ", " < "), (" < ", " >= "),
               (" > ", " <= ")]
OPERATORS = [("|=", "&="), ("&=", "|="), ("+=", "-="), ("-=", "+="), ("^=", "|="), (" << ", " >> "),
             (" >> ", " << "), ("~", ""), (" & ", " | "), (" | ", " & "), (" ^ ", " | "),
             (" && ", " || "), (" || ", " && "), ("min(", "max("), ("max(", "min("), (" + ", " - "),
             (" - ", " + "), (" * ", " + "), (" / ", " % "), (" % ", " / "), ("findLSB", "findMSB"),
             ("findMSB", "findLSB"), ("++", "--"), ("--", "++")]
NUMBERS = [("0u", "1u"), ("1u", "2u"), ("2u", "1u"), ("NONE", "7u"), ("true", "false")]


def swap(line, pairs):
    found = [(line.find(a), a, b) for a, b in pairs if a in line]
    if not found:
        return None
    at, a, b = min(found)
    return line[:at] + b + line[at + len(a):]


def mutants(line):
    """The line changed in one place, in ways to be tried until one compiles; none where it holds no
    code that could be changed."""
    code = line.split("//")[0].rstrip()
    text = code.strip()
    if not text or text in ("{", "}", "};", "else {", "} else {", "break;", "continue;", "default:"):
        return []
    if re.match(r"(#|layout|struct|const|shared|uint \w+\[|case \w+:$|void main|[A-Z]+\()", text):
        return []
    if re.match(r"\w+ \w+\([^;]*$", text) and not re.match(r"(return|else)\b", text):
        return []  # the head of a function
    if text.startswith("for ("):  # one round less; other changes would never end
        less = re.sub(r"(\w+) (<=?) ", r"\1 + 1u \2 ", code, 1)
        less = less if less != code else re.sub(r" > ([^;]+);", r" > \1 + 1u;", code, 1)
        return [less if less != code else code.replace("!= 0u", "> 1u")]
    swaps = [swap(code, COMPARISONS), swap(code, OPERATORS), swap(code, NUMBERS)]
    is_condition = re.match(r"(if|while|for|\} else if)\b", text)
    if not is_condition and text.endswith(";") and not re.match(r"(return|case|default)\b", text):
        gone = code[:len(code) - len(code.lstrip())] + ";"
        swaps = [gone, swaps[1], swaps[0], swaps[2]]
    return [s for s in swaps if s is not None]


def lines_to_change(name):
    with open(os.path.join(SHADERS, name)) as file:
        lines = file.read().split("\n")
    for i, line in enumerate(lines):
        # Barriers need a machine that does not run a work group in order.
        changed = [] if "emoryBarrier" in line else mutants(line.rstrip("\\").rstrip())
        tail = " \\" if line.endswith("\\") else ""
        if changed:
            yield lines, i, line, [c + tail for c in changed]


def first_red(test):
    """How a test turns red; None where it is green. It is not heard out after its first red case."""
    run = subprocess.Popen([os.path.join(BUILD, "tests/gl/gl-" + test)], stdout=subprocess.PIPE,
                           stderr=subprocess.DEVNULL, text=True)
    killer = threading.Timer(SECONDS[test], run.kill)
    killer.start()
    red = None
    for line in run.stdout:
        case = re.match(r"not ok \d+ - (\S+)", line)
        if "does not compile" in line or case:
            red = "does not compile" if not case else f"{test}: {case.group(1)}"
            run.kill()
            break
    run.stdout.close()
    code = run.wait()
    ended = killer.is_alive()
    killer.cancel()
    if red is None and code != 0:
        red = f"{test}: dies" if ended else f"{test}: does not end"
    return red


def turns_red():
    """The first test that is red, and how; None where all are green."""
    for test in SECONDS:
        subprocess.run(["ninja", "-C", BUILD, "tests/gl/gl-" + test], capture_output=True, check=True)
        red = first_red(test)
        if red:
            return red
    return None


def cell(text):
    return "`" + " ".join(text.split()).replace("|", "\\|") + "`"


def main():
    print("| line | was | became | red |\n|---|---|---|---|")
    for name in sorted(os.listdir(SHADERS)):
        if not name.endswith((".comp", ".glsl")) or (ONLY and name not in ONLY):
            continue
        path = os.path.join(SHADERS, name)
        with open(path) as file:
            before = file.read()
        for lines, i, was, ways in lines_to_change(name):
            for became in ways:
                with open(path, "w") as file:
                    file.write("\n".join(lines[:i] + [became] + lines[i + 1:]))
                red = turns_red()
                if red != "does not compile":
                    break
            with open(path, "w") as file:
                file.write(before)
            if red == "does not compile":
                continue
            print(f"| {name}:{i + 1} | {cell(was)} | {cell(became)} | {red or '**none**'} |",
                  flush=True)


main()
