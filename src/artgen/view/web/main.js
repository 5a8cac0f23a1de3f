// The viewer: it connects its parts, and holds the positions of the joints and the display options.

const LEAD = 0.75; // duration of the animation of one joint [s]
const TICK = 200; // time between two looks at outputs while nothing moves [ms]

class Viewer {
  constructor(data, nodes, stage) {
    this.data = data;
    this.kinematics = new Kinematics(data);
    this.controller = new Controller(data.outputs);
    this.clock = performance.now(); // time of the last step of the controller [ms]
    this.q = {}; // positions of the free joints that were moved [rad or m]
    this.apart = 0;
    this.colored = false;
    this.translucent = false; // whether the asset is translucent, for symbols inside
    this.alone = false; // whether all but the highlighted links are translucent
    this.highlighted = [];
    this.playing = 0; // number of the last animation that was started
    this.stage = stage;
    const [low, high] = data.bounds.map(([x, y, z]) => new THREE.Vector3(x, z, -y));
    const canvas = stage.querySelector("canvas");
    this.studio = new Studio(canvas, low.distanceTo(high), low.clone().add(high).divideScalar(2));
    this.model = new Model(nodes, data);
    this.studio.scene.add(this.model.root);
    this.symbols = new Symbols(data, this.model, this.studio.withoutShadow);
    this.panel = new Panel(this, document.getElementById("panel"));
    this.fit();
    const corners = cornersOf(data.space);
    this.orbit = new Orbit(this.studio, canvas, { ...data.view, corners });
    new ResizeObserver(() => this.fit()).observe(stage);
    canvas.addEventListener("click", (event) => this.pick(event));
    const pressed = { closed: () => this.place({}), open: () => this.place(data.open), home: () => this.orbit.reset() };
    for (const [name, action] of Object.entries(pressed)) document.getElementById(name).addEventListener("click", action);
    document.getElementById("toggle").addEventListener("click", () => document.body.classList.toggle("narrow"));
    this.update();
    if (data.outputs.length) setInterval(() => this.work(), TICK);
  }

  /** Moves a joint as far as the others allow; the panel shows the reason if it stops. */
  move(name, target) {
    this.playing += 1;
    const { position, by } = this.kinematics.reach(this.q, name, target);
    this.q = { ...this.q, [name]: position };
    const positions = this.kinematics.positions(this.q);
    const reasons = by.map((joint) => {
      const other = joint.name === name ? "" : `${joint.name} `;
      const where = conditionNames(joint.needs.condition).map((each) => `${each} at ${this.at(each, positions[each])}`);
      return `blocked: ${other}needs ${this.format(joint)}; ${where.join(", ")}`;
    });
    this.update(reasons.length ? { name, reason: reasons.join("; ") } : null);
    return position;
  }

  /** Returns a position of a joint as text. */
  at(name, position) {
    return format(this.kinematics.joints.get(name).kind, position);
  }

  /** Returns the dependency of a joint as text, with the range where it applies. */
  format({ name, needs }) {
    const text = (condition) => {
      const { kind, joint, value, terms } = condition;
      if (joint) return `${joint} ${kind === "above" ? ">" : "<"} ${this.at(joint, value)}`;
      return terms.map((term) => (term.joint ? text(term) : `(${text(term)})`)).join(kind === "all" ? " and " : " or ");
    };
    const beyond = needs.beyond ? ` beyond ${this.at(name, needs.beyond)}` : "";
    const until = needs.until === null ? "" : ` until ${this.at(name, needs.until)}`;
    return text(needs.condition) + beyond + until;
  }

  /** Moves all joints to positions; joints without one move nearest to 0. */
  place(q) {
    this.playing += 1;
    this.q = { ...q };
    this.light([], "");
    this.update();
  }

  /** Animates the joints from one pose to the next; every pose is shown even on a slow machine. */
  play(stops) {
    this.playing += 1;
    const own = this.playing;
    let leg = 0;
    let began = performance.now();
    const step = (now) => {
      if (own !== this.playing) return;
      const time = Math.min(Math.max(now - began, 0) / 1000 / LEAD, 1);
      const share = 0.5 - 0.5 * Math.cos(Math.PI * time);
      const [from, to] = [stops[leg], stops[leg + 1]];
      const at = (name) => (time < 1 ? from[name] + share * (to[name] - from[name]) : to[name]);
      this.q = Object.fromEntries(Object.keys(from).map((name) => [name, at(name)]));
      this.update();
      if (time === 1) [leg, began] = [leg + 1, now];
      if (leg < stops.length - 1) requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
  }

  explode(share) {
    this.apart = share;
    this.update();
  }

  /** Shows or hides a kind of symbol, or the colors of labels. */
  show(kind, shown) {
    if (kind === "labels") this.colored = shown;
    else this.symbols.show(kind, shown);
    if (kind === "masses" || kind === "colliders") {
      const boxes = [...document.querySelectorAll("[data-symbol=masses], [data-symbol=colliders]")];
      this.translucent = boxes.some((box) => box.checked);
    }
    this.updateMaterials();
    this.legend();
    this.update();
  }

  /** Shows two links of the certificate in their worst pose. */
  inspect(pair) {
    this.place(pair.pose);
    this.light(pair.links, pair.text, true);
    this.symbols.mark(pair.place);
    this.studio.redraw();
  }

  /** Highlights links and shows a text about them; with `alone`, the other links are translucent. */
  light(links, text, alone = false) {
    this.highlighted = links;
    this.alone = alone;
    this.updateMaterials();
    const tip = document.getElementById("tip");
    tip.textContent = text;
    tip.hidden = !text;
  }

  updateMaterials() {
    const { colored, translucent, alone, highlighted } = this;
    this.model.updateMaterials({ colors: colored ? this.data.colors : null, translucent: translucent || alone, highlighted });
    this.studio.redraw();
  }

  legend() {
    const legend = document.getElementById("legend");
    legend.hidden = !this.colored;
    const seen = new Set([...this.model.meshes()].map((mesh) => mesh.userData.label));
    const rows = Object.entries(this.data.colors).filter(([label]) => seen.has(label));
    legend.replaceChildren(
      ...rows.map(([label, color]) => {
        const sample = element("i");
        sample.style.background = `rgb(${color.map((part) => Math.round(255 * part)).join(",")})`;
        return element("div", {}, sample, label);
      }),
    );
  }

  /** Highlights the clicked link and shows its properties. */
  pick(event) {
    if (this.orbit.moved) return;
    const box = this.studio.renderer.domElement.getBoundingClientRect();
    const at = new THREE.Vector2(
      (2 * (event.clientX - box.left)) / box.width - 1,
      1 - (2 * (event.clientY - box.top)) / box.height,
    );
    const ray = new THREE.Raycaster();
    ray.setFromCamera(at, this.studio.camera);
    const [hit] = ray.intersectObjects([...this.model.meshes()], false);
    this.symbols.mark(null);
    if (!hit) {
      this.light([], "");
      return;
    }
    const { link, label, own } = hit.object.userData;
    const { mass } = this.data.links.find((each) => each.name === link);
    this.light([link], `${link} · ${label} · ${own.name} · ${kilograms(mass)}`);
    document.querySelectorAll("[data-row]").forEach((row) => {
      if (this.kinematics.joints.get(row.dataset.row).child === link) row.scrollIntoView({ block: "nearest" });
    });
  }

  /** Moves everything to the current positions and draws it. */
  update(blocked = null) {
    const positions = this.kinematics.positions(this.q);
    const poses = this.kinematics.poses(this.q);
    this.model.place(poses.links, this.apart);
    this.symbols.mark(null);
    this.symbols.follow(poses, positions);
    this.panel.update(positions, blocked);
    this.work(positions);
    this.studio.redraw({ moved: true });
  }

  /** Computes the outputs after the time that went by, and lets materials shine. */
  work(positions = this.kinematics.positions(this.q)) {
    const [now, before] = [performance.now(), this.values];
    this.values = this.controller.step(positions, (now - this.clock) / 1000);
    this.clock = now;
    if (before && this.data.outputs.every(({ name }) => before[name] === this.values[name])) return;
    this.model.shine(this.data.outputs, this.values);
    this.panel.work(this.values);
    this.studio.redraw();
  }

  fit() {
    const { clientWidth, clientHeight } = this.stage;
    if (clientWidth && clientHeight) this.studio.resize(clientWidth, clientHeight);
  }
}

/** Returns the names of the joints in a condition. */
function conditionNames(condition) {
  return condition.joint ? [condition.joint] : [...new Set(condition.terms.flatMap(conditionNames))];
}

/** Returns the corners of a box in scene coordinates, where y is up. */
function cornersOf([low, high]) {
  return [0, 1, 2, 3, 4, 5, 6, 7].map((number) => {
    const [x, y, z] = [0, 1, 2].map((axis) => ((number >> axis) & 1 ? high : low)[axis]);
    return new THREE.Vector3(x, z, -y);
  });
}

async function start() {
  const [three, data, glb] = await Promise.all([unpackedText("three"), unpackedText("data"), unpacked("model")]);
  document.head.append(element("script", { textContent: three }));
  const nodes = await nodesOf(glb);
  const viewer = new Viewer(JSON.parse(data), nodes, document.getElementById("stage"));
  viewer.studio.draw();
  document.getElementById("message").hidden = true;
  viewer.opened = performance.now(); // time since the page was requested [ms]
  window.artgen = viewer;
}

start().catch((error) => {
  const message = document.getElementById("message");
  message.className = "fault";
  message.textContent = `This page cannot be shown: ${error.message}. It needs a browser with WebGL, from 2023 or later.`;
  console.error(error);
});
