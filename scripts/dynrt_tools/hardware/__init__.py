# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Tools on the Verilog: lint, synthesis, placement, gates, other simulators."""
