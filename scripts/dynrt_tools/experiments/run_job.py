# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Runs one job of an experiment and puts its folder in place once it is whole. Input that a variant
cannot render is a result too: it gives the reason."""

import argparse
import pathlib
import shutil
import subprocess
import sys
import tempfile

from dynrt_tools.experiments.jobs import CORE, OUT, RESULT, SCRATCH
from dynrt_tools.project import read_json, write_json

MISTAKE = 2  # dynrt's exit code where the input cannot be rendered
KILLED = "it ended without a word, as a program does that is killed"


def placed(word: str, out: str, scratch: str) -> str:
    """A word with its file where the job's folders are."""
    for mark, folder in ((OUT, out), (SCRATCH, scratch)):
        if word.startswith(mark) or word == mark.rstrip("/"):
            return folder + word[len(mark) - 1 :]
    return word


def main() -> None:
    parser = argparse.ArgumentParser(prog="scripts/run_job", description=__doc__)
    parser.add_argument("job", type=pathlib.Path, metavar="JOB.json", help="its description")
    parser.add_argument("folder", type=pathlib.Path, metavar="FOLDER", help="of its result")
    args = parser.parse_args()
    job = read_json(args.job)
    part = args.folder.with_name(args.folder.name + ".part")
    shutil.rmtree(part, ignore_errors=True)
    part.mkdir(parents=True)
    with tempfile.TemporaryDirectory() as scratch:
        if job["keys"] is not None:
            write_json(pathlib.Path(placed(CORE, "", scratch)), job["keys"])
        words = [placed(word, str(part), scratch) for word in job["words"]]
        done = subprocess.run(words, capture_output=True, text=True, check=False)
    sentence = done.stderr.strip().removeprefix("dynrt: ")
    # A file that cannot be written or loaded is no property of the variant.
    defect = str(part) in sentence or "model.so" in sentence
    if done.returncode == MISTAKE and job["refusable"] and not defect:
        write_json(part / RESULT, {"refused": sentence})
    elif done.returncode:
        sys.exit(sentence or KILLED)
    part.replace(args.folder)
