# Writes a C program that holds api.json against the headers, by the compiler's own understanding.
#
# The reader in headers.py and the compiler share no thought, so where they agree on every size,
# offset, value, prototype and type of a field, a binding may rely on what stands in api.json. What
# the comments promise about NULL is tried as well: a call that refuses NULL is called with nothing
# but zeros, and one that takes NULL too.
#
# usage: probe.py API.JSON OUTPUT.C

import json
import sys

HEAD = """// SPDX-License-Identifier: MIT
// Why: bindings are made from api.json and never see a header. Written by bindings/api/probe.py: that
// every type, value and prototype is as api.json says, and that NULL is taken and refused as said.
#include "test.h"

#include <sf/cage_io.h>
#include <sf/contour_io.h>
#include <sf/exchange.h>
#include <sf/gltf.h>
#include <sf/io.h>
#include <sf/job.h>
#include <sf/layers.h>
#include <sf/session.h>
#include <sf/sf.h>
#include <sf/threemf.h>

#include <stddef.h>
"""
MAIN = """
int main(void)
{
    TEST(values);
    if (sizeof(void *) == 8) {
        TEST(layouts);
    }
    TEST(fields);
    TEST(prototypes);
    TEST(refuses_null);
    TEST(takes_null);
    return test_finish();
}
"""
CHUNK = 40


def declare(type_, name):
    """A declaration in C of a name with a type, as api.json spells types."""
    kind = type_["kind"]
    if kind == "pointer":
        if type_["to"]["kind"] == "array":
            return declare(type_["to"], f"(*{name})")
        inside = type_["to"]
        if inside["kind"] == "pointer":
            return declare(inside, f"{'const ' if type_.get('const') else ''}*{name}")
        return f"{'const ' if type_.get('const') else ''}{declare(inside, '*' + name)}"
    if kind == "array":
        return declare(type_["of"], f"{name}[{type_['count']}]")
    if kind == "callback" and "name" not in type_:
        return function_pointer(type_["returns"], type_["parameters"], name)
    return f"{type_['name']} {name}".rstrip()


def function_pointer(returns, parameters, name):
    said = ", ".join(declare(p["type"], p["name"]) for p in parameters) or "void"
    return declare(returns, f"(*{name})({said})")


def literal(type_, value):
    if type_ == "string":
        return json.dumps(value)
    return repr(value) + {"uint32_t": "u", "uint64_t": "u"}.get(type_, "")


def functions_of_lines(name, lines):
    """Lines of checks in functions that are not too long for a compiler; and their calls."""
    text, calls = "", []
    for start in range(0, len(lines), CHUNK):
        calls.append(f"{name}_{start // CHUNK}")
        text += f"\nstatic void {calls[-1]}(void)\n{{\n"
        text += "".join(f"    {line}\n" for line in lines[start:start + CHUNK]) + "}\n"
    text += f"\nstatic void {name}(void)\n{{\n" + "".join(f"    {c}();\n" for c in calls) + "}\n"
    return text


def values(api):
    lines = []
    for c in api["constants"]:
        if c["type"] == "string":
            lines.append(f"CHECK_STR({c['name']}, {literal('string', c['value'])});")
        else:
            lines.append(f"CHECK({c['name']} == {literal(c['type'], c['value'])});")
            lines.append(f"CHECK_EQ(sizeof({c['name']}), sizeof({c['type']}));")
    for e in api["enums"]:
        lines += [f"CHECK_EQ({v['name']}, {v['value']});" for v in e["values"]]
        lines.append(f"CHECK_EQ(sizeof({e['name']}), sizeof(int));")
    return lines


def layouts(api):
    lines = []
    for s in api["structs"]:
        lines.append(f"CHECK_EQ(sizeof({s['name']}), {s['size']});")
        lines += [f"CHECK_EQ(offsetof({s['name']}, {f['name']}), {f['offset']});" for f in s["fields"]]
    return lines


def fields(api):
    """A field's address goes into a pointer to its type: the compiler refuses any other."""
    text, calls = "", []
    for s in api["structs"]:
        calls.append(f"fields_{s['name']}")
        text += f"\nstatic void {calls[-1]}(void)\n{{\n    static {s['name']} s;\n"
        for f in s["fields"]:
            type_, name = f["type"], f"p_{f['name']}"
            pointer = declare({"kind": "pointer", "to": type_}, name)
            if type_["kind"] == "callback" and "name" not in type_:
                pointer = function_pointer(type_["returns"], type_["parameters"], f"*{name}")
            text += f"    {pointer} = &s.{f['name']};\n    CHECK({name} != NULL);\n"
        text += "}\n"
    return text + "\nstatic void fields(void)\n{\n" + "".join(f"    {c}();\n" for c in calls) + "}\n"


def prototypes(api):
    lines = []
    for f in api["functions"]:
        pointer = function_pointer(f["returns"]["type"], f["parameters"], f"the_{f['name']}")
        lines += [f"{pointer} = {f['name']};", f"CHECK(the_{f['name']} != NULL);"]
    for c in api["callbacks"]:
        lines.append(f"{function_pointer(c['returns'], c['parameters'], 'a_' + c['name'])} = NULL;")
        lines += [f"{c['name']} same_{c['name']} = a_{c['name']};",
                  f"CHECK(same_{c['name']} == NULL);"]
    return lines


def zero(type_):
    """An argument of zeros."""
    if type_["kind"] == "struct":
        return f"zero_{type_['name']}"
    if type_["kind"] == "enum":
        return f"({type_['name']})0"
    return "NULL" if type_["kind"] in ("pointer", "callback") else "0"


def refuses(f):
    """Whether a call must refuse zeros: it has a status, and an argument that may not be NULL."""
    return f["returns"]["type"].get("name") == "sf_status" and \
        any(p.get("nullable") is False for p in f["parameters"])


def takes(f):
    """Whether a call says what it does without any of its pointers."""
    return f["returns"]["type"].get("name") != "sf_status" and \
        all(p.get("nullable", True) for p in f["parameters"]) and f["parameters"]


def zeros(api, is_wanted):
    lines = []
    for f in api["functions"]:
        if not is_wanted(f):
            continue
        call = f"{f['name']}({', '.join(zero(p['type']) for p in f['parameters'])})"
        if refuses(f):
            lines.append(f"CHECK_EQ({call}, SF_ERR_ARGUMENT);")
        else:
            nothing = f["returns"]["type"]["kind"] == "void"
            lines += [f"{call};" if nothing else f"(void){call};", "CHECK(1);"]
    return lines


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        api = json.load(file)
    text = HEAD
    by_value = {p["type"]["name"] for f in api["functions"] if refuses(f) or takes(f)
                for p in f["parameters"] if p["type"]["kind"] == "struct"}
    text += "".join(f"static {name} zero_{name};\n" for name in sorted(by_value))
    parts = {"values": values(api), "layouts": layouts(api), "prototypes": prototypes(api),
             "refuses_null": zeros(api, refuses), "takes_null": zeros(api, takes)}
    for name, lines in parts.items():
        text += functions_of_lines(name, lines)
    text += fields(api) + MAIN
    with open(sys.argv[2], "w", encoding="utf-8", newline="\n") as file:
        file.write(text)


if __name__ == "__main__":
    main()
