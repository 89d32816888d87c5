# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Runs an experiment for `dynrt report`: its jobs, and the files that it writes."""

import argparse
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from dynrt_tools.build import fingerprint
from dynrt_tools.build.whole import require_whole
from dynrt_tools.command import INTERRUPTED
from dynrt_tools.experiments import drawing, error, figures, hardware, output, page, rows, table
from dynrt_tools.experiments.flags import MISTAKE, parse
from dynrt_tools.experiments.jobs import File, Job, Maker, Word
from dynrt_tools.experiments.output import scene_name, scene_path
from dynrt_tools.experiments.workflow import Workflow
from dynrt_tools.hardware.placed_clocks import without_rates
from dynrt_tools.project import Failed, Json, read_json, show_progress, write_rows

MISSING = 1  # the exit code
LISTS = ("rows", "aims", "budget", "table", "findings", "additions", "runs")


# ---- Before the work ----


def check(args: argparse.Namespace, work: str, parts: str) -> None:
    """Refuses flags that no job could be run with, or a build that lacks parts that `work`
    needs."""
    if args.jobs < 1:
        raise Failed(f"--jobs {args.jobs}: at least one is needed")
    build = read_json(args.build)
    require_whole(build, work, parts)
    if fingerprint.fingerprint(build) != args.expect:
        raise Failed("the sources have changed since this program was built; build it again")


def describe(program: pathlib.Path, scene: str, size: str) -> str:
    """A scene in a line; refuses one that dynrt does not read, or pictures of this size."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "info.json"
        command = [str(program), "info", scene, "--size", size, "--json", str(path)]
        result = subprocess.run(command, capture_output=True, text=True, check=False)
        if result.returncode != 0:
            raise Failed(result.stderr.strip().removeprefix("dynrt: "))
    line = next((x for x in result.stdout.splitlines() if x.startswith("scene ")), scene)
    return line.removeprefix("scene").strip()


@dataclass
class Session:
    """What the measuring of an experiment needs."""

    args: argparse.Namespace
    maker: Maker
    flow: Workflow
    scenes: Json  # by the names that a report gives them: path, and a line about each

    def words(self) -> dict[str, Word]:
        """The scenes as commands take them: a file's content decides what is measured."""
        found: dict[str, Word] = {}
        for name, scene in self.scenes.items():
            path, _, part = scene["path"].partition(":")
            file = pathlib.Path(scene["path"])
            if file.is_absolute():
                whole = file.is_file()
                found[name] = File(
                    file if whole else pathlib.Path(path), "" if whole else f":{part}"
                )
            else:
                found[name] = scene["path"]
        return found

    def run(self, goals: Sequence[Job]) -> list[str]:
        return self.flow.run(goals, self.args.jobs, self.args.slurm)


def session(args: argparse.Namespace, scenes: Sequence[str]) -> Session:
    known: Json = {}
    for scene in scenes:
        path, name = scene_path(scene), scene_name(scene)
        if name in known:
            raise Failed(
                f"{scene}: another scene of this report has the same name, '{name}'; make two reports"
            )
        known[name] = {"path": path, "about": describe(args.program, path, args.size)}
    output.check_writable(args.out)
    folder = args.out.absolute().with_name(args.out.name + ".work")
    maker = Maker(args.program.resolve(), args.build.resolve(), args.expect)
    return Session(args, maker, Workflow(folder), known)


# ---- The experiments ----


@dataclass
class Made:
    """A report, and the forms in which it is written."""

    report: Json
    kept: Json  # what the documents keep
    lines: list[Json]  # of the CSV
    page: Json
    text: str
    missing: Sequence[str] = ()
    pictures: dict[str, pathlib.Path] | None = None


def measured(args: argparse.Namespace, scenes: Sequence[str]) -> Json:
    """An error report in which nothing is missing; throws Failed for the first job that fails."""
    made = error_report(args, scenes, True)
    for sentence in made.missing:
        raise Failed(sentence)
    return made.report


def error_report(args: argparse.Namespace, scenes: Sequence[str], with_hardware: bool) -> Made:
    variants = error.variants_of(args)
    check(args, "measuring variants", "hlsc, CGAL and Embree")
    work = session(args, scenes)
    found = error.Experiment(work.maker, work.words(), variants, args.size, with_hardware)
    with work.flow.alone():
        missing = work.run(found.goals)
        report, pictures = found.collected(work.flow, work.scenes)
    report["missing"] = missing
    runs = report["runs"]
    refused = [run for run in runs if "refused" in run]
    if len(refused) == len(runs):
        first = missing[0] if missing else refused[0]["refused"]
        raise Failed(f"no variant can render any of the scenes; {first}")
    said = [f"{one['variant']}: not with {one['scene']}: {one['refused']}" for one in refused]
    said.append(
        f"{len(runs) - len(refused)} frames of {len(report['variants'])} variants and "
        f"{len(report['scenes'])} scenes"
    )
    kept = error.kept(report)
    shown = error.shown(kept, missing)
    return Made(report, kept, error.csv_rows(report), shown, "\n".join(said), missing, pictures)


def hardware_report(args: argparse.Namespace) -> Made:
    if not 1 <= args.frames <= hardware.MOST_FRAMES:
        raise Failed(
            f"--frames {args.frames}: a report's walk has 1 to {hardware.MOST_FRAMES} frames"
        )
    drawn = hardware.figures_of(args.figure)
    configurations = hardware.configurations_of(args, drawn)
    check(args, "a hardware report", "hlsc")
    work = session(args, args.scene)
    names = [figure["name"] for figure in drawn]
    names += [figures.ADDED] if not args.figure or figures.ADDED in args.figure else []
    found = hardware.Experiment(
        work.maker, work.words(), configurations, names, args.size, args.frames
    )
    with work.flow.alone():
        missing = work.run(found.goals)
        report = found.collected(work.flow, work.scenes)
    report["missing"] = missing + report["missing"]
    if not report["runs"]:
        raise Failed(f"there is no walk to report; {report['missing'][0]}")
    said = f"{len(report['runs'])} walks with {len(report['configurations'])} configurations"
    return Made(
        report,
        report,
        hardware.csv_rows(report),
        hardware.shown(report),
        f"{said} through {len(report['scenes'])} scenes",
        report["missing"],
    )


def build_target(build: pathlib.Path, target: str) -> None:
    """Makes a target of the build that an experiment's programs come from."""
    show_progress(f"building {target}")
    command = [
        "cmake",
        "--build",
        str(build),
        "--target",
        target,
        "--parallel",
        str(os.cpu_count()),
    ]
    done = subprocess.run(
        command, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False
    )
    show_progress("")
    if done.returncode:
        lines = [line for line in done.stdout.splitlines() if "error" in line.lower()]
        reason = lines[0].strip() if lines else "cmake says no more"
        raise Failed(f"{build}: {target} cannot be built: {reason}")


def rows_report(name: str, args: argparse.Namespace) -> Made:
    stated, variants = table.experiment(name), table.of_experiment(name)
    for one in args.variant:
        if one not in variants:
            raise Failed(f"--variant {one}: unknown; the variants are {', '.join(variants)}")
    variants = {n: v for n, v in variants.items() if not args.variant or n in args.variant}
    check(args, f"the experiment {name}", "hlsc")
    work = session(args, args.scene)
    if "target" in stated:
        build_target(args.program.resolve().parent, stated["target"])
    jobs = rows.jobs_of(work.maker, stated, variants, work.words(), args.size)
    with work.flow.alone():
        missing = work.run(list(jobs.values()))
        report = rows.collected(stated, variants, jobs, work.flow, args.size)
    if not report["rows"]:
        raise Failed(
            f"there is no frame to report; {missing[0] if missing else 'no variant is asked'}"
        )
    lines = [{k: v for k, v in row.items() if k != "frame"} for row in report["rows"]]
    shown = rows.shown(name, stated, variants, report, work.scenes, missing)
    return Made(report, report, lines, shown, rows.text(stated, report), missing)


# ---- What is written ----


def write(name: str, args: argparse.Namespace, made: Made) -> None:
    """The page, CSV and JSON of a report, its pictures, and what the flags ask for more."""
    with output.written_first(args.out) as new:
        for goal, picture in (made.pictures or {}).items():
            (new / goal).parent.mkdir(parents=True, exist_ok=True)
            (new / goal).write_bytes(picture.read_bytes())
        data = error.with_pictures(made.page, made.report, new) if made.pictures else made.page
        write_rows(new / f"{name}.json", made.report, *(k for k in LISTS if k in made.report))
        output.write_csv(new / f"{name}.csv", made.lines)
        (new / f"{name}.html").write_text(page.page(data), encoding="utf-8")
    if args.json:
        kept = without_rates(made.kept)
        assert isinstance(kept, dict)
        write_rows(args.json, kept, *(k for k in LISTS if k in kept))
    if args.drawings:
        for file, text in drawing.drawings(made.page).items():
            (args.drawings / file).write_text(text, encoding="utf-8")


def run(name: str, args: argparse.Namespace) -> int:
    output.check_folder("--json", args.json, args.json and args.json.absolute().parent)
    output.check_folder("--drawings", args.drawings, args.drawings)
    if name == "error":
        made = error_report(args, args.scene, args.hardware)
    elif name == "hardware":
        made = hardware_report(args)
    else:
        made = rows_report(name, args)
    write(name, args, made)
    for sentence in made.missing:
        print(f"dynrt: missing: {sentence}", file=sys.stderr)
    print(f"{made.text}\n{args.out}/{name}.html, {name}.csv and {name}.json")
    return MISSING if made.missing else 0


def guarded(act: Callable[[argparse.Namespace], int | None], args: argparse.Namespace) -> int:
    """The exit code of a command, whose mistakes are one sentence each."""
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        return act(args) or 0
    except Failed as error_:
        print(f"dynrt: {error_}", file=sys.stderr)
    except OSError as error_:
        print(f"dynrt: {error_.filename or args.out}: {error_.strerror}", file=sys.stderr)
    except KeyboardInterrupt:
        print("\ndynrt: interrupted; the same command goes on from here", file=sys.stderr)
        return INTERRUPTED
    return MISTAKE


def main() -> int:
    """The first word is the name of the experiment."""
    known = table.names()
    if sys.argv[1:2] == ["--list"]:
        print(json.dumps({name: table.experiment(name)["about"] for name in known}))
        return 0
    name = sys.argv[1] if len(sys.argv) > 1 else ""
    if name not in known:
        print(
            f"experiment: '{name}': unknown; the experiments are {', '.join(known)}",
            file=sys.stderr,
        )
        return MISTAKE
    return guarded(lambda args: run(name, args), parse(name, sys.argv[2:]))
