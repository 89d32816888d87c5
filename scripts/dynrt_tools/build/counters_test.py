# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Holds the counters that the scripts name against the description of the core, which the join
writes. host/render/figures_test.cpp does the same for the host."""

import pathlib
import re
import unittest

from dynrt_tools import project, testing

DESCRIPTION = project.ROOT / "rtl" / "generated" / "thesis" / "dynrt_core.json"
COUNTER = re.compile(r'"(\w+\.(?:tokens|transactions|stalls))"')


def unknown(root: pathlib.Path, counters: set[str]) -> list[str]:
    """A sentence for each counter that a script names and the core lacks."""
    sentences = []
    for path in sorted(root.rglob("*.py")):
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), start=1):
            for name in COUNTER.findall(line):
                if name not in counters:
                    place = f"{path.relative_to(root).as_posix()}:{number}"
                    sentences.append(f"{place}: the core has no counter {name}")
    return sentences


class Counters(testing.InFolder):
    def test_the_core_has_those_that_scripts_name(self) -> None:
        counters = {c["name"] for c in project.read_json(DESCRIPTION)["counters"]}
        self.assertIn("node_fetch.transactions", counters)
        self.assertEqual(unknown(project.ROOT / "scripts" / "dynrt_tools", counters), [])

    def test_another_is_found(self) -> None:
        name = "nod_fetch" + ".transactions"
        testing.write_tree(self.folder, {"a/b.py": f'x = 1\ny = of["{name}"]\n'})
        self.assertEqual(
            unknown(self.folder, {"node_fetch.transactions"}),
            [f"a/b.py:2: the core has no counter {name}"],
        )


if __name__ == "__main__":
    unittest.main()
