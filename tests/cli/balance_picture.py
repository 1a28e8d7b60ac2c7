#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
# Why: whoever is told that a model stands looks at the picture first. So pictures of shapes of which
# one knows everything are read pixel by pixel: their size, that all of the shape is seen, that
# what it stands on, where its centre of mass may lie, was and is are where they should be, in the
# proportions that they should have, and that the key covers none of it. Speaks TAP.
#
# usage: balance_picture.py    SF and SF_WRAPPER as for the scripts beside

import json
import math
import os
import pathlib
import struct
import subprocess
import sys
import tempfile
import zlib

SF = os.environ.get("SF_WRAPPER", "").split() + [os.environ["SF"]]
SHADOW, SUPPORT, SAFE = (230, 231, 233), (158, 194, 237), (143, 212, 148)
RING, DOT, STRING, INK = (230, 102, 26), (26, 31, 41), (115, 46, 153), (60, 64, 70)
WIDTH, HEIGHT = 800, 600
results = []


def ok(good, text):
    results.append(bool(good))
    print(f"{'' if good else 'not '}ok {len(results)} - {text}")


# Rows of (red, green, blue) of an 8-bit PNG.
def read_png(path):
    data, at, packed = path.read_bytes(), 8, b""
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + size]
        if kind == b"IHDR":
            width, height, depth, colour, _, _, interlace = struct.unpack(">IIBBBBB", body)
            assert (depth, colour, interlace) == (8, 2, 0)
        packed += body if kind == b"IDAT" else b""
        at += 12 + size
    raw, stride = zlib.decompress(packed), 3 * width
    rows, last = [], bytearray(stride)
    for y in range(height):
        how = raw[y * (stride + 1)]
        row = bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for i in range(stride):
            left, above = row[i - 3] if i > 2 else 0, last[i]
            corner = last[i - 3] if i > 2 else 0
            if how == 1:
                row[i] = row[i] + left & 255
            elif how == 2:
                row[i] = row[i] + above & 255
            elif how == 3:
                row[i] = row[i] + (left + above) // 2 & 255
            elif how == 4:
                ways = [(abs(above - corner), left), (abs(left - corner), above),
                        (abs(left + above - 2 * corner), corner)]
                row[i] = row[i] + min(ways, key=lambda way: way[0])[1] & 255
        rows.append([tuple(row[i:i + 3]) for i in range(0, stride, 3)])
        last = row
    return rows


def near(a, b):
    return all(abs(p - q) <= 2 for p, q in zip(a, b))


# x0, y0, x1, y1 of the pixels of colours, within a box; and how many there are.
def find(rows, colours, box):
    xs, ys = [], []
    for y in range(box[1], box[3]):
        for x in range(box[0], box[2]):
            if any(near(rows[y][x], c) for c in colours):
                xs.append(x)
                ys.append(y)
    return (min(xs), min(ys), max(xs) + 1, max(ys) + 1, len(xs)) if xs else None


# The insides of the frames, from the left: their top rows are long lines of ink.
def frames(rows):
    found = []
    for y in range(len(rows)):
        x = 0
        while x < len(rows[y]):
            end = x
            while end < len(rows[y]) and near(rows[y][end], INK):
                end += 1
            if end - x > 200:
                twin = [f for f in found if f[0] == x and f[2] == end]
                if twin:
                    twin[0][3] = y
                else:
                    found.append([x, y, end, y])
            x = end + 1
    return sorted((x0 + 1, y0 + 1, x1 - 1, y1) for x0, y0, x1, y1 in found)


def middle(box):
    return 0.5 * (box[0] + box[2]), 0.5 * (box[1] + box[3])


def box_mesh(low, high, lean=0):
    corners = [[(high if i >> d & 1 else low)[d] for d in range(3)] for i in range(8)]
    faces = "1 3 4 2", "5 6 8 7", "1 2 6 5", "3 7 8 4", "1 5 7 3", "2 4 8 6"
    return "".join(f"v {x + lean * (z > low[2])} {y} {z}\n" for x, y, z in corners) + \
        "".join(f"f {f}\n" for f in faces)


def draw(folder, mesh, *how, status=0):
    (folder / "mesh.obj").write_text(mesh)
    run = subprocess.run(SF + ["stand", folder / "mesh.obj", "--quiet", "--json", "-o", folder / "it",
                          "--pixels", f"{WIDTH},{HEIGHT}", *how],
                         stdout=subprocess.PIPE, check=False)
    ok(run.returncode == status, f"sf stand {' '.join(how)} exits with {status}")
    return json.loads(run.stdout), read_png(folder / "it.png")


# A column of 12 x 12 x 40 mm whose top lies 16 mm aside, as it is: from above 28 x 12 mm.
def leaning(folder):
    _, rows = draw(folder, box_mesh((0, 0, 0), (12, 12, 40), 16), "--no-carve", "--no-deform", status=1)
    ok(len(rows) == HEIGHT and len(rows[0]) == WIDTH, f"{len(rows[0])} x {len(rows)} pixels")
    frame = frames(rows)
    ok(len(frame) == 1, f"one plan, in a frame: {frame}")
    frame = frame[0]
    shape = find(rows, [SHADOW, SUPPORT, SAFE], frame)
    base, safe = find(rows, [SUPPORT, SAFE], frame), find(rows, [SAFE], frame)
    ok(all(shape[d] > frame[d] + 5 and shape[d + 2] < frame[d + 2] - 5 for d in (0, 1)),
       f"all of the shape is seen: {shape[:4]} in {frame}")
    scale = (shape[2] - shape[0]) / 28
    ok(abs((shape[3] - shape[1]) / 12 - scale) < 3 / 12, "as long as it is wide, where it is")
    ok(abs(base[0] - shape[0]) <= 4 and abs((base[2] - base[0]) / scale - 12) < 0.3,
       "what it stands on is 12 mm of that, and on the left")
    # A tilt of 4 degrees takes 20 mm tan(4 degrees) from each side.
    ok(abs((safe[2] - safe[0]) / scale - (12 - 40 * math.tan(math.radians(4)))) < 0.3,
       "what is safe is smaller by the height and the angle")
    x, y = (round(v) for v in middle(base))
    ok(near(rows[y][x], SAFE) and near(rows[y][base[0] + 8], SUPPORT) and
       near(rows[y][x + round(9 * scale)], SHADOW), "each has its colour")
    ring, dot = find(rows, [RING], frame), find(rows, [DOT], frame)
    ok(all(abs(middle(mark)[0] - (shape[0] + 14 * scale)) < 3 and abs(middle(mark)[1] - y) < 3
           for mark in (ring, dot)), "the centre of mass is 14 mm from the left, and was")
    ok(ring[0] < dot[0] and ring[2] > dot[2] and dot[4] > 8 and ring[4] > 16,
       "a ring and a dot at one place are both seen")
    below = find(rows, [RING], (0, frame[3], WIDTH, HEIGHT))
    ok(below is not None and find(rows, [SHADOW], (0, frame[3], WIDTH, HEIGHT)) is not None,
       "the key lies below the plan")


# Much the same, made to stand: an arrow leads from ring to dot, which lies on what is safe.
def standing(folder):
    report, rows = draw(folder, box_mesh((0, 0, 0), (12, 12, 40), 13), "--wall", "1", "--resolution", "40",
                        "--gamma", "1")
    frame = frames(rows)[0]
    base, safe = find(rows, [SUPPORT, SAFE], frame), find(rows, [SAFE], frame)
    dot, ring = find(rows, [DOT], frame), find(rows, [RING], frame)
    x, y = middle(dot)
    scale = (base[2] - base[0]) / 12
    ok(abs((x - base[0]) / scale - report["com_mm"][0]) < 0.2 and
       abs((base[3] - y) / scale - report["com_mm"][1]) < 0.2, "the dot lies where the report says")
    ok(safe[0] < x < safe[2] and safe[1] < y < safe[3], "and that is safe")
    ok(ring[0] - dot[2] < 12 and ring[2] - ring[0] > (12.5 - report["com_mm"][0]) * scale - 12,
       "an arrow goes to it from where it was")


# A foot of 4 mm below a slab of 40 mm: a second plan shows it larger; y is up, z to the right.
def small_foot(folder):
    def add(mesh, other):
        faces = [[int(i) + 8 for i in line.split()[1:]] for line in other.splitlines() if line[0] == "f"]
        return mesh + "".join(line + "\n" for line in other.splitlines() if line[0] == "v") + \
            "".join("f " + " ".join(map(str, f)) + "\n" for f in faces)
    mesh = add(box_mesh((18, 0, 8), (22, 10, 12)), box_mesh((0, 10, 0), (40, 14, 20)))
    _, rows = draw(folder, mesh, "--up", "+y", "--no-carve", "--no-deform")
    plans = frames(rows)
    ok(len(plans) == 2, f"a small foot has a plan of its own: {plans}")
    whole, part = (find(rows, [SUPPORT, SAFE], frame) for frame in plans)
    shape = find(rows, [SHADOW, SUPPORT, SAFE], plans[0])
    ok(part[2] - part[0] > 2 * (whole[2] - whole[0]), "in which it is larger")
    ok(abs((shape[3] - shape[1]) / (shape[2] - shape[0]) - 2) < 0.05,
       "x goes up and z to the right, where y is towards the eye")


# Hung from the middle of its top, 10 mm beside its centre.
def hanging(folder):
    _, rows = draw(folder, box_mesh((0, 0, 0), (40, 30, 20)), "--suspend", "30,15,20", "--no-carve",
                   "--no-deform", status=1)
    frame = frames(rows)[0]
    shape, string = find(rows, [SHADOW], frame), find(rows, [STRING], frame)
    dot = find(rows, [DOT], frame)
    scale = (shape[2] - shape[0]) / 40
    ok(abs((middle(string)[0] - shape[0]) / scale - 30) < 0.3 and
       abs((middle(string)[1] - shape[1]) / scale - 15) < 0.3, "the point that it hangs from is seen")
    ok(abs((middle(dot)[0] - shape[0]) / scale - 20) < 0.3, "and the centre of mass beside it")
    ok(find(rows, [SUPPORT], (0, 0, WIDTH, HEIGHT)) is None, "and nothing that it would stand on")
    # Carved, so that its centre comes 2 mm nearer, to within 0.2 mm: the large plan is of these.
    _, rows = draw(folder, box_mesh((0, 0, 0), (40, 30, 20)), "--suspend", "22,15,20", "--no-deform",
                   "--resolution", "40")
    plans = frames(rows)
    ok(len(plans) == 2, f"what the marks hide has a plan of its own: {plans}")
    safe, dot = find(rows, [SAFE], plans[1]), find(rows, [DOT], plans[1])
    ok(safe[2] - safe[0] > 0.4 * (plans[1][2] - plans[1][0]) and
       safe[0] - 3 < middle(dot)[0] < safe[2] + 3 and safe[1] < middle(dot)[1] < safe[3],
       "in which one sees whether it is safe")


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for case in (leaning, standing, small_foot, hanging):
            case(folder)
        for pixels in ("64,64", "90,400", "3000,80"):
            _, rows = draw(folder, box_mesh((0, 0, 0), (9, 9, 9)), "--no-carve", "--no-deform", "--pixels", pixels)
            ok(f"{len(rows[0])},{len(rows)}" == pixels and find(rows, [SAFE], (0, 0, len(rows[0]), len(rows))),
               f"a picture of {pixels} pixels")
    print(f"1..{len(results)}")
    return not all(results)


sys.exit(main())
