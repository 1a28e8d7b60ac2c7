# Writes bindings/api/api.json from the public headers, or says where it is behind them.
#
# The file is committed, so that whoever writes a binding needs neither a compiler nor this program,
# and so that a change of the interface shows in a review as a change of one text. Objects that fit
# stand on a line of their own: a changed parameter is a changed line.
#
# usage: generate.py SOURCE [--check]     --check: write nothing, exit with 1 where the file differs

import difflib
import json
import os
import sys

import headers
import model

COLUMNS = 140


def formatted(value, indent=0):
    """JSON in which every object and array that fits stands on one line."""
    line = json.dumps(value, ensure_ascii=False)
    if len(line) + indent <= COLUMNS or not isinstance(value, (dict, list)) or not value:
        return line
    inside = " " * (indent + 1)
    if isinstance(value, dict):
        parts = [f"{json.dumps(key)}: {formatted(part, indent + 1)}" for key, part in value.items()]
        return "{\n" + ",\n".join(inside + p for p in parts) + "\n" + " " * indent + "}"
    parts = [inside + formatted(part, indent + 1) for part in value]
    return "[\n" + ",\n".join(parts) + "\n" + " " * indent + "]"


def main():
    source = os.path.abspath(sys.argv[1])
    path = os.path.join(source, "bindings", "api", "api.json")
    try:
        text = formatted(model.build(source)) + "\n"
    except headers.Trouble as trouble:
        print(trouble, file=sys.stderr)
        return 2
    old = ""
    if os.path.exists(path):
        with open(path, encoding="utf-8") as file:
            old = file.read()
    if "--check" in sys.argv[2:]:
        changes = list(difflib.unified_diff(old.splitlines(), text.splitlines(), "api.json",
                                            "the headers", lineterm="", n=1))
        print("\n".join(changes[:40]))
        return 1 if changes else 0
    with open(path, "w", encoding="utf-8", newline="\n") as file:
        file.write(text)
    return 0


if __name__ == "__main__":
    sys.exit(main())
