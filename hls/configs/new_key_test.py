# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""A new key needs its record in the table of keys and no more: a copy of the table with one more is
generated and compiled with the project's own sources, all unchanged, into a program that reads the
key from JSON, writes it, and finds it in the struct of the units, with its enumeration, and in what
the host asks of keys: whether the memory depends on it, and how a core for a scene has it.

The compiler may be named as argument.
"""

import pathlib
import shutil
import subprocess
import sys
import unittest

from generate_case import GENERATE, GenerateCase

ROOT = GENERATE.parents[2]
COMPILER = sys.argv.pop() if len(sys.argv) > 1 else "clang++-19"
TABLE = "KEYS: dict[str, Key] = {\n"
KEY = """\
    "order": Key(
        Choice(
            "ChildOrder",
            {"near": "kNear", "far": "kFar"},
            "The child that rays enter first.",
            {"near": "the nearer one", "far": "the farther one"},
        ),
        "kOrder",
        "of a node's children",
        "near",
        in_memory=False,
        kept=HITS_STAY,
    ),
"""
PROGRAM = """\
#include "configs/full.h"
#include "host/format/configuration_json.h"

static_assert(dynrt::config::full::kOrder == dynrt::ChildOrder::kNear);

int main() {
  using namespace dynrt;
  const auto listed = listed_configurations();
  if (listed.empty()) return 1;
  for (const CoreConfiguration& one : listed) {
    if (one.order != ChildOrder::kNear || configuration_of(json_of(one)) != one) return 2;
  }
  const auto read = configuration_of(Json::parse(R"({"like": "full", "order": "far"})"));
  if (read.order != ChildOrder::kFar || json_of(read).at("order") != "far") return 3;
  if (configuration_of<config::full>().order != ChildOrder::kNear) return 4;
  // Images that are laid out with another value are taken, and cores for a scene keep the value.
  int found = 5;
  for_each_key(read, [&](const ConfigurationKey& key, const auto&) {
    if (key.name == "order" && key.of_core && !key.in_memory &&
        key.kept == "hits and pixels do not depend on it") {
      found = 0;
    }
  });
  return found;
}
"""
INCLUDES = ("", "hls", "hls/include", "hls/native")


class NewKey(GenerateCase):
    def generated(self, folder: pathlib.Path, line: str) -> dict[str, str]:
        """The files that a copy of hls/configs with one more line in its table writes."""
        copy = folder / "table"
        shutil.copytree(GENERATE.parent, copy, ignore=shutil.ignore_patterns("__pycache__"))
        keys = copy / "configurations" / "keys.py"
        text = keys.read_text(encoding="utf-8")
        self.assertEqual(text.count(TABLE), 1)
        keys.write_text(text.replace(TABLE, TABLE + line), encoding="utf-8")
        out = folder / "configs"
        subprocess.run([copy / "generate", copy / "configs.json", out], check=True)
        return {path.name: path.read_text(encoding="utf-8") for path in out.iterdir()}

    def test_a_new_key_changes_no_other_file(self) -> None:
        before = self.generated(self.folder / "before", "")
        after = self.generated(self.folder / "after", KEY)
        self.assertEqual(before.keys(), after.keys())
        main = self.folder / "main.cpp"
        main.write_text(PROGRAM, encoding="utf-8")
        program = self.folder / "program"
        sources = (
            main,
            self.folder / "after" / "configs" / "core_configuration.cpp",
            ROOT / "host" / "format" / "configuration_json.cpp",
        )
        folders = (self.folder / "after", *(ROOT / folder for folder in INCLUDES))
        result = subprocess.run(
            [
                COMPILER,
                "-std=c++20",
                "-Wno-bit-int-extension",
                *(f"-I{folder}" for folder in folders),
                *sources,
                "-o",
                program,
            ],
            capture_output=True,
            text=True,
            check=False,
        )
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(subprocess.run([program], check=False).returncode, 0)


if __name__ == "__main__":
    unittest.main()
