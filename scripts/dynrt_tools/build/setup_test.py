# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Runs scripts/setup, demo and test against stand-ins for apt-get and dpkg-query, and their
command lines against mistakes. Nothing is installed."""

import os
import shutil
import unittest
from collections.abc import Iterable

from dynrt_tools import project, testing

SCRIPTS = project.SCRIPTS
# The machine of the stand-ins: the file `installed` holds dpkg's answer, `calls` what apt-get got.
DPKG_QUERY = '#!/bin/sh\ncat "$MACHINE/installed"\n'
APT_GET = """#!/bin/sh
echo "$@" >>"$MACHINE/calls"
case "$*" in
  *update*) [ "$BROKEN" = update ] && { echo "E: Could not resolve host"; exit 100; } ;;
  *install*)
    [ "$BROKEN" = install ] && { echo "E: No space left on device"; exit 100; }
    for argument; do echo "ii $argument"; done >>"$MACHINE/installed" ;;
esac
exit 0
"""
APT_CACHE = '#!/bin/sh\n[ "$BROKEN" = unknown ] && [ "$3" = yosys ] && exit 100\nexit 0\n'
ID = '#!/bin/sh\necho "${USER_ID:-0}"\n'


def names_in(lines: str) -> list[str]:
    """The packages that lines of packages.txt name."""
    names = (line.split("#")[0].strip() for line in lines.splitlines())
    return [name for name in names if name and not name.startswith("[")]


class Scripts(testing.InFolder):
    def setUp(self) -> None:
        super().setUp()
        self.machine = self.folder
        for name, text in (
            ("dpkg-query", DPKG_QUERY),
            ("apt-get", APT_GET),
            ("apt-cache", APT_CACHE),
            ("id", ID),
        ):
            testing.write_program(self.machine / name, text)
        shutil.copytree(SCRIPTS, self.machine / "scripts")
        for_demo, for_test = (SCRIPTS / "packages.txt").read_text().split("\n[test]\n")
        self.demo_packages = names_in(for_demo)
        self.packages = self.demo_packages + names_in(for_test)
        self.install(self.packages)

    def install(self, packages: Iterable[str]) -> None:
        text = "".join(f"ii {name}\n" for name in packages)
        (self.machine / "installed").write_text(text)

    def run_script(self, *command: str, **environment: str) -> testing.Result:
        path = f"{self.machine}:{os.environ['PATH']}"
        return testing.run(
            self.machine / "scripts" / command[0],
            *command[1:],
            env={**os.environ, "PATH": path, "MACHINE": str(self.machine), **environment},
        )

    def calls(self) -> list[str]:
        path = self.machine / "calls"
        return path.read_text().splitlines() if path.exists() else []

    def test_complete_machine_is_left_alone(self) -> None:
        result = self.run_script("setup")
        self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "", ""))
        self.assertEqual(self.calls(), [])

    def test_only_what_is_missing_is_installed(self) -> None:
        self.install(p for p in self.packages if p not in ("yosys", "verilator"))
        result = self.run_script("setup")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("installing 2 Debian packages: verilator yosys", result.stdout)
        self.assertEqual(len(self.calls()), 2)
        self.assertTrue(self.calls()[1].endswith("install --no-install-recommends verilator yosys"))
        self.assertEqual(self.run_script("setup").stdout, "")
        self.assertEqual(len(self.calls()), 2)

    def test_demo_needs_fewer_packages(self) -> None:
        self.install(self.demo_packages)
        result = self.run_script("setup", "--for", "demo")
        self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "", ""))
        for heavy in ("llvm-19-dev", "chromium", "libcgal-dev", "libembree-dev", "yosys"):
            self.assertNotIn(heavy, self.demo_packages)
        result = self.run_script("setup", "--for", "test", "--check")
        rest = sorted(set(self.packages) - set(self.demo_packages))
        self.assertEqual((result.returncode, result.stdout.split()), (1, rest))

    def test_removed_package_counts_as_missing(self) -> None:
        self.install(self.packages)
        text = (self.machine / "installed").read_text().replace("ii yosys", "rc yosys")
        (self.machine / "installed").write_text(text)
        result = self.run_script("setup", "--check")
        self.assertEqual((result.returncode, result.stdout), (1, "yosys\n"))
        self.assertEqual(self.calls(), [])

    def assert_setup_fails(self, message: str, **environment: str) -> None:
        self.install(p for p in self.packages if p != "yosys")
        result = self.run_script("setup", **environment)
        self.assertEqual(result.returncode, 1)
        self.assertIn(message, result.stderr)

    def test_failed_update(self) -> None:
        self.assert_setup_fails(
            "E: Could not resolve host\nsetup: apt-get update failed", BROKEN="update"
        )

    def test_unknown_package(self) -> None:
        self.assert_setup_fails("setup: no package source has: yosys; this is", BROKEN="unknown")

    def test_failed_install(self) -> None:
        self.assert_setup_fails(
            "E: No space left on device\nsetup: apt-get could not install: yosys",
            BROKEN="install",
        )

    def test_neither_root_nor_sudo(self) -> None:
        tools = ("bash", "dirname", "basename", "sed", "sort", "comm", "cat", "mktemp", "rm")
        testing.link_tools(self.machine, *tools)
        self.assert_setup_fails(
            "not root and sudo is not installed; as root run: apt-get install yosys",
            USER_ID="1000",
            PATH=str(self.machine),
        )

    def test_help_says_what_will_be_installed(self) -> None:
        for script, packages in (
            ("setup", self.packages),
            ("demo", self.demo_packages),
            ("test", self.packages),
        ):
            result = self.run_script(script, "--help")
            self.assertEqual(result.returncode, 0, result.stderr)
            listed = result.stdout.partition("(as root or with sudo):\n")[2]
            listed = listed.partition("\nscripts/packages.txt")[0]
            self.assertEqual(listed.split(), packages, script)

    def test_mistakes_on_the_command_line(self) -> None:
        for command, message in (
            (("setup", "--now"), "setup: unknown argument '--now'"),
            (("setup", "--for"), "setup: --for needs demo or test"),
            (("setup", "--for", "work"), "setup: unknown purpose 'work'; --for takes demo or"),
            (("demo", "office"), "demo: unknown argument 'office'"),
            (("demo", "--size"), "demo: --size needs WxH, for example 512x384"),
            (("test", "--label", "units"), "test: unknown label 'units'; the labels are unit,"),
            (
                ("test", "--fast", "--slow-part", "10/10"),
                "test: --slow-part 10/10 is no part; give",
            ),
            (("test", "--slow-part", "10"), "test: --slow-part adds a part to --fast; give both"),
            (("test", "--preset", "debug"), "test: unknown preset 'debug'; the presets are"),
        ):
            result = self.run_script(*command)
            self.assertEqual(result.returncode, 1, command)
            self.assertTrue(result.stderr.startswith(message), result.stderr)


if __name__ == "__main__":
    unittest.main()
