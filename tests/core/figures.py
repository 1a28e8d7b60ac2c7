# What a checker on a chip takes: code, read from the linker's map, and stack, the longest way through
# the calls that the compiler lists (-fcallgraph-info=su).

import os
import re

# memcpy and memset come from elsewhere; what they are taken to use. The run on a board measures it.
FOREIGN = 32


def code(path):
    """Bytes of code and constants by object file."""
    with open(path, encoding="utf-8") as file:
        text = file.read()
    text = text[text.index("Linker script and memory map"):]
    text = re.sub(r"(\n \.[\w.]+)\n +0x", r"\1 0x", text)  # long names stand on a line of their own
    sizes = {}
    for size, name in re.findall(
            r"^ \.(?:text|rodata|vectors)\S* +0x[0-9a-f]+ +0x([0-9a-f]+) (\S.*)$", text, re.M):
        sizes[name] = sizes.get(name, 0) + int(size, 16)
    return sizes


class Calls:
    """Who calls whom, and how much stack each takes."""

    def __init__(self, folder):
        self.stack, self.calls, self.indirect = {}, {}, set()
        for name in sorted(os.listdir(folder)):
            if name.endswith(".ci"):
                with open(os.path.join(folder, name), encoding="utf-8") as file:
                    self.read(file.read())

    def read(self, text):
        for title, label in re.findall(r'node: \{ title: "([^"]+)" label: "([^"]*)"', text):
            bytes_of = re.search(r"(\d+) bytes \((\w+)", label)
            if bytes_of:
                if bytes_of.group(2) != "static":
                    raise SystemExit(f"{title} has a stack that no compiler can tell")
                self.stack[self.short(title)] = int(bytes_of.group(1))
        for source, target in re.findall(r'sourcename: "([^"]+)" targetname: "([^"]+)"', text):
            if target == "__indirect_call":
                self.indirect.add(self.short(source))
            else:
                self.calls.setdefault(self.short(source), set()).add(self.short(target))

    @staticmethod
    def short(title):
        # A static function has its file before it: two of one name are told apart by the folder's.
        return title.split("/")[-1]

    def depth(self, name, above=()):
        """The deepest that the stack gets below and with a function, apart from callbacks."""
        if name in above:
            raise SystemExit(f"{name} calls itself")
        if name not in self.stack:
            return FOREIGN
        below = [self.depth(n, above + (name,)) for n in self.calls.get(name, ())]
        return self.stack[name] + max(below, default=0)

    def depth_to(self, name, goal, above=()):
        """The deepest way from a function to one that it leads to; None: there is none."""
        if name == goal:
            return self.stack[name]
        ways = [self.depth_to(n, goal, above + (name,)) for n in self.calls.get(name, ())
                if n not in above and n in self.stack]
        ways = [w for w in ways if w is not None]
        return self.stack[name] + max(ways) if ways else None

    def worst(self, entries):
        """By entry; and what a push takes when the decoder hands over what it decoded."""
        found = {name: self.depth(name) for name in entries}
        callers = [n for n in self.indirect if self.depth_to("sf_chip_push", n)]
        to_decoder = max(self.depth_to("sf_chip_push", n) for n in callers)
        found["sf_chip_push, a decoder, sf_chip_grey"] = to_decoder + self.depth("sf_chip_grey")
        return found
