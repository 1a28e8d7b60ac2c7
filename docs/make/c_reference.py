# The reference of C, a page for each header, from bindings/api/api.json: what the bindings are made from
# is what the reader sees, so that there is one truth and it is the headers. (A second parser of C beside
# that of bindings/api, such as hawkmoth with libclang, would be a second truth, and a large dependency.)

import words


def c_type(kind, name=""):
    """A type as C writes it around a name."""
    what = kind["kind"]
    const = "const " if kind.get("const") else ""
    if what == "pointer":
        inner = kind["to"]
        star = "*" + name
        if "count" in kind:
            return const + c_type(inner, f"{name}[{kind['count']}]")
        # What a pointer points to is constant: where that is a pointer, the word stands between the stars.
        if const and inner["kind"] == "pointer":
            return c_type(inner, "const " + star)
        return const + c_type(inner, star)
    if what == "array":
        return c_type(kind["of"], f"{name}[{kind['count']}]")
    if what == "callback" and "parameters" in kind:
        inside = ", ".join(c_type(p["type"], p["name"]) for p in kind["parameters"]) or "void"
        return c_type(kind["returns"], f"(*{name})({inside})")
    return (const + kind["name"] + (" " + name if name and name[0] not in "[" else name)).replace(" *[", " [")


def signature(function):
    inside = ", ".join(c_type(p["type"], p["name"]) for p in function["parameters"]) or "void"
    return c_type(function["returns"]["type"], f"{function['name']}({inside})")


def learn(api):
    """Every name that links may lead to."""
    words.FUNCTIONS.update(f["name"] for f in api["functions"])
    for kind in ("structs", "enums", "opaque", "callbacks"):
        words.TYPES.update(t["name"] for t in api[kind])
    words.VALUES.update(c["name"] for c in api["constants"])
    words.VALUES.update(v["name"] for e in api["enums"] for v in e["values"])


def function_lines(function):
    lines = [f".. c:function:: {signature(function)}", "", "   " + words.inline(function["summary"]), ""]
    lines += words.paragraphs(function["doc"], "   ")
    fields = []
    for p in function["parameters"]:
        notes = [n for n, is_so in (("may be NULL", p.get("nullable")), ("the caller owns it", p.get("owned")),
                                    ("it is gone afterwards", p.get("freed"))) if is_so]
        text = words.inline(p["doc"]) if p["doc"] else ""
        text += (" " if text else "") + (f"*({'; '.join(notes)})*" if notes else "")
        if text:
            fields.append(f"   :param {p['name']}: {text}")
    if function["returns"].get("doc"):
        fields.append("   :return: " + words.inline(function["returns"]["doc"]))
    for tag in ("cost", "threads", "source", "since"):
        if function.get(tag):
            fields.append(f"   :{tag}: " + words.inline(function[tag]))
    return lines + fields + [""]


def struct_lines(struct):
    lines = [f".. c:struct:: {struct['name']}", ""]
    lines += words.paragraphs(struct["doc"], "   ")
    if struct["default"]:
        lines += [f"   Filled by :c:func:`{struct['default']}`.", ""]
    for field in struct["fields"]:
        lines += [f"   .. c:member:: {c_type(field['type'], field['name'])}", ""]
        lines += words.paragraphs(field["doc"], "      ")
    return lines


def enum_lines(enum):
    lines = [f".. c:enum:: {enum['name']}", ""] + words.paragraphs(enum["doc"], "   ")
    for value in enum["values"]:
        lines += [f"   .. c:macro:: {value['name']}", "", f"      = {value['value']}. " + words.inline(value["doc"]), ""]
    return lines


def constant_lines(constant):
    return [f".. c:macro:: {constant['name']}", "", f"   = {words.plain(str(constant['value']))}. "
            + words.inline(constant["doc"]), ""]


def opaque_lines(opaque):
    lines = [f".. c:type:: {opaque['name']}", ""] + words.paragraphs(opaque["doc"], "   ")
    if opaque.get("makes"):
        lines += ["   Made by " + ", ".join(f":c:func:`{m}`" for m in opaque["makes"]) + ".", ""]
    if opaque.get("destroy"):
        lines += [f"   Ends with :c:func:`{opaque['destroy']}`.", ""]
    return lines


def callback_lines(callback):
    inside = ", ".join(c_type(p["type"], p["name"]) for p in callback["parameters"]) or "void"
    head = c_type(callback["returns"], f"(*{callback['name']})({inside})")
    return [f".. c:type:: {head}", ""] + words.paragraphs(callback["doc"], "   ")


def of_header(api, kind, header):
    return [thing for thing in api[kind] if thing["header"] == header]


def page(api, header):
    name = header["name"]
    lines = words.title(f"<{name}>", "=") + words.paragraphs(header["doc"])
    lines += [f"In the library ``lib{header['library']}``.", ""]
    for heading, kind, write in (("Types", "opaque", opaque_lines), ("Structures", "structs", struct_lines),
                                 ("Enumerations", "enums", enum_lines), ("Callbacks", "callbacks", callback_lines),
                                 ("Constants", "constants", constant_lines), ("Functions", "functions", function_lines)):
        things = of_header(api, kind, name)
        if things:
            lines += words.title(heading, "-")
            for thing in things:
                lines += write(thing)
    return "\n".join(lines) + "\n"


def first_sentence(header):
    return header["doc"].split("\n")[0].strip()


def pages(api):
    """Name and text of each page; "index" first."""
    learn(api)
    headers = [h for h in api["headers"] if h["name"] != "sf/sf.h"]
    stem = {h["name"]: h["name"].removeprefix("sf/").removesuffix(".h") for h in headers}
    lines = words.title("C", "=") + [
        f"{len(api['functions'])} functions in {len(headers)} headers. ``#include <sf/sf.h>`` brings all of the core; "
        "what reads and writes files is in ``<sf/io.h>``, ``<sf/cage_io.h>``, ``<sf/exchange.h>``, "
        "``<sf/layers.h>`` and ``<sf/session.h>``, and in a library of its own.", "",
        "Every function that can fail returns an :c:type:`sf_status`, and changes nothing when it does. Begin "
        "with ``<sf/rule.h>``, which says what may rest on what, and ``<sf/support.h>``.", "",
        ".. list-table::", "   :widths: 25 75", ""]
    for h in headers:
        lines += [f"   * - :doc:`<{h['name']}> <{stem[h['name']]}>`", "     - " + words.inline(first_sentence(h))]
    lines += ["", ".. toctree::", "   :hidden:", ""] + [f"   {s}" for s in stem.values()]
    yield "index", "\n".join(lines) + "\n"
    for h in headers:
        yield stem[h["name"]], page(api, h)
