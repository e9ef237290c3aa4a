// The artificial horizon: roll and pitch as the pilot sees them, and the heading on a tape below.

import { css } from "./colours";
import { onResize } from "./resize";

/** Pitch from the middle of the dial to its edge, rad. */
const PITCH = 0.6;

export class Horizon {
  private roll = 0;
  private pitch = 0;
  private heading = 0;

  constructor(private readonly canvas: HTMLCanvasElement) {
    onResize(canvas, () => this.draw());
  }

  /** Angles of the thesis, rad: a positive roll lowers the left side, and a positive pitch raises the nose. */
  show(roll: number, pitch: number, yaw: number): void {
    [this.roll, this.pitch, this.heading] = [-roll, pitch, yaw];
    this.draw();
  }

  private draw(): void {
    const { canvas } = this;
    const scale = Math.min(devicePixelRatio, 2), width = canvas.clientWidth * scale, tape = 18 * scale;
    if (canvas.width !== width) [canvas.width, canvas.height] = [width, width + tape];
    const paper = canvas.getContext("2d");
    if (!paper || width === 0) return;
    const middle = width / 2, radius = middle - scale;
    paper.clearRect(0, 0, width, canvas.height);
    paper.save();
    paper.beginPath();
    paper.arc(middle, middle, radius, 0, 2 * Math.PI);
    paper.clip();
    paper.translate(middle, middle);
    paper.rotate(-this.roll);
    const level = Math.max(-2, Math.min(2, this.pitch / PITCH)) * radius;
    paper.fillStyle = css("--sky");
    paper.fillRect(-2 * radius, -4 * radius, 4 * radius, 4 * radius + level);
    paper.fillStyle = css("--ground");
    paper.fillRect(-2 * radius, level, 4 * radius, 4 * radius);
    paper.strokeStyle = "#ffffff";
    paper.lineWidth = 1.5 * scale;
    paper.beginPath();
    paper.moveTo(-2 * radius, level);
    paper.lineTo(2 * radius, level);
    // A line for each 10\u00b0 of pitch.
    for (let n = -3; n <= 3; n += 1) {
      const y = level - n * radius * (Math.PI / 18) / PITCH, half = radius * (n === 0 ? 0 : 0.18);
      paper.moveTo(-half, y);
      paper.lineTo(half, y);
    }
    paper.stroke();
    paper.restore();
    // The aircraft, which stays where it is.
    paper.strokeStyle = css("--wanted");
    paper.lineWidth = 2.5 * scale;
    paper.beginPath();
    paper.moveTo(middle - 0.5 * radius, middle);
    paper.lineTo(middle - 0.15 * radius, middle);
    paper.moveTo(middle + 0.15 * radius, middle);
    paper.lineTo(middle + 0.5 * radius, middle);
    paper.moveTo(middle, middle);
    paper.arc(middle, middle, scale, 0, 2 * Math.PI);
    paper.stroke();
    paper.fillStyle = css("--ink");
    paper.font = `600 ${11 * scale}px system-ui`;
    paper.textAlign = "center";
    const degrees = Math.round(this.heading * 180 / Math.PI) || 0;
    paper.fillText(`yaw ${degrees}\u00b0`, middle, width + tape - 5 * scale);
  }
}
