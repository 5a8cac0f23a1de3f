// The panel: details of the selected node or function, or the times of all functions.

const LISTED = 14; // rows of a list
const STATES = { computed: "computed", cached: "from the cache", unused: "not needed: in the other branch of a switch", given: "drawn" };

class Details {
  constructor(panel, data, visible, page) {
    Object.assign(this, { panel, data, visible, page, nodes: data.nodes });
    this.canvas = element("canvas");
    this.canvas.setAttribute("aria-label", "geometry");
    this.ghosted = element("input", { type: "checkbox", id: "ghosted" });
    this.ghosted.addEventListener("change", () => this.geometry?.show(this.items, this.ghosted.checked));
    this.view = element("div", {}, this.canvas, element("label", { className: "muted" }, this.ghosted, " in the whole asset"));
  }

  link(index) {
    const node = this.nodes[index];
    const name = node.op === "parameter" ? node.name : [node.op, node.name].filter(Boolean).join(" ");
    const dot = element("i", { className: "dot", title: node.type });
    dot.style.background = colorOf(node);
    const made = element("a", { href: `#n${index}`, onclick: (event) => (event.preventDefault(), this.page.goto(index)) }, name);
    return element("span", {}, dot, " ", made, " ", element("small", { className: "muted" }, cut(node.value, 36)));
  }

  /** Shows a node. */
  node(index) {
    const node = this.nodes[index];
    const rows = [
      ["type", node.type],
      ["value", node.value || "-"],
      ["state", node.state === "computed" ? `computed in ${spent(node.ms)}` : STATES[node.state]],
      ["made in", element("a", { onclick: () => this.page.chooseGroup(node.group) }, node.group)],
      ["at", node.where],
    ];
    const inputs = node.inputs.map(([name, parts]) => [name, element("span", {}, ...parts.map((part) => (typeof part === "number" ? this.link(part) : part)))]);
    const into = this.visible.into[index];
    this.fill(
      element("h2", {}, node.op === "parameter" ? node.name : [node.op, node.name].filter(Boolean).join(" ")),
      this.picture(node.shape),
      this.table(rows),
      element("pre", {}, node.source || "(the source is not available)"),
      ...this.listed("Inputs", this.table(inputs), inputs.length),
      ...this.listed("Used by", this.links(into), into.length),
    );
  }

  /** Shows a function. */
  group(name) {
    const inside = this.visible.groups.get(name);
    const ms = inside.reduce((sum, index) => sum + this.nodes[index].ms, 0);
    const leaving = inside.filter((index) => this.visible.into[index].some((user) => this.nodes[user].group !== name) || !this.visible.into[index].length);
    const states = Object.entries(STATES).map(([state]) => [state, inside.filter((index) => this.nodes[index].state === state).length]);
    this.fill(
      element("h2", {}, name),
      this.picture([...new Set(leaving.flatMap((index) => this.nodes[index].shape))]),
      element("p", { className: "muted" }, `${inside.length} nodes, ${spent(ms)}: ${states.filter(([, count]) => count).map(([state, count]) => `${count} ${state}`).join(", ")}`),
      element("p", {}, element("button", { onclick: () => this.page.toggle(name) }, this.visible.opened.has(name) ? "Close" : "Open")),
      ...this.listed("Its results", this.links(leaving), leaving.length),
      ...this.listed("Its slowest nodes", this.slowest(inside), inside.length),
    );
  }

  /** Shows the times of functions and nodes. */
  overview() {
    const groups = [...this.visible.groups].map(([name, inside]) => [name, inside.reduce((sum, index) => sum + this.nodes[index].ms, 0)]);
    groups.sort((a, b) => b[1] - a[1]);
    const most = groups[0][1];
    this.fill(
      element("h2", {}, "Computing time"),
      element("p", { className: "muted" }, "Click a box to see its value and its geometry, double-click a function to open it. Arrows lead from an input to the nodes that use it."),
      this.picture(this.nodes.at(-1).shape),
      element("h3", {}, "Functions"),
      this.table(groups.slice(0, LISTED).map(([name, ms]) => [element("a", { onclick: () => this.page.chooseGroup(name) }, name), this.time(ms, most)]), true),
      ...this.listed("Nodes", this.slowest([...this.nodes.keys()]), 1),
    );
  }

  slowest(indices) {
    const sorted = [...indices].sort((a, b) => this.nodes[b].ms - this.nodes[a].ms).slice(0, LISTED);
    const most = this.nodes[sorted[0]].ms;
    return this.table(sorted.map((index) => [this.link(index), this.time(this.nodes[index].ms, most)]), true);
  }

  time(ms, most) {
    const bar = element("i", { className: "bar" });
    bar.style.width = `${most ? (40 * ms) / most : 0}px`;
    return element("span", {}, bar, spent(ms));
  }

  links(indices) {
    return this.table(indices.slice(0, 60).map((index) => [this.link(index)]), true);
  }

  listed(title, content, count) {
    return count ? [element("h3", {}, title), content] : [];
  }

  table(rows, numbers = false) {
    const cell = (content, index) => element("td", { className: numbers && index ? "number" : "" }, content);
    return element("table", { className: numbers ? "" : "keys" }, ...rows.map((row) => element("tr", {}, ...row.map(cell))));
  }

  /** Returns the view of some items; nothing without items, as for numbers. */
  picture(items) {
    this.items = items;
    return items.length ? this.view : "";
  }

  fill(...content) {
    this.panel.replaceChildren(...content);
    this.panel.scrollTop = 0;
    if (!this.items.length) return;
    this.geometry ??= new Geometry(this.canvas, this.data, this.page.blob, this.nodes.at(-1).shape);
    this.geometry.show(this.items, this.ghosted.checked);
  }
}
