# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The variants of a report: a configuration of hls/configs/configs.json, and what differs from
it."""

import pathlib

from dynrt_tools.build import configs
from dynrt_tools.project import Failed, Json

LISTED = pathlib.Path(__file__).resolve().parent / "variants.json"


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


def read_variants(path: pathlib.Path, base: Json, leave_out: bool = False) -> dict[str, Json]:
    """By name, in the file's order: every key of its configuration, and those that differ from
    `base`. `like` stands for all in which that configuration differs from the first. One of the
    variants, the reference, differs in none. With `leave_out` those are left out whose keys the
    base's exclude, else they are refused, and those that are as one before them."""
    generate = configs.load_configurations()
    try:
        listed = generate.parse(path)
        if not isinstance(listed, dict) or not all(isinstance(v, dict) for v in listed.values()):
            raise generate.Refused("must be an object of variants by name, each an object of keys")
        variants = {}
        for name, differs in listed.items():
            if not name.replace("-", "_").replace(".", "_").isidentifier():
                raise generate.Refused(
                    f"variant '{name}': is no name; write letters, digits, _, - "
                    "and ., a letter first"
                )
            try:
                own = {key: value for key, value in differs.items() if key != "like"}
                like = keys_of(differs["like"]) if "like" in differs else {}
                config = generate.checked("variant", {**base, **like, **own, "about": name})
            except generate.Refused as error:
                if leave_out:
                    continue
                sentence = str(error).removeprefix("configuration 'variant'")
                raise generate.Refused(f"variant '{name}'{sentence}") from error
            known = [v["configuration"] | {"about": name} for v in variants.values()]
            if leave_out and config in known:
                continue
            variants[name] = {"configuration": config, "differs": differs}
        if sum(not v["differs"] for v in variants.values()) != 1:
            raise generate.Refused(
                "one variant, and no more, must be {}: that which the others differ from"
            )
    except generate.Refused as error:
        raise Failed(error.at(path)) from error
    return variants


def chosen(variants: dict[str, Json], names: list[str]) -> dict[str, Json]:
    """Those of these names, and the reference."""
    for name in names:
        if name not in variants:
            raise Failed(f"--variant {name}: unknown; the variants are {', '.join(variants)}")
    return {
        name: variant
        for name, variant in variants.items()
        if not names or name in names or not variant["differs"]
    }
