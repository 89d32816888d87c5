# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Experiments: variants of the core, scenes and measures, as tables that one runner measures."""
