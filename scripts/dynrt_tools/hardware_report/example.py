# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""What the tests of a hardware report share: configurations, gates and frames whose figures are easy to
compute by hand."""

from typing import Any

from dynrt_tools.hardware_report import figures, findings, points, rows, walks
from dynrt_tools.hardware_report import gates as gate_jobs
from dynrt_tools.hardware_report.collect import table_row
from dynrt_tools.hardware_report.figure import KEYS, Point
from dynrt_tools.project import Json

PIXELS = (32, 24)
FRAMES = 3
ARITHMETIC = {"slice_0": 300, "intersection": 100}


def configuration(packets: int = 4, lines: int = 2, curves: bool = True) -> Json:
    keys = {"about": "an example", "packets": packets, "lines": lines, "memory": "banks", "ways": 1}
    found = points.points(keys, figures.FIGURES if curves else ())
    return {"keys": keys, "named": "example", "curves": curves, "points": found}


def gates(packets: int, lines: int, pipelines: int = 1) -> Json:
    """In each pipeline: logic 1,000 gates and 10 a packet; memories 200 a packet and 30 a line."""
    return {
        "logic": pipelines * (1000 + 10 * packets),
        "memory": pipelines * (200 * packets + 30 * lines),
        "arithmetic": {name: pipelines * count for name, count in ARITHMETIC.items()},
    }


def gates_of(keys: Json) -> Json:
    return gates(keys["packets"], keys["lines"], keys.get("pipelines", 1))


def frame(packets: int, lines: int, scanline: bool = False, keys: Point | None = None) -> Json:
    """The slice works in packets / 10 of the clocks, the intersection in half as many. With scanlines
    and with fewer lines the caches miss more. Each clock more of the memory makes a frame an eighth
    longer."""
    wait, _, pipelines = (int((keys or {}).get(key, own)) for key, own in KEYS.items())
    use = packets / 10
    misses = {"node": 400 // lines, "list": 100 // lines, "matrix": 200 // lines}
    units = {"slice_0": use, "node_lookup": use, "list_lookup": use / 4, "transformation": use / 2}
    units["intersection"] = use / 2
    return {
        "packets": packets,
        "cache_lines": lines,
        "width": PIXELS[0],
        "height": PIXELS[1],
        "hits": PIXELS[0],
        "cycles": 76800 // packets * (7 + wait) // (8 * pipelines),
        "memory": {
            "bytes_read": 8 * misses["node"] + 4 * misses["list"] + 12 * misses["matrix"],
            "pixel_bytes_written": 4 * PIXELS[0] * PIXELS[1],
            "hit_bytes_written": 24 * PIXELS[0] * PIXELS[1],
        },
        "units": {name: {"utilisation": value} for name, value in units.items()},
        "caches": {
            name: {"lookups": 500, "misses": count + 50 * scanline}
            for name, count in misses.items()
        },
    }


def walk(number: int, packets: int, lines: int, scanline: bool = False, keys: Any = None) -> Json:
    """So many frames of which that is the mean: each takes two clocks more than the one before."""
    mean = frame(packets, lines, scanline, keys)
    frames = [{**mean, "cycles": mean["cycles"] + 2 * i - (number - 1)} for i in range(number)]
    return {"walk": {"frames": [{"figures": one} for one in frames]}}


def mean_frame(*given: Any, **keys: Any) -> Json:
    """As collect() has it."""
    frames = walk(FRAMES, *given, **keys)["walk"]["frames"]
    return walks.mean([one["figures"] for one in frames])


def frame_at(point: Point) -> Json:
    scanline = point["order"] == "scanline"
    return mean_frame(int(point["packets"]), int(point["lines"]), scanline, points.keys_of(point))


# A dynrt that knows two scenes and walks through them as walk() has it. A walk of one packet dies where
# the file `fail` says so, is killed where `kill` does, and does not come to its end where `hang` does.
PROGRAM = """#!/usr/bin/python3
import json, os, pathlib, signal, sys, time
sys.path.insert(0, {scripts!r})
from dynrt_tools.hardware_report import example
words = sys.argv[1:]
of = lambda flag: words[words.index(flag) + 1]
if words[1] not in ("blocks", "lamps") and not words[1].endswith(".obj"):
    print(f"dynrt: {{words[1]}}: unknown scene; the scenes are blocks, lamps", file=sys.stderr)
    sys.exit(2)
if words[0] == "info":
    print(f"scene       {{words[1]}}: 12 triangles")
    sys.exit()
if words[0] == "specialise":
    with pathlib.Path("ran").open("a") as file:
        file.write(f"specialise {{words[1]}} --keep {{of('--keep')}}\\n")
    if pathlib.Path("fail_specialise").exists():
        sys.exit("dynrt: no core can be made")
    pathlib.Path(of("--out")).mkdir(exist_ok=True)
    core = {{"like": "thesis", "packets": 2, "lines": 1}}
    (pathlib.Path(of("--out")) / "configuration.json").write_text(json.dumps(core))
    sys.exit()
with pathlib.Path("ran").open("a") as file:
    file.write(" ".join(words[1:2] + words[words.index("--config"):words.index("--again")]) + "\\n")
packet = "--packets 1 " in " ".join(words)
if pathlib.Path("fail").exists() and packet:
    print("dynrt: the frame is lost", file=sys.stderr)
    sys.exit(3)
if pathlib.Path("kill").exists() and packet:
    os.kill(os.getpid(), signal.SIGKILL)
if pathlib.Path("hang").exists() and packet:
    signal.signal(signal.SIGTERM, signal.SIG_IGN)
    pathlib.Path("hanging").write_text(os.environ.get("SLURM_JOB_ID", ""))
    time.sleep(600)
model = pathlib.Path(of("--config"))
keys = json.loads(model.read_text()) if model.suffix == ".so" else {{}}
of_core = [int(of(f"--{{n}}") if f"--{{n}}" in words else keys[n]) for n in ("packets", "lines")]
walk = example.walk(int(of("--frames")), *of_core, of("--order") == "scanline", keys)
pathlib.Path(of("--out")).mkdir(exist_ok=True)
pathlib.Path(of("--json")).write_text(json.dumps(walk))
"""

# Stands in for scripts/configuration: with --verilog a folder that holds the keys, else a model that is
# a file with them.
CONFIGURATION = """#!/usr/bin/python3
import pathlib, shutil, sys
words = sys.argv[1:]
out = pathlib.Path(words[words.index("--out") + 1])
verilog = "--verilog" in words
with pathlib.Path("ran").open("a") as file:
    file.write(f"configuration {out.parent.name}\\n" if verilog else f"model {out.stem}\\n")
if pathlib.Path("fail_configuration").exists() and verilog:
    sys.exit("configuration: this unit cannot be lowered")
if pathlib.Path("fail_model").exists() and out.name == "wide-pipelines2.so":
    sys.exit("configuration: cannot be built")
if verilog:
    out.mkdir(parents=True)
shutil.copyfile(words[0], out / "keys.json" if verilog else out)
"""

# Stands in for scripts/variant_gates.
GATES = """#!/usr/bin/python3
import json, pathlib, sys
sys.path.insert(0, {scripts!r})
from dynrt_tools.hardware_report import example
keys = json.loads((pathlib.Path(sys.argv[1]) / "keys.json").read_text())
pathlib.Path("ran").open("a").write(f"gates {{pathlib.Path(sys.argv[1]).parent.name}}\\n")
pathlib.Path(sys.argv[2]).write_text(json.dumps(example.gates_of(keys)))
"""


def report(**changes: Any) -> Json:
    """A report of two scenes, of a configuration with curves and of one without, as collect() makes
    it of these frames."""
    configurations = {"wide": configuration(4, 2), "narrow": configuration(2, 2, curves=False)}
    made: Json = {
        "size": "32x24",
        "frames": FRAMES,
        "figures": [figure.name for figure in figures.FIGURES],
        "reading": ["how </script> it is read"],
        "scenes": {"cistern": {"about": "a level"}, "lamps": {"about": "three lamps"}},
        "configurations": {},
        "table": [],
        "additions": [],
        "runs": [],
        "missing": [],
    }
    for name, one in configurations.items():
        keys = one["keys"]
        cores = gate_jobs.cores(name, keys, one["curves"]).values()
        counted = [(core, gates_of(core)) for core in cores]
        whole = gate_jobs.of_core(keys, counted[0][1], gate_jobs.split(counted))
        made["configurations"][name] = {
            **keys,
            "curves": one["curves"],
            "clock": "at 100 MHz, placed",
            "gates": whole,
        }
        for scene in made["scenes"]:
            for point in one["points"]:
                changed = {**keys, **points.keys_of(point)}
                own = gate_jobs.of_core(changed, gates_of(changed), None)
                found = rows.figures_of(frame_at(point), own if changed != keys else whole)
                made["runs"].append(rows.row(scene, name, point, found))
                if point == points.own_point(keys):
                    made["table"].append(table_row(scene, name, keys, found))
    made["findings"] = findings.of(made)
    return {**made, **changes}
