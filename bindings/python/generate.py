# Writes what the Python package takes from the interface, from bindings/api/api.json:
#
#   _sf.c      the extension module, by cffi in API mode: a C compiler checks every declaration
#   _types.py  enums, and a frozen dataclass for each struct that holds nothing but values
#   _docs.py   the words of the headers, for docstrings
#
# None of them is committed: the build makes them.
#
# usage: generate.py API.json FOLDER

import json
import os
import re
import sys

import cffi

# Called by the library; the functions are in libsf/_core.py.
CALLBACKS = """
extern "Python" {
    void sf_py_progress(void *, double);
    void sf_py_parallel(void *, size_t, sf_task_body, void *);
    sf_status sf_py_read(void *, void *, size_t, size_t *);
    sf_status sf_py_write(void *, const void *, size_t);
    int sf_py_place(void *, const double *, double *);
    int sf_py_value(void *, const double *, double *);
    double sf_py_density(void *, const double *);
    int sf_py_keep(void *, const double *);
    sf_status sf_py_layer(void *, uint32_t, uint16_t *const *);
}
int sf_cli_main(int, char **);
typedef struct { void *handle; double asked_s; } sf_py_ticker;
void sf_py_tick(void *, double);
typedef struct { sf_task_body body; void *context; unsigned char *begun; size_t ended; } sf_py_pieces;
void sf_py_piece(sf_py_pieces *, size_t);
size_t sf_py_ended(sf_py_pieces *);
"""

# Progress that nobody watches is still where Ctrl-C is heard; fifty times a second will do.
#
# A piece of parallel work is run by whoever asks for it first, and its end is counted: so nobody has to know
# whether an exception fell before a piece or behind it.
HELPERS = """
#include <time.h>

int sf_cli_main(int argc, char **argv);

typedef struct { sf_task_body body; void *context; unsigned char *begun; size_t ended; } sf_py_pieces;

static void sf_py_piece(sf_py_pieces *pieces, size_t i)
{
    if (__atomic_exchange_n(&pieces->begun[i], 1, __ATOMIC_RELAXED) == 0) {
        pieces->body(pieces->context, i);
        __atomic_add_fetch(&pieces->ended, 1, __ATOMIC_RELEASE);
    }
}

static size_t sf_py_ended(sf_py_pieces *pieces)
{
    return __atomic_load_n(&pieces->ended, __ATOMIC_ACQUIRE);
}

typedef struct { void *handle; double asked_s; } sf_py_ticker;

static void sf_py_progress(void *, double);

static void sf_py_tick(void *user, double share)
{
    sf_py_ticker *ticker = user;
    struct timespec t;
    timespec_get(&t, TIME_UTC);
    double now_s = (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
    if (now_s - ticker->asked_s > 0.02 || now_s < ticker->asked_s) {
        ticker->asked_s = now_s;
        sf_py_progress(ticker->handle, share);
    }
}
"""


# --- C -------------------------------------------------------------------------------------------

def declare(kind, name, is_const=False):
    """A C declaration of `name` with a type as api.json has it."""
    what = kind["kind"]
    if what == "pointer":
        star = "*const " if is_const else "*"
        return declare(kind["to"], star + name, kind.get("const", False))
    if what == "array":
        return declare(kind["of"], f"{name}[{kind['count']}]", is_const)
    if what == "callback" and "returns" in kind and "name" not in kind:
        inside = ", ".join(declare(p["type"], "") for p in kind["parameters"]) or "void"
        return f"{declare(kind['returns'], f'(*{name})')}({inside})"
    return f"{'const ' if is_const else ''}{kind['name']} {name}"


def c_declarations(api):
    lines = []
    for o in api["opaque"]:
        lines.append(f"typedef struct {o['name']} {o['name']};")
    for e in api["enums"]:
        values = ", ".join(f"{v['name']} = {v['value']}" for v in e["values"])
        lines.append(f"typedef enum {{ {values} }} {e['name']};")
    for s in api["structs"]:
        lines.append(f"typedef struct {s['name']} {s['name']};")
    for c in api["callbacks"]:
        inside = ", ".join(declare(p["type"], "") for p in c["parameters"]) or "void"
        lines.append(f"typedef {declare(c['returns'], '(*' + c['name'] + ')')}({inside});")
    for s in api["structs"]:
        fields = " ".join(declare(f["type"], f["name"]) + ";" for f in s["fields"])
        lines.append(f"struct {s['name']} {{ {fields} }};")
    for f in api["functions"]:
        inside = ", ".join(declare(p["type"], "") for p in f["parameters"]) or "void"
        lines.append(f"{declare(f['returns']['type'], f['name'])}({inside});")
    return "\n".join(lines)


def write_module(api, folder):
    ffi = cffi.FFI()
    ffi.cdef(c_declarations(api) + CALLBACKS)
    includes = "".join(f"#include <{h['name']}>\n" for h in api["headers"])
    ffi.set_source("libsf._sf", includes + HELPERS)
    ffi.emit_c_code(os.path.join(folder, "_sf.c"))


# --- Python --------------------------------------------------------------------------------------

def camel(name):
    return "".join(part.capitalize() for part in name.removeprefix("sf_").split("_"))


def short_names(values):
    """SF_RULE_BOX3, SF_RULE_DISK -> BOX3, DISK."""
    names = [v["name"] for v in values]
    common = os.path.commonprefix(names)
    cut = common.rfind("_") + 1
    return [(n[cut:] if n[cut:cut + 1].isalpha() else "_" + n[cut:], v["value"])
            for n, v in zip(names, values)]


def python_type(kind, values):
    what = kind["kind"]
    if what == "enum":
        return camel(kind["name"])
    if what == "integer":
        return "int"
    if what == "float":
        return "float"
    if what == "array" and kind["of"].get("name") == "char":
        return "str"
    if what == "array":
        inside = python_type(kind["of"], values)
        return inside and f"tuple[{inside}, ...]"
    if what == "struct" and kind["name"] in values:
        return camel(kind["name"])
    return None


def value_structs(api):
    """Structs of numbers, enums and each other; not options, which are set by keyword."""
    found = {}
    for s in api["structs"]:
        types = [python_type(f["type"], found) for f in s["fields"]]
        if all(types) and s["fields"][0]["name"] != "struct_size":
            found[s["name"]] = list(zip(s["fields"], types))
    return found


def one_line(text):
    return re.sub(r"\s+", " ", text).strip()


def wrapped(text, indent):
    """A comment or docstring in lines of at most 100 columns."""
    import textwrap
    return textwrap.fill(one_line(text), 100 - indent, subsequent_indent=" " * indent)


def write_types(api, folder):
    values = value_structs(api)
    doc = {s["name"]: s["doc"] for s in api["structs"]}
    lines = ['"""Enums and values of the library; made by generate.py."""', "",
             "from __future__ import annotations", "", "from dataclasses import dataclass",
             "from enum import IntEnum"]
    for e in api["enums"]:
        lines += ["", "", f"class {camel(e['name'])}(IntEnum):",
                  '    """' + wrapped(e["doc"], 4).replace("\\", "\\\\") + '"""', ""]
        lines += [f"    {name} = {value}" for name, value in short_names(e["values"])]
    for name, fields in values.items():
        lines += ["", "", "@dataclass(frozen=True)", f"class {camel(name)}:",
                  '    """' + wrapped(doc[name], 4).replace("\\", "\\\\") + '"""', ""]
        for field, kind in fields:
            lines += ["    # " + wrapped(field["doc"] or field["name"], 6).replace("\n      ", "\n    # "),
                      f"    {field['name']}: {kind}"]
    lines += ["", "", "STRUCTS: dict[str, type] = {"]
    lines += [f'    "{name}": {camel(name)},' for name in values]
    lines += ["}", "ENUMS: dict[str, type[IntEnum]] = {"]
    lines += [f'    "{e["name"]}": {camel(e["name"])},' for e in api["enums"]]
    lines += ["}", ""]
    with open(os.path.join(folder, "_types.py"), "w", encoding="utf-8") as file:
        file.write("\n".join(lines))


def docstring(function):
    parts = [function["summary"], function["doc"]]
    inside = [f"{p['name']}: {p['doc']}" for p in function["parameters"] if p.get("doc")]
    if inside:
        parts.append("In C:\n" + "\n".join("    " + one_line(p) for p in inside))
    if function["returns"].get("doc"):
        parts.append("Returns in C: " + one_line(function["returns"]["doc"]))
    for key in ("cost", "threads", "source"):
        if function.get(key):
            parts.append(f"{key.capitalize()}: {one_line(function[key])}")
    return "\n\n".join(p for p in parts if p)


def write_docs(api, folder):
    with open(os.path.join(folder, "_docs.py"), "w", encoding="utf-8") as file:
        file.write('"""The words of the headers; made by generate.py."""\n\n'
                   "DOCS: dict[str, str] = {\n")
        for f in api["functions"]:
            file.write(f"    {f['name']!r}: {docstring(f)!r},\n")
        file.write("}\n")


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        api = json.load(file)
    os.makedirs(sys.argv[2], exist_ok=True)
    write_module(api, sys.argv[2])
    write_types(api, sys.argv[2])
    write_docs(api, sys.argv[2])


if __name__ == "__main__":
    main()
