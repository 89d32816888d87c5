// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The stream of pictures: coarse ones while something moves, as fast as the program draws them, and a
// full one when nothing moves.
import {ask} from "./ask.js";

const scales = [1, 0.75, 0.5, 0.375, 0.25];
const longest = 1000 / 17;  // ms a frame while moving, so that there are 15 a second
const rest = 140;           // after so many ms without a change nothing moves

export class Frames {
  /// `shown` gets each frame, `failed` each refusal.
  constructor(size, shown, failed) {
    Object.assign(this, {size, shown, failed, scale: 2, asked: null, whole: null, times: []});
  }

  /// Frames a second while moving, of the last second.
  get rate() {
    const now = performance.now();
    this.times = this.times.filter((time) => now - time < 1000);
    return this.times.length;
  }

  /// Asks for the next frame if one is due; `changed` is when `from` last changed.
  async next(from, changed) {
    if (this.asked) return;
    const moving = performance.now() - changed < rest;
    if (!moving && this.whole === from) return;
    const begin = performance.now();
    this.asked = from;
    try {
      const [width, height] = moving ? this.coarse() : this.size;
      const answer = await ask("frame", {...from, width, height, moving});
      if (moving) this.adapt(performance.now() - begin);
      if (!moving) this.whole = from;
      this.shown(answer, from);
    } catch (error) {
      this.whole = from;  // asked again when something changes
      this.failed(error);
    } finally {
      this.asked = null;
    }
  }

  coarse() {
    return this.size.map((side) => Math.max(8, Math.round(side * scales[this.scale] / 8) * 8));
  }

  adapt(milliseconds) {
    this.times.push(performance.now());
    this.mean = this.mean ? 0.8 * this.mean + 0.2 * milliseconds : milliseconds;
    const finer = this.scale > 0 ? (scales[this.scale - 1] / scales[this.scale]) ** 2 : Infinity;
    if (this.mean > longest && this.scale < scales.length - 1) {
      this.scale += 1;
      this.mean = 0;
    } else if (this.mean * finer < 0.8 * longest) {
      this.scale -= 1;
      this.mean = 0;
    }
  }
}
