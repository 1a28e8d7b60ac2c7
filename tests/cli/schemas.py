#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
# Why: docs/*.schema.json say what files sf takes, and people check theirs by them; so what the docs
# show must work, and what a schema refuses sf must refuse, and the other way around (TRUST: what is
# documented is so). Each example is broken in every way that keeps it JSON: a key left out, added,
# or of another type. Schemas are asked through jsonschema, where it is installed.
#
# usage: schemas.py DOCS    SF, SF_WRAPPER and JSON_GET as for the scripts beside

import copy
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

try:
    from jsonschema import Draft202012Validator
except ImportError:
    Draft202012Validator = None

DOCS = pathlib.Path(sys.argv[1])
SF = os.environ.get("SF_WRAPPER", "").split() + [os.environ["SF"]]
NAMES = ("stance", "handles", "density", "materials", "paint")
# A column that leans, as the files of docs/balance.md speak of, and the least work that reads a file.
COLUMN = "".join(f"v {x + 16 * z / 40} {y} {z}\n" for z in (0, 40) for y in (0, 12) for x in (0, 12))
COLUMN += "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n"
ASKED = {
    "stance": ["stand", "column.obj", "--no-carve", "--no-deform", "--stance"],
    "handles": ["stand", "column.obj", "--no-carve", "--handles"],
    "density": ["stand", "column.obj", "--rest", "--density"],
    "materials": ["grade", "cage.vtk", "-o", "out", "--materials"],
    "paint": ["grade", "cage.vtk", "-o", "out", "--property", "stiffness", "--paint"],
}
# The cage that docs/grade.md shows.
CAGE = re.search(r"```vtk\n(.*?)```", (DOCS / "grade.md").read_text(encoding="utf-8"), re.S).group(1)
# More than the docs show: every key that there is.
MORE = {
    "stance": [{"kind": "stand", "up": [0, 0, 2], "gamma_deg": 1, "low_mm": [-9, -9, -9], "high_mm": [99, 99, 99],
                "contact_mm": 0.1},
               {"kind": "hang", "up": [0, 0, 1], "point_mm": [14, 6, 20], "tolerance_deg": 2, "lever_mm": 0.5},
               {"kind": "rock", "up": [0, 0, 1], "tolerance_deg": 2, "range_deg": 20}],
    "handles": [{"kind": "point", "at_mm": [14, 6, 20], "locked": False,
                 "pose": {"scale": 1, "shift_mm": [0, 0, 0], "turn_deg": [0, 0, 0]}},
                {"ray": {"from_mm": [-9, 6, 30], "direction": [1, 0, 0]}, "radius_mm": 1, "kind": "ball"}],
    "density": {"density": 2, "infill": 0.5, "wall_mm": 1,
                "regions": [{"density": 3, "box": {"low": [0, 0, 0], "high": [9, 9, 9]}},
                            {"density": 1, "mesh": "column.obj", "keep": True}],
                "masses": [{"mass": 0.5, "at_mm": [14, 6, 10]}]},
    "materials": {"materials": [{"name": "a", "colour": "#00fF7a", "density_g_cm3": 1.5}, {"name": "b"}, {"name": "c"}],
                  "properties": ["stiffness"],
                  "mixtures": [{"fractions": [1, 0, 0], "values": [0]}, {"fractions": [0, 1, 0], "values": [0.5]},
                               {"fractions": [0, 0, 1], "values": [1]}]},
    "paint": [{"property": "stiffness", "ball": {"at_mm": [0, 0, 0], "radius_mm": 3, "strength": 0.5,
                                                 "falloff": "linear", "where": "outside"}, "set": 0.5},
              {"property": "stiffness", "capsule": {"from_mm": [0, 0, 0], "to_mm": [0, 0, 4], "radius_mm": 1,
                                                    "where": "inside", "falloff": "constant"}, "add": 0.25},
              {"property": "stiffness", "points": [0, 7], "smooth": 0.5},
              {"all": True, "move": [1, 0, 0]}, {"all": True, "smooth_shape": 0.25},
              {"create": "other", "value": 0.5, "low": 0, "high": 1}],
}
WRONG = {
    "materials": [{"materials": [{"name": "a"}], "properties": ["stiffness"], "mixtures": []}, {"materials": []}],
    "paint": [[], [{}], [{"all": True}], [{"set": 1, "all": True}], [{"property": "stiffness", "set": 1}],
              [{"property": "stiffness", "all": True, "points": [0], "set": 1}], [{"all": False, "move": [0, 0, 1]}],
              [{"property": "stiffness", "all": True, "set": 1, "add": 1}],
              [{"property": "stiffness", "all": True, "smooth": 2}], [{"points": [], "move": [0, 0, 1]}],
              [{"property": "stiffness", "ball": {"at_mm": [0, 0, 0], "radius_mm": 0}, "set": 1}],
              [{"property": "stiffness", "ball": {"at_mm": [0, 0, 0], "radius_mm": 1, "strength": 2}, "set": 1}]],
    "stance": [[], [{}] * 33, [{"up": [0, 0, 0]}], [{"gamma_deg": -1}], [{"gamma_deg": 81}],
               [{"kind": "hang", "point_mm": [14, 6, 20], "tolerance_deg": 0}], [{"kind": "lie"}], [{"up": [0, 1]}],
               [{"up": [0, 0, 1, 0]}], [{"contact_mm": -1}], [{"kind": "hang", "lever_mm": -1}]],
    "handles": [[], [{}], [{"at_mm": [14, 6, 20]}] * 64, [{"at_mm": [14, 6, 20], "kind": "ball"}],
                [{"at_mm": [14, 6, 20], "kind": "ball", "radius_mm": 0}],
                [{"at_mm": [14, 6, 20], "ray": {"from_mm": [-9, 6, 30], "direction": [1, 0, 0]}}],
                [{"ray": {"from_mm": [-9, 6, 30], "direction": [0, 0, 0]}}], [{"ray": {"from_mm": [-9, 6, 30]}}],
                [{"at_mm": [14, 6, 20], "pose": {"scale": 0}}], [{"at_mm": [14, 6, 20], "kind": "base"}]],
    "density": [{"density": 0}, {"infill": 0}, {"infill": 1.5}, {"wall_mm": -1}, {"regions": [{"density": 1}]},
                {"regions": [{"box": {"low": [0, 0, 0], "high": [9, 9, 9]}}]},
                {"regions": [{"density": 0, "box": {"low": [0, 0, 0], "high": [9, 9, 9]}}]},
                {"regions": [{"density": 1, "box": {"low": [0, 0, 0], "high": [9, 9, 9]}, "mesh": "column.obj"}]},
                {"regions": [{"density": 1, "box": {"low": [0, 0], "high": [9, 9, 9]}}]},
                {"regions": [{"density": 1, "box": {"low": [0, 0, 0], "high": [9, 9, 9]}, "keep": 1}]},
                {"masses": {}}, {"masses": [{"mass": 1}]}, {"masses": [{"mass": 0, "at_mm": [0, 0, 0]}]},
                {"masses": [{"mass": 1, "at_mm": [0, 0]}]}],
}
count = failures = 0


def ok(good, words, notes=()):
    global count, failures
    count += 1
    failures += not good
    print(f"{'ok' if good else 'not ok'} {count} - {words}")
    for note in () if good else notes[:20]:
        print(f"# {note}")


def document(name, inside):
    head = {"format": f"libsf-{name}", "version": 1}
    if name in ("density", "materials"):
        return {**head, **inside}
    return {**head, {"stance": "stances", "paint": "steps"}.get(name, name): inside}


def breakages(value):
    """Copies of a document, each with one thing wrong: (what, copy)."""

    def at(root, path):
        for step in path:
            root = root[step]
        return root

    def changed(path, change):
        made = copy.deepcopy(value)
        change(at(made, path[:-1]) if path else made, path[-1] if path else None)
        return made

    def put(other):
        def change(inside, key):
            inside[key] = other
        return change

    def walk(path):
        here = at(value, path)
        if isinstance(here, dict):
            yield f"{path} with a key too many", changed(path + ["none"], put(1))
        for key in here if isinstance(here, dict) else range(len(here)) if isinstance(here, list) else ():
            below = path + [key]
            kind = float if type(at(value, below)) is int else type(at(value, below))
            for other in (None, {}, "text", -7.5, [], True):
                if type(other) is not kind:
                    yield f"{below} is {json.dumps(other)}", changed(below, put(other))
            yield from walk(below)

    yield from walk([])
    for key in ("format", "version", "stances", "handles", "materials", "properties", "mixtures", "steps"):
        if key in value:
            yield f"no {key}", {k: v for k, v in value.items() if k != key}
    yield "another format", {**value, "format": "libsf-other"}
    yield "another version", {**value, "version": 2}


def takes(name, made):
    """Whether sf takes a file (None where it says anything but that it is wrong), and its sentence."""
    with open("file.json", "w") as file:
        json.dump(made, file)
    done = subprocess.run(SF + ASKED[name] + ["file.json", "--resolution", "8"], capture_output=True, text=True)
    return {0: True, 1: True, 3: False}.get(done.returncode), done.stderr.strip()


def warnings(name, made):
    """What sf warns of a file."""
    with open("file.json", "w") as file:
        json.dump(made, file)
    done = subprocess.run(SF + ASKED[name] + ["file.json", "--resolution", "8", "--json"], capture_output=True, text=True)
    return json.loads(done.stdout).get("warnings", [])


def shown(name):
    """The examples of the docs."""
    for page in sorted(DOCS.glob("*.md")):
        for block in re.findall(r"```json\n(.*?)```", page.read_text(encoding="utf-8"), re.S):
            made = json.loads(block)
            if made.get("format") == f"libsf-{name}":
                yield page.name, made


def check(name):
    schema = json.loads((DOCS / f"{name}.schema.json").read_text(encoding="utf-8"))
    validator = Draft202012Validator(schema) if Draft202012Validator else None
    ok(schema["properties"]["format"] == {"const": f"libsf-{name}"}, f"{name}.schema.json is JSON, and of that format")
    if validator:
        Draft202012Validator.check_schema(schema)
    good = [made for _, made in shown(name)]
    ok(good, f"the docs show a file of {name}")
    if name == "paint":
        said = [warnings(name, made) for made in good]
        ok(not any(said), "each brush that they show meets points", said)
    good += [document(name, MORE[name])]
    if name not in ("density", "materials"):
        good += [document(name, [item]) for item in MORE[name]]
    for i, made in enumerate(good):
        taken, said = takes(name, made)
        ok(taken, f"sf takes example {i} of {name}", [said])
        if validator:
            ok(validator.is_valid(made), "and so does the schema",
               [error.message for error in validator.iter_errors(made)])
    bad = [(json.dumps(inside)[:60], document(name, inside)) for inside in WRONG[name]]
    missed = [f"{what}: {said}" for what, made in bad for taken, said in [takes(name, made)] if taken is not False]
    ok(not missed, f"sf refuses {len(bad)} files of {name} that are wrong", missed)
    if validator:
        missed = [what for what, made in bad if validator.is_valid(made)]
        ok(not missed, "and so does the schema", missed)
        broken = [pair for made in good for pair in breakages(made)]
        apart = [f"{what}: sf {taken}, {said}" for what, made in broken for taken, said in [takes(name, made)]
                 if taken is not validator.is_valid(made)]
        ok(not apart, f"both agree on {len(broken)} that are broken", apart)
    else:
        broken = [pair for made in good[:1] for pair in breakages(made)]
        missed = [f"{what}: {said}" for what, made in broken for taken, said in [takes(name, made)] if taken]
        ok(not missed, f"sf refuses {len(broken)} that are broken", missed)


def main():
    if not os.environ.get("JSON_GET"):
        print("1..0 # SKIP this build reads no JSON")
        return 0
    with tempfile.TemporaryDirectory() as place:
        os.chdir(place)
        pathlib.Path("column.obj").write_text(COLUMN)
        pathlib.Path("cage.vtk").write_text(CAGE)
        for name in NAMES:
            check(name)
        os.chdir("/")
    if Draft202012Validator is None:
        print("# jsonschema is not installed: what the schemas say was not asked, only sf")
    print(f"1..{count}")
    return failures > 0


if __name__ == "__main__":
    sys.exit(main())
