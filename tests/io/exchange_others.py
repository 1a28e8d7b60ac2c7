# SPDX-License-Identifier: MIT
# Why: exchange files are written by other programs, too, whose texts have any length and whose
# numbers any type; and by people who mean harm. What is not as docs/exchange.md says is refused,
# with a sentence that says where, and nothing leads out of a file: not a link, not a table whose
# numbers lie elsewhere. The files are made by h5py.
import os
import subprocess
import sys
import tempfile

try:
    import h5py
    import numpy
except ImportError:
    print("1..0 # SKIP h5py is not installed")
    sys.exit(0)

if "libhdf5" in subprocess.run([sys.argv[1], "read", os.devnull], capture_output=True, text=True).stdout:
    print("1..0 # SKIP this build has no libhdf5")
    sys.exit(0)

count = 0
OK, ARGUMENT, FORMAT, UNSUPPORTED = 0, 1, 7, 8
UUID = "408b9c0d-608a-45f0-9af1-ffeeda90d9ea"
positions = numpy.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], "f8")
tets = numpy.array([[0, 1, 2, 3]], "u4")


def write(path):
    with h5py.File(path, "w") as file:
        file.attrs["format"] = "libsf-exchange"
        file.attrs["version"] = 1
        file.attrs["length_unit"] = "mm"
        file["positions"], file["tets"] = positions, tets
        group = file.create_group(f"properties/{UUID}")
        group.attrs["name"], group.attrs["unit"] = "density", "kg m^-3"
        group.attrs["si_exponents"] = [-3, 1, 0, 0, 0, 0, 0]
        group.attrs["low"], group.attrs["high"] = 0.0, numpy.inf
        group["values"], group["index"] = numpy.array([1.0, 2, 3, 4]), tets


def judge(words, change, expected, part=""):
    global count
    count += 1
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "other.h5")
        write(path)
        elsewhere = os.path.join(folder, "elsewhere.h5")
        write(elsewhere)
        with open(os.path.join(folder, "numbers"), "wb") as raw:
            raw.write(positions.tobytes())
        with h5py.File(path, "r+") as file:
            change(file, folder)
        told = subprocess.run([sys.argv[1], "read", path], capture_output=True, text=True, timeout=60)
    good = told.returncode == 0 and told.stdout.startswith(f"{expected} ") and part in told.stdout
    print(f"{'ok' if good else 'not ok'} {count} - {words}")
    if not good:
        print(f"# {told.returncode}: {told.stdout} {told.stderr}")


def replace(name, make):
    def change(file, folder):
        del file[name]
        made = make(file, folder)
        if made is not None:
            file[name] = made
    return change


def attribute(place, name, value):
    def change(file, folder):
        file[place].attrs[name] = value
    return change


def no_attribute(place, name):
    def change(file, folder):
        del file[place].attrs[name]
    return change


def external(file, folder):
    file.create_dataset("positions", (4, 3), "f8", external=[(os.path.join(folder, "numbers"), 0, 96)])


def virtual(file, folder):
    layout = h5py.VirtualLayout((4, 3), "f8")
    layout[:] = h5py.VirtualSource(os.path.join(folder, "elsewhere.h5"), "positions", (4, 3))
    file.create_virtual_dataset("positions", layout)


def link_away(name):
    return lambda file, folder: h5py.ExternalLink(os.path.join(folder, "elsewhere.h5"), name)


def nothing(file, folder):
    pass


def extra(file, folder):
    file["more/of/it"] = numpy.arange(5)
    file["properties"].attrs["remark"] = "made by hand"


def many_points(file, folder):
    file.create_dataset("positions", (1 << 30, 3), "f8", chunks=(1024, 3), compression="gzip")


compound = numpy.zeros(4, [("x", "f8"), ("y", "f8"), ("z", "f8")])
group = f"properties/{UUID}"
judge("texts of any length", nothing, OK, "1 tetrahedra, 1 properties")
judge("what is there beside the layout is passed over", extra, OK)
judge("texts of a fixed length", attribute("/", "format", numpy.bytes_("libsf-exchange")), OK)
judge("another format", attribute("/", "format", "something"), FORMAT, "the file")
judge("a format without a value", attribute("/", "format", h5py.Empty("S10")), FORMAT)
judge("two formats", attribute("/", "format", ["libsf-exchange", "x"]), FORMAT)
judge("a format that is a number", attribute("/", "format", 1), FORMAT)
judge("another version", attribute("/", "version", 2), UNSUPPORTED)
judge("a version that is text", attribute("/", "version", "1"), UNSUPPORTED)
judge("another unit", attribute("/", "length_unit", "inch"), UNSUPPORTED)
judge("a name that is too long", attribute(group, "name", "n" * 48), FORMAT, UUID)
judge("an empty name", attribute(group, "name", ""), ARGUMENT, "name")
judge("no name", no_attribute(group, "name"), FORMAT, UUID)
judge("six exponents", attribute(group, "si_exponents", [0] * 6), FORMAT)
judge("a bound that is no number", attribute(group, "low", numpy.nan), ARGUMENT)
judge("a bound that is text", attribute(group, "low", "0"), FORMAT)
judge("a value below", attribute(group, "low", 2.0), ARGUMENT, "value 0")
judge("no positions", replace("positions", nothing), FORMAT, "/positions")
judge("a group in place of a table", replace("positions", lambda f, _: f.create_group("positions") and None), FORMAT)
judge("positions of 32 bits", replace("positions", lambda *_: positions.astype("f4")), FORMAT, "/positions")
judge("positions that are whole", replace("positions", lambda *_: positions.astype("i8")), FORMAT)
judge("positions from the other end", replace("positions", lambda *_: positions.astype(">f8")), OK)
judge("two coordinates", replace("positions", lambda *_: positions[:, :2]), FORMAT)
judge("coordinates in one list", replace("positions", lambda *_: positions.ravel()), FORMAT)
judge("no points", replace("positions", lambda *_: positions[:0]), FORMAT)
judge("no number at all", replace("positions", lambda *_: positions * numpy.nan), ARGUMENT, "point 0")
judge("compounds", replace("positions", lambda *_: compound), FORMAT)
judge("texts", replace("tets", lambda f, _: f.create_dataset("tets", (1, 4), h5py.string_dtype()) and None), FORMAT)
judge("lists of lists", replace("tets", lambda f, _: f.create_dataset("tets", (1, 4), h5py.vlen_dtype("u4")) and None),
      FORMAT)
judge("references", replace("tets", lambda f, _: f.create_dataset("tets", (1, 4), h5py.ref_dtype) and None), FORMAT)
judge("signed corners", replace("tets", lambda *_: tets.astype("i4")), FORMAT, "/tets")
judge("corners of 64 bits", replace("tets", lambda *_: tets.astype("u8")), FORMAT)
judge("a point that there is not", replace("tets", lambda *_: tets + 1), ARGUMENT, "point 4")
judge("too few rows of values", replace(f"{group}/index", lambda *_: numpy.zeros((2, 4), "u4")), FORMAT, "index")
judge("a value that there is not", replace(f"{group}/index", lambda *_: tets + 1), ARGUMENT, "value 4")
judge("a property that is a table", replace(group, lambda *_: positions), FORMAT, "/properties")
judge("a property without a UUID", lambda f, _: f.move(group, "properties/density") and None, FORMAT, "/properties")
judge("more points than the file holds", replace("positions", many_points), FORMAT, "/positions")
judge("numbers in another file", replace("positions", external), FORMAT, "another file")
judge("a table of tables in other files", replace("positions", virtual), FORMAT, "another file")
judge("a link to another file", replace("positions", link_away("/positions")), FORMAT, "/positions")
judge("a link to another file's properties", replace("properties", link_away("/properties")), FORMAT, "/properties")
judge("a property in another file", replace(group, link_away(f"/{group}")), FORMAT, "/properties")
judge("a link in a circle", replace("positions", lambda *_: h5py.SoftLink("/positions")), FORMAT, "/positions")
judge("a link to another place", replace(f"{group}/index", lambda *_: h5py.SoftLink("/tets")), FORMAT, "index")
print(f"1..{count}")
