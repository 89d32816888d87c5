# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The cache keeps whole entries alone, whoever else is at work, and says why it cannot keep one."""

import errno
import multiprocessing
import os
import pathlib
import signal
import time
import unittest
from collections.abc import Callable
from multiprocessing.synchronize import Event
from typing import Any, NoReturn

from dynrt_tools import testing
from dynrt_tools.build.cache import BuildCache, CacheError

Build = Callable[[pathlib.Path], pathlib.Path]


def build_text(
    text: str,
    seconds: float = 0.0,
    started: Event | None = None,
    builds: Any = None,
) -> Build:
    """A build that writes two files and counts itself."""

    def build(folder: pathlib.Path) -> pathlib.Path:
        if builds is not None:
            with builds.get_lock():
                builds.value += 1
        made = folder / "made"
        made.mkdir()
        (made / "first").write_text(text, encoding="utf-8")
        if started is not None:
            started.set()
        time.sleep(seconds)
        (made / "second").write_text(text, encoding="utf-8")
        return made

    return build


def never(_: pathlib.Path) -> NoReturn:
    """The build of what is there."""
    raise AssertionError("it is built again")


class Cache(testing.InFolder):
    def setUp(self) -> None:
        super().setUp()
        self.folder /= "cache"
        self.cache = BuildCache(self.folder)

    def names(self, suffix: str) -> list[str]:
        return [p.name for p in self.folder.iterdir() if p.name.endswith(suffix)]

    def assert_whole(self, entry: pathlib.Path, text: str) -> None:
        self.assertEqual(
            [(entry / n).read_text(encoding="utf-8") for n in ("first", "second")], [text, text]
        )
        self.assertEqual(self.names(".partial"), [])

    def start(self, build: Build) -> multiprocessing.Process:
        process = multiprocessing.Process(target=self.cache.get, args=("key", build))
        process.start()
        self.addCleanup(process.join)
        return process

    def test_builds_once(self) -> None:
        builds: Any = multiprocessing.Value("i", 0)
        for _ in range(2):
            self.assert_whole(self.cache.get("key", build_text("a", builds=builds)), "a")
        self.assertEqual(builds.value, 1)

    def test_a_file_is_an_entry_too(self) -> None:
        def build(folder: pathlib.Path) -> pathlib.Path:
            (folder / "file").write_text("a", encoding="utf-8")
            return folder / "file"

        self.assertEqual(self.cache.get("key", build).read_text(encoding="utf-8"), "a")

    def test_two_at_once(self) -> None:
        builds: Any = multiprocessing.Value("i", 0)
        started = multiprocessing.Event()
        first = self.start(build_text("a", seconds=0.5, started=started, builds=builds))
        self.assertTrue(started.wait(30))
        waited: list[int] = []
        entry = self.cache.get("key", build_text("b", builds=builds), lambda: waited.append(1))
        first.join()
        self.assertEqual((builds.value, waited), (1, [1]))
        self.assert_whole(entry, "a")

    def test_a_build_that_was_cut_off_is_never_used(self) -> None:
        started = multiprocessing.Event()
        killed = self.start(build_text("a", seconds=60, started=started))
        self.assertTrue(started.wait(30))
        assert killed.pid is not None
        os.kill(killed.pid, signal.SIGKILL)
        killed.join()
        self.assertEqual(len(self.names(".partial")), 1)
        self.assertFalse((self.folder / "key").exists())
        self.assert_whole(self.cache.get("key", build_text("b")), "b")

    def test_a_build_that_fails_leaves_nothing(self) -> None:
        def build(folder: pathlib.Path) -> NoReturn:
            (folder / "half").write_text("a", encoding="utf-8")
            raise ValueError("no")

        with self.assertRaises(ValueError):
            self.cache.get("key", build)
        self.assertEqual(self.names("key") + self.names(".partial"), [])

    def test_full_disk(self) -> None:
        def build(_: pathlib.Path) -> NoReturn:
            raise OSError(errno.ENOSPC, "No space left on device")

        with self.assertRaisesRegex(
            CacheError,
            f"^the disk that holds the cache {self.folder} is "
            "full; free some space or let DYNRT_CACHE name a folder",
        ):
            self.cache.get("key", build)

    def test_what_a_build_runs_into_is_not_told_of_the_cache(self) -> None:
        def build(_: pathlib.Path) -> NoReturn:
            raise FileNotFoundError(errno.ENOENT, "No such file or directory", "cmake")

        with self.assertRaisesRegex(FileNotFoundError, "cmake"):
            self.cache.get("key", build)
        self.assertEqual(self.names(".partial"), [])

    def test_an_entry_that_is_not_whole_is_built_again(self) -> None:
        def whole(entry: pathlib.Path) -> bool:
            return (entry / "second").stat().st_size > 0

        entry = self.cache.get("key", build_text("a"), whole=whole)
        self.assertEqual(self.cache.get("key", never, whole=whole), entry)
        (entry / "second").write_text("", encoding="utf-8")
        self.assert_whole(self.cache.get("key", build_text("b"), whole=whole), "b")

    def test_cache_that_cannot_be_written(self) -> None:
        self.folder.write_text("no folder", encoding="utf-8")
        with self.assertRaisesRegex(
            CacheError,
            f"^the cache {self.folder} cannot be written .*; "
            "let DYNRT_CACHE name a folder that can$",
        ):
            self.cache.get("key", build_text("a"))

    def test_what_is_there_needs_no_writing(self) -> None:
        (self.folder / "key").mkdir(parents=True)
        self.folder.chmod(0o500)
        self.addCleanup(self.folder.chmod, 0o700)
        self.assertEqual(self.cache.get("key", never), self.folder / "key")
        self.assertEqual(self.names(".lock"), [])


if __name__ == "__main__":
    unittest.main()
