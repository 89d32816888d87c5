# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""Proves the properties that verif/formal/proofs.json states."""
