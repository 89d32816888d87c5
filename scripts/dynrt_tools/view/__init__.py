# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The live window of dynrt view in a browser: its test and the pictures of its page."""
