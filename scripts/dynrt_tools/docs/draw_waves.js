// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Draws timing diagrams: reads {NAME: diagram} from stdin and writes {NAME: SVG} to stdout. Parts of
// WaveDrom's skin that a diagram does not use are left out, nine tenths of the file.
const { createRequire } = require("module");
const load = createRequire(process.argv[2] + "/");
const wavedrom = load("wavedrom");
const onml = load("onml");
const skin = load("wavedrom/skins/narrow.js");

function visit(tree, see) {
  if (!Array.isArray(tree)) return;
  see(tree);
  tree.forEach((child) => visit(child, see));
}

function draw(diagram) {
  const tree = structuredClone(wavedrom.renderAny(0, diagram, skin)); // it holds the skin itself
  const used = new Set();
  visit(tree, (node) => {
    const link = node[0] === "use" && node[1]["xlink:href"];
    if (link) used.add(link.slice(1));
  });
  visit(tree, (node) => {
    if (node[0] !== "defs") return;
    const kept = node.filter((part) => !(Array.isArray(part) && part[0] === "g") || used.has(part[1].id));
    node.splice(0, node.length, ...kept);
  });
  return onml.s(tree);
}

const diagrams = JSON.parse(require("fs").readFileSync(0, "utf8"));
const pictures = Object.entries(diagrams).map(([name, diagram]) => [name, draw(diagram)]);
process.stdout.write(JSON.stringify(Object.fromEntries(pictures)));
