// A viewer of the tiles at `/city/tileset.json`. A click shows the attributes of a building.

import { GLTFExtensionsPlugin, ReorientationPlugin } from "3d-tiles-renderer/three/plugins";
import { TilesRenderer } from "3d-tiles-renderer/three";
import {
    DirectionalLight, HemisphereLight, PerspectiveCamera, Raycaster, Scene, Sphere, Triangle, Vector2, Vector3, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";

const renderer = new WebGLRenderer({ antialias: true, logarithmicDepthBuffer: true });
renderer.setClearColor(0xcfdde8);
document.body.append(renderer.domElement);
const scene = new Scene();
const sun = new DirectionalLight(0xffffff, 2);
sun.position.set(1, 2, 1.5);
scene.add(new HemisphereLight(0xffffff, 0x887766, 1.4), sun);
const camera = new PerspectiveCamera(50, 1, 1, 1e6);
const controls = new OrbitControls(camera, renderer.domElement);
controls.maxPolarAngle = 1.5;

const tiles = new TilesRenderer("city/tileset.json");
tiles.registerPlugin(new GLTFExtensionsPlugin({ metadata: true }));
tiles.registerPlugin(new ReorientationPlugin({ recenter: true }));
tiles.setCamera(camera);
scene.add(tiles.group);

const errors = [];
const state = document.getElementById("state");
tiles.addEventListener("load-error", ({ error, url }) => errors.push(`${url ?? ""} ${error}`));

/** Looks at the middle of the city from a distance in metres. */
function lookFrom(metres) {
    controls.target.set(0, 0, 0);
    camera.position.set(0.3, 0.75, 0.6).normalize().multiplyScalar(metres);
    controls.update();
}

let isPlaced = false;
function place() {
    const sphere = new Sphere();
    if (isPlaced || !tiles.getBoundingSphere(sphere)) return;
    isPlaced = true;
    lookFrom(1.6 * sphere.radius);
}
tiles.addEventListener("load-root-tileset", place);
tiles.addEventListener("load-tileset", place);

function resize() {
    const { innerWidth: width, innerHeight: height } = window;
    renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    renderer.setSize(width, height);
    camera.aspect = width / height;
    camera.updateProjectionMatrix();
    tiles.setResolutionFromRenderer(camera, renderer);
}
window.addEventListener("resize", resize);
resize();

/** A value of an object, or of the nearest object around it that has one. */
function inherited(object, name) {
    for (let at = object; at; at = at.parent) if (at.userData[name] !== undefined) return at.userData[name];
    return undefined;
}

/** The tables and the rows of the features at a hit. */
async function featuresAt(hit) {
    const { meshFeatures } = hit.object.userData;
    if (!meshFeatures) {
        // A mesh that rules insert several times has nodes with the numbers of their buildings.
        const building = inherited(hit.object, "building");
        return building === undefined ? [[], []] : [[0], [building]];
    }
    const { geometry } = hit.object;
    const corner = (number) => new Vector3().fromBufferAttribute(geometry.attributes.position, geometry.index ? geometry.index.getX(number) : number);
    const triangle = new Triangle(...[0, 1, 2].map((at) => corner(3 * hit.faceIndex + at)));
    const weights = triangle.getBarycoord(hit.object.worldToLocal(hit.point.clone()), new Vector3());
    const rows = await meshFeatures.getFeaturesAsync(hit.faceIndex, weights);
    return [meshFeatures.getFeatureInfo().map((info) => info.propertyTable), rows];
}

/** The metadata of the building at a place of the page, or null. */
async function buildingAt(x, y) {
    const caster = new Raycaster();
    caster.firstHitOnly = true;
    caster.setFromCamera(new Vector2((2 * x) / innerWidth - 1, 1 - (2 * y) / innerHeight), camera);
    const [hit] = caster.intersectObject(tiles.group, true);
    if (!hit) return null;
    const structuralMetadata = inherited(hit.object, "structuralMetadata");
    if (!structuralMetadata) return null;
    const rows = structuralMetadata.getPropertyTableData(...(await featuresAt(hit)));
    const row = rows.find((row) => "seed" in row);
    // Seeds have 64 bits.
    return row ? Object.fromEntries(Object.entries(row).map(([name, value]) => [name, typeof value === "bigint" ? String(value) : value])) : null;
}

async function show(x, y) {
    const card = document.getElementById("card");
    card.textContent = "";
    const building = await buildingAt(x, y);
    if (!building) return null;
    const table = document.createElement("table");
    for (const [name, value] of Object.entries(building)) {
        const row = table.insertRow();
        row.insertCell().textContent = name;
        row.insertCell().textContent = String(value);
    }
    card.append(table);
    return building;
}

let pressed = null;
renderer.domElement.addEventListener("pointerdown", ({ clientX, clientY }) => (pressed = [clientX, clientY]));
renderer.domElement.addEventListener("pointerup", ({ clientX, clientY }) => {
    if (pressed && Math.hypot(clientX - pressed[0], clientY - pressed[1]) < 4) show(clientX, clientY);
});

/** The numbers of tiles, for the line at the bottom and for tests. */
function numbers() {
    const { downloading = 0, parsing = 0, queued = 0, failed = 0 } = tiles.stats;
    return { waiting: downloading + parsing + queued, failed, visible: tiles.visibleTiles.size, errors, isPlaced };
}

renderer.setAnimationLoop(() => {
    controls.update();
    camera.updateMatrixWorld();
    tiles.update();
    renderer.render(scene, camera);
    const { waiting, failed, visible } = numbers();
    state.textContent = `${visible} tiles` + (waiting ? `, ${waiting} to come` : "") + (failed ? `, ${failed} failed` : "");
});

window.city = { numbers, lookFrom, show, deepest: () => Math.max(0, ...[...tiles.visibleTiles].map((tile) => tile.internal?.depth ?? tile.__depth ?? 0)) };
