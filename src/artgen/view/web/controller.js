// Outputs of an asset over time: the same values as asset.controller() in Python, of one product.

const [SWITCHES_ON, SWITCHES_OFF] = [2 / 3, 1 / 3]; // levels at which a pressed control switches on and off

/** Value of each kind of signal, from its terms, which of them rise, its value before, and the time of the step. */
const RULES = {
  level: (signal, { positions }) => level(signal, positions),
  pressed: (signal, { positions, before }) =>
    Number(level(signal, positions) > (before > 0.5 ? SWITCHES_OFF : SWITCHES_ON)),
  where: (signal, { positions }) => Number(holds(signal.condition, positions)),
  toggle: (signal, { rises, before }) => (rises[0] ? 1 - before : before),
  timer: (signal, { rises, before, seconds }) => (rises[0] ? signal.seconds : Math.max(before - seconds, 0)), // left
  latest: (signal, { rises, before }) => signal.values.reduce((value, own, term) => (rises[term] ? own : value), before),
  all: (signal, { terms }) => Math.min(...terms),
  any: (signal, { terms }) => Math.max(...terms),
  not: (signal, { terms }) => 1 - terms[0],
  scaled: (signal, { terms }) => signal.factor * terms[0],
};

/** Returns the share of the way of a joint from one end to the other. */
function level({ joint, ends: [start, end] }, positions) {
  return Math.min(Math.max((positions[joint] - start) / (end - start), 0), 1);
}

class Controller {
  /** Stores the outputs of an asset, as at delivery. */
  constructor(outputs) {
    this.outputs = outputs;
    this.memory = new Map(); // value and terms of each signal in the last step; empty before the first one
  }

  /** Returns the values of all outputs by name, from 0 to 1, after a step of time [s]. */
  step(positions, seconds) {
    const now = new Map();
    const valueOf = (signal) => {
      const terms = (signal.terms ?? []).map(valueOf);
      const off = signal.unless ? valueOf(signal.unless) > 0.5 : false;
      const last = this.memory.get(signal) ?? { value: 0, terms: null };
      const rises = terms.map((term, place) => term > 0.5 && last.terms !== null && last.terms[place] < 0.5);
      const found = RULES[signal.kind](signal, { positions, terms, rises, before: last.value, seconds });
      const value = off ? 0 : found;
      now.set(signal, { value, terms });
      return signal.kind === "timer" ? Number(value > 0) : value;
    };
    const values = Object.fromEntries(this.outputs.map(({ name, signal }) => [name, valueOf(signal)]));
    this.memory = now;
    return values;
  }
}
