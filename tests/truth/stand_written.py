# Why: `sf stand` says that a model stands, how thick its wall is, and that nothing hangs inside. Here
# nothing that it says is believed: the meshes are weighed and tipped, the distance of the two surfaces
# is taken from triangle to triangle, and the layers are looked at voxel by voxel, all from what was
# written (written.py). The paper's balls must come as far by carving as was promised, by planes and
# without supports; a horse on its hind hooves must stand after bending, moved by no more than 16 % of
# its size, and not run into itself where it did not before. What --cut wrote must be closed, and hold what
# the surface of the whole says is on its side of the plane.
#
# usage: stand_written.py SF [SF_VERIFY]; speaks TAP. Models from SF_DATA.

import os
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True  # leave nothing beside the sources
import written  # says so and ends where numpy, scipy or trimesh is missing

import numpy as np

SLACK_DEG = 0.02
CARVED_LEAST = 0.9  # of what the paper's carving takes out
MOVED_MOST = 0.16
numbers = {"tests": 0, "failed": 0}
solids = {}


def check(good, words):
    numbers["tests"] += 1
    numbers["failed"] += not good
    print("%s %d - %s" % ("ok" if good else "not ok", numbers["tests"], words), flush=True)


def say(words):
    print("# " + words, flush=True)


def run(*command):
    return subprocess.run([str(c) for c in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)


def upright(triangles):
    """From axes with y upwards to build axes."""
    return np.stack([triangles[..., 0], -triangles[..., 2], triangles[..., 1]], axis=-1)


def stand(program, model, name, *options):
    made = run(program, "stand", model, "-q", "-o", name, *options)
    if made.returncode not in (0, 1):
        check(False, "sf stand ends with %d: %s" % (made.returncode, made.stdout))
        sys.exit(1)
    return written.read_stl(name + "_outer.stl"), written.read_stl(name + "_inner.stl"), made.returncode


def weigh(outer, inner, up, words, chosen=None):
    """The margin, by two ways that must agree."""
    check(written.is_closed(outer) and written.is_closed(inner), words + ": both surfaces are closed")
    ours, theirs, volumes = written.centre([outer, inner])
    (mine, contacts), other = written.margin(outer, ours, up, chosen), written.margin(outer, theirs, up, chosen)[0]
    say("%s: volume %.9g (trimesh %.9g), centre of mass %s, %d contacts, margin %.4f degrees (trimesh %.4f)" % (
        words, volumes[0], volumes[1], np.array2string(ours, precision=6), contacts, mine, other))
    check(abs(mine - other) < 1e-6 and abs(volumes[0] - volumes[1]) < 1e-9 * abs(volumes[0]), words + ": weighed twice alike")
    return mine


# --- Balls ----------------------------------------------------------------------------------------

# Wall, pitch, and the margins that carving by planes and carving without supports must reach, by the
# paper's rule and by the octagon, which is stricter.
SETTINGS = [(0.010, 0.0107, 4.0, 3.0, 2.95), (0.015, 0.005, 3.5, 2.5, 2.5)]
AS_FAR_AS_CAN_BE = 5


def look_at_layers(folder, outer, words, is_free):
    """Components, and what hangs that did not hang in the solid, all by own voxels; whether those are
    solid whose centres lie on the surface, the layers say, for wall is not carved."""
    carved, about = written.read_stack(folder)
    key = str(about["lattice"])  # balls are all that is looked at, and their outside stays
    if key not in solids:
        solids[key] = written.voxels_of(upright(outer), about)
    inside, doubtful = solids[key]
    solid = inside | (doubtful & carved)
    hung, hangs = written.unsupported(solid, about), written.unsupported(carved, about)
    new = hangs & ~hung
    by_faces, by_corners = written.components(carved)
    say("%s: %d voxels of %d left, %d in doubt, rule %s, %d pieces by faces, %d by corners, %d hung before, %d hang that did not" % (
        words, carved.sum(), solid.sum(), doubtful.sum(), about["rule"]["kind"], by_faces, by_corners, hung.sum(), new.sum()))
    check(doubtful.sum() < 1e-3 * solid.sum() and not (carved & ~solid).any(), words + ": nothing was added")
    check(by_corners == 1, words + ": one piece")
    if is_free:
        check(not new.any(), words + ": nothing hangs that did not before")
    else:
        say("the paper's carving leaves %d voxels of ceilings without support" % new.sum())
        check(new.any(), words + ": ceilings hang, so that there is something to find")
    return carved, solid, about


def look_at_wall(outer, inner, asked, words):
    thin = written.wall(outer, inner)
    say("%s: wall %.6f, of %g asked" % (words, thin, asked))
    check(thin >= asked * (1 - 1e-5), words + ": the wall is as thick as asked")


def carve_balls(program, verifier, model, setting, way, gamma, asked):
    wall, pitch = setting[:2]
    rule = "octagon" if way == "octagon" else "box3"
    words = "balls, wall %.3f, %s, %g degrees asked" % (wall, way, gamma)
    options = ["--up", "+y", "--wall", wall, "--pitch", pitch, "--rule", rule, "--no-deform", "--gamma", gamma, "--layers", "layers"]
    if way == "paper":
        options += ["--carve", "paper"]
    elif verifier is not None:
        options += ["--certificate", "layers.json"]
    outer, inner, status = stand(program, model, "balls", *options)
    before = written.read_any(model)
    away = np.linalg.norm(outer - before, axis=2).max()
    check(away < 3e-6 * np.ptp(before.reshape(-1, 3), axis=0).max(), words + ": the outside is as it was (%.3g)" % away)
    margin = weigh(outer, inner, 1, words)
    check(margin >= asked - SLACK_DEG, words + ": margin %.4f degrees, at least %g" % (margin, asked))
    check((status == 0) == (margin >= gamma - SLACK_DEG), words + ": the status says whether that was asked")
    look_at_wall(outer, inner, wall, words)
    look_at_layers("layers", outer, words, way != "paper")
    if way != "paper" and verifier is not None:
        said = run(verifier, "layers", "layers.json")
        check(said.returncode == 0, words + ": %s" % said.stdout.strip())
    return -written.body(inner)[0]


def hollow_balls(program, verifier, model, setting):
    """`sf hollow` asks for no balance: of all that may go, nearly all must."""
    wall, pitch = setting[:2]
    words = "balls, wall %.3f, hollow" % wall
    certify = ["--certificate", "layers.json"] if verifier is not None else []
    made = run(program, "hollow", model, "-q", "--up", "+y", "--wall", wall, "--pitch", pitch, "--min-feature", 2 * pitch,
               "--rule", "box3", "-o", "layers", "--cavity", "cavity.stl", *certify)
    check(made.returncode == 0, words + ": made")
    outer = written.read_any(model)
    look_at_wall(outer, written.read_stl("cavity.stl"), wall, words)
    carved, solid, about = look_at_layers("layers", outer, words, True)
    most = written.most_that_may_go(solid, about, upright(outer), wall)
    out = int((solid & ~carved).sum())
    check(out >= CARVED_LEAST * most, words + ": %d voxels out, %.1f %% of the %d that any carving could take" % (out, 100 * out / most, most))
    if verifier is not None:
        said = run(verifier, "layers", "layers.json")
        check(said.returncode == 0, words + ": %s" % said.stdout.strip())


def balls(program, verifier, folder):
    model = os.path.join(folder, "characters", "spheres_outer.stl")
    solid = written.read_any(model)
    com = written.centre([solid])[0]
    falls = written.margin(solid, com, 1)[0]
    check(abs(written.body(solid)[0] - 0.1010587300) < 1e-8 and np.abs(com - [0.497724, 0.413541, 0.607710]).max() < 1e-5,
          "the balls weigh what is known of them")
    check(falls < 0, "and fall: margin %.4f degrees" % falls)
    for setting in SETTINGS:
        by_planes, without, octagon = setting[2:]
        most = carve_balls(program, verifier, model, setting, "paper", AS_FAR_AS_CAN_BE, by_planes)
        carve_balls(program, verifier, model, setting, "paper", by_planes, by_planes)
        for way, asked in (("support-free", without), ("octagon", octagon)):
            free = carve_balls(program, verifier, model, setting, way, AS_FAR_AS_CAN_BE, asked)
            check(free >= CARVED_LEAST * most, "wall %.3f, %s: %.1f %% of the paper's cavity (%.6f of %.6f)" % (
                setting[0], way, 100 * free / most, free, most))
        carve_balls(program, verifier, model, setting, "support-free", without, without)
        hollow_balls(program, verifier, model, setting)


# --- Horse ----------------------------------------------------------------------------------------


def horse(program, folder):
    path = os.path.join(folder, "characters", "horse.ply")
    before = written.read_any(path)
    if written.body(before)[0] < 0:
        before = before[:, [0, 2, 1]]  # inside out, and turned
    size = np.ptp(before.reshape(-1, 3), axis=0).max()
    as_given = written.crossings(before.astype(np.float32).astype(float))
    for way in ("paper", "support-free"):
        words = "horse on its hind hooves, " + way
        outer, inner, _ = stand(program, path, "horse", "--up", "+z", "--contacts", "y>0", "--gamma", 3, "--carve", way)
        margin = weigh(outer, inner, 2, words, lambda p: p[:, 1] > 0)
        check(margin >= 3 - SLACK_DEG, words + ": margin %.4f degrees, of 3" % margin)
        ground = outer[..., 2][outer[..., 1] > 0].min()
        check(outer[..., 2].min() >= ground - 1e-4 * size, words + ": nothing is below its hooves")
        moved = np.linalg.norm(outer - before, axis=2).max() / size
        check(moved <= MOVED_MOST, words + ": moved by at most %.2f %% of its size" % (100 * moved))
        crossed = written.crossings(outer)
        check(crossed <= as_given, words + ": %d triangles cross, %d as given" % (crossed, as_given))
        look_at_wall(outer, inner, 0.01 * size, words)


# --- Halves ---------------------------------------------------------------------------------------


def look_at_halves(name, whole, axis, at, words):
    """Each half is closed, lies on its side, and holds what is there of the whole."""
    low, high = written.read_stl(name + "_low.stl"), written.read_stl(name + "_high.stl")
    size = np.ptp(whole.reshape(-1, 3), axis=0).max()
    check(written.is_closed(low) and written.is_closed(high), words + ": both halves are closed")
    beyond = max(low[..., axis].max() - at, at - high[..., axis].min())
    check(beyond <= 1e-6 * size, words + ": and end at the plane (%.3g)" % beyond)
    below, all_of_it = written.volume_below(whole, axis, at), written.body(whole)[0]
    for half, volume in ((low, below), (high, all_of_it - below)):
        mine = written.body(half)[0]
        check(abs(mine - volume) < 1e-6 * all_of_it, words + ": a half of %.9g, of %.9g" % (mine, volume))


def halves(program, folder):
    for file in ("horse.ply", "spot_low_resolution.obj", "human_man.obj"):
        path = os.path.join(folder, "characters", file)
        for axis in range(3):
            at = (7, -5, 2)[axis]
            words = "%s, hollow and cut across %s" % (file, "xyz"[axis])
            made = run(program, "hollow", path, "-q", "--size", 100, "--wall", 2, "--resolution", 100,
                       "-o", "hollow.stl", "--cut", "%s,%g" % ("xyz"[axis], at))
            if made.returncode == 2:  # beside the part: through its middle
                made = run(program, "hollow", path, "-q", "--size", 100, "--wall", 2, "--resolution", 100,
                           "-o", "hollow.stl", "--cut", "xyz"[axis])
                at = None
            check(made.returncode == 0, words + ": made")
            whole = written.read_stl("hollow.stl")
            if at is None:
                at = (whole[..., axis].min() + whole[..., axis].max()) / 2
            look_at_halves("hollow", whole, axis, at, words)
    model = os.path.join(folder, "characters", "spheres_outer.stl")
    outer, inner, _ = stand(program, model, "balls", "--up", "+y", "--wall", 0.015, "--pitch", 0.01, "--cut", "x,0.5")
    look_at_halves("balls", np.concatenate([outer, inner]), 0, 0.5, "balls that stand, cut")


def main():
    folder = os.environ.get("SF_DATA")
    if folder is None:
        print("1..0 # SKIP SF_DATA is not set, and these are real models")
        return 0
    program = os.path.abspath(sys.argv[1])
    verifier = os.path.abspath(sys.argv[2]) if len(sys.argv) > 2 else None
    with tempfile.TemporaryDirectory() as scratch:
        os.chdir(scratch)
        balls(program, verifier, folder)
        horse(program, folder)
        halves(program, folder)
        os.chdir(folder)
    print("1..%d" % numbers["tests"])
    return 1 if numbers["failed"] > 0 else 0


sys.exit(main())
