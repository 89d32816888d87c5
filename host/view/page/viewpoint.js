// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Where the camera is and where it looks: {position, look_at, up, field_of_view, time}, the program's
// Viewpoint.

export const add = (a, b, by = 1) => a.map((x, i) => x + by * b[i]);
export const minus = (a, b) => a.map((x, i) => x - b[i]);
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                                a[0] * b[1] - a[1] * b[0]];
export const length = (a) => Math.sqrt(dot(a, a));
export const unit = (a) => a.map((x) => x / length(a));

/// Unit vectors: forward, to the right, up in the picture.
export function axes_of(from) {
  const forward = unit(minus(from.look_at, from.position));
  const right = unit(cross(forward, from.up));
  return {forward, right, up: cross(right, forward)};
}

/// Steps along the view's axes; the up of a step is that of the scene.
export function moved(from, {ahead = 0, aside = 0, higher = 0}) {
  const {forward, right} = axes_of(from);
  let step = add([0, 0, 0], forward, ahead);
  step = add(step, right, aside);
  step = add(step, unit(from.up), higher);
  return {...from, position: add(from.position, step), look_at: add(from.look_at, step)};
}

function turned_about(vector, axis, angle) {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const along = dot(axis, vector) * (1 - c);
  const side = cross(axis, vector);
  return vector.map((x, i) => x * c + side[i] * s + axis[i] * along);
}

/// Turns to the right and up, in radians; never beyond straight up or down.
export function turned(from, to_right, to_up) {
  const steepest = 1.5;
  const {forward, right} = axes_of(from);
  const up = unit(from.up);
  const now = Math.asin(Math.max(-1, Math.min(1, dot(forward, up))));
  const pitch = Math.max(-steepest, Math.min(steepest, now + to_up)) - now;
  const looking = turned_about(turned_about(forward, right, pitch), up, -to_right);
  const distance = length(minus(from.look_at, from.position));
  return {...from, look_at: add(from.position, looking, distance)};
}

/// The point of the picture, 0 to 1 from the left and from the top, where a point of the world is
/// seen; nothing for one behind the eye.
export function seen_at(from, aspect, point) {
  const {forward, right, up} = axes_of(from);
  const to = minus(point, from.position);
  const depth = dot(to, forward);
  if (depth <= 0) return null;
  const half = Math.tan(from.field_of_view * Math.PI / 360);
  return [0.5 + dot(to, right) / depth / (2 * half * aspect),
          0.5 - dot(to, up) / depth / (2 * half)];
}
