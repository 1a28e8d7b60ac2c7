# The reference of the command line: what the programs say of themselves when they are asked with --help.
# Nothing is written twice; what a test of tests/cli holds for --help is true here.

import re
import subprocess

import words


def help_of(*command):
    """What is said, whatever the status: where there is no --help it is the usage."""
    run = subprocess.run([*command, "--help"], capture_output=True, text=True)
    return run.stdout or run.stderr


def verbs(text):
    return re.findall(r"^  (\w+)  +(\S.*)$", text, re.M)


def literal(text):
    return [".. code-block:: text", ""] + ["   " + line if line else "" for line in text.rstrip().split("\n")] + [""]


def page(sf, more):
    """more: name and path of further programs."""
    whole = help_of(sf)
    lines = words.title("Command line", "=") + [
        "What ``sf VERB --help`` says. The status is 0 where all is good, 1 where what was asked for was not reached, "
        "2 for usage, 3 for bad input, 4 for memory or disk, 130 when cancelled. ``--json`` puts one object on "
        "standard output, for programs.", ""]
    for verb, what in verbs(whole):
        lines += words.title(f"sf {verb}", "-") + [words.inline(what[0].upper() + what[1:]), ""]
        lines += literal(help_of(sf, verb))
    for name, path in more:
        lines += words.title(name, "-") + literal(help_of(path))
    return "\n".join(lines) + "\n"
