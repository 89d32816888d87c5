// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The window: ties the picture, the walk and the panels to the program.
import {address_of, read_address} from "./address.js";
import {ask} from "./ask.js";
import {ChoicesPanel} from "./choices.js";
import {by_id, tabs} from "./elements.js";
import {Frames} from "./frames.js";
import {MachinePanel} from "./machine.js";
import {MapView} from "./maps.js";
import {Picture} from "./picture.js";
import {PixelPanel} from "./pixel.js";
import {Player} from "./player.js";
import {SharePanel} from "./share.js";
import {Trials} from "./trials.js";
import {length, minus} from "./viewpoint.js";
import {Walk} from "./walk.js";

function say(sentence) {
  by_id("message").textContent = sentence;
  by_id("message").hidden = !sentence;
}

const stage = by_id("stage");
const picture = new Picture(by_id("picture"));
const machine = new MachinePanel(by_id("panel-machine"));
const pixel = new PixelPanel(by_id("panel-pixel"), by_id("overlay"), (x, y) => point(x, y));
let from = null, changed = -Infinity;
let full = null;     // {head, from} of the full picture in sight
let watched = null;  // what the program saw while it rendered that picture clock by clock
let pointed = null;  // {x, y}
let start = null;    // the program's answer to the choices that hold
const given = read_address();

function change(act) {
  if (start.recorded) return;  // there is one frame
  from = act(from);
  changed = performance.now();
}

/// Asks a question about the full picture; null if there is a newer one when the answer comes.
async function ask_of_full(type, fields = {}) {
  const of = full;
  try {
    const answer = await ask(type, {...fields, number: of.head.number});
    return of === full ? answer : null;
  } catch (error) {
    say(error.message);
    return null;
  }
}

function show(answer, of) {
  const {width, height, moving, seconds} = answer.head;
  picture.show(answer.words, width, height);
  say("");
  document.documentElement.style.setProperty("--aspect", width / height);
  stage.dataset.state = moving ? "moving" : "still";
  stage.dataset.size = `${width}x${height}`;
  if (moving) {
    by_id("speed").textContent = `window: ${frames.rate} frames/s at ${width}x${height}` +
        (core_rate ? `; the core: ${core_rate}` : "");
    if (full) forget_full();
    return;
  }
  by_id("speed").textContent = `${width}x${height}, drawn in ${seconds.toFixed(2)} s`;
  if (answer.head.opened !== start.opened) return take_over();
  full = {head: answer.head, from: of};
  if (given.pixel) [pointed, given.pixel] = [{x: given.pixel[0], y: given.pixel[1]}, null];
  stage.dataset.number = answer.head.number;
  tell_address();
  look_inside();
}

/// Writes the view and the choices into the address and the command.
function tell_address() {
  if (!full) return;
  const pixel = pointed ? [pointed.x, pointed.y] : null;
  const {choices} = start;
  history.replaceState(null, "", address_of({from: full.from, choices, map: maps.name, pixel}));
  share.show({scene: start.scene, size: frames.size, from: full.from, choices, pixel,
              inside: full.from.position.every((x, i) =>
                  x >= Math.min(start.low[i], start.first.position[i]) &&
                  x <= Math.max(start.high[i], start.first.position[i]))});
}

/// Another page of this window has made another choice.
async function take_over() {
  begin((await ask("start")).head);
  frames.whole = null;
}

let core_rate = "";

function forget_full() {
  full = watched = null;
  pointed = null;
  pixel.clear();
  machine.clear();
  maps.hide();
  delete stage.dataset.watched;
}

/// Has the program watch the frame, and shows the machine and the maps of it.
async function look_inside() {
  if (maps.wanted && !maps.wanted.watched) show_map();
  const answer = await ask_of_full("examine");
  if (!answer || answer.head.stopped) {
    if (answer && full) setTimeout(() => full && !watched && look_inside(), 50);
    return;
  }
  watched = answer.head;
  stage.dataset.watched = watched.number;
  machine.show(watched);
  if (!watched.cycles) find_clocks();
  note_trial();
  if (watched.frames_per_second) {
    core_rate = `${watched.frames_per_second.toFixed(1)} frames/s at ${watched.clock.mhz} MHz`;
    by_id("speed").textContent += `; the core: ${core_rate}, ${watched.cycles.toLocaleString("en")} clocks`;
  }
  if (maps.wanted?.watched) show_map();
  if (pointed) point(pointed.x, pointed.y);
}

/// Adds the full picture to the table of the choices tried.
function note_trial() {
  if (start.recorded) return;
  const row = trials.row(full.from, start.choices);
  Object.assign(row, {clocks: watched.cycles, cells: chosen.cells});
  trials.draw(by_id("trials"));
  if (trials.rows.length > 1) count_wrong(row);
}

async function count_wrong(row) {
  if (row.wrong !== undefined) return;
  try {
    const {counts} = (await ask("map", {name: "wrong", number: full.head.number})).head;
    row.wrong = 1 - counts[0] / d3.sum(counts);
  } catch {
    row.wrong = null;  // no true hits in this build, or there is a newer picture
  }
  trials.draw(by_id("trials"));
}

async function point(x, y) {
  if (!full) return;
  pointed = {x, y};
  const answer = await ask_of_full("pixel", {x, y});
  if (!answer || pointed.x !== x || pointed.y !== y) return;
  if (!by_id("panel-pixel").dataset.pixel) choose_tab("pixel");
  tell_address();
  pixel.show(answer.head, full.from, [full.head.width, full.head.height]);
}

async function show_map() {
  if (!maps.wanted) return maps.hide();
  if (!full || (maps.wanted.watched && !watched)) return;
  if (maps.name === "clocks" && !watched.cycles && lowered === "under way") return maps.hide();
  const answer = await ask_of_full("map", {name: maps.name});
  if (!answer) return maps.hide();
  if (answer.head.name === maps.name) maps.show(answer, full.head.width, full.head.height);
}

/// Whether the units of the current choices were lowered: "", "under way" or "tried".
let lowered = "";

/// Has the program lower the units of a configuration that has no schedules, and watches the frame
/// again. Until then the page shows everything but the clocks.
async function find_clocks() {
  if (lowered || start.recorded) return;
  lowered = "under way";
  const {choices} = start;
  const holds = () => start.choices === choices;
  const tell = (text) => {
    if (holds()) machine.say_of_clocks(by_id("clocks").textContent = text);
  };
  try {
    // The units of an earlier choice may still be lowered.
    for (let head; holds() && (head = (await ask("lowering")).head).state === "running";) {
      tell(`its clocks come after ${progress_of(head)}`);
      await new Promise((resolve) => setTimeout(resolve, 500));
    }
    if (!holds()) return;
    const {head} = await ask("lower", choices);
    await finished(head.job, (text) => tell(`its clocks come with ${text}`), "lowering");
    if (!holds()) return;
    lowered = "tried";
    tell("");
    if (full) look_inside();
  } catch (error) {
    if (holds()) lowered = "tried";
    tell(`its clocks are not known: ${error.message}`);
  }
}

const progress_of = ({name, progress, seconds}) =>
    `${name}: ${progress || "begun"}, ${seconds.toFixed(0)} s`;

/// Asks how far a job is until it ends. Returns its result, or null if another job has begun.
async function finished(job, tell, question = "progress") {
  for (;;) {
    const {head} = await ask(question);
    if (head.job !== job) return null;
    if (head.state === "done") return head.result;
    if (head.state === "failed") throw new Error(head.error);
    tell(progress_of(head));
    await new Promise((resolve) => setTimeout(resolve, 200));
  }
}

/// Builds the configuration if need be, and opens the scene with it. If that fails, the last picture
/// stays.
async function choose(choices) {
  stage.dataset.choosing = "yes";
  if (watched) count_wrong(trials.row(full.from, start.choices));
  try {
    const {head} = await ask("make", choices);
    if (!await finished(head.job, (text) => chosen.say(text))) return;
    chosen.say("building the trees");
    begin((await ask("open", choices)).head);
    forget_full();
    change((at) => ({...at}));
    frames.whole = null;
    say("");
  } catch (error) {
    say(error.message);
    chosen.show(start);
  } finally {
    chosen.say("");
    trials.draw(by_id("trials"));
    delete stage.dataset.choosing;
  }
}

/// Takes over the program's description of the scene and the core.
function begin(answer) {
  start = answer;
  chosen.show(start);
  core_rate = "";
  lowered = "";
  by_id("clocks").textContent = "";
}

async function compare() {
  by_id("compare").disabled = true;
  try {
    share.say("begun", "running");
    const {head} = await ask("compare", {number: full?.head.number ?? 0});
    const result = await finished(head.job, (text) => share.say(text, "running"));
    if (result) share.compared(result);
  } catch (error) {
    share.say(error.message, "failed");
  } finally {
    by_id("compare").disabled = false;
  }
}

const trials = new Trials();
const chosen = new ChoicesPanel(by_id("panel-choices"), choose);
const share = new SharePanel(by_id("panel-share"), {
  compare,
  csv: async () => (await ask_of_full("csv"))?.head.csv,
});
const choose_tab = tabs(by_id("tabs"), {pixel: "Pixel", machine: "Machine", choices: "Choices",
                                        share: "Share"}, () => {});
begin((await ask("start")).head);
if (start.recorded) {
  for (const name of ["tab-choices", "through-rtl"]) by_id(name).hidden = true;
  given.from = given.choices = {};
}
from = {...start.first, ...given.from};
by_id("title").textContent = `dynrt view ${start.scene}`;
document.title = `${start.scene}, dynrt view`;
const maps = new MapView(by_id("map"), by_id("map-name"), start.maps);
by_id("map-name").value = start.maps.some(({name}) => name === given.map) ? given.map : "";
by_id("map-name").onchange = () => {
  tell_address();
  show_map();
};
const frames = new Frames([start.width, start.height], show, (error) => say(error.message));
const walk = new Walk(stage, change, (event) => {
  const {x, y} = picture.place_of(event);
  point(x, y);
});
walk.speed = length(minus(start.high, start.low)) / 8;
/// Shows a moment, from the scene's own camera if the reader wants that.
async function show_moment(time) {
  change((at) => ({...at, time}));
  if (!by_id("follow").checked) return;
  const {head} = await ask("path", {time});
  if (head.from && player.time === time) change(() => head.from);
}
by_id("follow-label").hidden = !start.has_path;
by_id("follow").onchange = () => show_moment(player.time);
const player = new Player(start.seconds, show_moment);
player.time = from.time;
player.tell();
const wanted = {...start.choices, ...given.choices};
if (JSON.stringify(wanted) !== JSON.stringify(start.choices)) await choose(wanted);

let before = performance.now();
function tick(now) {
  const passed = Math.min(0.2, (now - before) / 1000);
  if (walk.walking) change((at) => walk.step(at, passed));
  player.tick(passed);
  before = now;
  if (!stage.dataset.choosing) frames.next(from, changed);
  requestAnimationFrame(tick);
}
stage.focus();
requestAnimationFrame(tick);
