// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// Asks the program and takes its answer apart (host/view/message.h).

/// The program refused, with a sentence for the reader.
export class Refused extends Error {}

/// {head, words}: the answer's JSON, and the numbers of 32 bits behind it.
export async function ask(type, fields = {}) {
  let response;
  try {
    response = await fetch("/ask", {
      method: "POST",
      headers: {"Content-Type": "application/json"},
      body: JSON.stringify({type, ...fields}),
    });
  } catch {
    throw new Refused("the program does not answer; it may have been stopped");
  }
  if (!response.ok) throw new Refused((await response.json()).error);
  return parts_of(await response.arrayBuffer());
}

export function parts_of(bytes) {
  const length = new DataView(bytes).getUint32(0, true);
  const text = new TextDecoder().decode(new Uint8Array(bytes, 4, length));
  return {head: JSON.parse(text), words: new Uint32Array(bytes, 4 + length)};
}
