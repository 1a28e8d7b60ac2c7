# Makes libsf one source and one header, sf.c and sf.h, for programs that take a library by copying it.
#
# usage: amalgamate.py SOURCE FOLDER [DEPFILE]
#
# sf.h is all public headers, each once, in the order in which they include one another. sf.c is every
# source of libsf and libsf-io, one after another, in one translation unit. Three things could go wrong
# there, and each is settled here and not by rules for those who write the sources:
#
#   * Two files may have private names of their own that are the same word. Where a word is defined at
#     file scope in more than one of them, it is given the file's name as an ending. Members of structs
#     keep theirs: a word after a dot or an arrow, and one that a struct declares, is left alone.
#   * A macro of one file must not reach the next, so that each file's are undefined after it.
#   * A header without a guard is a template: it is copied in wherever it is included, as if it stood in
#     that file; all others are copied in once.
#
# What the compiler then says is the check (tests/install/one_file.sh): a word that was missed is defined
# twice, and does not compile. Sources in C++ (adapters, glTF) stay outside.

import glob
import os
import re
import sys

TOKEN = re.compile(r"""
    (?P<comment>//[^\n]*|/\*.*?\*/)
  | (?P<text>"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])*')
  | (?P<number>\.?[0-9](?:[eEpP][+-]|[\w.])*)
  | (?P<word>[A-Za-z_]\w*)
  | (?P<sign>->|\#\#|\.\.\.|[^\s\w])
  | (?P<blank>\\\n|\s+)
""", re.X | re.S)
DIRECTIVE = re.compile(r"^[ \t]*#[ \t]*(\w+)((?:\\\n|/\*.*?\*/|[^\n])*)", re.M | re.S)
INCLUDE = re.compile(r'^#[ ]*include ([<"])([^>"]+)[>"][^\n]*\n', re.M)
GUARD = re.compile(r"^#ifndef (\w+_H)\n#define \1$", re.M)
# What one source asks for before it includes anything; in one file it has to stand at the head.
POSIX = "#define _POSIX_C_SOURCE 200809L\n"
# Words of the C library, and of zlib, that a file may have for its own as long as it does not include their header.
TAKEN = """round trunc ceil floor exp exp2 log log2 pow sin cos tan atan hypot fmin fmax fdim fma remainder
scalb scale y0 y1 yn j0 j1 jn gamma signgam index rindex div ldiv random link unlink read write open close
pipe pause dup truncate sync select remove rename time clock signal raise stat send accept listen bind near
far small interface compress uncompress inflate deflate crc32 adler32""".split()

HEAD = """// SPDX-License-Identifier: MIT
// libsf {version} in one {what}: {text}
// Made by libsf/package/amalgamate.py from the sources of libsf; changes belong there.

"""


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def write(path, text):
    """Leaves a whole file or none."""
    with open(path + ".new", "w", encoding="utf-8", newline="\n") as file:
        file.write(text)
    os.replace(path + ".new", path)


class Tree:
    """The sources, and which of them were read."""

    def __init__(self, source):
        self.room = os.path.join(source, "libsf")
        self.read = set()

    def text(self, name):
        path = os.path.join(self.room, name)
        self.read.add(path)
        return read(path)

    def find(self, mark, name):
        """The file of ours that an #include means, or None where it is the system's."""
        name = "include/" + name if mark == "<" else name
        return name if os.path.exists(os.path.join(self.room, name)) else None


def sources(tree):
    """The C sources in floors' order, which is also an order of reading."""
    rooms = ["base", "simd", "voxel", "support", "mesh", "orient", "balance", "grade", "sculpt", "io"]
    found = []
    for room in rooms:
        whole = glob.glob(os.path.join(tree.room, room, "**", "*.c"), recursive=True)
        found += sorted(os.path.relpath(p, tree.room).replace(os.sep, "/") for p in whole)
    return found


# --- public headers ------------------------------------------------------------------------------


def public_header(tree, name, done):
    """A public header with those that it includes, less what an earlier one has brought."""
    if name in done:
        return ""
    done.add(name)

    def included(match):
        inner = tree.find(match.group(1), match.group(2))
        return public_header(tree, inner, done) if inner else match.group(0)

    return INCLUDE.sub(included, tree.text(name))


# --- private names -------------------------------------------------------------------------------


def tokens(text):
    """Kind and text of each token; a directive is one token. Joined they are the text."""
    at = 0
    while at < len(text):
        match = DIRECTIVE.match(text, at) if at == 0 or text[at - 1] == "\n" else None
        if match is not None:
            yield "directive", match.group(0)
        else:
            match = TOKEN.match(text, at)
            yield match.lastgroup, match.group(0)
        at = match.end()


def chunks(text):
    """The outermost declarations, as lists of (word, depth of braces, depth of brackets)."""
    chunk, braces, rounds = [], 0, 0
    for kind, word in tokens(text):
        if kind in ("comment", "blank", "directive"):
            continue
        braces -= word == "}"
        rounds -= word == ")"
        chunk.append((word, braces, rounds))
        braces += word == "{"
        rounds += word == "("
        body_ends = word == "}" and braces == 0 and is_function(chunk)
        if braces == 0 and rounds == 0 and (word == ";" or body_ends):
            yield chunk
            chunk = []


def outer(chunk):
    """The words of a declaration outside all braces and brackets; "()" stands for what is in these."""
    words = []
    for word, braces, rounds in chunk:
        if braces == 0 and rounds == 0 and word != ")":
            words.append(word)
    return words


def is_function(chunk):
    words = outer(chunk)
    brace = words.index("{") if "{" in words else len(words)
    return brace > 0 and "(" in words[:brace] and "=" not in words[:brace]


def defined(text):
    """The words that a file defines for itself at file scope, and its macros."""
    names = set()
    for chunk in chunks(text):
        words = outer(chunk)
        names |= {words[i + 1] for i, w in enumerate(words[:-2])
                  if w in ("struct", "union", "enum") and words[i + 2] == "{"}
        if "enum" in words and "{" in words:
            inside = [(w, r) for w, b, r in chunk if b == 1]
            names |= {w for i, (w, r) in enumerate(inside) if r == 0 and re.match(r"[A-Za-z_]\w*$", w)
                      and (i == 0 or inside[i - 1][0] == ",")}
        if words and words[0] == "typedef":
            pointer = [chunk[i + 1][0] for i, (w, b, _) in enumerate(chunk[:-1])
                       if b == 0 and w == "*" and chunk[i - 1][0] == "("]
            names |= set(pointer[:1]) or {words[-2]}
        elif "static" in words:
            end = min((words.index(m) for m in ("=", "[", ";", "{") if m in words), default=len(words))
            head = [w for w in words[:end] if w not in ("{", "}")]
            if "__attribute__" in head:
                at = head.index("__attribute__")
                head = head[:at] + head[at + 2:]
            names.add(head[head.index("(") - 1] if "(" in head else head[-1])
    macros = set()
    for kind, word in tokens(text):
        match = re.match(r"#[ ]*define\s+(\w+)", word.strip()) if kind == "directive" else None
        if match:
            macros.add(match.group(1))
    return names, macros


def renamed(text, names):
    """The text with each word that names has replaced by what it has there, unless it is a struct's member."""
    if not names:
        return text
    all_tokens = list(tokens(text))
    seen = [(i, kind, word) for i, (kind, word) in enumerate(all_tokens)
            if kind not in ("comment", "blank", "directive")]
    depth, structs = 0, []
    for at, (i, kind, word) in enumerate(seen):
        before = seen[at - 1][2] if at else ""
        after = seen[at + 1][2] if at + 1 < len(seen) else ""
        if word == "{":
            two_before = seen[at - 2][2] if at > 1 else ""
            depth += 1
            if "struct" in (before, two_before) or "union" in (before, two_before):
                structs.append(depth)
        elif word == "}":
            structs = [d for d in structs if d != depth]
            depth -= 1
        elif kind == "word" and word in names and before not in (".", "->"):
            declares = structs and structs[-1] == depth and (
                after in (";", ",", ":", "[") or (after == ")" and before == "*"))
            if not declares:
                all_tokens[i] = (kind, names[word])
    pattern = re.compile(r"(?<![\w.>])(" + "|".join(map(re.escape, sorted(names))) + r")\b")
    return "".join(pattern.sub(lambda m: names[m.group(1)], word)
                   if kind == "directive" and not INCLUDE.match(word + "\n") else word
                   for kind, word in all_tokens)


# --- sources and private headers -----------------------------------------------------------------


class Part:
    """A source or a private header: its text without what it includes, which headers these are, and
    the words that it defines for itself."""

    def __init__(self, tree, name):
        self.name, self.includes = name, []
        self.text = self.expand(tree, tree.text(name).replace(POSIX, ""))
        self.words, self.macros = defined(self.text)
        self.ending = "_" + re.sub(r"\W", "_", name)

    def expand(self, tree, text):
        def included(match):
            inner = tree.find(match.group(1), match.group(2))
            if inner is None:
                return match.group(0)
            if inner.startswith("include/"):
                return ""
            body = tree.text(inner)
            if GUARD.search(body):
                self.includes.append(inner)
                return ""
            return self.expand(tree, body)

        return INCLUDE.sub(included, text)


def one_source(tree):
    parts, order = {}, []

    def add(name):
        """Those that a part includes come before it."""
        if name not in parts:
            parts[name] = Part(tree, name)
            for inner in parts[name].includes:
                add(inner)
            order.append(name)

    for name in sources(tree):
        add(name)
    counts, sees = dict.fromkeys(TAKEN, 1), {}
    for name in order:
        part = parts[name]
        sees[name] = {name}.union(*(sees[inner] for inner in part.includes))
        # A struct whose name a header has given out is the header's, wherever its members stand.
        part.words -= set().union(*(parts[inner].words for inner in sees[name] - {name}))
        for word in part.words | part.macros:
            counts[word] = counts.get(word, 0) + 1
    texts = [POSIX, '#define SF_BUILDING\n#include "sf.h"\n']
    for name in order:
        names = {word: word + parts[seen].ending for seen in sees[name]
                 for word in parts[seen].words | parts[seen].macros if counts[word] > 1}
        texts.append(f"\n// ==== {name} ====\n\n" + renamed(parts[name].text, names))
        if name.endswith(".c"):
            texts += [f"#undef {names.get(m, m)}\n" for m in sorted(parts[name].macros)]
    return "".join(texts)


def main():
    tree = Tree(sys.argv[1])
    folder = sys.argv[2]
    os.makedirs(folder, exist_ok=True)
    version = re.search(r'SF_VERSION_STRING "([^"]+)"', read(os.path.join(tree.room, "include/sf/base.h")))
    # Whoever compiles sf.c into a program imports nothing.
    static = "#if !defined(SF_SHARED) && !defined(SF_STATIC)\n#define SF_STATIC\n#endif\n\n"
    public = ["include/sf/sf.h"] + sorted("include/sf/" + os.path.basename(p) for p in
                                          glob.glob(os.path.join(tree.room, "include", "sf", "*.h")))
    done = set()
    header = "".join(public_header(tree, name, done) for name in public)
    write(os.path.join(folder, "sf.h"), HEAD.format(
        version=version.group(1), what="header", text="sf/sf.h and sf/io.h.") + static + header)
    write(os.path.join(folder, "sf.c"), HEAD.format(
        version=version.group(1), what="source", text="cc -O2 -ffp-contract=off -c sf.c, and link with -lm.")
        + one_source(tree))
    if len(sys.argv) > 3:
        output = os.path.join(folder, "sf.c")
        write(sys.argv[3], output + ": " + " ".join(sorted(tree.read)) + "\n")


main()
