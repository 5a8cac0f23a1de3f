// The asset: the links of the GLB, each with its own matrix.

// Reflections on glass are as strong as on opaque materials; only the light from behind is attenuated.
const GLASS = `
float shine = clamp(dot(totalSpecular, vec3(0.3333)), 0.0, 1.0);
float cover = diffuseColor.a + (1.0 - diffuseColor.a) * shine;
gl_FragColor = vec4((totalDiffuse * diffuseColor.a + totalSpecular + totalEmissiveRadiance) / max(cover, 0.001), cover);
`;

const GLOWS = [[0.42, 0.09, 0.0], [0.0, 0.13, 0.45]]; // orange, blue

class Model {
  /** Stores the nodes of the links by name, with the data of the asset. */
  constructor(nodes, data) {
    this.root = new THREE.Group();
    this.root.rotation.x = -Math.PI / 2; // z is up in the asset, y in the scene
    this.links = new Map();
    for (const link of data.links) {
      const node = nodes.get(link.name);
      node.removeFromParent();
      node.matrixAutoUpdate = false;
      const place = new THREE.Matrix4().makeTranslation(...link.origin);
      this.links.set(link.name, { node, place, shift: new THREE.Vector3(...link.shift), meshes: [] });
      this.root.add(node);
    }
    for (const [name, link] of this.links) {
      link.node.traverse((node) => {
        if (node.isMesh) link.meshes.push(prepared(node, name));
      });
    }
    this.materials = new Map(); // changed copies of materials, by their changes
    this.poses = {};
  }

  /** Moves every link to its pose, plus a share of its offset in the exploded view. */
  place(poses, apart) {
    for (const [name, link] of this.links) {
      const pose = poses[name].clone();
      const shift = link.shift.clone().multiplyScalar(apart);
      link.node.matrix.makeTranslation(shift.x, shift.y, shift.z).multiply(pose).multiply(link.place);
      this.poses[name] = new THREE.Matrix4().makeTranslation(shift.x, shift.y, shift.z).multiply(pose);
      link.node.matrixWorldNeedsUpdate = true;
    }
    this.root.updateMatrixWorld(true);
  }

  /**
   * Gives every surface its own material, or a plain one in the color of its label. The links in `highlighted` glow,
   * each in its own color, and stay opaque when the others are translucent.
   */
  updateMaterials({ colors, translucent, highlighted }) {
    for (const mesh of this.meshes()) {
      const { own, label, link } = mesh.userData;
      const color = colors && colors[label];
      const glows = highlighted.indexOf(link) + 1;
      const clear = translucent && !glows;
      const key = `${color ? label : own.uuid} ${clear} ${glows}`;
      if (!this.materials.has(key)) this.materials.set(key, changedMaterial(color ? flat(color) : own, clear, glows));
      mesh.material = this.materials.get(key);
    }
  }

  /** Lets materials emit the light of their outputs. */
  shine(outputs, values) {
    const colors = new Map(); // linear RGB by name of the material
    for (const { name, material, color } of outputs.filter((each) => each.material)) {
      const before = colors.get(material) ?? [0, 0, 0];
      colors.set(material, before.map((part, place) => Math.min(part + values[name] * color[place], 1)));
    }
    for (const { userData } of this.meshes()) {
      const color = colors.get(userData.own.name);
      if (!color) continue;
      userData.own.emissive.setRGB(...color);
      this.materials.get(`${userData.own.uuid} true 0`)?.emissive.setRGB(...color); // the translucent copy
    }
  }

  * meshes() {
    for (const link of this.links.values()) yield* link.meshes;
  }
}

function flat(color) {
  const shown = new THREE.Color(...color).convertSRGBToLinear();
  return new THREE.MeshStandardMaterial({ color: shown, roughness: 0.75, metalness: 0, envMapIntensity: 0.6 });
}

function changedMaterial(material, translucent, glows) {
  if (!translucent && !glows) return material;
  const result = material.clone();
  result.onBeforeCompile = material.onBeforeCompile;
  if (translucent) Object.assign(result, { opacity: 0.25 * material.opacity, transparent: true, depthWrite: false });
  if (glows) result.emissive.setRGB(...GLOWS[(glows - 1) % GLOWS.length]);
  return result;
}

/** Returns the nodes of a GLB by their names in the file; GLTFLoader renames duplicates. */
async function nodesOf(glb) {
  const { parser } = await new THREE.GLTFLoader().parseAsync(glb, "");
  const nodes = parser.json.nodes.map(async ({ name }, number) => [name, await parser.getDependency("node", number)]);
  return new Map(await Promise.all(nodes));
}

/** Prepares a surface: opaque ones cast shadows, and glass mirrors the studio. */
function prepared(mesh, link) {
  const { material } = mesh;
  Object.assign(mesh.userData, { link, label: mesh.geometry.userData.label, own: material });
  mesh.castShadow = !material.transparent;
  mesh.receiveShadow = true;
  if (material.transparent) {
    material.depthWrite = false;
    material.onBeforeCompile = (shader) => {
      shader.fragmentShader = shader.fragmentShader.replace("#include <output_fragment>", GLASS);
    };
  }
  return mesh;
}
