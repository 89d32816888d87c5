// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// A map over the picture, its legend, and the slider between the two.
import {by_id, make, shown} from "./elements.js";

const class_colours = ["#3b7d4f", "#e3b505", "#d7263d", "#8f2bd6"];
const unknown = [0, 0, 0, 255];

function bytes_of(colour) {
  const {r, g, b} = d3.rgb(colour);
  return [r, g, b, 255];
}

/// Colours of 256 steps from low to high.
const ramp = () => d3.range(256).map((i) => bytes_of(d3.interpolateViridis(i / 255)));

export class MapView {
  constructor(canvas, select, maps) {
    Object.assign(this, {canvas, select, maps, head: null});
    for (const {name, about} of maps) {
      select.append(make("option", {value: name}, `${name}: ${about}`));
    }
    by_id("split").oninput = () => this.split();
  }

  get name() { return this.select.value; }
  get wanted() { return this.maps.find((map) => map.name === this.name) ?? null; }

  hide() {
    this.canvas.hidden = by_id("legend").hidden = by_id("split-label").hidden = true;
    by_id("save-map").disabled = true;
    this.head = null;
    delete this.canvas.dataset.name;
  }

  show({head, words}, width, height) {
    this.head = head;
    this.values = head.kind === "colours" ? words : new Float32Array(words.buffer, words.byteOffset,
                                                                     words.length);
    this.canvas.width = width;
    this.canvas.height = height;
    this.canvas.getContext("2d").putImageData(
        new ImageData(new Uint8ClampedArray(this.colours().flat()), width, height), 0, 0);
    this.canvas.hidden = by_id("split-label").hidden = by_id("save-map").disabled = false;
    this.canvas.dataset.name = head.name;
    this.legend();
    this.split();
  }

  colours() {
    const {kind, low, high} = this.head;
    if (kind === "colours") {
      return Array.from(this.values, (w) => [w & 255, w >> 8 & 255, w >> 16 & 255, 255]);
    }
    if (kind === "classes") {
      const colours = class_colours.map(bytes_of);
      return Array.from(this.values, (value) => colours[value]);
    }
    const colours = ramp();
    // The scale is a square root, which spreads small values out: few pixels have the large ones.
    const scale = high > low ? 1 / (high - low) : 0;
    return Array.from(this.values, (value) => Number.isNaN(value)
        ? unknown : colours[Math.round(255 * Math.sqrt((value - low) * scale))]);
  }

  legend() {
    const {kind, low, high, classes, counts} = this.head;
    const about = this.wanted?.about ?? this.head.name;
    const parts = [make("div", {}, about)];
    if (kind === "values") {
      const stops = d3.range(11).map((i) => d3.interpolateViridis(i / 10)).join(", ");
      parts.push(make("div", {class: "bar", style: `background: linear-gradient(to right, ${stops})`}),
                 make("div", {class: "ends"}, make("span", {}, shown(low)),
                      make("span", {}, shown(+(low + (high - low) / 4).toPrecision(3))), make("span", {}, shown(high))));
    } else if (kind === "classes") {
      parts.push(make("div", {}, ...classes.flatMap((name, i) => [
        make("span", {class: "key", style: `background: ${class_colours[i]}`}),
        `${name} (${shown(counts[i])})`])));
    }
    by_id("legend").replaceChildren(...parts);
    by_id("legend").hidden = false;
  }

  /// The right part is the map.
  split() {
    this.canvas.style.clipPath = `inset(0 0 0 ${100 - by_id("split").value}%)`;
  }
}
