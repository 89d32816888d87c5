#!/usr/bin/env python3
# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Runs hls/configs/generate on configurations that are right, and on every kind that is not."""

import json
import pathlib
import shutil
import subprocess
import tempfile
import unittest

GENERATE = pathlib.Path(__file__).resolve().parent / "generate"
GOOD = {"about": "for the test", "packets": 4, "lines": 16, "stack_depth": 5,
        "exponent_bits": 6, "mantissa_bits": 9, "rounding": "truncate", "epsilon": 0.25,
        "sram_latency": 4}


class Generate(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.json = self.folder / "configs.json"
        self.out = self.folder / "out"

    def run_on(self, text):
        if text is not None:
            self.json.write_text(text, encoding="utf-8")
        return subprocess.run([GENERATE, self.json, self.out], capture_output=True, text=True,
                              check=False)

    def written(self, **keys):
        result = self.run_on(json.dumps({"tiny": GOOD | keys}))
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return (self.out / "tiny.h").read_text(encoding="utf-8")

    def assert_refused(self, text, sentence):
        result = self.run_on(text)
        self.assertEqual(result.stderr, f"{self.json}: {sentence}\n")
        self.assertEqual(result.returncode, 1)
        self.assertFalse(self.out.exists())

    def assert_key_refused(self, key, value, sentence):
        self.assert_refused(json.dumps({"tiny": GOOD | {key: value}}),
                            f"configuration 'tiny': key '{key}' {sentence}")

    def test_struct(self):
        text = self.written()
        self.assertIn("/// for the test\nstruct tiny {\n"
                      "  using Real = hls::Float<6, 9, hls::Rounding::kTruncate>;\n"
                      "  /// packets in flight\n  static constexpr unsigned kPackets = 4;\n", text)
        self.assertIn("static constexpr double kEpsilon = 0.25;", text)
        self.assertIn("static constexpr unsigned kSramLatency = 4;", text)

    def test_defaults(self):
        text = self.written()
        for line in ("unsigned kLights = 0;", "unsigned kReflections = 0;",
                     "Crossing kCrossing = Crossing::kNone;",
                     "TriangleMatrix kTriangleMatrix = TriangleMatrix::kNormalConsistent;",
                     "Primitives kPrimitives = Primitives{.triangle = true, .sphere = false, "
                     ".rectangle = false};", "bool kCounters = true;",
                     "bool kOneColour = false;", "unsigned kTopStackDepth = 31;",
                     "unsigned kLevels = 2;",
                     "unsigned kObjectSlots = 8;", "unsigned kTriangleSlots = 8;",
                     "unsigned kAddressBits = 19;", "unsigned kMatrixBits = 17;",
                     "bool kUncompressed = true;"):
            self.assertIn(f"  static constexpr {line}\n", text)
        config = json.loads((self.out / "configs.json").read_text(encoding="utf-8"))[0]
        self.assertEqual(config["name"], "tiny")
        self.assertEqual(config["rtl"], True)
        self.assertEqual(config["lights"], 0)
        self.assertEqual(config["packets"], 4)

    def test_what_is_stated(self):
        text = self.written(lights=8, reflections=15, crossing="remember", epsilon=0,
                            triangle_matrix="memory_efficient", primitives=["rectangle", "sphere"])
        for line in ("unsigned kLights = 8;", "unsigned kReflections = 15;",
                     "Crossing kCrossing = Crossing::kRemember;", "double kEpsilon = 0.0;",
                     "TriangleMatrix kTriangleMatrix = TriangleMatrix::kMemoryEfficient;",
                     "Primitives kPrimitives = Primitives{.triangle = false, .sphere = true, "
                     ".rectangle = true};"):
            self.assertIn(f"  static constexpr {line}\n", text)

    def test_a_value_may_have_its_reason_beside_it(self):
        text = self.written(lights={"value": 3, "reason": "the scene has 3 lights"},
                            mantissa_bits={"value": 12, "reason": "an error of 1e-3 is allowed"})
        self.assertIn("  static constexpr unsigned kLights = 3;\n", text)
        self.assertIn("hls::Float<6, 12, ", text)
        for stated in ({"value": 3}, {"value": 3, "reason": ""},
                       {"value": 3, "reason": "so", "unit": 1}):
            shutil.rmtree(self.out, ignore_errors=True)
            self.assert_key_refused("lights", stated, f"is {json.dumps(stated)}; write its value, or "
                                    '{"value": ..., "reason": "a sentence"}')

    def test_where_it_is_from_is_text_alone(self):
        text = self.written()
        self.assertEqual(self.written(made_for="office", made_from="thesis"), text)

    def test_files_that_stay_the_same_are_left_alone(self):
        self.written()
        before = (self.out / "tiny.h").stat().st_mtime_ns
        self.run_on(json.dumps({"tiny": GOOD, "other": GOOD | {"packets": 8}}))
        self.assertEqual((self.out / "tiny.h").stat().st_mtime_ns, before)
        self.assertIn("kPackets = 8;", (self.out / "other.h").read_text(encoding="utf-8"))

    def test_values_out_of_range(self):
        self.assert_key_refused("packets", 200, "(packets in flight) is 200; "
                                "it must be a whole number from 1 to 64")
        self.assert_key_refused("lines", 500, "(lines of each cache) is 500; "
                                "it must be a power of two from 1 to 512")
        self.assert_key_refused("stack_depth", -3, "(entries of a packet's stack in an object's tree) is -3; "
                                "it must be a whole number from 1 to 63")
        self.assert_key_refused("sram_latency", 0, "(clocks from an SRAM bank's address to its "
                                "data) is 0; it must be a whole number from 3 to 8")
        self.assert_key_refused("lights", 9, "(passes of light rays from a packet's hits, at most) "
                                "is 9; it must be a whole number from 0 to 8")
        self.assert_key_refused("reflections", 16, "(bounces of a ray, at most) is 16; "
                                "it must be a whole number from 0 to 15")
        self.assert_key_refused("epsilon", -0.5, "(how far outside the unit triangle a hit may "
                                "lie) is -0.5; it must be a number from 0 to 1")
        self.assert_key_refused("epsilon", float("nan"), "(how far outside the unit triangle a "
                                "hit may lie) is NaN; it must be a number from 0 to 1")

    def test_floats_that_are_too_wide(self):
        wide = GOOD | {"exponent_bits": 8, "mantissa_bits": 24}
        self.assert_refused(json.dumps({"wide": wide}),
                            "configuration 'wide': a float of 1 + 8 + 24 = 33 bits; it must have "
                            "32 at most")
        widest = GOOD | {"exponent_bits": 8, "mantissa_bits": 23}
        self.assertEqual(self.run_on(json.dumps({"widest": widest})).returncode, 0)

    def test_values_of_another_type(self):
        self.assert_key_refused("mantissa_bits", "x", "(stored mantissa bits of the float) is "
                                '"x"; it must be a whole number from 8 to 29')
        self.assert_key_refused("packets", True, "(packets in flight) is true; "
                                "it must be a whole number from 1 to 64")
        self.assert_key_refused("packets", 4.0, "(packets in flight) is 4.0; "
                                "it must be a whole number from 1 to 64")
        self.assert_key_refused("rtl", 1, "(whether builds make its Verilog too, not the model "
                                "alone) is 1; it must be true or false")
        self.assert_key_refused("about", "", '(what it is for) is ""; it must be a sentence')
        self.assert_key_refused("lights", None, "(passes of light rays from a packet's hits, at "
                                "most) is null; it must be a whole number from 0 to 8")

    def test_unknown_choices(self):
        self.assert_key_refused("rounding", "up", "(of every operation of the float) is "
                                '"up"; it must be one of nearest_even, truncate')
        self.assert_key_refused("crossing", ["split"], "(what happens to a packet whose rays "
                                'disagree on the nearer child) is ["split"]; it must be one of '
                                "none, split, remember")
        for value in (["cube"], [], ["sphere", "sphere"], "sphere", [["sphere"]]):
            self.assert_key_refused("primitives", value, "(unit objects that are intersected) is "
                                    f"{json.dumps(value)}; it must be a list of one or more of "
                                    "triangle, sphere, rectangle")

    def test_what_a_watertight_test_asks_of_other_keys(self):
        good = {"triangle_test": "watertight", "epsilon": 0.0, "exponent_bits": 7}
        self.assertIn("static constexpr TriangleTest kTriangleTest = TriangleTest::kWatertight;",
                      self.written(**good))
        self.folder.joinpath("out/tiny.h").unlink()
        self.folder.joinpath("out/configs.json").unlink()
        self.out.rmdir()
        for key, value, wants in (
                ("triangle_matrix", "memory_efficient",
                 "normal_consistent, as corners and normal take four columns"),
                ("primitives", ["triangle", "sphere"],
                 '["triangle"], as only triangles are mapped to the ray'),
                ("object_box", "unit", "nodes, as corners are rounded before an object's tree is "
                 "built, not scaled after"),
                ("divider", "reciprocal", "digit_recurrence, as a ray's shear is made of its "
                 "direction, not of reciprocals"),
                ("epsilon", 0.25, "0, as edges are decided exactly"),
                ("exponent_bits", 9, "7 or 8, as ordinary coordinates must not saturate, and a "
                 "product, which takes two bits more, is held in a double by the model")):
            self.assert_refused(json.dumps({"tiny": GOOD | good | {key: value}}),
                                f"configuration 'tiny': with triangle_test \"watertight\" the key "
                                f"'{key}' must be {wants}; it is {json.dumps(value)}")

    def test_one_level(self):
        for key, value, wants in (
                ("object_box", "unit", "nodes, as no object is entered"),
                ("triangle_test", "watertight", "unit_triangle, as a ray's shear is made when it "
                 "enters an object")):
            self.assert_refused(json.dumps({"tiny": GOOD | {"levels": 1, key: value}}),
                                f"configuration 'tiny': with levels 1 the key '{key}' must be "
                                f"{wants}; it is {json.dumps(value)}")
        self.assertIn("unsigned kLevels = 1;", self.written(levels=1, divider="reciprocal"))

    def test_keys(self):
        self.assert_refused(json.dumps({"tiny": GOOD | {"lihgts": 1}}),
                            "configuration 'tiny': unknown key 'lihgts'; the keys are about, "
                            "made_for, made_from, rtl, packets, lines, levels, stack_depth, top_stack_depth, object_slots, "
                            "triangle_slots, exponent_bits, mantissa_bits, rounding, epsilon, "
                            "sram_latency, lights, reflections, scan_out, crossing, object_box, "
                            "divider, triangle_matrix, primitives, triangle_test, address_bits, "
                            "matrix_bits, uncompressed, one_colour, counters")
        self.assert_refused(json.dumps({"tiny": {k: GOOD[k] for k in GOOD if k != "lines"}}),
                            "configuration 'tiny': lacks the key 'lines' (lines of each cache), "
                            "a power of two from 1 to 512")
        self.assert_refused('{"tiny": {"packets": 4, "packets": 8}}',
                            "'packets' is there twice; leave one")

    def test_files_that_are_none(self):
        self.assert_refused(None, "cannot be read: No such file or directory")
        self.assert_refused('{"tiny": {\n', "line 2, column 1 is no JSON: expecting property name "
                            "enclosed in double quotes")
        self.assert_refused("[]", "must be an object of one or more configurations by name")
        self.assert_refused("{}", "must be an object of one or more configurations by name")
        self.assert_refused('{"tiny": 3}',
                            "configuration 'tiny': must be an object of keys, not 3")
        self.assert_refused(json.dumps({"Tiny one": GOOD}), "configuration 'Tiny one': is no name; "
                            "write small letters, digits and _, a letter first")

    def test_a_folder_that_cannot_be_written(self):
        self.out = self.folder / "configs.json" / "out"
        result = self.run_on(json.dumps({"tiny": GOOD}))
        self.assertEqual(result.stderr, f"{self.out}: cannot be written: Not a directory\n")
        self.assertEqual(result.returncode, 1)


if __name__ == "__main__":
    unittest.main()
