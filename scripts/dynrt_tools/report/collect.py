# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Collects the results of an error report's jobs, as README.md says, and writes the report."""

import contextlib
import csv
import errno
import json
import os
import pathlib
import re
import shutil
import tempfile
from collections.abc import Iterator
from typing import Any

from dynrt_tools.hardware.area import FAMILY
from dynrt_tools.hardware.devices import COLUMNS, FAMILIES
from dynrt_tools.project import Failed, Json, read_json
from dynrt_tools.report import page

PICTURES = "pictures"


def collect(
    folder: pathlib.Path, scenes: dict[str, Json], variants: dict[str, Json], size: str
) -> tuple[Json, dict[str, pathlib.Path]]:
    """The content of error.json, and the present place of each picture that it names."""
    report: Json = {
        "size": size,
        "device": FAMILIES[FAMILY]["name"],
        "reference": next(n for n, v in variants.items() if not v["differs"]),
        "scenes": {},
        "variants": {},
        "runs": [],
    }
    pictures = {}
    for name, variant in variants.items():
        hardware = folder / "variants" / name / "hardware.json"
        report["variants"][name] = {
            "differs": variant["differs"],
            "configuration": variant["configuration"],
            **(read_json(hardware) if hardware.exists() else {}),
        }
    for scene in scenes:
        report["scenes"][scene] = {"about": scenes[scene]["about"]}
        for name in variants:
            run = read_json(folder / "scenes" / scene / name / "run.json")
            for kind in ("image", "difference", "truth"):
                picture = folder / "scenes" / scene / name / "pictures" / f"{kind}.png"
                if not picture.exists():
                    continue
                if kind == "truth":
                    goal = f"{PICTURES}/{scene}/truth.png"
                    report["scenes"][scene].setdefault("truth", goal)
                else:
                    suffix = "" if kind == "image" else f".{kind}"
                    goal = run[kind] = f"{PICTURES}/{scene}/{name}{suffix}.png"
                pictures[goal] = picture
            if "clocks" in run:
                run["frame_ms"] = run["clocks"] * clock_ns(report["variants"][name]) / 1e6
            report["runs"].append({"scene": scene, "variant": name, **run})
    return report, pictures


def clock_ns(variant: Json) -> float:
    """The period for which its units are scheduled."""
    return float(variant["schedule"]["clock_ns"])


def measures_of(run: Json) -> dict[str, Any]:
    """Every figure of a run as KIND.NAME."""
    return {
        f"{kind}.{name}": value
        for kind, figures in run.get("measures", {}).items()
        for name, value in figures.items()
    }


def write_csv(path: pathlib.Path, report: Json) -> None:
    keys = list(dict.fromkeys(k for v in report["variants"].values() for k in v["differs"]))
    measures = list(dict.fromkeys(m for run in report["runs"] for m in measures_of(run)))
    with path.open("w", encoding="utf-8", newline="") as file:
        rows = csv.writer(file)
        rows.writerow(
            [
                "scene",
                "variant",
                *keys,
                *COLUMNS,
                "clock_ns",
                "clocks",
                "frame_ms",
                *measures,
                "refused",
            ]
        )
        for run in report["runs"]:
            variant = report["variants"][run["variant"]]
            area, found = variant.get("area", {}), measures_of(run)
            rows.writerow(
                [
                    run["scene"],
                    run["variant"],
                    *(variant["differs"].get(k, variant["configuration"].get(k)) for k in keys),
                    *(area.get(c) for c in COLUMNS),
                    variant.get("schedule", {}).get("clock_ns"),
                    run.get("clocks"),
                    run.get("frame_ms"),
                    *(found.get(m) for m in measures),
                    run.get("refused"),
                ]
            )


AS_IT_WAS = "a report that was there is as it was, and all measurements are kept"
NEW = re.compile(r"\.new(\d+)\.")  # what a process with this number writes first


def not_written(out: pathlib.Path, error: OSError, then: str) -> Failed:
    reason = "the disk is full" if error.errno == errno.ENOSPC else error.strerror
    return Failed(f"--out {out}: cannot be written ({reason}); {then}")


def check_writable(out: pathlib.Path, then: str = AS_IT_WAS) -> None:
    """Refuses a folder that could not be written to, before anything is measured; `then` ends the
    sentence."""
    try:
        out.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(prefix=f".new{os.getpid()}.", dir=out):
            pass
    except OSError as error:
        raise not_written(out, error, then) from error


def remove_left(out: pathlib.Path) -> None:
    """Half-written folders of processes that have ended."""
    for left in out.glob(".new*"):
        process = NEW.match(left.name)
        if process and not pathlib.Path("/proc", process[1]).exists():
            shutil.rmtree(left, ignore_errors=True)


@contextlib.contextmanager
def written_first(out: pathlib.Path, then: str = AS_IT_WAS) -> Iterator[pathlib.Path]:
    """A folder to write to, whose files take the place of those of the same name in `out` when all
    are there: if the disk is full, what was there before stays as it is. `then` says so."""
    try:
        out.mkdir(parents=True, exist_ok=True)
        remove_left(out)
        new = pathlib.Path(tempfile.mkdtemp(prefix=f".new{os.getpid()}.", dir=out))
        try:
            yield new
            # The page last: a reader who finds the new one finds all that it shows.
            files = sorted(
                (p for p in new.rglob("*") if p.is_file()), key=lambda p: (p.suffix == ".html", p)
            )
            for path in files:
                with path.open("rb") as file:
                    os.fsync(file.fileno())
            for path in files:
                goal = out / path.relative_to(new)
                goal.parent.mkdir(parents=True, exist_ok=True)
                path.replace(goal)
        finally:
            shutil.rmtree(new, ignore_errors=True)
    except OSError as error:
        raise not_written(out, error, then) from error


def write(out: pathlib.Path, report: Json, pictures: dict[str, pathlib.Path]) -> None:
    with written_first(out) as new:
        for goal, picture in pictures.items():
            (new / goal).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(picture, new / goal)
        (new / "error.json").write_text(json.dumps(report, indent=1) + "\n", encoding="utf-8")
        write_csv(new / "error.csv", report)
        page.write_page(new / "error.json", new / "error.html")


def scene_path(scene: str) -> str:
    """As the program reads it in any folder: a file's absolute path, or the name of a built-in one,
    which goes before a folder or file of that name."""
    file = pathlib.Path(scene if os.path.isfile(scene) else scene.split(":")[0])
    return os.path.abspath(scene) if file.suffix and file.is_file() else scene


def scene_name(scene: str) -> str:
    """The name of a scene in a report: that of a built-in scene, or of its file."""
    return re.sub(
        r"[^A-Za-z0-9_.-]",
        "_",
        pathlib.Path(scene.split(":")[0]).stem
        + ("_" + scene.split(":")[1] if ":" in scene else ""),
    )
