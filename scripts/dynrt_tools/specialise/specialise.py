# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Makes the smallest core that renders a scene: `dynrt specialise`, and --specialise of the
commands that render, for which it prints the path of the configuration."""

import argparse
import math
import os
import pathlib
import shutil
import sys
import tempfile

from dynrt_tools.build.cache import BuildCache
from dynrt_tools.build.whole import require_whole
from dynrt_tools.project import Failed, Json, read_json, show_progress, write_json
from dynrt_tools.experiments.output import check_writable, written_first
from dynrt_tools.experiments.command import guarded
from dynrt_tools.experiments.table import base_configuration
from dynrt_tools.specialise import choose_format, costs, decisions, flags, table
from dynrt_tools.specialise.specialiser import Project, Specialiser, analysis_of, is_whole

DELIVERED = (".v", ".vh", ".json", ".txt")  # of a core's folder; the rest is of its build alone


def general_core(project: Project) -> tuple[str, Json, Json, str, decisions.Measured]:
    """Name and keys of the configuration to start from, what the scene needs of it, and what is
    decided of the float."""
    args, formats = project.args, {}
    needs, about = project.analyst.needs(args.config)
    name = needs["general"]
    general = base_configuration(name)
    if name.endswith(".json"):
        name = os.path.abspath(name)
    if args.max_error is not None:
        formats = choose_format.chosen(args, name, project.scene, project.out)
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / f"{decisions.called(name)}.json"
            write_json(path, general | {key: value for key, (value, _) in formats.items()})
            needs, about = project.analyst.needs(path)
    needs["general"] = name
    return name, general, needs, about, formats


def add_costs(project: Project, result: Json, special: pathlib.Path, general: Json) -> pathlib.Path:
    """Area, gates, stages and clocks of both cores; gives the folder with the made one's
    Verilog."""
    args = project.args
    of = {}
    with tempfile.TemporaryDirectory() as work:
        whole = pathlib.Path(work) / "general.json"
        write_json(whole, general)
        for name, path in (("general", whole), ("special", special)):
            verilog = project.made(path, "--verilog")
            meter = project.meter(path, verilog)
            read = read_json(path)
            packets, lines = (decisions.plain(read[key]) for key in ("packets", "lines"))
            of[name] = {"clocks": meter.clocks(packets, lines)}
            if args.hardware:
                of[name] |= costs.costs_of(verilog, args.device[0], args.jobs, show_progress)
    result["costs"] = of | {"less": costs.less(of["general"], of["special"])}
    return verilog


def check_outputs(out: pathlib.Path, figures: pathlib.Path | None) -> None:
    """Refuses outputs that could not be written, before the work."""
    if figures and not figures.absolute().parent.is_dir():
        raise Failed(
            f"--json {figures}: there is no folder '{figures.parent}'; create it or name "
            "a file elsewhere"
        )
    if figures and figures.is_dir():
        raise Failed(f"--json {figures}: is a folder; name a file")
    new = not out.exists()
    check_writable(out, "name a folder elsewhere")
    if new:
        out.rmdir()


def delivered(verilog: pathlib.Path) -> list[str]:
    """Names of the files in a core's folder that are of use without the build."""
    return sorted(path.name for path in verilog.iterdir() if path.suffix in DELIVERED)


def written_earlier(out: pathlib.Path) -> list[str]:
    """Names of the files in the folder's verilog/ that an earlier run has written."""
    try:
        listed = read_json(out / "analysis.json")["verilog"]
        return [name for name in listed if pathlib.Path(name).name == name]
    except (OSError, ValueError, LookupError, TypeError):
        return []


def write_figures(path: pathlib.Path, data: object) -> None:
    """As a whole, so that a full disk leaves the file that was there."""
    path = path.resolve()
    if path.exists() and not path.is_file():  # a pipe
        write_json(path, data)
        return
    part = path.with_name(f"{path.name}.{os.getpid()}")
    try:
        write_json(part, data)
        part.replace(path)
    finally:
        part.unlink(missing_ok=True)


def deliver(
    out: pathlib.Path, configuration: pathlib.Path, verilog: pathlib.Path, result: Json
) -> None:
    """Writes the folder, and removes the files that an earlier core with other units has left."""
    result["verilog"] = delivered(verilog)
    earlier = written_earlier(out)
    with written_first(
        out, "the files that were there are as they were, and the cache keeps the decisions"
    ) as new:
        shutil.copyfile(configuration, new / "configuration.json")
        write_json(new / "analysis.json", result)
        (new / "verilog").mkdir()
        for name in result["verilog"]:
            shutil.copyfile(verilog / name, new / "verilog" / name)
    for name in earlier:
        if name not in result["verilog"]:
            (out / "verilog" / name).unlink(missing_ok=True)


def finish(project: Project, name: str, general: Json, about: str, entry: pathlib.Path) -> None:
    """Prints and delivers a configuration that the cache holds."""
    args = project.args
    result = read_json(analysis_of(entry))
    result["curves"] = {
        name: {int(n): clocks for n, clocks in points.items()}
        for name, points in result["curves"].items()
    }
    result["layouts"] = {int(n): costs for n, costs in result["layouts"].items()}
    out, special = project.out, entry / f"{project.name}.json"
    verilog = add_costs(project, result, special, general)
    misfit = args.hardware and costs.misfits(
        verilog, result["costs"]["special"], args.device, args.jobs, show_progress
    )
    show_progress("")
    deliver(out, special, verilog, result)
    if args.json:
        write_figures(args.json, result)
    print(
        table.page(about, decisions.called(name), general, result)
        + f"written     {out}/configuration.json, analysis.json and verilog"
    )
    if misfit:
        raise Failed(f"the core made for {project.name} fits no device asked for: {misfit}")


def run(args: argparse.Namespace) -> int:
    project = Project(args)
    require_whole(project.build, "specialising a core", "hlsc")
    costs.check_devices(args.device)
    if args.jobs < 1:
        raise Failed(f"--jobs {args.jobs}: at least one is needed")
    if not 0 <= args.max_slowdown < math.inf:
        raise Failed(f"--max-slowdown {args.max_slowdown:g}: a part in percent, 0 or more")
    choose_format.check(args)
    if not args.for_program:
        check_outputs(project.out, args.json)
    if args.max_error is not None or args.hardware and not args.for_program:
        costs.check_tools()
    with project.asking():
        make(project)
    return 0


def make(project: Project) -> None:
    """The configuration, and what the command is to do with it."""
    args = project.args
    name, general, needs, about, formats = general_core(project)
    entry = BuildCache().get(
        project.key(needs, general, formats),
        Specialiser(project, name, general, needs, formats),
        lambda: show_progress("another program builds it; waiting"),
        lambda entry: is_whole(entry, project.name),
    )
    show_progress("")
    if args.for_program:
        print(entry / f"{project.name}.json")
        return
    finish(project, name, general, about, entry)


def for_program(args: argparse.Namespace) -> int:
    """As scripts/configuration does: a mistake in place of the path."""
    try:
        return run(args)
    except Failed as error:
        print(error)
    except OSError as error:
        print(f"{error.filename or args.scene}: {error.strerror}")
    return 1


def main() -> int:
    args = flags.parse(sys.argv[1:])
    return for_program(args) if args.for_program else guarded(run, args)
