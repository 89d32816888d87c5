# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""What scripts/docs --check finds: old pages, missing pages, links that lead nowhere."""

import pathlib
import tempfile
import unittest

from dynrt_tools.docs import keys, links, made, registers


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

    def test_every_register_and_format_is_there(self) -> None:
        page = registers.page()
        for name in ("packets", "uncompressed", "object", "REG_FRAME", "kMaxMatrices"):
            self.assertIn(f"| `{name}` |", page)
        for struct in ("Node", "ListEntry", "MatrixWord", "HitPlace", "HitSurface"):
            self.assertIn(f"\n### {struct}\n", page)


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

    def test_a_missing_heading(self) -> None:
        self.assertEqual(
            self.broken("[a](docs/a.md#three)"),
            ["README.md:1: docs/a.md has no heading 'three'"],
        )


if __name__ == "__main__":
    unittest.main()
