# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The configurations of the core, for scripts: hls/configs/generate alone knows the keys."""

import importlib.machinery
import importlib.util
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
LISTED = ROOT / "hls" / "configs" / "configs.json"


def load_generate():
    """hls/configs/generate as a module, though its name does not end as one's does."""
    path = ROOT / "hls" / "configs" / "generate"
    loader = importlib.machinery.SourceFileLoader("generate", str(path))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("generate", loader))
    sys.modules["generate"] = module  # its dataclasses look for their module
    writes, sys.dont_write_bytecode = sys.dont_write_bytecode, True
    loader.exec_module(module)
    sys.dont_write_bytecode = writes
    return module
