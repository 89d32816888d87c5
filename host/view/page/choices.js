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

  show({choices, offers, core, least_lines, materials, first}) {
    Object.assign(this, {choices, offers, core, first});
    const listed = offers.configurations.find(({name}) => name === choices.configuration);
    const text = (name, values, advice) => make("label", {class: "lines"}, `${name}, one a line`,
                                            make("textarea", {
      id: `choice-${name}`, rows: 2, placeholder: advice,
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
                   ...powers(core.lines).slice(1).filter((n) => n >= least_lines).map((n) => [n, n])],
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
        make("div", {id: "trials", hidden: true}),
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

  /// The figures of the last error reports, by configuration and bits.
  row(configuration, bits) {
    const suffix = configuration === "thesis" ? "" : `_${configuration}`;
    const name = `m${bits}${suffix}`;
    const {errors} = this.offers;
    for (const report of [errors[this.choices.configuration], ...Object.values(errors)]) {
      const row = report?.rows.find(({variant}) => variant === name);
      if (row) return row;
    }
    return null;
  }

  with_figures(bits) {
    const row = this.row(this.choices.configuration, bits);
    return row ? `${bits}: ${(100 * row["primary.wrong_share"]).toPrecision(2)} % of hits wrong` : bits;
  }

  /// Of the core that is chosen; null if no report has it.
  get cells() {
    return this.row(this.choices.configuration, this.core.mantissa_bits)?.LUT ?? null;
  }

  /// How error, time and LUTs change with the number format and the configuration.
  figures() {
    const [report] = Object.values(this.offers.errors);
    if (!report) return [];
    const {configuration} = this.choices;
    const found = (name, bits) => ({name, bits, row: this.row(name, bits)});
    const others = this.offers.configurations.filter(({name}) => name !== configuration);
    const rows = [...formats.map((bits) => found(configuration, bits)),
                  ...others.map(({name, mantissa_bits}) => found(name, mantissa_bits))]
        .filter(({row}) => row);
    if (rows.length === 0) return [];
    const base = this.row(configuration, this.core.mantissa_bits);
    const ratio = (row, name) => base
        ? `${shown(+row[name].toPrecision(6))} (${(100 * row[name] / base[name]).toFixed(0)} %)`
        : shown(row[name]);
    return [
      make("h2", {}, "Effect of the number format and the configuration"),
      make("p", {class: "faint"}, `From the last error reports: ${report.rows[0].scene} at ${report.size} on ` +
           `${report.device}; in brackets: the share of the chosen core.`),
      table(["", "bits", "wrong hits", "LUT", "ms a frame"], rows.map(({name, bits, row}) =>
          [name, bits, `${(100 * row["primary.wrong_share"]).toPrecision(3)} %`, ratio(row, "LUT"),
           ratio(row, "frame_ms")])),
    ];
  }

  say(sentence) { if (by_id("making")) by_id("making").textContent = sentence; }
}
