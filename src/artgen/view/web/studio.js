// The studio: soft light from all around, a key light, shadows on the ground, and tone mapping.

const EXPOSURE = 0.82;
const SHADOW_TEXELS = 1024;
const SOFT_TEXELS = 256;

// Without a graphics card, motion is drawn with a quarter of the pixels, and the still picture with all.
const SOFTWARE = /swiftshader|llvmpipe|softpipe|software|basic render/i;
const COARSE = 0.5;
const RESTS = 200; // delay of the full picture [ms]

// The Khronos neutral tone mapper keeps base colors and only compresses highlights.
const NEUTRAL = `
vec3 CustomToneMapping(vec3 color) {
  const float START = 0.8 - 0.04, DESATURATION = 0.15;
  color *= toneMappingExposure;
  float low = min(color.r, min(color.g, color.b));
  color -= low < 0.08 ? low - 6.25 * low * low : 0.04;
  float peak = max(color.r, max(color.g, color.b));
  if (peak < START) return color;
  float rest = 1.0 - START, rolled = 1.0 - rest * rest / (peak + rest - START);
  color *= rolled / peak;
  return mix(color, vec3(rolled), 1.0 - 1.0 / (DESATURATION * (peak - rolled) + 1.0));
}`;

const BLUR = `
uniform sampler2D map;
uniform vec2 stride;
varying vec2 at;
void main() {
  float sum = 0.0, whole = 0.0;
  for (int tap = -6; tap <= 6; tap += 1) {
    float weight = exp(-float(tap * tap) / 14.0);
    sum += weight * texture2D(map, at + float(tap) * stride).a;
    whole += weight;
  }
  gl_FragColor = vec4(0.0, 0.0, 0.0, sum / whole);
}`;

class Studio {
  /** Sets up a scene on a canvas, for an asset of this size [m] with its center at `middle` (y up). */
  constructor(canvas, size, middle) {
    THREE.ShaderChunk.tonemapping_pars_fragment = THREE.ShaderChunk.tonemapping_pars_fragment.replace(
      "vec3 CustomToneMapping( vec3 color ) { return color; }",
      NEUTRAL,
    );
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true, alpha: true });
    this.renderer.outputEncoding = THREE.sRGBEncoding;
    this.renderer.physicallyCorrectLights = true;
    this.renderer.toneMapping = THREE.CustomToneMapping;
    this.renderer.toneMappingExposure = EXPOSURE;
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = THREE.PCFShadowMap;
    this.renderer.shadowMap.autoUpdate = false;
    this.scene = new THREE.Scene();
    this.scene.environment = surroundings(this.renderer);
    this.camera = new THREE.PerspectiveCamera(28, 1, size / 200, size * 40);
    this.key = keyLight(size, middle);
    this.ground = ground(size, middle);
    this.soft = new SoftShadow(this.renderer, this.scene, size, middle);
    this.scene.add(this.key, this.key.target, this.ground, this.soft.plane);
    this.withoutShadow = [this.ground, this.soft.plane]; // nodes without shadow
    this.moved = true;
    this.slow = SOFTWARE.test(rendererName(this.renderer.getContext()));
    this.sharp = false; // whether all pixels are drawn
    this.timer = 0;
    this.waiting = false;
  }

  /** Draws the scene again with the next frame of the browser. */
  redraw({ moved = false } = {}) {
    this.moved ||= moved;
    this.sharp = false;
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => this.waiting && this.draw());
  }

  draw() {
    this.waiting = false;
    clearTimeout(this.timer);
    this.paint(this.slow ? COARSE : 1);
    if (this.slow) this.timer = setTimeout(() => this.paint(1), RESTS);
  }

  /** Draws the scene with a share of the pixels in each direction. */
  paint(share) {
    if (this.moved) {
      this.soft.draw(this.withoutShadow.filter((node) => node.visible));
      this.renderer.shadowMap.needsUpdate = true;
      this.moved = false;
    }
    const ratio = share * Math.min(window.devicePixelRatio, 2);
    if (this.renderer.getPixelRatio() !== ratio) this.renderer.setPixelRatio(ratio);
    this.renderer.render(this.scene, this.camera);
    this.sharp = share === 1;
  }

  resize(width, height) {
    const before = this.renderer.getSize(new THREE.Vector2());
    if (before.x === width && before.y === height) return;
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.redraw();
  }
}

// The lamps: azimuth (0 in front, 90 at the right) and elevation of their centers, half their width and height,
// the width of their soft edges [degrees], and their brightness.
const LAMPS = [
  { azimuth: -50, elevation: 42, width: 30, height: 24, edge: 10, light: 4.6 },
  { azimuth: 68, elevation: 25, width: 11, height: 38, edge: 7, light: 3.4 },
  { azimuth: 10, elevation: 88, width: 180, height: 22, edge: 14, light: 1.7 },
  { azimuth: 22, elevation: 14, width: 40, height: 26, edge: 24, light: 0.75 },
  { azimuth: 160, elevation: 35, width: 40, height: 20, edge: 16, light: 1.8 },
];
const SKY = { floor: 0.42, horizon: 0.38, top: 0.55 };
const SKY_WIDTH = 256; // texels around; half as many in height

/** Returns the environment map: a bright room with soft lamps. */
function surroundings(renderer) {
  const height = SKY_WIDTH / 2;
  const texels = new Uint16Array(4 * SKY_WIDTH * height).fill(THREE.DataUtils.toHalfFloat(1));
  for (let row = 0; row < height; row += 1) {
    const elevation = (180 * (row + 0.5)) / height - 90;
    for (let column = 0; column < SKY_WIDTH; column += 1) {
      const azimuth = 90 - ((360 * (column + 0.5)) / SKY_WIDTH - 180); // columns begin at the left
      const place = 4 * (row * SKY_WIDTH + column);
      texels.fill(THREE.DataUtils.toHalfFloat(brightness(azimuth, elevation)), place, place + 3);
    }
  }
  const sky = new THREE.DataTexture(texels, SKY_WIDTH, height, THREE.RGBAFormat, THREE.HalfFloatType);
  Object.assign(sky, { mapping: THREE.EquirectangularReflectionMapping, magFilter: THREE.LinearFilter, needsUpdate: true });
  const generator = new THREE.PMREMGenerator(renderer);
  const { texture } = generator.fromEquirectangular(sky);
  generator.dispose();
  sky.dispose();
  return texture;
}

/** Returns the brightness of the surroundings in a direction [degrees]. */
function brightness(azimuth, elevation) {
  const { smoothstep, lerp } = THREE.MathUtils;
  let sum = elevation < 0
    ? lerp(SKY.horizon, SKY.floor, smoothstep(-elevation, 0, 40))
    : lerp(SKY.horizon, SKY.top, smoothstep(elevation, 0, 80));
  for (const lamp of LAMPS) {
    const aside = Math.abs(((azimuth - lamp.azimuth + 540) % 360) - 180);
    const across = 1 - smoothstep(aside, lamp.width - lamp.edge, lamp.width + lamp.edge);
    const along = 1 - smoothstep(Math.abs(elevation - lamp.elevation), lamp.height - lamp.edge, lamp.height + lamp.edge);
    sum += lamp.light * across * along;
  }
  return sum;
}

/** Returns the name of the renderer: of a graphics card or of a program. */
function rendererName(context) {
  const known = context.getExtension("WEBGL_debug_renderer_info");
  return known ? context.getParameter(known.UNMASKED_RENDERER_WEBGL) : "";
}

function keyLight(size, middle) {
  const light = new THREE.DirectionalLight(0xfff8ee, 1.25);
  light.position.copy(middle).add(new THREE.Vector3(-0.55, 1.35, 0.75).multiplyScalar(size * 1.5));
  light.target.position.copy(middle);
  light.castShadow = true;
  light.shadow.mapSize.set(SHADOW_TEXELS, SHADOW_TEXELS);
  light.shadow.radius = 3;
  light.shadow.bias = -0.0006;
  light.shadow.normalBias = size * 0.004;
  Object.assign(light.shadow.camera, {
    left: -size, right: size, top: size, bottom: -size, near: size * 0.1, far: size * 5,
  });
  return light;
}

/** Returns the ground, which shows only the shadow of the key light. */
function ground(size, middle) {
  const plane = new THREE.Mesh(new THREE.PlaneGeometry(size * 3, size * 3), new THREE.ShadowMaterial({ opacity: 0.1 }));
  plane.rotation.x = -Math.PI / 2;
  plane.position.set(middle.x, -size * 0.0008, middle.z);
  plane.receiveShadow = true;
  return plane;
}

/** The soft shadow under an asset: darker where an object above the ground is nearer. */
class SoftShadow {
  constructor(renderer, scene, size, middle) {
    Object.assign(this, { renderer, scene });
    const across = size * 2.6;
    this.target = new THREE.WebGLRenderTarget(SOFT_TEXELS, SOFT_TEXELS);
    this.between = new THREE.WebGLRenderTarget(SOFT_TEXELS, SOFT_TEXELS);
    this.camera = new THREE.OrthographicCamera(-across / 2, across / 2, across / 2, -across / 2, 0, size * 0.22);
    this.camera.position.set(middle.x, -size * 0.001, middle.z);
    this.camera.rotation.x = Math.PI / 2; // from under the ground, upwards
    this.depth = new THREE.ShaderMaterial({
      vertexShader: "void main() { gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }",
      fragmentShader: "void main() { float near = 1.0 - gl_FragCoord.z; gl_FragColor = vec4(0.0, 0.0, 0.0, near * near); }",
      side: THREE.DoubleSide,
    });
    this.blur = new THREE.ShaderMaterial({
      uniforms: { map: { value: null }, stride: { value: new THREE.Vector2() } },
      vertexShader: "varying vec2 at; void main() { at = uv; gl_Position = vec4(position.xy, 0.0, 1.0); }",
      fragmentShader: BLUR,
      depthTest: false,
    });
    this.sheet = new THREE.Mesh(new THREE.PlaneGeometry(2, 2), this.blur);
    this.sheet.frustumCulled = false;
    const shown = new THREE.MeshBasicMaterial({
      map: this.target.texture, color: 0x000000, opacity: 0.5, transparent: true, depthWrite: false,
      toneMapped: false, side: THREE.BackSide,
    });
    // the picture from below is mirrored, because it is seen from above
    this.plane = new THREE.Mesh(new THREE.PlaneGeometry(across, across), shown);
    this.plane.rotation.x = Math.PI / 2;
    this.plane.position.set(middle.x, -size * 0.0006, middle.z);
    this.plane.renderOrder = -1;
  }

  /** Draws the shadow of the scene without the given nodes. */
  draw(hidden) {
    const { renderer, scene } = this;
    const shown = hidden.filter((node) => node.visible);
    for (const node of shown) node.visible = false;
    scene.overrideMaterial = this.depth;
    renderer.setRenderTarget(this.target);
    renderer.clear();
    renderer.render(scene, this.camera);
    scene.overrideMaterial = null;
    for (const node of shown) node.visible = true;
    for (const texels of [2.2, 1.1]) {
      this.smear(this.target, this.between, texels / SOFT_TEXELS, 0);
      this.smear(this.between, this.target, 0, texels / SOFT_TEXELS);
    }
    renderer.setRenderTarget(null);
  }

  smear(from, to, x, y) {
    this.blur.uniforms.map.value = from.texture;
    this.blur.uniforms.stride.value.set(x, y);
    this.renderer.setRenderTarget(to);
    this.renderer.render(this.sheet, this.camera);
  }
}
