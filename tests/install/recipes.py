# Why: a port for vcpkg and a recipe for Conan are lists of what meson.build already says: the version,
# the options, what is installed. A program of neither kind is asked for here, so that they are held
# against the tree wherever it is tested: the port is run by CMake with stand-ins for vcpkg's functions,
# of which the configuring one calls meson with the options that the port gave it.
#
# usage: recipes.py SOURCE VERSION MESON [CMAKE]; speaks TAP.

import ast
import json
import os
import re
import subprocess
import sys
import tempfile

SOURCE, VERSION, MESON = sys.argv[1:4]
CMAKE = sys.argv[4] if len(sys.argv) > 4 else None
PACKAGE = os.path.join(SOURCE, "libsf", "package")

STAND_INS = """
cmake_minimum_required(VERSION 3.20)
function(vcpkg_configure_meson)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "SOURCE_PATH" "OPTIONS")
  if(arg_UNPARSED_ARGUMENTS OR NOT EXISTS "${arg_SOURCE_PATH}/meson.build")
    message(FATAL_ERROR "vcpkg_configure_meson: ${arg_SOURCE_PATH}, ${arg_UNPARSED_ARGUMENTS}")
  endif()
  execute_process(COMMAND "${MESON}" setup "${FOLDER}/${BUILD}" "${arg_SOURCE_PATH}" --prefix=/p --libdir=lib
    --default-library=static ${arg_OPTIONS} RESULT_VARIABLE failed OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(failed)
    message(FATAL_ERROR "${said}")
  endif()
endfunction()
function(vcpkg_install_copyright)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "" "FILE_LIST")
  foreach(file IN LISTS arg_FILE_LIST)
    if(NOT EXISTS "${file}")
      message(FATAL_ERROR "${file} is not there")
    endif()
  endforeach()
endfunction()
foreach(name vcpkg_install_meson vcpkg_copy_pdbs vcpkg_fixup_pkgconfig)
  cmake_language(EVAL CODE "function(${name})\\nendfunction()")
endforeach()
set(CURRENT_PACKAGES_DIR "${FOLDER}/packages")
include("${PORT}/portfile.cmake")
"""


def read(*path):
    with open(os.path.join(SOURCE, *path), encoding="utf-8") as file:
        return file.read()


def meson_options():
    return set(re.findall(r"^option\('(\w+)'", read("meson_options.txt"), re.M)) | {"auto_features"}


def port():
    return json.loads(read("libsf", "package", "vcpkg", "libsf", "vcpkg.json"))


def check_port_manifest():
    """The port's manifest has the version of the project, and its features are sorted and known."""
    manifest = port()
    bad = [] if manifest["version-semver"] == VERSION else [f"version {manifest['version-semver']}"]
    bad += [] if manifest["license"] == "MIT" and manifest["name"] == "libsf" else ["name or licence"]
    names = list(manifest["features"])
    bad += [] if names == sorted(names) else ["features are not sorted, as vcpkg format-manifest has them"]
    portfile = read("libsf", "package", "vcpkg", "libsf", "portfile.cmake")
    bad += [f"the port never asks for feature {n}" for n in names if f'"{n}" IN_LIST FEATURES' not in portfile]
    bad += [f"{n} is no feature" for n in re.findall(r'"(\w+)" IN_LIST FEATURES', portfile) if n not in names]
    return bad + [f"{o} is no option of meson's" for o in re.findall(r"-D(\w+)=", portfile)
                  if o not in meson_options()]


def check_port_runs():
    """The port, run by CMake, configures; what meson would install is the libraries and their files."""
    if CMAKE is None:
        return "skip: cmake is not installed"
    bad = []
    with tempfile.TemporaryDirectory() as folder:
        script = os.path.join(folder, "run.cmake")
        with open(script, "w", encoding="utf-8") as file:
            file.write(STAND_INS)
        run = subprocess.run(
            [CMAKE, f"-DMESON={MESON}", f"-DFOLDER={folder}", "-DBUILD=plain", "-DFEATURES=",
             f"-DPORT={os.path.join(PACKAGE, 'vcpkg', 'libsf')}", "-P", script], capture_output=True, text=True)
        if run.returncode != 0:
            return (run.stdout + run.stderr).splitlines()[-20:]
        plan = json.loads(subprocess.run([MESON, "introspect", "--install-plan", os.path.join(folder, "plain")],
                                         capture_output=True, text=True, check=True).stdout)
    names = {os.path.basename(path) for kind in plan.values() for path in kind}
    bad += [f"{n} would not be installed" for n in
            ["libsf.a", "libsf-io.a", "sf.h", "io.h", "libsf.pc", "libsf-io.pc", "libsfConfig.cmake"] if n not in names]
    return bad + [f"{n} would be installed" for n in ["sf", "sculpt", "libsf.so"] if n in names]


def check_conan_recipe():
    """The recipe for Conan is Python, takes meson's options, and exports folders and files that are there."""
    text = read("libsf", "package", "conan", "conanfile.py")
    ast.parse(text)
    bad = []
    block = re.search(r"project_options\.update\(\{(.*?)\}\)", text, re.S).group(1)
    bad += [f"{o} is no option of meson's" for o in re.findall(r'"(\w+)":', block) if o not in meson_options()]
    exported = re.search(r"for pattern in \((.*?)\):", text, re.S).group(1)
    bad += [f"{p} is not there" for p in re.findall(r'"([^"]+)"', exported)
            if not os.path.exists(os.path.join(SOURCE, p.removesuffix("/*")))]
    # The line that the recipe takes the version from.
    found = read("meson.build").split("version: '", 1)[1].split("'", 1)[0]
    return bad + ([] if found == VERSION else [f"the recipe reads version {found}"])


def main():
    checks = [check_port_manifest, check_port_runs, check_conan_recipe]
    failures = 0
    print(f"1..{len(checks)}")
    for number, check in enumerate(checks, 1):
        bad = check()
        if isinstance(bad, str):
            print(f"ok {number} - {check.__doc__} # SKIP {bad.removeprefix('skip: ')}")
            continue
        failures += bool(bad)
        print(f"{'not ok' if bad else 'ok'} {number} - {check.__doc__}")
        for line in bad:
            print(f"#   {line}")
    sys.exit(failures > 0)


main()
