# Golden vectors: small shapes and what is true of them, by sets of places, loops and fractions. C,
# Python and Rust are held against the same files. This shares no code with any of them.
#
# box3: what the papers' rule makes of small grids. A string of 0 and 1 is a grid in (layer, y, x) order. `trimmed` is the largest support-free part,
# `unsupported` what nothing carries, each voxel by itself, `bounds` x0 y0 z0 x1 y1 z1 of the shape,
# its high ends without. The bed is layer 0.
#
# tetrahedra: bodies on a triangle in the plane z = 0, corners in whole mm. The integrals are those of
# the corners in closed form, in fractions, and rounded once. `margin_rad` is the least angle by which
# the ground may tilt about an edge of the base; below 0 it falls as it is.
#
# usage: make.py box3 >box3.json; make.py tetrahedra >tetrahedra.json

import json
import math
import random
import sys
from fractions import Fraction

SIZES = [(1, 1, 1), (1, 1, 9), (7, 1, 3), (3, 4, 5), (9, 8, 4), (64, 2, 3), (65, 3, 4), (130, 2, 3), (5, 6, 7)]


def carried(place, below):
    x, y, z = place
    return z == 0 or any((x + i, y + j, z - 1) in below for i in (-1, 0, 1) for j in (-1, 0, 1))


def text(places, size):
    nx, ny, nz = size
    return "".join("1" if (x, y, z) in places else "0" for z in range(nz) for y in range(ny) for x in range(nx))


def case(size, share, rng):
    nx, ny, nz = size
    shape = {(x, y, z) for z in range(nz) for y in range(ny) for x in range(nx) if rng.random() < share}
    kept = set()
    for z in range(nz):
        kept |= {p for p in shape if p[2] == z and carried(p, kept)}
    bounds = [0] * 6
    if shape:
        bounds = [min(p[i] for p in shape) for i in range(3)] + [max(p[i] for p in shape) + 1 for i in range(3)]
    return {"size": size, "voxels": text(shape, size), "count": len(shape), "bounds": bounds,
            "trimmed": text(kept, size), "kept": len(kept),
            "unsupported": text({p for p in shape if not carried(p, shape)}, size)}


def box3():
    rng = random.Random(2016)
    return [case(size, share, rng) for size in SIZES for share in (0.0, 0.1, 0.3, 0.6, 1.0)]


def standing(base, com):
    """The least tilt about an edge of a triangle that goes around counter-clockwise."""
    tilts = []
    for a, b in zip(base, base[1:] + base[:1]):
        cross = (b[0] - a[0]) * (com[1] - a[1]) - (b[1] - a[1]) * (com[0] - a[0])
        tilts.append(math.atan2(cross / math.hypot(b[0] - a[0], b[1] - a[1]), com[2]))
    return min(tilts)


def tetrahedron(rng):
    a, b, c, top = [[rng.randint(-9, 9), rng.randint(-9, 9), 0] for _ in range(4)]
    top[2] = rng.randint(1, 12)
    turn = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    if turn == 0:
        return None
    base = [a, b, c] if turn > 0 else [a, c, b]
    corners, volume = base + [top], Fraction(abs(turn) * top[2], 6)
    com = [Fraction(sum(p[i] for p in corners), 4) for i in range(3)]
    spread = [[volume / 20 * sum((p[i] - com[i]) * (p[j] - com[j]) for p in corners) for j in range(3)] for i in range(3)]
    xx, yy, zz = (spread[i][i] for i in range(3))
    inertia = [yy + zz, zz + xx, xx + yy, -spread[0][1], -spread[0][2], -spread[1][2]]
    return {"vertices": corners, "triangles": [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]], "volume_mm3": float(volume),
            "com_mm": [float(v) for v in com], "inertia_mm5": [float(v) for v in inertia],
            "margin_rad": standing(base, com)}


def tetrahedra():
    rng = random.Random(2013)
    return [t for t in (tetrahedron(rng) for _ in range(40)) if t is not None]


def main():
    cases = {"box3": box3, "tetrahedra": tetrahedra}[sys.argv[1]]()
    print('{"format": "libsf-golden", "about": "%s", "cases": [' % sys.argv[1])
    print(",\n".join(json.dumps(c) for c in cases))
    print("]}")


if __name__ == "__main__":
    main()
