# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Measures dynrt and holds what was reached against what is asked."""
