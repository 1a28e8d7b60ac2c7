# What a binding relies on in api.json, beyond what types say: that nothing is left unsaid.
#
# Each rule is a function of the interface that returns what breaks it, in sentences. tests/api runs
# them on the headers as they are, and on headers that are spoilt in one place each.

import re

import model

OPTIONAL = {"sf_allocator", "sf_task", "sf_fault"}


def has_status(function):
    return function["returns"]["type"].get("name") == "sf_status"


def declarations(api):
    """Everything that has a comment: where it is, its comment."""
    for kind in ("headers", "constants", "enums", "opaque", "callbacks", "structs"):
        for thing in api[kind]:
            yield thing["name"], thing["doc"]
            for part in thing.get("values", []) + thing.get("fields", []):
                yield f"{thing['name']}: {part['name']}", part["doc"]


def everything_is_said(api):
    """Every header, type, field, value, constant and callback has a comment."""
    return [f"{name} has no comment" for name, doc in declarations(api) if not doc]


def functions_are_said(api):
    """Every function has a sentence, @cost, @threads and @since, and @return where it returns."""
    bad = []
    for f in api["functions"]:
        if not re.match(r".+[.]$", f["summary"]):
            bad.append(f"{f['name']} does not begin with a sentence")
        bad += [f"{f['name']} lacks @{tag}" for tag in ("cost", "threads", "since") if not f.get(tag)]
        if f["returns"]["type"]["kind"] != "void" and not f["returns"].get("doc"):
            bad.append(f"{f['name']} lacks @return")
    return bad


def parameters_are_said(api):
    """Every parameter is documented."""
    return [f"{f['name']} says nothing of '{p['name']}'"
            for f in api["functions"] for p in f["parameters"] if not p["doc"]]


def codes_are_said(api):
    """Every function with a status names its codes, SF_OK among them, and must be heeded."""
    bad = []
    codes = {v["name"] for e in api["enums"] if e["name"] == "sf_status" for v in e["values"]}
    for f in filter(has_status, api["functions"]):
        said = set(f["returns"]["codes"])
        bad += [f"{f['name']} returns {c}, which is no code" for c in said - codes]
        if "SF_OK" not in said or len(said) < 2:
            bad.append(f"{f['name']} names the codes {sorted(said)} only")
        if not f["must_use"]:
            bad.append(f"{f['name']} has a status and is not SF_CHECKED")
    return bad


def null_is_said(api):
    """Where no status can refuse NULL, the comment says what becomes of it."""
    bad = []
    for f in api["functions"]:
        for p in f["parameters"]:
            pointed = p["type"].get("to", {}).get("name")
            if "nullable" in p and not has_status(f) and model.may_be_null(p["doc"]) is None:
                bad.append(f"{f['name']} does not say whether '{p['name']}' may be NULL")
            if pointed in OPTIONAL and not p["nullable"]:
                bad.append(f"{f['name']} does not say that '{p['name']}' may be NULL")
        if "nullable" in f["returns"] and "NULL" not in f["returns"].get("doc", ""):
            bad.append(f"{f['name']} does not say whether it returns NULL")
    return bad


def objects_begin_and_end(api):
    """Every opaque object is made by some call and ended by just one that cannot fail."""
    bad = []
    for o in api["opaque"]:
        if not o["makes"]:
            bad.append(f"nothing makes an {o['name']}")
        if o["destroy"] is None and "memory of the caller's" not in o["doc"]:
            bad.append(f"nothing ends an {o['name']}, or more than one call does: {o['ends']}")
    ended = {o["name"] for o in api["opaque"] if o["ends"]}
    bad += [f"{f['name']}: '{p['name']}' is owned, and nothing ends it" for f in api["functions"]
            for p in f["parameters"] if p.get("owned") and model.points_to(p["type"], 2) not in ended]
    return bad


def options_have_defaults(api):
    """A struct that begins with its size says so, and whether a default sets it."""
    bad = []
    for s in api["structs"]:
        first = s["fields"][0]
        sized = first["name"] == "struct_size"
        if sized and (s["default"] is not None) != ("set by" in first["doc"]):
            bad.append(f"{s['name']}: its struct_size says {first['doc']!r}, its default is {s['default']}")
        if sized and f"sizeof({s['name']})" not in first["doc"]:
            bad.append(f"{s['name']}: its struct_size does not say of what")
    return bad


def names_are_once(api):
    """No name is declared twice."""
    names = [t["name"] for kind in ("constants", "enums", "opaque", "callbacks", "structs", "functions")
             for t in api[kind]] + [v["name"] for e in api["enums"] for v in e["values"]]
    return [f"{n} is declared twice" for n in sorted({n for n in names if names.count(n) > 1})]


RULES = [everything_is_said, functions_are_said, parameters_are_said, codes_are_said, null_is_said,
         objects_begin_and_end, options_have_defaults, names_are_once]
