// The artificial horizon: roll and pitch as the pilot sees them, and the heading on a tape below.

import { css } from "./colours";
import { onResize } from "./resize";

/** Pitch from the middle of the dial to its edge, rad. */
const PITCH = 0.6;

/** Height of the tape with the heading, px. */
const TAPE = 22;

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
    const scale = Math.min(devicePixelRatio, 2), width = canvas.clientWidth * scale, tape = (TAPE + 18) * scale;
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
    this.tape(paper, scale, middle, width);
  }

  /** The heading, on a tape that moves behind a mark: the room's x is 0\u00b0, counted clockwise. */
  private tape(paper: CanvasRenderingContext2D, scale: number, middle: number, top: number): void {
    const degrees = this.heading * 180 / Math.PI, pixels = middle / 60, edge = top + 4 * scale;
    paper.save();
    paper.beginPath();
    paper.rect(0, top, 2 * middle, TAPE * scale);
    paper.clip();
    paper.strokeStyle = paper.fillStyle = css("--ink");
    paper.lineWidth = scale;
    paper.font = `${9 * scale}px system-ui`;
    paper.textAlign = "center";
    paper.beginPath();
    for (let mark = 10 * Math.ceil((degrees - 60) / 10); mark <= degrees + 60; mark += 10) {
      const x = middle + (mark - degrees) * pixels;
      paper.moveTo(x, edge);
      paper.lineTo(x, edge + (mark % 30 === 0 ? 6 : 3) * scale);
      if (mark % 30 === 0) paper.fillText(`${(mark % 360 + 360) % 360}`, x, edge + 15 * scale);
    }
    paper.stroke();
    paper.restore();
    paper.fillStyle = css("--wanted");
    paper.beginPath();
    paper.moveTo(middle, edge);
    paper.lineTo(middle - 4 * scale, top);
    paper.lineTo(middle + 4 * scale, top);
    paper.fill();
    paper.fillStyle = css("--ink");
    paper.font = `600 ${11 * scale}px system-ui`;
    paper.textAlign = "center";
    paper.fillText(`heading ${(Math.round(degrees) % 360 + 360) % 360}\u00b0`, middle, top + (TAPE + 13) * scale);
  }
}
