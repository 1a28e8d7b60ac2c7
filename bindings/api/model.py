# Makes of the headers what a binding wants to know, as one dictionary: docs/bindings.md tells its
# fields. Whatever a program can read out of types is read out of types; the rest is read out of the
# comments, whose words are therefore fixed:
#
#   "NULL" in what is said of a pointer means that it may be NULL; "not NULL" or "not be NULL" that
#   it may not. Where nothing is said of it, it may not, and a call with a status refuses it.
#   "freed" means that the call ends the object, so that whoever owned it does so no more.
#   A pointer to a pointer to something opaque receives a new object, which the caller owns.
#
# Offsets and sizes are those of machines with 64-bit pointers; tests/api asks the compiler.

import os
import re

import comments
import headers

FOLDER = "libsf/include/"
IO = {"cage_io", "contour_io", "exchange", "gltf", "io", "job", "layers", "session", "threemf"}
SIZES = {"char": 1, "int8_t": 1, "uint8_t": 1, "int16_t": 2, "uint16_t": 2, "int": 4, "int32_t": 4,
         "uint32_t": 4, "float": 4, "int64_t": 8, "uint64_t": 8, "size_t": 8, "double": 8}


def read_all(source):
    """Every header, those first that others include: name to (text, declarations)."""
    known, done = {}, {}

    def visit(name, above):
        if name in done:
            return
        if name in above:
            raise headers.Trouble(f"{name} includes itself")
        with open(os.path.join(source, FOLDER, name), encoding="utf-8") as file:
            text = file.read()
        for other in re.findall(r"^#include <(sf/\w+\.h)>", text, re.M):
            visit(other, above | {name})
        done[name] = text, headers.read_header(name, text, known)

    # Adapters (sf/link) are libraries of their own, which no binding is linked to.
    for name in sorted(n for n in os.listdir(os.path.join(source, FOLDER, "sf")) if n.endswith(".h")):
        visit(f"sf/{name}", set())
    return done


def is_pointer(type_):
    return type_["kind"] in ("pointer", "callback")


def may_be_null(text):
    """True or False as a text says it, None where it says nothing."""
    if re.search(r"\b(not|never)( be)? NULL", text):
        return False
    return True if "NULL" in text else None


def points_to(type_, depth):
    """The opaque type behind so many pointers, or None."""
    for _ in range(depth):
        if type_["kind"] != "pointer":
            return None
        type_ = type_["to"]
    return type_["name"] if type_["kind"] == "opaque" else None


# --- what a function is -----------------------------------------------------------------------------


def parameter(function, said):
    name, type_ = function["name"], function["type"]
    text = said["params"].get(name, "")
    found = {"name": name, "type": type_}
    if is_pointer(type_):
        found["nullable"] = bool(may_be_null(text))
    if points_to(type_, 2):
        found["owned"] = True
    if points_to(type_, 1) and re.search(r"\bfreed\b", text):
        found["freed"] = True
    found["doc"] = text
    return found


def function(name, header, comment, value):
    said = comments.take_apart(comment or "")
    returns = {"type": value["returns"]}
    if is_pointer(value["returns"]):
        returns["nullable"] = may_be_null(said.get("return", "") or said["text"]) is not False
    if "return" in said:
        returns["doc"] = said["return"]
    summary = comments.sentence(said["text"])
    found = {"name": name, "header": header, "library": library(header), "summary": summary,
             "doc": said["text"][len(summary):].lstrip(" ").strip("\n"),
             "parameters": [parameter(p, said) for p in value["parameters"]], "returns": returns,
             "must_use": value["checked"]}
    found.update({tag: said[tag] for tag in ("cost", "threads", "source", "since") if tag in said})
    return found


def add_codes(functions):
    """To each function with a status the codes that its @return names, itself or by reference."""
    by_name = {f["name"]: f for f in functions}

    def codes(name, seen):
        if name in seen or name not in by_name:
            return set()
        seen.add(name)
        text = by_name[name]["returns"].get("doc", "")
        found = set(comments.CODES.findall(text))
        for other in comments.referred(text):
            found |= codes(other, seen)
        return found

    for f in functions:
        if f["returns"]["type"].get("name") == "sf_status":
            f["returns"]["codes"] = sorted(codes(f["name"], set()))


def library(header):
    return "sf-io" if header[3:-2] in IO else "sf"


# --- what types are --------------------------------------------------------------------------------


def align_up(size, to):
    return (size + to - 1) // to * to


def size_of(type_, structs):
    """Size and alignment of a type in bytes, with pointers of 64 bits."""
    kind = type_["kind"]
    if kind in ("pointer", "callback"):
        return 8, 8
    if kind == "enum":
        return 4, 4
    if kind == "array":
        size, align = size_of(type_["of"], structs)
        return size * type_["count"], align
    if kind == "struct":
        return structs[type_["name"]]["size"], structs[type_["name"]]["align"]
    return SIZES[type_["name"]], SIZES[type_["name"]]


def lay_out(struct, structs):
    at, widest = 0, 1
    for field in struct["fields"]:
        size, align = size_of(field["type"], structs)
        field["offset"] = align_up(at, align)
        at, widest = field["offset"] + size, max(widest, align)
    struct["size"], struct["align"] = align_up(at, widest), widest


def struct(name, header, comment, fields):
    found = {"name": name, "header": header, "doc": comments.paragraphs(comment or ""), "fields": []}
    for f in fields:
        text = comments.paragraphs(f["doc"] or "")
        made = {"name": f["name"], "type": f["type"]}
        if is_pointer(f["type"]) and may_be_null(text) is not None:
            made["nullable"] = may_be_null(text)
        found["fields"].append({**made, "doc": text})
    return found


def describe_owners(opaque, functions):
    """Who makes and who ends each opaque object."""
    for o in opaque:
        name = o["name"]
        ends = [f["name"] for f in functions if any(p.get("freed") and points_to(p["type"], 1) == name
                                                    for p in f["parameters"])]
        plain = [e for e in ends if returns_nothing(functions, e)]
        o["destroy"] = plain[0] if len(plain) == 1 else None
        o["ends"] = ends
        if not ends:
            for f in functions:
                for p in f["parameters"]:
                    if points_to(p["type"], 2) == name:
                        del p["owned"]
        o["makes"] = [f["name"] for f in functions
                      if any(points_to(p["type"], 2) == name for p in f["parameters"])]


def returns_nothing(functions, name):
    return next(f for f in functions if f["name"] == name)["returns"]["type"]["kind"] == "void"


def build(source):
    """The interface as one dictionary."""
    api = {"format": "libsf-api", "format_version": 1, "version": None, "headers": [],
           "constants": [], "enums": [], "opaque": [], "callbacks": [], "structs": [],
           "functions": []}
    sizes = {}
    for header, (text, declared) in read_all(source).items():
        includes = [n for kind, n, _, _ in declared if kind == "include"]
        api["headers"].append({"name": header, "library": library(header), "includes": includes,
                               "doc": comments.paragraphs(headers.essay(text))})
        for kind, name, comment, value in declared:
            doc = comments.paragraphs(comment or "")
            if kind == "constant":
                api["constants"].append({"name": name, "header": header, "type": value[1],
                                         "value": value[0], "doc": doc})
            elif kind == "enum":
                values = [{**v, "doc": comments.paragraphs(v["doc"] or "")} for v in value]
                api["enums"].append({"name": name, "header": header, "doc": doc, "values": values})
            elif kind == "opaque":
                api["opaque"].append({"name": name, "header": header, "doc": doc})
            elif kind == "callback":
                api["callbacks"].append({"name": name, "header": header, "doc": doc,
                                         "returns": value["returns"],
                                         "parameters": value["parameters"]})
            elif kind == "struct":
                made = struct(name, header, comment, value)
                sizes[name] = made
                lay_out(made, sizes)
                api["structs"].append(made)
            elif kind == "function":
                api["functions"].append(function(name, header, comment, value))
    add_codes(api["functions"])
    describe_owners(api["opaque"], api["functions"])
    defaults = {f["returns"]["type"]["name"]: f["name"] for f in api["functions"]
                if f["returns"]["type"]["kind"] == "struct" and f["name"].endswith("_default")}
    for s in api["structs"]:
        s["default"] = defaults.get(s["name"])
    api["version"] = next(c["value"] for c in api["constants"] if c["name"] == "SF_VERSION_STRING")
    return api
