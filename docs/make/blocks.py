# What the pages show is run. Finds the blocks of code of a page, and runs them in a folder of the page's
# own, one after another, as a reader would: files that one makes are there for the next. The pictures of
# the pages are made so, and tests/docs holds every block to it.
#
# A comment right before a block says more; readers do not see it:
#
#   <!-- file: NAME -->         the block is written to this file, and is no program
#   <!-- first: COMMANDS -->    these are run before, quietly; where they end with 77, the block is skipped
#   <!-- exit: N -->            the status that the last command of a shell block must have (0)
#   <!-- prints -->             the block is just what the one before it printed
#   <!-- given: C -->           what a piece of C that is no program is compiled with: parameters
#   <!-- with: C -->            and what stands before it: macros, variables
#   <!-- not run: REASON -->    the one way out; the test counts these
#
# Languages: sh, c, python, rust, json are run or read; text, vtk and session are for people, and files.

import json
import os
import re
import shutil
import subprocess
import sys

LANGUAGES = ("sh", "c", "python", "rust", "json", "toml", "cmake", "text", "vtk", "session", "meson")
# In the folder of a page: the text of its blocks that were skipped.
SKIPPED = "skipped.txt"
COMMENT = re.compile(r"<!--\s*(file|first|exit|prints|given|with|not run)(?::\s*((?:(?!-->).)*?))?\s*-->\s*\Z", re.S)


class Block:
    """A block of a page: its language, its text, its line, and what the comments before it say."""

    def __init__(self, page, line, language, text, before):
        self.page, self.line, self.language, self.text = page, line, language, text
        self.says = {}
        while True:
            match = COMMENT.search(before)
            if match is None:
                break
            self.says[match.group(1)] = match.group(2) or ""
            before = before[:match.start()]

    def place(self):
        return f"{self.page}:{self.line}"


def find(page, text):
    """The blocks of a page, in order. What is no fenced block is none: an indented one is refused."""
    found = []
    for match in re.finditer(r"^```([^`\n]*)\n(.*?)^```$", text, re.M | re.S):
        if match.group(1).startswith("{"):
            continue
        found.append(Block(page, text.count("\n", 0, match.start()) + 1, match.group(1), match.group(2),
                           text[:match.start()].rstrip(" ")))
    return found


def stray(text):
    """Lines of indented blocks, which nothing would run."""
    blank = re.sub(r"^(```+).*?^\1$|<!--.*?-->", lambda m: "\n" * m.group(0).count("\n"), text, flags=re.M | re.S)
    lines = blank.split("\n")
    return [i + 1 for i, line in enumerate(lines)
            if line.startswith("    ") and line.strip() and i > 0 and not lines[i - 1].strip()
            and not re.match(r"\s+([-*]|\d+\.)\s", line)]


def excused(folder, picture):
    """Whether a picture may be missing: a block that was skipped would have made it."""
    path = os.path.join(folder, SKIPPED)
    if not os.path.exists(path):
        return False
    with open(path, encoding="utf-8") as file:
        return re.search(r"(?<![\w.-])" + re.escape(picture) + r"(?![\w.-])", file.read()) is not None


class Runner:
    """Runs the blocks of one page in one folder."""

    def __init__(self, source, build, folder, seconds=300):
        self.source, self.build, self.folder, self.seconds = source, build, folder, seconds
        self.printed, self.python_so_far = "", []
        os.makedirs(folder, exist_ok=True)
        self.environment = dict(os.environ)
        tools = [os.path.join(build, "demo", "sf"), os.path.join(build, "demo", "verify"),
                 os.path.join(build, "demo", "firmware"), os.path.join(build, "demo", "fill")]
        libraries = [os.path.join(build, "libsf", room) for room in ("", "io", "link")]
        self.environment["PATH"] = os.pathsep.join(tools + [self.environment.get("PATH", "")])
        self.environment["LD_LIBRARY_PATH"] = os.pathsep.join(libraries)
        self.environment["PKG_CONFIG_PATH"] = os.path.join(build, "meson-uninstalled")
        self.environment["PYTHONPATH"] = os.path.join(build, "bindings", "python")
        self.environment.update(MPLBACKEND="Agg", LIBSF_SOURCE=source)

    def command(self, *words):
        """Status, and everything that was said."""
        try:
            run = subprocess.run(words, cwd=self.folder, env=self.environment, stdin=subprocess.DEVNULL,
                                 stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                                 timeout=self.seconds)
        except subprocess.TimeoutExpired:
            return 124, f"not done after {self.seconds} s"
        return run.returncode, run.stdout

    def run(self, block):
        """None where all is well, "skip: why", or what is wrong."""
        if block.language not in LANGUAGES:
            return f"language '{block.language}'; there are {', '.join(LANGUAGES)}"
        if "not run" in block.says:
            return "skip: " + block.says["not run"] if block.says["not run"] else "'not run' has no reason"
        if "first" in block.says:
            status, said = self.command("sh", "-euc", block.says["first"])
            if status == 77:
                return f"skip: {said.strip() or 'what goes before it is not to be had'}"
            if status != 0:
                return f"what goes before it ends with {status}:\n{said}"
        if "file" in block.says:
            with open(os.path.join(self.folder, block.says["file"]), "w", encoding="utf-8") as file:
                file.write(block.text)
        if "prints" in block.says:
            return self.compare(block)
        way = getattr(self, "run_" + block.language, None)
        wrong = way(block) if way else None
        if wrong and wrong.startswith("skip: "):
            self.printed = None
        return wrong

    def excuse(self, block):
        """Keep in mind that a block was skipped: what it would have drawn is not there."""
        with open(os.path.join(self.folder, SKIPPED), "a", encoding="utf-8") as file:
            file.write(block.text)

    def compare(self, block):
        if self.printed is None:
            return "skip: what prints it was not run"
        shown, printed = block.text.strip(), self.printed.strip()
        return None if shown == printed else f"it shows\n{shown}\nbut what was printed is\n{printed}"

    def run_sh(self, block):
        status, self.printed = self.command("sh", "-euc", block.text)
        wanted = int(block.says.get("exit") or 0)
        return None if status == wanted else f"ends with {status}, not {wanted}:\n{self.printed}"

    def run_json(self, block):
        try:
            json.loads(block.text)
        except ValueError as error:
            return str(error)
        return None

    def run_c(self, block):
        """A program is compiled, linked and run; a piece of one is compiled."""
        if "file" in block.says and not re.search(r"^int main\(", block.text, re.M):
            return None
        flags = ["-std=c99", "-Wall", "-Wextra", "-Werror", "-I" + os.path.join(self.source, "libsf", "include")]
        whole = re.search(r"^int main\(", block.text, re.M)
        text = block.text if whole else self.piece(block)
        name = os.path.splitext(block.says.get("file") or f"block{block.line}.c")[0]
        with open(os.path.join(self.folder, name + ".c"), "w", encoding="utf-8") as file:
            file.write(text)
        compiler = os.environ.get("CC", "cc").split()
        if not whole:
            status, said = self.command(*compiler, *flags, "-Wno-unused", "-Wno-unused-result",
                                        "-fsyntax-only", name + ".c")
            return None if status == 0 else said
        adapters = re.findall(r"#include <sf/link/(\w+)\.h>", text)
        for adapter in adapters:
            if not os.path.exists(os.path.join(self.build, "libsf", "link", f"libsf-{adapter}.so")):
                self.printed = None
                return f"skip: the adapter {adapter} is not built"
        libraries = ["-L" + os.path.join(self.build, "libsf", room) for room in ("link", "io", "")]
        libraries += [f"-lsf-{adapter}" for adapter in adapters] + ["-lsf-io", "-lsf", "-lm"]
        status, said = self.command(*compiler, *flags, name + ".c", "-o", name, *libraries)
        if status != 0:
            return said
        status, self.printed = self.command("./" + name)
        wanted = int(block.says.get("exit") or 0)
        return None if status == wanted else f"ends with {status}, not {wanted}:\n{self.printed}"

    def piece(self, block):
        """A piece of C as a file: in a function, unless it has one of its own."""
        headers = ["chip", "exchange", "io", "session", "sf"]
        head = "".join(f"#include <sf/{h}.h>\n" for h in headers) + block.says.get("with", "") + "\n"
        if re.search(r"^\{$", block.text, re.M):
            return head + block.text
        given = block.says.get("given") or "void"
        return head + f"void piece({given});\nvoid piece({given})\n{{\n" + block.text + "}\n"

    def run_python(self, block):
        """The blocks of a page are one program, of which each is run after those before it."""
        if not os.path.isdir(os.path.join(self.build, "bindings", "python", "libsf")):
            return "skip: the Python package is not built"
        program = "".join(self.python_so_far) + "print('----')\n" + block.text
        python = os.environ.get("LIBSF_PYTHON", sys.executable)
        status, said = self.command(python, "-W", "error", "-c", program)
        if status != 0:
            missing = re.search(r"No module named '(\w+)'", said)
            return (f"skip: there is no {missing.group(1)}" if missing and missing.group(1) != "libsf" else
                    f"ends with {status}:\n{said}")
        self.python_so_far.append(block.text)
        self.printed = said.rsplit("----\n", 1)[1]
        return None

    def run_rust(self, block):
        """A program, run by cargo on the libraries of this build, where cargo has what it needs."""
        if shutil.which("cargo") is None:
            return "skip: cargo is not installed"
        crate = os.path.join(self.source, "bindings", "rust", "libsf")
        folder = os.path.join(self.folder, "rust")
        os.makedirs(os.path.join(folder, "src"), exist_ok=True)
        with open(os.path.join(folder, "Cargo.toml"), "w", encoding="utf-8") as file:
            file.write('[package]\nname = "page"\nversion = "0.0.0"\nedition = "2021"\n[workspace]\n'
                       f'[dependencies]\nlibsf = {{ path = "{crate}", features = ["system"] }}\n')
        with open(os.path.join(folder, "src", "main.rs"), "w", encoding="utf-8") as file:
            file.write(block.text)
        self.environment["CARGO_TARGET_DIR"] = os.path.join(self.build, "rust", "pages")
        status, said = self.command("cargo", "run", "--offline", "--quiet", "--manifest-path",
                                    os.path.join(folder, "Cargo.toml"))
        if status == 101 and "offline" in said:
            return "skip: the crates that it is built with are not there; the suite 'rust' fetches them"
        self.printed = said
        return None if status == 0 else said
