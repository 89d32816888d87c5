# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Measures dynrt and compares each figure with its aim."""
