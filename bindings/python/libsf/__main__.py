"""`python -m libsf` is the command line program sf."""

import os
import sys

from ._sf import ffi, lib


def main() -> int:
    words = [ffi.new("char[]", os.fsencode(w)) for w in ["sf", *sys.argv[1:]]]
    line = ffi.new("char *[]", [*words, ffi.NULL])
    sys.stdout.flush()
    return int(lib.sf_cli_main(len(words), line))


if __name__ == "__main__":
    sys.exit(main())
