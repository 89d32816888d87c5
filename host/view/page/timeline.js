// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The timeline of a frame: a row for each unit, the clocks from left to right. Each column shows the
// shares of its clocks in which the unit works, waits for space in a FIFO, and waits for a token.
import {make, percent, shown} from "./elements.js";
import {part_of, wait_text} from "./flow.js";

const width = 420, left = 118, row = 13, bar = 11;  // of the drawing
const levels = 22;                                  // pixels of a row's height

/// The colour of a variable of the style sheet.
const colour = (name) => getComputedStyle(document.documentElement).getPropertyValue(name);

function painted(machine, units, parts) {
  const canvas = make("canvas", {width: parts, height: units.length * levels});
  const context = canvas.getContext("2d");
  const [busy, stall] = [colour("--busy"), colour("--stall")];
  units.forEach((unit, i) => {
    for (let part = 0; part < parts; ++part) {
      const {work, space} = part_of(machine, unit, part);
      const bottom = (i + 1) * levels;
      const up = levels * work, further = levels * space;
      context.fillStyle = busy;
      context.fillRect(part, bottom - up, 1, up);
      context.fillStyle = stall;
      context.fillRect(part, bottom - up - further, 1, further);
    }
  });
  return canvas.toDataURL();
}

/// `chosen` gets the unit of the place that the reader points to.
export function timeline_of(machine, chosen) {
  const {cycles, part_clocks} = machine;
  if (!cycles) return make("p", {class: "faint"}, "Without clocks there is no timeline.");
  const parts = Math.ceil(cycles / part_clocks);
  const units = machine.units.filter((unit) => unit.transactions > 0);
  const height = units.length * row;
  const svg = d3.create("svg").attr("class", "machine timeline").attr("id", "timeline")
      .attr("viewBox", [0, 0, width, height + 16]).attr("tabindex", 0).attr("role", "application")
      .attr("aria-label", "what each unit does over the frame; the arrow keys go along the clocks " +
                          "and from unit to unit")
      .attr("aria-describedby", "timeline-place");
  const step = (width - left) / parts;
  svg.selectAll("rect.row").data(units).join("rect").attr("class", "row").attr("x", left)
      .attr("y", (d, i) => i * row).attr("width", width - left).attr("height", bar);
  const picture = painted(machine, units, parts);
  svg.selectAll("svg.bar").data(units).join("svg").attr("class", "bar").attr("x", left)
      .attr("y", (d, i) => i * row).attr("width", width - left).attr("height", bar)
      .attr("viewBox", (d, i) => [0, i * levels, parts, levels]).attr("preserveAspectRatio", "none")
      .append("image").attr("href", picture).attr("width", parts)
      .attr("height", units.length * levels).attr("style", "image-rendering: pixelated");
  svg.selectAll("text.name").data(units).join("text").attr("class", "name").attr("x", left - 4)
      .attr("y", (d, i) => i * row + 9).attr("text-anchor", "end").text((d) => d.name);
  svg.append("text").attr("x", left).attr("y", height + 12).text("clock 0");
  svg.append("text").attr("x", width).attr("y", height + 12).attr("text-anchor", "end")
      .text(shown(cycles));
  const mark = svg.append("rect").attr("class", "place").attr("width", Math.max(step, 1.5))
      .attr("height", bar).attr("visibility", "hidden");
  const place = make("p", {id: "timeline-place", role: "status"}, "Point to a place, or go there with " +
                     "the arrow keys, to read what the unit does there.");
  let at = {unit: 0, part: 0};
  const point = (unit, part) => {
    at = {unit: Math.max(0, Math.min(units.length - 1, unit)),
          part: Math.max(0, Math.min(parts - 1, part))};
    mark.attr("visibility", "visible").attr("x", left + at.part * step).attr("y", at.unit * row);
    place.textContent = sentence(machine, units[at.unit], at.part);
    place.dataset.unit = units[at.unit].name;
    place.dataset.part = at.part;
  };
  svg.on("pointermove", (...given) => {
    // D3 5 gives no event; later ones do.
    const event = given[0] instanceof Event ? given[0] : d3.event;
    const box = svg.node().getBoundingClientRect();
    const x = (event.clientX - box.left) / box.width * width;
    const y = (event.clientY - box.top) / box.height * (height + 16);
    if (x >= left && y < height) point(Math.floor(y / row), Math.floor((x - left) / step));
  });
  svg.on("click", () => chosen(units[at.unit]));
  svg.node().addEventListener("keydown", (event) => {
    const by = {ArrowLeft: [0, -1], ArrowRight: [0, 1], ArrowUp: [-1, 0], ArrowDown: [1, 0]}[event.key];
    if (event.key === "Enter") chosen(units[at.unit]);
    if (!by) return;
    event.preventDefault();
    const many = event.shiftKey ? 16 : 1;
    point(at.unit + by[0], at.part + by[1] * many);
  });
  return make("div", {}, place, svg.node(), make("p", {class: "faint"},
      make("span", {class: "key busy"}), " works ", make("span", {class: "key stalled"}),
      " waits for space in a FIFO ", make("span", {class: "key"}), ` waits for a token. A column is ${
          shown(part_clocks)} clocks.`));
}

/// "mailbox, clocks 512 to 1,023: works 20.0 %, waits 70.0 % for a token in entry, from list; .."
function sentence(machine, unit, part) {
  const {work, waits} = part_of(machine, unit, part);
  const from = part * machine.part_clocks;
  const to = Math.min(machine.cycles, from + machine.part_clocks) - 1;
  return `${unit.name}, clocks ${shown(from)} to ${shown(to)}: ` +
      [`works ${percent(work)}`,
       ...waits.map(({wait, share}) => `waits ${percent(share)} for ${wait_text(machine, wait)}`)]
          .join("; ");
}
