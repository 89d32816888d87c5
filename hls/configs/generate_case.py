# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""What the tests of hls/configs/generate share: configurations of which each test changes a key, and
the run of the generator on them."""

import json
import pathlib
import subprocess
import tempfile
import unittest
from collections.abc import Mapping

GENERATE = pathlib.Path(__file__).resolve().parent / "generate"
GOOD: dict[str, object] = {
    "about": "for the test",
    "packets": 4,
    "lines": 16,
    "stack_depth": 5,
    "exponent_bits": 6,
    "mantissa_bits": 9,
    "rounding": "truncate",
    "epsilon": 0.25,
}


def listing(keys: Mapping[str, object], name: str = "tiny") -> str:
    """A list of one configuration."""
    return json.dumps([{"name": name, **GOOD, **keys}])


class GenerateCase(unittest.TestCase):
    def setUp(self) -> None:
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        self.json = self.folder / "configs.json"
        self.out = self.folder / "out"

    def run_on(self, text: str | None) -> subprocess.CompletedProcess[str]:
        if text is not None:
            self.json.write_text(text, encoding="utf-8")
        return subprocess.run(
            [GENERATE, self.json, self.out], capture_output=True, text=True, check=False
        )

    def written(self, **keys: object) -> str:
        result = self.run_on(listing(keys))
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return (self.out / "tiny.h").read_text(encoding="utf-8")

    def assert_refused(self, text: str | None, sentence: str, line: int | None = 1) -> None:
        result = self.run_on(text)
        self.assertEqual(result.stderr, f"{self.json}:{f'{line}:' if line else ''} {sentence}\n")
        self.assertEqual(result.returncode, 1)
        self.assertFalse(self.out.exists())

    def assert_key_refused(self, key: str, value: object, sentence: str) -> None:
        self.assert_refused(listing({key: value}), f"configuration 'tiny': key '{key}' {sentence}")
