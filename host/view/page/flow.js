// Copyright the dynrt authors.
// SPDX-License-Identifier: Apache-2.0
//
// The waits of the units and the fill of the FIFOs between them, in words and sums.

const listed = (units) => units.length ? units.join(", ") : "the outside";

/// "a token in jobs, from list, shading" or "space in jobs, to mailbox".
export function wait_text({fifos}, wait) {
  const fifo = fifos[wait.fifo];
  return wait.for === "space" ? `space in ${fifo.channel}, to ${listed(fifo.to)}`
                             : `a token in ${fifo.channel}, from ${listed(fifo.from)}`;
}

/// "list → mailbox": the writer, or the fork or arbiter in its place, and the readers.
export function fifo_text({of, from, to}) {
  const before = {writer: listed(from), reader: "fork", channel: "arbiter"}[of];
  return `${before} → ${listed(to)}`;
}

/// FIFOs of the core, not those that the outside fills.
export const fifos_within = ({fifos}) => fifos.filter(({depth}) => depth > 0);

/// Adds to each unit its shares of the frame's clocks: `use`, and `stalled` for want of space in a FIFO; to
/// each of its waits their sum, `total`, the longest first.
export function add_shares({units, cycles}) {
  for (const unit of units) {
    unit.use = cycles && unit.transactions !== null ? unit.transactions / cycles : null;
    for (const wait of unit.waits) wait.total = d3.sum(wait.clocks);
    unit.waits.sort((a, b) => b.total - a.total);
    const stalls = d3.sum(unit.waits.filter((wait) => wait.for === "space"), ({total}) => total);
    unit.stalled = cycles ? stalls / cycles : null;
  }
}

/// A unit in a part of the frame: {work, space, token}, shares of the part's clocks, and its waits
/// there, the longest first.
export function part_of(machine, unit, part) {
  const clocks = Math.min(machine.part_clocks, machine.cycles - part * machine.part_clocks);
  const waits = unit.waits.filter((wait) => wait.clocks[part] > 0)
      .sort((a, b) => b.clocks[part] - a.clocks[part]);
  const share = (count) => Math.min(1, count / clocks);
  const sum = (kind) => share(d3.sum(waits, (wait) => wait.for === kind ? wait.clocks[part] : 0));
  return {work: share(unit.work[part]), space: sum("space"), token: sum("token"),
          waits: waits.map((wait) => ({wait, share: share(wait.clocks[part])}))};
}
