# Reads the public headers: what they declare, and the comment that stands above each declaration.
#
# The headers are written in a small part of C: enums with numbers, structs of plain fields, opaque
# structs, pointers to functions, functions, and constants that are one expression. That part is
# read here whole, token by token; whatever lies outside it is an error that names its line, never
# passed over, because what is not read is missing in every binding without a word. There is no
# preprocessor: conditional blocks hold linkage alone and are left out.
#
# A type is a dictionary: {"kind": "integer" | "float" | "void", "name"}, {"kind": "enum" | "struct" |
# "opaque" | "callback", "name"}, {"kind": "pointer", "const", "to"}, with "count" where a parameter
# was written as an array and "const" only where it is true, {"kind": "array", "count", "of"} in structs, and {"kind": "callback",
# "returns", "parameters"} for a pointer to a function that has no name of its own.

import re

INTEGERS = {"char", "int", "int8_t", "int16_t", "int32_t", "int64_t", "uint8_t", "uint16_t",
            "uint32_t", "uint64_t", "size_t"}
FLOATS = {"float", "double"}
LIMITS = {"UINT16_MAX": (2**16 - 1, "int"), "UINT32_MAX": (2**32 - 1, "uint32_t"),
          "UINT64_MAX": (2**64 - 1, "uint64_t"), "INT32_MAX": (2**31 - 1, "int32_t")}
TOKENS = re.compile(r"""(?P<after>/\*\*<.*?\*/) | (?P<before>/\*\*.*?\*/) | (?P<skip>/\*.*?\*/|//[^\n]*|\s+)
    | (?P<number>0[xX][0-9a-fA-F]+[uUlL]*|\d+\.?\d*(?:[eE][-+]?\d+)?[uUlLfF]*)
    | (?P<word>[A-Za-z_]\w*) | (?P<string>"[^"\n]*") | (?P<mark><<|[-+*(){}\[\],;=&.])""", re.S | re.X)


class Trouble(Exception):
    """A header that is not written in the part of C that is read here."""


def inner(comment):
    """The text within a comment, without its frame of stars."""
    text = re.sub(r"^/\*\*<?|\*/$", "", comment).strip("\n")
    return re.sub(r"^[ \t]*\*(?: |$)", "", text, flags=re.M).strip()


def pointer_to(type_, is_const):
    return {"kind": "pointer", **({"const": True} if is_const else {}), "to": type_}


def essay(text):
    """What a header says at its head, below the licence."""
    lines = []
    for line in text.split("\n")[1:]:
        if not line.startswith("//"):
            break
        lines.append(line[2:].removeprefix(" "))
    return "\n".join(lines)


def without_conditions(text):
    """The text without its conditional blocks but the guard; lines keep their numbers."""
    kept, depth = [], 0
    for line in text.split("\n"):
        opens = re.match(r"#\s*(if\w*)\b", line)
        is_guard = re.match(r"#ifndef \w+_H$", line)
        if opens and not is_guard:
            depth += 1
        kept.append("" if depth or is_guard or re.match(r"#(endif|define \w+_H$)", line) else line)
        if re.match(r"#\s*endif", line) and depth:
            depth -= 1
    return "\n".join(kept)


class Reader:
    """The tokens of a header, and the rules of its grammar."""

    def __init__(self, name, text, known):
        self.name, self.known = name, known
        self.constants, self.found = {}, []
        self.tokens = list(self.cut(without_conditions(text)))
        self.at = 0

    def cut(self, text):
        position = 0
        doc_above = None
        while position < len(text):
            line = text.count("\n", 0, position) + 1
            if text[position] == "#" and (position == 0 or text[position - 1] == "\n"):
                end = text.find("\n", position)
                yield "directive", text[position:end], line, doc_above
                doc_above, position = None, end
                continue
            match = TOKENS.match(text, position)
            if not match:
                raise Trouble(f"{self.name}:{line}: cannot read {text[position:position + 20]!r}")
            position = match.end()
            if match.lastgroup == "before":
                doc_above = inner(match.group())
            elif match.lastgroup != "skip":
                yield match.lastgroup, match.group(), line, doc_above
                doc_above = None

    def wrong(self, wanted):
        _, text, line, _ = self.tokens[min(self.at, len(self.tokens) - 1)]
        raise Trouble(f"{self.name}:{line}: {wanted} wanted, {text!r} found")

    def peek(self, ahead=0):
        place = self.at + ahead
        return self.tokens[place][1] if place < len(self.tokens) else ""

    def kind(self):
        return self.tokens[self.at][0] if self.at < len(self.tokens) else ""

    def take(self, wanted=None):
        if self.at >= len(self.tokens) or wanted not in (None, self.peek()):
            self.wrong(wanted or "more")
        self.at += 1
        return self.tokens[self.at - 1][1]

    def take_word(self):
        if self.kind() != "word":
            self.wrong("a name")
        return self.take()

    def accept(self, text):
        if self.peek() == text:
            self.at += 1
            return True
        return False

    def doc(self):
        """The comment just above the token that comes next."""
        return self.tokens[self.at][3]

    def doc_after(self):
        if self.kind() == "after":
            return inner(self.take())
        return None

    # --- types -----------------------------------------------------------------------------------

    def base_type(self):
        """A type without its stars; and whether it is const."""
        is_const = self.accept("const")
        self.accept("struct")
        name = self.take_word()
        is_const = self.accept("const") or is_const
        if name == "void":
            return {"kind": "void", "name": name}, is_const
        if name in INTEGERS:
            return {"kind": "integer", "name": name}, is_const
        if name in FLOATS:
            return {"kind": "float", "name": name}, is_const
        if name not in self.known:
            self.at -= 1
            self.wrong("a known type")
        return {"kind": self.known[name], "name": name}, is_const

    def pointers(self, base, is_const):
        while self.accept("*"):
            base = pointer_to(base, is_const)
            is_const = self.accept("const")
        return base

    def declarator(self, base, is_const, is_parameter=False):
        """A name and its type: stars before, brackets after, or a pointer to a function."""
        type_ = self.pointers(base, is_const)
        if self.accept("("):
            self.take("*")
            name = self.take_word()
            self.take(")")
            return name, {"kind": "callback", "returns": type_, "parameters": self.parameters()}
        name = self.take_word()
        counts = []
        while self.accept("["):
            counts.append(self.expression()[0])
            self.take("]")
        if is_parameter and counts:
            for count in reversed(counts[1:]):
                type_ = {"kind": "array", "count": count, "of": type_}
            return name, {**pointer_to(type_, is_const), "count": counts[0]}
        for count in reversed(counts):
            type_ = {"kind": "array", "count": count, "of": type_}
        return name, type_

    def parameters(self):
        self.take("(")
        if self.peek() == "void" and self.peek(1) == ")":
            self.take("void")
            self.take(")")
            return []
        found = []
        while True:
            name, type_ = self.declarator(*self.base_type(), is_parameter=True)
            found.append({"name": name, "type": type_})
            if not self.accept(","):
                self.take(")")
                return found

    # --- constants -------------------------------------------------------------------------------

    def expression(self):
        """The value of a constant and its type in C: sums, shifts, casts and brackets."""
        value, type_ = self.term()
        while self.peek() in ("+", "-", "<<"):
            mark = self.take()
            other, _ = self.term()
            value = value << other if mark == "<<" else value + (other if mark == "+" else -other)
        return value, type_

    def term(self):
        if self.accept("-"):
            value, type_ = self.term()
            return -value, type_
        if self.accept("("):
            if self.peek() in INTEGERS:
                type_ = self.take()
                self.take(")")
                return self.term()[0], type_
            found = self.expression()
            self.take(")")
            return found
        if self.kind() == "number":
            return self.number(self.take())
        if self.kind() == "string":
            return self.take()[1:-1], "string"
        name = self.take_word()
        if name in LIMITS:
            return LIMITS[name]
        found = self.constants.get(name) or self.known.get("constants", {}).get(name)
        if not found:
            self.at -= 1
            self.wrong("a known constant")
        return found

    def number(self, text):
        body = text.rstrip("uUlL") if text[:2].lower() == "0x" else text.rstrip("uUlLfF")
        if re.search(r"[.eE]", body) and text[:2].lower() != "0x":
            return float(body), "double"
        value = int(body, 0)
        if text[len(body):].lower() == "u":
            return value, "uint32_t" if value < 2**32 else "uint64_t"
        if text != body or value >= 2**31:
            self.at -= 1
            self.wrong("a number of 32 bits, or one with a cast")
        return value, "int"

    # --- declarations ----------------------------------------------------------------------------

    def directive(self):
        _, line, number, doc = self.tokens[self.at]
        self.at += 1
        define = re.match(r"#define (\w+) +(.+?)\s*$", line)
        if line.startswith("#include"):
            self.found.append(("include", re.search(r"[<\"]([^>\"]+)", line).group(1), None, None))
        elif define:
            inside = Reader(f"{self.name}:{number}", "", self.known)
            inside.tokens = list(inside.cut(define.group(2)))
            inside.constants = self.constants
            value = inside.expression()
            if inside.at != len(inside.tokens):
                inside.wrong("one expression")
            self.constants[define.group(1)] = value
            self.found.append(("constant", define.group(1), doc, value))
        else:
            raise Trouble(f"{self.name}:{number}: cannot read {line!r}")

    def enum(self, doc):
        name = self.take_word()
        self.take("{")
        values = []
        while not self.accept("}"):
            above = self.doc()
            word = self.take_word()
            self.take("=")
            number = self.expression()[0]
            self.constants[word] = (number, "int")
            is_last = not self.accept(",")
            values.append({"name": word, "value": number, "doc": self.doc_after() or above})
            if is_last:
                self.take("}")
                break
        self.finish(name, "enum", doc, values)

    def struct(self, doc):
        name = self.take_word()
        if not self.accept("{"):
            self.finish(name, "opaque", doc, None)
            return
        self.known.setdefault(name, "struct")
        fields = []
        while not self.accept("}"):
            above = self.doc()
            base, is_const = self.base_type()
            group = [self.declarator(base, is_const)]
            while self.accept(","):
                group.append(self.declarator(base, is_const))
            self.take(";")
            text = self.doc_after() or above
            fields += [{"name": n, "type": t, "doc": text} for n, t in group]
        self.finish(name, "struct", doc, fields)

    def finish(self, name, kind, doc, value):
        if self.take_word() != name:
            self.at -= 1
            self.wrong(name)
        self.take(";")
        self.known[name] = kind
        self.found.append((kind, name, doc, value))

    def callback(self, doc):
        name, type_ = self.declarator(*self.base_type())
        self.take(";")
        if type_["kind"] != "callback":
            self.wrong("a pointer to a function")
        self.known[name] = "callback"
        self.found.append(("callback", name, doc, type_))

    def function(self, doc):
        is_checked = self.accept("SF_CHECKED")
        returns = self.pointers(*self.base_type())
        name = self.take_word()
        parameters = self.parameters()
        self.take(";")
        self.found.append(("function", name, doc, {"returns": returns, "parameters": parameters,
                                                   "checked": is_checked}))

    def read(self):
        while self.at < len(self.tokens):
            doc = self.doc()
            if self.kind() == "directive":
                self.directive()
            elif self.accept("SF_API"):
                self.function(doc)
            elif self.accept("typedef"):
                if self.accept("enum"):
                    self.enum(doc)
                elif self.peek() == "struct" and (self.peek(2) == "{" or self.peek(3) == ";"):
                    self.take("struct")
                    self.struct(doc)
                else:
                    self.callback(doc)
            else:
                self.wrong("a declaration")
        return self.found


def read_header(name, text, known):
    """Everything that a header declares, in order: (kind, name, comment, what else there is).

    `known` maps the names of types from the headers that it includes to their kinds, "constants" to
    those of constants, and is added to."""
    reader = Reader(name, text, known)
    found = reader.read()
    known.setdefault("constants", {}).update(reader.constants)
    return found
