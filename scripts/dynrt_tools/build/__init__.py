# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""How the project is built: configurations, the cache of builds, layers of the sources."""
