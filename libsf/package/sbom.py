# What went into a build, as SPDX 2.3 in JSON: the project itself and every library that meson found.
# Without times or places of its own, so that two builds write the same bytes: `created` is
# SOURCE_DATE_EPOCH, or the beginning of time.
#
# usage: sbom.py BUILD VERSION FOLDER [NAME...]; names of libraries that meson has no list of. FOLDER - prints
# the list; any other is meson's to name, as it installs: libsf.spdx.json there, below the prefix.

import datetime
import hashlib
import json
import os
import sys

# By meson's name: the licence, who makes it, what it is for.
LIBRARIES = {
    "cairo": ("LGPL-2.1-only OR MPL-1.1", "https://cairographics.org", "words in pictures"),
    "embree": ("Apache-2.0", "https://www.embree.org", "rays"),
    "epoxy": ("MIT", "https://github.com/anholt/libepoxy", "sculpting on the graphics card"),
    "expat": ("MIT", "https://libexpat.github.io", "3MF"),
    "glfw3": ("Zlib", "https://www.glfw.org", "the window"),
    "hdf5": ("BSD-3-Clause", "https://www.hdfgroup.org", "exchange files"),
    "hdf5-serial": ("BSD-3-Clause", "https://www.hdfgroup.org", "exchange files"),
    "hidapi-hidraw": ("BSD-3-Clause", "https://github.com/libusb/hidapi", "SpaceMice"),
    "imgui": ("MIT", "https://github.com/ocornut/imgui", "the panel"),
    "jansson": ("MIT", "https://github.com/akheron/jansson", "JSON"),
    "lib3MF": ("BSD-2-Clause", "https://3mf.io", "a test's reader of 3MF"),
    "libpng": ("libpng-2.0", "http://www.libpng.org", "PNG"),
    "muparser": ("BSD-2-Clause", "https://github.com/beltoforion/muparser", "formulas in recipes"),
    "osdCPU": ("Apache-2.0", "https://graphics.pixar.com/opensubdiv", "limit surfaces to compare with"),
    "spng": ("BSD-2-Clause", "https://libspng.org", "PNG"),
    "tet": ("AGPL-3.0-or-later", "https://wias-berlin.de/software/tetgen", "tetrahedra, in a program apart"),
    "tinygltf": ("MIT", "https://github.com/syoyo/tinygltf", "glTF"),
    "zlib": ("Zlib", "https://zlib.net", "compression"),
}
# Nothing that is installed is linked with these: the platform's own, the Python that is built for, and
# what tests alone compare with.
PLATFORM = ("threads", "dl", "m", "python", "pybind", "lib3MF", "lib3mf")


def package(name, version, licence, home, purpose):
    found = {"SPDXID": "SPDXRef-" + name.replace("_", "-"), "name": name, "versionInfo": version,
             "downloadLocation": home or "NOASSERTION", "filesAnalyzed": False,
             "licenseConcluded": licence, "licenseDeclared": licence, "copyrightText": "NOASSERTION"}
    if purpose:
        found["summary"] = purpose
    return found


def is_platform(name):
    return name in PLATFORM or name.startswith("python-")


def dependencies(build):
    with open(os.path.join(build, "meson-info", "intro-dependencies.json"), encoding="utf-8") as file:
        return json.load(file)


def document(build, version, also):
    own = package("libsf", version, "MIT", None, "shapes that print without supports")
    packages, unknown = [own], []
    versions = {**dict.fromkeys(also, "unknown"), **{d["name"]: d["version"] for d in dependencies(build)}}
    for name, found in sorted(versions.items()):
        if name in LIBRARIES:
            packages.append(package(name, found if found != "unknown" else "NOASSERTION", *LIBRARIES[name]))
        elif not is_platform(name):
            # A list that is not whole must not keep anybody from installing; tests/supply asks for "-".
            packages.append(package(name, found, "NOASSERTION", None, None))
            unknown.append(name)
    if unknown and sys.argv[3] == "-":
        sys.exit(f"sbom.py: say the licence of {', '.join(unknown)} in libsf/package/sbom.py")
    digest = hashlib.sha256(json.dumps(packages, sort_keys=True).encode()).hexdigest()[:16]
    when = datetime.datetime.fromtimestamp(int(os.environ.get("SOURCE_DATE_EPOCH", "0")),
                                           datetime.timezone.utc)
    return {
        "spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT",
        "name": "libsf-" + version,
        "documentNamespace": f"https://spdx.org/spdxdocs/libsf-{version}-{digest}",
        "creationInfo": {"created": when.strftime("%Y-%m-%dT%H:%M:%SZ"), "creators": ["Tool: libsf-sbom"]},
        "packages": packages,
        "relationships": [{"spdxElementId": "SPDXRef-DOCUMENT", "relationshipType": "DESCRIBES",
                           "relatedSpdxElement": own["SPDXID"]}] +
                         [{"spdxElementId": own["SPDXID"], "relationshipType": "DEPENDS_ON",
                           "relatedSpdxElement": p["SPDXID"]} for p in packages[1:]],
    }


if __name__ == "__main__":
    text = json.dumps(document(sys.argv[1], sys.argv[2], sys.argv[4:]), indent=2)
    if sys.argv[3] == "-":
        print(text)
    elif not os.environ.get("MESON_INSTALL_DRY_RUN"):
        folder = os.path.join(os.environ["MESON_INSTALL_DESTDIR_PREFIX"], sys.argv[3])
        os.makedirs(folder, exist_ok=True)
        with open(os.path.join(folder, "libsf.spdx.json"), "w", encoding="utf-8", newline="\n") as file:
            file.write(text + "\n")
