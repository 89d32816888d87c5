// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The plots of one figure of each variant over another.
"use strict";

const size = {width: 640, height: 430, left: 74, right: 24, top: 30, bottom: 52};

/// Variants that differ in the same keys are a family, and have a colour.
const families = ["reference", ...new Set(report.rows.map((r) => r.family)
    .filter((f) => f !== "reference"))];
const colour = (row) => palette[families.indexOf(row.family) % palette.length];

/// The variants that no other beats in both figures: none is worse in neither and better in one.
function front(points, x, y) {
  const signs = [x, y].map((c) => ({less: 1, more: -1})[c.better] || 0);
  if (!signs[0] || !signs[1]) return new Set();
  const worse = (a, b) => [signs[0] * (a.x - b.x), signs[1] * (a.y - b.y)];
  const beats = (a, b) => worse(a, b).every((d) => d <= 0 || Number.isNaN(d)) &&
                          worse(a, b).some((d) => d < 0);
  return new Set(points.filter((p) => !points.some((q) => beats(q, p))).map((p) => p.row.variant));
}

/// Pictures that are identical to the truth have no noise: their ratio of signal to noise is infinite.
const number = (value) => (value === "identical" ? Infinity : value);
function points_of(rows, x, y) {
  return rows.map((row) => ({row, x: number(figure(row, x.key)), y: number(figure(row, y.key))}))
      .filter((p) => typeof p.x === "number" && typeof p.y === "number");
}

/// Logarithmic where the values spread. What has no place on the axis, 0 on a logarithmic one or
/// infinity, gets a line of its own beyond its end. `range`: pixels from the least to the largest.
function scale_of(values, [from, to], is_error) {
  const proper = values.filter((v) => Number.isFinite(v) && (v > 0 || !is_error));
  const [low, high] = proper.length ? d3.extent(proper) : [1, 10];
  const log = low > 0 && high / low > (is_error ? 20 : 8);
  const scale = log ? d3.scaleLog() : d3.scaleLinear();
  const margin = log ? Math.pow(high / low, 0.06) : (high - low || Math.abs(high) || 1) * 0.08;
  const from_zero = is_error && (values.includes(0) || low - margin < 0.3 * high);
  scale.domain(log ? [low / margin, high * margin] : [from_zero ? 0 : low - margin, high + margin]);
  const room = 26 * Math.sign(to - from);
  const zero_apart = log && values.includes(0);
  const infinite = values.includes(Infinity);
  scale.range([zero_apart ? from + room : from, infinite ? to - room : to]);
  const beyond = zero_apart ? from + room / 6 : infinite ? to - room / 6 : null;
  const is_beyond = (v) => v === Infinity || (log && v === 0);
  return {scale, log, beyond, beyond_text: zero_apart ? "0" : "same",
          place: (v) => (is_beyond(v) ? beyond : scale(v))};
}

function ticks(axis, scale, log) {
  if (!log) return axis.ticks(6).tickFormat(scale.domain()[1] >= 1e5 ? d3.format("~s") : d3.format(",~r"));
  const decades = Math.log10(scale.domain()[1] / scale.domain()[0]);
  const digits = decades < 1 ? [1, 2, 3, 4, 5, 6, 7, 8, 9] : decades < 3 ? [1, 2, 5] : [1];
  const low = Math.floor(Math.log10(scale.domain()[0]));
  const values = d3.range(low, low + Math.ceil(decades) + 2)
      .flatMap((e) => digits.map((d) => d * Math.pow(10, e)))
      .filter((v) => v >= scale.domain()[0] && v <= scale.domain()[1]);
  const format = (v) => (v >= 0.001 && v < 1e6 ? d3.format(",~r")(+v.toPrecision(6))
                                                : d3.format(".0e")(v));
  return axis.tickValues(values).tickFormat(format);
}

/// The first place around a point where its name covers neither point nor name.
function place_labels(points, names) {
  const taken = points.map((p) => ({x0: p.px - 5, x1: p.px + 5, y0: p.py - 5, y1: p.py + 5}));
  const order = [...points].sort((a, b) => b.on_front - a.on_front);
  for (const p of order) {
    const width = 6.6 * p.row.variant.length;
    const places = [[8, 4, "start"], [-8, 4, "end"], [0, -9, "middle"], [0, 18, "middle"],
                    [8, -7, "start"], [-8, -7, "end"], [8, 15, "start"], [-8, 15, "end"]];
    for (const [dx, dy, anchor] of places) {
      const x0 = p.px + dx - (anchor === "end" ? width : anchor === "middle" ? width / 2 : 0);
      const box = {x0, x1: x0 + width, y0: p.py + dy - 11, y1: p.py + dy + 2};
      const inside = box.x0 > size.left && box.x1 < size.width && box.y0 > 0 &&
                     box.y1 < size.height - size.bottom;
      if (!inside || taken.some((t) => box.x0 < t.x1 && t.x0 < box.x1 && box.y0 < t.y1 &&
                                t.y0 < box.y1)) continue;
      taken.push(box);
      names.append("text").attr("class", `label${p.on_front ? " on-front" : ""}`)
          .attr("x", p.px + dx).attr("y", p.py + dy).attr("text-anchor", anchor)
          .text(p.row.variant);
      break;
    }
  }
}

function draw_axis(svg, x, y, across, up) {
  const right = size.width - size.right, bottom = size.height - size.bottom;
  svg.append("g").attr("class", "axis").attr("transform", `translate(0,${bottom})`)
      .call(ticks(d3.axisBottom(across.scale), across.scale, across.log).tickSizeOuter(0));
  const upwards = ticks(d3.axisLeft(up.scale), up.scale, up.log);
  svg.append("g").attr("class", "grid").attr("transform", `translate(${size.left},0)`)
      .call(upwards.tickSize(size.left - right)).selectAll("text").remove();
  svg.append("g").attr("class", "axis").attr("transform", `translate(${size.left},0)`)
      .call(upwards.tickSize(6).tickSizeOuter(0));
  if (up.beyond !== null) {
    svg.append("line").attr("class", "end").attr("x1", size.left).attr("x2", right)
        .attr("y1", up.beyond).attr("y2", up.beyond);
    svg.append("text").attr("x", size.left - 9).attr("y", up.beyond + 4).attr("text-anchor", "end")
        .text(up.beyond_text);
  }
  svg.append("text").attr("class", "title").attr("x", right).attr("y", size.height - 12)
      .attr("text-anchor", "end")
      .text(`${name_of_column(x)}${unit_of(x)}${across.log ? ", logarithmic" : ""} →`);
  const better = {more: "↑ better: ", less: "↓ better: "}[y.better] || "";
  svg.append("text").attr("class", "title").attr("x", 4).attr("y", 14)
      .text(`${better}${name_of_column(y)}${unit_of(y)}${up.log ? ", logarithmic" : ""}`);
}

/// `chosen` is the variant that is marked, `act` takes the one that the reader chooses.
function draw_scatter(svg, rows, x, y, chosen, act) {
  svg.attr("viewBox", `0 0 ${size.width} ${size.height}`)
      .attr("aria-label", `${name_of_column(y)} over ${name_of_column(x)}`).selectAll("*").remove();
  const points = points_of(rows, x, y);
  if (!points.length) {
    svg.append("text").attr("x", size.left).attr("y", size.height / 2)
        .text(`no variant has figures for ${name_of_column(x)}`);
    return points;
  }
  const across = scale_of(points.map((p) => p.x), [size.left, size.width - size.right], false);
  const up = scale_of(points.map((p) => p.y), [size.height - size.bottom, size.top], Boolean(y.better));
  draw_axis(svg, x, y, across, up);
  const best = front(points, x, y);
  for (const p of points) {
    [p.px, p.py] = [across.place(p.x), up.place(p.y)];
    p.on_front = best.has(p.row.variant);
  }
  const line = points.filter((p) => p.on_front).sort((a, b) => a.x - b.x || b.py - a.py);
  svg.append("path").attr("class", "front")
      .attr("d", d3.line().x((p) => p.px).y((p) => p.py).curve(d3.curveStepAfter)(line));
  svg.append("g").selectAll("circle").data(points).join("circle")
      .attr("class", (p) => `point${p.on_front ? " on-front" : best.size ? " dominated" : ""}` +
                            `${p.row.variant === chosen ? " chosen" : ""}`)
      .attr("cx", (p) => p.px).attr("cy", (p) => p.py).attr("r", (p) => (p.on_front ? 6 : 5))
      .attr("stroke", (p) => colour(p.row))
      .attr("fill", (p) => (p.on_front || !best.size ? colour(p.row) : null))
      .attr("tabindex", 0).attr("role", "button")
      .attr("aria-label", (p) => `${p.row.variant}: ${text(p.x)}, ${text(p.y)}`)
      .attr("data-variant", (p) => p.row.variant)
      .on("mouseenter focus", function (p) {
        const about = p.row.differs + (p.on_front ? "; on the front" : "");
        const told = columns.filter((c) => c.key === x.key || c.key === y.key || c.told);
        fill_tip(this, p.row.variant, about,
                 told.map((c) => [name_of_column(c) + unit_of(c), figure(p.row, c.key)]));
      })
      .on("mouseleave blur", hide_tip)
      .on("click", (p) => act(p.row.variant))
      .on("keydown", (p) => { if (d3.event.key === "Enter") act(p.row.variant); });
  place_labels(points, svg.append("g"));
  return points;
}

function draw_families(parent) {
  parent.html("");
  for (const family of families.filter((f) => report.rows.some((r) => r.family === f))) {
    const entry = parent.append("span");
    entry.append("svg").attr("viewBox", "0 0 14 14").append("circle").attr("cx", 7).attr("cy", 7)
        .attr("r", 5).attr("fill", palette[families.indexOf(family) % palette.length]);
    entry.append("span").text(` ${family.replace(/_/g, " ")}`);
  }
  parent.append("span").attr("class", "faint")
      .text("filled, dashed line: the front, which no other variant beats in both");
}
