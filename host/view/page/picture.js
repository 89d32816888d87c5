// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The picture on its canvas.

export class Picture {
  constructor(canvas) {
    this.canvas = canvas;
    this.context = canvas.getContext("2d");
  }

  /// Words of 0x00BBGGRR, row by row from the top.
  show(words, width, height) {
    const opaque = words.map((word) => (word | 0xff000000) >>> 0);
    const image = new ImageData(new Uint8ClampedArray(opaque.buffer), width, height);
    if (this.canvas.width !== width || this.canvas.height !== height) {
      this.canvas.width = width;
      this.canvas.height = height;
    }
    this.context.putImageData(image, 0, 0);
  }

  /// Of an event, in pixels of the picture.
  place_of(event) {
    const box = this.canvas.getBoundingClientRect();
    const along = (at, from, size, pixels) =>
        Math.max(0, Math.min(pixels - 1, Math.floor((at - from) / size * pixels)));
    return {x: along(event.clientX, box.left, box.width, this.canvas.width),
            y: along(event.clientY, box.top, box.height, this.canvas.height)};
  }
}
