// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The panel of a pixel: its hit record, the true hit, and the path of its packet, which is drawn over
// the picture.
import {by_id, make, shown, table} from "./elements.js";
import {seen_at} from "./viewpoint.js";

const verdicts = ["right", "another primitive", "missed", "nothing is there"];
const edges = [[0, 1], [2, 3], [4, 5], [6, 7], [0, 2], [1, 3], [4, 6], [5, 7], [0, 4], [1, 5], [2, 6],
               [3, 7]];

/// The distance of a number from the true one in units of the last place; null if not known.
const off = (truth, name) => truth?.off ? truth.off[name] : null;

function hit_table({record, truth}) {
  const row = (name) => [name, record.hit ? record[name].value : null,
                         record.hit ? record[name].bits : null, truth?.hit ? truth[name] : null,
                         off(truth, name) === null ? null : +off(truth, name).toFixed(3)];
  return table(["", "core", "bits", "truth", "last places apart"],
               ["t", "u", "v", "cosine"].map(row));
}

function names_of(names) {
  return names ? `${names.object} (instance ${names.instance}), primitive ${names.primitive}, ` +
                 `material ${names.material}` : "nothing";
}

export class PixelPanel {
  /// `point` asks for another pixel.
  constructor(panel, overlay, point) {
    Object.assign(this, {panel, overlay, point, data: null, step: 0});
    this.clear();
  }

  clear() {
    this.data = null;
    this.panel.replaceChildren(make("p", {class: "faint"},
        "Click a pixel of the picture, or give its place: ", this.input("x", ""), " ",
        this.input("y", ""), ". Keys w a s d walk, left and right turn, q and e go down and up."));
    this.overlay.replaceChildren();
    delete this.panel.dataset.pixel;
  }

  /// `size` is that of the picture.
  show(data, from, size) {
    Object.assign(this, {data, from, size, step: 0});
    const {record, names, truth, packet} = data;
    this.panel.dataset.pixel = `${record.x},${record.y}`;
    const parts = [
      make("h2", {}, "Pixel ", this.input("x", record.x), " ", this.input("y", record.y),
           ` ${record.colour}`),
      make("p", {}, `the core hits ${names_of(record.hit ? names : null)}`),
      truth ? make("p", {id: "verdict"},
                   `${verdicts[truth.verdict]}; the true hit is ${names_of(truth.names)}` +
                   (truth.hit && truth.place !== "inside" ? `, ${truth.place}` : ""))
            : make("p", {class: "faint"},
                   "True hits need the full build: run scripts/test --build-only."),
      hit_table(data),
    ];
    if (packet) parts.push(...this.packet_parts(packet, data.way));
    else parts.push(make("p", {class: "faint", id: "no-way"}, "The path of its packet follows."));
    this.panel.replaceChildren(...parts);
    this.draw();
  }

  input(axis, value) {
    return make("label", {}, `${axis} `, make("input", {
      type: "number", min: 0, value, id: `pixel-${axis}`,
      onchange: () => {
        const [x, y] = [by_id("pixel-x").value, by_id("pixel-y").value];
        if (x !== "" && y !== "") this.point(+x, +y);
      },
    }));
  }

  packet_parts(packet, way) {
    const spent = this.spent(packet, way);
    const slider = make("input", {
      type: "range", id: "way-step", min: 0, max: way.length - 1, value: 0,
      "aria-label": "step of the packet's path",
      oninput: (event) => this.go(+event.target.value),
    });
    this.rows = way.map((step, i) => make("tr", {onclick: () => this.go(i)},
        make("td", {class: "number"}, packet.begin === null ? "–" : String(step.clock)), make("td", {}, step.event),
        make("td", {}, this.about(step))));
    return [
      make("h2", {}, `Packet of ${packet.columns}x${packet.rows} pixels at ${packet.x}, ${packet.y}`),
      table([], [
        ["nodes", packet.nodes, "lists", packet.lists],
        ["list entries", packet.entries, "objects entered", packet.objects],
        ["primitives tested", packet.triangles, "cache misses", packet.misses],
        ["clocks", packet.begin === null ? null : packet.end - packet.begin,
         "from clock", packet.begin],
      ]),
      ...(packet.begin === null ? [] : [make("p", {class: "faint"}, spent)]),
      make("h2", {}, "Its path through the trees ", slider),
      make("div", {class: "way", id: "way"}, make("table", {}, ...this.rows)),
    ];
  }

  /// Clocks from each kind of step to the next.
  spent(packet, way) {
    const sums = new Map();
    way.forEach((step, i) => {
      const end = i + 1 < way.length ? way[i + 1].clock : packet.end - packet.begin;
      sums.set(step.event, (sums.get(step.event) ?? 0) + end - step.clock);
    });
    return "clocks until the next step: " +
           [...sums].map(([event, clocks]) => `${event} ${shown(clocks)}`).join(", ");
  }

  about(step) {
    if (step.event === "object") return `${step.name ?? ""} (matrix ${step.number})`;
    if (step.event === "triangle") return `primitive ${step.primitive ?? "?"}`;
    const level = step.top ? "of the instances" : "of the object";
    if (step.event === "node") {
      return `${step.number} ${level}` + ("axis" in step ? `, split in ${"xyz"[step.axis]}` : "");
    }
    return `${step.number} ${level}`;
  }

  go(step) {
    this.step = step;
    by_id("way-step").value = step;
    this.draw();
    const list = by_id("way");
    list.scrollTop = this.rows[step].offsetTop - list.clientHeight / 2;
  }

  /// Draws the boxes and triangles that the packet has met up to this step over the picture.
  draw() {
    const {record, way} = this.data;
    const [width, height] = this.size;
    const aspect = width / height;
    const lines = (points, pairs) => pairs.map(([a, b]) => [points[a], points[b]])
        .filter(([a, b]) => a && b).map(([a, b]) => `M${a}L${b}`).join("");
    const path = (step, css) => {
      const corners = (step.box ?? step.corners).map((p) => seen_at(this.from, aspect, p));
      const pairs = step.box ? edges : [[0, 1], [1, 2], [2, 0]];
      return `<path class="${css}" d="${lines(corners, pairs)}"/>`;
    };
    const drawn = (way ?? []).slice(0, this.step + 1).filter((step) => step.box || step.corners);
    const last = drawn.length - 1;
    this.overlay.innerHTML = drawn.slice(-60).map((step, i, some) =>
        path(step, `${step.event} ${i === some.length - 1 && last >= 0 ? "now" : ""}`)).join("") +
        `<rect x="${record.x / width}" y="${record.y / height}" width="${1 / width}"
           height="${1 / height}"/>`;
    this.rows?.forEach((row, i) => row.classList.toggle("now", i === this.step));
  }
}
