// The page: it connects the selection, the visible part of the graph, and the buttons.

const FEW = 60; // largest number of nodes, without numbers, that are not grouped by function

class GraphPage {
  constructor(data, blob, dagre) {
    Object.assign(this, { data, blob, nodes: data.nodes });
    this.visible = new Visible(data.nodes);
    this.drawing = new Drawing(document.getElementById("graph"), data.nodes, dagre, {
      choose: (box) => (box.closed ? this.chooseGroup(box.group, false) : this.choose(box.nodes[0])),
      open: (box) => box.closed && this.toggle(box.group),
      close: (name) => this.toggle(name),
    });
    this.details = new Details(document.getElementById("details"), data, this.visible, this);
    this.group = null; // the selected function
    const seen = data.nodes.filter((node) => !NUMBERS.includes(node.type));
    this.visible.grouped = document.getElementById("grouped").checked = seen.length > FEW;
    this.head();
    this.types();
    this.buttons();
    this.search();
    this.details.overview();
  }

  /** Draws the visible boxes; `to` is the box to center. */
  async update({ fit = false, to = null, anyway = false } = {}) {
    const seen = { ...this.visible.look(), framed: this.visible.grouped };
    this.seen = seen;
    this.pressed();
    if (seen.boxes.length > MANY && !anyway) {
      this.say(`${seen.boxes.length} boxes take long to draw: close functions, hide types, or select a node and press Around. `, () => this.update({ fit, to, anyway: true }));
      return;
    }
    const late = setTimeout(() => this.say("Drawing ..."), 250);
    try {
      await this.drawing.draw(seen);
    } catch (error) {
      this.say(`This cannot be drawn (${error.message}); close or open other functions.`);
      return;
    } finally {
      clearTimeout(late);
    }
    this.say("");
    this.mark();
    if (to) this.drawing.center(to);
    else if (fit) this.drawing.fit();
    document.body.dataset.drawn = seen.boxes.length;
  }

  say(text, anyway = null) {
    const message = document.getElementById("message");
    message.replaceChildren(...(text ? [text] : []));
    if (anyway) message.append(element("button", { onclick: anyway }, "Draw anyway"));
  }

  mark() {
    const { chosen } = this.visible;
    const start = chosen !== null ? [chosen] : this.group !== null ? this.visible.groups.get(this.group) : [];
    const related = new Set([...this.visible.upstream(start), ...this.visible.downstream(start)].map((index) => this.seen.box[index]));
    this.drawing.mark(this.box(), related);
  }

  /** Returns the box of the selection. */
  box() {
    if (this.visible.chosen !== null) return this.seen.box[this.visible.chosen];
    return this.group === null ? null : `g${this.group}`;
  }

  choose(index) {
    const before = this.visible.chosen;
    this.visible.chosen = index;
    this.group = null;
    this.details.node(index);
    this.pressed();
    if (this.visible.scope === "all" || before === index) this.mark();
    else this.update({ to: `n${index}` });
  }

  /** Selects a node and opens its function. */
  goto(index) {
    const node = this.nodes[index];
    this.choose(index);
    if (this.visible.grouped) this.visible.opened.add(node.group);
    this.visible.hidden.delete(node.type);
    this.types();
    this.update({ to: `n${index}` });
  }

  chooseGroup(name, centered = true) {
    this.visible.chosen = null;
    this.group = name;
    this.details.group(name);
    if (this.visible.scope === "all") this.mark();
    else this.setScope("all");
    this.pressed();
    if (centered) this.drawing.center(`g${name}`);
  }

  toggle(name) {
    const { opened } = this.visible;
    const closing = opened.delete(name);
    if (!closing) opened.add(name);
    if (closing && this.nodes[this.visible.chosen]?.group === name) this.visible.chosen = null;
    this.group = closing ? name : null;
    if (this.visible.chosen === null) this.details.group(name);
    this.update({ to: closing ? `g${name}` : `f${name}` });
  }

  setScope(scope) {
    this.visible.scope = scope;
    this.types();
    this.visible.grouped = document.getElementById("grouped").checked = this.visible.within().size > 160;
    this.update({ fit: true });
  }

  head() {
    const { name, seed, change } = this.data;
    document.getElementById("title").textContent = `${name}, seed ${seed}`;
    const count = (state) => this.nodes.filter((node) => node.state === state).length;
    const total = this.nodes.reduce((sum, node) => sum + node.ms, 0);
    const changed = Object.entries(change).map(([each, value]) => `${each} = ${value}`).join(", ");
    const facts = [`${this.nodes.length} nodes`, `${count("computed")} computed in ${spent(total)}`];
    if (count("cached")) facts.push(`${count("cached")} from the cache`);
    if (count("unused")) facts.push(`${count("unused")} not needed`);
    document.getElementById("facts").textContent = (changed ? `after ${changed}: ` : "") + facts.join(", ");
  }

  types() {
    const counts = Map.groupBy(this.nodes, (node) => node.type);
    const made = [...counts].sort((a, b) => b[1].length - a[1].length).map(([type, nodes]) => {
      const dot = element("i", { className: "dot" });
      dot.style.background = COLORS[type] ?? colorOf(nodes[0]);
      const hidden = this.visible.hidden.has(type);
      const button = element("button", { className: hidden ? "off" : "", title: `Show or hide nodes of type ${type}` }, dot, `${type} ${nodes.length}`);
      button.dataset.type = type;
      button.setAttribute("aria-pressed", String(!hidden));
      button.addEventListener("click", () => {
        if (!this.visible.hidden.delete(type)) this.visible.hidden.add(type);
        this.types();
        this.update({ fit: true });
      });
      return button;
    });
    document.getElementById("types").replaceChildren(...made);
  }

  buttons() {
    const at = (id) => document.getElementById(id);
    for (const button of at("scope").children) button.addEventListener("click", () => this.setScope(button.dataset.scope));
    at("steps").addEventListener("change", () => {
      this.visible.steps = Number(at("steps").value);
      this.setScope(this.visible.scope);
    });
    at("grouped").addEventListener("change", () => {
      this.visible.grouped = at("grouped").checked;
      this.update({ fit: true });
    });
    at("openall").addEventListener("click", () => {
      this.visible.opened = new Set(this.visible.groups.keys());
      this.update({ fit: true });
    });
    at("closeall").addEventListener("click", () => {
      this.visible.opened.clear();
      this.update({ fit: true });
    });
    at("fit").addEventListener("click", () => this.drawing.fit());
    at("graph").addEventListener("click", (event) => {
      if (event.target === at("graph") && !this.drawing.dragged) this.clear();
    });
  }

  /** Clears the selection. */
  clear() {
    this.visible.chosen = this.group = null;
    this.details.overview();
    if (this.visible.scope === "all") this.mark();
    else this.setScope("all");
    this.pressed();
  }

  /** Updates which buttons are active and enabled. */
  pressed() {
    const { scope, chosen, grouped } = this.visible;
    for (const button of document.getElementById("scope").children) {
      button.classList.toggle("active", button.dataset.scope === scope);
      button.disabled = button.dataset.scope !== "all" && chosen === null;
    }
    document.getElementById("steps").disabled = scope === "all";
    for (const id of ["openall", "closeall"]) document.getElementById(id).disabled = !grouped;
  }

  search() {
    const [field, list] = ["search", "found"].map((id) => document.getElementById(id));
    const texts = this.nodes.map((node) => `${node.name} ${node.op} ${node.type} ${node.group} ${node.where} ${node.value}`.toLowerCase());
    const look = () => {
      const words = field.value.toLowerCase().split(/\s+/).filter(Boolean);
      const found = words.length ? [...texts.keys()].filter((index) => words.every((word) => texts[index].includes(word))) : [];
      const rows = found.slice(0, 40).map((index) => {
        const row = element("li", {}, this.details.link(index), element("small", {}, `  ${this.nodes[index].where}`));
        row.addEventListener("click", () => {
          list.hidden = true;
          this.goto(index);
        });
        return row;
      });
      const more = found.length > 40 ? [element("li", { className: "muted" }, `and ${found.length - 40} more`)] : [];
      const none = words.length && !found.length ? [element("li", { className: "muted" }, "no such node")] : [];
      list.replaceChildren(...rows, ...more, ...none);
      list.hidden = !words.length;
    };
    field.addEventListener("input", look);
    field.addEventListener("focus", look);
    field.addEventListener("keydown", (event) => {
      if (event.key === "Enter") list.querySelector("li:not(.muted)")?.click();
      if (event.key === "Escape") list.hidden = true;
    });
    document.addEventListener("pointerdown", (event) => {
      if (!list.contains(event.target) && event.target !== field) list.hidden = true;
    });
  }
}

async function start() {
  document.head.append(element("script", { textContent: await unpackedText("three") }));
  const page = new GraphPage(JSON.parse(await unpackedText("data")), await unpacked("meshes"), await unpackedText("dagre"));
  window.page = page;
  await page.update({ fit: true });
}

start().catch((error) => {
  const message = document.getElementById("message");
  message.textContent = `The graph cannot be shown: ${error.message}`;
  message.className = "fault";
  console.error(error);
});
