# Why: bindings are made from bindings/api/api.json, not from headers. A file that is behind them, a
# function that was not read, an argument of which nothing is said, or one that no test ever called is
# found here and not by whoever binds to it. Each rule is also tried on headers that are spoilt in one
# place, where it has to speak: a rule that finds nothing may be one that looks for nothing.
#
# usage: api.py SOURCE [NM SHARED-LIBRARY...]; speaks TAP.

import glob
import os
import re
import shutil
import subprocess
import sys
import tempfile

SOURCE = os.path.abspath(sys.argv[1])
NM = sys.argv[2] if len(sys.argv) > 2 else None
LIBRARIES = sys.argv[3:]
API = os.path.join(SOURCE, "bindings", "api")
sys.dont_write_bytecode = True
sys.path.insert(0, API)

import headers  # noqa: E402
import model  # noqa: E402
import rules  # noqa: E402

# Header, what stands there, what it becomes, and the rule that must speak, or None where the reader
# itself has to refuse.
SPOILT = [
    ("grid", "/** A stack of slices that owns its memory. */\n", "", rules.everything_is_said),
    ("grid", " /**< voxel size along x, > 0 */", "", rules.everything_is_said),
    ("base", " /**< done */", "", rules.everything_is_said),
    ("slice", "/** Largest reach of a structuring element along x and along y, in voxels. */\n", "",
     rules.everything_is_said),
    ("grid", "Free a grid.", "Free a grid", rules.functions_are_said),
    ("slice", "@cost constant.   @threads any.   @since 0.1\n */\nSF_API size_t sf_slice_stride",
     "@cost constant.   @threads any.\n */\nSF_API size_t sf_slice_stride", rules.functions_are_said),
    ("base", " * @return a static string, never NULL.\n * @cost constant.   @threads any.\n * @since 0.1\n"
     " */\nSF_API const char *sf_version", " * @cost constant.   @threads any.\n * @since 0.1\n */\n"
     "SF_API const char *sf_version", rules.functions_are_said),
    ("grid", " * @param clone ", " * ", rules.parameters_are_said),
    ("grid", " * @return as sf_grid_create().\n", " * @return a status.\n", rules.codes_are_said),
    ("grid", "SF_API SF_CHECKED sf_status sf_grid_clone", "SF_API sf_status sf_grid_clone",
     rules.codes_are_said),
    ("grid", "the grid; NULL has none", "the grid", rules.null_is_said),
    ("grid", "for the grid; NULL for the C library's", "for the grid", rules.null_is_said),
    ("sculpt", "NULL for NULL", "none", rules.null_is_said),
    ("grid", "the grid, freed; NULL does nothing", "the grid; NULL does nothing",
     rules.objects_begin_and_end),
    ("stand", "sf_stand_options_default(void)", "sf_stand_options_plain(void)",
     rules.options_have_defaults),
    ("grid", "SF_API int sf_grid_equal(", "SF_API int sf_slice_equal(", rules.names_are_once),
    ("grid", "uint64_t low, high;", "long low, high;", None),
    ("grid", "uint64_t low, high;", "uint64_t low : 3;", None),
    ("grid", "uint64_t low, high;", "union { int a; } u;", None),
    ("slice", "SF_BORDER_EMPTY = 0,", "SF_BORDER_EMPTY,", None),
    ("slice", "#define SF_REACH_MAX 255u", "#define SF_REACH_MAX UNKNOWN", None),
    ("slice", "#define SF_REACH_MAX 255u", "#define SF_REACH_MAX(a) (a)", None),
    ("grid", "SF_API int sf_grid_equal(const sf_grid *a,", "SF_API int sf_grid_equal(const sf_grit *a,",
     None),
    ("grid", "SF_API int sf_grid_equal(", "static inline int sf_grid_equal(", None),
    ("grid", "#include <sf/slice.h>", "#include <sf/voxel.h>", None),
]


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def is_current():
    """api.json is what the headers say"""
    run = subprocess.run([sys.executable, "-B", os.path.join(API, "generate.py"), SOURCE, "--check"],
                         capture_output=True, text=True)
    if run.returncode == 0:
        return []
    return ["run bindings/api/generate.py:"] + (run.stdout + run.stderr).splitlines()


def is_whole(api):
    """api.json names what the libraries export, no more and no less"""
    if not LIBRARIES:
        return "there are no shared libraries to look into"
    bad = []
    # Adapters have headers of their own, which are not bound.
    for path in [p for p in LIBRARIES if re.match(r"(lib)?sf(-io)?\.", os.path.basename(p))]:
        output = subprocess.run([NM, "-D", path], capture_output=True, text=True, check=True).stdout
        there = set(re.findall(r"^[0-9a-f]+ T (sf_\w+)", output, re.M))
        which = "sf-io" if "sf-io" in os.path.basename(path) else "sf"
        said = {f["name"] for f in api["functions"] if f["library"] == which}
        bad += [f"{which} exports {n}, which is not in api.json" for n in sorted(there - said)]
        bad += [f"{which} does not export {n}" for n in sorted(said - there)]
    return bad


def formats_are_kept(api):
    """Lines of comments that show a format keep their indentation"""
    wanted = 0
    for header in api["headers"]:
        text = read(os.path.join(SOURCE, "libsf", "include", header["name"]))
        for comment in re.findall(r"^/\*\*(.*?)\*/", text, re.M | re.S):
            wanted += len(re.findall(r"^ \*     *\S", comment.split("\n * @")[0], re.M))
    kept = sum(line.startswith("    ") for kind in ("enums", "opaque", "callbacks", "structs", "functions")
               for thing in api[kind] for line in thing["doc"].split("\n"))
    return [] if kept == wanted else [f"{wanted} lines of headers are indented, {kept} of api.json"]


def exceptions():
    found = {}
    for line in read(os.path.join(API, "exceptions.txt")).splitlines():
        if line and not line.startswith("#"):
            name, _, reason = line.partition(":")
            found[name] = reason.strip()
    return found


def calls(folder):
    """The names of functions that the tests call."""
    found = set()
    for place, _, names in os.walk(folder):
        for name in names:
            if name.endswith((".c", ".h")):
                code = re.sub(r"//[^\n]*|/\*.*?\*/", "", read(os.path.join(place, name)), flags=re.S)
                found |= set(re.findall(r"\b(sf_\w+)\s*\(", code))
    return found


def are_called(api):
    """Every function is called by a test, or exceptions.txt says why it is not"""
    called, excepted = calls(os.path.join(SOURCE, "tests")), exceptions()
    names = {f["name"] for f in api["functions"]}
    bad = [f"no test calls {n}" for n in sorted(names - called - excepted.keys())]
    bad += [f"exceptions.txt names {n}, which is no function" for n in excepted.keys() - names]
    bad += [f"exceptions.txt names {n}, which a test calls" for n in excepted.keys() & called]
    bad += [f"exceptions.txt gives no reason for {n}" for n, reason in excepted.items() if not reason]
    return bad


def bound_in_python():
    """Functions that the Python package calls, and defaults of options that it takes."""
    code = "".join(read(path) for path in glob.glob(os.path.join(SOURCE, "bindings", "python", "libsf", "*.py")))
    options = re.findall(r'options\(\s*"(sf_\w+)"', code)
    return set(re.findall(r"\b_?lib\.(sf_\w+)", code)) | {name + "_default" for name in options}


def bound_in_rust():
    """Functions that the safe crate calls. Its words name others, and so do comments."""
    found = set()
    for path in glob.glob(os.path.join(SOURCE, "bindings", "rust", "libsf", "src", "*.rs")):
        if os.path.basename(path) != "words.rs":
            found |= set(re.findall(r"\bsys::(sf_\w+)", re.sub(r"//[^\n]*", "", read(path))))
    return found


BINDINGS = {"python": bound_in_python, "rust": bound_in_rust}


def are_bound(api):
    """Every function is bound in each language, or unbound.txt says why it is not"""
    names, bad = {f["name"] for f in api["functions"]}, []
    listed = {language: {} for language in BINDINGS}
    for line in read(os.path.join(API, "unbound.txt")).splitlines():
        if line and not line.startswith("#"):
            what, _, reason = line.partition(":")
            language, name = what.split()
            if language in listed:
                listed[language][name] = reason.strip()
    for language, find in BINDINGS.items():
        bound, excused = find(), listed[language]
        bad += [f"{language} does not bind {n}" for n in sorted(names - bound - excused.keys())]
        bad += [f"unbound.txt names {n}, which is no function" for n in excused.keys() - names]
        bad += [f"unbound.txt names {n}, which {language} binds" for n in excused.keys() & bound]
        bad += [f"unbound.txt gives no reason for {n}" for n, reason in excused.items() if not reason]
    return bad


def are_fuzzed(api):
    """Every function is called by a fuzz target, or fuzz/shapes.txt says why it is not"""
    sys.argv = ["calls.py", SOURCE, "--table"]
    sys.path.insert(0, os.path.join(SOURCE, "fuzz"))
    import calls as fuzz
    found = fuzz.table()
    bad = [f"no fuzz target calls {n}, and fuzz/shapes.txt gives no reason" for n in sorted(found)
           if not found[n] and not fuzz.SHAPES.left.get(n)]
    bad += [f"fuzz/shapes.txt has to say how much is behind {key}" for key in fuzz.unsaid()]
    return bad + [f"fuzz/shapes.txt speaks of {key}, which there is not" for key in fuzz.stale()]


def spoil(tree, header, before, after):
    """Headers of a project in which one of them is another; whether that is found in it."""
    path = os.path.join(tree, "libsf", "include", "sf", header + ".h")
    text = read(path)
    if before not in text:
        return False
    with open(path, "w", encoding="utf-8") as file:
        file.write(text.replace(before, after, 1))
    return True


def rules_bite():
    """What is spoilt in a header is found"""
    bad = []
    for header, before, after, rule in SPOILT:
        place = f"{header}.h, {before.strip()[:60]!r}"
        with tempfile.TemporaryDirectory() as tree:
            shutil.copytree(os.path.join(SOURCE, "libsf", "include"), os.path.join(tree, "libsf", "include"))
            if not spoil(tree, header, before, after):
                bad.append(f"{place} is not there to be spoilt")
                continue
            try:
                said = rule(model.build(tree)) if rule else []
                refused = rule is None and model.build(tree) is None
            except headers.Trouble:
                said, refused = [], rule is None
        if not said and not refused:
            bad.append(f"{place}: {'the reader' if rule is None else rule.__name__} does not mind")
    bad += [f"nothing spoils {r.__name__}" for r in rules.RULES if r not in [s[3] for s in SPOILT]]
    return bad


def main():
    api = model.build(SOURCE)
    checks = [(is_current.__doc__, is_current()), (is_whole.__doc__, is_whole(api)),
              (formats_are_kept.__doc__, formats_are_kept(api)), (are_called.__doc__, are_called(api)),
              (are_bound.__doc__, are_bound(api)), (are_fuzzed.__doc__, are_fuzzed(api)), (rules_bite.__doc__, rules_bite())]
    checks += [(rule.__doc__, rule(api)) for rule in rules.RULES]
    for number, (what, bad) in enumerate(checks, 1):
        if isinstance(bad, str):
            print(f"ok {number} - {what} # SKIP {bad}")
            continue
        for line in bad[:40]:
            print(f"# {line}")
        print(f"{'not ' if bad else ''}ok {number} - {what}")
    print(f"1..{len(checks)}")
    return any(bad and not isinstance(bad, str) for _, bad in checks)


sys.exit(main())
