// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The table of the choices that were tried on this view: wrong hits, clocks and LUTs.
import {make, shown, table} from "./elements.js";

export function text_of({configuration, mantissa_bits, packets, lines, reflections, lights, mirrors}) {
  const counted = (count, what) => count ? [`${count} ${what}${count === 1 ? "" : "s"}`] : [];
  const told = (count, what) => count === null ? [] : [`${count} ${what}`];
  return [configuration, ...told(mantissa_bits, "bits"), ...told(packets, "packets"),
          ...told(lines, "lines"), ...told(reflections, "bounces"), ...counted(lights.length, "light"),
          ...counted(mirrors.length, "mirror")].join(", ");
}

/// "1,200 (80.0 %)": the value, and its share of the first row's.
function beside(value, first) {
  if (value === null || value === undefined) return "–";
  return first ? `${shown(value)} (${(100 * value / first).toFixed(1)} %)` : shown(value);
}

export class Trials {
  constructor() {
    this.view = "";
    this.rows = [];
  }

  /// The row of these choices; rows of another view are dropped.
  row(from, choices) {
    const view = JSON.stringify(from), name = text_of(choices), key = JSON.stringify(choices);
    if (view !== this.view) Object.assign(this, {view, rows: []});
    const known = this.rows.find((row) => row.key === key);
    if (known) return known;
    this.rows.push({key, name, clocks: null, cells: null});
    return this.rows[this.rows.length - 1];
  }

  draw(place) {
    if (!place) return;
    place.hidden = this.rows.length < 2;
    if (place.hidden) return;
    const [first] = this.rows;
    place.replaceChildren(
        make("h2", {}, "This view with every choice that you have tried"),
        table(["", "wrong hits", "clocks", "LUT"], this.rows.map((row) =>
            [row.name, row.wrong === undefined || row.wrong === null ? "–"
                         : `${+(100 * row.wrong).toPrecision(3)} %`,
             beside(row.clocks, row === first ? null : first.clocks),
             beside(row.cells, row === first ? null : first.cells)])),
        make("p", {class: "faint"}, "In brackets: the share of the first row. LUTs come from the last " +
             "error report, if it has this core; packets, lines, lights and mirrors change none."));
  }
}
