# Why: who links libsf in has to say what is in it. The list that is installed must be what SPDX 2.3
# asks for, must name every library that the shared libraries and the programs ask the loader for,
# and must be the same bytes each time.
#
# usage: sbom.py GENERATOR BUILD VERSION READELF NAME,NAME... FILE...; speaks TAP

import json
import os
import re
import subprocess
import sys
import tempfile

GENERATOR, BUILD, VERSION, READELF = sys.argv[1:5]
ALSO_FOUND = [n for n in sys.argv[5].split(",") if n]
FILES = sys.argv[6:]
PLATFORM = re.compile(r"lib(c|m|pthread|dl|rt|gcc_s|stdc\+\+)\.so|ld-|libsf|linux-vdso")
# By what the loader calls it, where that is not the name that meson knows.
ALSO = {"hdf5_serial": "hdf5-serial", "hdf5": "hdf5", "glfw": "glfw3", "png16": "libpng",
        "embree3": "embree", "embree4": "embree", "z": "zlib", "tetgen": "tet", "tet1.5": "tet"}
count = bad = 0


def ok(problems, what):
    global count, bad
    count += 1
    bad += bool(problems)
    for problem in problems:
        print("#", problem)
    print(f"{'not ok' if problems else 'ok'} {count} - {what}")


def generate(**environment):
    return subprocess.run([sys.executable, "-B", GENERATOR, BUILD, VERSION, "-", *ALSO_FOUND],
                          capture_output=True, text=True,
                          env={"PATH": "/usr/bin:/bin", **environment}).stdout


with tempfile.TemporaryDirectory() as folder:
    subprocess.run([sys.executable, "-B", GENERATOR, BUILD, VERSION, "share/libsf", *ALSO_FOUND], check=True,
                   env={"PATH": "/usr/bin:/bin", "MESON_INSTALL_DESTDIR_PREFIX": folder})
    with open(os.path.join(folder, "share", "libsf", "libsf.spdx.json"), encoding="utf-8") as file:
        text = file.read()
said = json.loads(text)
wanted = {"spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT"}
ok([f"{k} is {said.get(k)}" for k, v in wanted.items() if said.get(k) != v] +
   [f"{k} is missing" for k in ("name", "documentNamespace", "creationInfo", "packages", "relationships")
    if not said.get(k)], "it is a document of SPDX 2.3")

packages = {p["name"]: p for p in said["packages"]}
ok([f"{p.get('name')} lacks {k}" for p in said["packages"]
    for k in ("SPDXID", "name", "versionInfo", "downloadLocation", "licenseDeclared") if not p.get(k)] +
   [f"{p['SPDXID']} is no name" for p in said["packages"]
    if not re.fullmatch(r"SPDXRef-[A-Za-z0-9.-]+", p["SPDXID"])] +
   ([] if packages.get("libsf", {}).get("versionInfo") == VERSION else ["libsf's version is another"]),
   "each package has a version and a licence")

known = {p["SPDXID"] for p in said["packages"]} | {"SPDXRef-DOCUMENT"}
ok([f"{r['relatedSpdxElement']} is nobody" for r in said["relationships"]
    if r["relatedSpdxElement"] not in known or r["spdxElementId"] not in known] +
   [f"nothing is said of {i}" for i in known - {"SPDXRef-DOCUMENT"} -
    {r["relatedSpdxElement"] for r in said["relationships"]}], "each package is what something depends on")

missing = []
for path in FILES:
    out = subprocess.run([READELF, "-d", path], capture_output=True, text=True).stdout
    for name in re.findall(r"\(NEEDED\).*\[([^]]+)\]", out):
        plain = re.sub(r"^lib|\.so.*$", "", name)
        if not PLATFORM.match(name) and ALSO.get(plain, plain) not in packages:
            missing.append(f"{path} asks for {name}, which the list does not name")
ok(missing if FILES else ["there are no files to look into"], "it names what the loader is asked for")

again = [generate(), generate(TZ="Asia/Tokyo", LC_ALL="C"), generate(SOURCE_DATE_EPOCH="1700000000")]
ok(([] if again[0] == again[1] == text else ["two lists of one build differ"]) +
   ([] if '"2023-11-14T22:13:20Z"' in again[2] else ["SOURCE_DATE_EPOCH is not heeded"]),
   "it is the same bytes each time, and dated as the packager says")
print(f"1..{count}")
sys.exit(bad > 0)
