// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The view and the choices in the part of the address behind "#", so that a link shows somebody else
// the same.

const vectors = ["position", "look_at", "up"];
const numbers = ["field_of_view", "time"];
const counts = ["mantissa_bits", "packets", "lines", "reflections"];
const texts = ["lights", "mirrors"];

/// {from, choices, map, pixel}: only the parts that the address states.
export function read_address(hash = location.hash) {
  const given = new URLSearchParams(hash.replace(/^#/, ""));
  const from = {}, choices = {};
  for (const name of vectors) {
    const value = (given.get(name) ?? "").split(",").map(Number);
    if (value.length === 3 && value.every(Number.isFinite)) from[name] = value;
  }
  for (const name of numbers) {
    if (given.has(name) && Number.isFinite(+given.get(name))) from[name] = +given.get(name);
  }
  if (given.has("configuration")) choices.configuration = given.get("configuration");
  for (const name of counts) {
    if (/^\d+$/.test(given.get(name) ?? "")) choices[name] = +given.get(name);
  }
  for (const name of texts) {
    if (given.has(name)) choices[name] = given.getAll(name).filter((text) => text);
  }
  const pixel = (given.get("pixel") ?? "").split(",").map(Number);
  return {from, choices, map: given.get("map") ?? "",
          pixel: pixel.length === 2 && pixel.every(Number.isInteger) ? pixel : null};
}

export function address_of({from, choices, map, pixel}) {
  const told = new URLSearchParams();
  for (const name of vectors) told.set(name, from[name].join(","));
  for (const name of numbers) told.set(name, from[name]);
  told.set("configuration", choices.configuration);
  for (const name of counts) if (choices[name] !== null) told.set(name, choices[name]);
  for (const name of texts) {
    for (const text of choices[name].length ? choices[name] : [""]) told.append(name, text);
  }
  if (map) told.set("map", map);
  if (pixel) told.set("pixel", pixel.join(","));
  return "#" + told.toString().replace(/%2C/g, ",").replace(/%3A/g, ":");
}
