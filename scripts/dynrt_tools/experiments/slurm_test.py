# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Jobs on a real Slurm cluster of one node, of a program that only pretends."""

import multiprocessing
import os
import pathlib
import signal
import tempfile
import threading
import time
import unittest
from unittest import mock

from dynrt_tools.experiments.slurm_cluster import Cluster
from dynrt_tools.experiments.workflow import Workflow
from dynrt_tools.experiments.workflow_test import Case


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

    def submit(self) -> list[str]:
        return self.run_jobs(self.job("b", self.job("a")), self.job("c"), slurm=True)

    def wait_for_queue(self, count: int) -> None:
        for _ in range(600):
            if len(self.cluster.queue()) == count:
                return
            time.sleep(0.1)
        self.fail(f"the queue does not come to {count} jobs")

    def test_every_job_is_one_of_slurm(self) -> None:
        self.assertEqual(self.submit(), [])
        self.assertEqual(len(list((self.work / "logs" / "slurm").iterdir())), 3)
        self.assertEqual(sorted(self.ran()), ["a", "b", "c"])
        self.assertEqual(self.submit(), [])
        self.assertEqual(self.ran(), [])

    def test_a_job_that_slurm_ends_is_named_and_the_rest_is_there(self) -> None:
        self.mark("slow", "a")

        def end() -> None:
            self.wait_for_runs(2)
            self.wait_for_queue(1)
            self.cluster.command("scancel", f"--user={self.cluster.user}")

        thread = threading.Thread(target=end)
        thread.start()
        (sentence,) = self.submit()
        thread.join()
        self.assertRegex(
            sentence, "^blocks, a: rendering failed: Slurm ended it: JOB [0-9]+ ON .* CANCELLED AT "
        )
        flow = Workflow(self.work)
        kept = [flow.kept(self.job(word)).exists() for word in ("a", "c")]
        self.assertEqual(kept, [False, True])

    def test_interrupted_it_leaves_no_job_and_goes_on(self) -> None:
        self.mark("slow", "a")
        process = multiprocessing.Process(target=self.submit)
        process.start()
        self.wait_for_runs(2)
        assert process.pid is not None
        os.kill(process.pid, signal.SIGINT)
        process.join(120)
        self.assertIsNotNone(process.exitcode)
        self.wait_for_queue(0)
        (self.work / "slow").unlink()
        self.assertEqual(self.submit(), [])
        self.assertEqual(self.ran()[:2], ["a", "b"])


if __name__ == "__main__":
    unittest.main()
