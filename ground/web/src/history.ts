// Every signal since the flight began, in columns that grow, so that a plot is a view and no copy.

import type { Flight, Frame } from "./protocol";

const SIGNALS = 64;
/** Samples that fit: 20 minutes at 50 Hz. When they are full, every second one goes, and new ones come half as often. */
const FULL = 60_000;

export class History {
  private readonly times = new Float64Array(FULL);
  private readonly columns = Array.from({ length: SIGNALS }, () => new Float64Array(FULL));
  private end = 0;
  private last = -1;
  /** Frames of which one is a sample, and those since the last sample. */
  private every = 1;
  private since = 0;
  /** Whether the columns hold a whole recorded flight, to which frames add nothing. */
  private whole = false;
  /** The time between two frames while none is missing, s. */
  step = Infinity;
  /** How often frames were missing. */
  gaps = 0;
  /** What each signal was last. */
  readonly now = new Float64Array(SIGNALS).fill(NaN);
  truth: number[] = [];

  /** Takes a frame in; whether it is the first of another software. */
  take(frame: Frame, period: number): boolean {
    const anew = frame.period < this.last;
    if (anew && !this.whole) {
      this.end = this.since = 0;
      this.every = 1;
      this.step = Infinity;
    } else if (!anew && this.last >= 0 && frame.period > this.last) {
      const step = (frame.period - this.last) * period;
      this.gaps += Number(step > 1.5 * this.step);
      this.step = Math.min(this.step, step);
    }
    this.last = frame.period;
    this.truth = frame.truth;
    frame.signals.forEach((signal, place) => { this.now[signal] = frame.values[place] ?? NaN; });
    if (!this.whole) this.add(frame, period);
    return anew;
  }

  /** Takes a recorded flight in. */
  fill(flight: Flight): void {
    this.whole = true;
    this.end = Math.min(flight.times.length, FULL);
    for (const column of this.columns) column.fill(NaN, 0, this.end);
    for (let n = 0; n < this.end; n += 1) this.times[n] = flight.times[n]!;
    flight.signals.forEach((signal, place) => {
      const from = flight.columns[place] ?? [], to = this.columns[signal]!;
      for (let n = 0; n < this.end; n += 1) to[n] = from[n] ?? NaN;
    });
  }

  private add(frame: Frame, period: number): void {
    this.since += 1;
    if (this.since < this.every && this.end > 0) return;
    this.since = 0;
    if (this.end === FULL) this.halve();
    this.times[this.end] = frame.period * period;
    // What does not come down is not drawn as if it stood still.
    for (const column of this.columns) column[this.end] = NaN;
    for (const signal of frame.signals) this.columns[signal]![this.end] = this.now[signal]!;
    this.end += 1;
  }

  private halve(): void {
    for (const column of [this.times, ...this.columns]) {
      for (let n = 0; n < FULL / 2; n += 1) column[n] = column[2 * n]!;
    }
    this.end = FULL / 2;
    this.every *= 2;
  }

  /** Duration that is shown, s. */
  shown = Infinity;

  /** Time without samples after which a line begins anew, s. */
  get silence(): number { return Math.max(1, this.whole ? 2.5 * (this.times[1]! - this.times[0]!) : 2.5 * this.every * Math.min(this.step, 1)); }

  /** Whether this is a recorded flight. */
  get recorded(): boolean { return this.whole; }

  /** First sample that is shown. */
  private get first(): number {
    const from = this.whole ? -Infinity : (this.times[this.end - 1] ?? 0) - this.shown;
    let [low, high] = [0, this.end];
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.times[middle]! < from) low = middle + 1; else high = middle;
    }
    return low;
  }
  get time(): Float64Array { return this.times.subarray(this.first, this.end); }
  column(signal: number): Float64Array { return this.columns[signal]!.subarray(this.first, this.end); }
}
