# Copyright the dynrt authors.
# SPDX-License-Identifier: Apache-2.0
"""The page of an error report, made of error.json alone."""

import html
import json


def write_page(source, goal):
    report = json.loads(source.read_text(encoding="utf-8"))
    goal.write_text("<!doctype html><meta charset='utf-8'><title>dynrt report error</title><pre>" +
                    html.escape(json.dumps(report["runs"], indent=1)) + "</pre>\n",
                    encoding="utf-8")
