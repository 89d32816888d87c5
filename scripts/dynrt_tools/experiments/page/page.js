// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The page of an experiment. What is shown is in the address behind "#", so that a view can be kept and
// sent.
"use strict";

const keys = ["scene", "y", "x0", "x1", "variant", "sort"];
const {y: ups, x: rights} = report.axes;
const first = {scene: Object.keys(report.scenes)[0], y: report.axes.first || ups[0],
               x0: (rights[0] || [])[0], x1: (rights[1] || [])[0], variant: report.reference, sort: ""};
const state = {...first};

function read_address() {
  for (const [key, value] of new URLSearchParams(location.hash.slice(1))) {
    if (keys.includes(key)) state[key] = value;
  }
  const known = {scene: Object.keys(report.scenes), y: ups, x0: rights[0], x1: rights[1],
                 variant: report.rows.map((r) => r.variant)};
  for (const [key, values] of Object.entries(known)) {
    if (!(values || []).includes(state[key])) state[key] = first[key];
  }
}
function choose(change) {
  Object.assign(state, change);
  const address = new URLSearchParams(keys.filter((k) => state[k]).map((k) => [k, state[k]]));
  history.replaceState(null, "", `#${address}`);
  show();
}
const rows_of_scene = () => report.rows.filter((r) => r.scene === state.scene);

// ---- The tables ----

/// A number in brackets, of another core's clock, is sorted as the number.
function value_of(row, column) {
  const value = figure(row, column.key);
  const bare = typeof value === "string" ? parseFloat(value.replace("(", "")) : NaN;
  return column.words || Number.isNaN(bare) ? value : bare;
}
function sorted(rows) {
  const [, key, direction] = state.sort.match(/^(.*) (up|down)$/) || [];
  const column = column_of(key);
  if (!column) return rows;
  const sign = direction === "down" ? -1 : 1;
  return [...rows].sort((a, b) => {
    const [u, v] = [value_of(a, column), value_of(b, column)];
    if (u === null || v === null) return (u === null) - (v === null);  // at the end either way
    return sign * (typeof u === typeof v && typeof u === "number" ? u - v
                                                                  : String(u).localeCompare(String(v)));
  });
}

function draw_head(table) {
  const head = table.select("thead").html("");
  const groups = head.append("tr").attr("class", "groups");
  for (const group of new Set(columns.map((c) => c.group))) {
    groups.append("th").attr("colspan", columns.filter((c) => c.group === group).length).text(group);
  }
  const cells = head.append("tr").selectAll("th").data(columns).join("th")
      .attr("class", (c) => (c.words ? "words" : null))
      .attr("title", (c) => (c.meaning ? `${c.meaning} (${c.unit})` : null))
      .attr("aria-sort", (c) => (state.sort === `${c.key} up` ? "ascending"
                                  : state.sort === `${c.key} down` ? "descending" : "none"));
  cells.append("button").attr("tabindex", 0).attr("type", "button").text((c) => c.name)
      .on("click", (c) => choose({sort: `${c.key} ${state.sort === `${c.key} up` ? "down" : "up"}`}));
}

function draw_table(fronts) {
  draw_head(d3.select("#table"));
  const rows = d3.select("#table tbody").html("").selectAll("tr").data(sorted(report.rows)).join("tr")
      .attr("data-variant", (r) => r.variant)
      .attr("class", (r) => (r.scene === state.scene && (!state.variant || r.variant === state.variant)
                                 ? "chosen" : null))
      .on("click", (r) => choose({scene: r.scene, variant: r.variant}));
  rows.each(function (row) {
    const line = d3.select(this);
    for (const column of columns.filter((c) => !row.refused || c.group === "variant")) {
      const cell = line.append("td").attr("class", column.words ? "words" : null)
          .text(text(figure(row, column.key)));
      if (column.key === "variant" && fronts.length && row.scene === state.scene) {
        cell.append("span").attr("class", "front")
            .text(` ${fronts.map((f) => (f.has(row.variant) ? "●" : "○")).join("")}`);
      }
    }
    if (row.refused) {
      line.append("td").attr("class", "words faint")
          .attr("colspan", columns.filter((c) => c.group !== "variant").length).text(row.refused);
    }
  });
}

function draw_tables() {
  for (const one of report.tables) {
    const section = d3.select("#tables").append("section").attr("data-table", one.title);
    section.append("h2").text(one.title);
    if (one.about) section.append("p").attr("class", "faint").text(one.about);
    if (one.items) section.append("ul").selectAll("li").data(one.items).join("li").text((t) => t);
    if (!one.rows) continue;
    const table = section.append("div").attr("class", "scroll").append("table").attr("class", "wrapped");
    fill_row(table.append("thead"), "th", one.columns);
    const body = table.append("tbody");
    for (const row of one.rows) fill_row(body, "td", row.map(text));
  }
}

// ---- All of it ----

function show_plots() {
  const y = column_of(state.y);
  by_id("scatter").hidden = !ups.length;
  for (const label of document.querySelectorAll(".axes")) {
    const id = label.querySelector("select").id;
    label.hidden = !ups.length || (id === "x1" && !rights[1].length);
  }
  by_id("meaning").textContent = !ups.length ? "No run gives an error; the table says why."
                               : y.meaning ? `${name_of_column(y)}: ${y.meaning}.` : "";
  by_id("scatter").hidden = !ups.length && !report.axes.wanted;
  if (!ups.length) return [];
  const named = (list) => list.map((k) => ({value: k, text: name_of_column(column_of(k))}));
  fill_options("y", named(ups), state.y, (value) => choose({y: value}));
  draw_families(d3.select("#legend"));
  const fronts = [];
  rights.forEach((list, i) => {
    const plot = d3.select(`#plot${i}`);
    plot.node().closest("figure").hidden = !list.length;
    if (!list.length) return;
    fill_options(`x${i}`, named(list), state[`x${i}`], (value) => choose({[`x${i}`]: value}));
    const x = column_of(state[`x${i}`]);
    const points = draw_scatter(plot, rows_of_scene(), x, y, state.variant,
                                (variant) => choose({variant}));
    const absent = rows_of_scene().filter((r) => !points.some((p) => p.row === r)).map((r) => r.variant);
    plot.node().nextElementSibling.textContent =
        absent.length ? `Without a figure for it, so not in the plot: ${absent.join(", ")}.` : "";
    fronts.push(front(points, x, y));
  });
  return fronts;
}

function show_pictures() {
  by_id("shown").hidden = !Object.keys(report.pictures).length;
  const rows = rows_of_scene();
  fill_options("variant", rows.map((r) => ({value: r.variant, text: r.variant})), state.variant,
               (variant) => choose({variant}));
  const row = rows.find((r) => r.variant === state.variant) || {};
  by_id("differs").textContent = row.refused || row.differs || "";
  const truth = report.scenes[state.scene].truth;
  for (const [id, picture] of [["image", row.image], ["truth", truth], ["difference", row.difference]]) {
    if (picture) by_id(id).src = report.pictures[picture];
    by_id(id).style.visibility = picture ? "visible" : "hidden";
  }
}

function show() {
  hide_tip();
  fill_options("scene", Object.keys(report.scenes).map((n) => ({value: n, text: n})), state.scene,
               (scene) => choose({scene}));
  by_id("scene-about").textContent = report.scenes[state.scene].about || "";
  const fronts = show_plots();
  show_pictures();
  const figures = d3.select("#figures").html("");
  for (const one of report.figures) draw_figure(figures, one, state.scene);
  draw_table(fronts);
}

document.title = `dynrt: ${report.title}`;
by_id("title").textContent = report.title;
by_id("about").textContent = report.about;
by_id("keyboard").hidden = !report.figures.length;
for (const sentence of report.missing) {
  d3.select("#missing ul").append("li").text(sentence);
  by_id("missing").hidden = false;
}
draw_tables();
addEventListener("hashchange", () => { read_address(); show(); });
read_address();
show();
