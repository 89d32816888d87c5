// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The window: ties the picture, the walk and the panels to the program.
import {ask} from "./ask.js";
import {Frames} from "./frames.js";
import {Picture} from "./picture.js";
import {length, minus} from "./viewpoint.js";
import {Walk} from "./walk.js";

const by_id = (id) => document.getElementById(id);

function say(sentence) {
  by_id("message").textContent = sentence;
  by_id("message").hidden = !sentence;
}

const picture = new Picture(by_id("picture"));
let from = null, changed = -Infinity;

function change(act) {
  from = act(from);
  changed = performance.now();
}

function show(answer, of) {
  const {width, height, moving, seconds} = answer.head;
  picture.show(answer.words, width, height);
  say("");
  const stage = by_id("stage");
  stage.dataset.state = moving ? "moving" : "still";
  stage.dataset.size = `${width}x${height}`;
  by_id("speed").textContent = moving
      ? `window ${frames.rate} frames a second at ${width}x${height}`
      : `${width}x${height}, drawn in ${seconds.toFixed(2)} s`;
}

const start = (await ask("start")).head;
from = start.first;
by_id("title").textContent = `dynrt view ${start.scene}`;
document.title = `${start.scene}, dynrt view`;
const frames = new Frames([start.width, start.height], show, (error) => say(error.message));
const walk = new Walk(by_id("stage"), change, () => {});
walk.speed = length(minus(start.high, start.low)) / 8;

let before = performance.now();
function tick(now) {
  if (walk.walking) change((at) => walk.step(at, Math.min(0.2, (now - before) / 1000)));
  before = now;
  frames.next(from, changed);
  requestAnimationFrame(tick);
}
by_id("stage").focus();
requestAnimationFrame(tick);
