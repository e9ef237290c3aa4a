// The aircraft in space: as it is estimated, as it truly is (a ghost), and where it is wanted.

import {
  AmbientLight, BoxGeometry, Color, CylinderGeometry, DirectionalLight, Euler, GridHelper, Group, Line,
  BufferGeometry, LineBasicMaterial, Matrix4, Mesh, MeshBasicMaterial, MeshLambertMaterial, PerspectiveCamera, Quaternion, Scene as World,
  SphereGeometry, TorusGeometry, Vector3, WebGLRenderer,
} from "three";

import { css } from "./colours";
import { onResize } from "./resize";

/** Where the camera stands from what it looks at, m. */
const STAND = new Vector3(2.6, -3.4, 1.7);

/** Rotation from the body to the room at roll, pitch and yaw: R = C1 C2 C3 of passive turns (thesis, eq. (2.11)). */
function attitude(roll: number, pitch: number, yaw: number): Quaternion {
  const turn = (x: number, y: number, z: number) => new Matrix4().makeRotationFromEuler(new Euler(x, y, z));
  const all = turn(-roll, 0, 0).multiply(turn(0, -pitch, 0)).multiply(turn(0, 0, -yaw));
  return new Quaternion().setFromRotationMatrix(all);
}

export class Scene {
  private readonly renderer: WebGLRenderer | undefined;
  private readonly world = new World();
  private readonly camera = new PerspectiveCamera(40, 1, 0.05, 60);
  private aircraft: Group;
  private ghost: Group;
  private readonly wanted: Mesh;
  private readonly trail: Vector3[] = [];
  private readonly line = new Line(new BufferGeometry(), new LineBasicMaterial());
  private readonly grid = new GridHelper(6, 12);

  constructor(private readonly canvas: HTMLCanvasElement) {
    try {
      // Smooth edges, unless the processor has to draw them.
      this.renderer = new WebGLRenderer({ canvas, antialias: !drawnBySoftware(), preserveDrawingBuffer: false });
    } catch {
      // No WebGL: plan and plots say the same.
      canvas.hidden = true;
    }
    // z is upwards.
    this.camera.up.set(0, 0, 1);
    this.follow(0, 0);
    this.grid.rotateX(Math.PI / 2);
    const sun = new DirectionalLight(0xffffff, 2.2);
    sun.position.set(2, -3, 6);
    this.aircraft = craft(false, 4);
    this.ghost = craft(true, 4);
    this.wanted = new Mesh(new SphereGeometry(0.05, 12, 8), new MeshBasicMaterial());
    this.world.add(new AmbientLight(0xffffff, 1.4), sun, this.grid, this.aircraft, this.ghost, this.wanted, this.line);
    onResize(canvas.parentElement ?? canvas, () => this.resize());
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.colour());
    this.colour();
  }

  /** Estimated and true place (m) and angles (rad), and the wanted place. */
  show(now: Float64Array, truth: number[], wanted: [number, number, number]): void {
    const finite = (value: number | undefined) => value !== undefined && Number.isFinite(value) ? value : 0;
    this.aircraft.position.set(finite(now[0]), finite(now[1]), finite(now[2]));
    this.aircraft.quaternion.copy(attitude(finite(now[3]), finite(now[4]), finite(now[5])));
    this.ghost.position.set(finite(truth[0]), finite(truth[1]), finite(truth[2]));
    this.ghost.quaternion.copy(attitude(finite(truth[3]), finite(truth[4]), finite(truth[5])));
    this.wanted.position.set(...wanted);
    const last = this.trail[this.trail.length - 1];
    if (!last || last.distanceTo(this.aircraft.position) > 0.02) {
      this.trail.push(this.aircraft.position.clone());
      if (this.trail.length > 400) this.trail.shift();
      this.line.geometry.dispose();
      this.line.geometry = new BufferGeometry().setFromPoints(this.trail);
    }
    this.follow(this.aircraft.position.x, this.aircraft.position.y);
    this.renderer?.render(this.world, this.camera);
  }

  /** Draws an aircraft by the number of its motors. */
  set motors(count: number) {
    this.world.remove(this.aircraft, this.ghost);
    [this.aircraft, this.ghost] = [craft(false, count), craft(true, count)];
    this.world.add(this.aircraft, this.ghost);
  }

  /** Goes along with the aircraft, not quite as far, so that it is seen to move. */
  private follow(x: number, y: number): void {
    const middle = new Vector3(0.7 * x, 0.7 * y, 0.7);
    this.camera.position.copy(middle).add(STAND);
    this.camera.lookAt(middle);
  }

  forget(): void { this.trail.length = 0; }

  private resize(): void {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (width === 0 || height === 0) return;
    this.renderer?.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer?.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
  }

  private colour(): void {
    this.world.background = new Color(css("--panel"));
    (this.wanted.material as MeshBasicMaterial).color = new Color(css("--wanted"));
    (this.line.material as LineBasicMaterial).color = new Color(css("--one"));
    const grid = this.grid.material as LineBasicMaterial;
    grid.vertexColors = false;
    grid.color = new Color(css("--grid"));
    grid.needsUpdate = true;
  }
}

/** Whether there is no graphics processor behind WebGL. */
function drawnBySoftware(): boolean {
  const probe = document.createElement("canvas").getContext("webgl2");
  const told = probe?.getExtension("WEBGL_debug_renderer_info");
  const name = told ? String(probe?.getParameter(told.UNMASKED_RENDERER_WEBGL)) : "";
  probe?.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|software/i.test(name);
}

/** A multicopter, larger than it is so that its attitude can be seen; its front is the red arms. */
function craft(ghost: boolean, motors: number): Group {
  const group = new Group();
  const paint = (colour: number) => new MeshLambertMaterial(
    { color: colour, transparent: ghost, opacity: ghost ? 0.25 : 1 });
  group.add(new Mesh(new BoxGeometry(0.16, 0.1, 0.05), paint(0x6a7280)));
  for (let n = 0; n < motors; n += 1) {
    const angle = Math.PI * (2 * n + 1) / motors;
    const front = Math.cos(angle) > 0.5;
    const colour = front ? 0xd1453b : 0x4b5563;
    const arm = new Mesh(new CylinderGeometry(0.012, 0.012, 0.22, 8), paint(colour));
    arm.position.set(Math.cos(angle) * 0.12, Math.sin(angle) * 0.12, 0);
    arm.rotation.z = angle - Math.PI / 2;
    const ring = new Mesh(new TorusGeometry(0.085, 0.008, 5, 24), paint(colour));
    ring.position.set(Math.cos(angle) * 0.23, Math.sin(angle) * 0.23, 0.02);
    group.add(arm, ring);
  }
  return group;
}
