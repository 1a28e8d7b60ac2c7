# Writes calls.c: for each function of the library a function that makes its arguments in a world
# (world.h), calls it, and holds what it promised. What can be called is read out of the headers by
# bindings/api; what is behind a pointer is said in shapes.txt, and where nothing is said it is one.
#
# usage: calls.py SOURCE OUTPUT    writes the file
#        calls.py SOURCE --table   prints which targets call which function

import os
import re
import sys

SOURCE = os.path.abspath(sys.argv[1])
sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(SOURCE, "bindings", "api"))

import model  # noqa: E402

FUZZ = os.path.join(SOURCE, "fuzz")


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


class Shapes:
    """shapes.txt: what is behind pointers, what stands for a parameter, what is not called."""

    def __init__(self):
        self.counts, self.values, self.left, self.rare = {}, {}, {}, {}
        for number, line in enumerate(read(os.path.join(FUZZ, "shapes.txt")).splitlines(), 1):
            line = line.strip()
            if not line or line.startswith("#"):
                continue
            found = re.match(r"([\w*]+\.\w+)\[(.*)\]$", line)
            if found:
                self.counts[found[1]] = found[2]
                continue
            found = re.match(r"([\w*]+\.\w+) = (.*)$", line)
            if found:
                self.values[found[1]] = found[2]
                continue
            found = re.match(r"rare (\w+) (\d+)$", line)
            if found:
                self.rare[found[1]] = int(found[2])
                continue
            found = re.match(r"not (\w+): (.+)$", line)
            if not found:
                sys.exit(f"shapes.txt:{number}: not understood: {line}")
            self.left[found[1]] = found[2]

    def get(self, table, owner, name):
        return table.get(f"{owner}.{name}", table.get(f"*.{name}"))


SHAPES = Shapes()
API = model.build(SOURCE)
STRUCTS = {s["name"]: s for s in API["structs"]}
ENUMS = {e["name"]: e for e in API["enums"]}
HAND = set(re.findall(r"\bworld_(sf_\w+)\(world", read(os.path.join(FUZZ, "world.h"))))
ENDS = {end for opaque in API["opaque"] for end in opaque["ends"]}
MADE = []  # structs for which make_() is written, in their order


def c_type(type_):
    if type_["kind"] == "pointer":
        return ("const " if type_.get("const") else "") + c_type(type_["to"]) + " *"
    return type_["name"]


def scalar(type_):
    """An expression that draws a number or an enum."""
    name = type_["name"]
    if type_["kind"] == "enum":
        values = [v["name"] for v in ENUMS[name]["values"] if not v["name"].endswith("_COUNT")]
        table = ", ".join(values)
        return (f"(draw_odd(&w->in, 32) ? ({name})draw_below(&w->in, 99) : (const {name}[]){{{table}}}"
                f"[draw_below(&w->in, {len(values)})])")
    if type_["kind"] == "float":
        return f"({name})draw_double(&w->in)"
    if name == "int":
        return "(int)(draw_odd(&w->in, 32) ? draw_word(&w->in) : draw_below(&w->in, 2))"
    return f"({name})draw_count(&w->in)"


def value(type_, owner, name):
    """An expression that makes a value of a type that is no pointer."""
    said = SHAPES.get(SHAPES.values, owner, name)
    if said:
        return f"({type_['name']})({said})" if type_["kind"] == "integer" else said
    if type_["kind"] == "struct":
        return make(type_["name"])
    return scalar(type_)


def make(name):
    """The call that makes a struct."""
    if name in HAND:
        return f"world_{name}(w)"
    if name not in MADE:
        fill(name)
    return f"make_{name}(w)"


WRITTEN = {}


def pointer_field(struct, field):
    """What is put into a pointer of a struct, or None to leave it as it is."""
    said = SHAPES.get(SHAPES.values, struct, field["name"])
    if said:
        return said
    to = field["type"]["to"]
    if to["kind"] == "opaque":
        return f'draw_below(&w->in, 4) ? o.{field["name"]} : world_pick(w, "{to["name"]}")'
    return None


def fill(name):
    struct, lines = STRUCTS[name], []
    default = struct.get("default")
    lines.append(f"static {name} make_{name}(world *w)\n{{")
    lines.append(f"    {name} o = {default}();" if default else
                 f"    {name} o;\n    memset(&o, 0, sizeof o);")
    said = [f for f in struct["fields"] if SHAPES.get(SHAPES.values, name, f["name"])]
    for field in said:
        lines += put(name, field, "")
    if default:
        lines.append("    if (draw_below(&w->in, 3) == 0) {\n        return o;\n    }")
    for field in struct["fields"]:
        if field not in said:
            lines += put(name, field, "if (draw_below(&w->in, 4) == 0) " if default else "")
    lines.append("    (void)w;\n    return o;\n}\n")
    WRITTEN[name] = "\n".join(lines)
    MADE.append(name)


def put(struct, field, maybe):
    """What sets a field of a struct."""
    type_, member = field["type"], "o." + field["name"]
    if type_["kind"] == "callback" or (type_["kind"] == "pointer" and not pointer_field(struct, field)):
        return []
    if field["name"] == "struct_size":
        return [f"    if (draw_odd(&w->in, 64)) {{\n        {member} = draw_byte(&w->in);\n    }}"]
    if type_["kind"] == "pointer":
        return [f"    {member} = {pointer_field(struct, field)};"]
    if type_["kind"] == "array":
        if type_["of"]["kind"] == "array" or type_["of"]["name"] == "char":
            return []
        one = value(type_["of"], struct, field["name"])
        return [f"    {maybe}{{\n        for (size_t i = 0; i < {type_['count']}; i++) {{\n"
                f"            {member}[i] = {one};\n        }}\n    }}"]
    return [f"    {maybe}{{\n        {member} = {value(type_, struct, field['name'])};\n    }}"]


def held(type_, count, owner, name):
    """An array that is only read."""
    to = type_["to"]
    if to["kind"] == "void":
        return f"world_bytes(w, {count})"
    if to["name"] == "double":
        places = re.search(r"(_mm|xyz|positions|points)$", name)
        return f"{'world_places' if places else 'world_doubles'}(w, {count})"
    if to["name"] in ("float", "uint32_t", "uint8_t"):
        made = {"float": "world_floats", "uint32_t": "world_words", "uint8_t": "world_bytes"}
        return f"{made[to['name']]}(w, {count})"
    return f"array_{to['name']}(w, {count})"


ARRAYS = {}


def array_of(type_):
    """A function that makes an array of structs, or of numbers that have no function."""
    name = type_["name"]
    if name not in ARRAYS:
        one = make(name) if type_["kind"] == "struct" else scalar(type_)
        ARRAYS[name] = f"""static {name} *array_{name}(world *w, size_t count)
{{
    if (draw_odd(&w->in, 32) || count > 1u << 20) {{
        return NULL;
    }}
    {name} *array = world_scratch(w, count * sizeof *array);
    for (size_t i = 0; i < count; i++) {{
        array[i] = {one};
    }}
    return array;
}}
"""


def is_opaque(type_, depth):
    for _ in range(depth):
        if type_["kind"] != "pointer":
            return False
        type_ = type_["to"]
    return type_["kind"] == "opaque"


def argument(function, p, named):
    """(order, expression) of one argument; named: parameters that say how much there is."""
    owner, name, type_ = function["name"], p["name"], p["type"]
    said = SHAPES.get(SHAPES.values, owner, name)
    count = SHAPES.counts.get(f"{owner}.{name}")
    if said:
        return (1, said)
    if type_["kind"] == "callback":
        return (0, f"world_{type_['name']}")
    if type_["kind"] == "struct":
        return (1, make(type_["name"]))
    if type_["kind"] != "pointer":
        return (0, f"({type_['name']})world_few(w)" if name in named and type_["kind"] == "integer" else scalar(type_))
    to = type_["to"]
    if is_opaque(type_, 1):
        if owner in ENDS:
            return (0, f'world_give(w, "{to["name"]}")')
        if not function["must_use"] and not p.get("nullable"):
            return (0, f'world_need(w, "{to["name"]}")')
        verb = ("world_pick" if type_.get("const") else
                "world_culprits" if name == "culprits" else "world_change")
        return (0, f'{verb}(w, "{to["name"]}")')
    known = {"sf_task": "world_task(w)", "sf_fault": "world_fault(w)",
             "sf_allocator": "world_allocator(w)"}
    if to.get("name") in known:
        return (0, known[to["name"]])
    if to.get("name") == "char":
        return (0, "world_text(w)")
    if is_opaque(type_, 2):
        return (3, "draw_odd(&w->in, 32) ? NULL : &made")
    if type_.get("const") and (to["kind"] != "pointer"):
        if not count and to["kind"] == "struct":
            array_of(to)
            null = "1" if p.get("nullable") else "0"
            return (2, f"{null} && draw_below(&w->in, 3) == 0 ? NULL : array_{to['name']}(w, 1)")
        if to["kind"] not in ("void",) and to["name"] not in ("double", "float", "uint32_t", "uint8_t"):
            array_of(to)
        return (2, held(type_, f"({count or 1})", owner, name))
    size = "1" if to["kind"] == "void" else f"sizeof({c_type(to)})"
    counts = int(bool(re.search(r"count|size", name)))
    if count and count.startswith("inout "):
        if to["kind"] == "struct" or to["name"] not in ("double", "float", "uint32_t", "uint8_t"):
            array_of(to)
        inner = held({**type_, "to": to}, f"({count[6:]})", owner, name)
        return (2, f"world_inout(w, {inner}, ({count[6:]}) * {size})")
    if not function["must_use"] and not p.get("nullable"):
        return (2, f"world_scratch(w, ({count or 1}) * {size})")
    return (2, f"world_room(w, ({count or 1}) * {size}, {counts})")


def local(p):
    """A parameter's name in the function that calls: w is the world there."""
    return p["name"] + "_" if p["name"] == "w" else p["name"]


def in_order(arguments):
    """Arguments, those first that others are made of."""
    left, names, done = list(arguments), {p["name"] for _, p, _ in arguments} - {"w"}, set()
    while left:
        for a in left:
            words = set(re.findall(r"(?<![\w.>])[a-z]\w*\b", re.sub(r'"[^"]*"', "", a[2])))
            if not (words & names) - done - {a[1]["name"]}:
                left.remove(a)
                done.add(a[1]["name"])
                yield a
                break
        else:
            sys.exit(f"shapes.txt: arguments are made of each other: {[a[1]['name'] for a in left]}")


def call(function):
    name, lines = function["name"], []
    named = set()
    for p in function["parameters"]:
        named |= set(re.findall(r"\b[a-z]\w*\b", SHAPES.counts.get(f"{name}.{p['name']}", "")))
    made, arguments = None, []
    for p in function["parameters"]:
        order, text = argument(function, p, named)
        if order == 3:
            kind = p["type"]["to"]["to"]["name"]
            made = (made or []) + [(p["name"], kind)]
            text = text.replace("&made", f"&made_{p['name']}")
        arguments.append((order, p, text))
    for where, kind in made or []:
        lines.append(f"    {kind} *made_{where} = NULL;")
    for _, p, text in in_order(arguments):
        type_ = p["type"]
        plain = c_type(type_)
        if type_["kind"] == "pointer" and type_["to"]["kind"] == "pointer" and not is_opaque(type_, 2):
            plain = "void *"
        lines.append(f"    {plain} {local(p)} = {text};")
        if text.startswith("world_need("):
            lines.append(f"    if ({local(p)} == NULL) {{\n        return SF_OK;\n    }}")
    names = ", ".join(local(p) for p in function["parameters"])
    returns = function["returns"]["type"]
    has_status = returns.get("name") == "sf_status"
    lines.append(f'    world_arm(w, "{name}");')
    if has_status:
        codes = " | ".join(f"1u << {c}" for c in ["SF_OK"] + [c for c in function["returns"]["codes"] if c != "SF_OK"])
        lines.append(f"    sf_status status = {name}({names});")
        for where, kind in made or []:
            lines.append(f'    world_made(w, status, {where} != NULL, made_{where} != NULL);')
        lines.append(f"    world_judge(w, status, {codes});")
        for where, kind in made or []:
            lines.append(f'    world_keep(w, "{kind}", made_{where});')
        lines.append("    return status;")
    else:
        lines.append(f"    (void){name}({names});\n    world_judge_quiet(w);\n    return SF_OK;")
    return f"static sf_status call_{name}(world *w)\n{{\n" + "\n".join(lines) + "\n}\n"


def ends():
    lines = []
    functions = {f["name"]: f for f in API["functions"]}
    for opaque in API["opaque"]:
        last = [e for e in opaque["ends"] if functions[e]["returns"]["type"]["kind"] == "void"]
        if last:
            lines.append(f'    if (strcmp(kind, "{opaque["name"]}") == 0) {{\n        {last[0]}(object);\n    }}')
    return "void world_destroy(const char *kind, void *object)\n{\n" + "\n".join(lines) + "\n}\n"


def reached():
    """Functions that calls.c calls; the others are in SHAPES.left."""
    return [f for f in API["functions"] if f["name"] not in SHAPES.left]


def unsaid():
    """Pointers of which shapes.txt should say how much is behind them: the call is told a number."""
    found = []
    for f in reached():
        numbers = [p for p in f["parameters"] if p["type"]["kind"] == "integer" and
                   re.search(r"count|capacity|size|stride|width", p["name"])]
        for p in f["parameters"]:
            to = p["type"].get("to")
            if not numbers or not to or to["kind"] not in ("integer", "float", "struct", "void"):
                continue
            key = f"{f['name']}.{p['name']}"
            fixed = (to.get("name", "").endswith(("_options", "_report")) or p["name"] == "user" or
                     to.get("name") in ("sf_task", "sf_allocator", "sf_fault", "sf_lattice", "sf_terms", "char") or
                     re.search(r"count|changed|missed", p["name"]))
            if not fixed and key not in SHAPES.counts and key not in SHAPES.values:
                found.append(key)
    return found


def stale():
    """Lines of shapes.txt that speak of nothing that there is."""
    names = {f["name"] for f in API["functions"]}
    there = {f"{f['name']}.{p['name']}" for f in API["functions"] for p in f["parameters"]}
    there |= {f"{s['name']}.{f['name']}" for s in API["structs"] for f in s["fields"]}
    said = [k for k in list(SHAPES.counts) + list(SHAPES.values) if not k.startswith("*.")]
    return sorted(set(said) - there) + sorted((set(SHAPES.left) | set(SHAPES.rare)) - names)


def table():
    """Function to the targets that call it."""
    found = {f["name"]: (["api"] if f["name"] not in SHAPES.left else []) for f in API["functions"]}
    with open(os.path.join(FUZZ, "meson.build"), encoding="utf-8") as file:
        targets = re.findall(r"^  '(\w+)',", file.read(), re.M)
    for target in targets:
        code = re.sub(r"//[^\n]*", "", read(os.path.join(FUZZ, target + ".c")))
        for name in sorted(set(re.findall(r"\b(sf_\w+)\s*\(", code)) & found.keys()):
            found[name] += [target]
    return found


def write(path):
    functions = reached()
    for text in SHAPES.values.values():
        for name in re.findall(r"\barray_(\w+)\(", text):
            array_of({"kind": "struct" if name.startswith("sf_") else "integer", "name": name})
    calls = [call(f) for f in functions]
    table = "\n".join(f'    {{"{f["name"]}", "{f["header"][3:-2]}", call_{f["name"]}, '
                      f'{int(f["returns"]["type"].get("name") == "sf_status")}, '
                      f'{SHAPES.rare.get(f["name"], 1)}}},' for f in functions)
    with open(path, "w", encoding="utf-8") as file:
        file.write("// Written by fuzz/calls.py.\n\n#include \"world.h\"\n\n")
        file.writelines(f"#include <{h['name']}>\n" for h in API["headers"])
        file.write("\n".join(WRITTEN[n] for n in MADE) + "\n" + "\n".join(ARRAYS.values()) + "\n")
        file.write("\n".join(calls) + "\n" + ends())
        file.write(f"\nconst world_call world_calls[] = {{\n{table}\n}};\n")
        file.write("const size_t world_call_count = sizeof world_calls / sizeof *world_calls;\n")


if __name__ == "__main__":
    if sys.argv[2] == "--table":
        for name, targets in table().items():
            print(f"{name}: {' '.join(targets) or 'not: ' + SHAPES.left[name]}")
    else:
        write(sys.argv[2])
