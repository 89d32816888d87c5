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
GOOD = {
    "about": "for the test",
    "packets": 4,
    "lines": 16,
    "stack_depth": 5,
    "exponent_bits": 6,
    "mantissa_bits": 9,
    "rounding": "truncate",
    "epsilon": 0.25,
    "sram_latency": 4,
}


def listing(keys, name="tiny"):
    """A list of one configuration."""
    return json.dumps([{"name": name} | GOOD | keys])


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
        return subprocess.run(
            [GENERATE, self.json, self.out], capture_output=True, text=True, check=False
        )

    def written(self, **keys):
        result = self.run_on(listing(keys))
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return (self.out / "tiny.h").read_text(encoding="utf-8")

    def assert_refused(self, text, sentence, line=1):
        result = self.run_on(text)
        self.assertEqual(result.stderr, f"{self.json}:{f'{line}:' if line else ''} {sentence}\n")
        self.assertEqual(result.returncode, 1)
        self.assertFalse(self.out.exists())

    def assert_key_refused(self, key, value, sentence):
        self.assert_refused(listing({key: value}), f"configuration 'tiny': key '{key}' {sentence}")

    def test_struct(self):
        text = self.written()
        self.assertIn(
            "/// for the test\nstruct tiny {\n"
            "  using Real = hls::Float<6, 9, hls::Rounding::kTruncate>;\n"
            "  /// packets in flight\n  static constexpr unsigned kPackets = 4;\n",
            text,
        )
        self.assertIn("static constexpr double kEpsilon = 0.25;", text)
        self.assertIn("static constexpr unsigned kSramLatency = 4;", text)

    def test_defaults(self):
        text = self.written()
        for line in (
            "unsigned kLights = 0;",
            "unsigned kReflections = 0;",
            "Crossing kCrossing = Crossing::kNone;",
            "TriangleMatrix kTriangleMatrix = TriangleMatrix::kNormalConsistent;",
            "Primitives kPrimitives = Primitives{.triangle = true, .sphere = false, "
            ".rectangle = false};",
            "bool kCounters = true;",
            "bool kOneColour = false;",
            "unsigned kTopStackDepth = 31;",
            "unsigned kLevels = 2;",
            "unsigned kObjectSlots = 8;",
            "unsigned kTriangleSlots = 8;",
            "unsigned kAddressBits = 19;",
            "unsigned kMatrixBits = 17;",
            "bool kUncompressed = true;",
        ):
            self.assertIn(f"  static constexpr {line}\n", text)
        config = json.loads((self.out / "configs.json").read_text(encoding="utf-8"))[0]
        self.assertEqual(config["name"], "tiny")
        self.assertEqual(config["rtl"], True)
        self.assertEqual(config["lights"], 0)
        self.assertEqual(config["packets"], 4)

    def test_what_is_stated(self):
        text = self.written(
            lights=8,
            reflections=15,
            crossing="remember",
            epsilon=0,
            triangle_matrix="memory_efficient",
            primitives=["rectangle", "sphere"],
        )
        for line in (
            "unsigned kLights = 8;",
            "unsigned kReflections = 15;",
            "Crossing kCrossing = Crossing::kRemember;",
            "double kEpsilon = 0.0;",
            "TriangleMatrix kTriangleMatrix = TriangleMatrix::kMemoryEfficient;",
            "Primitives kPrimitives = Primitives{.triangle = false, .sphere = true, "
            ".rectangle = true};",
        ):
            self.assertIn(f"  static constexpr {line}\n", text)

    def test_a_value_may_have_its_reason_beside_it(self):
        text = self.written(
            lights={"value": 3, "reason": "the scene has 3 lights"},
            mantissa_bits={"value": 12, "reason": "an error of 1e-3 is allowed"},
        )
        self.assertIn("  static constexpr unsigned kLights = 3;\n", text)
        self.assertIn("hls::Float<6, 12, ", text)
        for stated in (
            {"value": 3},
            {"value": 3, "reason": ""},
            {"value": 3, "reason": "so", "unit": 1},
        ):
            shutil.rmtree(self.out, ignore_errors=True)
            self.assert_key_refused(
                "lights",
                stated,
                f"is {json.dumps(stated)}; write its value, or "
                '{"value": ..., "reason": "a sentence"}',
            )

    def test_where_it_is_from_is_text_alone(self):
        text = self.written()
        self.assertEqual(self.written(made_for="office", made_from="thesis"), text)

    def test_files_that_stay_the_same_are_left_alone(self):
        self.written()
        before = (self.out / "tiny.h").stat().st_mtime_ns
        self.run_on(
            json.dumps(
                [
                    {"name": "tiny"} | GOOD,
                    {"name": "other", "like": "tiny", "about": "other", "packets": 8},
                ]
            )
        )
        self.assertEqual((self.out / "tiny.h").stat().st_mtime_ns, before)
        self.assertIn("kPackets = 8;", (self.out / "other.h").read_text(encoding="utf-8"))

    def test_values_out_of_range(self):
        self.assert_key_refused(
            "packets", 200, "(packets in flight) is 200; " "it must be a whole number from 1 to 64"
        )
        self.assert_key_refused(
            "lines", 500, "(lines of each cache) is 500; " "it must be a power of two from 1 to 512"
        )
        self.assert_key_refused(
            "stack_depth",
            -3,
            "(entries of a packet's stack in an object's tree) is -3; "
            "it must be a whole number from 1 to 63",
        )
        self.assert_key_refused(
            "sram_latency",
            0,
            "(clocks from an SRAM bank's address to its "
            "data) is 0; it must be a whole number from 3 to 8",
        )
        self.assert_key_refused(
            "lights",
            9,
            "(passes of light rays from a packet's hits, at most) "
            "is 9; it must be a whole number from 0 to 8",
        )
        self.assert_key_refused(
            "reflections",
            16,
            "(bounces of a ray, at most) is 16; " "it must be a whole number from 0 to 15",
        )
        self.assert_key_refused(
            "epsilon",
            -0.5,
            "(how far outside the unit triangle a hit may "
            "lie) is -0.5; it must be a number from 0 to 1",
        )
        self.assert_key_refused(
            "epsilon",
            float("nan"),
            "(how far outside the unit triangle a "
            "hit may lie) is NaN; it must be a number from 0 to 1",
        )

    def test_floats_that_are_too_wide(self):
        wide = GOOD | {"exponent_bits": 8, "mantissa_bits": 24}
        self.assert_refused(
            listing(wide, "wide"),
            "configuration 'wide': a float of 1 + 8 + 24 = 33 bits; it must have " "32 at most",
        )
        widest = GOOD | {"exponent_bits": 8, "mantissa_bits": 23}
        self.assertEqual(self.run_on(listing(widest, "widest")).returncode, 0)

    def test_values_of_another_type(self):
        self.assert_key_refused(
            "mantissa_bits",
            "x",
            "(stored mantissa bits of the float) is " '"x"; it must be a whole number from 8 to 29',
        )
        self.assert_key_refused(
            "packets",
            True,
            "(packets in flight) is true; " "it must be a whole number from 1 to 64",
        )
        self.assert_key_refused(
            "packets", 4.0, "(packets in flight) is 4.0; " "it must be a whole number from 1 to 64"
        )
        self.assert_key_refused(
            "rtl",
            1,
            "(whether builds make its Verilog too, not the model "
            "alone) is 1; it must be true or false",
        )
        self.assert_key_refused("about", "", '(what it is for) is ""; it must be a sentence')
        self.assert_key_refused(
            "lights",
            None,
            "(passes of light rays from a packet's hits, at "
            "most) is null; it must be a whole number from 0 to 8",
        )

    def test_unknown_choices(self):
        self.assert_key_refused(
            "rounding",
            "up",
            "(of every operation of the float) is "
            '"up"; it must be one of nearest_even, truncate',
        )
        self.assert_key_refused(
            "crossing",
            ["split"],
            "(what happens to a packet whose rays "
            'disagree on the nearer child) is ["split"]; it must be one of '
            "none, split, remember",
        )
        for value in (["cube"], [], ["sphere", "sphere"], "sphere", [["sphere"]]):
            self.assert_key_refused(
                "primitives",
                value,
                "(unit objects that are intersected) is "
                f"{json.dumps(value)}; it must be a list of one or more of "
                "triangle, sphere, rectangle",
            )

    def test_what_a_watertight_test_asks_of_other_keys(self):
        good = {"triangle_test": "watertight", "epsilon": 0.0, "exponent_bits": 7}
        self.assertIn(
            "static constexpr TriangleTest kTriangleTest = TriangleTest::kWatertight;",
            self.written(**good),
        )
        shutil.rmtree(self.out)
        for key, value, wants in (
            (
                "triangle_matrix",
                "memory_efficient",
                "normal_consistent, as corners and normal take four columns",
            ),
            (
                "primitives",
                ["triangle", "sphere"],
                '["triangle"], as only triangles are mapped to the ray',
            ),
            (
                "object_box",
                "unit",
                "nodes, as corners are rounded before an object's tree is "
                "built, not scaled after",
            ),
            (
                "divider",
                "reciprocal",
                "digit_recurrence, as a ray's shear is made of its "
                "direction, not of reciprocals",
            ),
            ("epsilon", 0.25, "0, as edges are decided exactly"),
            (
                "exponent_bits",
                9,
                "7 or 8, as ordinary coordinates must not saturate, and the "
                "model holds a product, which takes two bits more, in a double",
            ),
        ):
            self.assert_refused(
                listing(good | {key: value}),
                f"configuration 'tiny': with triangle_test \"watertight\" the key "
                f"'{key}' must be {wants}; it is {json.dumps(value)}",
            )

    def test_one_level(self):
        for key, value, wants in (
            ("object_box", "unit", "nodes, as no object is entered"),
            (
                "triangle_test",
                "watertight",
                "unit_triangle, as a ray's shear is made when it " "enters an object",
            ),
        ):
            self.assert_refused(
                listing({"levels": 1, key: value}),
                f"configuration 'tiny': with levels 1 the key '{key}' must be "
                f"{wants}; it is {json.dumps(value)}",
            )
        self.assertIn("unsigned kLevels = 1;", self.written(levels=1, divider="reciprocal"))

    def test_keys(self):
        self.assert_refused(
            listing({"lihgts": 1}),
            "configuration 'tiny': unknown key 'lihgts'; the keys are about, "
            "made_for, made_from, rtl, packets, lines, levels, stack_depth, top_stack_depth, object_slots, "
            "triangle_slots, exponent_bits, mantissa_bits, rounding, epsilon, "
            "sram_latency, lights, reflections, scan_out, crossing, object_box, "
            "divider, triangle_matrix, primitives, triangle_test, address_bits, "
            "matrix_bits, uncompressed, one_colour, counters",
        )
        self.assert_refused(
            json.dumps([{"name": "tiny"} | {k: GOOD[k] for k in GOOD if k != "lines"}]),
            "configuration 'tiny': lacks the key 'lines' (lines of each cache), "
            "a power of two from 1 to 512",
        )
        self.assert_refused(
            '[{"name": "tiny",\n "packets": 4,\n "packets": 8}]',
            "'packets' is there twice; leave one",
            line=3,
        )

    def test_files_that_are_none(self):
        self.assert_refused(None, "cannot be read: No such file or directory", line=None)
        self.assert_refused('[{"name":\n', "column 1 is no JSON: expecting value", line=2)
        for text in ("{}", "[]"):
            self.assert_refused(text, "must be a list of one or more configurations", line=None)
        self.assert_refused(
            "[3]", "configuration 1 of the list must be an object with a name", line=None
        )
        self.assert_refused(
            '[\n {"packets": 4}]',
            "configuration 1 of the list must be an object with a name",
            line=2,
        )
        self.assert_refused(
            listing({}, "Tiny one"),
            "configuration 'Tiny one': is no name; "
            "write small letters, digits and _, a letter first",
        )
        self.assert_refused(
            '[{"name": "a", "like": "b"}]',
            "configuration 'a': is like \"b\"; the "
            "configurations before it are none; it is the first",
        )

    def test_a_configuration_is_like_another(self):
        self.run_on(
            json.dumps(
                [
                    {"name": "tiny", "scan_out": True, "lights": 2} | GOOD,
                    {"name": "lit", "like": "tiny", "about": "lit", "lights": 3},
                    {"name": "far", "like": "lit", "about": "far", "packets": 2},
                ]
            )
        )
        tiny, lit, far = json.loads((self.out / "configs.json").read_text(encoding="utf-8"))
        self.assertEqual(
            lit, tiny | {"name": "lit", "about": "lit", "lights": 3, "scan_out": False}
        )
        self.assertEqual(far, lit | {"name": "far", "about": "far", "packets": 2})

    def test_it_is_like_one_that_is_not_there(self):
        first = json.dumps({"name": "tiny"} | GOOD)
        for like, named in (("me", "itself"), ("nobody", '"nobody"'), (3, "3")):
            entry = json.dumps({"about": "me", "name": "me", "like": like}, indent=1)
            self.assert_refused(
                f"[{first},\n{entry}]",
                f"configuration 'me': is like {named}; the " "configurations before it are tiny",
                line=5,
            )
        self.assert_refused(
            f'[{first},\n{{"name": "me", "like": "tiny"}}]',
            "configuration 'me': lacks the key 'about' (what it is for), a " "sentence",
            line=2,
        )
        self.assert_refused(
            f"[{first},\n{first}]", "configuration 'tiny' is there twice; leave " "one", line=2
        )

    def test_a_mistake_names_its_line(self):
        keys = json.dumps(GOOD | {"name": "tiny", "lights": 9}, indent=1)
        self.assert_refused(
            f"[{keys}]",
            "configuration 'tiny': key 'lights' (passes of light rays "
            "from a packet's hits, at most) is 9; it must be a whole number from 0 "
            "to 8",
            line=2 + list(GOOD | {"name": 0, "lights": 0}).index("lights"),
        )

    def test_a_new_key_changes_no_other_file(self):
        """The struct, the object at run time and its JSON have a key once keys.py has it."""
        copy = self.folder / "configs"
        shutil.copytree(GENERATE.parent, copy, ignore=shutil.ignore_patterns("__pycache__"))
        keys = copy / "configurations" / "keys.py"
        text = keys.read_text(encoding="utf-8")
        self.assertIn("KEYS: dict[str, Key] = {\n", text)
        keys.write_text(
            text.replace(
                "KEYS: dict[str, Key] = {\n",
                'KEYS: dict[str, Key] = {\n    "ways": Key(Whole(1, 4), '
                '"kWays", "of each cache", 1),\n',
            ),
            encoding="utf-8",
        )
        subprocess.run([copy / "generate", copy / "configs.json", self.out], check=True)
        self.assertIn(
            "  /// of each cache\n  static constexpr unsigned kWays = 1;\n",
            (self.out / "full.h").read_text(encoding="utf-8"),
        )
        header = (self.out / "core_configuration.h").read_text(encoding="utf-8")
        for line in (
            "unsigned ways{1};",
            "configuration.ways = C::kWays;",
            'visit(ConfigurationKey{"ways", "of each cache", true, false, 1}, ',
        ):
            self.assertIn(line, header)
        self.assertIn(".ways = 1", (self.out / "core_configuration.cpp").read_text("utf-8"))

    def test_a_folder_that_cannot_be_written(self):
        self.out = self.folder / "configs.json" / "out"
        result = self.run_on(listing({}))
        self.assertEqual(result.stderr, f"{self.out}: cannot be written: Not a directory\n")
        self.assertEqual(result.returncode, 1)


if __name__ == "__main__":
    unittest.main()
