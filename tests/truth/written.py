# What is measured of files that `sf stand` wrote: weight, margin, wall, layers, by numpy, scipy and
# trimesh, and with nothing of the library.
#
# A mesh is an array of triangles (n, 3 corners, 3), in the axes of the input; a stack an array of
# booleans (layer, y, x) in build axes.

import json
import os
import struct
import sys
import zlib

try:
    import numpy as np
    import scipy.ndimage as ndimage
    import trimesh
    from scipy.spatial import ConvexHull, cKDTree
except ImportError as missing:
    print("1..0 # SKIP %s is not installed for this Python" % missing.name)
    sys.exit(0)

# --- Meshes ---------------------------------------------------------------------------------------


def read_stl(path):
    with open(path, "rb") as file:
        data = file.read()
    count = struct.unpack_from("<I", data, 80)[0]
    assert len(data) == 84 + 50 * count, path
    rows = np.frombuffer(data, dtype=np.dtype([("n", "<f4", 3), ("p", "<f4", (3, 3)), ("a", "<u2")]), offset=84)
    return rows["p"].astype(float)


def read_any(path):
    """Triangles in the order of the file."""
    mesh = trimesh.load(path, process=False)
    return np.asarray(mesh.vertices, dtype=float)[np.asarray(mesh.faces)]


def as_trimesh(triangles):
    return trimesh.Trimesh(*merge(triangles), process=False)


def merge(triangles):
    points, at = np.unique(triangles.reshape(-1, 3), axis=0, return_inverse=True)
    return points, at.reshape(-1, 3)


def is_closed(triangles):
    return as_trimesh(triangles).is_watertight


def body(triangles):
    """Volume and first moment, by tetrahedra from the middle of the box."""
    middle = (triangles.min(axis=(0, 1)) + triangles.max(axis=(0, 1))) / 2
    p = triangles - middle
    six = np.einsum("ij,ij->i", p[:, 0], np.cross(p[:, 1], p[:, 2]))
    volume = six.sum() / 6
    return volume, (six[:, None] * p.sum(axis=1)).sum(axis=0) / 24 + volume * middle


def volume_below(triangles, axis, at):
    """Volume on the low side of a plane across an axis, from the surface alone: what flows out of it of
    a field that is 0 in the plane, so that nothing has to be known of the cut."""
    p = triangles - triangles.mean(axis=(0, 1)) * (np.arange(3) != axis)
    flat = [(axis + 1) % 3, (axis + 2) % 3]
    u, v = (p[:, 1] - p[:, 0])[:, flat], (p[:, 2] - p[:, 0])[:, flat]
    area = (u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]) / 2  # seen along the axis, with its sign
    f = np.sort(triangles[:, :, axis] - at, axis=1)
    low, middle, high = f[:, 0], f[:, 1], f[:, 2]
    with np.errstate(divide="ignore", invalid="ignore"):
        below = np.where(middle > 0, low * low * low / ((low - middle) * (low - high)) / 3,
                         f.sum(axis=1) / 3 - high * high * high / ((high - low) * (high - middle)) / 3)
    below = np.where(high <= 0, f.sum(axis=1) / 3, np.where(low >= 0, 0, below))
    return (area * below).sum()


def centre(parts):
    """Centre of mass of all parts together, twice: by tetrahedra, and as trimesh has it."""
    ours = [body(part) for part in parts]
    made = [as_trimesh(part) for part in parts]
    volume = sum(v for v, _ in ours), sum(m.volume for m in made)
    moment = sum(m for _, m in ours), sum(m.volume * m.center_mass for m in made)
    return moment[0] / volume[0], moment[1] / volume[1], volume


def margin(outer, com, up, chosen=None):
    """Least tilt, in degrees, at which a body falls that stands on its lowest vertices; those chosen
    are all where none are."""
    points = merge(outer)[0]
    points = points if chosen is None else points[chosen(points)]
    ground, size = points[:, up].min(), np.ptp(outer.reshape(-1, 3), axis=0).max()
    flat = [d for d in range(3) if d != up]
    contacts = points[points[:, up] <= ground + 1e-6 * size][:, flat]
    sides = ConvexHull(contacts).equations  # n . x + d <= 0 inside
    inside = -(sides[:, :2] @ com[flat] + sides[:, 2])
    return np.degrees(np.arctan2(inside.min(), com[up] - ground)), len(contacts)


# --- Distances ------------------------------------------------------------------------------------


def to_triangles(p, t):
    """Distance of each point to the triangle beside it: to its plane where it is above it, else to
    its edges."""
    normal = np.cross(t[:, 1] - t[:, 0], t[:, 2] - t[:, 0])
    length = np.linalg.norm(normal, axis=1)
    above, least = length > 0, np.full(len(p), np.inf)
    for i in range(3):
        a, b = t[:, i], t[:, (i + 1) % 3]
        e, q = b - a, p - a
        square = np.einsum("ij,ij->i", e, e)
        part = np.clip(np.einsum("ij,ij->i", q, e) / np.where(square > 0, square, 1), 0, 1)
        least = np.minimum(least, np.linalg.norm(q - part[:, None] * e, axis=1))
        above &= np.einsum("ij,ij->i", np.cross(e, q), normal) >= 0
    plane = np.abs(np.einsum("ij,ij->i", p - t[:, 0], normal)) / np.where(length > 0, length, 1)
    return np.where(above, plane, least)


def least_distance(points, triangles):
    """The least distance of any of the points to any of the triangles."""
    middle = triangles.mean(axis=1)
    radius = np.linalg.norm(triangles - middle[:, None], axis=2).max()
    tree, least = cKDTree(middle), np.inf
    near = tree.query(points)[0]
    # Whoever is nearer than `best` has the middle of its triangle within best + radius.
    best = to_triangles(points, triangles[tree.query(points)[1]]).min()
    close = points[near <= best + radius]
    for part in np.array_split(close, max(1, len(close) // 5000)):
        found = tree.query_ball_point(part, best + radius)
        counts = np.array([len(f) for f in found])
        if counts.sum() > 0:
            at = np.concatenate([np.array(f, dtype=int) for f in found])
            least = min(least, to_triangles(np.repeat(part, counts, axis=0), triangles[at]).min())
    return min(best, least)


def wall(outer, inner):
    """Between the two surfaces: from corners, middles of edges and of triangles of either, to all
    triangles of the other."""
    def samples(t):
        return np.unique(np.concatenate([t.reshape(-1, 3), t.mean(axis=1), (t + np.roll(t, 1, axis=1)).reshape(-1, 3) / 2]), axis=0)
    return min(least_distance(samples(inner), outer), least_distance(samples(outer), inner))


# --- Surfaces that run into themselves ------------------------------------------------------------


def crossings(triangles):
    """Pairs of triangles without a common corner of which an edge of one goes through the other."""
    points, faces = merge(triangles)
    low, high = triangles.min(axis=1), triangles.max(axis=1)
    middle, radius = (low + high) / 2, np.linalg.norm(high - low, axis=1) / 2
    pairs, tree = [], cKDTree(middle)
    # The larger one of a pair looks for those that are not larger, in classes of twice the size.
    classes = np.floor(np.log2(radius + 1e-300))
    for c in np.unique(classes):
        at = np.nonzero(classes == c)[0]
        found = tree.query_ball_point(middle[at], 2.0 ** (c + 2))
        counts = np.array([len(f) for f in found])
        a, b = np.repeat(at, counts), np.concatenate([np.array(f, dtype=int) for f in found])
        good = (classes[b] < c) | ((classes[b] == c) & (a < b))
        a, b = a[good], b[good]
        good = np.all((low[a] <= high[b]) & (low[b] <= high[a]), axis=1)
        pairs.append(np.stack([a[good], b[good]], axis=1))
    pairs = np.concatenate(pairs)
    shared = (faces[pairs[:, 0]][:, :, None] == faces[pairs[:, 1]][:, None, :]).any(axis=(1, 2))
    a, b = pairs[~shared].T
    hit = np.zeros(len(a), dtype=bool)
    for s, t in ((a, b), (b, a)):
        p, (t0, t1, t2) = triangles[s], (triangles[t][:, i] for i in range(3))
        for i in range(3):
            hit |= goes_through(p[:, i], p[:, (i + 1) % 3], t0, t1, t2)
    return int(hit.sum())


def volume_of(a, b, c, d):
    return np.einsum("ij,ij->i", np.cross(b - a, c - a), d - a)


def goes_through(p, q, a, b, c):
    sides = np.sign(volume_of(a, b, c, p)) * np.sign(volume_of(a, b, c, q)) < 0
    turns = [np.sign(volume_of(p, q, *e)) for e in ((a, b), (b, c), (c, a))]
    return sides & (turns[0] == turns[1]) & (turns[1] == turns[2]) & (turns[0] != 0)


# --- Layers ---------------------------------------------------------------------------------------


def read_png(path):
    """A picture of one bit for each pixel, the first row first."""
    with open(path, "rb") as file:
        data = file.read()
    at, packed = 8, b""
    while at < len(data):
        size, kind = struct.unpack_from(">I4s", data, at)
        if kind == b"IHDR":
            width, height, depth, colour, _, _, interlaced = struct.unpack_from(">IIBBBBB", data, at + 8)
            assert (depth, colour, interlaced) == (1, 0, 0), path
        elif kind == b"IDAT":
            packed += data[at + 8:at + 8 + size]
        at += 12 + size
    raw, row = zlib.decompress(packed), (width + 7) // 8
    last, rows = bytearray(row), []
    for y in range(height):
        way, line = raw[y * (row + 1)], bytearray(raw[y * (row + 1) + 1:(y + 1) * (row + 1)])
        for i in range(row):
            left, above, corner = (line[i - 1], last[i], last[i - 1]) if i > 0 else (0, last[i], 0)
            guess = left + above - corner
            paeth = min((abs(guess - v), n, v) for n, v in enumerate((left, above, corner)))[2]
            line[i] = (line[i] + (0, left, above, (left + above) // 2, paeth)[way]) & 255
        rows.append(np.unpackbits(np.frombuffer(bytes(line), dtype=np.uint8))[:width])
        last = line
    return np.array(rows, dtype=bool)


def read_stack(folder):
    """(layer, y, x), and the description."""
    with open(os.path.join(folder, "stack.json"), encoding="utf-8") as file:
        about = json.load(file)
    assert (about["row_order"], about["solid"]) == ("top_is_max_y", "white")
    pattern, count = about["layers"]["pattern"], about["layers"]["count"]
    return np.array([read_png(os.path.join(folder, pattern % k))[::-1] for k in range(count)]), about


def steps(about):
    """What carries: for each step upwards, whether the voxel that is (dx, dy) aside does; by the
    formulas of docs/certificate.md, for cubes and 45 degrees."""
    kind, count = about["rule"]["kind"], about["lattice"]["nz"]
    if kind == "box3":
        return [(1, 2)] * count
    assert kind == "octagon" and abs(about["rule"]["angle_deg"] - 45) < 1e-9
    c, d = np.floor(np.cos(np.pi / 8) * 2.0 ** 32) / 2.0 ** 32, np.floor((np.sqrt(2) - 1) * 2.0 ** 32) / 2.0 ** 32
    a = np.floor(c * np.arange(count + 1) + 0.5)
    b = np.floor(d * a + 0.5)
    return [(int(f), int(f + s)) for f, s in zip(np.diff(a), np.diff(b))]


def unsupported(stack, about):
    """Voxels above the lowest matter with nothing below that may carry them."""
    hang, bed, step = np.zeros_like(stack), np.nonzero(stack.any(axis=(1, 2)))[0][0], steps(about)
    for k in range(bed + 1, len(stack)):
        first, second = step[k - 1]
        dx, dy = np.meshgrid(np.arange(-first, first + 1), np.arange(-first, first + 1))
        hang[k] = stack[k] & ~ndimage.binary_dilation(stack[k - 1], np.abs(dx) + np.abs(dy) <= second)
    return hang


def voxels_of(triangles, about):
    """The voxels whose centres a closed surface winds around, and those whose centres lie on it, or
    nearer to it than vertices are rounded to (1/512 of a voxel and what a file rounds): these may be
    either. Triangles in build axes."""
    aside = 2e-3 * np.array([[1, 0.3, 0.1], [-1, 0.1, 0.3], [0.3, 1, -0.1], [0.1, -1, -0.3], [0.2, 0.1, 1], [-0.1, -0.2, -1]])
    tries = np.array([winding(triangles, about, move) != 0 for move in aside])
    return tries.all(axis=0), tries.any(axis=0) & ~tries.all(axis=0)


def winding(triangles, about, move):
    """How often the surface winds around each voxel's centre, moved by parts of a voxel: from its
    crossings with the vertical lines through them."""
    l = about["lattice"]
    pitch, origin = l["pitch_mm"][0], np.array(l["origin_mm"])
    turns = np.zeros((l["nz"] + 1, l["ny"], l["nx"]), dtype=int)
    p = (triangles - origin) / pitch - 0.5 - move
    for t in p:
        x0, y0 = np.maximum(np.ceil(t.min(axis=0)[:2]), 0).astype(int)
        x1, y1 = np.minimum(np.floor(t.max(axis=0)[:2]), [l["nx"] - 1, l["ny"] - 1]).astype(int)
        area = (t[1, 0] - t[0, 0]) * (t[2, 1] - t[0, 1]) - (t[1, 1] - t[0, 1]) * (t[2, 0] - t[0, 0])
        if x1 < x0 or y1 < y0 or area == 0:
            continue
        x, y = np.meshgrid(np.arange(x0, x1 + 1), np.arange(y0, y1 + 1))
        u = ((x - t[0, 0]) * (t[2, 1] - t[0, 1]) - (y - t[0, 1]) * (t[2, 0] - t[0, 0])) / area
        v = ((t[1, 0] - t[0, 0]) * (y - t[0, 1]) - (t[1, 1] - t[0, 1]) * (x - t[0, 0])) / area
        inside = (u >= 0) & (v >= 0) & (u + v <= 1)
        z = t[0, 2] + u * (t[1, 2] - t[0, 2]) + v * (t[2, 2] - t[0, 2])
        k = np.clip(np.ceil(z[inside]), 0, l["nz"]).astype(int)
        np.add.at(turns, (k, y[inside], x[inside]), -1 if area > 0 else 1)
    return np.cumsum(turns, axis=0)[:-1]


def most_that_may_go(stack, about, triangles, wall):
    """How many voxels any carving could take out, at most: a cube that stays `wall` away has its centre
    half an edge further in. Distances are to corners and middles, so too large if anything."""
    pitch = about["lattice"]["pitch_mm"][0]
    centres = np.argwhere(stack)[:, ::-1] * pitch + np.array(about["lattice"]["origin_mm"]) + pitch / 2
    tree = cKDTree(np.concatenate([triangles.reshape(-1, 3), triangles.mean(axis=1)]))
    return int((tree.query(centres, workers=1)[0] >= wall + pitch / 2).sum())


def components(stack):
    """With voxels that share a face; and that share a corner."""
    return ndimage.label(stack)[1], ndimage.label(stack, np.ones((3, 3, 3)))[1]
