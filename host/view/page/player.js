// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The scene's animation: played, stopped, stepped.
import {by_id} from "./elements.js";

const step = 1 / 25;  // seconds

export class Player {
  /// `show` gets each moment.
  constructor(seconds, show) {
    Object.assign(this, {seconds, show, time: 0, playing: false});
    by_id("clock-controls").hidden = !(seconds > 0);
    by_id("time").max = seconds;
    by_id("time").value = 0;
    by_id("play").onclick = () => this.play(!this.playing);
    by_id("step").onclick = () => this.go(this.time + step);
    by_id("step-back").onclick = () => this.go(this.time - step);
    by_id("time").oninput = (event) => this.go(+event.target.value);
    this.tell();
  }

  play(on) {
    this.playing = on;
    by_id("play").textContent = on ? "stop" : "play";
    by_id("play").setAttribute("aria-pressed", on);
  }

  go(time) {
    this.play(false);
    this.set(Math.max(0, Math.min(this.seconds, time)));
  }

  set(time) {
    this.time = time;
    this.tell();
    this.show(time);
  }

  tell() {
    by_id("time").value = this.time;
    by_id("time").dataset.seconds = this.time;  // the slider keeps fewer digits
    by_id("seconds").textContent = `${this.time.toFixed(2)} s`;
  }

  /// Goes on after so many seconds.
  tick(passed) {
    if (this.playing) this.set((this.time + passed) % this.seconds);
  }
}
