// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The page of an error report: plots, pictures and table of one scene. What is shown is in the
// address behind "#", so that a view can be kept and sent.
"use strict";

const keys = ["scene", "measure", "time", "area", "variant", "sort"];
const size = {width: 640, height: 430, left: 74, right: 24, top: 30, bottom: 52};

// ---- What there is ----

/// Every figure that some run has, as GROUP.NAME.
const measures = report.measures.map((m) => ({...m, key: `${m.group}.${m.name}`}))
    .filter((m) => report.runs.some((r) => figure(r, m.key) !== null));
const errors = measures.filter((m) => m.better !== "-");
const areas = [...new Set(Object.values(report.variants).flatMap((v) => Object.keys(v.area || {})))];

/// What a variant differs in: its family, and its colour.
function family(name) {
  const differs = Object.keys(report.variants[name].differs);
  return differs.length === 0 ? "reference" : differs.join(" + ");
}
const families = ["reference", ...new Set(Object.keys(report.variants).map(family)
    .filter((f) => f !== "reference"))];
const colour = (name) => palette[families.indexOf(family(name)) % palette.length];

/// A figure of a run by its column's name; null if it is not known.
function figure(run, key) {
  const variant = report.variants[run.variant];
  if (key === "variant") return run.variant;
  if (key === "differs") return describe(run.variant);
  if (key.startsWith("area.")) return (variant.area || {})[key.slice(5)] ?? null;
  if (key === "clock_ns") return (variant.schedule || {}).clock_ns ?? null;
  if (key === "frame_ms" || key === "clocks") return run[key] ?? null;
  const [group, name] = key.split(".");
  const value = ((run.measures || {})[group] || {})[name];
  return value === undefined ? null : value;
}

function describe(name) {
  const differs = Object.entries(report.variants[name].differs);
  return differs.map(([key, value]) => `${key.replace(/_/g, " ")} ${String(value).replace(/_/g, " ")}`)
      .join(", ") || "the reference";
}

/// The periods of the variants, if they are known.
function clocks_text() {
  const [least, most] = d3.extent(runs(), (run) => figure(run, "clock_ns"));
  return least === undefined ? "" : least === most ? `clock of ${least} ns; `
                                                   : `clocks of ${least} to ${most} ns; `;
}
const with_unit = (value, unit) =>
    unit && unit !== "1" && value !== null ? `${text(value)} ${unit}` : text(value);

// ---- What is shown ----

const told_first = ["primary.wrong_share", "image.rms"].find((key) => errors.some((m) => m.key === key));
const state = {scene: Object.keys(report.scenes)[0],
               measure: told_first || (errors[0] || {}).key,
               time: "frame_ms", area: areas[0], variant: report.reference, sort: ""};

function read_address() {
  for (const [key, value] of new URLSearchParams(location.hash.slice(1))) {
    if (keys.includes(key)) state[key] = value;
  }
  if (!(state.scene in report.scenes)) state.scene = Object.keys(report.scenes)[0];
  if (!(state.variant in report.variants)) state.variant = report.reference;
  if (!errors.some((m) => m.key === state.measure)) state.measure = (errors[0] || {}).key;
}
function choose(change) {
  Object.assign(state, change);
  const address = new URLSearchParams(keys.filter((k) => state[k]).map((k) => [k, state[k]]));
  history.replaceState(null, "", `#${address}`);
  show();
}
const runs = () => report.runs.filter((r) => r.scene === state.scene);
const measure = () => errors.find((m) => m.key === state.measure);

/// Of identical pictures the ratio of signal to noise has no bound.
const is_identical = (run, m) =>
    m.name === "psnr" && figure(run, m.key) === null && figure(run, "image.differ") === 0;

/// The runs that no other beats in both: no larger x and no worse error, and better in one.
function front(points, better) {
  const sign = better === "more" ? -1 : 1;
  const beats = (a, b) => a.x <= b.x && sign * a.y <= sign * b.y &&
      (a.x < b.x || sign * a.y < sign * b.y);
  return new Set(points.filter((p) => !points.some((q) => beats(q, p))).map((p) => p.run.variant));
}
function points_of(x_key, m) {
  return runs().map((run) => ({run, x: figure(run, x_key),
                               y: is_identical(run, m) ? Infinity : figure(run, m.key)}))
      .filter((p) => p.x !== null && p.y !== null);
}

// ---- A plot ----

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
    const width = 6.6 * p.run.variant.length;
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
          .text(p.run.variant);
      break;
    }
  }
}

function draw(id, left_out_id, x_key, x_text, m) {
  const svg = d3.select(`#${id}`).attr("viewBox", `0 0 ${size.width} ${size.height}`);
  svg.selectAll("*").remove();
  const points = points_of(x_key, m);
  const absent = runs().filter((r) => !points.some((p) => p.run === r)).map((r) => r.variant);
  by_id(left_out_id).textContent =
      absent.length ? `Without a figure for it, so not in the plot: ${absent.join(", ")}.` : "";
  if (points.length === 0) {
    svg.append("text").attr("x", size.width / 2).attr("y", size.height / 2)
        .attr("text-anchor", "middle").text(`no variant has figures for ${x_text}`);
    return;
  }
  const bottom = size.height - size.bottom;
  const right = size.width - size.right;
  const x = scale_of(points.map((p) => p.x), [size.left, right], false);
  const y = scale_of(points.map((p) => p.y), [bottom, size.top], true);
  const best = front(points, m.better);
  for (const p of points) {
    p.px = x.place(p.x);
    p.py = y.place(p.y);
    p.on_front = best.has(p.run.variant);
  }

  const across = ticks(d3.axisBottom(x.scale), x.scale, x.log).tickSizeOuter(0);
  const upwards = ticks(d3.axisLeft(y.scale), y.scale, y.log);
  svg.append("g").attr("class", "grid").attr("transform", `translate(${size.left},0)`)
      .call(upwards.tickSize(size.left - right)).selectAll("text").remove();
  svg.append("g").attr("class", "axis").attr("transform", `translate(0,${bottom})`).call(across);
  svg.append("g").attr("class", "axis").attr("transform", `translate(${size.left},0)`)
      .call(upwards.tickSize(6).tickSizeOuter(0));
  if (y.beyond !== null) {
    svg.append("line").attr("class", "end").attr("x1", size.left).attr("x2", right)
        .attr("y1", y.beyond).attr("y2", y.beyond);
    svg.append("text").attr("x", size.left - 9).attr("y", y.beyond + 4).attr("text-anchor", "end")
        .text(y.beyond_text);
  }
  svg.append("text").attr("class", "title").attr("x", right).attr("y", size.height - 12)
      .attr("text-anchor", "end").text(`${x_text}${x.log ? ", logarithmic" : ""} →`);
  const unit = m.unit === "1" ? "" : `, ${m.unit}`;
  svg.append("text").attr("class", "title").attr("x", 4).attr("y", 14)
      .text(`${m.better === "more" ? "↑ better: " : "↓ better: "}${m.group} ${m.name}${unit}` +
            `${y.log ? ", logarithmic" : ""}`);

  const line = points.filter((p) => p.on_front).sort((a, b) => a.x - b.x || b.py - a.py);
  svg.append("path").attr("class", "front")
      .attr("d", d3.line().x((p) => p.px).y((p) => p.py).curve(d3.curveStepAfter)(line));
  svg.append("g").selectAll("circle").data(points).join("circle")
      .attr("class", (p) => `point${p.on_front ? " on-front" : " dominated"}` +
                            `${p.run.variant === state.variant ? " chosen" : ""}`)
      .attr("cx", (p) => p.px).attr("cy", (p) => p.py).attr("r", (p) => (p.on_front ? 6 : 5))
      .attr("stroke", (p) => colour(p.run.variant))
      .attr("fill", (p) => (p.on_front ? colour(p.run.variant) : null))
      .attr("tabindex", 0).attr("role", "button")
      .attr("aria-label", (p) => `${p.run.variant}: ${text(p.x)}, ${text(p.y)}`)
      .attr("data-variant", (p) => p.run.variant)
      .on("mouseenter focus", function (p) { show_tip(p, this, m); })
      .on("mouseleave blur", hide_tip)
      .on("click", (p) => choose({variant: p.run.variant}))
      .on("keydown", (p) => { if (d3.event.key === "Enter") choose({variant: p.run.variant}); });
  place_labels(points, svg.append("g"));
}

// ---- What the page says of a point ----

function show_tip(p, element, m) {
  const area = (key) => [key, figure(p.run, `area.${key}`)];
  const rows = [[`${m.group} ${m.name}`, Number.isFinite(p.y) ? with_unit(p.y, m.unit) : "identical"],
                ["clocks", figure(p.run, "clocks")], ["ms a frame", figure(p.run, "frame_ms")],
                ["clock, ns", figure(p.run, "clock_ns")], ...areas.map(area),
                ...["primary.wrong_share", "primary.t_median", "image.differ_share", "image.psnr"]
                    .filter((k) => k !== m.key && measures.some((n) => n.key === k))
                    .map((k) => [k.replace(".", " "), figure(p.run, k)])];
  fill_tip(element, p.run.variant, describe(p.run.variant) + (p.on_front ? "; on the front" : ""),
           rows);
}

// ---- The table ----

const columns = [
  {key: "variant", group: "variant", name: "variant", words: true},
  {key: "differs", group: "variant", name: "what differs", words: true},
  {key: "clocks", group: "time", name: "clocks", better: "less"},
  {key: "frame_ms", group: "time", name: "ms a frame", better: "less"},
  {key: "clock_ns", group: "time", name: "clock, ns", better: "less"},
  ...areas.map((a) => ({key: `area.${a}`, group: "area", name: a, better: "less"})),
  ...measures.map((m) => ({key: m.key, group: m.group, name: m.name, meaning: m.meaning,
                           unit: m.unit, better: m.better}))];

function sorted(rows) {
  const [key, direction] = state.sort.split(" ");
  if (!columns.some((c) => c.key === key)) return rows;
  const sign = direction === "down" ? -1 : 1;
  return [...rows].sort((a, b) => {
    const [u, v] = [figure(a, key), figure(b, key)];
    if (u === null || v === null) return (u === null) - (v === null);  // at the end either way
    return sign * (typeof u === "number" ? u - v : String(u).localeCompare(String(v)));
  });
}

function draw_table(fronts) {
  const head = d3.select("#table thead").html("");
  const groups = head.append("tr").attr("class", "groups");
  for (const group of new Set(columns.map((c) => c.group))) {
    groups.append("th").attr("colspan", columns.filter((c) => c.group === group).length)
        .text(group);
  }
  const [sort_key, direction] = state.sort.split(" ");
  const cells = head.append("tr").selectAll("th").data(columns).join("th")
      .attr("class", (c) => (c.words ? "words" : null))
      .attr("title", (c) => (c.meaning ? `${c.meaning} (${c.unit})` : null))
      .attr("aria-sort", (c) => (c.key !== sort_key ? "none"
                                  : direction === "down" ? "descending" : "ascending"));
  cells.append("button").attr("tabindex", 0).text((c) => c.name)
      .on("click", (c) => {
        const [key, was] = state.sort.split(" ");
        choose({sort: `${c.key} ${key === c.key && was === "up" ? "down" : "up"}`});
      });
  const rows = d3.select("#table tbody").html("").selectAll("tr").data(sorted(runs())).join("tr")
      .attr("data-variant", (r) => r.variant)
      .attr("class", (r) => (r.variant === state.variant ? "chosen" : null))
      .on("click", (r) => choose({variant: r.variant}));
  rows.each(function (run) {
    const row = d3.select(this);
    for (const column of columns) {
      if (run.refused && !["variant", "differs"].includes(column.key)) continue;
      const cell = row.append("td").attr("class", column.words ? "words" : null);
      cell.text(is_identical(run, column) ? "identical" : text(figure(run, column.key)));
      if (column.key === "variant") {
        cell.append("span").attr("class", "front")
            .text(` ${fronts.map((f) => (f.has(run.variant) ? "●" : "○")).join("")}`);
      }
    }
    if (run.refused) {
      row.append("td").attr("class", "words faint").attr("colspan", columns.length - 2)
          .text(run.refused);
    }
  });
}

// ---- All of it ----

function options(id, values, chosen, key) {
  fill_options(id, values, chosen, (value) => choose({[key]: value}));
}

function show() {
  hide_tip();
  const m = measure();
  const scene = report.scenes[state.scene];
  by_id("about").textContent = `${scene.about}; ${report.size} pixels; ` +
      `${clocks_text()}area on ${report.device}; reference ${report.reference}`;
  const plain = (names) => names.map((n) => ({value: n, text: n}));
  options("scene", plain(Object.keys(report.scenes)), state.scene, "scene");
  options("area", areas.map((a) => ({value: a, text: a})), state.area, "area");
  options("variant", plain(runs().map((r) => r.variant)), state.variant, "variant");
  options("measure", errors.map((e) => ({value: e.key, text: `${e.group} ${e.name}`})),
          state.measure, "measure");
  by_id("time").value = state.time;
  by_id("time").onchange = (event) => choose({time: event.target.value});

  by_id("legend").replaceChildren();
  for (const f of families) {
    const name = Object.keys(report.variants).find((v) => family(v) === f);
    if (!name) continue;
    const entry = d3.select("#legend").append("span");
    entry.append("svg").attr("viewBox", "0 0 14 14").append("circle").attr("cx", 7).attr("cy", 7)
        .attr("r", 5).attr("fill", colour(name));
    entry.append("span").text(` ${f.replace(/_/g, " ")}`);
  }
  d3.select("#legend").append("span").attr("class", "faint")
      .text("filled, dashed line: the front, which no other variant beats in both");

  const fronts = [new Set(), new Set()];
  by_id("meaning").textContent =
      m ? `${m.group} ${m.name}: ${m.meaning}.` : "No run gives an error; the table says why.";
  if (m) {
    const area_key = `area.${state.area}`;
    const time_text = state.time === "clocks" ? "clocks a frame" : "ms a frame";
    draw("time-plot", "time-left-out", state.time, time_text, m);
    draw("area-plot", "area-left-out", area_key, `${state.area || "area"} cells`, m);
    fronts[0] = front(points_of(state.time, m), m.better);
    fronts[1] = front(points_of(area_key, m), m.better);
  }
  const run = runs().find((r) => r.variant === state.variant) || {};
  by_id("differs").textContent = run.refused || describe(state.variant);
  for (const [id, picture] of [["image", run.image], ["truth", scene.truth],
                               ["difference", run.difference]]) {
    if (picture) by_id(id).src = report.pictures[picture];
    by_id(id).style.visibility = picture ? "visible" : "hidden";
  }
  draw_table(fronts);
}

addEventListener("hashchange", () => { read_address(); show(); });
read_address();
show();
