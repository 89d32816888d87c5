# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""From the needs of a scene to the configuration made for it: what is measured, and in which
order."""

import argparse
import contextlib
import hashlib
import json
import os
import pathlib
import subprocess
from collections.abc import Iterable, Iterator

from dynrt_tools.build import configs
from dynrt_tools.project import SCRIPTS, Failed, Json, read_json, show_progress, write_json
from dynrt_tools.experiments.output import scene_name, scene_path
from dynrt_tools.experiments.jobs import hashed
from dynrt_tools.specialise import analyst, choose_format, curve, decisions, flags, layout


class Project:
    """Runs the program and scripts/configuration for one scene."""

    def __init__(self, args: argparse.Namespace) -> None:
        self.args = args
        self.scene = scene_path(args.scene)
        self.name = scene_name(args.scene)
        self.out = args.out or pathlib.Path(f"{self.name}.specialised")
        self.seen = flags.passed_on(args, of_frame=True)
        self.build = read_json(pathlib.Path(args.build))
        self.analyst: analyst.Analyst

    @contextlib.contextmanager
    def asking(self) -> Iterator[None]:
        """While the program answers."""
        command = [self.args.program, "needs", self.scene, *self.seen]
        command += [*flags.passed_on(self.args, of_frame=False), "--answer"]
        with analyst.above() if self.args.for_program else analyst.started(command) as answering:
            self.analyst = answering
            yield

    def meter(self, configuration: pathlib.Path, verilog: pathlib.Path) -> curve.Meter:
        return curve.Meter(self.analyst, configuration, verilog, show_progress)

    def made(self, configuration: pathlib.Path, *kind: str) -> pathlib.Path:
        """The path of the result of scripts/configuration for a file."""
        result = subprocess.run(
            [
                SCRIPTS / "configuration",
                configuration,
                *kind,
                "--build",
                self.args.build,
                "--expect",
                self.args.expect,
                "--jobs",
                str(self.args.jobs),
                "--for-program",
            ],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            text=True,
            check=False,
        )
        if result.returncode != 0:
            raise Failed(result.stdout.strip() or "scripts/configuration failed")
        return pathlib.Path(result.stdout.strip())

    def key(self, needs: Json, general: Json, formats: decisions.Measured) -> str:
        """Of all that the configuration depends on."""
        args = self.args
        said = {
            "name": self.name,
            "needs": needs,
            "general": general,
            "formats": formats,
            "seen": self.seen,
            "keep": args.keep,
            "slowdown": args.max_slowdown,
            "fingerprint": args.expect,
            "variables": self.build["variables"],
            "program": hashed(pathlib.Path(args.program)),
            "hlsc": hashed(pathlib.Path(self.build["hlsc"])),
        }
        if not os.path.isabs(self.scene):  # a built-in one
            said["scene"] = self.scene
        digest = hashlib.sha256(json.dumps(said, sort_keys=True).encode())
        return f"specialised-{digest.hexdigest()[:40]}"


def analysis_of(entry: pathlib.Path) -> pathlib.Path:
    """In a folder of its own, as the configuration beside it has the name of its scene."""
    return entry / "analysis" / "analysis.json"


def is_whole(entry: pathlib.Path, name: str) -> bool:
    """Whether both files of an entry can be read; not where a machine has lost its power."""
    try:
        for path in (entry / f"{name}.json", analysis_of(entry)):
            read_json(path)
    except (OSError, ValueError):
        return False
    return True


class Specialiser:
    """Writes the configuration of a scene and its analysis into a folder of the cache."""

    def __init__(
        self,
        project: Project,
        general_name: str,
        general: Json,
        needs: Json,
        formats: decisions.Measured,
    ) -> None:
        self.project, self.general_name, self.general = project, general_name, general
        self.formats = formats
        self.needs = needs
        self.keys = configs.load_configurations().KEYS

    def decide(self, measured: decisions.Measured) -> Json:
        return decisions.decide(
            self.keys,
            self.general_name,
            self.general,
            self.needs["keys"],
            measured | self.formats,
            self.project.args.keep,
        )

    def configuration(self, decided: Json) -> Json:
        """Throws Failed if the rules of its keys do not hold."""
        stated = decisions.configuration(self.project.name, self.general_name, decided)
        generate = configs.load_configurations()
        try:
            generate.checked("special", stated)
        except generate.Refused as error:
            raise Failed(str(error)) from error
        return stated

    def __call__(self, folder: pathlib.Path) -> pathlib.Path:
        made = folder / "made"
        made.mkdir()
        path = made / f"{self.project.name}.json"
        measured, figures = self.measured(folder)
        decided = self.decide(measured)
        write_json(path, self.configuration(decided))
        analysis = analysis_of(made)
        analysis.parent.mkdir()
        write_json(
            analysis,
            {
                "general": self.general_name,
                "needs": self.needs["needs"],
                **figures,
                "left_out": decisions.left_out(decided, self.general),
                "configuration": decided,
            },
        )
        return made

    def allowed(self, decided: Json) -> bool:
        try:
            self.configuration(decided)
        except Failed:
            return False
        return True

    def meter(self, folder: pathlib.Path, measured: decisions.Measured) -> curve.Meter:
        """Of a core, of which the folder receives the configuration."""
        folder.mkdir(exist_ok=True)
        path = folder / f"{self.project.name}.json"
        write_json(path, self.configuration(self.decide(measured)))
        return self.project.meter(path, self.project.made(path, "--verilog"))

    def measured(self, folder: pathlib.Path) -> tuple[decisions.Measured, Json]:
        """Nodes of a line, packets and lines, and the figures behind. All else is as it will be."""
        args, most = self.project.args, {k: self.general[k] for k in ("packets", "lines")}
        frame = f"a frame of {args.size or choose_format.SIZE}"
        frame += " at time 0" if self.needs["needs"].get("frames", 1) > 1 else ""
        whole: decisions.Measured = {k: (n, "being measured") for k, n in most.items()}
        decided: decisions.Measured = {}
        figures: Json = {"layouts": {}}
        numbers = self.nodes_of_a_line(whole)
        if numbers:
            layouts, meters = self.layouts(folder, whole, numbers)
            nodes = layout.best(layouts)
            decided = layout.keys(nodes, layout.reason(layouts, nodes, frame))
            figures["layouts"] = {n: costs._asdict() for n, costs in layouts.items()}
            meter = meters[nodes]
        else:
            meter = self.meter(folder / "whole", whole)
        least = self.least_lines(whole | decided)
        counts, figures["curves"] = curve.choose(
            meter, most["packets"], most["lines"], args.max_slowdown, frame, least
        )
        return decided | counts, figures

    def layouts(
        self, folder: pathlib.Path, whole: decisions.Measured, numbers: Iterable[int]
    ) -> tuple[layout.Layouts, dict[int, curve.Meter]]:
        """What a frame takes with so many nodes in a line, and what measured it."""
        meters: dict[int, curve.Meter] = {}

        def frame_of(nodes: int) -> analyst.FrameCosts:
            show_progress(f"making a core whose lines have {nodes} nodes")
            keys = whole | layout.being_measured(nodes)
            meters[nodes] = self.meter(folder / f"{nodes}_nodes", keys)
            return meters[nodes].frame(self.general["packets"], self.general["lines"])

        return layout.measured(frame_of, numbers), meters

    def nodes_of_a_line(self, whole: decisions.Measured) -> list[int]:
        """The numbers among which to choose; none where the memory or the user leaves no choice."""
        if self.general["memory"] == "banks" or "line_nodes" in self.project.args.keep:
            return []
        kind = self.keys["line_nodes"].kind
        return [
            n
            for n in range(kind.low, kind.high + 1)
            if kind.allows(n) and self.allowed(self.decide(whole | layout.being_measured(n)))
        ]

    def least_lines(self, measured: decisions.Measured) -> int:
        """The fewest that the rules allow beside all that is decided."""
        most = int(self.general["lines"])
        fewer = sorted(curve.powers_below(most))
        return next(
            (n for n in fewer if self.allowed(self.decide(measured | {"lines": (n, "tried")}))),
            most,
        )
