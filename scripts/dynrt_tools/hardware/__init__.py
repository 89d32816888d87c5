# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""What becomes of the Verilog: lint, synthesis, placement, gates, other simulators."""
