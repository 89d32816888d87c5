# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The jobs of a hardware report: the Snakefile beside this file."""

import json
import pathlib
from collections.abc import Iterable

from dynrt_tools.hardware_report import gates, points
from dynrt_tools.hardware_report.figure import MADE
from dynrt_tools.project import Json
from dynrt_tools.report.jobs import Jobs, write_if_new

SNAKEFILE = pathlib.Path(__file__).resolve().parent / "Snakefile"
DOING = {
    "specialise": "making a core for the scene",
    "verilog": "lowering its units",
    "gates": "counting its gates",
    "model": "building its model",
    "frame": "rendering",
}


def models_of(configurations: dict[str, Json]) -> dict[str, Json]:
    """The keys of every core that points have beside the configurations themselves."""
    return {
        points.core_of(name, point): points.core_at(one["keys"], point)
        for name, one in configurations.items()
        for point in one["points"]
        if points.keys_of(point)
    }


def made_for(scenes: Iterable[str], configurations: dict[str, Json]) -> list[str]:
    """The names of the cores that are made for scenes, whose keys jobs find."""
    return [
        points.core_of(name, point, scene)
        for scene in scenes
        for name, one in configurations.items()
        for point in one["points"]
        if MADE in point
    ]


def cores_of(configurations: dict[str, Json]) -> dict[str, Json]:
    """The keys of every core whose Verilog is needed."""
    of_configurations = {
        name: core
        for configuration, one in configurations.items()
        for name, core in gates.cores(configuration, one["keys"], one["curves"]).items()
    }
    return {**of_configurations, **models_of(configurations)}


def counted(configurations: dict[str, Json]) -> list[str]:
    """The cores of cores_of whose gates are needed."""
    unneeded = {
        points.core_of(name, point)
        for name, one in configurations.items()
        for point in one["points"]
        if not gates.is_counted(points.keys_of(point))
    }
    return [name for name in cores_of(configurations) if name not in unneeded]


def lowered(core: Json) -> Json:
    """The keys of a core's Verilog. Three pipelines count more than a core's counters can, and no unit
    depends on them: so those of several pipelines have none."""
    return {**core, "counters": False} if points.own_value(core, "pipelines") > 1 else core


class Workflow(Jobs):
    """The jobs of these scenes and configurations."""

    def __init__(
        self, folder: pathlib.Path, program: pathlib.Path, build: pathlib.Path, expect: str
    ) -> None:
        super().__init__(SNAKEFILE, DOING, folder, program, build, expect)

    def prepare(
        self, scenes: dict[str, str], configurations: dict[str, Json], size: str, frames: int
    ) -> None:
        """A configuration has its `keys`, how it is `named` for dynrt, whether it has `curves`, and its
        `points`. Each point is measured over so many `frames` of each scene's walk."""
        cores, models = cores_of(configurations), models_of(configurations)
        made = made_for(scenes, configurations)
        for folder, written in (
            ("cores", {name: lowered(core) for name, core in cores.items()}),
            ("models", models),
        ):
            for name, keys in written.items():
                write_if_new(self.folder / folder / f"{name}.json", json.dumps(keys, indent=1))
        every = [point for one in configurations.values() for point in one["points"]]
        self.configure(
            {
                "scenes": scenes,
                "configurations": {
                    name: {
                        "named": one["named"],
                        "points": {
                            points.name_of(p): points.core_of(name, p) for p in one["points"]
                        },
                    }
                    for name, one in configurations.items()
                },
                "cores": [*cores, *made],
                "counted": [*counted(configurations), *made],
                "models": [*models, *made],
                "flags": {points.name_of(p): points.flags_of(p) for p in every},
                "size": size,
                "frames": frames,
            }
        )
