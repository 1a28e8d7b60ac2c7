# Why: a check that finds nothing may be one that looks for nothing, and the pattern of one could never
# match. So house.py is run on a tiny project that keeps every rule, where it must be content, and then
# on that project with one thing spoilt at a time, where the check whose rule is broken must say so.
# A check without a spoiler fails this test.
#
# usage: bites.py HOUSE.PY FORMAT-FILE; speaks TAP.

import os
import re
import shutil
import subprocess
import sys
import tempfile

HOUSE, FORMAT = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])

HEADER = """// SPDX-License-Identifier: MIT
// The whole interface of a tiny project.

#ifndef SF_BASE_H
#define SF_BASE_H

#define SF_VERSION_MAJOR 1
#define SF_VERSION_MINOR 2
#define SF_VERSION_PATCH 3
#define SF_VERSION_STRING "1.2.3"

typedef enum sf_status { SF_OK = 0, SF_ERR_MEMORY = 1 } sf_status;

/**
 * Do it.
 *
 * @return SF_OK; SF_ERR_MEMORY.
 * @cost constant.   @threads any.   @since 1.2
 */
SF_API sf_status sf_do(int times);

#endif
"""

SOURCE = """// SPDX-License-Identifier: MIT
// All that the tiny project does.

#include <sf/base.h>

sf_status sf_do(int times)
{
    return times > 3 ? SF_ERR_MEMORY : SF_OK;
}
"""

TREE = {
    "libsf/include/sf/base.h": HEADER,
    "libsf/base/do.c": SOURCE,
    "libsf/base/meson.build": "sources += files('do.c')\n",
    "libsf/package/libsfConfig.cmake.in": "sf_place_(do::do do)\n",
    "fuzz/calls.py": "# Nothing is called.\n",
    "fuzz/shapes.txt": "# Nothing is said.\n",
    "fuzz/world.h": "// SPDX-License-Identifier: MIT\n// What fuzz targets share.\n\n#ifndef SF_FUZZ_WORLD_H\n"
                    "#define SF_FUZZ_WORLD_H\n\n#endif\n",
    "libsf/include/meson.build": "sf_header_names = ['base']\n",
    "CITATION.cff": "version: 1.2.3\n",
    "CHANGELOG.md": "# Changelog\n\n## [1.2.3] - today\n",
    "README.md": "| `do` | Does it. |\n\n## Where\n\n| `libsf` | one room: `base` |\n",
    "demo/sf/verbs.c": "// SPDX-License-Identifier: MIT\n// The verb of the tiny project.\n\n"
                      "static const verb verbs[] = {\n    {{\"do\", \"Does it.\"}},\n};\n",
    "demo/sf/meson.build": "sources += files('verbs.c')\n",
    # Stand-ins for nm and for what it looks into.
    "nm": "#!/bin/sh\ncat \"$2\"\n",
    "libsf.so": "00 T sf_do\n         U malloc\n",
}

DO, BASE = "libsf/base/do.c", "libsf/include/sf/base.h"


def after_head(lines):
    """The source with lines after its includes."""
    return SOURCE.replace("base.h>\n", "base.h>\n\n" + lines)


def in_body(line):
    return SOURCE.replace("    return", f"    {line}\n    return")


# What to spoil (files and their new texts), and a word of the sentence of the check that must bite.
SPOILT = [
    ("export what", "libsf.so", TREE["libsf.so"] + "00 T sf_more\n"),
    ("export what", "libsf.so", "         U malloc\n"),
    ("asks of the C library", "libsf.so", TREE["libsf.so"] + "         U printf\n"),
    ("says what it does", BASE, HEADER.replace("Do it.", "do it")),
    ("says what it does", BASE, HEADER.replace("@cost constant.", "")),
    ("says what it does", BASE, HEADER.replace("SF_OK; SF_ERR_MEMORY", "nothing much")),
    ("says what it does", BASE, HEADER.replace("@return", "@param no  none\n * @return")),
    ("says what it does", BASE, HEADER.replace("/**", "/*")),
    ("code that is written", DO, SOURCE.replace("ERR_MEMORY", "ERR_MEMROY")),
    ("@return names", BASE, HEADER.replace("; SF_ERR_MEMORY.", ".")),
    ("@return names", DO, after_head("static int more(void)\n{\n    return SF_ERR_MORE;\n}\n")
     .replace("? SF_ERR_MEMORY", "? more()")),
    ("one file alone", DO, after_head("int sfi_more(void)\n{\n    return 1;\n}\n")
     .replace("times > 3", "times > sfi_more()")),
    ("one file alone", DO, after_head("static int sfi_more(void)\n{\n    return 1;\n}\n")
     .replace("times > 3", "times > sfi_more()")),
    ("one file alone", "libsf/base/more.h", "int sfi_do(void);\n", DO,
     after_head("int sfi_do(void)\n{\n    return 1;\n}\n")),
    ("longer than 500", DO, SOURCE + "// more\n" * 500),
    ("longer than 60", DO, SOURCE.replace("    return", "    times++;\n" * 60 + "    return")),
    ("opens with its licence", DO, SOURCE.replace("SPDX", "SPXD")),
    ("opens with its licence", DO, SOURCE.replace("// All that the tiny project does.\n", "")),
    ("guarded by its own", BASE, HEADER.replace("SF_BASE_H", "SF_BASIS_H")),
    ("no tabs", DO, SOURCE.replace("    return", "\treturn")),
    ("no tabs", DO, SOURCE.replace(";\n", "; \n")),
    ("no tabs", DO, SOURCE.replace("\n", "\r\n")),
    ("no tabs", DO, after_head("// " + "long " * 20 + "\n")),
    ("no tabs", DO, after_head("// TO" + "DO: all of it\n")),
    ("no tabs", DO, after_head("// see /ho" + "me/me\n")),
    ("drawer", "libsf/base/util.c", SOURCE),
    ("128-bit", DO, in_body("__int128 x = 0;")),
    ("128-bit", DO, in_body("unsigned __int128 x = 0;")),
    ("128-bit", DO, in_body("long double d = 0;")),
    ("128-bit", DO, in_body("goto out;")),
    ("128-bit", DO, in_body("times = (int)pow(times, 2);")),
    ("128-bit", DO, in_body("void *p = alloca(7);")),
    ("clang-format", DO, SOURCE.replace("times > 3", "times>3")),
    ("lower floors", DO, SOURCE.replace("<sf/base.h>", "<sf/voxel.h>")),
    ("lower floors", DO, SOURCE.replace("<sf/base.h>", '"io/save.h"')),
    ("lower floors", "libsf/nowhere/do.c", SOURCE),
    ("source is built", "libsf/base/meson.build", "sources += files()\n"),
    ("source is built", "libsf/base/meson.build", "sources += files('do.c', 'gone.c')\n"),
    ("source is built", "libsf/include/meson.build", "sf_header_names = []\n"),
    ("README names", "README.md", TREE["README.md"] + "\nSee [the guide](docs/guide.md).\n"),
    ("README names", "README.md", TREE["README.md"] + "\nSee `libsf/gone.c`.\n"),
    ("README names", "README.md", TREE["README.md"] + "\nLink `libdo::do`.\n"),
    ("README names", "README.md", TREE["README.md"].replace("base", "cellar")),
    ("README names", "README.md", TREE["README.md"].replace("Does", "Undoes")),
    ("one version", BASE, HEADER.replace("MINOR 2", "MINOR 3")),
    ("one version", BASE, HEADER.replace("@since 1.2", "@since 1.3")),
    ("one version", BASE, HEADER.replace("@since 1.2", "@since 1.2.4")),
    ("one version", "CITATION.cff", "version: 1.2.4\n"),
    ("one version", "CHANGELOG.md", "# Changelog\n\n## [1.2.2] - today\n"),
]


def judge(tree):
    """What house.py says of a tree: the sentences of its checks, each with ok, not ok or skip."""
    with tempfile.TemporaryDirectory() as folder:
        for name, text in tree.items():
            path = os.path.join(folder, name)
            os.makedirs(os.path.dirname(path), exist_ok=True)
            with open(path, "w", encoding="utf-8", newline="") as file:
                file.write(text)
        shutil.copy(FORMAT, os.path.join(folder, ".clang-format"))
        nm = os.path.join(folder, "nm")
        os.chmod(nm, 0o755)
        run = subprocess.run([sys.executable, HOUSE, folder, "1.2.3", nm,
                              os.path.join(folder, "libsf.so")], capture_output=True, text=True)
    found = {}
    for verdict, sentence in re.findall(r"^(ok|not ok) \d+ - (.*)$", run.stdout, re.M):
        sentence, _, skipped = sentence.partition(" # SKIP")
        found[sentence] = "skip" if skipped else verdict
    if f"1..{len(found)}" not in run.stdout.splitlines():
        found = {}  # it stumbled, and what follows was never looked at
    return found, run.stdout + run.stderr


def main():
    number, failures = 0, 0

    def tell(good, what, output):
        nonlocal number, failures
        number += 1
        failures += not good
        print(f"{'ok' if good else 'not ok'} {number} - {what}")
        if not good:
            print("".join(f"# {line}\n" for line in output.splitlines()), end="")

    clean, output = judge(TREE)
    tell(clean and "not ok" not in clean.values(), "a project that keeps the rules passes", output)
    for sentence in clean:
        tell(any(word in sentence for word, *_ in SPOILT), f"there is a spoiler for: {sentence}", "")
    for word, name, text, *more in SPOILT:
        found, output = judge({**TREE, name: text, **dict(zip(more[::2], more[1::2]))})
        verdicts = [v for sentence, v in found.items() if word in sentence]
        bites = verdicts == ["not ok"] or (verdicts == ["skip"] and word == "clang-format")
        tell(bites and text != TREE.get(name), f"bites: {word}, {name}", output)
    print(f"1..{number}")
    return failures > 0


sys.exit(main())
