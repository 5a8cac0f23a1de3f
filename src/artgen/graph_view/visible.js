// The visible boxes and arrows: a closed function is one box. Arrows pass through hidden geometry, but not through
// hidden numbers, which would connect almost everything.

const NUMBERS = ["Float", "Bool", "Vector"];

class Visible {
  constructor(nodes) {
    this.nodes = nodes;
    this.into = nodes.map(() => []); // for each node, the nodes that use it
    nodes.forEach((node, index) => node.from.forEach((child) => this.into[child].push(index)));
    this.groups = new Map();
    nodes.forEach((node, index) => {
      if (!this.groups.has(node.group)) this.groups.set(node.group, []);
      this.groups.get(node.group).push(index);
    });
    this.opened = new Set(); // functions whose nodes are visible
    this.left = { all: new Set(NUMBERS), around: new Set() }; // hidden types, in the whole graph and around a node
    this.grouped = true;
    this.scope = "all";
    this.steps = 3;
    this.chosen = null; // the selected node
  }

  get hidden() {
    return this.left[this.scope === "all" ? "all" : "around"];
  }

  /** Returns the nodes that can be reached from some nodes within a number of steps. */
  reach(start, next, steps = Infinity) {
    const seen = new Set(start);
    let border = [...start];
    for (let step = 0; step < steps && border.length; step += 1) {
      border = [...new Set(border.flatMap((index) => next(index)))].filter((index) => !seen.has(index));
      border.forEach((index) => seen.add(index));
    }
    return seen;
  }

  upstream(start, steps) {
    return this.reach(start, (index) => this.nodes[index].from, steps);
  }

  downstream(start, steps) {
    return this.reach(start, (index) => this.into[index], steps);
  }

  /** Returns the nodes within the scope. */
  within() {
    if (this.scope === "all" || this.chosen === null) return new Set(this.nodes.keys());
    const found = new Set([this.chosen]);
    if (this.scope !== "down") this.upstream([this.chosen], this.steps).forEach((index) => found.add(index));
    if (this.scope !== "up") this.downstream([this.chosen], this.steps).forEach((index) => found.add(index));
    return found;
  }

  /** Returns the boxes, the arrows between them, and the box of each node. */
  look() {
    const within = this.within();
    const box = this.nodes.map((node, index) => {
      if (!within.has(index) || (this.hidden.has(node.type) && index !== this.chosen)) return null;
      return this.grouped && !this.opened.has(node.group) ? `g${node.group}` : `n${index}`;
    });
    const boxes = new Map();
    box.forEach((id, index) => {
      if (id === null) return;
      if (!boxes.has(id)) boxes.set(id, { id, nodes: [], group: this.nodes[index].group, closed: id[0] === "g" });
      boxes.get(id).nodes.push(index);
    });
    const arrows = new Map();
    const sources = []; // for each node, the boxes that it depends on
    this.nodes.forEach((node, index) => {
      const before = new Set(within.has(index) ? node.from.flatMap((child) => [...sources[child]]) : []);
      if (box[index] === null) {
        sources.push(NUMBERS.includes(node.type) ? new Set() : before);
        return;
      }
      for (const from of before) {
        if (from !== box[index]) arrows.set(`${from} ${box[index]}`, { from, to: box[index] });
      }
      sources.push(new Set([box[index]]));
    });
    for (const each of boxes.values()) {
      if (each.closed) each.nodes = this.groups.get(each.group).filter((index) => within.has(index));
    }
    return { box, boxes: [...boxes.values()], arrows: [...arrows.values()] };
  }
}
