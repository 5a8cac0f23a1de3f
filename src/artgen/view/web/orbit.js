// The camera: dragging turns it about the asset, the right button or Shift pans it, the wheel changes its distance.
// In a room, W A S D and the arrow keys walk at eye height; dragging looks around then.

const STEEPEST = 1.55; // largest elevation above or below the horizon [rad]
const EYES = 1.6; // height of the camera above the floor while walking [m]
const PACE = 0.12; // way per press or repetition of a key [m]
const LOOK = 0.08; // angle per press or repetition of a key [rad]
const ROOM = 1.9; // smallest width, depth and height of a room [m]
const WALKING_FOV = 60; // field of view while walking [degrees]
// by key: steps forward, steps to the right, turns to the right
const KEYS = {
  KeyW: [1, 0, 0], KeyS: [-1, 0, 0], KeyA: [0, -1, 0], KeyD: [0, 1, 0],
  ArrowUp: [1, 0, 0], ArrowDown: [-1, 0, 0], ArrowLeft: [0, 0, -1], ArrowRight: [0, 0, 1],
};

class Orbit {
  /** Sets the first view of a studio: azimuth and elevation [rad], and the corners of the visible box. */
  constructor(studio, canvas, { azimuth, elevation, corners }) {
    Object.assign(this, { studio, canvas, home: { azimuth, elevation, corners, fov: studio.camera.fov } });
    this.fingers = new Map();
    this.moved = false; // whether the pointer moved since the last press
    canvas.addEventListener("pointerdown", (event) => this.press(event));
    canvas.addEventListener("pointermove", (event) => this.drag(event));
    for (const name of ["pointerup", "pointercancel"]) {
      canvas.addEventListener(name, (event) => this.fingers.delete(event.pointerId));
    }
    canvas.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
    canvas.addEventListener("contextmenu", (event) => event.preventDefault());
    this.box = new THREE.Box3();
    this.reset();
    if (Math.min(...this.box.getSize(new THREE.Vector3()).toArray()) > ROOM) {
      canvas.title = "W A S D and arrow keys: walk";
      window.addEventListener("keydown", (event) => this.walk(event));
    }
  }

  /** Returns to the first view, at the smallest distance that shows the whole box. */
  reset() {
    const { azimuth, elevation, corners, fov } = this.home;
    Object.assign(this, { azimuth, elevation, walking: false });
    this.see(fov);
    this.target = this.box.setFromPoints(corners).getCenter(new THREE.Vector3());
    const { right, up, back } = this.axes();
    const tall = Math.tan(THREE.MathUtils.degToRad(this.studio.camera.fov / 2));
    const wide = tall * this.studio.camera.aspect;
    const needed = corners.map((corner) => {
      const offset = corner.clone().sub(this.target);
      return offset.dot(back) + Math.max(Math.abs(offset.dot(right)) / wide, Math.abs(offset.dot(up)) / tall);
    });
    this.distance = Math.max(...needed) * 1.08;
    this.apply();
  }

  /** Sets the field of view [degrees]. */
  see(fov) {
    this.studio.camera.fov = fov;
    this.studio.camera.updateProjectionMatrix();
  }

  /** Walks by a key; the first key puts the camera into the middle of the room, at eye height. */
  walk(event) {
    const step = KEYS[event.code];
    if (!step || event.ctrlKey || event.metaKey || event.altKey || event.target.closest?.("input, select, textarea")) return;
    event.preventDefault();
    if (!this.walking) {
      Object.assign(this, { walking: true, elevation: 0, distance: 0.01 });
      this.target = this.box.getCenter(new THREE.Vector3()).setY(this.box.min.y + EYES);
      this.see(WALKING_FOV);
    }
    const [forward, right, turn] = step;
    this.azimuth -= turn * LOOK;
    this.target.x += PACE * (right * Math.cos(this.azimuth) - forward * Math.sin(this.azimuth));
    this.target.z -= PACE * (right * Math.sin(this.azimuth) + forward * Math.cos(this.azimuth));
    this.box.clampPoint(this.target, this.target);
    this.apply();
  }

  axes() {
    const [across, along] = [Math.cos(this.elevation), Math.sin(this.elevation)];
    const back = new THREE.Vector3(Math.sin(this.azimuth) * across, along, Math.cos(this.azimuth) * across);
    const right = new THREE.Vector3(Math.cos(this.azimuth), 0, -Math.sin(this.azimuth));
    return { right, back, up: new THREE.Vector3().crossVectors(back, right) };
  }

  apply() {
    const { camera } = this.studio;
    camera.position.copy(this.target).addScaledVector(this.axes().back, this.distance);
    camera.lookAt(this.target);
    this.studio.redraw();
  }

  press(event) {
    this.canvas.setPointerCapture(event.pointerId);
    this.fingers.set(event.pointerId, [event.clientX, event.clientY]);
    this.moved = false;
  }

  drag(event) {
    const before = this.fingers.get(event.pointerId);
    if (!before) return;
    const [x, y] = [event.clientX - before[0], event.clientY - before[1]];
    if (Math.hypot(x, y) < 3 && !this.moved) return;
    this.moved = true;
    const others = [...this.fingers].filter(([number]) => number !== event.pointerId).map(([, at]) => at);
    this.fingers.set(event.pointerId, [event.clientX, event.clientY]);
    if (others.length) this.pinch(before, [event.clientX, event.clientY], others[0]);
    else if (event.shiftKey || event.buttons === 2) this.pan(x, y);
    else this.turn(x, y);
    this.apply();
  }

  turn(x, y) {
    this.azimuth -= (x / this.canvas.clientHeight) * Math.PI;
    const elevation = this.elevation + (y / this.canvas.clientHeight) * Math.PI;
    this.elevation = Math.min(Math.max(elevation, -STEEPEST), STEEPEST);
  }

  pan(x, y) {
    const tall = 2 * this.distance * Math.tan(THREE.MathUtils.degToRad(this.studio.camera.fov / 2));
    const { right, up } = this.axes();
    this.target.addScaledVector(right, (-x / this.canvas.clientHeight) * tall);
    this.target.addScaledVector(up, (y / this.canvas.clientHeight) * tall);
  }

  pinch(before, after, other) {
    const apart = ([x, y]) => Math.max(Math.hypot(x - other[0], y - other[1]), 1);
    this.distance *= apart(before) / apart(after);
    this.pan((after[0] - before[0]) / 2, (after[1] - before[1]) / 2);
  }

  wheel(event) {
    event.preventDefault();
    this.distance *= Math.exp(event.deltaY * (event.deltaMode ? 0.04 : 0.0012));
    this.apply();
  }
}
