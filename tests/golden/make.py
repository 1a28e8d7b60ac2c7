# Golden vectors: small shapes, and what the papers' rule makes of them, by sets of places and loops.
# C, Python and Rust are held against the same file. This shares no code with any of them.
#
# A string of 0 and 1 is a grid in (layer, y, x) order. `trimmed` is the largest support-free part,
# `unsupported` what nothing carries, each voxel by itself, `bounds` x0 y0 z0 x1 y1 z1 of the shape,
# its high ends without. The bed is layer 0.
#
# usage: make.py >box3.json

import json
import random

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


def main():
    rng = random.Random(2016)
    cases = [case(size, share, rng) for size in SIZES for share in (0.0, 0.1, 0.3, 0.6, 1.0)]
    print('{"format": "libsf-golden", "rule": "box3", "cases": [')
    print(",\n".join(json.dumps(c) for c in cases))
    print("]}")


if __name__ == "__main__":
    main()
