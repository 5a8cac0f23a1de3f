// The geometry of a node in a small view, within the faint whole asset.

const GHOST = 0.07; // opacity of the whole asset
const STEPS = 65535; // positions along one side of a mesh
const LINE = { axis: 0xc8483a, line: 0x8d64b3, points: 0xa8763e };

class Geometry {
  constructor(canvas, data, blob, root) {
    this.items = data.items;
    this.meshes = unpackedMeshes(data.meshes, blob);
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true, alpha: true });
    this.renderer.outputEncoding = THREE.sRGBEncoding;
    this.camera = new THREE.PerspectiveCamera(28, 1, 0.01, 100);
    this.scene = new THREE.Scene();
    this.world = new THREE.Group();
    this.world.rotation.x = -Math.PI / 2; // z is up
    this.key = new THREE.DirectionalLight(0xffffff, 0.75);
    this.scene.add(this.world, new THREE.HemisphereLight(0xffffff, 0x8a8f96, 0.75), this.key);
    this.shown = new THREE.Group();
    this.world.add(this.shown);
    const whole = this.made(root, true);
    this.all = new THREE.Box3().setFromObject(this.world.add(whole));
    this.ghost = whole;
    this.size = this.all.getSize(new THREE.Vector3()).length();
    [this.camera.near, this.camera.far] = [this.size / 500, this.size * 30];
    this.orbit = new Orbit(this, canvas, { azimuth: -0.6, elevation: 0.35, corners: this.corners(this.all) });
    new ResizeObserver(() => this.resize()).observe(canvas);
  }

  /** Shows the items of a node, and adapts the distance of the camera. */
  show(items, ghosted) {
    this.ghost.visible = ghosted;
    this.shown.clear();
    this.shown.add(...this.made(items, false).children);
    this.resize();
    const box = new THREE.Box3();
    const solid = this.shown.children.filter((each) => !each.userData.symbol);
    solid.forEach((each) => box.expandByObject(each));
    const flat = box.getSize(new THREE.Vector3()).length() < 1e-4 * this.size;
    this.orbit.home.corners = this.corners(!solid.length || flat || ghosted ? this.all.clone().union(box) : box);
    this.orbit.reset();
  }

  made(items, ghost) {
    const group = new THREE.Group();
    for (const number of items) {
      const item = this.items[number];
      if (item.mesh !== undefined) group.add(this.placed(item, ghost));
      else if (!ghost) group.add(this.symbol(item));
    }
    return group;
  }

  placed(item, ghost) {
    const color = new THREE.Color(...item.color);
    const look = ghost
      ? new THREE.MeshBasicMaterial({ color: 0x40464d, transparent: true, opacity: GHOST, depthWrite: false })
      : new THREE.MeshPhongMaterial({ color, shininess: 12, specular: 0x111111 });
    const mesh = new THREE.Mesh(this.meshes[item.mesh], look);
    if (item.matrix) mesh.applyMatrix4(new THREE.Matrix4().fromArray(item.matrix));
    return mesh;
  }

  /** Draws an item without a surface: a frame, an axis, points or a line. */
  symbol(item) {
    const group = new THREE.Group();
    group.userData.symbol = !item.line;
    const long = 0.12 * this.size;
    const rod = (from, to, radius, color) => group.add(bar(from, to, radius, ink(color)));
    if (item.frame) {
      const matrix = new THREE.Matrix4().fromArray(item.frame);
      const at = new THREE.Vector3().setFromMatrixPosition(matrix);
      [0xc8483a, 0x3c9a56, 0x3f6fb5].forEach((color, axis) => {
        const along = new THREE.Vector3().setFromMatrixColumn(matrix, axis);
        rod(at, at.clone().addScaledVector(along, long / 3), long / 60, color);
      });
    } else if (item.axis) {
      const [[at], [along]] = [points([item.at]), points([item.along])];
      const end = at.clone().addScaledVector(along, long);
      rod(at.clone().addScaledVector(along, -long), end, long / 50, LINE.axis);
      group.add(tip(end, along, long / 16, long / 5, ink(LINE.axis)));
    } else if (item.points) {
      for (const at of points(item.points)) group.add(ball(at, long / 20, ink(LINE.points)));
    } else {
      const line = points(item.line);
      const radius = 0.004 * new THREE.Box3().setFromPoints(line).getSize(new THREE.Vector3()).length();
      line.slice(1).forEach((to, index) => rod(line[index], to, radius, LINE.line));
      if (item.closed) rod(line.at(-1), line[0], radius, LINE.line);
    }
    return group;
  }

  corners({ min, max }) {
    return [...Array(8).keys()].map((corner) => new THREE.Vector3(corner & 1 ? max.x : min.x, corner & 2 ? max.y : min.y, corner & 4 ? max.z : min.z));
  }

  resize() {
    const { clientWidth, clientHeight } = this.renderer.domElement;
    if (!clientWidth) return;
    this.renderer.setPixelRatio(window.devicePixelRatio);
    this.renderer.setSize(clientWidth, clientHeight, false);
    this.camera.aspect = clientWidth / clientHeight;
    this.camera.updateProjectionMatrix();
    this.redraw();
  }

  redraw() {
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => {
      this.waiting = false;
      this.key.position.copy(this.camera.position).add(new THREE.Vector3(0, this.size, 0));
      this.renderer.render(this.scene, this.camera);
    });
  }
}

/** Reads the meshes: positions and normals of the vertices, and triangles, each at a multiple of 4 bytes. */
function unpackedMeshes(headers, blob) {
  let at = 0;
  const take = (Kind, count) => {
    const numbers = new Kind(blob, at, count);
    at += Math.ceil(numbers.byteLength / 4) * 4;
    return numbers;
  };
  return headers.map(({ vertices, triangles, low, size }) => {
    const steps = take(Uint16Array, 3 * vertices);
    const normals = take(Int8Array, 3 * vertices);
    const corners = take(vertices > STEPS ? Uint32Array : Uint16Array, 3 * triangles);
    const positions = Float32Array.from(steps, (step, index) => low[index % 3] + (step / STEPS) * size[index % 3]);
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(positions, 3));
    geometry.setAttribute("normal", new THREE.BufferAttribute(normals, 3, true));
    geometry.setIndex(new THREE.BufferAttribute(corners, 1));
    return geometry;
  });
}
