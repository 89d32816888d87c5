# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""What the tests of whole hardware reports share: a folder with programs that only pretend."""

import argparse
import contextlib
import io
import json
from unittest import mock

from dynrt_tools import project, testing
from dynrt_tools.build import fingerprint
from dynrt_tools.hardware_report import example, report
from dynrt_tools.project import Json
from dynrt_tools.report import jobs
from dynrt_tools.report.report import guarded

FRAMES = 6  # of a configuration of 4 packets and 2 lines, as figures_test counts them
# Figures over packets and lines. Each value of the others is a core of its own: four of each of
# two keys, beside a frame of the configuration itself without hit records.
FLAGS = ["7.5", "7.9"]
ALL_FRAMES = FRAMES + 1 + 2 * 4


class Case(testing.InFolder):
    def setUp(self) -> None:
        super().setUp()
        scripts = self.folder / "scripts"
        scripts.mkdir()
        placed = {"scripts": str(project.SCRIPTS)}
        testing.write_program(scripts / "configuration", example.CONFIGURATION)
        testing.write_program(scripts / "variant_gates", example.GATES.format(**placed))
        self.program = self.folder / "dynrt"
        testing.write_program(self.program, example.PROGRAM.format(**placed))
        self.enterContext(mock.patch.object(jobs, "SCRIPTS", scripts))
        self.build = self.folder / "build.json"
        described = {"source": str(self.folder), "identity": {}, "hlsc": "hlsc"}
        self.build.write_text(json.dumps(described), encoding="utf-8")
        for name, keys in {"wide": (4, 2), "narrow": (2, 2)}.items():
            stated = {"like": "thesis", "packets": keys[0], "lines": keys[1]}
            (self.folder / f"{name}.json").write_text(json.dumps(stated), encoding="utf-8")
        self.out, self.work = self.folder / "out", self.folder / "out.work"

    def run_report(self, *scenes: str, **changes: object) -> tuple[int, str]:
        """The exit code and the sentences about what is wrong."""
        args = argparse.Namespace(
            scene=list(scenes),
            program=self.program,
            build=self.build,
            expect=fingerprint.fingerprint(project.read_json(self.build)),
            size="32x24",
            frames=example.FRAMES,
            jobs=2,
            slurm=False,
            out=self.out,
            config=[str(self.folder / "wide.json")],
            table=[str(self.folder / "narrow.json")],
            json=None,
            drawings=None,
            figure=FLAGS,
        )
        for key, value in changes.items():
            setattr(args, key, value)
        (self.work / "ran").unlink(missing_ok=True)
        with contextlib.redirect_stderr(io.StringIO()) as said, contextlib.redirect_stdout(
            io.StringIO()
        ):
            code = guarded(report.run, args)
        return code, said.getvalue()

    def ran(self) -> list[str]:
        path = self.work / "ran"
        return path.read_text(encoding="utf-8").splitlines() if path.exists() else []

    def made(self) -> Json:
        return dict(project.read_json(self.out / "hardware.json"))
