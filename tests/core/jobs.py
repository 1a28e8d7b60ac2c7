# Jobs for the example firmware: small ones made by chance, the worst that a row can be, and the
# slicers' files of SF_DATA, read here by other code than the library's wherever that is easy.

import json
import os
import random
import struct
import subprocess
import zipfile


def number(value):
    out = bytearray()
    while value > 127:
        out.append(value & 127 | 128)
        value >>= 7
    out.append(value)
    return bytes(out)


def write(path, width, height, layers):
    """layers: for each layer, for each row, a list of (x0, x1)."""
    out = [b"SFJOB1\n", number(width), number(height), number(len(layers))]
    for layer in layers:
        for row in layer:
            out.append(number(len(row)))
            x = 0
            for x0, x1 in row:
                out += [number(x0 - x), number(x1 - x0)]
                x = x1
    with open(path, "wb") as file:
        file.write(b"".join(out))
    return path


def runs(bits, width):
    """Runs of a row that is an integer, voxel x its bit x."""
    found, x = [], 0
    while bits >> x:
        x += ((bits >> x) & -(bits >> x)).bit_length() - 1
        end = x
        rest = ~(bits >> x)
        end += (rest & -rest).bit_length() - 1
        found.append((x, end))
        x = end
    return found


def chance(path, seed, width=200, height=90, layers=14):
    """Blobs that wander and grow, with crumbs in the air."""
    dice = random.Random(seed)
    full = (1 << width) - 1
    rows = [0] * height
    stack = [[0] * height]
    for _ in range(6):
        x, y, w, h = (dice.randrange(width), dice.randrange(height), dice.randrange(5, 60),
                      dice.randrange(3, 30))
        for i in range(y, min(height, y + h)):
            rows[i] |= ((1 << w) - 1) << x & full
    for _ in range(layers - 1):
        stack.append(list(rows))
        grown = list(rows)
        for y in range(height):
            r = rows[y]
            if dice.random() < 0.5:
                grown[y] |= (r << 1 | r >> 1) & full
            if dice.random() < 0.2:
                grown[y] |= rows[max(0, y - 1)]
            if dice.random() < 0.02:
                grown[y] |= 7 << dice.randrange(width) & full
            if dice.random() < 0.3:
                grown[y] &= ~(1 << dice.randrange(width))
        rows = grown
    return write(path, width, height, [[runs(r, width) for r in layer] for layer in stack])


def combs(path, width, height):
    """Rows of single voxels, as many as there can be; in the second layer nothing carries them, but
    for the first two rows."""
    comb = [(x, x + 1) for x in range(0, width, 2)]
    return write(path, width, height, [[comb] + [[]] * (height - 1), [comb] * height])


def all_runs(path, run_count):
    """All the runs that a layer may have: in one row, and below it in the three that it looks at."""
    width, third = 4 * run_count, run_count // 3
    below = [(x, x + 1) for x in range(0, 12 * third, 12)]
    above = [(x + 2, x + 3) for x in range(0, 4 * run_count, 4)]
    return write(path, width, 3, [[below] * 3, [[], above, []]])


def sl1(path, archive, folder, pack):
    """A job of an SL1 file: its pictures become a stack, which sf-chip packs."""
    os.makedirs(folder)
    with zipfile.ZipFile(archive) as file:
        names = sorted(n for n in file.namelist() if n.endswith(".png"))
        for k, name in enumerate(names):
            data = file.read(name)
            size = struct.unpack(">II", data[16:24])
            with open(os.path.join(folder, f"layer_{k:05d}.png"), "wb") as out:
                out.write(data)
    about = {"format": "libsf-stack", "version": 1, "units": "mm",
             "lattice": {"nx": size[0], "ny": size[1], "nz": len(names), "pitch_mm": [0.05, 0.05],
                         "layer_mm": 0.05, "origin_mm": [0, 0, 0]},
             "rule": None, "layers": {"pattern": "layer_%05u.png", "count": len(names)},
             "solid": "white", "row_order": "top_is_max_y"}
    with open(os.path.join(folder, "stack.json"), "w", encoding="utf-8") as out:
        json.dump(about, out)
    run = subprocess.run([pack, "pack", folder, path], capture_output=True, text=True)
    return path if run.returncode == 0 else None


def photon(path, source):
    """A job of a .photon file, whose layers are runs already."""
    with open(source, "rb") as file:
        data = file.read()
    width, height = struct.unpack_from("<II", data, 0x34)
    table, count = struct.unpack_from("<II", data, 0x40)
    layers = []
    for k in range(count):
        address, size = struct.unpack_from("<II", data, table + 36 * k + 12)
        rows, at = [[] for _ in range(height)], 0
        for byte in data[address:address + size]:
            length, is_solid = byte & 127, byte >> 7
            while length > 0:
                y, x = divmod(at, width)
                part = min(length, width - x)
                if is_solid and rows[y] and rows[y][-1][1] == x:
                    rows[y][-1] = (rows[y][-1][0], x + part)
                elif is_solid:
                    rows[y].append((x, x + part))
                at += part
                length -= part
        layers.append(rows)
    return write(path, width, height, layers)
