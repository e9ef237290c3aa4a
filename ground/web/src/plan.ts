// The plan: the room from above with its walls, the way of the aircraft, and where it is to go. A click or Enter sets a point.

import { css } from "./colours";
import type { Point } from "./protocol";
import { onResize } from "./resize";

/** Distance between two points of the trail, m, and their largest number. */
const STEP = 0.03, LONGEST = 2000;

/** Room around the walls for the numbers of the axes, px. */
const MARGIN = 20;

export class Plan {
  private reach = 3;
  private cursor: [number, number] = [0, 0];
  private at: [number, number] = [0, 0];
  private wanted: [number, number] = [0, 0];
  private yaw = 0;
  private readonly trail: [number, number][] = [];
  private points: Point[] = [];
  /** The whole way of a recorded flight. */
  private way: [number, number][] = [];
  /** Time since the take-off, s; not a number on the ground. */
  private time = NaN;

  constructor(private readonly canvas: HTMLCanvasElement, chosen: (x: number, y: number) => void) {
    canvas.addEventListener("click", (event) => {
      const box = canvas.getBoundingClientRect();
      const part = (offset: number, length: number) => (offset - MARGIN) / (length - 2 * MARGIN) * 2 - 1;
      const within = (value: number) => Math.min(this.reach, Math.max(-this.reach, value));
      const x = within(part(event.clientX - box.left, box.width) * this.reach);
      const y = within(-part(event.clientY - box.top, box.height) * this.reach);
      this.cursor = [x, y];
      chosen(x, y);
    });
    canvas.addEventListener("keydown", (event) => {
      const steps: Record<string, [number, number]> =
        { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1] };
      const step = steps[event.key];
      if (step) {
        const within = (value: number) => Math.min(this.reach, Math.max(-this.reach, value));
        this.cursor = [within(this.cursor[0] + step[0]), within(this.cursor[1] + step[1])];
        event.preventDefault();
        this.draw();
      } else if (event.key === "Enter") {
        chosen(...this.cursor);
      }
    });
    onResize(canvas, () => this.draw());
  }

  set space(reach: number) { this.reach = reach; this.draw(); }

  /** Points of the trajectory on board. */
  get course(): Point[] { return this.points; }
  set course(points: Point[]) { this.points = points.map((point) => ({ ...point })); this.draw(); }

  show(at: [number, number], yaw: number, wanted: [number, number], time: number): void {
    const last = this.trail[this.trail.length - 1];
    if (!last || Math.hypot(at[0] - last[0], at[1] - last[1]) > STEP) this.trail.push(at);
    if (this.trail.length > LONGEST) this.trail.shift();
    [this.at, this.yaw, this.wanted, this.time] = [at, yaw, wanted, time];
    this.draw();
  }

  /** Shows the whole way of a recorded flight. */
  set recorded(way: [number, number][]) { this.way = way; this.draw(); }

  /** Number of the point that is flown to at a time since the take-off, s, from 1; 0 before the first, or without points. */
  static reached(points: Point[], time: number): number {
    return points.filter((point) => point.time <= time).length;
  }

  /** Begins a new trail. */
  forget(): void { this.trail.length = 0; }

  private draw(): void {
    const { canvas, reach } = this;
    const scale = Math.min(devicePixelRatio, 2), size = canvas.clientWidth * scale;
    if (canvas.width !== size) canvas.width = canvas.height = size;
    const paper = canvas.getContext("2d");
    if (!paper || size === 0) return;
    const margin = MARGIN * scale, room = size - 2 * margin;
    const place = ([x, y]: [number, number]): [number, number] =>
      [margin + (x / reach + 1) * room / 2, margin + (1 - y / reach) * room / 2];
    paper.fillStyle = css("--panel");
    paper.fillRect(0, 0, size, size);
    paper.strokeStyle = css("--line");
    paper.lineWidth = scale;
    paper.beginPath();
    const [west, south] = place([-reach, -reach]), [east, north] = place([reach, reach]);
    paper.font = `${11 * scale}px system-ui`;
    paper.textAlign = "center";
    for (let metre = -Math.floor(reach); metre <= reach; metre += 1) {
      const [x, y] = place([metre, metre]);
      paper.moveTo(x, north); paper.lineTo(x, south); paper.moveTo(west, y); paper.lineTo(east, y);
      paper.fillStyle = css("--quiet");
      paper.fillText(`${metre}`, x, south + 13 * scale);
      paper.fillText(`${metre}`, west - 10 * scale, y + 4 * scale);
    }
    paper.stroke();
    // The walls.
    paper.strokeStyle = css("--quiet");
    paper.lineWidth = 2 * scale;
    paper.strokeRect(west, north, east - west, south - north);
    paper.fillStyle = css("--quiet");
    paper.fillText("x, m →", east - 22 * scale, south - 6 * scale);
    paper.fillText("y, m ↑", west + 24 * scale, north + 14 * scale);
    const path = (points: [number, number][], colour: string, dash: number[]) => {
      paper.beginPath();
      points.forEach((point) => paper.lineTo(...place(point)));
      paper.strokeStyle = css(colour);
      paper.lineWidth = 1.5 * scale;
      paper.setLineDash(dash);
      paper.stroke();
      paper.setLineDash([]);
    };
    path(this.way, "--grid", []);
    path(this.trail, "--one", []);
    path(this.points.map(({ x, y }) => [x, y]), "--wanted", [4 * scale, 4 * scale]);
    this.points.forEach(({ x, y, time }, n) => {
      const [across, down] = place([x, y]), reached = this.time >= time;
      paper.beginPath();
      paper.arc(across, down, 3 * scale, 0, 2 * Math.PI);
      paper.fillStyle = css(reached ? "--quiet" : "--wanted");
      paper.fill();
      paper.fillText(`${n + 1}`, across + 9 * scale, down - 6 * scale);
    });
    const ring = (where: [number, number], radius: number, colour: string, full: boolean) => {
      const [x, y] = place(where);
      paper.beginPath();
      paper.arc(x, y, radius * scale, 0, 2 * Math.PI);
      paper.lineWidth = 2 * scale;
      paper.strokeStyle = paper.fillStyle = css(colour);
      if (full) paper.fill(); else paper.stroke();
    };
    ring(this.wanted, 8, "--wanted", false);
    ring(this.at, 5, "--one", true);
    // The nose.
    const [x, y] = place(this.at), length = 16 * scale;
    paper.beginPath();
    paper.moveTo(x, y);
    // Yaw counts clockwise, seen from above.
    paper.lineTo(x + length * Math.cos(this.yaw), y + length * Math.sin(this.yaw));
    paper.stroke();
    if (document.activeElement === canvas) ring(this.cursor, 4, "--quiet", false);
  }
}
