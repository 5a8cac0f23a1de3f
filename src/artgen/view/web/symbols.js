// Symbols over an asset: colliders, axes and ranges of joints, frames of hands, centers of mass.

const SYMBOL_COLORS = {
  axis: 0xd55e00, range: 0xe69f00, hand: 0x0072b2, push: 0xcc79a7, center: 0x111111, place: 0xff2a00,
  x: 0xd62728, y: 0x2ca02c, z: 0x1f5fd0,
};

/** Returns a material that stays visible behind other objects. */
function ink(color, opacity = 1) {
  return new THREE.MeshBasicMaterial({
    color: new THREE.Color(color).convertSRGBToLinear(), opacity, transparent: true,
    depthTest: false, depthWrite: false, toneMapped: false, side: THREE.DoubleSide,
  });
}

/** Returns a round bar between two points. */
function bar(from, to, radius, material) {
  const way = new THREE.Vector3().subVectors(to, from);
  const mesh = new THREE.Mesh(new THREE.CylinderGeometry(radius, radius, way.length(), 10), material);
  mesh.position.copy(from).addScaledVector(way, 0.5);
  mesh.quaternion.setFromUnitVectors(new THREE.Vector3(0, 1, 0), way.normalize());
  return mesh;
}

function tip(at, direction, radius, length, material) {
  const mesh = new THREE.Mesh(new THREE.ConeGeometry(radius, length, 16), material);
  mesh.position.copy(at).addScaledVector(direction, length / 2);
  mesh.quaternion.setFromUnitVectors(new THREE.Vector3(0, 1, 0), direction);
  return mesh;
}

function ball(at, radius, material) {
  const mesh = new THREE.Mesh(new THREE.SphereGeometry(radius, 20, 14), material);
  mesh.position.copy(at);
  return mesh;
}

const points = (rows) => rows.map((row) => new THREE.Vector3(...row));

class Symbols {
  /** Stores the data of an asset, its model, to whose root symbols are added, and the list of nodes without shadow. */
  constructor(data, model, withoutShadow) {
    Object.assign(this, { data, model, withoutShadow });
    const [low, high] = points(data.bounds);
    this.size = low.distanceTo(high);
    this.groups = {}; // created when they are first shown
    this.place = null;
  }

  /** Shows or hides one kind of symbol: `colliders`, `joints`, `grasps` or `masses`. */
  show(kind, shown) {
    if (shown && !this.groups[kind]) {
      const made = { colliders: this.colliders, joints: this.joints, grasps: this.grasps, masses: this.masses };
      this.groups[kind] = new THREE.Group();
      this.groups[kind].renderOrder = kind === "colliders" ? 5 : 10;
      made[kind].call(this, this.groups[kind]);
      this.groups[kind].traverse((node) => Object.assign(node, { renderOrder: this.groups[kind].renderOrder }));
      this.model.root.add(this.groups[kind]);
      this.withoutShadow.push(this.groups[kind]);
    }
    if (this.groups[kind]) this.groups[kind].visible = shown;
  }

  /** Marks a point on the asset, such as that of a collision; null removes the mark. */
  mark(place) {
    this.place?.removeFromParent();
    this.place = place && ball(new THREE.Vector3(...place), this.size * 0.012, ink(SYMBOL_COLORS.place, 0.85));
    if (this.place) {
      this.place.renderOrder = 20;
      this.model.root.add(this.place);
      this.withoutShadow.push(this.place);
    }
  }

  /** Moves all symbols with the asset. */
  follow(poses, positions) {
    for (const group of Object.values(this.groups)) {
      for (const symbol of group.children) {
        const { link, joint, turns } = symbol.userData;
        if (link) symbol.matrix.copy(this.model.poses[link]);
        if (joint) {
          const shift = new THREE.Matrix4().copyPosition(this.model.poses[joint.parent]);
          const still = new THREE.Matrix4().copyPosition(poses.links[joint.parent]).invert();
          symbol.matrix.copy(shift.multiply(still).multiply(poses.axes[joint.name]));
          if (turns) symbol.matrix.multiply(motion(joint, positions[joint.name]));
        }
        symbol.matrixWorldNeedsUpdate = true;
      }
    }
    const whole = this.groups.masses?.children.find((symbol) => symbol.userData.whole);
    if (whole) whole.matrix.setPosition(this.center());
    this.model.root.updateMatrixWorld(true);
  }

  /** Returns the center of mass of the whole asset in its pose. */
  center() {
    const sum = new THREE.Vector3();
    for (const link of this.data.links) {
      const at = new THREE.Vector3(...link.center).applyMatrix4(this.model.poses[link.name]);
      sum.addScaledVector(at, link.mass);
    }
    return sum.divideScalar(this.data.mass);
  }

  part(group, what) {
    const part = new THREE.Group();
    part.matrixAutoUpdate = false;
    part.userData = what;
    group.add(part);
    return part;
  }

  colliders(group) {
    for (const link of this.data.links) {
      const part = this.part(group, { link: link.name });
      for (const { label, vertices, triangles } of link.colliders) {
        const geometry = new THREE.BufferGeometry();
        geometry.setAttribute("position", new THREE.Float32BufferAttribute(vertices, 3));
        geometry.setIndex(triangles);
        const color = new THREE.Color(...this.data.colors[label]).convertSRGBToLinear();
        const faces = new THREE.MeshBasicMaterial({
          color, opacity: 0.3, transparent: true, depthWrite: false, toneMapped: false,
          polygonOffset: true, polygonOffsetFactor: -1, polygonOffsetUnits: -1,
        });
        const edges = new THREE.LineBasicMaterial({ color: color.clone().multiplyScalar(0.3), toneMapped: false });
        part.add(new THREE.Mesh(geometry, faces), new THREE.LineSegments(new THREE.EdgesGeometry(geometry, 25), edges));
      }
    }
  }

  joints(group) {
    const radius = this.size * 0.0022;
    for (const joint of this.data.joints) {
      if (!joint.symbol) continue;
      const still = this.part(group, { joint });
      const turning = this.part(group, { joint, turns: true });
      const axis = points(joint.symbol.axis);
      const range = points(joint.symbol.range);
      const hand = points(joint.symbol.hand);
      const direction = new THREE.Vector3(...joint.axis);
      const [drawn, way, own] = [ink(SYMBOL_COLORS.axis), ink(SYMBOL_COLORS.range), ink(SYMBOL_COLORS.hand)];
      if (joint.kind === "revolute") {
        still.add(bar(axis[0], axis[1], radius, drawn));
        still.add(tip(axis[1], direction, 3 * radius, 9 * radius, drawn));
        still.add(fan(hand[0], range, ink(SYMBOL_COLORS.range, 0.22)));
        const arc = new THREE.CatmullRomCurve3(range);
        still.add(new THREE.Mesh(new THREE.TubeGeometry(arc, Math.max(2, 2 * range.length), radius * 0.8, 8), way));
        turning.add(bar(hand[0], hand[1], radius, own), ball(hand[1], 2.2 * radius, own));
      } else {
        still.add(bar(range[0], range[1], radius, way));
        for (const end of range) still.add(ball(end, 2 * radius, way));
        still.add(tip(range[1], direction, 3 * radius, 9 * radius, drawn));
        turning.add(ball(hand[1], 3.2 * radius, own));
      }
    }
  }

  grasps(group) {
    const length = this.size * 0.045;
    for (const link of this.data.links) {
      const part = this.part(group, { link: link.name });
      for (const hold of link.holds) {
        const matrix = new THREE.Matrix4().set(...hold.frame.flat());
        const frame = new THREE.Group();
        frame.applyMatrix4(matrix);
        const zero = new THREE.Vector3();
        const unit = { x: new THREE.Vector3(1, 0, 0), y: new THREE.Vector3(0, 1, 0), z: new THREE.Vector3(0, 0, 1) };
        for (const [name, direction] of Object.entries(unit)) {
          const material = ink(SYMBOL_COLORS[name]);
          // z is the approach of the hand and ends at the point of contact
          const [from, to] = name === "z"
            ? [direction.clone().multiplyScalar(-1.6 * length), direction.clone().multiplyScalar(-0.35 * length)]
            : [zero, direction.clone().multiplyScalar(0.6 * length)];
          frame.add(bar(from, to, length * 0.035, material));
          if (name === "z") frame.add(tip(to, direction, length * 0.11, length * 0.35, material));
        }
        if (hold.kind === "push") frame.add(ball(zero, length * 0.13, ink(SYMBOL_COLORS.push)));
        for (const side of hold.kind === "grasp" ? [-1, 1] : []) {
          const x = (side * hold.width) / 2;
          const finger = [new THREE.Vector3(x, 0, -0.8 * length), new THREE.Vector3(x, 0, 0.25 * length)];
          frame.add(bar(...finger, length * 0.06, ink(SYMBOL_COLORS.hand, 0.8)));
        }
        part.add(frame);
      }
    }
  }

  masses(group) {
    const heaviest = Math.max(...this.data.links.map((link) => link.mass));
    for (const link of this.data.links) {
      const part = this.part(group, { link: link.name });
      const radius = this.size * (0.006 + 0.012 * Math.cbrt(link.mass / heaviest));
      const at = new THREE.Vector3(...link.center);
      part.add(ball(at, radius, ink(SYMBOL_COLORS.center, 0.8)), ball(at, radius * 0.55, ink(SYMBOL_COLORS.range)));
    }
    const whole = this.part(group, { whole: true });
    const zero = new THREE.Vector3();
    whole.add(ball(zero, this.size * 0.014, ink(SYMBOL_COLORS.axis, 0.9)), ball(zero, this.size * 0.006, ink(0xffffff)));
  }
}

/** Returns the area between a point and the points of an arc. */
function fan(middle, rim, material) {
  const geometry = new THREE.BufferGeometry().setFromPoints([middle, ...rim]);
  geometry.setIndex(rim.slice(1).flatMap((_, number) => [0, number + 1, number + 2]));
  return new THREE.Mesh(geometry, material);
}
