// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The panel of the machine: the units with their use and their FIFOs, the waits of the chosen unit,
// the caches, and the timeline of the frame.
import {timeline_of} from "./timeline.js";
import {by_id, make, percent, shown, table} from "./elements.js";
import {add_shares, fifo_text, fifos_within, wait_text} from "./flow.js";

const column_width = 200, unit_height = 20, gap = 16, columns = 2;
const tank_width = 5, tank_step = 7;

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

const fifo_sentence = (fifo) => `${fifo.channel}, ${fifo_text(fifo)}: ${fifo.mean.toFixed(2)} tokens ` +
    `on average, ${fifo.most} at most, of ${fifo.depth}`;

/// A FIFO's fill, from left to right.
function level(fifo) {
  const share = (count) => `${(100 * Math.min(1, count / fifo.depth)).toFixed(1)}%`;
  return make("span", {class: "level", title: fifo_sentence(fifo)},
              make("span", {class: "fill", style: `width: ${share(fifo.mean)}`}),
              make("span", {class: "most", style: `left: ${share(fifo.most)}`}));
}

export class MachinePanel {
  constructor(panel) {
    this.panel = panel;
    this.clear();
  }

  clear() {
    this.panel.replaceChildren(make("p", {class: "faint"}, "The frame is being watched."));
    this.machine = null;
    delete this.panel.dataset.number;
  }

  show(machine) {
    const {cycles, clock} = machine;
    add_shares(machine);
    this.machine = machine;
    this.detail = make("div", {id: "unit-detail", role: "status"});
    this.panel.replaceChildren(
        make("p", {id: "core-speed"}, cycles
            ? `${shown(cycles)} clocks, ${machine.frames_per_second.toFixed(1)} frames/s at ` +
              `${clock.mhz} MHz, ${shown(machine.rays_per_clock)} rays a clock`
            : "The clocks are not known, as this configuration has no schedules."),
        make("div", {class: "halves"},
            make("div", {}, ...this.units(machine)),
            make("div", {}, make("h2", {}, "Timeline of the frame"),
                 timeline_of(machine, (unit) => this.choose(unit)),
                 make("h2", {}, "Caches"),
                 table(["", "lookups", "misses", "hits"], machine.caches.map((cache) =>
                     [cache.name, cache.lookups, cache.misses, percent(cache.hit_rate)])))),
        ...this.fifos(machine));
    const last = machine.units.find(({name}) => name === this.chosen);
    if (last) this.choose(last);
    this.panel.dataset.number = machine.number;
  }

  /// The diagram, with what the chosen unit does below.
  units(machine) {
    return [
      make("h2", {}, "Units and FIFOs"),
      make("p", {class: "faint"}, make("span", {class: "key busy"}), " working ",
           make("span", {class: "key stalled"}), " blocked by a full output ",
           make("span", {class: "key tank"}), " FIFO: its mean fill, and a line at the highest fill. " +
           "A unit's output FIFOs are at its right. Click a unit to see its channels and its waits."),
      this.diagram(machine),
      this.detail,
    ];
  }

  /// Of a frame whose clocks are not known.
  say_of_clocks(sentence) {
    if (sentence && this.machine && !this.machine.cycles) by_id("core-speed").textContent = sentence;
  }

  /// All FIFOs, the fullest first.
  fifos(machine) {
    if (!machine.cycles) return [];
    const sorted = [...fifos_within(machine)].sort((a, b) => b.mean / b.depth - a.mean / a.depth);
    return [make("h2", {}, "FIFOs"), this.table_of_fifos(sorted, "fifos")];
  }

  table_of_fifos(fifos, id) {
    const made = table(["channel", "", "mean", "highest", "places", ""], fifos.map((fifo) =>
        [fifo.channel, fifo_text(fifo), fifo.mean.toFixed(2), fifo.most, fifo.depth, level(fifo)]));
    made.id = id;
    made.className = "fifos";
    return made;
  }

  choose(unit) {
    this.chosen = unit.name;
    this.mark(unit);
    const {machine} = this;
    const {cycles} = machine;
    const fifos = fifos_within(machine).filter(({from, to}) =>
        from.includes(unit.name) || to.includes(unit.name));
    this.detail.replaceChildren(
        make("h2", {}, unit.name),
        ...(cycles ? [table([], [
          ["works", unit.transactions, percent(unit.use)],
          ...unit.waits.map((wait) => [`waits for ${wait_text(machine, wait)}`, wait.total,
                                       percent(wait.total / cycles)]),
        ]), this.table_of_fifos(fifos, "unit-fifos")]
                  : [make("p", {}, `${shown(unit.transactions)} transactions`)]));
  }

  diagram(machine) {
    const {units, channels, cycles} = machine;
    const share = (unit) => cycles ? percent(unit.use) : shown(unit.transactions);
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
    this.mark = (chosen) => {
      paths.classed("chosen", ({from, to}) => from === chosen || to === chosen);
      svg.selectAll("rect.unit").classed("chosen", (unit) => unit === chosen);
    };
    const choose = (chosen) => this.choose(chosen);
    const unit = svg.append("g").selectAll("g").data(units).join("g").attr("data-unit", (d) => d.name)
        .attr("tabindex", 0).on("click", choose).on("focus", choose);
    const box = (css, x, size) => unit.append("rect").attr("class", css).attr("x", x)
        .attr("y", (d) => d.y).attr("width", size).attr("height", unit_height - 3).attr("rx", 3);
    const inner = column_width - 12;
    box("unit", (d) => d.x, inner);
    box("busy", (d) => d.x, (d) => inner * Math.min(1, part(d)));
    box("stalled", (d) => d.x + inner * Math.min(1, part(d)),
        (d) => inner * Math.min(1 - Math.min(1, part(d)), d.stalled ?? 0));
    const tanks = fifos_within(machine);
    const outputs = d3.nest().key(({from}) => from[0]).map(tanks.filter(({of}) => of === "writer"));
    const branches = d3.nest().key(({to}) => to[0]).map(tanks.filter(({of}) => of === "reader"));
    const after = (d) => outputs.get(d.name) ?? [], before = (d) => branches.get(d.name) ?? [];
    unit.append("text").attr("x", (d) => d.x + 4 + before(d).length * tank_step)
        .attr("y", (d) => d.y + 12).text((d) => d.name);
    unit.append("text").attr("x", (d) => d.x + inner - 4 - after(d).length * tank_step)
        .attr("y", (d) => d.y + 12).attr("text-anchor", "end").text(share);
    this.tanks(unit, before, (d, i) => d.x + 2 + i * tank_step);
    this.tanks(unit, after, (d, i) => d.x + inner - (after(d).length - i) * tank_step);
    unit.append("title").text((d) => `${d.name}: ${shown(d.transactions)} transactions` +
        (d.stalled === null ? "" : `, ${percent(d.stalled)} of the clocks stalled`));
    return svg.node();
  }

  /// FIFOs as tanks.
  tanks(unit, fifos_of, x) {
    const tall = unit_height - 7;
    const tank = unit.selectAll(null).data((d) => fifos_of(d).map((fifo, i) => ({fifo, d, i})))
        .join("g").attr("class", "tank").attr("transform", ({d, i}) => `translate(${x(d, i)},${d.y + 2})`);
    const part = ({fifo}, name) => tall * Math.min(1, fifo[name] / fifo.depth);
    tank.append("rect").attr("class", "tank").attr("width", tank_width).attr("height", tall);
    tank.append("rect").attr("class", "fill").attr("width", tank_width)
        .attr("y", (d) => tall - part(d, "mean")).attr("height", (d) => part(d, "mean"));
    tank.append("path").attr("class", "most")
        .attr("d", (d) => `M0,${tall - part(d, "most")}h${tank_width}`);
    tank.append("title").text(({fifo}) => fifo_sentence(fifo));
  }
}
