# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The table of experiments and the variants that lists state: which are known, and which are
refused."""

import json
import re
import unittest

from dynrt_tools import project, testing
from dynrt_tools.build import configs
from dynrt_tools.docs.results import template_text
from dynrt_tools.experiments import figures, rows, table
from dynrt_tools.project import Failed

THESIS = table.base_configuration("thesis")
LISTED = configs.load_configurations().listed()
REPORT = project.ROOT / "host" / "app" / "report_command.cpp"


class Table(unittest.TestCase):
    def test_the_program_has_each_experiment(self) -> None:
        text = (
            REPORT.read_text(encoding="utf-8").partition("kExperiments[] = {")[2].partition("};")[0]
        )
        self.assertEqual(sorted(re.findall(r'\{"(\w+)",', text)), table.names())

    def test_each_variant_is_a_core_that_there_can_be(self) -> None:
        for name in table.names():
            stated = table.experiment(name)
            found = table.of_experiment(name) if "columns" in stated else {}
            for variant in found.values():
                self.assertTrue(variant.named in LISTED or variant.differs, variant.name)
            for column, relation in stated.get("relations", {}).items():
                self.assertIn(column, stated["columns"])
                self.assertIn(relation["as"], rows.RELATIONS)
                beside = (v.settings.get("beside", {}).get(column) for v in found.values())
                others: list[str | None] = [relation.get("variant"), *beside]
                for other in filter(None, others):
                    self.assertIn(other, found)
            for aim in stated.get("aims", []):
                self.assertIn(aim["variant"], found)
                self.assertIn(aim["figure"], stated["columns"])

    def test_each_core_of_a_figure_or_an_addition_is_one_that_there_can_be(self) -> None:
        check = configs.load_configurations().checked
        for name in figures.TABLE["curves"]:
            own = LISTED[name]
            points = figures.points(own, figures.FIGURES, figures.wanted(name, own))
            for point in points:
                check("one", figures.core_at(own, point))
        for one in figures.ADDITIONS:
            self.assertTrue(one.get("made") or one.get("with") != one.get("without"), one["name"])

    def test_the_pages_have_the_variants(self) -> None:
        for name, page in (("memory", "memory"), ("board_caches", "boards")):
            text = template_text(page)
            for variant in table.of_experiment(name):
                self.assertIn(f"{name}:rows/{variant}+", text)

    def test_those_of_the_error_report_go_through_the_formats(self) -> None:
        path = table.FOLDER / "error.json"
        listed = table.with_reference(path, THESIS, "thesis", False)
        for key, least in (
            ("mantissa_bits", {8, 10, 12, 14, 16, 18, 20, 23}),
            ("exponent_bits", {5, 6, 7, 8}),
        ):
            self.assertLessEqual(least, {v.configuration[key] for v in listed.values()})
        tests = {v.configuration["triangle_test"] for v in listed.values()}
        self.assertEqual(tests, {"unit_triangle", "watertight"})
        self.assertEqual((listed["m16"].named, listed["m16_fast"].named), ("thesis", "fast"))
        self.assertEqual(listed["m14_fast"].named, "")


class Variants(testing.InFolder):
    def read(self, text: str | project.Json, own: bool = True) -> dict[str, table.Variant]:
        path = self.folder / "v.json"
        path.write_text(text if isinstance(text, str) else json.dumps(text), encoding="utf-8")
        return table.with_reference(path, THESIS, "thesis", own)

    def assert_refused(self, text: str | project.Json, sentence: str) -> None:
        with self.assertRaises(Failed) as caught:
            self.read(text)
        self.assertEqual(str(caught.exception), f"{self.folder}/v.json:{sentence}")

    def test_every_key(self) -> None:
        read = self.read({"a": {}, "b": {"mantissa_bits": 10}})
        self.assertEqual(list(read), ["a", "b"])
        self.assertEqual(read["b"].differs, {"mantissa_bits": 10})
        self.assertEqual(read["b"].configuration["mantissa_bits"], 10)
        self.assertEqual(read["b"].configuration["packets"], THESIS["packets"])
        self.assertEqual((read["a"].named, read["b"].named), ("thesis", ""))

    def test_one_like_another_configuration(self) -> None:
        one = self.read({"a": {}, "b": {"like": "fast", "mantissa_bits": 14}})["b"]
        fast = table.base_configuration("fast")
        for key in set(fast) - {"name", "about", "mantissa_bits", "scan_out"}:
            self.assertEqual(one.configuration[key], fast[key], key)
        self.assertEqual(one.configuration["mantissa_bits"], 14)
        self.assert_refused(
            {"a": {}, "b": {"like": "slow"}},
            f" variant 'b': is like 'slow'; the configurations are {', '.join(LISTED)}",
        )

    def test_a_list_of_the_project_leaves_out_what_a_base_excludes(self) -> None:
        whitted = table.base_configuration("whitted")
        path = table.FOLDER / "error.json"
        self.assertNotIn("m16_fast", table.with_reference(path, whitted, "whitted", False))

    def test_refused(self) -> None:
        known = ", ".join(configs.load_configurations().KEYS)
        refused: tuple[tuple[project.Json, str], ...] = (
            (
                {"a": {}, "b": {"mantissa": 10}},
                f" variant 'b': unknown key 'mantissa'; the keys are {known}",
            ),
            (
                {"a": {}, "b": {"packets": 0}},
                " variant 'b': key 'packets' (packets in flight in a pipeline) is 0; it must be a "
                "whole number from 1 to 64",
            ),
            (
                {"a": {}, "b/c": {"packets": 1}},
                " variant 'b/c': is no name; write letters, digits, _, - and ., a letter first",
            ),
            (
                {"b": {"packets": 2}},
                " one variant, and no more, must be {}: that which the others differ from",
            ),
            ({"b": 2}, " must be an object of variants by name, each an object of keys"),
        )
        for text, sentence in refused:
            self.assert_refused(text, sentence)
        self.assert_refused(
            "{", "1: column 2 is no JSON: expecting property name enclosed in double quotes"
        )

    def test_chosen(self) -> None:
        read = self.read({"a": {}, "b": {"packets": 2}, "c": {"packets": 3}})
        self.assertEqual(list(table.chosen(read, ["c"])), ["a", "c"])
        self.assertEqual(list(table.chosen(read, [])), ["a", "b", "c"])
        with self.assertRaisesRegex(Failed, "^--variant d: unknown; the variants are a, b, c$"):
            table.chosen(read, ["d"])

    def test_base(self) -> None:
        with self.assertRaisesRegex(Failed, "^--config x: unknown; the configurations are thesis,"):
            table.base_configuration("x")
        with self.assertRaisesRegex(Failed, "^--config x.so: a library does not hold its keys; "):
            table.base_configuration("x.so")
        path = self.folder / "mine.json"
        keys = {key: value for key, value in THESIS.items() if key != "about"}
        path.write_text(json.dumps(keys | {"packets": 7}), encoding="utf-8")
        self.assertEqual(table.base_configuration(str(path))["packets"], 7)
        path.write_text(json.dumps(keys | {"packets": 99}), encoding="utf-8")
        with self.assertRaisesRegex(
            Failed, f"^--config {path}: line 1: key 'packets' .* is 99; it"
        ):
            table.base_configuration(str(path))


if __name__ == "__main__":
    unittest.main()
