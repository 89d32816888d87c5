# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The program's side of `dynrt specialise`: it reads the scene once and answers what a script asks
about it (host/app/analyst.h). For --specialise that is the program that runs the script, at its
standard input and output; else the script starts one."""

import contextlib
import json
import subprocess
import sys
import tempfile
from collections.abc import Iterator, Sequence
from typing import IO, NamedTuple

from dynrt_tools.project import Failed, Json


class FrameCosts(NamedTuple):
    clocks: int
    bytes_per_ray: float | None  # read of the scene; none of a core without counters


class Analyst:
    def __init__(self, questions: IO[str], answers: IO[str], mark: str = "") -> None:
        """`mark` begins each question."""
        self.questions, self.answers, self.mark = questions, answers, mark

    def ask(self, question: Json) -> Json:
        try:
            print(self.mark + json.dumps(question), file=self.questions, flush=True)
            line = self.answers.readline()
        except BrokenPipeError:
            line = ""
        if not line:
            raise EOFError
        answer: Json = json.loads(line)
        if "refused" in answer:
            raise Failed(answer["refused"])
        return answer

    def needs(self, configuration: object = None) -> tuple[Json, str]:
        """What `dynrt needs` says, and its line about the scene. `configuration` is the general
        one; without it the scene decides."""
        question = {"ask": "needs"}
        if configuration:
            question["configuration"] = str(configuration)
        answer = self.ask(question)
        return answer, answer.pop("about")

    def frame(
        self, configuration: object, schedules: object, packets: int, lines: int
    ) -> FrameCosts:
        """What a frame takes on the native model, by the schedules in a folder."""
        answer = self.ask(
            {
                "ask": "frame",
                "configuration": str(configuration),
                "schedules": str(schedules),
                "packets": packets,
                "lines": lines,
            }
        )
        return FrameCosts(answer["clocks"], answer["bytes_per_ray"])


@contextlib.contextmanager
def started(command: Sequence[object]) -> Iterator[Analyst]:
    """A program that answers, until the script is done with it."""
    with tempfile.TemporaryFile("w+", encoding="utf-8", errors="replace") as complaints:
        with subprocess.Popen(
            list(map(str, command)),
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=complaints,
            text=True,
        ) as process:
            assert process.stdin and process.stdout
            try:
                yield Analyst(process.stdin, process.stdout)
                return
            except EOFError:
                with contextlib.suppress(BrokenPipeError):
                    process.stdin.close()
                process.wait()
            except BaseException:
                process.terminate()
                raise
        complaints.seek(0)
        said = complaints.read().strip().removeprefix("dynrt: ")
        raise Failed(said or f"the analysis ended with {process.returncode}")


@contextlib.contextmanager
def above() -> Iterator[Analyst]:
    """The program that runs this script."""
    try:
        yield Analyst(sys.stdout, sys.stdin, mark="? ")
    except EOFError as error:
        raise Failed("the program that analyses the scene has ended") from error
