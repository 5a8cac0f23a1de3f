// The panel beside the asset: sliders, checkboxes and tables. It passes requests to the viewer, and shows its state.

const SYMBOLS = {
  colliders: "Colliders",
  joints: "Joint axes and limits",
  grasps: "Grasps and pushes",
  masses: "Centers of mass",
  labels: "Colors of labels",
};
const UNLIMITED = { revolute: Math.PI, prismatic: 0.2 }; // range of sliders of joints without limits [rad or m]

function section(title, count, opened, ...children) {
  const head = element("summary", {}, `${title} `);
  if (count !== null) head.append(element("span", { className: "count" }, `${count}`));
  return element("section", {}, element("details", { open: opened }, head, ...children));
}

function table(rows) {
  return element("table", {}, ...rows.map((row) => element("tr", {}, ...row.map((cell) => element("td", {}, cell)))));
}

function kilograms(mass) {
  return mass < 1 ? `${(1000 * mass).toPrecision(3)} g` : `${mass.toPrecision(4)} kg`;
}

/** Returns a position of a joint in degrees or millimeters. */
function format(kind, position) {
  const shown = kind === "revolute" ? THREE.MathUtils.radToDeg(position) : 1000 * position;
  return `${(Math.abs(shown) < 0.05 ? 0 : shown).toFixed(1)}${kind === "revolute" ? "°" : " mm"}`;
}

function number(value) {
  return typeof value === "number" && !Number.isInteger(value) ? `${Number(value.toPrecision(5))}` : `${value}`;
}

class Panel {
  constructor(viewer, root) {
    this.viewer = viewer;
    this.rows = new Map(); // slider, position and reason text of each joint
    this.pairs = [];
    this.values = new Map(); // cell with the value of each output
    const { data } = viewer;
    root.append(
      element("h1", {}, data.name),
      element("p", { className: "facts" }, this.facts()),
      section("Joints", data.joints.length, true, ...data.joints.map((joint) => this.joint(joint))),
      ...(data.outputs.length ? [section("Outputs", data.outputs.length, true, this.outputs())] : []),
      section("Show", null, true, this.switches()),
      section("Certificate", data.certificate?.pairs.length ?? null, true, ...this.certificate()),
      section("Masses", kilograms(data.mass), false, table(data.links.map((link) => [link.name, kilograms(link.mass)]))),
      section("Parameters", Object.keys(data.parameters).length, false, this.parameters()),
    );
  }

  facts() {
    const { category, seed, mass, bounds } = this.viewer.data;
    const size = bounds[1].map((high, axis) => (100 * (high - bounds[0][axis])).toFixed(0)).join(" × ");
    return [category, seed === null ? "" : `seed ${seed}`, `${size} cm`, kilograms(mass)].filter(Boolean).join(" · ");
  }

  parameters() {
    const rows = Object.entries(this.viewer.data.parameters).map(([name, value]) => [name, number(value)]);
    return Object.assign(table(rows), { id: "parameters" });
  }

  joint(joint) {
    const output = element("output");
    const blocked = element("small", { className: "blocked" });
    const title = `${joint.kind}, ${joint.parent} to ${joint.child}`;
    const head = element("header", {}, element("span", { className: "name", title }, joint.name), output);
    const row = element("div", { className: "joint" }, head);
    row.dataset.row = joint.name;
    this.rows.set(joint.name, { output, blocked, slider: null });
    if (joint.locked) row.append(element("small", {}, "locked"));
    if (joint.follows) row.append(element("small", {}, followed(joint.follows)));
    if (!joint.locked && !joint.follows) {
      const [low, high] = joint.limits ?? [-UNLIMITED[joint.kind], UNLIMITED[joint.kind]];
      const slider = element("input", { type: "range", min: low, max: high, step: "any", value: joint.closed });
      slider.dataset.joint = joint.name;
      slider.setAttribute("aria-label", joint.name);
      slider.addEventListener("input", () => this.viewer.move(joint.name, slider.valueAsNumber));
      this.rows.get(joint.name).slider = slider;
      if (joint.stops) {
        const action = `Open and close ${joint.name}, after the joints that it needs`;
        const play = element("button", { className: "play", title: action }, "▶");
        play.addEventListener("click", () => this.viewer.play(joint.stops));
        head.append(play);
      }
      row.append(slider);
    }
    row.append(blocked);
    if (joint.needs) row.append(element("small", {}, `needs ${this.viewer.format(joint)}`));
    if (joint.driven) row.append(element("small", {}, `moved by ${joint.driven}`));
    return row;
  }

  outputs() {
    const rows = this.viewer.data.outputs.map(({ name, kind, text }) => {
      const value = element("span");
      value.dataset.output = name;
      this.values.set(name, value);
      return [element("span", { title: text }, name, " ", element("span", { className: "muted" }, kind)), value];
    });
    return table(rows);
  }

  switches() {
    const checks = Object.entries(SYMBOLS).map(([kind, title]) => {
      const box = element("input", { type: "checkbox" });
      box.dataset.symbol = kind;
      box.addEventListener("change", () => this.viewer.show(kind, box.checked));
      return element("label", {}, box, title);
    });
    const apart = element("input", { type: "range", min: 0, max: 1, step: "any", value: 0, id: "apart" });
    apart.addEventListener("input", () => this.viewer.explode(apart.valueAsNumber));
    return element("div", { className: "checks" }, ...checks, element("label", { className: "apart" }, "Apart", apart));
  }

  certificate() {
    const { certificate } = this.viewer.data;
    if (!certificate) return [element("p", {}, element("span", { className: "badge" }, "not certified"))];
    const { proven, tolerance, text, pairs, contacts } = certificate;
    const badge = element("span", { className: `badge ${proven ? "good" : "bad"}` }, proven ? "proven" : "not proven");
    const summary = element("p", { id: "verdict" }, badge, ` ${text.replace(/^(not )?proven[^:]*: /, "")}`);
    if (tolerance) summary.append(`, ${(1000 * tolerance).toFixed(1)} mm clearance`);
    const found = [summary];
    if (pairs.length) {
      const title = proven ? "Show the narrowest pose" : "Show the worst pose";
      const worst = element("button", { id: "worst" }, title);
      worst.addEventListener("click", () => this.choose(0));
      found.push(element("p", {}, worst), this.verdicts(pairs));
    }
    if (contacts.length) {
      const texts = contacts.map((contact) => element("p", { className: "muted" }, contact));
      found.push(element("details", {}, element("summary", {}, `Contacts by design ${contacts.length}`), ...texts));
    }
    return found;
  }

  verdicts(pairs) {
    const shown = table(pairs.map((pair) => [pair.links.join(" – "), clearance(pair)]));
    this.pairs = [...shown.rows];
    for (const [place, row] of this.pairs.entries()) {
      row.className = pairs[place].clear ? "pick" : "pick fault";
      row.title = pairs[place].text;
      row.addEventListener("click", () => this.choose(place));
    }
    return shown;
  }

  /** Shows the nearest or a colliding pose of a pair of links of the certificate. */
  choose(place) {
    this.viewer.inspect(this.viewer.data.certificate.pairs[place]);
    for (const [other, row] of this.pairs.entries()) row.classList.toggle("chosen", other === place);
  }

  /** Shows the values of the outputs. */
  work(values) {
    for (const [name, cell] of this.values) {
      const percent = Math.round(100 * values[name]);
      cell.textContent = { 0: "off", 100: "on" }[percent] ?? `${percent} %`;
    }
  }

  /** Shows the positions of the joints, and the reason why one stopped. */
  update(positions, blocked) {
    for (const row of this.pairs) row.classList.remove("chosen");
    for (const [name, { slider, output, blocked: text }] of this.rows) {
      const joint = this.viewer.kinematics.joints.get(name);
      output.textContent = format(joint.kind, positions[name]);
      if (slider && slider.valueAsNumber !== positions[name]) slider.value = positions[name];
      text.textContent = blocked?.name === name ? blocked.reason : "";
    }
  }
}

/** Returns the coupling of a joint as text. */
function followed({ leader, ratio, offset, curve }) {
  if (curve) return `moves in a closed chain with ${leader}`;
  const added = offset ? ` ${offset < 0 ? "−" : "+"} ${number(Math.abs(offset))}` : "";
  return `follows ${number(ratio)} × ${leader}${added}`;
}

/** Returns the clearance of two links, or their penetration, in their worst pose as text. */
function clearance({ clear, guaranteed, depth }) {
  if (depth !== null) return `${(1000 * depth).toFixed(2)} mm deep`;
  if (!clear) return "not proven";
  if (guaranteed === null) return "touch by design";
  return guaranteed < 0.00001 ? "< 0.01 mm" : `${(1000 * guaranteed).toFixed(2)} mm`;
}
