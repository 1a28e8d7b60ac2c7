# Writes the Rust externs from bindings/api/api.json, the table that their layout is tested by, and what the
# safe crate has of that file (safe.py).
#
# They are committed, so that whoever builds the crate needs no generator; tests/rust compares. Enums
# become numbers with constants, because C may hand over a value that is none of them, which no enum
# of Rust could hold. Names stay those of C, but for words that Rust keeps for itself, which get an
# underscore. Comments go along: what is said of each argument stands below the text.
#
# usage: generate.py SOURCE [--check]     --check: write nothing, exit with 1 where a file differs

import json
import os
import re
import sys
import textwrap

import safe

KEYWORDS = {"as", "box", "const", "crate", "dyn", "else", "enum", "extern", "fn", "for", "if", "impl",
            "in", "let", "loop", "match", "mod", "move", "mut", "pub", "ref", "return", "self", "static",
            "struct", "super", "trait", "type", "unsafe", "use", "where", "while", "yield", "final",
            "macro", "override", "priv", "typeof", "unsized", "virtual", "abstract", "become", "do"}
NUMBERS = {"char": "c_char", "int": "c_int", "int8_t": "i8", "uint8_t": "u8", "int16_t": "i16",
           "uint16_t": "u16", "int32_t": "i32", "uint32_t": "u32", "int64_t": "i64",
           "uint64_t": "u64", "size_t": "usize", "float": "f32", "double": "f64"}
HEAD = """// SPDX-License-Identifier: MIT
// The interface of libsf. Written by bindings/rust/generate.py: change the headers instead.

use core::ffi::{c_char, c_int, c_void};
use core::marker::{PhantomData, PhantomPinned};
"""


def name_of(name):
    return name + "_" if name in KEYWORDS else name


def type_of(type_):
    """A type of C as Rust has it."""
    kind = type_["kind"]
    if kind == "void":
        return "c_void"
    if kind in ("integer", "float"):
        return NUMBERS[type_["name"]]
    if kind == "pointer":
        return f"*{'const' if type_.get('const') else 'mut'} {type_of(type_['to'])}"
    if kind == "array":
        return f"[{type_of(type_['of'])}; {type_['count']}]"
    if kind == "callback" and "name" not in type_:
        return f"Option<unsafe extern \"C\" fn{signature(type_['parameters'], type_['returns'])}>"
    return type_["name"]


def signature(parameters, returns, indent=None):
    said = [f"{name_of(p['name'])}: {type_of(p['type'])}" for p in parameters]
    end = "" if returns["kind"] == "void" else f" -> {type_of(returns)}"
    if indent is None or not said:
        return f"({', '.join(said)}){end}"
    inside = "".join(f"\n{indent}    {s}," for s in said)
    return f"({inside}\n{indent}){end}"


# --- comments ----------------------------------------------------------------------------------------


def escaped(text):
    """Prose in which no sign means anything to rustdoc but what is marked as code."""
    parts = text.split("`")
    for i in range(0, len(parts), 2):
        parts[i] = re.sub(r"([\[\]<>*])", r"\\\1", parts[i])
    return "`".join(parts)


def wrapped(line, indent):
    return textwrap.wrap(line, 96 - len(indent), break_long_words=False, break_on_hyphens=False,
                         subsequent_indent="  " if line.startswith("- ") else "")


def doc(text, indent="", more=()):
    """Lines of a comment: the text in paragraphs, and below it a list."""
    lines = []
    for part in [p for p in text.split("\n\n") if p]:
        if lines:
            lines.append("")
        if part.startswith("   "):
            lines += ["```text"] + textwrap.dedent(part).split("\n") + ["```"]
            continue
        for line in part.split("\n"):
            lines += wrapped(escaped(line), indent)
    if more:
        lines.append("")
    for what, said in more:
        lines += wrapped(f"- {what}: {escaped(said)}", indent)
    return "".join(f"{indent}/// {line}".rstrip() + "\n" for line in lines)


def function_doc(f):
    more = [(f"`{name_of(p['name'])}`", p["doc"]) for p in f["parameters"]]
    more += [("returns", f["returns"]["doc"])] if "doc" in f["returns"] else []
    more += [(tag, f[tag]) for tag in ("cost", "threads", "source", "since") if tag in f]
    return doc(f"{f['summary']}\n\n{f['doc']}", "    ", more)


# --- the file -----------------------------------------------------------------------------------------


def constant(c):
    if c["type"] == "string":
        text = c["value"].encode()
        return (f"{doc(c['doc'])}pub const {c['name']}: &[u8; {len(text) + 1}] = "
                f"b\"{c['value']}\\0\";\n")
    return f"{doc(c['doc'])}pub const {c['name']}: {NUMBERS[c['type']]} = {c['value']};\n"


def enum(e):
    text = f"{doc(e['doc'])}pub type {e['name']} = c_int;\n"
    for v in e["values"]:
        text += f"{doc(v['doc'])}pub const {v['name']}: {e['name']} = {v['value']};\n"
    return text


def opaque(o):
    return (f"{doc(o['doc'])}#[repr(C)]\npub struct {o['name']} {{\n    _nothing: [u8; 0],\n"
            "    _marker: PhantomData<(*mut u8, PhantomPinned)>,\n}\n")


def callback(c):
    said = {"kind": "callback", "returns": c["returns"], "parameters": c["parameters"]}
    return f"{doc(c['doc'])}pub type {c['name']} = {type_of(said)};\n"


def struct(s):
    text = f"{doc(s['doc'])}#[repr(C)]\n#[derive(Clone, Copy, Debug)]\npub struct {s['name']} {{\n"
    for f in s["fields"]:
        text += f"{doc(f['doc'], '    ')}    pub {name_of(f['name'])}: {type_of(f['type'])},\n"
    return text + "}\n"


def function(f):
    checked = "    #[must_use]\n" if f["must_use"] else ""
    head = f"    pub fn {f['name']}"
    line = head + signature(f["parameters"], f["returns"]["type"]) + ";"
    if len(line) > 100:
        line = head + signature(f["parameters"], f["returns"]["type"], "    ") + ";"
    return f"{function_doc(f)}{checked}{line}\n"


def externs(api):
    text = HEAD
    for kind, write in (("constants", constant), ("enums", enum), ("opaque", opaque),
                        ("callbacks", callback), ("structs", struct)):
        for thing in api[kind]:
            text += "\n" + write(thing)
    return text + '\nextern "C" {\n' + "\n".join(function(f) for f in api["functions"]) + "}\n"


# --- the layout, told by both languages ---------------------------------------------------------------


def numbers(api):
    """What has to be the same in both: an expression in C, and one in Rust."""
    for s in api["structs"]:
        yield f"sizeof({s['name']})", f"size_of::<{s['name']}>()"
        for f in s["fields"]:
            yield (f"offsetof({s['name']}, {f['name']})",
                   f"offset_of!({s['name']}, {name_of(f['name'])})")
    for e in api["enums"]:
        yield f"sizeof({e['name']})", f"size_of::<{e['name']}>()"
        for v in e["values"]:
            yield v["name"], f"{v['name']} as usize"
    for c in api["constants"]:
        if c["type"] not in ("string", "double"):
            yield f"sizeof({c['name']})", f"size_of_val(&{c['name']})"
            yield c["name"], f"{c['name']} as usize"


def layout(api):
    said = list(numbers(api))
    lines = "".join(f'    ("{c}", {rust}),\n' for c, rust in said)
    headers = "".join(f'    "{h["name"]}",\n' for h in api["headers"])
    functions = "".join(f"        {f['name']} as *const (),\n" for f in api["functions"])
    return f"""// SPDX-License-Identifier: MIT
// What has to be the same in C and in Rust. Written by bindings/rust/generate.py.

use core::mem::{{offset_of, size_of, size_of_val}};
use libsf_sys::*;

pub static HEADERS: [&str; {len(api["headers"])}] = [
{headers}];

#[rustfmt::skip]
pub static NUMBERS: [(&str, usize); {len(said)}] = [
{lines}];

#[rustfmt::skip]
pub fn functions() -> [*const (); {len(api["functions"])}] {{
    [
{functions}    ]
}}
"""


def main():
    source = os.path.abspath(sys.argv[1])
    folder = os.path.join(source, "bindings", "rust")
    with open(os.path.join(source, "bindings", "api", "api.json"), encoding="utf-8") as file:
        api = json.load(file)
    made = {"libsf-sys/src/externs.rs": externs(api), "libsf-sys/tests/layout/numbers.rs": layout(api)}
    for name, text in safe.made(api, os.path.join(folder, "libsf")).items():
        made[f"libsf/{name}"] = text
    behind = []
    for name, text in made.items():
        path = os.path.join(folder, name)
        old = None
        if os.path.exists(path):
            with open(path, encoding="utf-8") as file:
                old = file.read()
        if old != text:
            behind.append(name)
            if "--check" not in sys.argv[2:]:
                os.makedirs(os.path.dirname(path), exist_ok=True)
                with open(path, "w", encoding="utf-8", newline="\n") as file:
                    file.write(text)
    if "--check" in sys.argv[2:] and behind:
        print(f"run bindings/rust/generate.py: behind are {', '.join(behind)}")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
