# Why: what a printer's processor says of a job must be what the library says of it, in the memory,
# the code and the stack that such a processor has. The example firmware is built for a board, run
# there (qemu, node), and its words are held against this machine's; on this machine they are held
# against the library's own checker. The figures that docs/firmware.md names are measured here.
#
# usage: firmware.py SOURCE WHERE SF-CHIP FIRMWARE JUDGE STANDALONE-SOURCES...; WHERE: host, cortex-m4,
# cortex-m7 or wasm; speaks TAP.

import os
import re
import shutil
import subprocess
import sys
import tempfile

SOURCE, WHERE, TOOL, HOST, JUDGE = [os.path.abspath(p) if "/" in p else p for p in sys.argv[1:6]]
STANDALONE = [os.path.abspath(p) for p in sys.argv[6:]]
sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import figures  # noqa: E402
import jobs  # noqa: E402

FOLDER = os.path.join(SOURCE, "demo", "firmware")
ENTRIES = ["sf_chip_place", "sf_chip_push", "sf_chip_report", "sf_chip_save", "sf_chip_resume",
           "sf_chip_solid", "sf_chip_grey", "sf_chip_size", "sf_chip_slot_size",
           "sf_chip_options_default"]
RUNS = 3000
NEEDS = {"host": ["gcc"], "cortex-m4": ["arm-none-eabi-gcc", "qemu-system-arm"],
         "cortex-m7": ["arm-none-eabi-gcc", "qemu-system-arm"], "wasm": ["clang", "wasm-ld", "node"]}
BOARDS = {"cortex-m4": "mps2-an386", "cortex-m7": "mps2-an500"}
FLAGS = ["-std=c99", "-Os", "-ffreestanding", "-ffp-contract=off", "-ffunction-sections",
         "-fdata-sections", "-DSF_STATIC", "-I" + os.path.join(SOURCE, "libsf"),
         "-I" + os.path.join(SOURCE, "libsf", "include"), "-I" + FOLDER, "-I."]
count = bad = 0


def ok(good, what, *why):
    global count, bad
    count += 1
    bad += not good
    for line in why if not good else ():
        print("#", line)
    print(f"{'ok' if good else 'not ok'} {count} - {what}", flush=True)


def call(*words, **more):
    return subprocess.run(words, capture_output=True, text=True, **more)


def must(*words):
    run = call(*words)
    if run.returncode != 0:
        print("Bail out!", " ".join(words), run.stdout, run.stderr)
        sys.exit(99)
    return run


# --- building ------------------------------------------------------------------------------------


def compile_all(cc, sources, flags):
    objects = []
    for source in sources:
        name = os.path.relpath(source, SOURCE).replace("/", "-")[:-2] + ".o"
        must(*cc, *FLAGS, *flags, "-c", source, "-o", name)
        objects.append(name)
    return objects


def build_arm(core):
    cc = ["arm-none-eabi-gcc"]
    flags = ["-mcpu=" + core, "-mthumb", "-fstack-usage", "-fcallgraph-info=su"]
    library = compile_all(cc, STANDALONE, flags)
    example = compile_all(cc, [os.path.join(FOLDER, n) for n in
                               ("firmware.c", "job.c", "board_mps2.c")], flags)
    must("arm-none-eabi-ar", "rcs", "libsf-core.a", *library)
    must(*cc, *flags[:2], "--specs=nano.specs", "-nostartfiles", "-Wl,--gc-sections",
         "-Wl,-Map=firmware.map", "-T", os.path.join(FOLDER, "mps2.ld"), *example, "libsf-core.a",
         "-o", "firmware.elf")


def build_wasm():
    cc = ["clang", "--target=wasm32"]
    objects = compile_all(cc, STANDALONE + [os.path.join(FOLDER, n) for n in
                                            ("firmware.c", "job.c", "board_wasm.c")], [])
    must("wasm-ld", "--no-entry", "--export=firmware", "--gc-sections", "--strip-all", *objects,
         "-o", "firmware.wasm")


def build_host():
    compile_all(["gcc"], [s for s in STANDALONE if "/chip/" in s],
                ["-fstack-usage", "-fcallgraph-info=su", "-fno-stack-protector", "-fcf-protection=none"])


# --- running -------------------------------------------------------------------------------------


def firmware(*words, where=None, counted=False):
    """counted: instructions are counted, which takes qemu several times as long."""
    where = where or WHERE
    if where == "host":
        return call(HOST, *words)
    if where == "wasm":
        return call("node", os.path.join(FOLDER, "run.mjs"), "firmware.wasm", *words)
    arguments = ",".join("arg=" + w for w in ("firmware",) + words)
    return call("qemu-system-arm", "-machine", BOARDS[where], "-nographic", "-monitor", "none",
                "-serial", "none", *(["-icount", "shift=0"] if counted else []), "-semihosting-config",
                f"enable=on,target=native,{arguments}", "-kernel", "firmware.elf", timeout=300)


def said(run, *without):
    """What a run printed, but for what differs from machine to machine."""
    lines = (run.stdout + run.stderr).splitlines()
    return [l for l in lines if l.split(" ")[0] not in ("longest_row", "stack") + without]


def value(run, name):
    found = re.search(rf"^{name} (\d+)$", run.stdout + run.stderr, re.M)
    return int(found.group(1)) if found else -1


def check_job(name, path, sparse="runs"):
    """Both forms say the same, and what the library says or this machine said; returns the runs."""
    runs = {"dense": firmware("dense", path), "runs": firmware(sparse, path)}
    if WHERE == "host":
        judged = call(JUDGE, path)
        wanted = judged.stdout.splitlines()
        good = judged.returncode == 0 and len(wanted) == 5
        for form, run in runs.items():
            good = good and set(wanted) <= set(said(run))
        ok(good, f"{name}: dense and run-length count what the library counts", *wanted,
           *[l for run in runs.values() for l in said(run)])
    else:
        for form, run in runs.items():
            here = firmware("dense" if form == "dense" else sparse, path, where="host")
            ok(said(run) == said(here) and run.returncode == here.returncode,
               f"{name}, {form}: the same words as on this machine", run.returncode, *said(run),
               here.returncode, *said(here))
    dense, sparse = said(runs["dense"], "memory"), said(runs["runs"], "memory")
    ok(dense == sparse, f"{name}: dense and run-length say the same, hashes too", *dense, *sparse)
    return runs


def check_power_cut(path, form):
    whole = said(firmware(form, path))
    for stop in ("0", "3", "9"):
        state = f"state-{form}-{stop}"
        first = firmware(form, path, state, stop)
        second = firmware(form, path, state)
        ok(said(first)[0] == "from the beginning"
           and said(second)[0] == ("going on" if stop != "0" else "from the beginning")
           and said(second)[1:] == whole and second.returncode < 2,
           f"{form}: stopped after {stop} layers, it goes on to the same end", *said(first), *said(second))


def check_refusals(path):
    with open(path, "rb") as file:
        data = file.read()
    broken = {"cut": data[:len(data) // 2], "no job": b"solid" + data, "empty": b""}
    for name, data in broken.items():
        with open("broken.job", "wb") as file:
            file.write(data)
        run = firmware("runs", "broken.job")
        ok(run.returncode == 2 and "firmware: " in run.stdout + run.stderr,
           f"a job that is {name} is refused", run.returncode, *said(run))
    run = firmware("runs", jobs.combs("many.job", 2560, 40))
    ok(run.returncode == 2 and "too small" in run.stdout + run.stderr,
       "a layer of more runs than there is room for is refused", run.returncode, *said(run))
    ok(firmware("dense", "many.job").returncode == 1, "and a dense checker takes it")


# --- figures -------------------------------------------------------------------------------------


def check_sizes(all_runs):
    dense = value(all_runs["worst row, dense"]["dense"], "memory")
    rows = 2560 // 8 * (48 + 3)
    ok(0 < dense <= rows + 2048, f"dense: {dense} bytes of memory, of which {dense - rows} are more "
       "than the slice and three rows (at most 2048)")
    sparse = value(all_runs["worst row, runs"]["runs"], "memory")
    ok(0 < sparse <= 48 * 1024, f"run-length: {sparse} bytes of memory for {RUNS} runs a layer (at most "
       "49152)")


def check_stack(limit):
    worst = figures.Calls(".").worst(ENTRIES)
    for name, depth in sorted(worst.items(), key=lambda item: -item[1]):
        print(f"# {depth:4d} bytes of stack: {name}")
    deepest = max(worst.values())
    ok(0 < deepest <= limit, f"stack: {deepest} bytes at the most, decoder apart (at most {limit})")


def check_code():
    sizes = figures.code("firmware.map")
    core = {n: s for n, s in sizes.items() if "libsf-core.a" in n}
    foreign = {n: s for n, s in sizes.items() if "lib_a-" in n or "libgcc" in n}
    for name, size in sorted(core.items()) + sorted(foreign.items()):
        print(f"# {size:5d} bytes of code: {name.split('/')[-1]}")
    total, libc = sum(core.values()), sum(foreign.values())
    ok(0 < total <= 24 * 1024, f"code: {total} bytes, and {libc} of the C library (at most 24576)")
    names = {re.sub(r".*lib_a-|\.o\).*|.*\(", "", n) for n in foreign}
    allowed = re.compile(r"mem(cpy|set|cpy-stub)|_?u?(div|mod|l?shr|aeabi)\w*")
    strangers = [n for n in names if not allowed.fullmatch(n)]
    ok(not strangers, f"of the C library nothing but {', '.join(sorted(names))}", *strangers)


def check_work(all_runs):
    for name, form, pixels in (("worst row, dense", "dense", 2560), ("worst row, runs", "runs", 4 * RUNS)):
        run = all_runs[name][form]
        ok(0 < value(run, "longest_row") < 3000000,
           f"{form}: {value(run, 'longest_row')} instructions for the worst row of a layer of {pixels} pixels a row")


def check_stack_in_use():
    for form in ("dense", "runs"):
        run = firmware(form, "1.job", f"state-{form}-3")
        ok(0 < value(run, "stack") <= 1024, f"{form}, saving and going on: {value(run, 'stack')} bytes of "
           "stack were in use, the example's own included (at most 1024)", *said(run))


def main():
    missing = [n for n in NEEDS[WHERE] if shutil.which(n) is None]
    if missing:
        print(f"1..0 # SKIP {', '.join(missing)} is not installed")
        return 0
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        with open("table.h", "w", encoding="utf-8") as file:
            file.write(must(TOOL, "table").stdout)
        {"host": build_host, "wasm": build_wasm}.get(WHERE, lambda: build_arm(WHERE))()
        work()
    print(f"1..{count}")
    return bad > 0


def work():
    all_runs = {}
    for seed in range(6 if WHERE == "host" else 3):
        all_runs[f"chance {seed}"] = check_job(f"chance {seed}", jobs.chance(f"{seed}.job", seed))
    all_runs["worst row, dense"] = {"dense": firmware("dense", jobs.combs("comb.job", 2560, 48), counted=True)}
    all_runs["worst row, runs"] = check_job("all runs in one row", jobs.all_runs("all.job", RUNS))
    all_runs["worst row, runs"]["runs"] = firmware("runs", "all.job", counted=True)
    for form in ("dense", "runs"):
        check_power_cut("1.job", form)
    check_refusals("1.job")
    check_sizes(all_runs)
    if WHERE in BOARDS:
        check_code()
        check_work(all_runs)
        check_stack_in_use()
    if WHERE == "wasm":
        size = os.path.getsize("firmware.wasm")
        ok(size < 64 * 1024, f"firmware.wasm has {size} bytes, example and all")
    else:
        check_stack(512 if WHERE in BOARDS else 1024)
    data = os.environ.get("SF_DATA")
    if not data:
        ok(True, "slicers' files # SKIP SF_DATA is not set")
        return
    slices = os.path.join(data, "slices")
    for name in ("noAA", "AA"):
        path = jobs.sl1(f"{name}.job", os.path.join(slices, f"pyphotonfile_reference_{name}.sl1"), name,
                        TOOL)
        if path is None:
            ok(True, f"SL1 {name} # SKIP this build reads no stacks of PNG")
        else:
            runs = check_job(f"SL1 {name}", path, "runs=30000")
            if name == "noAA":
                ok(value(runs["dense"], "solid") == 16585109, "SL1: as many white pixels as it has",
                   *said(runs["dense"]))
    runs = check_job(".photon", jobs.photon("photon.job", os.path.join(slices,
                                                                      "pyphotonfile_reference.photon")),
                     "runs=30000")
    ok(value(runs["dense"], "solid") == 16600012, ".photon: as many white pixels as it has",
       *said(runs["dense"]))


sys.exit(main())
