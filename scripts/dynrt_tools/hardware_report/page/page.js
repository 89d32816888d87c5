// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The page of a hardware report: the table of all scenes, and the plots of one. What is shown is in the
// address behind "#", so that a view can be kept and sent.
"use strict";

const keys = ["scene", "sort"];
const size = {width: 560, height: 360, left: 58, right: 20, top: 30, bottom: 48};
const state = {scene: Object.keys(report.scenes)[0], sort: ""};

function read_address() {
  for (const [key, value] of new URLSearchParams(location.hash.slice(1))) {
    if (keys.includes(key)) state[key] = value;
  }
  if (!(state.scene in report.scenes)) state.scene = Object.keys(report.scenes)[0];
}
function choose(change) {
  Object.assign(state, change);
  const address = new URLSearchParams(keys.filter((k) => state[k]).map((k) => [k, state[k]]));
  history.replaceState(null, "", `#${address}`);
  show();
}

// ---- A plot ----

/// The same colour for the same curve of each configuration; a dashed curve has that of its twin.
function colours_of(curves) {
  const labels = [...new Set(curves.map(label_of))];
  return (curve) => palette[labels.indexOf(label_of(curve)) % palette.length];
}
const label_of = (curve) =>
    (curve.several ? curve.label.split(",")[0] : curve.configuration);
const name_of = (curve) =>
    (curve.several ? `${curve.configuration}, ${curve.label}` : curve.configuration);

function scales_of(curves, figure, mark) {
  const xs = curves.flatMap((c) => c.points.map((p) => p[0]));
  const ys = curves.flatMap((c) => c.points.map((p) => p[1])).concat(mark ? [mark.high] : []);
  const top = figure.limit === null ? 1.08 * d3.max(ys) : figure.limit;
  return [d3.scaleLinear().domain([0, d3.max(xs)]).range([size.left, size.width - size.right]),
          d3.scaleLinear().domain([0, top || 1]).range([size.height - size.bottom, size.top])];
}

function draw_axes(svg, x, y, figure) {
  const bottom = size.height - size.bottom;
  svg.append("g").attr("class", "grid").attr("transform", `translate(${size.left},0)`)
      .call(d3.axisLeft(y).ticks(6).tickSize(size.left - size.width + size.right))
      .selectAll("text").remove();
  svg.append("g").attr("class", "axis").attr("transform", `translate(0,${bottom})`)
      .call(d3.axisBottom(x).ticks(8).tickSizeOuter(0));
  svg.append("g").attr("class", "axis").attr("transform", `translate(${size.left},0)`)
      .call(d3.axisLeft(y).ticks(6).tickSizeOuter(0));
  svg.append("text").attr("class", "title").attr("x", size.width - size.right)
      .attr("y", size.height - 10).attr("text-anchor", "end").text(`${figure.over} →`);
  svg.append("text").attr("class", "title").attr("x", 4).attr("y", 14).text(figure.unit);
}

/// A value of the thesis's text: a band, or a point.
function draw_mark(svg, x, y, mark) {
  const group = svg.append("g").attr("class", "thesis");
  if (mark.x === null) {
    group.append("rect").attr("x", size.left).attr("width", size.width - size.left - size.right)
        .attr("y", y(mark.high)).attr("height", y(mark.low) - y(mark.high))
        .attr("fill", "var(--faint)").attr("opacity", 0.25);
  } else {
    group.append("path").attr("d", d3.symbol(d3.symbolDiamond, 90)())
        .attr("transform", `translate(${x(mark.x)},${y(mark.low)})`).attr("fill", "var(--faint)");
  }
  const [at, up] = mark.x === null ? [size.left + 6, y(mark.high) - 4] : [x(mark.x) + 9, y(mark.low) - 6];
  group.append("text").attr("class", "label").attr("x", at).attr("y", up).text("thesis");
}

function draw_curves(svg, curves, x, y, figure) {
  const colour = colours_of(curves);
  for (const curve of curves) {
    svg.append("path").attr("class", "curve").attr("fill", "none").attr("stroke", colour(curve))
        .attr("stroke-width", 1.8).attr("stroke-dasharray", curve.dashed ? "6 4" : null)
        .attr("d", d3.line().x((p) => x(p[0])).y((p) => y(p[1]))(curve.points));
  }
  const points = curves.flatMap((curve, row) =>
      curve.points.map((p, column) => ({curve, row, column, x: p[0], y: p[1]})));
  const dots = svg.append("g").selectAll("circle").data(points).join("circle")
      .attr("class", "point").attr("cx", (p) => x(p.x)).attr("cy", (p) => y(p.y)).attr("r", 4)
      .attr("stroke", (p) => colour(p.curve)).attr("fill", (p) => colour(p.curve))
      .attr("tabindex", (p) => (p.row === 0 && p.column === 0 ? 0 : -1)).attr("role", "img")
      .attr("aria-label", (p) => `${name_of(p.curve)}: ${text(p.y)} ${figure.unit} at ${p.x} ${figure.over}`)
      .on("mouseenter focus", function (p) {
        fill_tip(this, name_of(p.curve), "", [[figure.over, p.x], [figure.unit, p.y]]);
      })
      .on("mouseleave blur", hide_tip)
      .on("keydown", (p) => go(dots, p, d3.event));
}

const steps = {ArrowRight: [0, 1], ArrowLeft: [0, -1], ArrowUp: [-1, 0], ArrowDown: [1, 0]};
/// Moves the focus to the next point of the curve, or to the next curve.
function go(dots, from, event) {
  const step = steps[event.key];
  if (!step) return;
  event.preventDefault();
  const curves = new Set(dots.data().map((p) => p.row)).size;
  const row = (from.row + step[0] + curves) % curves;
  const others = dots.data().filter((p) => p.row === row);
  const column = Math.min(Math.max(from.column + step[1], 0), others.length - 1);
  dots.attr("tabindex", (p) => (p.row === row && p.column === column ? 0 : -1))
      .filter((p) => p.row === row && p.column === column).node().focus();
}

function draw_legend(parent, curves) {
  const colour = colours_of(curves);
  const legend = parent.append("div").attr("class", "legend");
  for (const curve of curves) {
    const entry = legend.append("span");
    entry.append("svg").attr("viewBox", "0 0 22 14").style("width", "22px").append("line")
        .attr("x1", 1).attr("x2", 21).attr("y1", 7).attr("y2", 7).attr("stroke", colour(curve))
        .attr("stroke-width", 2.5).attr("stroke-dasharray", curve.dashed ? "5 3" : null);
    entry.append("span").text(` ${name_of(curve)}`);
  }
}

/// The same figures for a reader who wants numbers.
function draw_numbers(parent, curves, figure) {
  const details = parent.append("details");
  details.append("summary").text("The figures of the plot");
  const xs = [...new Set(curves.flatMap((c) => c.points.map((p) => p[0])))].sort((a, b) => a - b);
  const table = details.append("div").attr("class", "scroll").append("table").attr("class", "numbers");
  fill_row(table.append("thead"), "th", [figure.over, ...curves.map(name_of)]);
  const body = table.append("tbody");
  for (const x of xs) {
    const of = (c) => (c.points.find((p) => p[0] === x) || [x, null])[1];
    fill_row(body, "td", [text(x), ...curves.map((c) => text(of(c)))]);
  }
}
function fill_row(parent, tag, cells) {
  parent.append("tr").selectAll(tag).data(cells).join(tag).text((c) => c);
}

/// Of a figure with one curve a configuration all together, else one plot for each configuration.
function groups_of(figure, plot) {
  const curves = plot.curves.map((c) => ({...c, several: figure.several}));
  if (!figure.several) return [curves];
  const names = [...new Set(curves.map((c) => c.configuration))];
  return names.map((name) => curves.filter((c) => c.configuration === name));
}

function draw_figure(parent, figure) {
  const plot = figure.plots[state.scene];
  const section = parent.append("section").attr("data-figure", figure.name)
      .attr("class", figure.several ? "wide" : null);
  section.append("h2").text(`${figure.title} over ${figure.over} (thesis figure ${figure.name})`);
  if (figure.said) section.append("p").text(`The thesis's text: ${figure.said}`);
  if (!plot.curves.length) {
    section.append("p").text("No frame of this scene gives it; the list above says what is missing.");
    return;
  }
  const plots = section.append("div").attr("class", "plots");
  for (const curves of groups_of(figure, plot)) {
    const one = plots.append("figure");
    const names = [...new Set(curves.map((c) => c.configuration))].join(" and ");
    const svg = one.append("svg").attr("viewBox", `0 0 ${size.width} ${size.height}`)
        .attr("role", "group").attr("aria-label", `${figure.title} over ${figure.over}, ${names}`);
    const [x, y] = scales_of(curves, figure, plot.mark);
    draw_axes(svg, x, y, figure);
    if (plot.mark) draw_mark(svg, x, y, plot.mark);
    draw_curves(svg, curves, x, y, figure);
    draw_legend(one, curves);
    draw_numbers(one, curves, figure);
  }
}

// ---- The tables ----

const columns = ["scene", "configuration", ...report.columns];
const words = (c) => ["scene", "configuration", "thesis's frames per second"].includes(c);
/// A number in brackets, of another core's clock, is sorted as the number.
const value_of = (row, column) => {
  const value = row[column];
  const number = typeof value === "string" ? parseFloat(value.replace("(", "")) : NaN;
  return words(column) || Number.isNaN(number) ? value : number;
};

function sorted(rows) {
  const [, key, direction] = state.sort.match(/^(.*) (up|down)$/) || [];
  if (!columns.includes(key)) return rows;
  const sign = direction === "down" ? -1 : 1;
  return [...rows].sort((a, b) => {
    const [u, v] = [value_of(a, key), value_of(b, key)];
    if (u === null || v === null) return (u === null) - (v === null);  // at the end either way
    return sign * (typeof u === "number" ? u - v : String(u).localeCompare(String(v)));
  });
}

function draw_table() {
  const head = d3.select("#table thead").html("").append("tr").selectAll("th").data(columns).join("th")
      .attr("class", (c) => (words(c) ? "words" : null))
      .attr("aria-sort", (c) => (state.sort === `${c} up` ? "ascending"
                                  : state.sort === `${c} down` ? "descending" : "none"));
  head.append("button").attr("tabindex", 0).attr("type", "button").text((c) => c)
      .on("click", (c) => choose({sort: `${c} ${state.sort === `${c} up` ? "down" : "up"}`}));
  const rows = d3.select("#table tbody").html("").selectAll("tr").data(sorted(report.table)).join("tr")
      .attr("class", (r) => (r.scene === state.scene ? "chosen" : null))
      .on("click", (r) => choose({scene: r.scene}));
  rows.selectAll("td").data((r) => columns.map((c) => [c, r[c]])).join("td")
      .attr("class", ([c]) => (words(c) ? "words" : null)).text(([, value]) => text(value));
}

function draw_gates() {
  const names = ["configuration", "C_AU", "C_IM", "C_AU + C_IM", "as packets P and lines CL", "clock"];
  fill_row(d3.select("#gates thead"), "th", names);
  for (const [name, one] of Object.entries(report.configurations)) {
    const gates = one.gates;
    const [logic, memory] = gates ? [gates.logic, gates.memory] : [null, null];
    fill_row(d3.select("#gates tbody"), "td",
             [name, text(logic), text(memory), text(gates ? logic + memory : null), formula(gates),
              one.clock]);
  }
  fill_row(d3.select("#gates tbody"), "td",
           ["the thesis's", "", "", "", "487,020 + 56,028 P + 996 CL", "at 85 MHz"]);
}
function draw_findings() {
  fill_row(d3.select("#findings thead"), "th", ["scene", "configuration", ...report.found]);
  for (const row of report.findings) {
    fill_row(d3.select("#findings tbody"), "td",
             [row.scene, row.configuration, ...report.found.map((c) => text(row[c]))]);
  }
  fill_row(d3.select("#findings tbody"), "td",
           ["the thesis's", "", ...report.found.map((c) => text(report.said[c]))]);
}
function draw_additions() {
  by_id("added").hidden = report.additions.length === 0;
  fill_row(d3.select("#additions thead"), "th", ["scene", "configuration", "addition", ...report.added]);
  for (const row of report.additions) {
    fill_row(d3.select("#additions tbody"), "td",
             [row.scene, row.configuration, row.addition, ...report.added.map((c) => text(row[c]))]);
  }
}
function formula(gates) {
  if (!gates || !gates.split) return "–";
  const [fixed, packet, line] = ["fixed", "packet", "line"].map((part) =>
      d3.format(",.0f")(gates.split[part].logic + gates.split[part].memory));
  return `${fixed} + ${packet} P + ${line} CL`;
}

// ---- All of it ----

function show() {
  hide_tip();
  fill_options("scene", Object.keys(report.scenes).map((n) => ({value: n, text: n})), state.scene,
               (scene) => choose({scene}));
  by_id("about").textContent = `${report.scenes[state.scene].about}; ${report.size} pixels`;
  draw_table();
  const figures = d3.select("#figures").html("");
  for (const figure of report.figures) draw_figure(figures, figure);
}

for (const [id, sentences] of [["missing", report.missing], ["reading", report.reading]]) {
  const list = by_id(id).querySelector("ul") || by_id(id);
  for (const sentence of sentences) list.append(Object.assign(document.createElement("li"),
                                                              {textContent: sentence}));
  by_id(id).hidden = sentences.length === 0;
}
by_id("frames").textContent = report.frames === 1 ? "the first frame" : `${report.frames} frames`;
draw_gates();
draw_findings();
draw_additions();
addEventListener("hashchange", () => { read_address(); show(); });
read_address();
show();
