# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The documentation: pages made from the sources, their checks, and the site."""
