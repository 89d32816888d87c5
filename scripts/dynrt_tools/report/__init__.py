# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The error report: variants of the core against the truth, and the choice among them."""
