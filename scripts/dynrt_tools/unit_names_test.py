# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Every command takes a unit by the name of its module or of its header."""

import pathlib
import unittest
from unittest import mock

from dynrt_tools import project, testing, unit_names
from dynrt_tools.build import try_unit
from dynrt_tools.hardware import lowering, place, rtl_files, synth

HEADERS = {
    "list": "list",
    "packet_mailbox": "mailbox",
    "node_lookup": "cache_lookup",
    "list_lookup": "cache_lookup",
}
LISTED = "".join(f"thesis|{m}|units/{h}.h|dynrt::X\n" for m, h in HEADERS.items())
COSIMULATED = "".join(f"thesis|{m}|{h}|cosim_{h}\n" for m, h in HEADERS.items())


class Names(unittest.TestCase):
    def test_a_module_is_itself_alone(self) -> None:
        self.assertEqual(unit_names.modules_of("node_lookup", HEADERS), ["node_lookup"])

    def test_a_header_means_all_its_modules(self) -> None:
        found = unit_names.all_modules_of(["mailbox", "cache_lookup", "packet_mailbox"], HEADERS)
        self.assertEqual(found, ["packet_mailbox", "node_lookup", "list_lookup"])

    def test_an_unknown_name_lists_both_names(self) -> None:
        with self.assertRaises(project.Failed) as caught:
            unit_names.all_modules_of(["mail"], HEADERS)
        self.assertEqual(
            str(caught.exception),
            "there is no unit 'mail' (did you mean mailbox or packet_mailbox?); the units are list, "
            "list_lookup (or cache_lookup), node_lookup (or cache_lookup), packet_mailbox (or mailbox)",
        )


class Commands(testing.InFolder):
    """Both names of the mailbox, in each of the three commands."""

    NAMES = ("mailbox", "packet_mailbox")

    def setUp(self) -> None:
        super().setUp()
        testing.write_tree(
            self.folder,
            {
                "hls/compiler/hlsc": "",
                "hls/units/list_units.txt": LISTED,
                "cosimulated_units.txt": COSIMULATED,
            },
        )

    def test_synth(self) -> None:
        for name in self.NAMES:
            with mock.patch("sys.argv", ["synth", name]):
                args = synth.parse()
            tops = synth.chosen(args, *2 * [rtl_files.units_in(rtl_files.GENERATED)])
            self.assertEqual(tops, ["packet_mailbox"])

    def test_place(self) -> None:
        for name in self.NAMES:
            with mock.patch("sys.argv", ["place", name, "--build", str(self.folder)]):
                args = place.parse()
            self.assertEqual(place.chosen(args), (["packet_mailbox"], self.folder))

    def test_try(self) -> None:
        modules = try_unit.read_modules(self.folder)
        for name in self.NAMES:
            (found,) = try_unit.chosen(modules, name, None)
            self.assertEqual((found.name, found.stem), ("packet_mailbox", "mailbox"))


class Sources(testing.InFolder):
    """Where the modules and their headers stand."""

    def test_the_checked_in_verilog_names_the_header_of_each_unit(self) -> None:
        headers = rtl_files.headers(rtl_files.units_in(rtl_files.GENERATED))
        self.assertEqual(headers["packet_mailbox"], "mailbox")
        self.assertEqual(headers["matrix_lookup"], "cache_lookup")
        units = project.ROOT / "hls" / "units"
        self.assertGreater(len(headers), 20)
        for header in headers.values():
            self.assertTrue((units / f"{header}.h").is_file(), header)

    def test_the_list_of_a_build_has_the_same(self) -> None:
        testing.write_tree(self.folder, {"hls/units/list_units.txt": LISTED})
        self.assertEqual(lowering.headers(lowering.units(pathlib.Path(self.folder))), HEADERS)


if __name__ == "__main__":
    unittest.main()
