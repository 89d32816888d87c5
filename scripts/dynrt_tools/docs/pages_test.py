# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""What scripts/docs --check finds: old pages, missing pages, links that lead nowhere."""

import json
import pathlib
import re
import tempfile
import typing
import unittest

from dynrt_tools import project
from dynrt_tools.build import configs
from dynrt_tools.docs import (
    commands,
    keys,
    limits,
    links,
    made,
    messages,
    registers,
    unit_sheet,
    waves,
)


def new_folder(test: unittest.TestCase) -> pathlib.Path:
    """A folder that goes when the test ends."""
    return pathlib.Path(test.enterContext(tempfile.TemporaryDirectory()))


class Pages(unittest.TestCase):
    """Made pages against their sources."""

    def setUp(self) -> None:
        self.docs = new_folder(self)

    def test_a_page_that_was_written_is_current(self) -> None:
        made.renew({"reference/a.md": "one\ntwo\n"}, self.docs)
        self.assertEqual(made.stale({"reference/a.md": "one\ntwo\n"}, self.docs), [])

    def test_an_old_page_is_named_with_its_line(self) -> None:
        made.renew({"a.md": "one\ntwo\n"}, self.docs)
        problem = made.stale({"a.md": "one\nthree\n"}, self.docs)
        self.assertEqual(
            problem,
            ["docs/a.md:2: differs from its sources; scripts/docs --renew writes it"],
        )

    def test_a_missing_page_is_named(self) -> None:
        problems = made.stale({"a.md": "one\n"}, self.docs)
        self.assertIn("docs/a.md:1: the page is missing", "".join(problems))

    def test_every_key_and_configuration_is_there(self) -> None:
        page = keys.keys_page()
        for name in keys.described().KEYS:
            self.assertIn(f"| `{name}` |", page)
        page = keys.configurations_page()
        for name in keys.configurations():
            self.assertIn(f"\n## {name}\n", page)

    def test_configurations_of_how_to_pages_are_right(self) -> None:
        package = configs.load_configurations()
        found = 0
        for name in ("configuration", "number-format"):
            text = (made.DOCS / "how-to" / f"{name}.md").read_text(encoding="utf-8")
            for stated in re.findall(r"^    (\{.*\})$", text, re.MULTILINE):
                path = new_folder(self) / "mine.json"
                path.write_text(f"[{json.dumps({'name': 'mine', **json.loads(stated)})}]", "utf-8")
                self.assertIn("mine", package.read(path, package.read(package.reading.LISTED)))
                found += 1
        self.assertEqual(found, 2)

    def test_every_register_and_format_is_there(self) -> None:
        page = registers.page()
        self.assertIn("| `WINDOW_BANK_LOW` | `22` | Byte address", page)
        self.assertIn("| `positive_syncs` | `0x234` |", page)
        self.assertIn("| 74 | `memory_interface.stalls` |", page)
        for name in ("packets", "uncompressed", "object", "REG_FRAME", "kMaxMatrices"):
            self.assertIn(f"| `{name}` |", page)
        for struct in ("Node", "ListEntry", "MatrixWord", "HitPlace", "HitSurface"):
            self.assertIn(f"\n### {struct}\n", page)

    def test_what_lies_behind_a_port_fills_no_byte_twice(self) -> None:
        lines = registers.port_table(limits.memory_constants())[2:]
        self.assertIn("| `0x0400000` | `0x05fffff` | 2 MB | 4 bytes | list entries |", lines)
        self.assertIn("| `0x1800000` | `0x1ffffff` | 8 MB | 24 bytes | hit records |", lines)
        ends = [re.findall(r"0x(\w+)", line) for line in lines if "pixels of 16" not in line]
        bytes_ = [int(end, 16) for both in ends for end in both]
        self.assertEqual(bytes_, sorted(bytes_))
        text = registers.source(registers.MEMORY)
        self.assertTrue(registers.port_comment(text).startswith("A memory behind one port"))

    def test_constants_of_the_memory_have_meanings(self) -> None:
        table = registers.constants_table(registers.source(registers.MEMORY))
        self.assertEqual([line for line in table if line.endswith("|  |")], [])
        self.assertTrue(any(line.startswith("| `kSpareBits` | `std::max(") for line in table))

    def test_cores_with_the_same_registers_share_a_column(self) -> None:
        small = "`define DYNRT_CORE_FRAME_BITS 64\n`define DYNRT_CORE_FRAME_PACKETS 32\n"
        large = f"{small}`define DYNRT_CORE_FRAME_BOX_COLUMN 64\n"
        lines = registers.frame_table({"one": small, "two": large, "three": small})
        self.assertIn("| register | `one`, `three` | `two` | meaning | only if |", lines)
        self.assertTrue(any(line.startswith("| `packets` | `0x104` | `0x104` |") for line in lines))
        self.assertTrue(any(line.startswith("| `box_column` | - | `0x108` |") for line in lines))

    def test_every_core_that_is_checked_in_has_its_registers(self) -> None:
        self.assertEqual(registers.configurations()[0], "thesis")
        cores = {
            name: registers.source(registers.generated(name, "vh"))
            for name in registers.configurations()
        }
        named = {name for name, _, _ in registers.frame_fields(registers.source(registers.FRAME))}
        for text in cores.values():
            self.assertLess(registers.places(text).keys() - {"bits"}, named)
            self.assertGreater(len(registers.places(text)), 16)


class Waves(unittest.TestCase):
    """Timing diagrams of a unit of two stages that reads a RAM in its second."""

    VERILOG = (
        "// Made by hlsc (list.h); do not edit.\nmodule list #(\n  parameter A = 1\n) (\n  input  "
        "wire clk_i,\n  input  wire job_valid_i,\n  output wire job_ready_o,\n  input  wire [3:0] "
        "job_data_i,\n  output wire row_en_o,\n  output wire [3:0] row_addr_o,\n  output wire "
        "pop_valid_o,\n  input  wire pop_ready_i,\n  output wire [3:0] pop_data_o\n);\n"
    )

    def drawn(self, stages: int) -> waves.Diagram:
        return waves.diagram({"stages": stages, "ram_stages": {"row": 1}}, self.VERILOG)

    def test_each_signal_begins_in_its_clock(self) -> None:
        begins = {
            lane["name"]: len(lane["wave"]) - len(lane["wave"].lstrip("0x."))
            for lane in self.drawn(2)["signal"][1:]
        }
        self.assertEqual(
            begins,
            {
                "job_valid": 1,
                "job_data": 1,
                "row_addr": 2,
                "pop_valid": 3,
                "pop_data": 3,
            },
        )

    def test_a_picture_of_another_schedule_is_old(self) -> None:
        folder = new_folder(self)
        mark = f"<!-- diagram {waves.digest(self.drawn(2))} -->"
        (folder / "list.svg").write_text(mark, encoding="utf-8")
        self.assertEqual(waves.stale({"list": self.drawn(2)}, folder), [])
        self.assertEqual(waves.stale({"list": self.drawn(3)}, folder), ["list"])


class Units(unittest.TestCase):
    """The ports of the page of units against the checked-in Verilog."""

    FOLDER = project.ROOT / "rtl" / "generated" / "thesis"
    PORT = re.compile(r"^ *(?:input|output) .*?(?:\[(\d+):0\] *)?(\w+),?$", re.MULTILINE)
    # By the kind of a signal: the ports that it stands for, with the bits of each.
    PORTS: typing.ClassVar[dict[str, dict[str, str]]] = {
        "in": {"valid_i": "1", "ready_o": "1", "data_i": "bits"},
        "out": {"valid_o": "1", "ready_i": "1", "data_o": "bits"},
        "reads": {"en_o": "1", "addr_o": "address", "data_i": "bits"},
        "writes": {"en_o": "1", "addr_o": "address", "data_o": "bits"},
        "steady": {"i": "bits"},
    }

    def sections(self) -> dict[str, str]:
        """The section of each module on the page."""
        page = (made.DOCS / "reference" / "units.md").read_text(encoding="utf-8")
        return {s.partition("\n")[0]: s for s in page.split("\n## ")[1:]}

    def shown(self, section: str) -> dict[str, int]:
        """The bits of each port that a section tells of."""
        ports = {"clk_i": 1, "rst_ni": 1, "fire_o": 1, "stall_o": 1}
        rows = re.findall(r"^\| (\w+) \| `(\w+)` \| (?:([\d,]+) x )?(\d+) \| .+ \|$", section, re.M)
        for kind, name, rows_, bits in rows:
            widths = {"1": 1, "bits": int(bits)}
            if rows_:
                widths["address"] = (int(rows_.replace(",", "")) - 1).bit_length()
            ports |= {f"{name}_{end}": widths[of] for end, of in self.PORTS[kind].items()}
        return ports

    def test_each_port_of_each_module_is_on_the_page(self) -> None:
        modules = {path.stem: path for path in self.FOLDER.glob("*.v")}
        del modules["dynrt_core"]  # the join
        sections = self.sections()
        self.assertEqual(sorted(sections), sorted(modules))
        for module, path in modules.items():
            with self.subTest(module=module):
                head = path.read_text(encoding="utf-8").partition("\n);")[0]
                has = {name: int(high or 0) + 1 for high, name in self.PORT.findall(head)}
                self.assertEqual(self.shown(sections[module]), has)

    def test_a_port_is_read_as_its_verilog_has_it(self) -> None:
        found = {
            module: list(
                unit_sheet.signals((self.FOLDER / f"{module}.v").read_text(encoding="utf-8"))
            )
            for module in ("matrix_fetch", "traversal_slice", "memory_interface", "shading")
        }
        self.assertIn(("in", "job", "37"), found["matrix_fetch"])
        self.assertIn(("reads", "ray", "256 x 48"), found["traversal_slice"])
        self.assertIn(("steady", "lane", "2"), found["traversal_slice"])
        self.assertIn(("reads", "bank_2", "1,048,576 x 32"), found["memory_interface"])
        self.assertIn(("writes", "bank_0", "1,048,576 x 32"), found["shading"])


class Limits(unittest.TestCase):
    """Numbers of headers."""

    def test_constants_are_computed(self) -> None:
        known = {"kA": 3}
        self.assertEqual(limits.value("1u << kA", known), 8)
        self.assertEqual(limits.value("20 / kA", known), 6)
        self.assertEqual(limits.value("2 * (1u << kA) +\n  kA / 2", known), 17)
        self.assertIsNone(limits.value("f(1) + kA", known))
        self.assertIsNone(limits.value("kA + kB", known))
        self.assertIsNone(limits.value("a::b", known))

    def test_a_pixel_takes_the_words_of_its_hit(self) -> None:
        self.assertEqual(limits.hit_words(17), 3)


class Texts(unittest.TestCase):
    """What programs print."""

    def test_a_message_shows_where_values_stand(self) -> None:
        folder = new_folder(self)
        table, source = folder / "a_messages.h", folder / "b.cpp"
        table.write_text(
            'inline constexpr char kA[] =\n    "{} takes {:.2f} ns, "\n    "{{not}} less";\n',
            encoding="utf-8",
        )
        source.write_text(
            'constexpr char kB[] = "{}: no file";\n'
            'refuse(\n    "no {} "\n    "here", kB);\nrefuse(kB, path);\nrefuse(sentence);\n',
            encoding="utf-8",
        )
        self.assertEqual(messages.wordings(table), ["… takes … ns, {not} less"])
        self.assertEqual(messages.wordings(source), ["no … here", "…: no file"])

    def test_the_page_has_the_messages_of_the_program(self) -> None:
        self.assertGreater(messages.page().count("\n- "), 200)

    def test_a_missing_build_is_named(self) -> None:
        with self.assertRaisesRegex(Exception, "commands.md:1: the page needs .*dynrt"):
            made.from_build(new_folder(self))

    def test_every_script_prints_its_help(self) -> None:
        page = commands.scripts_page()
        self.assertIn("## scripts/synth", page)
        self.assertIn("--device", page)


class Links(unittest.TestCase):
    """Links of a project of two pages."""

    def setUp(self) -> None:
        self.root = new_folder(self)
        for name in ("ARCHITECTURE.md", "CONTRIBUTING.md", "CHANGELOG.md"):
            (self.root / name).write_text("", encoding="utf-8")
        (self.root / "hls/compiler").mkdir(parents=True)
        (self.root / "hls/compiler/README.md").write_text("", encoding="utf-8")
        (self.root / "docs").mkdir()
        (self.root / "docs/a.md").write_text("# A\n\n## Two `words`\n", encoding="utf-8")

    def broken(self, text: str) -> list[str]:
        (self.root / "README.md").write_text(text, encoding="utf-8")
        return links.broken(self.root)

    def test_good_links(self) -> None:
        self.assertEqual(self.broken("[a](docs/a.md) [b](docs/a.md#two-words) [c](https://c)"), [])

    def test_code_holds_no_links(self) -> None:
        self.assertEqual(self.broken("`[a](nowhere.md)`\n\n```\n[a](nowhere.md)\n```\n"), [])

    def test_a_missing_file(self) -> None:
        self.assertEqual(
            self.broken("text\n[a](docs/b.md)"),
            ["README.md:2: the link 'docs/b.md' leads to no file of the project"],
        )

    def test_a_name_of_no_file(self) -> None:
        self.assertEqual(
            self.broken("`docs/a.md`, `docs/NAME.md`\nand `docs/b.md`"),
            ["README.md:2: 'docs/b.md' is no file or folder of the project"],
        )

    def test_a_missing_heading(self) -> None:
        self.assertEqual(
            self.broken("[a](docs/a.md#three)"),
            ["README.md:1: docs/a.md has no heading 'three'"],
        )


if __name__ == "__main__":
    unittest.main()
