# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""A report of a small scene whose jobs run on a Slurm cluster of one node, from the program to the
page.

Usage: python3 -m dynrt_tools.hardware_report.slurm_system_test PROGRAM
"""

import pathlib
import sys
import unittest

from dynrt_tools import testing
from dynrt_tools.project import read_json
from dynrt_tools.report.slurm_cluster import Cluster

PROGRAM = pathlib.Path(sys.argv.pop(1)).resolve()
PACKETS = [1, 2, 4, 8, 16, 24, 32]


class Report(testing.InFolder):
    def test_from_the_program_to_the_page(self) -> None:
        cluster = Cluster(self.folder / "cluster")
        self.addCleanup(cluster.stop)
        cluster.start()
        flags = ("--size", "64x48", "--config", "thesis", "--table", "thesis", "--figure", "7.9")
        command = (PROGRAM, "report", "hardware", "blocks", "--slurm", "--out", "report", *flags)
        result = testing.run(*command, cwd=self.folder, env=cluster.environment)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        report = read_json(self.folder / "report" / "hardware.json")
        self.assertEqual([run["flags"]["packets"] for run in report["runs"]], [32, *PACKETS[:-1]])
        self.assertTrue((self.folder / "report" / "hardware.html").is_file())
        # The Verilog and the gates of three cores, and the frames.
        submitted = list((self.folder / "report.work" / "logs" / "slurm").iterdir())
        self.assertEqual(len(submitted), 6 + len(PACKETS))


if __name__ == "__main__":
    unittest.main()
