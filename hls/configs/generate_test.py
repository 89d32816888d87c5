# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""What hls/configs/generate writes of configurations that are right."""

import json
import shutil
import subprocess
import unittest

from generate_case import GENERATE, GOOD, GenerateCase, listing


class Written(GenerateCase):
    def test_struct(self) -> None:
        text = self.written()
        self.assertIn(
            "/// for the test\nstruct tiny {\n"
            "  using Real = hls::Float<6, 9, hls::Rounding::kTruncate>;\n"
            "  /// packets in flight\n  static constexpr unsigned kPackets = 4;\n",
            text,
        )
        self.assertIn("static constexpr double kEpsilon = 0.25;", text)
        self.assertIn("static constexpr unsigned kSramLatency = 4;", text)

    def test_defaults(self) -> None:
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

    def test_what_is_stated(self) -> None:
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

    def test_a_value_may_have_its_reason_beside_it(self) -> None:
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

    def test_where_it_is_from_is_text_alone(self) -> None:
        text = self.written()
        self.assertEqual(self.written(made_for="office", made_from="thesis"), text)

    def test_files_that_stay_the_same_are_left_alone(self) -> None:
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

    def test_a_configuration_is_like_another(self) -> None:
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

    def test_a_new_key_changes_no_other_file(self) -> None:
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


if __name__ == "__main__":
    unittest.main()
