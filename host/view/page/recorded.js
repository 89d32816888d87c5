// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Takes the place of ask.js in a page that is a file with a recorded frame: gives the answers that
// the program has written into the file (host/view/recording.h).

export class Refused extends Error {}

export function parts_of(bytes) {
  const length = new DataView(bytes).getUint32(0, true);
  const text = new TextDecoder().decode(new Uint8Array(bytes, 4, length));
  return {head: JSON.parse(text), words: new Uint32Array(bytes, 4 + length)};
}

async function unpacked() {
  const text = document.getElementById("recorded").textContent;
  const packed = Uint8Array.from(atob(text), (character) => character.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
  return parts_of(await new Response(stream).arrayBuffer());
}

const {head: kept, words} = await unpacked();
const {width, height} = kept.frame;
const picture_of = (place) => words.subarray(place * width * height, (place + 1) * width * height);
const placed = ({box, corners, ...step}) => ({
  ...step,
  ...(box === undefined ? {} : {box: kept.places[box]}),
  ...(corners === undefined ? {} : {corners: kept.places[corners]}),
});

/// As the program writes it (hit_table of host/render/hit_json.h).
function csv() {
  const cell = (value) => typeof value === "boolean" ? +value : value?.value ?? value;
  const line = ({record}) => kept.columns.map((name) => cell(record[name])).join(",");
  return [kept.columns.join(","), ...kept.pixels.map(line), ""].join("\n");
}

const answers = {
  start: () => ({head: kept.start}),
  frame: () => ({head: kept.frame, words: picture_of(0)}),
  examine: () => ({head: kept.machine}),
  pixel: ({x, y}) => {
    const pixel = kept.pixels[y * width + x];
    return {head: {...pixel, way: kept.packets[pixel.way].map(placed)}};
  },
  csv: () => ({head: {csv: csv()}}),
  map: ({name}) => {
    const place = kept.maps.findIndex((map) => map.name === name);
    return {head: kept.maps[place], words: picture_of(place + 1).slice()};
  },
};

export async function ask(type, fields = {}) {
  if (!(type in answers)) throw new Refused("a recorded frame cannot answer this");
  return answers[type](fields);
}
