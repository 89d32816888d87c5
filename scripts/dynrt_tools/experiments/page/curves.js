// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The plots of the thesis's figures: curves over packets, lines, bandwidth or pipelines.
"use strict";

const plot_size = {width: 560, height: 360, left: 58, right: 20, top: 30, bottom: 48};

const label_of = (curve) =>
    (curve.several ? curve.label.split(",")[0] : curve.configuration);
const name_of = (curve) =>
    (curve.several ? `${curve.configuration}, ${curve.label}` : curve.configuration);
/// The same colour for the same curve of each configuration; a dashed curve has that of the solid one.
function colours_of(curves) {
  const labels = [...new Set(curves.map(label_of))];
  return (curve) => palette[labels.indexOf(label_of(curve)) % palette.length];
}

function scales_of(curves, one, mark) {
  const {width, height, left, right, top, bottom} = plot_size;
  const xs = curves.flatMap((c) => c.points.map((p) => p[0]));
  const ys = curves.flatMap((c) => c.points.map((p) => p[1])).concat(mark ? [mark.high] : []);
  const most = one.limit === null ? 1.08 * d3.max(ys) : one.limit;
  return [d3.scaleLinear().domain([0, d3.max(xs)]).range([left, width - right]),
          d3.scaleLinear().domain([0, most || 1]).range([height - bottom, top])];
}

function draw_axes(svg, x, y, one) {
  const {width, height, left, right} = plot_size;
  const bottom = height - plot_size.bottom;
  svg.append("g").attr("class", "grid").attr("transform", `translate(${left},0)`)
      .call(d3.axisLeft(y).ticks(6).tickSize(left - width + right)).selectAll("text").remove();
  svg.append("g").attr("class", "axis").attr("transform", `translate(0,${bottom})`)
      .call(d3.axisBottom(x).ticks(8).tickSizeOuter(0));
  svg.append("g").attr("class", "axis").attr("transform", `translate(${left},0)`)
      .call(d3.axisLeft(y).ticks(6).tickSizeOuter(0));
  svg.append("text").attr("class", "title").attr("x", width - right).attr("y", height - 10)
      .attr("text-anchor", "end").text(`${one.over} →`);
  svg.append("text").attr("class", "title").attr("x", 4).attr("y", 14).text(one.unit);
}

/// A value of the thesis's text: a band, or a point.
function draw_mark(svg, x, y, mark) {
  const group = svg.append("g").attr("class", "thesis");
  if (mark.x === null) {
    group.append("rect").attr("x", plot_size.left)
        .attr("width", plot_size.width - plot_size.left - plot_size.right)
        .attr("y", y(mark.high)).attr("height", y(mark.low) - y(mark.high))
        .attr("fill", "var(--faint)").attr("opacity", 0.25);
  } else {
    group.append("path").attr("d", d3.symbol(d3.symbolDiamond, 90)())
        .attr("transform", `translate(${x(mark.x)},${y(mark.low)})`).attr("fill", "var(--faint)");
  }
  const [at, up] = mark.x === null ? [plot_size.left + 6, y(mark.high) - 4]
                                   : [x(mark.x) + 9, y(mark.low) - 6];
  group.append("text").attr("class", "label").attr("x", at).attr("y", up).text("thesis");
}

function draw_curves(svg, curves, x, y, one) {
  const colour_of = colours_of(curves);
  for (const curve of curves) {
    svg.append("path").attr("class", "curve").attr("fill", "none").attr("stroke", colour_of(curve))
        .attr("stroke-width", 1.8).attr("stroke-dasharray", curve.dashed ? "6 4" : null)
        .attr("d", d3.line().x((p) => x(p[0])).y((p) => y(p[1]))(curve.points));
  }
  const points = curves.flatMap((curve, row) =>
      curve.points.map((p, column) => ({curve, row, column, x: p[0], y: p[1]})));
  const dots = svg.append("g").selectAll("circle").data(points).join("circle")
      .attr("class", "point").attr("cx", (p) => x(p.x)).attr("cy", (p) => y(p.y)).attr("r", 4)
      .attr("stroke", (p) => colour_of(p.curve)).attr("fill", (p) => colour_of(p.curve))
      .attr("tabindex", (p) => (p.row === 0 && p.column === 0 ? 0 : -1)).attr("role", "img")
      .attr("aria-label", (p) => `${name_of(p.curve)}: ${text(p.y)} ${one.unit} at ${p.x} ${one.over}`)
      .on("mouseenter focus", function (p) {
        fill_tip(this, name_of(p.curve), "", [[one.over, p.x], [one.unit, p.y]]);
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

/// The names of the curves, in the plot so that a drawing has them too.
function draw_legend(svg, curves) {
  const colour_of = colours_of(curves);
  const legend = svg.append("g").attr("class", "legend")
      .attr("transform", `translate(${plot_size.left},${plot_size.height})`);
  curves.forEach((curve, i) => {
    const entry = legend.append("g").attr("transform", `translate(${250 * (i % 2)},${16 * (i >> 1)})`);
    entry.append("line").attr("x1", 0).attr("x2", 22).attr("y1", 4).attr("y2", 4)
        .attr("stroke", colour_of(curve)).attr("stroke-width", 2.5)
        .attr("stroke-dasharray", curve.dashed ? "5 3" : null);
    entry.append("text").attr("x", 28).attr("y", 8).text(name_of(curve));
  });
  return plot_size.height + 16 * Math.ceil(curves.length / 2);
}

/// The same figures for a reader who wants numbers.
function draw_numbers(parent, curves, one) {
  const details = parent.append("details");
  details.append("summary").text("The figures of the plot");
  const xs = [...new Set(curves.flatMap((c) => c.points.map((p) => p[0])))].sort((a, b) => a - b);
  const table = details.append("div").attr("class", "scroll").append("table").attr("class", "numbers");
  fill_row(table.append("thead"), "th", [one.over, ...curves.map(name_of)]);
  const body = table.append("tbody");
  for (const x of xs) {
    const of = (c) => (c.points.find((p) => p[0] === x) || [x, null])[1];
    fill_row(body, "td", [text(x), ...curves.map((c) => text(of(c)))]);
  }
}

/// Of a figure with one curve a configuration all together, else one plot for each configuration.
function groups_of(one, plot) {
  const curves = plot.curves.map((c) => ({...c, several: one.several}));
  if (!one.several) return [curves];
  const names = [...new Set(curves.map((c) => c.configuration))];
  return names.map((name) => curves.filter((c) => c.configuration === name));
}

function draw_figure(parent, one, scene) {
  const plot = one.plots[scene];
  const section = parent.append("section").attr("data-figure", one.name)
      .attr("class", one.several ? "wide" : null);
  section.append("h2").text(`${one.title} over ${one.over} (thesis figure ${one.name})`);
  if (one.said) section.append("p").text(`The thesis's text: ${one.said}`);
  if (!plot.curves.length) {
    section.append("p").text("No frame of this scene gives it; the list above says what is missing.");
    return;
  }
  const plots = section.append("div").attr("class", "plots");
  for (const curves of groups_of(one, plot)) {
    const part = plots.append("figure");
    const names = [...new Set(curves.map((c) => c.configuration))].join(" and ");
    const svg = part.append("svg").attr("role", "group")
        .attr("aria-label", `${one.title} over ${one.over}, ${names}`).attr("data-names", names);
    const [x, y] = scales_of(curves, one, plot.mark);
    draw_axes(svg, x, y, one);
    if (plot.mark) draw_mark(svg, x, y, plot.mark);
    draw_curves(svg, curves, x, y, one);
    svg.attr("viewBox", `0 0 ${plot_size.width} ${draw_legend(svg, curves)}`);
    draw_numbers(part, curves, one);
  }
}
