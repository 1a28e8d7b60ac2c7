# Takes the comment of a declaration apart: what it says first, what it says about each argument and
# result, and which of the house's tags it has.
#
# A comment is prose with tags. Lines of prose are joined into paragraphs, so that a binding can
# break them anew; lines that are indented stay as they are, because they show a format.

import re

TAGS = ["param", "return", "cost", "threads", "source", "since"]
CODES = re.compile(r"\bSF_(?:OK|ERR_[A-Z]+)\b")


def paragraphs(text):
    """Lines joined into paragraphs, which a blank line parts; indented ones are kept, and an item of
    a list, which begins with a dash, has a line of its own."""
    done = []
    for part in re.split(r"\n[ \t]*\n", text.strip("\n")):
        lines = part.split("\n")
        if all(line.startswith("   ") for line in lines):
            done.append("\n".join(line.rstrip() for line in lines))
            continue
        stripped = [line.strip() for line in lines]
        done.append(re.sub(r"\n(?!- )", " ", "\n".join(stripped)).strip())
    return "\n\n".join(p for p in done if p)


def sentence(text):
    """The first sentence of a text: up to a full stop, or a colon, that ends a word group."""
    match = re.match(r".*?[.](?=\s+[A-Z`0-9\"]|\s*$)", text.split("\n\n")[0], re.S)
    return match.group() if match else text.split("\n\n")[0]


def take_apart(comment):
    """A comment as a dictionary: text, params (name to text), and each other tag that it has."""
    parts = re.split(r"(?:^|(?<=\s))@(" + "|".join(TAGS) + r")\b", comment)
    found = {"text": paragraphs(parts[0]), "params": {}}
    for tag, said in zip(parts[1::2], parts[2::2]):
        if tag == "param":
            name, _, rest = said.strip().partition(" ")
            found["params"][name.strip()] = paragraphs(rest.strip())
        else:
            found[tag] = paragraphs(said.strip())
    return found


def referred(text):
    """The functions that a @return names for their codes."""
    return re.findall(r"\b(sf_\w+)\(\)", text)
