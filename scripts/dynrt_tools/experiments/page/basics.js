// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// What all parts of the page share: the report, numbers as text, lists to choose from, and the box that
// tells the figures of a point.
"use strict";

const report = JSON.parse(document.getElementById("report").textContent);
const palette = ["#4269d0", "#d9730d", "#3a9a56", "#b2528f", "#8a6d1d", "#2a9aa5", "#9c6ade",
                 "#7a7f87", "#e0559b", "#5f8f00", "#c0392b", "#7fa8d9"];
const by_id = (id) => document.getElementById(id);

function text(value) {
  if (value === null || value === undefined) return "–";
  if (typeof value !== "number") return String(value);
  if (Number.isInteger(value)) return d3.format(",")(value);
  const size = Math.abs(value);
  return size >= 1000 ? d3.format(",.0f")(value)
       : size >= 0.001 ? String(+value.toPrecision(4)) : value.toExponential(2);
}

/// Shows the box #tip beside an element: a title, a line about it, and names with their values.
function fill_tip(element, title, about, rows) {
  const tip = by_id("tip");
  tip.replaceChildren();
  d3.select(tip).append("b").text(title);
  d3.select(tip).append("div").attr("class", "faint").text(about);
  const table = d3.select(tip).append("table");
  for (const [name, value] of rows) {
    const row = table.append("tr");
    row.append("td").text(name);
    row.append("td").text(text(value));
  }
  tip.hidden = false;
  const at = element.getBoundingClientRect();
  const left = Math.min(at.right + 12, document.documentElement.clientWidth - tip.offsetWidth - 8);
  const top = at.bottom + tip.offsetHeight + 12 > innerHeight ? at.top - tip.offsetHeight - 8
                                                              : at.bottom + 8;
  tip.style.left = `${Math.max(left, 4) + scrollX}px`;
  tip.style.top = `${Math.max(top, 4) + scrollY}px`;
}
function hide_tip() { by_id("tip").hidden = true; }

/// Fills the list of this id; `act` takes the value that the reader chooses.
function fill_options(id, values, chosen, act) {
  d3.select(`#${id}`).selectAll("option").data(values).join("option")
      .attr("value", (v) => v.value).property("selected", (v) => v.value === chosen)
      .text((v) => v.text);
  by_id(id).onchange = (event) => act(event.target.value);
}

function fill_row(parent, tag, cells) {
  return parent.append("tr").selectAll(tag).data(cells).join(tag).text((c) => c);
}

const columns = report.columns;
const column_of = (key) => columns.find((c) => c.key === key);
const name_of_column = (c) => [c.group, c.name].filter((w) => w).join(" ");
const unit_of = (c) => (c.unit && c.unit !== "1" ? `, ${c.unit}` : "");
/// A figure of a row by its column's key; null if it is not known.
function figure(row, key) {
  if (key === "scene" || key === "variant" || key === "differs") return row[key];
  const value = (row.figures || {})[key];
  return value === undefined ? null : value;
}
