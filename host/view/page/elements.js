// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Elements of the page, and numbers as text.

export const by_id = (id) => document.getElementById(id);

/// An element with attributes, and children or text.
export function make(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") element[name] = value;
    else if (value === true) element.setAttribute(name, "");
    else if (value !== false && value !== null) element.setAttribute(name, value);
  }
  element.append(...children.filter((child) => child !== null));
  return element;
}

const is_number = (value) => typeof value === "number" || / %$/.test(value);

/// A table of rows of cells; numbers go to the right.
export function table(head, rows) {
  const cell = (value) => make("td", is_number(value) ? {class: "number"} : {}, shown(value));
  return make("table", {},
              ...(head.length ? [make("tr", {}, ...head.map((name) => make("th", {}, name)))] : []),
              ...rows.map((row) => make("tr", {}, ...row.map(cell))));
}

export function shown(value) {
  if (value instanceof Node) return value;
  if (value === null || value === undefined) return "–";
  if (typeof value !== "number") return String(value);
  if (Number.isInteger(value)) return value.toLocaleString("en");
  const size = Math.abs(value);
  return size >= 1e5 || size < 1e-3 ? value.toExponential(3) : String(+value.toPrecision(6));
}

export const percent = (share) => share === null ? "–" : `${(100 * share).toFixed(1)} %`;

/// One of several panels is seen; `shown_now` is called with its name.
export function tabs(list, panels, shown_now) {
  const choose = (name) => {
    for (const other of Object.keys(panels)) {
      by_id(`panel-${other}`).hidden = other !== name;
      by_id(`tab-${other}`).setAttribute("aria-selected", other === name);
      by_id(`tab-${other}`).tabIndex = other === name ? 0 : -1;
    }
    shown_now(name);
  };
  const names = Object.keys(panels);
  for (const [i, name] of names.entries()) {
    list.append(make("button", {
      id: `tab-${name}`, type: "button", role: "tab", "aria-controls": `panel-${name}`,
      onclick: () => choose(name),
      onkeydown: (event) => {
        const by = {ArrowRight: 1, ArrowLeft: -1}[event.key];
        if (!by) return;
        const next = names[(i + by + names.length) % names.length];
        choose(next);
        by_id(`tab-${next}`).focus();
      },
    }, panels[name]));
  }
  choose(names[0]);
  return choose;
}
