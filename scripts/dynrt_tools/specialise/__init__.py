# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Makes the smallest core that renders a scene."""
