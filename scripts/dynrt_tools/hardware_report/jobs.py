# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The jobs of a hardware report: the Snakefile beside this file."""

import json
import pathlib

from dynrt_tools.hardware_report import figures, gates
from dynrt_tools.project import Json
from dynrt_tools.report.jobs import Jobs, write_if_new

SNAKEFILE = pathlib.Path(__file__).resolve().parent / "Snakefile"
DOING = {
    "verilog": "lowering its units",
    "gates": "counting its gates",
    "frame": "rendering",
}


def cores_of(configurations: dict[str, Json]) -> dict[str, Json]:
    """The keys of every core whose Verilog is needed."""
    return {
        name: core
        for configuration, one in configurations.items()
        for name, core in gates.cores(configuration, one["keys"], one["curves"]).items()
    }


def points_of(one: Json) -> list[figures.Point]:
    """The frames of a configuration: those of the figures, or its own alone."""
    return figures.points(one["keys"]) if one["curves"] else [figures.own_point(one["keys"])]


class Workflow(Jobs):
    """The jobs of these scenes and configurations."""

    def __init__(
        self, folder: pathlib.Path, program: pathlib.Path, build: pathlib.Path, expect: str
    ) -> None:
        super().__init__(SNAKEFILE, DOING, folder, program, build, expect)

    def prepare(self, scenes: dict[str, str], configurations: dict[str, Json], size: str) -> None:
        """A configuration has its `keys`, how it is `named` for dynrt, and whether it has `curves`."""
        cores = cores_of(configurations)
        for name, core in cores.items():
            write_if_new(self.folder / "cores" / f"{name}.json", json.dumps(core, indent=1))
        points = {name: points_of(one) for name, one in configurations.items()}
        flags = {figures.name_of(p): figures.flags_of(p) for all_ in points.values() for p in all_}
        self.configure(
            {
                "scenes": scenes,
                "configurations": {
                    name: {
                        "named": one["named"],
                        "points": [figures.name_of(p) for p in points[name]],
                    }
                    for name, one in configurations.items()
                },
                "cores": list(cores),
                "flags": flags,
                "size": size,
            }
        )
