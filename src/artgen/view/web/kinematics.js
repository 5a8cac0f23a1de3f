// How joints move links: what asset.positions, asset.blocked and asset.pose do in Python, on the same data.

const LIMIT_SLACK = 1e-9; // a position may miss its limit by rounding [rad or m]
const LOOKS = 96; // places on the way of a joint at which dependencies are asked
const HALVINGS = 30; // with which the place is found where a dependency stops a joint

/** Tells whether joint positions lie in a region of joint space. */
function holds(condition, positions) {
  if (condition.kind === "above") return positions[condition.joint] > condition.value;
  if (condition.kind === "below") return positions[condition.joint] < condition.value;
  const terms = condition.terms.map((term) => holds(term, positions));
  return condition.kind === "all" ? terms.every(Boolean) : terms.some(Boolean);
}

/** Tells whether a joint that needs others may stand at a position while they stand at theirs. */
function allows(needs, position, positions) {
  const near = Math.abs(position) <= Math.max(needs.beyond ?? 0, 1e-9);
  const far = needs.until !== null && Math.abs(position) >= needs.until;
  return near || far || holds(needs.condition, positions);
}

class Kinematics {
  /** Takes the data of an asset. */
  constructor(data) {
    this.base = data.links[0].name;
    this.joints = new Map(data.joints.map((joint) => [joint.name, joint]));
    this.free = data.joints.filter((joint) => !joint.follows && !joint.locked);
    this.chains = new Map(); // the joints between a link and its parent, by the name of the link
    for (const joint of data.joints) {
      if (!this.chains.has(joint.child)) this.chains.set(joint.child, []);
      this.chains.get(joint.child).push(joint);
    }
  }

  /** Returns the position of every joint: those not given stand nearest to 0, coupled ones follow. */
  positions(q = {}) {
    const result = {};
    const place = (joint) => {
      if (joint.name in result) return result[joint.name];
      const { follows } = joint;
      const position = follows
        ? follows.ratio * place(this.joints.get(follows.leader)) + follows.offset
        : (q[joint.name] ?? joint.closed);
      result[joint.name] = position;
      return position;
    };
    for (const joint of this.joints.values()) place(joint);
    return result;
  }

  /** Returns the nearest position within the limits of a joint. */
  within(name, position) {
    const { limits } = this.joints.get(name);
    if (!limits) return position;
    const inside = Math.min(Math.max(position, limits[0]), limits[1]);
    return Math.abs(inside - position) <= LIMIT_SLACK ? position : inside;
  }

  /** Returns the joints that a dependency forbids to stand where `q` puts them. */
  blocked(q = {}) {
    const positions = this.positions(q);
    return [...this.joints.values()].filter(
      (joint) => joint.needs && !allows(joint.needs, positions[joint.name], positions),
    );
  }

  /** Returns how far a joint gets towards a position, and the joints that would then be blocked. */
  reach(q, name, wanted) {
    const target = this.within(name, wanted);
    const start = this.positions(q)[name];
    const before = new Set(this.blocked(q)); // what is blocked already holds nothing up
    const stopped = (share) =>
      this.blocked({ ...q, [name]: start + share * (target - start) }).filter((joint) => !before.has(joint));
    for (let look = 1; look <= LOOKS; look += 1) {
      let by = stopped(look / LOOKS);
      if (!by.length) continue;
      let [low, high] = [(look - 1) / LOOKS, look / LOOKS];
      for (let halving = 0; halving < HALVINGS; halving += 1) {
        const middle = (low + high) / 2;
        const found = stopped(middle);
        if (found.length) [high, by] = [middle, found];
        else low = middle;
      }
      return { position: start + low * (target - start), by };
    }
    return { position: target, by: [] };
  }

  /** Returns how each link is displaced from rest, and the axis of each joint, as matrices by name. */
  poses(q = {}) {
    const positions = this.positions(q);
    const links = { [this.base]: new THREE.Matrix4() };
    const axes = {};
    for (const [child, joints] of this.chains) {
      const transform = links[joints[0].parent].clone();
      for (const joint of joints) {
        axes[joint.name] = transform.clone();
        transform.multiply(motion(joint, positions[joint.name]));
      }
      links[child] = transform;
    }
    return { links, axes };
  }
}

/** Returns the displacement of a joint's child at a position. */
function motion(joint, position) {
  const axis = new THREE.Vector3(...joint.axis);
  if (joint.kind === "prismatic") {
    const { x, y, z } = axis.multiplyScalar(position);
    return new THREE.Matrix4().makeTranslation(x, y, z);
  }
  const [x, y, z] = joint.pivot;
  return new THREE.Matrix4()
    .makeTranslation(x, y, z)
    .multiply(new THREE.Matrix4().makeRotationAxis(axis, position))
    .multiply(new THREE.Matrix4().makeTranslation(-x, -y, -z));
}
