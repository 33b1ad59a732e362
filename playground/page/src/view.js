// The view: three.js, drawn only when something changes.

import {
  AgXToneMapping, BackSide, BufferAttribute, BufferGeometry, CircleGeometry, Color, DirectionalLight, DoubleSide, EdgesGeometry,
  HemisphereLight, LineBasicMaterial, LineSegments, Mesh, MeshBasicMaterial, PCFShadowMap, PerspectiveCamera, PMREMGenerator,
  Raycaster, Scene, ShadowMaterial, SphereGeometry, Spherical, Vector2, Vector3, WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import { GLTFLoader } from 'three/examples/jsm/loaders/GLTFLoader.js';

const ACCENT = 0xff8a1f;
const RADIANS = Math.PI / 180;

/** Milliseconds without another model after which shadows are drawn. */
const CALM = 250;

/** The corners of a box. */
const corners = (from, to) => Array.from({ length: 8 }, (_, corner) => new Vector3(...[0, 1, 2].map((axis) => (corner & (1 << axis) ? to : from).getComponent(axis))));

export class View {
  /** `onPick(origin, direction)` gets a ray, `onMove` is called when the camera stops. */
  constructor(parent, { onPick, onMove, onCancel }) {
    this.parent = parent;
    this.renderer = new WebGLRenderer({ antialias: true, alpha: true });
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.renderer.toneMapping = AgXToneMapping;
    this.renderer.toneMappingExposure = 1.25;
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = PCFShadowMap;
    // Shadows change with the model, not with the camera.
    this.renderer.shadowMap.autoUpdate = false;
    parent.append(this.renderer.domElement);
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(30, 1, 0.1, 5000);
    this.loader = new GLTFLoader();
    this.addLight();
    this.renderer.domElement.addEventListener('webglcontextrestored', () => this.restore());
    this.controls = new OrbitControls(this.camera, this.renderer.domElement);
    this.controls.maxPolarAngle = 0.52 * Math.PI;
    this.controls.addEventListener('change', () => this.draw());
    this.controls.addEventListener('end', onMove);
    /** The corners of the box that must be in the view, and the bounds of its model. */
    this.region = null;
    this.addPointer(onPick);
    this.addKeys(onMove, onCancel);
    new ResizeObserver(() => this.resize()).observe(parent);
    this.resize();
  }

  addLight() {
    this.scene.add(new HemisphereLight(0xdfeaf5, 0xb8ab97, 0.9));
    this.sun = new DirectionalLight(0xfff1dc, 2.6);
    this.sun.castShadow = true;
    this.sun.shadow.mapSize.set(2048, 2048);
    this.scene.add(this.sun, this.sun.target);
    this.ground = new Mesh(new CircleGeometry(1, 64).rotateX(-Math.PI / 2), new ShadowMaterial({ opacity: 0.28 }));
    this.ground.receiveShadow = true;
    this.scene.add(this.ground);
  }

  /** Adds reflections of a sky. They take long to compute without a graphics processor, so the first model does not wait for them. */
  addSky() {
    this.scene.environment?.dispose();
    this.scene.environment = sky(this.renderer);
    this.scene.environmentIntensity = 0.55;
    this.draw();
  }

  /** Draws shadows and reflections again, which are lost with the context. */
  restore() {
    this.fence = null;
    this.sun.shadow.map?.dispose();
    this.sun.shadow.map = null;
    if (this.scene.environment) this.addSky();
    this.drawShadows();
  }

  /** A click without a drag picks. */
  addPointer(onPick) {
    const canvas = this.renderer.domElement;
    let start = null;
    canvas.addEventListener('pointerdown', (event) => (start = event.button === 0 ? [event.clientX, event.clientY] : null));
    canvas.addEventListener('pointerup', (event) => {
      if (start && Math.hypot(event.clientX - start[0], event.clientY - start[1]) < 4) {
        const box = canvas.getBoundingClientRect();
        const x = ((event.clientX - box.left) / box.width) * 2 - 1;
        const y = 1 - ((event.clientY - box.top) / box.height) * 2;
        const { origin, direction } = this.ray(x, y);
        onPick(origin.toArray(), direction.toArray());
      }
      start = null;
    });
  }

  ray(x, y) {
    const caster = new Raycaster();
    this.camera.updateMatrixWorld();
    caster.setFromCamera(new Vector2(x, y), this.camera);
    return caster.ray;
  }

  addKeys(onMove, onCancel) {
    const turns = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
    this.parent.addEventListener('keydown', (event) => {
      const turn = turns[event.key];
      const zoom = { '+': 1 / 1.15, '=': 1 / 1.15, '-': 1.15 }[event.key];
      if (event.key === 'Escape') onCancel();
      if (!turn && !zoom) return;
      event.preventDefault();
      const offset = new Spherical().setFromVector3(this.camera.position.clone().sub(this.controls.target));
      offset.theta += 0.1 * (turn?.[0] ?? 0);
      offset.phi = Math.min(Math.max(offset.phi + 0.07 * (turn?.[1] ?? 0), 0.05), this.controls.maxPolarAngle);
      offset.radius *= zoom ?? 1;
      this.camera.position.setFromSpherical(offset).add(this.controls.target);
      this.controls.update();
      onMove();
    });
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.parent;
    if (!width || !height) return;
    this.renderer.setSize(width, height);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  /**
   * Draws the next frame, when the last one is finished: without a graphics processor a frame takes long, and a second one would block the
   * page until then.
   */
  draw() {
    this.frame ??= requestAnimationFrame(() => this.drawNow());
  }

  drawNow() {
    const gl = this.renderer.getContext();
    const isOpen = this.fence && !gl.isContextLost() && gl.getSyncParameter(this.fence, gl.SYNC_STATUS) !== gl.SIGNALED;
    if (isOpen) {
      this.frame = setTimeout(() => this.drawNow(), 5);
      return;
    }
    if (this.fence) gl.deleteSync(this.fence);
    this.frame = null;
    this.renderer.render(this.scene, this.camera);
    this.fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
  }

  /**
   * Shows the bytes of a GLB file. `bounds` are its lowest and highest corner. Shadows follow when the model has not changed for a
   * moment: without a graphics processor they take long.
   */
  async show(glb, { low, high }) {
    const { scene: model } = await this.loader.parseAsync(glb.buffer, '');
    model.traverse((object) => {
      if (object.isMesh) object.castShadow = object.receiveShadow = true;
    });
    if (this.model) remove(this.scene, this.model);
    const isFirst = !this.model;
    this.model = model;
    this.scene.add(model);
    this.highlight(null);
    this.bounds = [new Vector3(...low), new Vector3(...high)];
    if (isFirst) this.light();
    else this.lightSoon();
    this.grow();
    this.draw();
  }

  /** Fits the shadows when no other model has come for a moment, and after a slider is let go. */
  lightSoon() {
    clearTimeout(this.calm);
    this.isLate = true;
    if (!this.isHeld) this.calm = setTimeout(() => this.light(), CALM);
  }

  /** Tells that a slider is dragged, or let go. */
  hold(isHeld) {
    const isLetGo = this.isHeld && !isHeld;
    this.isHeld = isHeld;
    if (isHeld) clearTimeout(this.calm);
    if (isLetGo && this.isLate) this.lightSoon();
  }

  /** Moves the camera back if a model that was in the view as a whole has grown out of it. */
  grow() {
    const { region, bounds: [low, high] } = this;
    if (!region) return;
    const [from, to] = [region.from.clone(), region.to.clone()];
    from.add(low.clone().sub(region.low).min(new Vector3()));
    to.add(high.clone().sub(region.high).max(new Vector3()));
    if (from.equals(region.from) && to.equals(region.to)) return;
    if (this.sees(region.from, region.to) && !this.sees(from, to)) this.fit(from, to, this.camera.position.clone().sub(this.controls.target).normalize());
    this.region = { from, to, low: low.clone().min(region.low), high: high.clone().max(region.high) };
  }

  /** True if the corners of a box are in the view. */
  sees(from, to) {
    this.camera.updateMatrixWorld();
    return corners(from, to).every((corner) => {
      const { x, y } = corner.project(this.camera);
      return Math.max(Math.abs(x), Math.abs(y)) < 1.03;
    });
  }

  /** Fits the shadows to the model. */
  light() {
    clearTimeout(this.calm);
    this.isLate = false;
    const [low, high] = this.bounds;
    const middle = low.clone().add(high).multiplyScalar(0.5);
    const radius = Math.max(low.distanceTo(high) / 2, 0.5);
    const azimuth = this.sunAzimuth ?? 0;
    const elevation = this.sunElevation ?? 45 * RADIANS;
    const toSun = new Vector3(Math.sin(azimuth) * Math.cos(elevation), Math.sin(elevation), Math.cos(azimuth) * Math.cos(elevation));
    this.sun.position.copy(middle).addScaledVector(toSun, 2 * radius);
    this.sun.target.position.copy(middle);
    const { camera, map } = this.sun.shadow;
    [camera.left, camera.right, camera.bottom, camera.top] = [-radius, radius, -radius, radius];
    [camera.near, camera.far] = [0.5 * radius, 3.5 * radius];
    camera.updateProjectionMatrix();
    this.sun.shadow.normalBias = map ? (2 * radius) / map.width : radius / 1024;
    this.sun.shadow.bias = -0.0004;
    this.ground.position.set(middle.x, low.y - 0.002 * radius, middle.z);
    this.ground.scale.setScalar(6 * radius);
    [this.camera.near, this.camera.far] = [radius / 200, radius * 60];
    this.camera.updateProjectionMatrix();
    this.controls.minDistance = radius / 20;
    this.controls.maxDistance = radius * 20;
    this.drawShadows();
  }

  drawShadows() {
    this.renderer.shadowMap.needsUpdate = true;
    this.parent.dataset.shadows = String(Number(this.parent.dataset.shadows ?? 0) + 1);
    this.draw();
  }

  /** Sets the camera and the sun of a grammar: angles, and the region that must be seen. */
  frameView(view, { low, high }) {
    const [from, to] = (view.region ?? [low, high]).map((corner) => new Vector3(...corner));
    const [azimuth, elevation] = [view.azimuth * RADIANS, view.elevation * RADIANS];
    this.sunAzimuth = azimuth + view.sunAzimuth * RADIANS;
    this.sunElevation = view.sunElevation * RADIANS;
    this.camera.fov = view.fieldOfView;
    this.camera.updateProjectionMatrix();
    const back = new Vector3(Math.sin(azimuth) * Math.cos(elevation), Math.sin(elevation), Math.cos(azimuth) * Math.cos(elevation));
    this.bounds = [new Vector3(...low), new Vector3(...high)];
    this.region = { from, to, low: this.bounds[0].clone(), high: this.bounds[1].clone() };
    this.light();
    this.fit(from, to, back);
  }

  /** Moves the camera along a direction so far that the corners of a box are in the view. */
  fit(from, to, back) {
    const middle = from.clone().add(to).multiplyScalar(0.5);
    const radius = Math.max(from.distanceTo(to) / 2, 0.5);
    this.controls.maxDistance = Math.max(this.controls.maxDistance, 20 * radius);
    this.camera.far = Math.max(this.camera.far, 60 * radius);
    this.controls.target.copy(middle);
    this.camera.position.copy(middle).add(back);
    this.camera.lookAt(middle);
    this.camera.updateProjectionMatrix();
    this.camera.updateMatrixWorld();
    const half = Math.tan((this.camera.fov / 2) * RADIANS);
    const wide = half * this.camera.aspect;
    // The notes above and below take 48 pixels each.
    const tall = half * Math.max(1 - 96 / this.parent.clientHeight, 0.5);
    const turn = this.camera.quaternion.clone().invert();
    let distance = 0;
    for (const corner of corners(from, to)) {
      const seen = corner.sub(middle).applyQuaternion(turn);
      distance = Math.max(distance, seen.z + Math.abs(seen.x) / wide, seen.z + Math.abs(seen.y) / tall);
    }
    this.camera.position.copy(middle).addScaledVector(back, 1.05 * distance);
    this.controls.update();
    this.draw();
  }

  /** The camera as six numbers: its place, and the point that it looks at. */
  get cameraNumbers() {
    return [...this.camera.position.toArray(), ...this.controls.target.toArray()];
  }

  set cameraNumbers(numbers) {
    this.camera.position.fromArray(numbers);
    this.controls.target.fromArray(numbers, 3);
    this.controls.update();
    this.draw();
  }

  /** Marks triangles, nine numbers each; null marks none. */
  highlight(triangles) {
    if (this.marked) remove(this.scene, ...this.marked);
    this.marked = null;
    if (triangles?.length) {
      const geometry = new BufferGeometry().setAttribute('position', new BufferAttribute(triangles, 3));
      const fill = new MeshBasicMaterial({
        color: ACCENT, transparent: true, opacity: 0.55, side: DoubleSide, depthWrite: false, toneMapped: false,
        polygonOffset: true, polygonOffsetFactor: -2, polygonOffsetUnits: -2,
      });
      const line = new LineBasicMaterial({ color: ACCENT, toneMapped: false, depthTest: false, transparent: true, opacity: 0.9 });
      this.marked = [new Mesh(geometry, fill)];
      // Outlines of thousands of leaves would cover everything.
      if (triangles.length < 9 * 2000) this.marked.push(new LineSegments(new EdgesGeometry(geometry, 20), line));
      this.scene.add(...this.marked);
    }
    this.draw();
  }
}

/** In place of the view where there is no WebGL: a sentence. */
export class NoView {
  constructor(parent) {
    this.parent = parent;
    const note = document.createElement('p');
    note.id = 'no-view';
    note.textContent = 'This browser does not draw with WebGL, so there is no picture. Everything else works: rules, values, parts, reports and files.';
    parent.append(note);
    this.cameraNumbers = null;
  }

  async show() {}
  frameView() {}
  addSky() {}
  highlight() {}
  hold() {}
}

/** Removes objects and frees what they hold on the graphics processor. */
function remove(scene, ...objects) {
  for (const object of objects) {
    scene.remove(object);
    object.traverse((part) => {
      part.geometry?.dispose();
      for (const material of [part.material ?? []].flat()) {
        for (const value of Object.values(material)) if (value?.isTexture) value.dispose();
        material.dispose();
      }
    });
  }
}

/** The image that smooth surfaces reflect: a sky that is brighter at the horizon. */
function sky(renderer) {
  const geometry = new SphereGeometry(10, 32, 24);
  const position = geometry.getAttribute('position');
  const colors = new Float32Array(3 * position.count);
  const [ground, horizon, zenith] = [new Color(0x8f8677), new Color(0xf2f0ea), new Color(0x6f9fc8)];
  for (let at = 0; at < position.count; at++) {
    const height = position.getY(at) / 10;
    const color = height < -0.05 ? ground : horizon.clone().lerp(zenith, Math.sqrt(Math.max(height, 0)));
    color.toArray(colors, 3 * at);
  }
  geometry.setAttribute('color', new BufferAttribute(colors, 3));
  const material = new MeshBasicMaterial({ vertexColors: true, side: BackSide });
  const scene = new Scene().add(new Mesh(geometry, material));
  const generator = new PMREMGenerator(renderer);
  // The sky is smooth, so a small image is enough.
  const { texture } = generator.fromScene(scene, 0, 0.1, 100, { size: 64 });
  generator.dispose();
  geometry.dispose();
  material.dispose();
  return texture;
}
