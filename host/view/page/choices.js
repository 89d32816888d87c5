// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The panel of choices: configuration, number format, packets, lines, reflections, lights, mirrors.
import {by_id, make, shown, table} from "./elements.js";

const formats = d3.range(8, 24);
const powers = (most) => d3.range(0, 1 + Math.log2(most)).map((i) => 2 ** i).reverse();

export class ChoicesPanel {
  /// `choose` gets all choices after a change.
  constructor(panel, choose) {
    Object.assign(this, {panel, choose});
  }

  show({choices, offers, core, materials, first}) {
    Object.assign(this, {choices, offers, core, first});
    const listed = offers.configurations.find(({name}) => name === choices.configuration);
    const text = (name, values, advice) => make("label", {}, `${name}, one a line: `, make("textarea", {
      id: `choice-${name}`, rows: 2, cols: 42, placeholder: advice,
      onchange: (event) => this.change({[name]: event.target.value.split("\n").map((t) => t.trim())
          .filter((t) => t)}),
    }, values.join("\n")));
    this.panel.replaceChildren(make("div", {class: "choices"},
        this.list("configuration", "Configuration",
                  offers.configurations.map(({name, about, built_in}) =>
                      [name, `${name}: ${about}${built_in ? "" : " (built when chosen)"}`]),
                  choices.configuration, (value) => ({configuration: value, mantissa_bits: null,
                                                      packets: null, lines: null, reflections: null})),
        this.list("mantissa_bits", "Bits of the mantissa",
                  [["", `${listed?.mantissa_bits ?? core.mantissa_bits}, as configured`],
                   ...formats.map((bits) => [bits, this.with_figures(bits)])],
                  choices.mantissa_bits, this.number("mantissa_bits")),
        this.list("packets", "Packets in flight",
                  [["", `all ${core.packets}`], ...powers(core.packets).slice(1).map((n) => [n, n])],
                  choices.packets, this.number("packets")),
        this.list("lines", "Lines of each cache",
                  [["", `all ${core.lines}`],
                   ...powers(core.lines).slice(1).filter((n) => n >= core.ways).map((n) => [n, n])],
                  choices.lines, this.number("lines")),
        core.reflections > 0
            ? this.list("reflections", "Bounces",
                        [["", `up to ${core.reflections}`],
                         ...d3.range(core.reflections).map((n) => [n, n])],
                        choices.reflections, this.number("reflections"))
            : make("p", {class: "faint"}, "This configuration reflects no rays; whitted does."),
        core.lights > 0 ? null
            : make("p", {class: "faint"}, "It has no light rays either and lights the scene from the eye."),
        text("lights", choices.lights, "X,Y,Z[:R,G,B[:INTENSITY]]"),
        text("mirrors", choices.mirrors, "MATERIAL[=0..1]"),
        make("details", {}, make("summary", {}, `${materials.length} materials`),
             make("p", {class: "faint"}, materials.join(", "))),
        make("p", {id: "making", role: "status"}),
        ...this.figures()));
  }

  list(id, label, options, chosen, act) {
    return make("label", {}, `${label} `, make("select", {
      id: `choice-${id}`, onchange: (event) => this.change(act(event.target.value)),
    }, ...options.map(([value, text]) => make("option", {
      value, selected: String(value) === String(chosen ?? "")}, String(text)))));
  }

  number(name) { return (value) => ({[name]: value === "" ? null : +value}); }

  change(some) { this.choose({...this.choices, ...some}); }

  /// The figures of the last error report that has this configuration with these bits.
  row(bits) {
    const report = this.offers.errors[this.choices.configuration];
    const suffix = this.choices.configuration === "thesis" ? "" : `_${this.choices.configuration}`;
    return report?.variants.find(({variant}) => variant === `m${bits}${suffix}`) ?? null;
  }

  with_figures(bits) {
    const row = this.row(bits);
    return row ? `${bits}: ${(100 * row["primary.wrong_share"]).toPrecision(2)} % of hits wrong` : bits;
  }

  /// How error, clocks and cells change with the number format.
  figures() {
    const report = this.offers.errors[this.choices.configuration];
    if (!report) return [];
    const rows = formats.map((bits) => [bits, this.row(bits)]).filter(([, row]) => row);
    const base = this.row(this.core.mantissa_bits);
    const ratio = (row, name) => base ? `${shown(row[name])} (${(100 * row[name] / base[name]).toFixed(0)} %)`
                                      : shown(row[name]);
    return [
      make("h2", {}, "What the number format changes"),
      make("p", {class: "faint"}, `From the last error report: ${report.scene} at ${report.size} on ` +
           `${report.device}; shares are of the chosen format.`),
      table(["bits", "wrong hits", "LUT", "ms a frame"], rows.map(([bits, row]) =>
          [bits, `${(100 * row["primary.wrong_share"]).toPrecision(3)} %`, ratio(row, "LUT"),
           ratio(row, "frame, ms")])),
    ];
  }

  say(sentence) { if (by_id("making")) by_id("making").textContent = sentence; }
}
