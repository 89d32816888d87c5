# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The fit of a delay model's constants, on times that are made of known ones, and which prediction
belongs to a placed end."""

import random
import unittest

from dynrt_tools import project
from dynrt_tools.hardware import fitting, joining, model_file, rtl_files
from dynrt_tools.hardware.joining import Place
from dynrt_tools.project import Json

BOUNDS = {"clock_overhead": (0.5, 3.0), "lut": (0.5, 2.0), "carry_bit": (0.01, 0.2)}
TRUE = {"clock_overhead": 2.0, "lut": 0.8, "carry_bit": 0.06, "lut_inputs": 4}
START = {"clock_overhead": 1.5, "lut": 1.2, "carry_bit": 0.05, "lut_inputs": 4}


def paths(seed: int = 1) -> list[list[fitting.Counts]]:
    """Of each end two paths, the longer of which counts."""
    random.seed(seed)
    return [
        [
            {
                "clock_overhead": 1.0,
                "lut": random.randrange(1, 6),
                "carry_bit": random.randrange(0, 40),
            }
            for _ in range(2)
        ]
        for _ in range(40)
    ]


def longest(end: list[fitting.Counts], model: fitting.Model) -> float:
    return max(fitting.total(path, model) for path in end)


def evaluate(ends: list[list[fitting.Counts]], factor: float = 1.0) -> "fitting.Evaluate":
    """As hlsc would time the ends; they were placed by TRUE, times a factor."""
    names = list(BOUNDS)

    def samples(model: fitting.Model) -> list[fitting.Sample]:
        models = fitting.beside(model, names)
        return [
            fitting.Sample(
                factor * longest(end, TRUE),
                longest(end, model),
                fitting.counts(model, names, [longest(end, m) for m in models]),
            )
            for end in ends
        ]

    return samples


class Fit(unittest.TestCase):
    def test_it_finds_the_constants(self) -> None:
        found = fitting.fit(evaluate(paths()), START, BOUNDS)
        for name in BOUNDS:
            self.assertAlmostEqual(found[name], TRUE[name], delta=0.03 * TRUE[name], msg=name)
        self.assertEqual(found["lut_inputs"], 4)

    def test_it_stays_within_the_bounds(self) -> None:
        found = fitting.fit(evaluate(paths(), 3.0), START, BOUNDS)
        for name, (least, most) in BOUNDS.items():
            self.assertTrue(least <= found[name] <= most, name)

    def test_a_constant_of_which_no_end_speaks_keeps_its_value(self) -> None:
        ends = [[{**path, "carry_bit": 0.0} for path in end] for end in paths()]
        self.assertEqual(fitting.fit(evaluate(ends), START, BOUNDS)["carry_bit"], 0.05)

    def test_counts_are_those_of_the_longest_path(self) -> None:
        for end in paths(2):
            (sample,) = evaluate([end])(START)
            chosen = max(end, key=lambda path: fitting.total(path, START))
            for name, count in chosen.items():
                self.assertAlmostEqual(sample.counts.get(name, 0), count, delta=0.01)

    def test_counts_of_two_equal_paths_are_those_of_one(self) -> None:
        end = [{"clock_overhead": 1.0, "lut": 3.0}, {"clock_overhead": 1.0, "carry_bit": 72.0}]
        (sample,) = evaluate([end])(START)
        self.assertAlmostEqual(fitting.total(sample.counts, START), 5.1, delta=0.01)

    def test_every_model_is_within_the_bounds_of_its_family(self) -> None:
        models = sorted((project.ROOT / "hls/compiler/delay").glob("*.json"))
        self.assertTrue(models)
        for path in models:
            bounds = fitting.TIMES[path.stem.partition("-")[0]]
            model = model_file.constants(path)
            for name, (least, most) in bounds.items():
                self.assertLess(least, most, (path.name, name))
                self.assertTrue(least <= model[name] <= most, (path.name, name))


def placed(unit: str, signal: str, port: str = "", start: str = "u: a_s0") -> Json:
    first, _, began = start.partition(": ")
    return {
        "unit": unit,
        "signal": signal,
        "port": port,
        "from": {"unit": first, "signal": began},
    }


class Joined(unittest.TestCase):
    JOINED = joining.Joined(
        {"u": "unit", "v": "other"},
        {
            "lines_ram_0": {
                "read_addr": Place("u", "lines_addr_o"),
                "read_en": Place("u", "lines_en_o"),
            }
        },
    )

    def place(self, *words: str) -> object:
        return joining.places(placed(*words), self.JOINED)

    def test_a_register_is_itself(self) -> None:
        self.assertEqual(self.place("u", "near_s3"), [Place("u", "near_s3")])
        self.assertEqual(self.place("v", "count_q"), [Place("v", "count_q")])

    def test_inside_a_fifo_the_path_s_start_decides(self) -> None:
        self.assertEqual(self.place("u", "out_fifo.space_q"), [Place("u", "out_fifo.valid_i")])
        self.assertEqual(self.place("u", "out_fifo.data_q"), [Place("u", "out_fifo.data_i")])
        self.assertEqual(
            self.place("u", "out_fifo.rows", "write_data"), [Place("u", "out_fifo.data_i")]
        )
        self.assertEqual(
            self.place("u", "out_fifo.read_q", "", "v: valid_s1"), [Place("v", joining.READY)]
        )
        self.assertEqual(
            self.place("u", "out_fifo.read_q", "", "x_arbiter: grant_q"), joining.TAKEN
        )
        self.assertEqual(
            self.place("u", "out_fifo.space_q", "", "u: out_fifo.write_q"), joining.POINTERS
        )

    def test_a_ram_by_its_port(self) -> None:
        self.assertEqual(
            self.place("u", "a_ram.exclusive.rows", "write_en"), [Place("u", "a_ram.write_en_i")]
        )
        self.assertEqual(
            self.place("u", "a_ram.read_data_o"),
            [Place("u", "a_ram.read_addr_i"), Place("u", "a_ram.read_en_i")],
        )
        self.assertEqual(
            self.place("lines_ram_0", "any.rows", "read_addr"), [Place("u", "lines_addr_o")]
        )

    def test_a_delay_by_its_ends(self) -> None:
        self.assertEqual(
            self.place("u", "delay_s0_s9.rows", "write_data"), [Place("u", "delay_s0_s9.data_i")]
        )
        self.assertEqual(self.place("u", "delay_s0_s9.data_o"), [Place("u", "delay_s0_s9.data_o")])

    def test_what_no_unit_predicts_has_a_reason(self) -> None:
        reasons = {
            ("u", "near_s3", "reset"): joining.RESET,
            ("wrapper", "fold_q"): joining.WRAPPER,
            ("u", "in_q"): joining.WRAPPER,
            ("counters", "low_q"): joining.COUNTERS,
            ("step_arbiter", "grant_q"): joining.JOIN,
        }
        for words, reason in reasons.items():
            self.assertEqual(self.place(*words), reason)

    def test_the_core_s_rams_are_those_of_units(self) -> None:
        core = joining.Joined.of_core(rtl_files.GENERATED / f"{rtl_files.CORE}.v")
        self.assertIn("mailbox", core.modules)
        self.assertGreater(len(core.rams), 10)
        for ports in core.rams.values():
            self.assertEqual(len(ports), 5)  # what is read comes from the RAM
            for place in ports.values():
                self.assertIn(place.unit, core.modules)


if __name__ == "__main__":
    unittest.main()
