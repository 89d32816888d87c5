# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""A folder that keeps results of builds, each under a key of all that it was built from.

An entry is there as a whole or not at all: it is built in a folder beside its place and moved there
when it is complete. A program waits for a result that another program is building. The next
build of the same result removes the files that an interrupted build has left.
"""

from collections.abc import Callable, Iterator


import contextlib
import errno
import fcntl
import os
import pathlib
import shutil
import tempfile

from dynrt_tools.project import Failed

Build = Callable[
    [pathlib.Path], pathlib.Path
]  # builds in an empty folder; gives the result to keep
PARTIAL = ".partial"


class CacheError(Failed):
    """Why something cannot be kept or built, in a sentence."""


def default_folder() -> pathlib.Path:
    """DYNRT_CACHE, or the cache folder by the desktop standards."""
    if named := os.environ.get("DYNRT_CACHE"):
        return pathlib.Path(named).absolute()
    base = os.environ.get("XDG_CACHE_HOME") or pathlib.Path.home() / ".cache"
    return pathlib.Path(base).absolute() / "dynrt"


def full_disk(folder: pathlib.Path) -> str:
    return (
        f"the disk that holds the cache {folder} is full; free some space or let DYNRT_CACHE "
        "name a folder elsewhere"
    )


def _sync(made: pathlib.Path) -> None:
    """So that a machine that loses its power keeps no entry with empty files."""
    for path in [made, *made.rglob("*")]:
        if path.is_file() or path.is_dir():
            _sync_one(path)


def _sync_one(path: pathlib.Path) -> None:
    """A file's content, or the names in a folder."""
    file = os.open(path, os.O_RDONLY)
    try:
        os.fsync(file)
    except OSError as error:
        if error.errno != errno.EINVAL:  # a file system that cannot, of a folder
            raise
    finally:
        os.close(file)


class BuildCache:
    def __init__(self, folder: pathlib.Path | str | None = None) -> None:
        self.folder = pathlib.Path(folder) if folder else default_folder()

    def get(
        self,
        key: str,
        build: Build,
        wait: Callable[[], None] = lambda: None,
        whole: Callable[[pathlib.Path], bool] = lambda entry: True,
    ) -> pathlib.Path:
        """The path of an entry. `build` makes it in an empty folder, of which it gives the file or
        folder that is kept; `wait` is called before waiting for somebody else's build. An entry
        that is not `whole` is built again."""
        entry = self.folder / key
        if entry.exists() and whole(entry):
            return entry
        with self._told():
            self.folder.mkdir(parents=True, exist_ok=True)
        with self._locked(key, wait) as alone:
            if not (entry.exists() and whole(entry)):
                self._make(entry, build, alone)
        return entry

    @contextlib.contextmanager
    def _told(self) -> Iterator[None]:
        """Turns errors in writing to the cache itself into sentences."""
        try:
            yield
        except OSError as error:
            if error.errno == errno.ENOSPC:
                raise CacheError(full_disk(self.folder)) from error
            raise CacheError(
                f"the cache {self.folder} cannot be written ({error.strerror}); let "
                "DYNRT_CACHE name a folder that can"
            ) from error

    @contextlib.contextmanager
    def _locked(self, key: str, wait: Callable[[], None]) -> Iterator[bool]:
        """True while nobody else builds this, False where the file system cannot tell."""
        with self._told():
            file = (self.folder / f"{key}.lock").open("w")
        with file:
            try:
                try:
                    fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
                except BlockingIOError:
                    wait()
                    fcntl.flock(file, fcntl.LOCK_EX)
                alone = True
            except OSError:
                alone = False
            yield alone

    def _make(self, entry: pathlib.Path, build: Build, alone: bool) -> None:
        if alone:
            for left in self.folder.glob(f"{entry.name}.*{PARTIAL}"):
                shutil.rmtree(left, ignore_errors=True)
        with self._told():
            if entry.is_dir():  # and not whole
                shutil.rmtree(entry)
            entry.unlink(missing_ok=True)
            partial = pathlib.Path(
                tempfile.mkdtemp(prefix=f"{entry.name}.", suffix=PARTIAL, dir=self.folder)
            )
        try:
            made = self._built(build, partial)
            with self._told():
                _sync(made)
                try:
                    made.rename(entry)
                except OSError:  # a folder that is not empty: another was faster
                    if not entry.exists():
                        raise
                _sync_one(self.folder)
        finally:
            shutil.rmtree(partial, ignore_errors=True)

    def _built(self, build: Build, partial: pathlib.Path) -> pathlib.Path:
        """The result of the build; of its errors, only a full disk is the cache's."""
        try:
            return pathlib.Path(build(partial))
        except OSError as error:
            if error.errno == errno.ENOSPC:
                raise CacheError(full_disk(self.folder)) from error
            raise
