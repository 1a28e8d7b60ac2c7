# Why: the spectrum of what is printed, measured on the pictures themselves by a program that shares
# nothing with the library: PGM, PBM, or PNG of a byte or a bit a voxel (grey or palette), read with
# zlib alone.
#
# S(k) is the mean over layers of |FFT2(B - mean of the layer)|^2 / (count t (1 - t)), B the voxels of
# one material, t its tone over all layers; white noise has 1. Printed, for each material asked for:
#
#   tone       voxels of the material in all of them
#   low        mean of S over 0 < |k| <= 0.125 cycles per voxel
#   half x, y  where S, in a wedge of 30 degrees around the axis, first comes up to one half, in cycles
#              per mm; the mean of S in rings that overlap, a line between their middles
#
# usage: spectrum.py FOLDER [--pitch PX,PY] [--from X,Y,LAYER] [--size NX,NY,NZ] MATERIAL...
#        materials are numbers as in the pictures; --from, --size: how much of the layers, from which
#        pixel and layer on; sides along x and y are powers of 2

import cmath
import math
import os
import re
import struct
import sys
import zlib


def read_netpbm(data):
    head = re.match(rb"(P[45])\s+(?:#[^\n]*\n\s*)*(\d+)\s+(\d+)\s+(?:(\d+)\s)?", data)
    width, height = int(head.group(2)), int(head.group(3))
    body = data[head.end():]
    if head.group(1) == b"P5":
        return [list(body[y * width:(y + 1) * width]) for y in range(height)]
    stride = (width + 7) // 8
    return [[body[y * stride + x // 8] >> (7 - x % 8) & 1 for x in range(width)] for y in range(height)]


def unfilter(kind, line, above, step):
    for i in range(len(line)):
        a = line[i - step] if i >= step else 0
        b = above[i]
        c = above[i - step] if i >= step else 0
        if kind == 1:
            add = a
        elif kind == 2:
            add = b
        elif kind == 3:
            add = (a + b) // 2
        else:
            p = a + b - c
            add = min((abs(p - v), n, v) for n, v in enumerate((a, b, c)))[2]
        line[i] = (line[i] + add) & 255
    return line


def read_png(data):
    at, packed, width, height, depth = 8, b"", 0, 0, 0
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        chunk = data[at + 8:at + 8 + size]
        if kind == b"IHDR":
            width, height, depth, colour = struct.unpack(">IIBB", chunk[:10])
            if colour not in (0, 3) or chunk[12] != 0:
                sys.exit("spectrum.py: only grey and palette PNGs that are not interlaced")
        elif kind == b"IDAT":
            packed += chunk
        at += 12 + size
    raw, stride = zlib.decompress(packed), (width * depth + 7) // 8
    rows, above = [], bytes(stride)
    for y in range(height):
        start = y * (stride + 1)
        line = bytearray(raw[start + 1:start + 1 + stride])
        above = unfilter(raw[start], line, above, 1) if raw[start] else line
        per = 8 // depth
        rows.append([above[x // per] >> (8 - depth) - x % per * depth & (1 << depth) - 1
                     for x in range(width)])
    return rows


def read_layers(folder):
    names = sorted(n for n in os.listdir(folder) if n.endswith((".pgm", ".pbm", ".png")))
    layers = []
    for name in names:
        with open(os.path.join(folder, name), "rb") as file:
            data = file.read()
        layers.append(read_png(data) if name.endswith(".png") else read_netpbm(data))
    return layers


def fft(values):
    n = len(values)
    if n == 1:
        return values
    even, odd = fft(values[0::2]), fft(values[1::2])
    turned = [cmath.exp(-2j * math.pi * k / n) * odd[k] for k in range(n // 2)]
    return ([even[k] + turned[k] for k in range(n // 2)] +
            [even[k] - turned[k] for k in range(n // 2)])


def power(plane):
    rows = [fft([complex(v) for v in row]) for row in plane]
    columns = [fft([row[x] for row in rows]) for x in range(len(rows[0]))]
    return [[abs(columns[x][y]) ** 2 for x in range(len(columns))] for y in range(len(rows))]


def spectrum(layers, material):
    height, width = len(layers[0]), len(layers[0][0])
    count = height * width
    total = sum(v == material for layer in layers for row in layer for v in row)
    tone = total / (count * len(layers))
    sums = [[0.0] * width for _ in range(height)]
    if total in (0, count * len(layers)):
        return total, tone, sums
    for layer in layers:
        bits = [[v == material for v in row] for row in layer]
        mean = sum(map(sum, bits)) / count
        for y, row in enumerate(power([[b - mean for b in row] for row in bits])):
            for x, v in enumerate(row):
                sums[y][x] += v / (len(layers) * count * tone * (1 - tone))
    return total, tone, sums


def signed(i, n):
    return i / n if i <= n // 2 else i / n - 1


def low(s):
    height, width = len(s), len(s[0])
    found = [s[y][x] for y in range(height) for x in range(width)
             if 0 < math.hypot(signed(x, width), signed(y, height)) <= 0.125]
    return sum(found) / len(found)


def half(s, pitch, axis):
    height, width = len(s), len(s[0])
    points = []
    for y in range(height):
        for x in range(width):
            f = (signed(x, width) / pitch[0], signed(y, height) / pitch[1])
            r = math.hypot(*f)
            if r > 0 and abs(f[axis]) >= r * math.cos(math.radians(15)):
                points.append((r, s[y][x]))
    # Rings as wide as the coarser step of frequency, four to a width.
    ring = max(1 / (width * pitch[0]), 1 / (height * pitch[1]))
    before, middle = None, ring
    while middle < max(r for r, _ in points):
        inside = [(r, v) for r, v in points if abs(r - middle) <= ring / 2]
        if inside:
            here = (sum(r for r, _ in inside) / len(inside), sum(v for _, v in inside) / len(inside))
            if before is not None and before[1] < 0.5 <= here[1]:
                return before[0] + (0.5 - before[1]) * (here[0] - before[0]) / (here[1] - before[1])
            before = here
        middle += ring / 4
    return math.nan


def main():
    arguments, pitch, start, size = [], (1.0, 1.0), (0, 0, 0), None
    words = iter(sys.argv[1:])
    for word in words:
        if word == "--pitch":
            pitch = tuple(float(v) for v in next(words).split(",")[:2])
        elif word == "--from":
            start = [int(v) for v in next(words).split(",")]
        elif word == "--size":
            size = [int(v) for v in next(words).split(",")]
        else:
            arguments.append(word)
    layers = read_layers(arguments[0])
    if size:
        x, y, k = start
        layers = [[row[x:x + size[0]] for row in layer[y:y + size[1]]] for layer in layers[k:k + size[2]]]
    for material in map(int, arguments[1:]):
        total, tone, s = spectrum(layers, material)
        print(f"material {material} voxels {total} tone {tone:.6f} low {low(s):.4f} "
              f"half x {half(s, pitch, 0):.4f} y {half(s, pitch, 1):.4f}")


main()
