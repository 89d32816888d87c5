# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The jobs of an error report: the Snakefile beside this file."""

import json
import pathlib

from dynrt_tools.project import Failed, Json
from dynrt_tools.report.jobs import Jobs, write_if_new

SNAKEFILE = pathlib.Path(__file__).resolve().parent / "Snakefile"
DOING = {
    "model": "building its model",
    "verilog": "lowering its units",
    "hardware": "synthesizing its units",
    "run": "rendering",
}


class Workflow(Jobs):
    """The jobs of these scenes and variants."""

    def __init__(
        self, folder: pathlib.Path, program: pathlib.Path, build: pathlib.Path, expect: str
    ) -> None:
        super().__init__(SNAKEFILE, DOING, folder, program, build, expect)

    def prepare(
        self, scenes: dict[str, str], variants: dict[str, Json], size: str, hardware: bool
    ) -> None:
        for name, variant in variants.items():
            write_if_new(
                self.folder / "variants" / f"{name}.json",
                json.dumps(variant["configuration"], indent=1),
            )
        self.configure(
            {
                "scenes": scenes,
                "variants": list(variants),
                "size": size,
                "hardware": hardware,
            }
        )

    def run(self, jobs: int, slurm: bool) -> None:
        """Throws Failed for the first job that fails."""
        for sentence in self.failures(jobs, slurm):
            raise Failed(sentence)
