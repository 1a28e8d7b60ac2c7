# Why: a house rule that nobody holds is a wish. This program reads the project as it stands and says
# where it leaves its own rules: what is exported, what each public function must say, how long
# things may be, who may include whom, how sources look. Every list that exists twice is compared.
#
# usage: house.py SOURCE VERSION [NM SHARED-LIBRARY...]; speaks TAP.

import os
import re
import shutil
import subprocess
import sys

SOURCE = os.path.abspath(sys.argv[1])
VERSION = sys.argv[2]
NM = sys.argv[3] if len(sys.argv) > 3 else None
LIBRARIES = sys.argv[4:]

ROOMS = ["libsf", "bindings", "demo", "tests", "fuzz"]
FILE_LINES = 500
FUNCTION_LINES = 60
COLUMNS = 100
# Files and functions that may be longer, and why. Empty: nothing may.
LONGER_FILES = {}
LONGER_FUNCTIONS = {}

# A room includes only rooms of lower floors and itself. The public headers stand on the floors of
# the rooms whose contracts they are; <sf/voxel.h> is the contract of simd and of voxel both.
FLOORS = {"base": 0, "simd": 1, "voxel": 2, "support": 3, "mesh": 3, "sculpt": 4, "balance": 4,
          "grade": 4, "orient": 4, "io": 5, "link": 5}
# Rooms with more than one public header.
HEADER_ROOMS = {"bend": "balance", "blend": "balance", "body": "balance", "cage": "grade", "cage_build": "grade", "cage_history": "grade", "cage_io": "io", "carve": "balance", "certificate": "support", "chip": "support", "contour": "voxel", "contour_io": "io", "density": "balance", "exchange": "io", "finding": "support", "gltf": "io", "grid": "voxel", "grow": "support", "halftone": "grade", "handles": "balance", "job": "io", "layers": "io", "limit": "grade", "locate": "grade", "mixture": "grade", "paint": "grade", "preserve": "support", "printing": "balance", "property": "grade", "refine": "grade", "repair": "support", "rule": "support", "sample": "grade", "session": "io", "slice": "voxel", "stance": "balance", "stand": "balance", "tetra": "grade", "threemf": "io", "weights": "balance"}
SHARED_CONTRACT = {"simd": ["voxel"]}

# What libsf asks of the C library. No locale, no files, no printing, nothing that allocates unseen.
LIBC = {"malloc", "free", "memcpy", "memmove", "memset", "memcmp", "sqrt", "floor", "fabs", "ldexp",
        "bcmp", "vsnprintf"}


def read(path):
    with open(os.path.join(SOURCE, path), "rb") as file:
        return file.read().decode("utf-8")


def files(*endings, rooms=ROOMS):
    found = []
    for room in rooms:
        for folder, folders, names in os.walk(os.path.join(SOURCE, room)):
            folders[:] = [f for f in folders if not f.startswith(".") and f != "__pycache__"]
            found += [os.path.relpath(os.path.join(folder, name), SOURCE).replace(os.sep, "/")
                      for name in names if name.endswith(endings)]
    return sorted(found)


SOURCES = files(".c", ".h")
TEXTS = [p for p in files(".c", ".h", ".sh", ".py", ".awk", ".in", ".txt", ".md", "meson.build")
         ] + [n for n in ["meson.build", "meson_options.txt", "dev", ".ci/run", "README.md",
                          "CHANGELOG.md", "CONTRIBUTING.md", "CITATION.cff",
                          "docs/pictures/make.sh"]
              if os.path.exists(os.path.join(SOURCE, n))]
HEADERS = [p for p in SOURCES if p.startswith("libsf/include/sf/")]


class Function:
    """A public function as its header declares it, with the comment above it."""

    def __init__(self, header, comment, declaration):
        self.header, self.comment = header, comment
        self.name = re.search(r"(\w+)\s*\(", declaration).group(1)
        self.returns = declaration[:declaration.index(self.name)].strip()
        parameters = declaration[declaration.index("(") + 1:declaration.rindex(")")]
        self.parameters = [re.search(r"(\w+)(\[\w*\])?$", p.strip()).group(1)
                           for p in parameters.split(",") if p.strip() != "void"]


def public_functions():
    found = []
    for header in HEADERS:
        text = read(header)
        for match in re.finditer(r"^SF_API\s+(?!__)([^;{}]*?\([^;]*\));", text, re.M):
            before = text[:match.start()].rstrip()
            comment = None
            if before.endswith("*/"):
                comment = before[before.rindex("/*"):]
            declaration = re.sub(r"\s+", " ", match.group(1)).replace("SF_CHECKED ", "")
            found.append(Function(header, comment, declaration))
    return found


FUNCTIONS = public_functions()


# --- what is exported ------------------------------------------------------------------------


def exported(library):
    output = subprocess.run([NM, "-D", library], capture_output=True, text=True, check=True).stdout
    lines = [line.split() for line in output.splitlines()]
    defined = {line[-1].split("@")[0] for line in lines if len(line) == 3}
    wanted = {line[-1].split("@")[0] for line in lines if len(line) == 2 and line[0] == "U"}
    return defined, wanted


def library_of(header):
    """The library that a public header belongs to: sf, sf-io, or an adapter of the header's name."""
    if room_of(header) == "link":
        return "sf-" + os.path.basename(header)[:-2]
    return "sf-io" if room_of(header) == "io" else "sf"


def library_named(path):
    """libsf-io.so.0.1.0 is sf-io."""
    return os.path.basename(path).removeprefix("lib").split(".")[0]


def check_exports():
    """The libraries export what the public headers declare, no more and no less."""
    if not LIBRARIES:
        return "skip: there are no shared libraries to look into"
    bad = []
    for library in LIBRARIES:
        declared = {f.name for f in FUNCTIONS if library_of(f.header) == library_named(library)}
        defined, _ = exported(library)
        name = os.path.basename(library)
        bad += [f"{name} exports {s}, which no public header declares" for s in defined - declared]
        bad += [f"{name} lacks {s}, which a public header declares" for s in declared - defined]
        bad += [f"{name} exports {s}, not an sf_ name" for s in defined if not s.startswith("sf_")]
    return bad


def check_libc():
    """The core asks of the C library only what the house allows."""
    core = [l for l in LIBRARIES if library_named(l) == "sf"]
    if not core:
        return "skip: there is no shared library to look into"
    _, wanted = exported(core[0])
    return [f"libsf calls {s}" for s in sorted(wanted) if s not in LIBC and not s.startswith("__")]


# --- what a public function says -------------------------------------------------------------


def check_doc_comments():
    """Every public function says what it does, @return, @cost, @threads and @since."""
    bad = []
    for f in FUNCTIONS:
        place = f"{f.header}: {f.name}"
        if f.comment is None or not f.comment.startswith("/**"):
            bad.append(f"{place} has no doc comment")
            continue
        text = re.sub(r"^\s*\*(?!/) ?", "", f.comment[3:-2].strip(), flags=re.M)
        first = re.split(r"\n\s*\n|\n\s*@", text)[0]
        if not re.match(r"\S[^@]*?[.](\s|$)", first):
            bad.append(f"{place} does not begin with a sentence")
        wanted = ["@cost", "@threads", "@since"] + ([] if f.returns == "void" else ["@return"])
        bad += [f"{place} lacks {tag}" for tag in wanted if tag not in text]
        named = re.findall(r"@param\s+(\w+)", text)
        bad += [f"{place} documents '{p}', which is no parameter" for p in named
                if p not in f.parameters]
        if named and len(f.parameters) != len(named):
            bad.append(f"{place} documents {len(named)} of {len(f.parameters)} parameters")
        if "sf_status" in f.returns and not re.search(r"@return\s+([^@]*\bSF_OK\b|as\b|what\b)", text):
            bad.append(f"{place} does not name the codes that it returns")
    return bad


def check_codes():
    """Every status code that is written anywhere exists."""
    codes = set(re.findall(r"\bSF_(?:OK|ERR_[A-Z]+)\b", read("libsf/include/sf/base.h")))
    bad = []
    for path in SOURCES:
        bad += [f"{path}: {c}" for c in set(re.findall(r"\bSF_ERR_[A-Z]+\b", read(path))) - codes]
    return bad


def functions_of(path):
    """The functions that a file defines: name, whether it is static, and body."""
    code = re.sub(r"//[^\n]*|/\*.*?\*/", "", read(path), flags=re.S)
    for match in re.finditer(r"^(\w[^;{}#]*?\b(\w+)\([^;{}]*\))\n\{\n(.*?)^\}", code, re.M | re.S):
        yield match.group(2), match.group(1).startswith("static"), match.group(3)


def literal_codes(name, bodies, seen):
    """Codes that a function makes, itself or in the static functions of its file that it names."""
    seen.add(name)
    made = set(re.findall(r"(?<![=!]= )(?<!case )\bSF_ERR_[A-Z]+\b", bodies[name]))
    for other in set(re.findall(r"\b\w+\b", bodies[name])) & bodies.keys() - seen:
        made |= literal_codes(other, bodies, seen)
    return made


def named_codes(name, seen):
    """Codes that the comment of a public function names, by itself or by the functions it refers to."""
    seen.add(name)
    comment = next((f.comment for f in FUNCTIONS if f.name == name), None) or ""
    said = re.search(r"@return(.*?)(?=\s@[a-z]|\*/)", comment, re.S)
    codes = set(re.findall(r"\bSF_ERR_[A-Z]+\b", said.group(1) if said else ""))
    for other in set(re.findall(r"\b(sf_\w+)\(\)", said.group(1) if said else "")) - seen:
        codes |= named_codes(other, seen)
    return codes


def check_returns():
    """A public function's @return names the codes that its own file makes."""
    bad = []
    public = {f.name for f in FUNCTIONS if "sf_status" in f.returns}
    for path in [p for p in SOURCES if p.startswith("libsf/") and p.endswith(".c")]:
        found = list(functions_of(path))
        bodies = {name: body for name, is_static, body in found if is_static}
        for name, is_static, body in found:
            if name in public:
                made = literal_codes(name, {**bodies, name: body}, set())
                bad += [f"{path}: {name} does not document {code}"
                        for code in made - named_codes(name, set())]
    return bad


def check_static():
    """A function that one file alone uses is static there, and static ones have no prefix."""
    public = {f.name for f in FUNCTIONS} | {"main", "LLVMFuzzerTestOneInput"}
    code = {path: re.sub(r"//[^\n]*|/\*.*?\*/", "", read(path), flags=re.S) for path in SOURCES}
    # A header that declares a function does not use it.
    words = {path: set(re.findall(r"\b[A-Za-z]\w+\b", re.sub(r"^[A-Za-z][^;{}#=]*\([^;{}]*\);", "", text,
                                                            flags=re.M) if path.endswith(".h") else text))
             for path, text in code.items()}
    # fuzz/calls.py writes the calls of these: by name, or world_ and the type that it needs.
    words["fuzz/calls.py"] = set(re.findall(r"\b[A-Za-z]\w+\b", read("fuzz/calls.py") + read("fuzz/shapes.txt")))
    words["fuzz/calls.py"] |= set(re.findall(r"\bworld_sf_\w+", read("fuzz/world.h")))
    bad, homes = [], {}
    for path in SOURCES:
        for name, is_static, _ in functions_of(path):
            if is_static and path.endswith(".c") and re.match(r"sfi?_", name):
                bad.append(f"{path}: {name} is static, and named as if it were not")
            elif not is_static and name not in public and not name.isupper():
                homes.setdefault(name, set()).add(path)
    bad += [f"{', '.join(sorted(paths))}: nobody else uses {name}" for name, paths in homes.items()
            if not any(name in words[path] for path in words if path not in paths)]
    return bad


# --- how long things are, how they begin, how they look ----------------------------------------


def check_files():
    """No file is longer than 500 lines."""
    counts = {path: read(path).count("\n") for path in SOURCES}
    return [f"{p}: {n} lines" for p, n in counts.items()
            if n > LONGER_FILES.get(p, FILE_LINES)]


def check_functions():
    """No function is longer than 60 lines."""
    bad = []
    for path in SOURCES:
        lines = read(path).splitlines()
        start = None
        for i, line in enumerate(lines):
            # A body opens with a brace of its own at the margin; its head began after a blank
            # line, a comment, a directive or the end of what came before.
            if line == "{":
                start = i
                while lines[start - 1] and not re.match(r"[}#/]|.*;$| \*", lines[start - 1]):
                    start -= 1
            elif line == "}" and start is not None:
                length = i - start + 1
                if length > LONGER_FUNCTIONS.get(f"{path}:{start + 1}", FUNCTION_LINES):
                    bad.append(f"{path}:{start + 1}: {length} lines: {lines[start].strip()}")
                start = None
    return bad


def check_heads():
    """Every source opens with its licence and says why it is there."""
    bad = []
    for path in SOURCES:
        lines = read(path).splitlines() or [""]
        if lines[0] != "// SPDX-License-Identifier: MIT":
            bad.append(f"{path} has no SPDX line")
        elif not re.match(r"// \S.{10,}", lines[1] if len(lines) > 1 else ""):
            bad.append(f"{path} does not say what it is for")
    return bad


def check_guards():
    """Every header is guarded by its own name."""
    bad = []
    for path in [p for p in SOURCES if p.endswith(".h") and not p.endswith("template.h")]:
        match = re.search(r"^#ifndef (\w+_H)\n#define \1$", read(path), re.M)
        stem = os.path.basename(path)[:-2].upper()
        if match is None or not match.group(1).endswith(f"{stem}_H"):
            bad.append(path)
    return bad


def check_looks():
    """LF, no tabs, no trailing blanks, at most 100 columns, nothing left to do, no machine's paths."""
    # Put together here, so that this file does not find itself.
    undone = re.compile(r"\b(" + "|".join(["TO" + "DO", "FIX" + "ME", "X" + "XX", "HA" + "CK"]) + r")\b")
    homes = re.compile("|".join(["/ho" + "me/", "/ro" + "ot/", "/wo" + "rk/", "/Us" + "ers/", r"C:\\Us" + "ers"]))
    bad = []
    for path in TEXTS:
        text = read(path)
        if not text.endswith("\n") or text.endswith("\n\n"):
            bad.append(f"{path} does not end with one newline")
        for i, line in enumerate(text.split("\n"), 1):
            place = f"{path}:{i}"
            if "\r" in line or "\t" in line or line != line.rstrip():
                bad.append(f"{place}: a tab, a carriage return or a blank at the end")
            if path.endswith((".c", ".h")) and len(line) > COLUMNS:
                bad.append(f"{place}: {len(line)} columns")
            if undone.search(line):
                bad.append(f"{place}: something is left to do")
            if homes.search(line):
                bad.append(f"{place}: a path of somebody's machine")
    return bad


def check_names():
    """No file is a drawer for odds and ends."""
    drawers = re.compile(r"(^|[_-])(util|utils|common|helper|helpers|misc|stuff)([_.-]|$)")
    return [p for p in files("") if drawers.search(os.path.basename(p))]


def check_language():
    """No 128-bit integers, variable-length memory, jumps or foreign mathematics in the library."""
    calls = re.compile(r"\b(alloca|powf?|expf?|logf?|sinf?|cosf?|tanf?|atan2?f?|acosf?|asinf?|cbrtf?|"
                       r"hypotf?|fmaf?|setlocale|strtod|atof|rand|exit|abort|printf|sprintf)\s*\(")
    words = re.compile(r"\b(__int128\w*|__uint128_t|long\s+double|goto)\b")
    bad = []
    for path in [p for p in SOURCES if p.startswith("libsf/")]:
        code = re.sub(r'"(\\.|[^"\\\n])*"', '""', re.sub(r"//[^\n]*|/\*.*?\*/", "", read(path), flags=re.S))
        bad += [f"{path}: {m.group(1)}" for p in [calls, words] for m in p.finditer(code)]
    return bad


def check_format():
    """clang-format 14 would change nothing."""
    tool = shutil.which("clang-format-14") or shutil.which("clang-format")
    if tool is None:
        return "skip: clang-format 14 is not installed"
    version = subprocess.run([tool, "--version"], capture_output=True, text=True).stdout
    if not re.search(r"version 14\.", version):
        return "skip: clang-format is here, but it is not version 14"
    run = subprocess.run([tool, "--dry-run", *SOURCES], cwd=SOURCE, capture_output=True, text=True)
    return sorted(set(re.findall(r"^(\S+:\d+):\d+: warning", run.stderr, re.M)))


# --- who includes whom, and lists that exist twice ---------------------------------------------


def room_of(path):
    """The room that a file of libsf, or a header named in an #include, belongs to."""
    if re.match(r"(?:libsf/)?(?:include/)?sf/link/", path):
        return "link"
    match = re.match(r"(?:libsf/)?(?:include/)?sf/(\w+)\.h$", path)
    if match:
        return HEADER_ROOMS.get(match.group(1), match.group(1))
    return path.removeprefix("libsf/").split("/")[0]


def check_floors():
    """A room includes rooms of lower floors only."""
    bad = []
    for path in [p for p in SOURCES if p.startswith("libsf/") and not p.endswith("/sf.h")]:
        room = room_of(path)
        if room not in FLOORS:
            bad.append(f"{path} is in no room")
            continue
        for included in re.findall(r'^#include (?:"([^"]+)"|<(sf/[^>]+)>)', read(path), re.M):
            other = room_of(included[0] or included[1])
            is_public = bool(included[1])
            lower = other in FLOORS and (other == room or FLOORS[other] < FLOORS[room])
            if not lower and not (is_public and other in SHARED_CONTRACT.get(room, [])):
                bad.append(f"{path} (floor {FLOORS[room]}) includes {included[0] or included[1]}")
    return bad


def check_lists():
    """Every source is built, and every source that is built is there."""
    bad = []
    for path in files("meson.build", rooms=["libsf", "demo", "fuzz", "tests"]):
        folder = os.path.dirname(path)
        text = read(path)
        for name in re.findall(r"(?<!output: )(?<!output: \[)'([a-z][\w./-]*\.c)'", text):
            if not os.path.exists(os.path.join(SOURCE, folder, name)):
                bad.append(f"{path} lists {name}, which is not there")
    for path in [p for p in SOURCES if p.endswith(".c")]:
        folder, name = os.path.split(path)
        text = read(folder + "/meson.build") if os.path.exists(
            os.path.join(SOURCE, folder, "meson.build")) else ""
        if f"'{name}'" not in text and f"'{name[:-2]}'" not in text:
            bad.append(f"{path} is in no meson.build")
    installed = set(re.findall(r"'(\w+)'", read("libsf/include/meson.build")))
    adapters = read("libsf/link/meson.build") if os.path.exists(os.path.join(SOURCE, "libsf/link/meson.build")) else ""
    installed |= {"link/" + name for name in re.findall(r"^  \['(\w+)', ", adapters, re.M)}
    bad += [f"{h} is not installed" for h in HEADERS
            if h.removeprefix("libsf/include/sf/").removesuffix(".h") not in installed]
    return bad


def check_version():
    """meson, base.h, CITATION.cff and CHANGELOG.md name one version, and no @since a later one."""
    header = read("libsf/include/sf/base.h")
    numbers = [re.search(rf"#define SF_VERSION_{part} (\d+)", header).group(1)
               for part in ["MAJOR", "MINOR", "PATCH"]]
    said = {
        "base.h, numbers": ".".join(numbers),
        "base.h, string": re.search(r'#define SF_VERSION_STRING "([^"]+)"', header).group(1),
        "CITATION.cff": re.search(r"^version: (\S+)$", read("CITATION.cff"), re.M).group(1),
        "CHANGELOG.md": re.search(r"^## \[([^\]]+)\]", read("CHANGELOG.md"), re.M).group(1),
    }
    bad = [f"{place} says {v}, meson says {VERSION}" for place, v in said.items() if v != VERSION]
    now = [int(n) for n in VERSION.split(".")]
    for header in sorted({f.header for f in FUNCTIONS}):
        bad += [f"{header} says @since {v}, which is after {VERSION}"
                for v in sorted(set(re.findall(r"@since (\d+(?:\.\d+)*)", read(header))))
                if [int(n) for n in v.split(".")] > now]
    return bad


def check_readme():
    """What the README names is there: files, folders, CMake targets, every verb; its pictures are light."""
    text = re.sub(r"^```.*?^```", "", read("README.md"), flags=re.M | re.S)
    named = re.findall(r"\]\((?!https?:)([^)]+)\)", text)
    named += [w for w in re.findall(r"`([\w./-]+)`", text) if "/" in w.strip("./")]
    bad = [f"README.md names {n}, which is not there" for n in named
           if not os.path.exists(os.path.join(SOURCE, n))]
    bad += [f"{n} is larger than 150 kB" for n in named if n.endswith(".png")
            and os.path.exists(os.path.join(SOURCE, n)) and os.path.getsize(os.path.join(SOURCE, n)) > 150000]
    bad += [f"README.md names libsf/{r}, which is not there" for r in re.findall(
        r"`(\w+)`", re.search(r"^\| `libsf` \|.*room:(.*)$", text, re.M).group(1))
        if not os.path.isdir(os.path.join(SOURCE, "libsf", r))]
    targets = set(re.findall(r"sf_place_\((\S+) ", read("libsf/package/libsfConfig.cmake.in")))
    bad += [f"README.md names the CMake target {t}, which is not there"
            for t in re.findall(r"`(\w+::[\w-]+)`", text) if t not in targets]
    verbs = re.findall(r'^    \{\{"(\w+)", "([^"]+)"', read("demo/sf/verbs.c"), re.M)
    said = re.findall(r"^\| `(\w+)` \| (.*) \|$", text[:text.index("## Where")], re.M)
    if said != verbs:
        bad.append(f"README.md says {said}, demo/sf/verbs.c {verbs}")
    return bad


def main():
    checks = [check_exports, check_libc, check_doc_comments, check_codes, check_returns, check_static, check_files,
              check_functions, check_heads, check_guards, check_looks, check_names, check_language,
              check_format, check_floors, check_lists, check_version, check_readme]
    failures = 0
    for number, check in enumerate(checks, 1):
        bad = check()
        if isinstance(bad, str):
            print(f"ok {number} - {check.__doc__} # SKIP {bad.removeprefix('skip: ')}")
            continue
        for line in sorted(bad)[:40]:
            print(f"# {line}")
        if len(bad) > 40:
            print(f"# and {len(bad) - 40} more")
        print(f"{'not ' if bad else ''}ok {number} - {check.__doc__}")
        failures += bool(bad)
    print(f"1..{len(checks)}")
    return failures > 0


sys.exit(main())
