# What the safe crate of Rust has: types, and for each function its head, a sentence, and the function of C
# behind it, found in the sources. cargo doc has the whole of it; this is the list that can be looked
# through beside that of C and Python.

import os
import re

import words

HEAD = re.compile(r"^(?P<indent> *)pub (?P<kind>fn|struct|enum|trait) (?P<name>\w+)(?P<rest>[^{;]*)", re.M)
IMPL = re.compile(r"^impl(?:<[^>]*>)? (?:[\w:]+(?:<[^>]*>)? for )?(?P<name>\w+)", re.M)
WORDS = re.compile(r"words!\((\w+)(?:[.:]\s*\w+)?")


def before(text, start):
    """The comments and attributes right above a place."""
    lines = []
    for line in reversed(text[:start].rstrip("\n").split("\n")):
        if not re.match(r"\s*(///|#\[)", line):
            break
        lines.insert(0, line.strip())
    return lines


def sentence(lines, api_words):
    said = []
    for line in [l[3:].strip() for l in lines if l.startswith("///")]:
        if not line:
            break
        said.append(line)
    if said:
        return words.inline(re.sub(r"\[([^\]]+)\](\([^)]*\))?", r"\1", " ".join(said)))
    named = WORDS.search("\n".join(lines))
    return words.inline(api_words.get(named.group(1), "")) if named else ""


def entry(match, text, api_words):
    lines = before(text, match.start())
    head = re.sub(r"\s+", " ", match.group("kind") + " " + match.group("name") + match.group("rest")).strip()
    head = re.sub(r" where .*|[(]$", "", head)
    said = sentence(lines, api_words)
    # A name that stands in words!() is what does the work, if it is a function.
    named = [n for n in WORDS.findall("\n".join(lines)) if n in words.FUNCTIONS]
    c = f" In C: :c:func:`{named[0]}`." if named else ""
    return head, said + c


def page(api, crate):
    api_words = {f["name"]: f["summary"] for f in api["functions"]}
    for kind in ("structs", "enums", "opaque"):
        api_words.update({t["name"]: t["doc"].split("\n")[0] for t in api[kind]})
    lines = words.title("Rust", "=") + [
        "The crate ``libsf``, from its sources. ``cargo doc --open`` in ``bindings/rust`` has all of it, with examples; "
        ":doc:`/bindings` says how to depend on it. ``libsf-sys`` has every function of :doc:`C </reference/c/index>` "
        "as it is.", ""]
    for name in sorted(n for n in os.listdir(crate) if n.endswith(".rs")):
        if name in ("words.rs", "lib.rs", "caught.rs", "array.rs"):
            continue
        with open(os.path.join(crate, name), encoding="utf-8") as file:
            text = file.read()
        impls = [(m.start(), m.group("name")) for m in IMPL.finditer(text)]
        found = []
        for match in HEAD.finditer(text):
            owner = [n for at, n in impls if at < match.start()][-1:] if match.group("indent") else []
            head, said = entry(match, text, api_words)
            found.append(((owner or [""])[0], head, said))
        if found:
            lines += words.title(name.removesuffix(".rs"), "-")
            for owner, head, said in found:
                # A long head is cut where its line would be.
                whole = (owner + "::" if owner else "") + head.removeprefix("fn ") if owner else head
                lines += [f"``{whole}``", f"   {said or 'As its name says.'}", ""]
    return "\n".join(lines) + "\n"
