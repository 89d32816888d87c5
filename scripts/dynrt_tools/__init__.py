# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The Python of the project. Commands in scripts/ call the main() of one of its modules."""
