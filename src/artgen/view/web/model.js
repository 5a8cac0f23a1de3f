// The asset itself: its links as the GLB has them, each with a matrix of its own.

// Reflections on glass are as strong as on what is opaque: only what is behind shines through.
const GLASS = `
float shine = clamp(dot(totalSpecular, vec3(0.3333)), 0.0, 1.0);
float cover = diffuseColor.a + (1.0 - diffuseColor.a) * shine;
gl_FragColor = vec4((totalDiffuse * diffuseColor.a + totalSpecular + totalEmissiveRadiance) / max(cover, 0.001), cover);
`;

const GLOWS = [[0.42, 0.09, 0.0], [0.0, 0.13, 0.45]]; // orange, blue

class Model {
  /** Takes the nodes of the links by name, and the data of the asset. */
  constructor(nodes, data) {
    this.root = new THREE.Group();
    this.root.rotation.x = -Math.PI / 2; // the asset's z is up, the scene's y
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
    this.dresses = new Map(); // the materials that were made of others, by what was changed
    this.poses = {};
  }

  /** Moves every link to its pose, and apart by a share of the exploded view. */
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
   * Gives every surface its own material, or a plain one in the color of its label. The links in `lit` glow, each
   * in a color of its own.
   * What is veiled can be looked through: all but those.
   */
  dress({ colors, veiled, lit }) {
    for (const mesh of this.meshes()) {
      const { own, label, link } = mesh.userData;
      const color = colors && colors[label];
      const glows = lit.indexOf(link) + 1;
      const clear = veiled && !glows;
      const key = `${color ? label : own.uuid} ${clear} ${glows}`;
      if (!this.dresses.has(key)) this.dresses.set(key, dressed(color ? flat(color) : own, clear, glows));
      mesh.material = this.dresses.get(key);
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

function dressed(material, veiled, glows) {
  if (!veiled && !glows) return material;
  const result = material.clone();
  result.onBeforeCompile = material.onBeforeCompile;
  if (veiled) Object.assign(result, { opacity: 0.25 * material.opacity, transparent: true, depthWrite: false });
  if (glows) result.emissive.setRGB(...GLOWS[(glows - 1) % GLOWS.length]);
  return result;
}

/** Returns the nodes of a GLB by their names in the file; GLTFLoader renames those that it finds twice. */
async function nodesOf(glb) {
  const { parser } = await new THREE.GLTFLoader().parseAsync(glb, "");
  const nodes = parser.json.nodes.map(async ({ name }, number) => [name, await parser.getDependency("node", number)]);
  return new Map(await Promise.all(nodes));
}

/** Readies a surface: it casts shadows, and glass mirrors the studio. */
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
