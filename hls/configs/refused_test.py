# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Every kind of configuration that hls/configs/generate refuses, with its sentence."""

import json
import shutil
import unittest

from configurations import GONE, KEYS
from generate_case import GOOD, GenerateCase, listing


class Refused(GenerateCase):
    def test_values_out_of_range(self) -> None:
        self.assert_key_refused(
            "packets",
            200,
            "(packets in flight in a pipeline) is 200; it must be a whole number from 1 to 64",
        )
        self.assert_key_refused(
            "lines",
            500,
            "(lines of each cache; its nodes or entries, where a line has several) is 500; it must be "
            "a power of two from 1 to 512",
        )
        self.assert_key_refused(
            "stack_depth",
            -3,
            f"({KEYS['stack_depth'].about}) is -3; it must be a whole number from 1 to 63",
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
            "(bounces of a ray, at most) is 16; it must be a whole number from 0 to 15",
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
        for clock in (0.5, -1, 101):
            self.assert_key_refused(
                "clock_ns",
                clock,
                "(nanoseconds of the clock that hlsc schedules the units for; 0: those of the build) "
                f"is {clock}; it must be 0 or a number from 1 to 100",
            )

    def test_every_way_has_a_line(self) -> None:
        self.assert_key_refused(
            "ways",
            3,
            "(ways of each cache: lines that an address may lie in; a miss replaces the one that "
            "pseudo-LRU names) is 3; it must be a power of two from 1 to 4",
        )
        for ways, lines in ((2, 1), (4, 2)):
            self.assert_refused(
                listing({"ways": ways, "lines": lines}),
                f"configuration 'tiny': with ways {ways} the key 'lines' must be {ways} or more, "
                f"as a set has a line in each way; it is {lines}",
            )
        self.assertIn("kWays = 4;", self.written(ways=4, lines=4))

    def test_floats_that_are_too_wide(self) -> None:
        wide = GOOD | {"exponent_bits": 8, "mantissa_bits": 24}
        self.assert_refused(
            listing(wide, "wide"),
            "configuration 'wide': a float of 1 + 8 + 24 = 33 bits; it must have 32 at most",
        )
        widest = GOOD | {"exponent_bits": 8, "mantissa_bits": 23}
        self.assertEqual(self.run_on(listing(widest, "widest")).returncode, 0)

    def test_values_of_another_type(self) -> None:
        self.assert_key_refused(
            "mantissa_bits",
            "x",
            '(stored mantissa bits of the float) is "x"; it must be a whole number from 8 to 29',
        )
        self.assert_key_refused(
            "packets",
            True,
            "(packets in flight in a pipeline) is true; it must be a whole number from 1 to 64",
        )
        self.assert_key_refused(
            "packets",
            4.5,
            "(packets in flight in a pipeline) is 4.5; it must be a whole number from 1 to 64",
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

    def test_unknown_choices(self) -> None:
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

    def test_what_a_watertight_test_asks_of_other_keys(self) -> None:
        good = {
            "triangle_test": "watertight",
            "epsilon": 0.0,
            "exponent_bits": 7,
        }
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

    def test_fast_maps_are_of_one_origin(self) -> None:
        good = {
            "triangle_test": "watertight",
            "epsilon": 0.0,
            "exponent_bits": 7,
            "datapath": "fast",
        }
        self.assert_refused(
            listing(good),
            'configuration \'tiny\': with datapath "fast" and triangle_test "watertight" the key '
            "'origins' must be common, as the origin of a packet's rays is subtracted from a "
            'triangle\'s corners once; it is "each"',
        )
        self.assertIn("kWatertight", self.written(**good, origins="common"))

    def test_reflected_rays_have_no_common_origin(self) -> None:
        self.assert_refused(
            listing({"datapath": "fast", "origins": "common", "reflections": 2}),
            "configuration 'tiny': with origins \"common\" the key 'reflections' must be 0, as the "
            "reflected rays of a packet start at points of their own; it is 2",
        )
        self.assertIn("kCommon", self.written(datapath="fast", origins="common", lights=2))

    def test_a_common_origin_is_of_the_fast_datapath(self) -> None:
        self.assert_refused(
            listing({"origins": "common"}),
            "configuration 'tiny': with origins \"common\" the key 'datapath' must be fast, as a "
            'slice that divides subtracts the origin of its ray itself; it is "thesis"',
        )

    def test_the_main_object_comes_by_a_list(self) -> None:
        self.assert_refused(
            listing({"main_first": True}),
            "configuration 'tiny': with main_first true the key 'datapath' must be fast, as rays "
            "start in the list of the main object, whose address only a pointer has; it is "
            '"thesis"',
        )
        self.assertIn("kMainFirst = true", self.written(main_first=True, datapath="fast"))

    def test_one_level(self) -> None:
        self.assert_refused(
            listing({"levels": 1, "triangle_test": "watertight"}),
            "configuration 'tiny': with levels 1 the key 'triangle_test' must be unit_triangle, as "
            'a ray\'s map is made when it enters an object; it is "watertight"',
        )
        self.assertIn("unsigned kLevels = 1;", self.written(levels=1, datapath="fast"))

    def test_keys_that_are_gone_name_what_has_their_place(self) -> None:
        for key, value in (("divider", "reciprocal"), ("stack_entries", 8), ("second_ways", 2)):
            self.assert_refused(
                listing({key: value}),
                f"configuration 'tiny': the key '{key}' is gone; {GONE[key]}",
            )
        self.assertIn("'datapath' = \"fast\"", GONE["divider"])
        self.assertEqual(set(GONE) & set(KEYS), set())

    def test_keys(self) -> None:
        self.assert_refused(
            listing({"lihgts": 1}),
            f"configuration 'tiny': unknown key 'lihgts'; the keys are {', '.join(KEYS)}",
        )
        self.assert_refused(
            json.dumps([{"name": "tiny"} | {k: v for k, v in GOOD.items() if k != "lines"}]),
            "configuration 'tiny': lacks the key 'lines' (lines of each cache; its nodes or entries, "
            "where a line has several), "
            "a power of two from 1 to 512",
        )
        self.assert_refused(
            '[{"name": "tiny",\n "packets": 4,\n "packets": 8}]',
            "'packets' is there twice; leave one",
            line=3,
        )

    def test_files_that_are_none(self) -> None:
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

    def test_it_is_like_one_that_is_not_there(self) -> None:
        first = json.dumps({"name": "tiny"} | GOOD)
        for like, named in (("me", "itself"), ("nobody", '"nobody"'), (3, "3")):
            entry = json.dumps({"about": "me", "name": "me", "like": like}, indent=1)
            self.assert_refused(
                f"[{first},\n{entry}]",
                f"configuration 'me': is like {named}; the configurations before it are tiny",
                line=5,
            )
        self.assert_refused(
            f'[{first},\n{{"name": "me", "like": "tiny"}}]',
            "configuration 'me': lacks the key 'about' (what it is for), a sentence",
            line=2,
        )
        self.assert_refused(
            f"[{first},\n{first}]", "configuration 'tiny' is there twice; leave one", line=2
        )

    def test_a_mistake_names_its_line(self) -> None:
        keys = json.dumps(GOOD | {"name": "tiny", "lights": 9}, indent=1)
        self.assert_refused(
            f"[{keys}]",
            "configuration 'tiny': key 'lights' (passes of light rays "
            "from a packet's hits, at most) is 9; it must be a whole number from 0 "
            "to 8",
            line=2 + list(GOOD | {"name": 0, "lights": 0}).index("lights"),
        )

    def test_a_folder_that_cannot_be_written(self) -> None:
        self.out = self.folder / "configs.json" / "out"
        result = self.run_on(listing({}))
        self.assertEqual(result.stderr, f"{self.out}: cannot be written: Not a directory\n")
        self.assertEqual(result.returncode, 1)


if __name__ == "__main__":
    unittest.main()
