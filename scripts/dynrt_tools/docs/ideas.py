# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The data of the page that says what each idea brings: frames of configurations that differ in one
key, rendered on the native model by hlsc's schedules."""

import pathlib
import subprocess
import tempfile

from dynrt_tools import project

DATA = project.ROOT / "docs" / "results" / "data" / "ideas.json"
SIZE = "160x120"
# Scene, configuration and further flags; the page compares those of one scene.
FRAMES: tuple[tuple[str, str, tuple[str, ...]], ...] = (
    ("office", "thesis", ()),
    ("office", "compact", ()),
    ("conference", "thesis", ()),
    ("conference", "compact", ()),
    ("blocks", "thesis", ()),
    ("blocks", "primitives", ()),
    ("lamps", "whitted_naive", ("--reflections", "3")),
    ("lamps", "whitted", ("--reflections", "3")),
    ("lamps", "whitted_split", ("--reflections", "3")),
)


# Those of them that are as another configuration but for a key.
VARIANTS = {
    "whitted_naive": {"like": "whitted", "crossing": "none"},
    "whitted_split": {"like": "whitted", "crossing": "split"},
}


def row(scene: str, configuration: str, report: project.Json) -> project.Json:
    """The figures of a frame that the page shows."""
    frame = report["frame"]
    caches = frame["caches"]
    return {
        "scene": scene,
        "configuration": configuration,
        "clocks": frame["cycles"] if frame.get("cycles_by_schedule") else None,
        "nodes fetched": frame["counters"]["node_fetch.transactions"],
        "columns asked for": caches["matrix"]["lookups"],
        "columns in the cache": caches["matrix"]["hit_rate"],
        "columns read": caches["matrix"]["misses"],
        "lines read": sum(cache["misses"] for cache in caches.values()),
    }


def render(
    build: pathlib.Path, scene: str, configuration: str, flags: tuple[str, ...]
) -> project.Json:
    """What dynrt writes about a frame; with its clocks if the build has the schedules."""
    schedules = build / "generated" / configuration
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "frame.json"
        command = [str(build / "dynrt"), "render", scene, "--board", "model", "--size", SIZE]
        named = configuration
        if configuration in VARIANTS:
            named = str(pathlib.Path(folder) / f"{configuration}.json")
            project.write_json(pathlib.Path(named), VARIANTS[configuration])
        command += ["--config", named, "--json", str(path), *flags]
        command += ["--out", str(path.with_suffix(".png"))]
        if schedules.is_dir():
            command += ["--schedule", str(schedules)]
        done = subprocess.run(
            command, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False
        )
        if done.returncode:
            raise project.Failed(f"{' '.join(command)} fails: {done.stderr.strip()}")
        report: project.Json = project.read_json(path)
    return report


def more_nodes(rows: list[project.Json]) -> project.Json:
    """By how much more nodes, in percent, each way to treat crossing rays fetches than none."""
    fetched = {row["configuration"]: row["nodes fetched"] for row in rows}
    none = fetched["whitted_naive"]
    return {
        "remember": 100 * (fetched["whitted"] / none - 1),
        "split": 100 * (fetched["whitted_split"] / none - 1),
    }


def measure(build: pathlib.Path, data: pathlib.Path = DATA) -> None:
    """Renders every frame and keeps its figures."""
    if not (build / "dynrt").exists():
        raise project.Failed(f"{build} has no dynrt; build it, or name another folder with --build")
    rows = []
    for number, (scene, configuration, flags) in enumerate(FRAMES, 1):
        project.show_progress(f"{scene} on {configuration}, frame {number} of {len(FRAMES)}")
        rows.append(row(scene, configuration, render(build, scene, configuration, flags)))
    project.show_progress("")
    project.write_json(data, {"size": SIZE, "crossing": more_nodes(rows), "frames": rows})
