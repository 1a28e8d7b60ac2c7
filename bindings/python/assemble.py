# Puts the package together in a build folder, so that it can be imported from there.
#
# usage: assemble.py FOLDER BUILD FILE...   BUILD holds the module and what generate.py has made

import os
import shutil
import sys

folder, build = sys.argv[1:3]
shutil.rmtree(folder, ignore_errors=True)
os.makedirs(folder)
for path in sys.argv[3:]:
    shutil.copy(path, folder)
for name in os.listdir(build):
    if name in ("_types.py", "_docs.py") or (name.startswith("_sf.") and not name.endswith((".c", ".p"))):
        os.symlink(os.path.join(build, name), os.path.join(folder, name))
