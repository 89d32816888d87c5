# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The table of experiments, a file of `table/` for each, and the variants of the core that they
measure."""

import pathlib
from dataclasses import dataclass

from dynrt_tools.build import configs
from dynrt_tools.experiments.jobs import stated
from dynrt_tools.project import ROOT, Failed, Json, read_json

FOLDER = pathlib.Path(__file__).resolve().parent / "table"
THESIS: Json = read_json(FOLDER / "thesis.json")
# What an entry says beside the keys of its core: of a frame, and of the figures beside which it stands.
SETTINGS = (
    "beside",
    "command",
    "core_mhz",
    "flags",
    "program",
    "schedule",
    "scenes",
    "sdram_mhz",
    "size",
)


@dataclass(frozen=True)
class Variant:
    """A core, and how frames of it are rendered."""

    name: str
    configuration: Json  # every key
    differs: Json  # what the table states: `like` and keys
    settings: Json
    named: str  # as the program knows it, if it does

    def setting(self, name: str, other: object = None) -> object:
        return self.settings.get(name, other)


def names() -> list[str]:
    """The experiments of the table."""
    return sorted(path.stem for path in FOLDER.glob("*.json") if "about" in read_json(path))


def experiment(name: str) -> Json:
    found: Json = read_json(FOLDER / f"{name}.json")
    return found


def base_configuration(name: str) -> Json:
    """Every key of a configuration: one of hls/configs/configs.json, or a file."""
    if name.endswith(".json"):
        try:
            return configs.read_file(pathlib.Path(name))
        except Failed as error:
            raise Failed(f"--config {name}: {error}") from error
    if name.endswith(".so"):
        raise Failed(
            f"--config {name}: a library does not hold its keys; name the file FILE.json "
            "that it was made of"
        )
    listed = configs.load_configurations().listed()
    if name not in listed:
        raise Failed(f"--config {name}: unknown; the configurations are {', '.join(listed)}")
    return dict(listed[name])


def keys_of(like: object) -> Json:
    """The keys in which a listed configuration differs from the first."""
    generate = configs.load_configurations()
    listed = generate.listed()
    if like not in listed:
        raise generate.Refused(f": is like {like!r}; the configurations are {', '.join(listed)}")
    first, whole = next(iter(listed.values())), listed[str(like)]
    return {
        key: value
        for key, value in whole.items()
        if key in generate.KEYS and generate.KEYS[key].inherited and value != first[key]
    }


def like_listed(like: str, own: Json) -> Json:
    """A listed configuration; of one that has keys of its own what it inherits."""
    generate = configs.load_configurations()
    found = base_configuration(like)
    return {
        k: v
        for k, v in found.items()
        if not own or k in generate.KEYS and generate.KEYS[k].inherited
    }


def variant(name: str, entry: Json, base: Json | None, named: str) -> Variant:
    """What an entry of a list states; the configuration `base` is `named` so. Without one it is
    like a listed configuration."""
    generate = configs.load_configurations()
    if (
        not name.replace("-", "_")
        .replace(".", "_")
        .replace(" ", "_")
        .replace(",", "_")
        .isidentifier()
    ):
        raise generate.Refused(
            f"variant '{name}': is no name; write letters, digits, _, - and ., a letter first"
        )
    settings = {key: value for key, value in entry.items() if key in SETTINGS}
    differs = {key: value for key, value in entry.items() if key not in SETTINGS}
    own = {key: value for key, value in differs.items() if key != "like"}
    try:
        like = keys_of(differs["like"]) if "like" in differs else {}
        if base is None:
            base = like_listed(str(differs.get("like", named)), own)
        whole = generate.checked("variant", {**base, **like, **own, "about": name})
    except generate.Refused as error:
        sentence = str(error).removeprefix("configuration 'variant'")
        raise generate.Refused(f"variant '{name}'{sentence}") from error
    known = "" if own else str(differs.get("like", named))
    return Variant(name, dict(whole), differs, settings, known)


def variants(
    path: pathlib.Path, listed: object, base: Json | None, named: str, leave_out: bool = False
) -> dict[str, Variant]:
    """Those of a list, in its order; `path` is where it stands. With `leave_out` those are left out
    whose keys the base's exclude; else they are refused."""
    generate = configs.load_configurations()
    found: dict[str, Variant] = {}
    try:
        if not isinstance(listed, dict) or not all(isinstance(v, dict) for v in listed.values()):
            raise generate.Refused("must be an object of variants by name, each an object of keys")
        for name, entry in listed.items():
            try:
                one = variant(name, entry, base, named)
            except generate.Refused:
                if leave_out:
                    continue
                raise
            known = [stated(other.configuration) for other in found.values()]
            if not leave_out or stated(one.configuration) not in known:
                found[name] = one
    except generate.Refused as error:
        raise Failed(error.at(path)) from error
    return found


def of_experiment(name: str) -> dict[str, Variant]:
    """Those of an experiment of the table, each like a listed configuration."""
    path, table = FOLDER / f"{name}.json", experiment(name)
    listed = dict(table["variants"])
    for core in read_json(ROOT / table["cores"]) if "cores" in table else []:
        listed[core["name"]] = {k: v for k, v in core.items() if k not in ("name", "about")}
    for one, entry in listed.items():
        program = {"program": table["programs"] + one} if "programs" in table else {}
        listed[one] = {**table.get("settings", {}), **program, **entry}
    base = next(iter(configs.load_configurations().listed()))
    return variants(path, listed, None, base)


def with_reference(path: pathlib.Path, base: Json, named: str, own: bool) -> dict[str, Variant]:
    """The variants of a file, which differ from one of them, the reference, and that from nothing.
    A user's `own` list is meant whole; those of the project are for every base."""
    generate = configs.load_configurations()
    try:
        listed = generate.parse(path)
        listed = listed.get("variants", listed) if isinstance(listed, dict) and not own else listed
        found = variants(path, listed, base, named, leave_out=not own)
        if sum(not one.differs for one in found.values()) != 1:
            raise generate.Refused(
                "one variant, and no more, must be {}: that which the others differ from"
            )
    except generate.Refused as error:
        raise Failed(error.at(path)) from error
    return found


def chosen(found: dict[str, Variant], names_: list[str]) -> dict[str, Variant]:
    """Those of these names, and the reference."""
    for name in names_:
        if name not in found:
            raise Failed(f"--variant {name}: unknown; the variants are {', '.join(found)}")
    return {
        name: one for name, one in found.items() if not names_ or name in names_ or not one.differs
    }
