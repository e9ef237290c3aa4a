// The plots: what each shows, and how a history becomes one.

import uPlot from "uplot";
import type { History } from "./history";
import { css } from "./colours";
import { onResize } from "./resize";
import { CLOSED_LOOP, FEED_FORWARD, GAIN, ROLL, VARIANCE, WANTED, WANTED_YAW, X, Y, YAW, Z } from "./protocol";

interface Line { name: string; signal: number; colour: string; dash?: boolean; scale?: number; band?: number }
interface Plot { title: string; lines: Line[] }

/** Of a plot without its legend, px: six of them fit on a screen. */
const HEIGHT = 118;

const DEGREES = 180 / Math.PI;
const MOTORS = ["--one", "--two", "--three", "--four", "--five", "--six", "--one", "--two"];
const lines = (first: number, count: number): Line[] =>
  MOTORS.slice(0, count).map((colour, n) => ({ name: `${n + 1}`, signal: first + n, colour, dash: n >= 6 }));

/** The plots of an aircraft by the number of its motors. */
const plotsOf = (motors: number): Plot[] => [
  { title: "Height, m", lines: [
    { name: "z", signal: Z, colour: "--one", band: VARIANCE + 2 },
    { name: "wanted", signal: WANTED + 2, colour: "--wanted", dash: true } ] },
  { title: "Position, m", lines: [
    { name: "x", signal: X, colour: "--one", band: VARIANCE },
    { name: "y", signal: Y, colour: "--two", band: VARIANCE + 1 },
    { name: "wanted x", signal: WANTED, colour: "--one", dash: true },
    { name: "wanted y", signal: WANTED + 1, colour: "--two", dash: true } ] },
  { title: "Roll and pitch, °", lines: [
    { name: "roll", signal: ROLL, colour: "--one", scale: DEGREES, band: VARIANCE + 3 },
    { name: "pitch", signal: ROLL + 1, colour: "--two", scale: DEGREES, band: VARIANCE + 4 } ] },
  { title: "Yaw, °", lines: [
    { name: "yaw", signal: YAW, colour: "--one", scale: DEGREES, band: VARIANCE + 5 },
    { name: "wanted", signal: WANTED_YAW, colour: "--wanted", scale: DEGREES, dash: true } ] },
  { title: "Motors, closed loop, rad/s", lines: lines(CLOSED_LOOP, motors) },
  { title: "Motors, feed-forward, rad/s", lines: [...lines(FEED_FORWARD, motors),
    { name: "gain × 1000", signal: GAIN, colour: "--wanted", scale: 1000, dash: true }] },
];

class Chart {
  private readonly plot: uPlot;
  private readonly scratch: Float64Array[] = [];
  readonly root: HTMLElement;

  private silence = 1;

  constructor(private readonly what: Plot, parent: HTMLElement, zoomed: (from: number, to: number) => void, marks: Marks) {
    const series: uPlot.Series[] = [{ label: "s" }];
    // A line goes on across lost samples; after a silence it begins anew.
    const gaps: uPlot.Series.GapsRefiner = (plot, _, from, to, found) => {
      const times = plot.data[0];
      for (let n = from + 1; n <= to; n += 1) {
        if (times[n]! - times[n - 1]! > this.silence) found.push([plot.valToPos(times[n - 1]!, "x", true), plot.valToPos(times[n]!, "x", true)]);
      }
      return found;
    };
    const bands: uPlot.Band[] = [];
    for (const line of what.lines) {
      series.push({ label: line.name, gaps, stroke: () => css(line.colour), width: 1.5,
        value: (_, value) => value == null || Number.isNaN(value) ? "–" : (value as number).toFixed(3).replace(/^-(0\.0+)$/, "$1"),
        ...(line.dash ? { dash: [6, 4] } : {}) });
    }
    // The bands' edges stand behind the lines, and are not in the legend.
    for (const line of what.lines) {
      if (line.band === undefined) continue;
      const at = series.length;
      for (let edge = 0; edge < 2; edge += 1) series.push({ width: 0, gaps, points: { show: false }, class: "edge" });
      bands.push({ series: [at, at + 1], fill: () => `color-mix(in srgb, ${css(line.colour)} 22%, transparent)` });
    }
    const axis = (): uPlot.Axis => ({ stroke: () => css("--quiet"), grid: { stroke: () => css("--line"), width: 1 },
      ticks: { stroke: () => css("--line"), width: 1 }, font: "11px system-ui", size: 54 });
    this.plot = new uPlot({
      title: what.title, width: 400, height: HEIGHT, series, bands, axes: [{ ...axis(), size: 26 }, axis()],
      scales: { x: { time: false }, y: { range: (_, low, high) => wide(low, high) } },
      // One cursor for all plots; a zoom is passed on by who made it.
      cursor: { points: { show: false }, sync: { key: "flight", setSeries: false }, drag: { setScale: false } },
      hooks: { draw: [(plot) => marks.draw(plot)], setSelect: [(plot) => {
        const { left, width } = plot.select;
        if (width < 4) return;
        plot.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
        zoomed(plot.posToVal(left, "x"), plot.posToVal(left + width, "x"));
      }] },
      legend: { live: true, markers: { stroke: (_, n) => `var(${what.lines[n - 1]?.colour ?? "--quiet"})` } }, pxAlign: 0,
    }, [[], ...series.slice(1).map(() => [])], parent);
    this.root = this.plot.root;
  }

  zoom(from: number, to: number): void { this.plot.setScale("x", { min: from, max: to }); }
  remove(): void { this.plot.destroy(); }

  resize(width: number): void { this.plot.setSize({ width, height: HEIGHT }); }
  redraw(): void { this.plot.redraw(false, true); }

  show(history: History): void {
    this.silence = history.silence;
    const data: (Float64Array)[] = [history.time];
    const length = history.time.length;
    let at = 0;
    const next = (): Float64Array => {
      const found = this.scratch[at];
      const array = found && found.length >= length ? found : new Float64Array(2 * length + 64);
      this.scratch[at] = array;
      at += 1;
      return array.subarray(0, length);
    };
    for (const { signal, scale } of this.what.lines) {
      const column = history.column(signal);
      if (scale === undefined) { data.push(column); continue; }
      const scaled = next();
      for (let n = 0; n < length; n += 1) scaled[n] = column[n]! * scale;
      data.push(scaled);
    }
    for (const { signal, scale = 1, band } of this.what.lines) {
      if (band === undefined) continue;
      const column = history.column(signal), variance = history.column(band);
      const upper = next(), lower = next();
      for (let n = 0; n < length; n += 1) {
        // Two standard deviations; none, where the variance is not received.
        const far = 2 * Math.sqrt(variance[n]!) || 0;
        upper[n] = (column[n]! + far) * scale;
        lower[n] = (column[n]! - far) * scale;
      }
      data.push(upper, lower);
    }
    this.plot.setData(data as unknown as uPlot.AlignedData);
  }
}

/** Times that every plot marks: events, and how far a recording has been played. */
class Marks {
  events: { time: number; colour: string }[] = [];
  played = NaN;

  draw(plot: uPlot): void {
    const { left, top, width, height } = plot.bbox;
    const line = (time: number, colour: string, dash: number[]) => {
      const x = Math.round(plot.valToPos(time, "x", true));
      if (!(x >= left && x <= left + width)) return;
      plot.ctx.save();
      plot.ctx.strokeStyle = css(colour);
      plot.ctx.setLineDash(dash);
      plot.ctx.beginPath();
      plot.ctx.moveTo(x, top);
      plot.ctx.lineTo(x, top + height);
      plot.ctx.stroke();
      plot.ctx.restore();
    };
    for (const { time, colour } of this.events) line(time, colour, [2, 4]);
    if (Number.isFinite(this.played)) line(this.played, "--ink", []);
  }
}

/** The most events that are marked. */
const MOST_MARKS = 100;

/** A range that never makes noise look like a flight. */
function wide(low: number, high: number): [number, number] {
  if (!Number.isFinite(low) || !Number.isFinite(high)) return [0, 1];
  const middle = (low + high) / 2, half = Math.max((high - low) * 0.55, 0.05);
  return [middle - half, middle + half];
}

/** Between two pictures, ms, at 50 Hz: while they take longer, plots take turns, up to so many. */
const PACE = 20, TURNS = 3;

export class Plots {
  private charts: Chart[] = [];
  private readonly marks = new Marks();
  private motors = 0;
  private pictures = 0;
  private last = 0;
  /** How long a picture takes of late, ms. */
  private pace = 0;
  private stopped = false;

  /** `changed` learns when the plots are paused, by a zoom as well, and when they go on. */
  constructor(private readonly parent: HTMLElement, private readonly changed: (paused: boolean) => void) {
    onResize(parent, () => this.resize());
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.charts.forEach((chart) => chart.redraw()));
  }

  /** Makes the plots of an aircraft by the number of its motors; those that were added stay. */
  set craft(motors: number) {
    if (motors === this.motors) return;
    this.motors = motors;
    this.charts.forEach((chart) => chart.remove());
    this.charts = plotsOf(motors).map((plot) => new Chart(plot, this.parent, this.zoom, this.marks));
    this.resize();
  }

  /** Marks an event, in the colour of its severity. */
  mark(time: number, severity: string): void {
    this.marks.events.push({ time, colour: severity === "critical" ? "--bad" : severity === "warning" ? "--poor" : "--quiet" });
    if (this.marks.events.length > MOST_MARKS) this.marks.events.shift();
  }

  /** Forgets the events. */
  forget(): void { this.marks.events.length = 0; }

  /** Marks how far a recording has been played, s. */
  set played(time: number) {
    this.marks.played = time;
    this.charts.forEach((chart) => chart.redraw());
  }

  get paused(): boolean { return this.stopped; }
  set paused(is: boolean) { this.stopped = is; this.changed(is); }

  /** Adds a plot of one signal, with a button that removes it. */
  add(name: string, signal: number): void {
    const chart = new Chart({ title: name, lines: [{ name, signal, colour: "--one" }] }, this.parent, this.zoom, this.marks);
    const away = document.createElement("button");
    away.textContent = "×";
    away.className = "quiet away";
    away.setAttribute("aria-label", `remove the plot of ${name}`);
    away.addEventListener("click", () => { this.charts.splice(this.charts.indexOf(chart), 1); chart.remove(); });
    chart.root.append(away);
    this.charts.push(chart);
    this.resize();
  }

  private resize(): void { this.charts.forEach((chart) => chart.resize(this.parent.clientWidth - 4)); }

  private readonly zoom = (from: number, to: number): void => {
    this.paused = true;
    this.charts.forEach((chart) => chart.zoom(from, to));
  };

  /** What moves in space shows a stutter sooner than a curve: where not everything can be drawn in time, curves wait. */
  show(history: History): void {
    if (this.stopped) return;
    const now = performance.now();
    this.pace += 0.05 * (Math.min(now - this.last, 10 * PACE) - this.pace);
    this.last = now;
    this.pictures += 1;
    const turns = Math.min(TURNS, Math.max(1, Math.round(this.pace / PACE)));
    this.charts.forEach((chart, n) => { if (n % turns === this.pictures % turns) chart.show(history); });
  }
}
