# Comments of the interface as reStructuredText. Comments are plain text in which a name stands between
# backticks, a function has its brackets and a status its capitals; here these become links where the
# reference has the name, and everything that would mean something to Sphinx is quoted.

import re

# What the reference has; c_reference.py fills it.
FUNCTIONS, TYPES, VALUES = set(), set(), set()

PIECE = re.compile(r"`([^`]+)`|\b(sf_\w+)\(\)|\b(sf_[a-z0-9_]+)\b|\b(SF_[A-Z0-9_]+)\b|(<sf/\w+\.h>)")
SPECIAL = re.compile(r"([\\*|_`])")


def plain(text):
    """Text that means nothing but itself."""
    return SPECIAL.sub(r"\\\1", text)


def linked(match):
    code, function, name, value, header = match.groups()
    if code is not None:
        return "\\ ``" + code.strip() + "``\\ "
    if function is not None:
        return f"\\ :c:func:`{function}`\\ " if function in FUNCTIONS else f"\\ ``{function}()``\\ "
    if name is not None:
        kind = "func" if name in FUNCTIONS else "type" if name in TYPES else None
        return f"\\ :c:{kind}:`{name}`\\ " if kind else plain(name)
    if value is not None:
        return f"\\ :c:macro:`{value}`\\ " if value in VALUES else plain(value)
    return f"\\ ``{header}``\\ "


def inline(text):
    """One paragraph, with links."""
    parts, at = [], 0
    text = re.sub(r"\s+", " ", text.strip())
    for match in PIECE.finditer(text):
        parts += [plain(text[at:match.start()]), linked(match)]
        at = match.end()
    whole = "".join(parts + [plain(text[at:])])
    # "T. Reiner" begins no list.
    whole = re.sub(r"^(\w{1,4})([.)]) ", r"\1\\\2 ", re.sub(r"^([-+]) ", r"\\\1 ", whole))
    return re.sub(r"^\\ |\\ $", "", re.sub(r"\\  | \\ ", " ", whole)).strip()


def paragraphs(text, indent=""):
    """Paragraphs and lists of a comment, as lines."""
    lines = []
    for part in re.split(r"\n\s*\n", text.strip()):
        items = re.split(r"(?:^|\s)\* (?=[A-Z`a-z])", part.strip())
        if part.lstrip().startswith("* ") and len(items) > 1:
            for item in [i for i in items if i.strip()]:
                lines.append(f"{indent}* {inline(item)}")
            lines.append("")
        elif part.strip():
            lines += [indent + inline(part), ""]
    return lines


def title(text, mark):
    return [text, mark * len(text), ""]
