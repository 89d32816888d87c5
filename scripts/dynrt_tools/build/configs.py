# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The configurations of the core, for scripts: hls/configs/configurations alone knows the keys."""

import importlib.util
import pathlib
import sys
from types import ModuleType

from dynrt_tools import project
from dynrt_tools.project import Failed, Json

PACKAGE = project.ROOT / "hls" / "configs" / "configurations"


def load_configurations() -> ModuleType:
    """The package, which lies with the configurations and not with the scripts."""
    if loaded := sys.modules.get(PACKAGE.name):
        return loaded
    spec = importlib.util.spec_from_file_location(
        PACKAGE.name, PACKAGE / "__init__.py", submodule_search_locations=[str(PACKAGE)]
    )
    assert spec and spec.loader
    module = importlib.util.module_from_spec(spec)
    sys.modules[PACKAGE.name] = module
    writes, sys.dont_write_bytecode = sys.dont_write_bytecode, True
    spec.loader.exec_module(module)
    sys.dont_write_bytecode = writes
    return module


def read_file(path: pathlib.Path) -> Json:
    """Every key of a file with one configuration; throws Failed."""
    name = "stated"  # which the user has not given, so no sentence has it
    configurations = load_configurations()
    try:
        return dict(configurations.read_one(path, name))
    except configurations.Refused as error:
        sentence = str(error).replace(f"configuration '{name}': ", "")
        raise Failed(f"line {error.line}: {sentence}" if error.line else sentence) from error
