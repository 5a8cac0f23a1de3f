// The drawing: boxes and arrows that can be dragged and zoomed; dagre computes the layout in a worker.

const NS = "http://www.w3.org/2000/svg";
const MANY = 2500; // number of boxes whose layout takes many seconds
const COLORS = {
  parameter: "#f2b544", Body: "#3f6fb5", Joint: "#c8483a", Solid: "#3c9a86", Profile: "#8d64b3", Path: "#a8763e",
  Points: "#a8763e", Vector: "#7f93a8", Frame: "#b6588b", Float: "#9aa0a6", Bool: "#9aa0a6",
};
const colorOf = (node) => COLORS[node.op === "parameter" ? "parameter" : node.type] ?? "#c8483a";
const pale = (color) => `color-mix(in srgb, ${color} 16%, white)`;

function svg(tag, attributes = {}, ...children) {
  const made = document.createElementNS(NS, tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  made.append(...children);
  return made;
}

const cut = (text, longest) => (text.length <= longest ? text : `${text.slice(0, longest - 1)}…`);
const spent = (ms) => (ms >= 100 ? `${Math.round(ms)} ms` : ms >= 0.1 ? `${ms.toFixed(1)} ms` : `${(1000 * ms).toFixed(0)} µs`);

/** Computes layouts; some frames make the best algorithm fail, then the next one is tried. */
function worker() {
  onmessage = ({ data: { boxes, arrows, space } }) => {
    const rankers = boxes.length > 300 ? ["longest-path"] : ["network-simplex", "longest-path"];
    for (const [framed, ranker] of [true, false].flatMap((frames) => rankers.map((ranker) => [frames, ranker]))) {
      const laid = structuredClone({ boxes: framed ? boxes : boxes.filter((box) => !box.frame), arrows });
      if (!framed) for (const box of laid.boxes) delete box.parent;
      try {
        dagre.layout(laid.boxes, laid.arrows, { ...space, ranker }, {});
      } catch (error) {
        continue;
      }
      postMessage(laid);
      return;
    }
    throw new Error("dagre found no layout");
  };
}

/** Returns a smooth line along some points. */
function curve(points) {
  const at = ({ x, y }) => `${x.toFixed(1)} ${y.toFixed(1)}`;
  const middle = (a, b) => ({ x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 });
  const bends = points.slice(1, -1).map((point, index) => {
    const last = index === points.length - 3;
    return `Q${at(point)} ${at(last ? points.at(-1) : middle(point, points[index + 2]))}`;
  });
  return `M${at(points[0])}${bends.join("")}${bends.length ? "" : `L${at(points.at(-1))}`}`;
}

class Drawing {
  constructor(root, nodes, dagre, pick) {
    Object.assign(this, { root, nodes, pick });
    this.source = URL.createObjectURL(new Blob([dagre, `(${worker})()`], { type: "text/javascript" }));
    this.ink = document.createElement("canvas").getContext("2d");
    this.slowest = Math.max(...nodes.map((node) => node.ms));
    this.view = { x: 0, y: 0, scale: 1 };
    this.drag();
  }

  /** Computes the layout of the boxes and draws them. */
  async draw(seen) {
    this.worker?.terminate();
    this.worker = new Worker(this.source);
    const boxes = seen.boxes.map((box) => ({ ...this.labelled(box), v: box.id, parent: this.parent(box, seen) }));
    const frames = new Set(boxes.map((box) => box.parent).filter(Boolean));
    for (const name of frames) boxes.push({ v: name, frame: name.slice(1), width: 10, height: 10 });
    const arrows = seen.arrows.map(({ from, to }) => ({ v: from, w: to }));
    const space = { rankdir: "LR", nodesep: 12, ranksep: 44, edgesep: 8 };
    const laid = await new Promise((done, failed) => {
      this.worker.onmessage = ({ data }) => done(data);
      this.worker.onerror = (event) => failed(new Error(event.message));
      this.worker.postMessage({ boxes, arrows, space });
    });
    this.show(laid);
  }

  /** Returns the frame of the box of a node, if several nodes of its function are visible. */
  parent(box, seen) {
    if (box.closed || !seen.framed) return undefined;
    this.siblings = this.siblingsOf === seen ? this.siblings : Map.groupBy(seen.boxes, (each) => each.group);
    this.siblingsOf = seen;
    return this.siblings.get(box.group).length > 1 ? `f${box.group}` : undefined;
  }

  labelled(box) {
    const inside = box.nodes.map((index) => this.nodes[index]);
    const ms = inside.reduce((sum, node) => sum + node.ms, 0);
    let texts = [cut(box.group, 34), `${inside.length} node${inside.length === 1 ? "" : "s"}, ${spent(ms)}`];
    if (!box.closed) {
      const [node] = inside;
      texts = [cut([node.op, node.name].filter(Boolean).join(" "), 34), cut(node.value, 27)].filter(Boolean);
      if (node.op === "parameter") texts[0] = cut(node.name, 34);
    }
    this.ink.font = "600 12px system-ui, sans-serif";
    const width = Math.max(...texts.map((text) => this.ink.measureText(text).width)) + 22;
    return { box, texts, ms, width: Math.max(width, 60), height: texts.length > 1 ? 36 : 22 };
  }

  show({ boxes, arrows }) {
    this.width = Math.max(...boxes.map((box) => box.x + box.width / 2));
    this.height = Math.max(...boxes.map((box) => box.y + box.height / 2));
    this.boxes = new Map(boxes.map((box) => [box.v, box]));
    this.paper = svg("g");
    this.paper.append(...boxes.filter((box) => box.frame).map((box) => this.frame(box)));
    this.edges = arrows.map((arrow) => {
      const [from, to] = [this.boxes.get(arrow.v), this.boxes.get(arrow.w)];
      if (from.x < to.x) { // other arrows belong to circles of functions that use each other
        arrow.points.splice(0, 1, { x: from.x + from.width / 2, y: from.y });
        arrow.points.splice(-1, 1, { x: to.x - to.width / 2, y: to.y });
      }
      const path = svg("path", { class: "edge", d: curve(arrow.points) });
      Object.assign(path, { from: arrow.v, to: arrow.w });
      return path;
    });
    this.paper.append(...this.edges, ...boxes.filter((box) => !box.frame).map((box) => this.box(box)));
    const arrowhead = (id, color) => svg(
      "marker",
      { id, viewBox: "0 0 8 8", refX: 7, refY: 4, markerWidth: 6, markerHeight: 6, orient: "auto", markerUnits: "userSpaceOnUse" },
      svg("path", { d: "M0 0L8 4L0 8z", fill: color }),
    );
    this.root.replaceChildren(svg("defs", {}, arrowhead("arrow", "#b4bac1"), arrowhead("near", "#0b66c3")), this.paper);
    this.place();
  }

  frame(box) {
    const [x, y] = [box.x - box.width / 2, box.y - box.height / 2];
    const made = svg("g", { class: "frame" });
    made.append(svg("rect", { x, y: y - 4, width: box.width, height: box.height + 8, rx: 8 }));
    made.append(svg("text", { x: x + 8, y: y + 9 }, `− ${box.frame}`), svg("title", {}, "Close this function"));
    made.addEventListener("click", () => this.dragged || this.pick.close(box.frame));
    return made;
  }

  box({ v, x, y, width, height, texts, box, ms }) {
    const node = box.closed ? null : this.nodes[box.nodes[0]];
    const made = svg("g", { class: `box ${box.closed ? "group" : node.state}`, "data-id": v, transform: `translate(${x - width / 2} ${y - height / 2})` });
    const color = node ? colorOf(node) : "#9aa0a6";
    made.append(svg("rect", { width, height, rx: box.closed ? 4 : 8, style: node ? `fill:${pale(color)};stroke:${color}` : "" }));
    const warm = Math.min(1, Math.sqrt(ms / this.slowest)) * (width - 12);
    if (warm > 2) made.append(svg("rect", { x: 6, y: height - 4, width: warm, height: 2.4, rx: 1, style: "fill:#e08a4b;stroke:none" }));
    texts.forEach((text, index) => made.append(svg("text", { x: 10, y: 15 + 14 * index, class: index ? "small" : "" }, text)));
    made.append(svg("title", {}, box.closed ? `${box.group}: double-click to open` : `${node.where}  ${node.source}`));
    made.addEventListener("click", () => this.dragged || this.pick.choose(box));
    made.addEventListener("dblclick", () => this.pick.open(box));
    return made;
  }

  /** Marks the selected box and its arrows, and fades unrelated boxes. */
  mark(chosen, related) {
    this.root.classList.toggle("chosen-one", chosen !== null);
    for (const made of this.root.querySelectorAll(".box")) {
      made.classList.toggle("chosen", made.dataset.id === chosen);
      made.classList.toggle("apart", !related.has(made.dataset.id));
    }
    for (const edge of this.edges ?? []) {
      edge.classList.toggle("near", chosen !== null && (edge.from === chosen || edge.to === chosen));
      edge.classList.toggle("apart", !(related.has(edge.from) && related.has(edge.to)));
    }
  }

  fit() {
    const { clientWidth, clientHeight } = this.root;
    const scale = Math.min(clientWidth / (this.width + 60), clientHeight / (this.height + 60), 1.25);
    this.view = { scale, x: (clientWidth - scale * this.width) / 2, y: (clientHeight - scale * this.height) / 2 };
    this.place();
  }

  /** Centers a box at a readable size. */
  center(id) {
    const box = this.boxes.get(id);
    if (!box) return;
    const scale = Math.max(this.view.scale, 0.8);
    this.view = { scale, x: this.root.clientWidth / 2 - scale * box.x, y: this.root.clientHeight / 2 - scale * box.y };
    this.place();
  }

  place() {
    const { x, y, scale } = this.view;
    this.paper?.setAttribute("transform", `translate(${x} ${y}) scale(${scale})`);
  }

  drag() {
    let before = null;
    this.root.addEventListener("pointerdown", (event) => {
      before = [event.clientX, event.clientY];
      this.dragged = false;
    });
    window.addEventListener("pointerup", () => (before = null));
    window.addEventListener("pointermove", (event) => {
      if (!before) return;
      const [x, y] = [event.clientX - before[0], event.clientY - before[1]];
      if (!this.dragged && Math.hypot(x, y) < 4) return;
      this.dragged = true;
      before = [event.clientX, event.clientY];
      this.view.x += x;
      this.view.y += y;
      this.place();
    });
    this.root.addEventListener("wheel", (event) => {
      event.preventDefault();
      const factor = Math.exp(-event.deltaY * (event.deltaMode ? 0.04 : 0.0015));
      const scale = Math.min(Math.max(this.view.scale * factor, 0.02), 4);
      const [x, y] = [event.offsetX, event.offsetY];
      const share = scale / this.view.scale;
      this.view = { scale, x: x - share * (x - this.view.x), y: y - share * (y - this.view.y) };
      this.place();
    }, { passive: false });
  }
}
