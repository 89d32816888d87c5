# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The stages that a log of nextpnr tells of, and that they are shown while it grows."""

import pathlib
import tempfile
import time
import unittest

from dynrt_tools.hardware import placer_log

READ = "Info: Packing constants..\n"
PLACED = """\
Info:     at iteration #1, type ALL: wirelen solved = 12185, spread = 1317539, legal = 1520928; time = 1
Info:     at iteration #2, type TRELLIS_COMB: wirelen solved = 9, spread = 9, legal = 9; time = 1s
"""
REFINED = """\
Info: Running simulated annealing placer for refinement.
Info:   at iteration #1: temp = 0.000000, timing cost = 7511, wirelen = 703067
"""
BEGUN = """\
Info: Routing 141270 arcs.
Info:            |   (re-)routed arcs  |   delta    | remaining|       time spent     |
Info:    IterCnt |  w/ripup   wo/ripup |  w/r  wo/r |      arcs| batch(sec) total(sec)|
"""
ROUTING = """\
Info:       1000 |       43        956 |   43   956 |    140316|       0.53       0.53|
Info:       2000 |      139       1860 |   96   904 |    139461|       0.29       0.82|
"""
NEGOTIATING = """\
Info: Running main router loop...
Info:     iter=1 wires=969219 overused=64484 overuse=71923 archfail=NA
Info:     iter=2 wires=987574 overused=1578 overuse=54458 archfail=NA
"""
ROUTED = "Info: Routing complete.\nInfo: Router1 time 479.00s\n"


class PlacerLog(unittest.TestCase):
    def test_stages(self) -> None:
        log = ""
        for text, stage in (
            (READ, "reading the netlist"),
            (PLACED, "placing, round 1"),
            (REFINED, "refining the placement"),
            (BEGUN, "routing, 141,270 of 141,270 arcs left"),
            (ROUTING, "routing, 139,461 of 141,270 arcs left"),
            (ROUTED, "checking the clocks"),
        ):
            log += text
            self.assertEqual(placer_log.stage(log), stage)

    def test_the_second_router(self) -> None:
        log = REFINED + NEGOTIATING
        said = "routing, round 2: 1,578 wires are shared by several nets"
        self.assertEqual(placer_log.stage(log), said)
        self.assertEqual(placer_log.stage(log + BEGUN + ROUTED), "checking the clocks")

    def test_a_log_is_followed_to_the_end(self) -> None:
        said: list[str] = []
        with tempfile.TemporaryDirectory() as folder:
            log = pathlib.Path(folder, "log")
            with placer_log.followed(log, said.append, 0.01):
                time.sleep(0.05)
                self.assertEqual(said, [], "there is no log yet")
                for text, word in ((READ, "reading"), (PLACED, "placing")):
                    log.write_text(text, encoding="utf-8")
                    self.wait_for(word, said)
            self.assertEqual(said[-1], "")

    def test_a_mistake_ends_it_too(self) -> None:
        said: list[str] = []
        with self.assertRaises(ValueError):
            with placer_log.followed(pathlib.Path("no log"), said.append, 0.01):
                raise ValueError
        self.assertEqual(said, [""])

    def wait_for(self, word: str, said: list[str]) -> None:
        end = time.monotonic() + 30
        while not (said and said[-1].startswith(word)):
            self.assertLess(time.monotonic(), end, said)
            time.sleep(0.01)


if __name__ == "__main__":
    unittest.main()
