// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Keys and mouse on the picture: which way one walks now, and what a drag turns.
import {moved, turned} from "./viewpoint.js";

const keys = {
  w: {ahead: 1}, s: {ahead: -1}, a: {aside: -1}, d: {aside: 1}, e: {higher: 1}, q: {higher: -1},
  arrowup: {ahead: 1}, arrowdown: {ahead: -1}, pageup: {up: 1}, pagedown: {up: -1},
  arrowleft: {turn: -1}, arrowright: {turn: 1},
};
const turns_a_second = 1.2;  // radians
const tap = 1 / 30;          // seconds
const drag_turns = 0.0045;   // radians a pixel

export class Walk {
  /// `change` takes a function from a viewpoint to the next; `pointed` gets the place of a click.
  constructor(stage, change, pointed) {
    this.change = change;
    this.held = new Set();
    this.fast = false;
    stage.addEventListener("keydown", (event) => this.key(event, true));
    stage.addEventListener("keyup", (event) => this.key(event, false));
    stage.addEventListener("blur", () => this.held.clear());
    stage.addEventListener("wheel", (event) => {
      event.preventDefault();
      change((from) => moved(from, {ahead: -Math.sign(event.deltaY) * this.speed / 10}));
    }, {passive: false});
    stage.addEventListener("pointerdown", (event) => {
      if (event.button !== 0 || event.target.closest("[data-control]")) return;
      stage.focus();
      stage.setPointerCapture(event.pointerId);
      this.drag = {x: event.clientX, y: event.clientY, far: 0};
    });
    stage.addEventListener("pointermove", (event) => {
      if (!this.drag) return;
      const [x, y] = [event.clientX - this.drag.x, event.clientY - this.drag.y];
      this.drag = {x: event.clientX, y: event.clientY, far: this.drag.far + Math.abs(x) + Math.abs(y)};
      if (this.drag.far > 3) change((from) => turned(from, -x * drag_turns, y * drag_turns));
    });
    stage.addEventListener("pointerup", (event) => {
      if (this.drag && this.drag.far <= 3) pointed(event);
      this.drag = null;
    });
    this.speed = 1;
  }

  key(event, down) {
    const name = event.key.toLowerCase();
    this.fast = event.shiftKey;
    if (!(name in keys) || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    if (!down) return this.held.delete(name);
    if (this.held.has(name)) return;
    this.held.add(name);
    this.change((from) => this.step(from, tap));  // however short the key is held
  }

  get walking() { return this.held.size > 0; }

  /// The viewpoint after so many seconds of the keys that are held.
  step(from, seconds) {
    const sum = {ahead: 0, aside: 0, higher: 0, turn: 0, up: 0};
    for (const key of this.held) {
      for (const [name, by] of Object.entries(keys[key])) sum[name] += by;
    }
    const far = this.speed * seconds * (this.fast ? 4 : 1);
    const stepped = moved(from, {ahead: sum.ahead * far, aside: sum.aside * far,
                                 higher: sum.higher * far});
    const angle = turns_a_second * seconds;
    return sum.turn || sum.up ? turned(stepped, sum.turn * angle, sum.up * angle) : stepped;
  }
}
