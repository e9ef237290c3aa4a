// The last minutes of every signal, in columns that grow and are cut, so that a plot is a view and no copy.

import type { Frame } from "./protocol";

const SIGNALS = 64;
/** Samples that are kept: 10 minutes at 50 Hz. */
const KEPT = 30_000;

export class History {
  private readonly times = new Float64Array(2 * KEPT);
  private readonly columns = Array.from({ length: SIGNALS }, () => new Float64Array(2 * KEPT));
  private begin = 0;
  private end = 0;
  private last = -1;
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
    if (anew) {
      this.begin = this.end = 0;
      this.step = Infinity;
    } else if (this.last >= 0 && frame.period > this.last) {
      const step = (frame.period - this.last) * period;
      this.gaps += Number(step > 1.5 * this.step);
      this.step = Math.min(this.step, step);
    }
    this.last = frame.period;
    this.truth = frame.truth;
    frame.signals.forEach((signal, place) => { this.now[signal] = frame.values[place] ?? NaN; });
    if (this.end === 2 * KEPT) {
      // Cut to the younger half.
      for (const column of [this.times, ...this.columns]) column.copyWithin(0, KEPT);
      this.begin = 0;
      this.end = KEPT;
    }
    this.times[this.end] = frame.period * period;
    // What does not come down is not drawn as if it stood still.
    for (const column of this.columns) column[this.end] = NaN;
    for (const signal of frame.signals) this.columns[signal]![this.end] = this.now[signal]!;
    this.end += 1;
    this.begin = Math.max(this.begin, this.end - KEPT);
    return anew;
  }

  /** Duration that is shown, s. */
  shown = Infinity;

  /** First sample that is shown. */
  private get first(): number {
    const from = (this.times[this.end - 1] ?? 0) - this.shown;
    let [low, high] = [this.begin, this.end];
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.times[middle]! < from) low = middle + 1; else high = middle;
    }
    return low;
  }
  get time(): Float64Array { return this.times.subarray(this.first, this.end); }
  column(signal: number): Float64Array { return this.columns[signal]!.subarray(this.first, this.end); }
}
