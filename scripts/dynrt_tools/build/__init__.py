# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""How the project is built: configurations, what is kept of them, layers of the sources."""
