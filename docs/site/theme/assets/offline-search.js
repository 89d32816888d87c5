// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Lets the search work where the site is opened as a file. There a browser neither loads the index by
// a request nor starts a worker. So the index comes as a script, search_index.js, and a hidden frame
// takes the worker's place.
var __search = { index: Promise.resolve(searchIndex) };

if (location.protocol === "file:") {
  window.Worker = class extends EventTarget {
    constructor(url) {
      super();
      const frame = document.createElement("iframe");
      frame.hidden = true;
      document.body.appendChild(frame);
      this.inside = frame.contentWindow;
      this.inside.postMessage = (data) => this.dispatchEvent(new MessageEvent("message", { data }));
      this.inside.importScripts = () => {};
      const script = frame.contentDocument.createElement("script");
      this.ready = new Promise((done) => (script.onload = done));
      script.src = url;
      frame.contentDocument.body.appendChild(script);
    }
    postMessage(data) {
      this.ready.then(() => this.inside.dispatchEvent(new MessageEvent("message", { data })));
    }
  };
}
