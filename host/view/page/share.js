// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The panel to share a picture: saves picture, map and hit records, shows the command that renders
// the same picture, and compares it with the RTL.
import {by_id, make, shown} from "./elements.js";

function save(name, content, type) {
  const url = URL.createObjectURL(content instanceof Blob ? content : new Blob([content], {type}));
  make("a", {href: url, download: name}).click();
  setTimeout(() => URL.revokeObjectURL(url), 1000);
}

const quoted = (text) => /^[\w./:,=+-]+$/.test(text) ? text : `'${text.replace(/'/g, "'\\''")}'`;

/// The command that renders the same picture, and writes the hit record of the pixel.
export function command_of({scene, size, from, choices, pixel}) {
  const words = ["dynrt", "render", scene, "--board", "model", "--size", size.join("x"),
                 "--position", from.position.join(","), "--look-at", from.look_at.join(","),
                 "--up", from.up.join(","), "--fov", String(from.field_of_view)];
  words.push("--config", choices.mantissa_bits === null ? choices.configuration
                       : `${choices.configuration}_m${choices.mantissa_bits}.json`);
  for (const name of ["packets", "lines", "reflections"]) {
    if (choices[name] !== null) words.push(`--${name}`, String(choices[name]));
  }
  for (const light of choices.lights) words.push("--light", light);
  for (const mirror of choices.mirrors) words.push("--mirror", mirror);
  if (pixel) words.push("--pixel", pixel.join(","), "--json", "pixel.json");
  return words.map(quoted).join(" ");
}

export class SharePanel {
  /// `act` has the actions of the buttons: csv() returns the hit records, compare() starts the
  /// comparison.
  constructor(panel, act) {
    const button = (id, text, onclick, more = {}) =>
        make("button", {id, type: "button", onclick, ...more}, text);
    panel.replaceChildren(
        make("h2", {}, "Save"),
        make("p", {}, button("save-picture", "picture", () => this.save_canvas("picture")), " ",
             button("save-map", "map", () => this.save_canvas("map"),
                                 {disabled: true, title: "a map must be shown"}), " ",
             button("save-csv", "hit records (CSV)", async () => {
               const text = await act.csv();
               if (text) save(`${this.name()}.csv`, text, "text/csv");
             })),
        make("h2", {}, "The same on the command line"),
        make("div", {class: "command", id: "command"}),
        make("p", {class: "faint", id: "command-note"}),
        make("p", {}, button("copy-command", "copy", () =>
            navigator.clipboard.writeText(by_id("command").textContent))),
        make("div", {id: "through-rtl"}, make("h2", {}, "Through the RTL"),
             make("p", {}, button("compare", "render this frame through the RTL and compare", act.compare)),
             make("p", {id: "comparison", role: "status"})));
  }

  name() { return `${document.title.split(",")[0]}-${by_id("stage").dataset.number ?? 0}`; }

  save_canvas(id) {
    by_id(id).toBlob((blob) => save(`${this.name()}${id === "map" ? `-${by_id(id).dataset.name}` : ""}.png`,
                                    blob));
  }

  show(seen) {
    by_id("command").textContent = command_of(seen);
    const notes = [];
    if (!seen.inside) {
      notes.push("The camera is outside the scene, so render may choose another scale for the core's " +
                 "numbers, and last places may differ.");
    }
    if (seen.from.time > 0) {
      notes.push(`This is the scene at ${seen.from.time} seconds of its animation; render shows it at 0.`);
    }
    if (seen.choices.mantissa_bits !== null) {
      notes.push(`Write the configuration's file first: {"like": "${seen.choices.configuration}", ` +
                 `"mantissa_bits": ${seen.choices.mantissa_bits}}.`);
    }
    by_id("command-note").textContent = notes.join(" ");
  }

  say(sentence, state) {
    by_id("comparison").textContent = sentence;
    by_id("comparison").dataset.state = state;
  }

  compared(result) {
    const clocks = result.cycles ? `, ${shown(result.cycles)} clocks` : "";
    this.say(result.identical
        ? `identical: ${shown(result.pixels)} pixels, their hit records and ${result.counters} counters ` +
          `of model and RTL${clocks}`
        : `${shown(result.different_pixels)} pixels, ${shown(result.different_hits)} hit records and ` +
          `${result.different_counters} counters differ; the first: ${result.first}`, "done");
  }
}
