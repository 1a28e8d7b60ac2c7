# Writes what the safe Rust crate has of bindings/api/api.json: its enums, its structs of numbers, and the
# words of the headers.
#
# Structs that only carry results become structs of Rust's with the same fields: a flag becomes a bool, a
# number that stands for "none" an Option, 128 bits a u128. Enums get a variant for numbers that have no name
# here. The words go into a macro with an arm for everything that the crate's sources ask for:
#
#     words!(sf_grid_trim)                what a function does: its first sentence, and the rest
#     words!(sf_grid_trim: bed_layer)     the same, with what is said of these parameters
#     words!(sf_terms.keep)               what is said of a field
#     words!(sf_terms)                    what is said of a type
#     words!(SF_DENSITY_BOX)              what is said of a value
#
# so that comments of the crate are those of the headers, and none is kept that nobody asks for.

import os
import re

ENUMS = {"sf_contour_fill": "ContourFill", "sf_contour_format": "ContourFormat",
         "sf_job_format": "JobFormat", "sf_carve_goal": "CarveGoal", "sf_carve_mode": "CarveMode", "sf_handle_kind": "HandleKind",
         "sf_stance_kind": "StanceKind", "sf_stand_solver": "StandSolver", "sf_weights_method": "WeightsMethod",
         "sf_status": "ErrorKind", "sf_rule_kind": "RuleKind", "sf_finding_kind": "FindingKind", "sf_void_kind": "VoidKind",
         "sf_preserve_mode": "PreserveMode", "sf_fill": "Fill", "sf_mesh_format": "MeshFormat",
         "sf_tip_shape": "TipShape", "sf_brush_kind": "BrushKind", "sf_session_step": "SessionStep",
         "sf_cage_format": "CageFormat", "sf_refine_rules": "RefineRules", "sf_falloff": "Falloff",
         "sf_paint_where": "PaintWhere", "sf_paint_operation": "PaintOperation", "sf_trend": "Trend",
         "sf_mask_kind": "MaskKind", "sf_operation": "Operation", "sf_landing": "Landing",
         "sf_path_end": "PathEnd", "sf_path_cost": "PathCost", "sf_border": "Border",
         "sf_connectivity": "Connectivity", "sf_isa": "Isa"}
# Values that are no error, or no value at all.
PASSED_OVER = {"SF_OK", "SF_STATUS_COUNT", "SF_BRUSH_KIND_COUNT", "SF_ISA_COUNT"}
STRUCTS = {"sf_carve_report": "CarveReport", "sf_drain": "Drain", "sf_drain_report": "DrainReport",
           "sf_orientation": "Orientation", "sf_printing_report": "PrintingReport",
           "sf_stance_verdict": "StanceVerdict", "sf_stand_report": "StandReport",
           "sf_weights_facts": "WeightsFacts", "sf_sculpt_change": "SculptChange", "sf_sculpt_history": "SculptHistory",
           "sf_session_counts": "SessionCounts", "sf_cage_report": "CageReport", "sf_cage_reading": "CageReading",
           "sf_cage_history_state": "CageHistoryState", "sf_limit_report": "LimitReport",
           "sf_sample_report": "SampleReport", "sf_tets_report": "TetsReport", "sf_diffusion": "Diffusion",
           "sf_material_use": "MaterialUse", "sf_emit_report": "EmitReport", "sf_gltf_report": "GltfReport", "sf_job_info": "JobInfo",
           "sf_finding_cost": "FindingCost", "sf_slice_sums": "SliceSums", "sf_component": "Component",
           "sf_bridge": "Bridge", "sf_rect": "Rect", "sf_box": "VoxelBox", "sf_moments": "Moments", "sf_rule_angles": "RuleAngles",
           "sf_check_report": "CheckReport", "sf_finding": "Finding", "sf_void": "Void",
           "sf_voids_report": "VoidsReport", "sf_steepest": "Steepest", "sf_trim_report": "TrimReport",
           "sf_grow_report": "GrowReport", "sf_repair_report": "RepairReport",
           "sf_preserve_report": "PreserveReport", "sf_topology": "Topology", "sf_mass": "Mass",
           "sf_voxelize_report": "VoxelizeReport"}
# Structs of plain numbers that stand in arrays: the same bytes in both languages, so that arrays need no copy.
PLAIN = {"sf_ballast": "Ballast", "sf_body": "Body", "sf_fold": "Fold", "sf_halfspace": "Halfspace", "sf_pose": "Pose",
         "sf_pose_change": "PoseChange", "sf_rest": "Rest", "sf_transform": "Transform", "sf_dab": "Dab", "sf_voxel": "Voxel", "sf_run": "Run", "sf_crease": "Crease",
         "sf_sharp_point": "SharpPoint", "sf_place": "Place", "sf_skeleton_node": "SkeletonNode",
         "sf_skeleton_strut": "SkeletonStrut", "sf_curve_sample": "CurveSample",
         "sf_certificate_layer": "CertificateLayer", "sf_certificate_step": "CertificateStep",
         "sf_certificate_span": "CertificateSpan"}
# Of these, what no zeros stand for.
NOT_ZERO = {"sf_pose", "sf_transform"}
# Structs of choices whose defaults the library knows. What of them leads elsewhere is said in other words.
OPTIONS = {"sf_orient_options": "OrientOptions", "sf_stance_options": "StanceOptions",
           "sf_stand_options": "StandOptions", "sf_weights_options": "WeightsOptions"}
ELSEWHERE = {"ballast_count", "struct_size"}
# Fields whose greatest number means that there is none.
NONE = {"sf_printing_report.bed_layer", "sf_printing_report.floating_layer", "sf_printing_report.layer",
        "sf_check_report.bed_layer", "sf_finding.cause", "sf_void.vent_layer", "sf_voids_report.bed_layer",
        "sf_steepest.layer", "sf_trim_report.bed_layer", "sf_grow_report.bed_layer",
        "sf_finding_cost.grow_voxels", "sf_repair_report.bed_layer", "sf_repair_report.trim_cost", "sf_repair_report.grow_cost"}
# What callers hand in as well: they are turned back.
BOTH_WAYS = {"sf_rect", "sf_box", "sf_finding", "sf_finding_cost"}
NUMBERS = {"uint8_t": "u8", "uint16_t": "u16", "int32_t": "i32", "uint32_t": "u32", "uint64_t": "u64",
           "size_t": "usize", "double": "f64"}
HEAD = """// SPDX-License-Identifier: MIT
// Results and choices of the library as Rust has them. Written by bindings/rust/generate.py.

use crate::plain::Plain;
use crate::sys;
"""


# --- words -------------------------------------------------------------------------------------------


def linked(text, api):
    """Prose in which names of C lead to their externs, and no other sign means anything to rustdoc."""
    parts = text.split("`")
    for i in range(0, len(parts), 2):
        part = re.sub(r"([\[\]<>*])", r"\\\1", parts[i])
        parts[i] = re.sub(r"\b(sf_\w+|SF_[A-Z0-9_]+)\b(\(\))?", lambda m: link(m, api), part)
    return "`".join(parts)


def link(found, api):
    name = found.group(1)
    if name not in api["names"]:
        return found.group(0)
    return f"[`{name}{found.group(2) or ''}`](crate::sys::{name})"


def prose(text, api):
    """Paragraphs of a comment as rustdoc takes them."""
    parts = []
    for part in [p for p in text.split("\n\n") if p]:
        parts.append(f"```text\n{part}\n```" if part.startswith("   ") else linked(part, api))
    return "\n\n".join(parts)


def of_function(f, names, api):
    said = [prose(f["summary"], api), prose(f["doc"], api)]
    lists = []
    for name in names:
        found = [p for p in f["parameters"] if p["name"] == name]
        if not found:
            raise SystemExit(f"{f['name']} has no parameter {name}")
        lists.append(f"- `{name}`: {linked(found[0]['doc'], api)}")
    for tag in ("cost", "threads", "source"):
        if f.get(tag):
            lists.append(f"- {tag}: {linked(f[tag], api)}")
    lists.append(f"- in C: [`{f['name']}()`](crate::sys::{f['name']})")
    return "\n\n".join([s for s in said if s] + ["\n".join(lists)])


def sentence(api, asked):
    """What stands for an argument of words!()."""
    name, _, more = asked.partition(":")
    name = name.strip()
    names = [m.strip() for m in more.split(",") if m.strip()]
    if "." in name:
        struct, field = name.split(".")
        found = [f for s in api["structs"] if s["name"] == struct for f in s["fields"] if f["name"] == field]
        if not found:
            raise SystemExit(f"there is no field {name}")
        return linked(found[0]["doc"][:1].upper() + found[0]["doc"][1:] + ".", api)
    for f in api["functions"]:
        if f["name"] == name:
            return of_function(f, names, api)
    for kind in ("structs", "enums", "opaque", "callbacks", "constants"):
        for thing in api[kind]:
            if thing["name"] == name:
                return prose(thing["doc"], api)
    for e in api["enums"]:
        for v in e["values"]:
            if v["name"] == name:
                return linked(v["doc"][:1].upper() + v["doc"][1:] + ".", api)
    raise SystemExit(f"the headers say nothing of {name}")


def quoted(text):
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n") + '"'


def words(api, folder):
    asked = set()
    for place, folders, files in os.walk(folder):
        folders.sort()
        for file in sorted(files):
            if file.endswith(".rs") and file != "words.rs":
                with open(os.path.join(place, file), encoding="utf-8") as text:
                    asked.update(" ".join(m.split()) for m in re.findall(r"words!\(([^)]*)\)", text.read()))
    arms = "".join(f"    ({a}) => {{\n        {quoted(sentence(api, a))}\n    }};\n" for a in sorted(asked))
    return ("// SPDX-License-Identifier: MIT\n// The words of the headers, for comments. Written by "
            f"bindings/rust/generate.py.\n\nmacro_rules! words {{\n{arms}}}\n")


# --- enums and structs --------------------------------------------------------------------------------


def comment(text, api, indent=""):
    lines = prose(text, api).split("\n")
    return "".join(f"{indent}/// {line}".rstrip() + "\n" for line in lines)


def variants(e):
    """The values of an enum with the names that Rust gives them."""
    values = [v for v in e["values"] if v["name"] not in PASSED_OVER]
    start = os.path.commonprefix([v["name"] for v in values])
    start = start[:start.rindex("_") + 1]
    for v in values:
        yield v, "".join(w.capitalize() for w in v["name"][len(start):].split("_"))


def enum(e, api):
    name = ENUMS[e["name"]]
    text = comment(e["doc"], api) + "#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]\n#[non_exhaustive]\n"
    text += f"pub enum {name} {{\n"
    for v, said in variants(e):
        text += comment(v["doc"], api, "    ") + f"    {said},\n"
    text += "    /// a number that has no name here\n    Other(i32),\n}\n\n"
    into = "".join(f"            {name}::{said} => sys::{v['name']},\n" for v, said in variants(e))
    out = "".join(f"            sys::{v['name']} => {name}::{said},\n" for v, said in variants(e))
    text += (f"impl {name} {{\n    #[allow(dead_code)]\n    pub(crate) fn c(self) -> sys::{e['name']} {{\n"
             f"        match self {{\n{into}            {name}::Other(number) => number,\n        }}\n    }}\n\n"
             f"    #[allow(dead_code)]\n    pub(crate) fn of(c: sys::{e['name']}) -> {name} {{\n"
             f"        match c {{\n{out}            number => {name}::Other(number),\n        }}\n    }}\n}}\n")
    return text


def rust_name(f):
    return f["name"] + "_" if f["name"] == "box" else f["name"]


def array_of(kind):
    return f"[{array_of(kind['of'])}; {kind['count']}]" if kind["kind"] == "array" else NUMBERS[kind["name"]]


def field(s, f):
    """Type of a field in Rust, and what makes it of the field of C."""
    kind, c = f["type"], f"c.{rust_name(f)}"
    if kind["kind"] == "array":
        return f"[{array_of(kind['of'])}; {kind['count']}]", c
    if kind["kind"] == "enum":
        return ENUMS[kind["name"]], f"{ENUMS[kind['name']]}::of({c})"
    if kind.get("name") == "sf_wide":
        return "u128", f"u128::from({c}.high) << 64 | u128::from({c}.low)"
    if kind["kind"] == "struct" and kind["name"] in PLAIN:
        return PLAIN[kind["name"]], f"crate::plain::of(&{c})"
    if kind["kind"] == "struct":
        return STRUCTS[kind["name"]], f"{STRUCTS[kind['name']]}::of(&{c})"
    if kind["name"] == "int":
        return "bool", f"{c} != 0"
    number = NUMBERS[kind["name"]]
    if f"{s['name']}.{f['name']}" in NONE:
        return f"Option<{number}>", f"({c} != {number}::MAX).then_some({c})"
    return number, c


def has_floats(s, api):
    """Whether there are numbers in it that are not equal to themselves."""
    inner = {f["type"]["name"] for f in s["fields"] if f["type"]["kind"] == "struct"}
    return any("f64" in field(s, f)[0] for f in s["fields"]) or any(
        has_floats(part, api) for part in api["structs"] if part["name"] in inner)


def turned_back(s, f):
    """A field in Rust as C has it."""
    kind, value = field(s, f)[0], f"self.{rust_name(f)}"
    if kind == "bool":
        return f"{value}.into()"
    if kind.startswith("Option"):
        return f"{value}.unwrap_or({kind[7:-1]}::MAX)"
    if kind in ENUMS.values() or kind in STRUCTS.values():
        return f"{value}.c()"
    return value


def struct(s, api):
    name = STRUCTS[s["name"]]
    traits = "Clone, Copy, Debug, PartialEq" + ("" if has_floats(s, api) else ", Eq, Hash")
    simple = all(field(s, f)[0] in NUMBERS.values() for f in s["fields"])
    traits += ", Default" if s["name"] in BOTH_WAYS and simple else ""
    text = f"{comment(s['doc'], api)}#[derive({traits})]\npub struct {name} {{\n"
    made = ""
    for f in s["fields"]:
        kind, value = field(s, f)
        none = " (`None` here)" if kind.startswith("Option") else ""
        text += comment(f["doc"] + none, api, "    ") + f"    pub {rust_name(f)}: {kind},\n"
        made += f"            {rust_name(f)}: {value},\n"
    text += (f"}}\n\nimpl {name} {{\n    #[allow(dead_code)]\n"
             f"    pub(crate) fn of(c: &sys::{s['name']}) -> {name} {{\n"
             f"        {name} {{\n{made}        }}\n    }}\n")
    if s["name"] in BOTH_WAYS:
        back = "".join(f"            {rust_name(f)}: {turned_back(s, f)},\n" for f in s["fields"])
        text += (f"\n    pub(crate) fn c(&self) -> sys::{s['name']} {{\n        sys::{s['name']} {{\n{back}"
                 "        }\n    }\n")
    return text + "}\n"


def options(s, api):
    """Choices that are plain values, filled by the library's defaults."""
    name = OPTIONS[s["name"]]
    fields = [f for f in s["fields"] if f["name"] not in ELSEWHERE and f["type"]["kind"] not in ("pointer", "callback")]
    said = [(f, *field(s, f)) for f in fields]
    text = f"{comment(s['doc'], api)}#[derive(Clone, Copy, Debug, PartialEq)]\npub struct {name} {{\n"
    text += "".join(f"{comment(f['doc'], api, '    ')}    pub {rust_name(f)}: {kind},\n" for f, kind, _ in said)
    out = "".join(f"            {rust_name(f)}: {value},\n" for f, _, value in said)
    back = ""
    for f, kind, _ in said:
        end = ".c()" if f["type"]["kind"] == "enum" else ".into()" if kind == "bool" else ""
        back += f"        c.{rust_name(f)} = self.{rust_name(f)}{end};\n"
    return (f"{text}}}\n\nimpl {name} {{\n    pub(crate) fn of(c: &sys::{s['name']}) -> {name} {{\n"
            f"        {name} {{\n{out}        }}\n    }}\n\n    pub(crate) fn c(&self) -> sys::{s['name']} {{\n"
            f"        let mut c = unsafe {{ sys::{s['default']}() }};\n{back}        c\n    }}\n}}\n\n"
            f"impl Default for {name} {{\n    fn default() -> {name} {{\n"
            f"        {name}::of(&unsafe {{ sys::{s['default']}() }})\n    }}\n}}\n")


def plain(s, api):
    name = PLAIN[s["name"]]
    kinds = [field(s, f)[0] for f in s["fields"]]
    traits = "Clone, Copy, Debug, " + ("" if s["name"] in NOT_ZERO else "Default, ") + "PartialEq"
    traits += "" if any("f64" in k for k in kinds) else ", Eq, Hash"
    text = f"{comment(s['doc'], api)}#[repr(C)]\n#[derive({traits})]\npub struct {name} {{\n"
    for f, kind in zip(s["fields"], kinds):
        if kind not in NUMBERS.values() and not re.fullmatch(r"\[(\w+); \w+\]", kind):
            raise SystemExit(f"{s['name']}.{f['name']} is no plain number")
        text += comment(f["doc"], api, "    ") + f"    pub {rust_name(f)}: {kind},\n"
    return (f"{text}}}\n\n// The fields are those of C, in their order.\nunsafe impl Plain for {name} {{\n"
            f"    type C = sys::{s['name']};\n}}\n")


def records(api):
    text = HEAD
    for e in api["enums"]:
        if e["name"] in ENUMS:
            text += "\n" + enum(e, api)
    for s in api["structs"]:
        if s["name"] in STRUCTS:
            text += "\n" + struct(s, api)
        if s["name"] in PLAIN:
            text += "\n" + plain(s, api)
        if s["name"] in OPTIONS:
            text += "\n" + options(s, api)
    return text


def made(api, folder):
    """The files of the crate in a folder: name and text."""
    kinds = ("functions", "structs", "enums", "opaque", "callbacks", "constants")
    api["names"] = {thing["name"] for kind in kinds for thing in api[kind]}
    api["names"] |= {v["name"] for e in api["enums"] for v in e["values"]}
    return {"src/records.rs": records(api), "src/words.rs": words(api, os.path.join(folder, "src"))}
