# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The variants of an error report: which files state them, and which are refused."""

import json
import unittest

from dynrt_tools import project, testing
from dynrt_tools.build import configs
from dynrt_tools.project import Failed
from dynrt_tools.report import variants

THESIS = variants.base_configuration("thesis")
LISTED = configs.load_configurations().listed()


class Variants(testing.InFolder):
    def read(self, text: str | project.Json) -> dict[str, project.Json]:
        path = self.folder / "v.json"
        path.write_text(text if isinstance(text, str) else json.dumps(text), encoding="utf-8")
        return variants.read_variants(path, THESIS)

    def assert_refused(self, text: str | project.Json, sentence: str) -> None:
        with self.assertRaises(Failed) as caught:
            self.read(text)
        self.assertEqual(str(caught.exception), f"{self.folder}/v.json:{sentence}")

    def test_every_key(self) -> None:
        read = self.read({"a": {}, "b": {"mantissa_bits": 10}})
        self.assertEqual(list(read), ["a", "b"])
        self.assertEqual(read["b"]["differs"], {"mantissa_bits": 10})
        self.assertEqual(read["b"]["configuration"]["mantissa_bits"], 10)
        self.assertEqual(read["b"]["configuration"]["packets"], THESIS["packets"])
        self.assertEqual(read["b"]["configuration"]["lights"], 0)

    def test_those_of_the_issue_are_listed(self) -> None:
        listed = variants.read_variants(variants.LISTED, THESIS)

        def values(key: str) -> set[object]:
            return {variant["configuration"][key] for variant in listed.values()}

        self.assertLessEqual({8, 10, 12, 14, 16, 18, 20, 23}, values("mantissa_bits"))
        self.assertLessEqual({5, 6, 7, 8}, values("exponent_bits"))
        self.assertEqual({"nearest_even", "truncate"}, values("rounding"))
        self.assertGreaterEqual(len(values("epsilon")), 4)
        self.assertEqual({"thesis", "fast"}, values("datapath"))
        self.assertEqual({"unit_triangle", "watertight"}, values("triangle_test"))

    def test_one_like_another_configuration(self) -> None:
        read = self.read({"a": {}, "b": {"like": "fast", "mantissa_bits": 14}})
        fast = variants.base_configuration("fast")
        own = {"name", "about", "mantissa_bits", "scan_out"}
        for key in set(fast) - own:
            self.assertEqual(read["b"]["configuration"][key], fast[key], key)
        self.assertEqual(read["b"]["configuration"]["mantissa_bits"], 14)
        self.assertEqual(read["b"]["differs"], {"like": "fast", "mantissa_bits": 14})
        whitted = variants.base_configuration("whitted")
        self.assertNotIn("m16_fast", variants.read_variants(variants.LISTED, whitted, True))
        self.assert_refused(
            {"a": {}, "b": {"like": "slow"}},
            f" variant 'b': is like 'slow'; the configurations are {', '.join(LISTED)}",
        )

    def test_a_list_for_every_core_leaves_out_what_one_excludes(self) -> None:
        formats = project.ROOT / "scripts" / "dynrt_tools" / "specialise" / "formats.json"
        watertight = variants.base_configuration("watertight")
        with self.assertRaisesRegex(Failed, "variant 'm14_e6'.*'exponent_bits' must be 7 or 8"):
            variants.read_variants(formats, watertight)
        fast = variants.base_configuration("fast")
        for general in (fast, watertight):
            read = variants.read_variants(formats, general, leave_out=True)
            self.assertLess({"m8", "m16", "m20"}, set(read))
            self.assertNotIn("m14_fast", read)
        whole = variants.read_variants(formats, THESIS, leave_out=True)
        self.assertEqual(whole, variants.read_variants(formats, THESIS))

    def test_refused(self) -> None:
        self.assert_refused(
            {"a": {}, "b": {"mantissa": 10}},
            " variant 'b': unknown key 'mantissa'; the keys are "
            + ", ".join(configs.load_configurations().KEYS),
        )
        self.assert_refused(
            {"a": {}, "b": {"packets": 0}},
            " variant 'b': key 'packets' (packets in flight in a pipeline) is 0; it must be a whole "
            "number from 1 to 64",
        )
        self.assert_refused(
            {"a": {}, "b/c": {"packets": 1}},
            " variant 'b/c': is no name; write letters, digits, _, - and ., a letter first",
        )
        self.assert_refused(
            {"b": {"packets": 2}},
            " one variant, and no more, must be {}: that which the others differ from",
        )
        self.assert_refused(
            {"b": 2}, " must be an object of variants by name, each an object of keys"
        )
        self.assert_refused(
            "{", "1: column 2 is no JSON: expecting property name enclosed in double quotes"
        )

    def test_chosen(self) -> None:
        read = self.read({"a": {}, "b": {"packets": 2}, "c": {"packets": 3}})
        self.assertEqual(list(variants.chosen(read, ["c"])), ["a", "c"])
        self.assertEqual(list(variants.chosen(read, [])), ["a", "b", "c"])
        with self.assertRaisesRegex(Failed, "^--variant d: unknown; the variants are a, b, c$"):
            variants.chosen(read, ["d"])

    def test_base(self) -> None:
        with self.assertRaisesRegex(Failed, "^--config x: unknown; the configurations are thesis,"):
            variants.base_configuration("x")
        with self.assertRaisesRegex(Failed, "^--config x.so: a library does not hold its keys; "):
            variants.base_configuration("x.so")

    def test_base_that_a_file_states(self) -> None:
        path = self.folder / "mine.json"
        keys = {key: value for key, value in THESIS.items() if key != "about"}
        path.write_text(
            json.dumps(keys | {"packets": {"value": 7, "reason": "few"}}), encoding="utf-8"
        )
        listed = self.folder / "variants.json"
        listed.write_text(json.dumps({"a": {}, "b": {"lines": 2}}), encoding="utf-8")
        read = variants.read_variants(listed, variants.base_configuration(str(path)))
        self.assertEqual([v["configuration"]["packets"] for v in read.values()], [7, 7])
        path.write_text(json.dumps(keys | {"packets": 99}), encoding="utf-8")
        with self.assertRaisesRegex(
            Failed, f"^--config {path}: line 1: key 'packets' .* is 99; it must"
        ):
            variants.base_configuration(str(path))


if __name__ == "__main__":
    unittest.main()
