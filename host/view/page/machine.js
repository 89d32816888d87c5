// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The panel of the machine: its units with their use, the caches, and the units' work in the course
// of the frame.
import {make, percent, shown, table} from "./elements.js";

const column_width = 200, unit_height = 20, gap = 16, columns = 2;

/// Groups with their units, each placed; the columns fill evenly.
function placed(units) {
  const groups = d3.nest().key((unit) => unit.group).entries(units);
  const bottoms = Array(columns).fill(0);
  for (const group of groups) {
    const column = bottoms.indexOf(Math.min(...bottoms));
    group.x = column * (column_width + 36);
    group.y = bottoms[column];
    group.height = group.values.length * unit_height + 26;
    group.values.forEach((unit, i) => {
      unit.x = group.x + 6;
      unit.y = group.y + 22 + i * unit_height;
    });
    bottoms[column] += group.height + gap;
  }
  return {groups, height: Math.max(...bottoms)};
}

export class MachinePanel {
  constructor(panel) {
    this.panel = panel;
    this.clear();
  }

  clear() {
    this.panel.replaceChildren(make("p", {class: "faint"}, "The frame is being watched."));
    delete this.panel.dataset.number;
  }

  show(machine) {
    const {cycles, clock} = machine;
    for (const unit of machine.units) {
      unit.use = cycles && unit.transactions !== null ? unit.transactions / cycles : null;
      unit.stalled = cycles && unit.stalls !== null ? unit.stalls / cycles : null;
    }
    const share = (unit) => cycles ? percent(unit.use) : shown(unit.transactions);
    this.panel.replaceChildren(
        make("p", {id: "core-speed"}, cycles
            ? `${shown(cycles)} clocks, ${machine.frames_per_second.toFixed(1)} frames a second at ` +
              `${clock.mhz} MHz, ${shown(machine.rays_per_clock)} rays a clock`
            : "the clocks are not known: the schedules of this configuration are not there"),
        make("h2", {}, "Units"),
        make("p", {class: "faint"},
             "Blue: clocks in which the unit starts a transaction; orange: clocks in which it has its " +
             "tokens but an output no room. A click shows a unit's channels."),
        this.diagram(machine, share),
        make("h2", {}, "Caches"),
        table(["", "lookups", "misses", "hits"], machine.caches.map((cache) =>
            [cache.name, cache.lookups, cache.misses, percent(cache.hit_rate)])),
        make("h2", {}, "In the course of the frame"),
        this.timeline(machine));
    this.panel.dataset.number = machine.number;
  }

  diagram({units, channels, cycles}, share) {
    const {groups, height} = placed(units);
    const most = d3.max(units, (unit) => unit.transactions ?? 0) || 1;
    const part = (unit) => cycles ? unit.use : (unit.transactions ?? 0) / most;
    const width = columns * (column_width + 36);
    const svg = d3.create("svg").attr("class", "machine").attr("viewBox", [0, 0, width, height])
        .attr("role", "img").attr("aria-label", "units and their use");
    const group = svg.selectAll("g.group").data(groups).join("g");
    group.append("rect").attr("class", "group").attr("x", (d) => d.x).attr("y", (d) => d.y)
        .attr("width", column_width).attr("height", (d) => d.height).attr("rx", 5);
    group.append("text").attr("class", "title").attr("x", (d) => d.x + 7).attr("y", (d) => d.y + 15)
        .text((d) => d.key);
    const by_name = new Map(units.map((unit) => [unit.name, unit]));
    const links = channels.flatMap((channel) => channel.from.flatMap((from) =>
        channel.to.map((to) => ({channel, from: by_name.get(from), to: by_name.get(to)}))))
        .filter(({from, to}) => from && to && from !== to);
    const busiest = d3.max(links, ({channel}) => channel.tokens ?? 0) || 1;
    const side = (unit, other) => unit.x + (other.x > unit.x ? column_width - 12 : 0);
    const line = ({from, to}) => {
      const [x1, x2] = from.x === to.x ? [from.x + column_width - 12, to.x + column_width - 12]
                                       : [side(from, to), side(to, from)];
      const [y1, y2] = [from.y + 9, to.y + 9];
      const bend = from.x === to.x ? x1 + 24 : (x1 + x2) / 2;
      return `M${x1},${y1}C${bend},${y1} ${bend},${y2} ${x2},${y2}`;
    };
    const paths = svg.append("g").selectAll("path").data(links).join("path").attr("class", "channel")
        .attr("d", line)
        .attr("stroke-width", ({channel}) => 1 + 4 * (channel.tokens ?? 0) / busiest);
    paths.append("title").text(({channel}) => `${channel.name}: ${shown(channel.tokens)} tokens`);
    const choose = (chosen) => {
      paths.classed("chosen", ({from, to}) => from === chosen || to === chosen);
      svg.selectAll("rect.unit").classed("chosen", (unit) => unit === chosen);
    };
    const unit = svg.append("g").selectAll("g").data(units).join("g").attr("data-unit", (d) => d.name)
        .attr("tabindex", 0).on("click", choose).on("focus", choose);
    const box = (css, x, size) => unit.append("rect").attr("class", css).attr("x", x)
        .attr("y", (d) => d.y).attr("width", size).attr("height", unit_height - 3).attr("rx", 3);
    const inner = column_width - 12;
    box("unit", (d) => d.x, inner);
    box("busy", (d) => d.x, (d) => inner * Math.min(1, part(d)));
    box("stalled", (d) => d.x + inner * Math.min(1, part(d)),
        (d) => inner * Math.min(1 - Math.min(1, part(d)), d.stalled ?? 0));
    unit.append("text").attr("x", (d) => d.x + 4).attr("y", (d) => d.y + 12).text((d) => d.name);
    unit.append("text").attr("x", (d) => d.x + inner - 4).attr("y", (d) => d.y + 12)
        .attr("text-anchor", "end").text(share);
    unit.append("title").text((d) => `${d.name}: ${shown(d.transactions)} transactions` +
        (d.stalls === null ? "" : `, ${shown(d.stalls)} clocks stalled`));
    return svg.node();
  }

  /// A row for each unit, the clocks of the frame from left to right.
  timeline({units, part_clocks, cycles}) {
    if (!cycles) return make("p", {class: "faint"}, "Without clocks a frame has no course.");
    const parts = Math.ceil(cycles / part_clocks);
    const width = 420, left = 118, row = 11;
    const shownUnits = units.filter((unit) => unit.transactions > 0);
    const svg = d3.create("svg").attr("class", "machine")
        .attr("viewBox", [0, 0, width, shownUnits.length * row + 16]).attr("role", "img")
        .attr("aria-label", "work of the units over the frame");
    const x = (part) => left + part * (width - left) / parts;
    const colour = d3.scaleSequential(d3.interpolateViridis).domain([0, 1]);
    const canvas = make("canvas", {width: parts, height: shownUnits.length});
    const context = canvas.getContext("2d");
    shownUnits.forEach((unit, i) => {
      unit.work.slice(0, parts).forEach((count, part) => {
        context.fillStyle = colour(Math.min(1, count / part_clocks));
        context.fillRect(part, i, 1, 1);
      });
    });
    svg.append("image").attr("href", canvas.toDataURL()).attr("x", left).attr("y", 0)
        .attr("width", width - left).attr("height", shownUnits.length * row)
        .attr("preserveAspectRatio", "none").attr("style", "image-rendering: pixelated");
    svg.selectAll("text.name").data(shownUnits).join("text").attr("x", left - 4)
        .attr("y", (d, i) => i * row + 9).attr("text-anchor", "end").style("font-size", "9px")
        .text((d) => d.name);
    svg.append("text").attr("x", left).attr("y", shownUnits.length * row + 12).text("clock 0");
    svg.append("text").attr("x", width).attr("y", shownUnits.length * row + 12)
        .attr("text-anchor", "end").text(shown(cycles));
    return make("div", {}, svg.node(), make("p", {class: "faint"},
        `A column is ${shown(part_clocks)} clocks; dark: idle, yellow: a transaction in each clock.`));
  }
}
