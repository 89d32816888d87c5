# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The figures of the thesis's chapter 7 for our cores."""
