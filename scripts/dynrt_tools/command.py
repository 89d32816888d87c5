# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""How a command begins and how Ctrl-C ends it: with one sentence, exit code 130 and no tool left."""

import concurrent.futures
import contextlib
import importlib
import os
import pathlib
import signal
import sys
from collections.abc import Callable
from types import TracebackType
from typing import NoReturn

from dynrt_tools import project

INTERRUPTED = 130  # as a shell counts a program that SIGINT has ended


def run(module: str) -> NoReturn:
    """Runs the function main of a module of dynrt_tools and ends with its exit code."""

    def main() -> int | None:
        code: int | None = importlib.import_module(f"dynrt_tools.{module}").main()
        return code

    guarded(main)


def guarded(main: Callable[[], int | None]) -> NoReturn:
    """Runs a function and ends with its exit code, or says that it was interrupted."""
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        end_tools()
        project.show_progress("")
        name = pathlib.Path(sys.argv[0]).name
        print(f"{name}: interrupted before its end", file=sys.stderr)
        sys.exit(INTERRUPTED)


def end_tools() -> None:
    """Ends the programs that this one has started and that still run."""
    for listed in pathlib.Path("/proc/self/task").glob("*/children"):
        with contextlib.suppress(OSError):  # the thread or the program has ended by itself
            for process in listed.read_text(encoding="ascii").split():
                os.kill(int(process), signal.SIGTERM)


class Pool(concurrent.futures.ThreadPoolExecutor):
    """Threads that run tools. An error or Ctrl-C begins no further job, and Ctrl-C ends the tools."""

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> bool | None:
        if kind is not None:
            self.shutdown(wait=False, cancel_futures=True)
        if kind is KeyboardInterrupt:
            end_tools()
        return super().__exit__(kind, error, trace)
