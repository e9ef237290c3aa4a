// The plan: the room from above, and where the aircraft is to go. A click or Enter sets a point.

import { css } from "./colours";
import { onResize } from "./resize";

export class Plan {
  private reach = 3;
  private cursor: [number, number] = [0, 0];
  private at: [number, number] = [0, 0];
  private wanted: [number, number] = [0, 0];

  constructor(private readonly canvas: HTMLCanvasElement, chosen: (x: number, y: number) => void) {
    canvas.addEventListener("click", (event) => {
      const box = canvas.getBoundingClientRect();
      const x = ((event.clientX - box.left) / box.width * 2 - 1) * this.reach;
      const y = (1 - (event.clientY - box.top) / box.height * 2) * this.reach;
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

  show(at: [number, number], wanted: [number, number]): void {
    this.at = at;
    this.wanted = wanted;
    this.draw();
  }

  private draw(): void {
    const { canvas, reach } = this;
    const scale = Math.min(devicePixelRatio, 2), size = canvas.clientWidth * scale;
    if (canvas.width !== size) canvas.width = canvas.height = size;
    const paper = canvas.getContext("2d");
    if (!paper || size === 0) return;
    const place = ([x, y]: [number, number]): [number, number] => [(x / reach + 1) * size / 2, (1 - y / reach) * size / 2];
    paper.fillStyle = css("--panel");
    paper.fillRect(0, 0, size, size);
    paper.strokeStyle = css("--line");
    paper.lineWidth = scale;
    paper.beginPath();
    for (let metre = -reach; metre <= reach; metre += 1) {
      const [x, y] = place([metre, metre]);
      paper.moveTo(x, 0); paper.lineTo(x, size); paper.moveTo(0, y); paper.lineTo(size, y);
    }
    paper.stroke();
    paper.fillStyle = css("--quiet");
    paper.font = `${11 * scale}px system-ui`;
    paper.fillText("x →", size - 30 * scale, size / 2 - 4 * scale);
    paper.fillText("y ↑", size / 2 + 4 * scale, 14 * scale);
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
    if (document.activeElement === canvas) ring(this.cursor, 4, "--quiet", false);
  }
}
