# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Keys that configurations had before, and what has the place of each."""

_FAST = "'datapath' = \"fast\" has it with all that travelled together"
GONE: dict[str, str] = {
    "rays_sent": _FAST,
    "divider": _FAST,
    "camera": _FAST,
    "sums": _FAST,
    "leaves": _FAST,
    "packet_fifos": _FAST,
    "item_cost": "it follows from 'datapath'",
    "object_cost": "it follows from 'datapath'",
    "object_box": "it follows from 'origins': boxes are tested in the world where these are common",
    "stack_entries": "it follows from 'origins': a stack keeps four where these are common, else all",
    "top_stack_depth": "'stack_depth' holds for the trees of both levels",
    "second_ways": "the second level always has four",
    "second_line": "it follows from 'line_nodes' and 'port_bytes', whichever asks for more",
    "sram_latency": "the banks always take three clocks",
}
