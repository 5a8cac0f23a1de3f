// Kinematics of an asset: the same results as asset.positions, asset.blocked and asset.pose in Python.

const LIMIT_SLACK = 1e-9; // tolerance of a limit, for rounding errors [rad or m]
const CHECKS = 96; // positions on the path of a joint at which dependencies are checked
const HALVINGS = 30; // bisection steps to the position at which a dependency stops a joint

/** Tells whether joint positions lie in a region of joint space. */
function holds(condition, positions) {
  if (condition.kind === "above") return positions[condition.joint] > condition.value;
  if (condition.kind === "below") return positions[condition.joint] < condition.value;
  const terms = condition.terms.map((term) => holds(term, positions));
  return condition.kind === "all" ? terms.every(Boolean) : terms.some(Boolean);
}

/** Tells whether a dependency allows a position of its joint, given all positions. */
function allows(needs, position, positions) {
  const near = Math.abs(position) <= Math.max(needs.beyond ?? 0, 1e-9);
  const far = needs.until !== null && Math.abs(position) >= needs.until;
  return near || far || holds(needs.condition, positions);
}

/** Returns the position of a joint of a closed chain at a position of its input; without a curve, the same. */
function bent(curve, position) {
  if (!curve) return position;
  const [low, high] = curve.range;
  const turns = curve.turns ? Math.floor((position - low) / (2 * Math.PI)) : 0;
  const place = (2 * (position - 2 * Math.PI * turns) - low - high) / (high - low);
  let [value, before, gain] = [0, 0, 0]; // Clenshaw's recurrence
  for (let number = curve.terms.length - 1; number > 0; number -= 1) {
    [value, before] = [2 * place * value - before + curve.terms[number], value];
    gain += number % 2 ? 2 * curve.terms[number] : 0;
  }
  return place * value - before + curve.terms[0] + turns * gain;
}

class Kinematics {
  /** Stores the joints of an asset. */
  constructor(data) {
    this.base = data.links[0].name;
    this.joints = new Map(data.joints.map((joint) => [joint.name, joint]));
    this.free = data.joints.filter((joint) => !joint.follows && !joint.locked);
    this.chains = new Map(); // joints between a link and its parent, by name of the link
    for (const joint of data.joints) {
      if (!this.chains.has(joint.child)) this.chains.set(joint.child, []);
      this.chains.get(joint.child).push(joint);
    }
  }

  /** Returns the position of every joint: the given one, else the nearest to 0; coupled joints follow. */
  positions(q = {}) {
    const result = {};
    const place = (joint) => {
      if (joint.name in result) return result[joint.name];
      const { follows } = joint;
      const position = follows
        ? follows.ratio * bent(follows.curve, place(this.joints.get(follows.leader))) + follows.offset
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

  /** Returns the joints whose dependencies forbid their positions in `q`. */
  blocked(q = {}) {
    const positions = this.positions(q);
    return [...this.joints.values()].filter(
      (joint) => joint.needs && !allows(joint.needs, positions[joint.name], positions),
    );
  }

  /** Returns the position that a joint reaches towards a target, and the joints that would be blocked beyond. */
  reach(q, name, position) {
    const target = this.within(name, position);
    const start = this.positions(q)[name];
    const before = new Set(this.blocked(q)); // joints that are blocked at the start do not stop the motion
    const stopped = (share) =>
      this.blocked({ ...q, [name]: start + share * (target - start) }).filter((joint) => !before.has(joint));
    for (let check = 1; check <= CHECKS; check += 1) {
      let by = stopped(check / CHECKS);
      if (!by.length) continue;
      let [low, high] = [(check - 1) / CHECKS, check / CHECKS];
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

  /** Returns the displacement from rest of each link, and of the axis of each joint, as matrices by name. */
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
