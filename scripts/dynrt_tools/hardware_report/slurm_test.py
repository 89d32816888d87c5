# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Hardware reports whose jobs run on a real Slurm cluster of one node, with programs that only
pretend."""

import multiprocessing
import os
import pathlib
import signal
import tempfile
import threading
import time
import unittest
from unittest import mock

from dynrt_tools.hardware_report.report_case import Case
from dynrt_tools.report.slurm_cluster import Cluster

JOBS = 9  # the Verilog and the gates of three cores, and three frames
LOST = "blocks.wide.packets-1_lines-2_order-morton"


class Slurm(Case):
    cluster: Cluster

    @classmethod
    def setUpClass(cls) -> None:
        super().setUpClass()
        folder = cls.enterClassContext(tempfile.TemporaryDirectory())
        cls.cluster = Cluster(pathlib.Path(folder))
        cls.addClassCleanup(cls.cluster.stop)
        cls.cluster.start()

    def setUp(self) -> None:
        super().setUp()
        self.enterContext(mock.patch.dict(os.environ, self.cluster.environment))
        self.work.mkdir()
        self.hang, self.hanging = self.work / "hang", self.work / "hanging"

    def submit(self) -> tuple[int, str]:
        wide = str(self.folder / "wide.json")
        return self.run_report("blocks", slurm=True, config=[wide], table=[wide], figure=["7.9"])

    def slurm_job(self) -> str:
        """The number of the job that hangs."""
        for _ in range(600):
            if self.hanging.exists() and (number := self.hanging.read_text(encoding="utf-8")):
                return number
            time.sleep(0.1)
        raise AssertionError("no job hangs")

    def test_every_job_is_one_of_slurm(self) -> None:
        self.assertEqual(self.submit(), (0, ""))
        self.assertEqual(len(self.made()["runs"]), 3)
        self.assertEqual(len(list((self.work / "logs" / "slurm").iterdir())), JOBS)
        self.assertEqual(len(self.ran()), JOBS)
        self.assertEqual(self.submit(), (0, ""))
        self.assertEqual(self.ran(), [])

    def test_a_job_that_slurm_ends_is_named_and_the_rest_is_there(self) -> None:
        self.hang.touch()
        end = threading.Thread(target=lambda: self.cluster.command("scancel", self.slurm_job()))
        end.start()
        code, sentences = self.submit()
        end.join()
        self.assertEqual(code, 1)
        first, second = sentences.splitlines()
        self.assertRegex(
            first,
            f"^dynrt: missing: {LOST}: rendering failed: Slurm ended it: JOB [0-9]+ ON node "
            "CANCELLED AT ",
        )
        self.assertEqual(second, "dynrt: missing: blocks, wide: 1 of 3 walks")
        self.assertEqual(len(self.made()["runs"]), 2)
        self.assertIn("Slurm ended it", (self.out / "hardware.html").read_text(encoding="utf-8"))

    def test_interrupted_it_leaves_no_job_and_goes_on(self) -> None:
        self.hang.touch()
        process = multiprocessing.Process(target=self.submit)
        process.start()
        self.slurm_job()
        assert process.pid is not None
        os.kill(process.pid, signal.SIGINT)
        process.join(120)
        self.assertIsNotNone(process.exitcode)
        for _ in range(600):
            if not self.cluster.queue():
                break
            time.sleep(0.1)
        self.assertEqual(self.cluster.queue(), [])
        self.hang.unlink()
        self.assertEqual(self.submit(), (0, ""))
        self.assertLess(len(self.ran()), JOBS)
        self.assertEqual(len(self.made()["runs"]), 3)


if __name__ == "__main__":
    unittest.main()
