# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Proves what verif/formal/proofs.json states."""
