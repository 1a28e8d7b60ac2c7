# Why: weights come from a solver of our own, on cells of our own. This program makes shapes, asks for
# their weights, and solves the same problem with the sparse factorisation of scipy: CLAMPED weights
# must be the same, BOUNDED ones must meet the conditions of the least within bounds. Where libigl is
# installed, its bounded biharmonic weights on tetrahedra, six for each voxel, must not be far.
#
# usage: weights.py PROGRAM; speaks TAP. It shares nothing with the library but the meaning of a cell.

import itertools
import subprocess
import sys
import time

try:
    import numpy as np
    import scipy.sparse as sparse
    import scipy.sparse.linalg as linalg
except ImportError:
    print("1..0 # SKIP scipy is not installed")
    sys.exit(0)

FAR = 0.15  # from tetrahedra: another discretisation


def figure(n):
    """A trunk on two legs, with arms and a head, n voxels high; layers first."""
    z, y, x = (np.indices((n, n // 2, n)) + 0.5) * (32 / n)
    x, y = x - 16, y - 8
    trunk = (x ** 2 + y ** 2 < 16) & (z > 10) & (z < 22)
    arm = (y ** 2 + (z - 19) ** 2 < 6) & (abs(x) < 15)
    leg = ((abs(x) - 3) ** 2 + y ** 2 < 6) & (z <= 10)
    head = x ** 2 + y ** 2 + (z - 26) ** 2 < 25
    points = np.array([[3.2, 8, 19], [28.8, 8, 19], [16, 8, 26], [16, 8, 16], [13, 8, 1], [19, 8, 1]])
    return trunk | arm | leg | head, np.floor(points * (n / 32)) + 0.25


def ball(n):
    """A ball with a dent."""
    z, y, x = np.indices((n, n, n)) + 0.5 - n / 2
    solid = (x ** 2 + y ** 2 + z ** 2 < n * n / 4) & ((x - n / 2) ** 2 + y ** 2 + z ** 2 > n * n / 16)
    points = np.array([[0.5, 0.5, 0.06], [0.5, 0.5, 0.94], [0.1, 0.5, 0.5], [0.5, 0.1, 0.5]]) * n
    return solid, np.floor(points) + 0.25


def corners(solid):
    """Nodes of each voxel, and the place of each node, both in (z, y, x) order."""
    z, y, x = np.nonzero(solid)
    nz, ny, nx = solid.shape
    numbers = np.stack([((z + k) * (ny + 1) + y + j) * (nx + 1) + x + i
                        for k in (0, 1) for j in (0, 1) for i in (0, 1)], 1)
    used, inverse = np.unique(numbers, return_inverse=True)
    place = np.stack([used % (nx + 1), used // (nx + 1) % (ny + 1), used // (nx + 1) // (ny + 1)], 1)
    return inverse.reshape(numbers.shape), place, np.stack([x, y, z], 1)


def matrices(cells, count, pitch):
    volume = np.prod(pitch)
    mass = np.bincount(cells.ravel(), minlength=count) * volume / 8
    low, high, flow = [], [], []
    for a, b in itertools.combinations(range(8), 2):
        if (a ^ b) in (1, 2, 4):
            low.append(cells[:, a])
            high.append(cells[:, b])
            flow.append(np.full(len(cells), volume / 4 / pitch[{1: 0, 2: 1, 4: 2}[a ^ b]] ** 2))
    low, high, flow = (np.concatenate(part) for part in (low, high, flow))
    between = sparse.coo_matrix((np.r_[flow, flow], (np.r_[low, high], np.r_[high, low])),
                                shape=(count, count)).tocsr()
    laplacian = sparse.diags(np.asarray(between.sum(1)).ravel()) - between
    return mass, (laplacian @ sparse.diags(1 / mass) @ laplacian).tocsr()


def ask(program, solid, points, pitch, method):
    """Weights of the library, and the places of its nodes."""
    nz, ny, nx = solid.shape
    text = f"{nx} {ny} {nz} {pitch[0]} {pitch[1]} {pitch[2]} {method} {len(points)}\n"
    text += "".join("01"[int(v)] for v in solid.flat) + "\n"
    text += "\n".join(" ".join(repr(float(c)) for c in p * pitch) for p in points) + "\n"
    started = time.process_time()
    answer = subprocess.run([program], input=text, capture_output=True, text=True, check=True)
    values = np.array(answer.stdout.split()[1:], dtype=float).reshape(-1, 3 + len(points))
    return values[:, 3:], values[:, :3], time.process_time() - started


def divide(weights):
    weights = np.clip(weights, 0, 1)
    return weights / weights.sum(1, keepdims=True)


class Case:
    def __init__(self, name, shape, pitch):
        self.name, (self.solid, self.points), self.pitch = name, shape, np.array(pitch)
        self.cells, self.place, voxels = corners(self.solid)
        self.mass, self.energy = matrices(self.cells, len(self.place), self.pitch)
        self.owner = np.full(len(self.place), -1)
        for j, p in enumerate(self.points):
            voxel = int(np.nonzero((voxels == np.floor(p).astype(int)).all(1))[0][0])
            self.owner[self.cells[voxel]] = j

    def given(self, j):
        return np.where(self.owner == j, 1.0, 0.0)


def clamped_is_scipys(program, case):
    found, at, _ = ask(program, case.solid, case.points, case.pitch, 0)
    free = np.nonzero(case.owner < 0)[0]
    factor = linalg.splu(case.energy[free][:, free].tocsc())
    solved = np.stack([case.given(j) for j in range(len(case.points))], 1)
    for j in range(len(case.points)):
        solved[free, j] = factor.solve(-(case.energy @ case.given(j))[free])
    error = abs(found - divide(solved)).max()
    return abs(at - case.place * case.pitch).max() < 1e-9 and error < 1e-5, \
        f"{len(free)} free corners, unbounded from {solved.min():.3f} to {solved.max():.3f}, off by {error:.1e}"


def bounded_meets_conditions(program, case):
    """Two handles, whose bounded weights add up to 1 by themselves."""
    pair = Case(case.name, (case.solid, case.points[[0, 3]]), case.pitch)
    found, _, _ = ask(program, pair.solid, pair.points, pair.pitch, 1)
    off = 0
    for w in found.T:
        aim = w - (pair.energy @ w) / pair.energy.diagonal()
        off = max(off, abs(w - np.clip(aim, 0, 1))[pair.owner < 0].max())
    held = int(((found[:, 0] < 1e-9) & (pair.owner < 0)).sum())
    return off < 1e-6 and held > 0, f"{held} corners at 0, off by {off:.1e}"


def tetrahedra(cells, place, pitch):
    """Six for each voxel, one for each way from its lowest to its highest corner."""
    made = np.concatenate([cells[:, [0, p[0], p[0] + p[1], 7]] for p in itertools.permutations([1, 2, 4])])
    at = place * pitch
    edges = at[made[:, 1:]] - at[made[:, :1]]
    negative = np.linalg.det(edges) < 0
    made[negative] = made[negative][:, [0, 2, 1, 3]]
    return at, made


def is_near_libigls(program, case):
    import igl
    at, tets = tetrahedra(case.cells, case.place, case.pitch)
    held = np.nonzero(case.owner >= 0)[0]
    values = np.eye(len(case.points))[case.owner[held]]
    started = time.process_time()
    theirs = divide(igl.bbw(at, tets.astype(np.int64), held.astype(np.int64), values))
    seconds = time.process_time() - started
    said = f"{len(at)} corners, {seconds:.1f} s:"
    good = True
    for method, name in enumerate(["clamped", "bounded"]):
        error = abs(ask(program, case.solid, case.points, case.pitch, method)[0] - theirs)
        said += f" {name} off by {error.max():.3f} at most, {np.sqrt((error ** 2).mean()):.4f} rms;"
        good &= error.max() < FAR
    return good, said.rstrip(";")


def main():
    program = sys.argv[1]
    cases = [Case("figure", figure(24), (1, 1, 1)), Case("figure, flat voxels", figure(24), (1, 1.2, 0.9)),
             Case("ball", ball(13), (1, 1, 1))]
    small = [Case("figure", figure(18), (1, 1, 1)), Case("ball", ball(9), (1, 1, 1))]
    jobs = [(clamped_is_scipys, c) for c in cases] + [(bounded_meets_conditions, c) for c in cases] + \
        [(is_near_libigls, c) for c in small]
    failures = 0
    for number, (job, case) in enumerate(jobs, 1):
        name = f"{job.__name__}: {case.name}"
        try:
            good, said = job(program, case)
        except ImportError:
            print(f"ok {number} - {name} # SKIP libigl is not installed")
            continue
        print(f"# {said}")
        print(f"{'ok' if good else 'not ok'} {number} - {name}", flush=True)
        failures += not good
    print(f"1..{len(jobs)}")
    return failures > 0


sys.exit(main())
