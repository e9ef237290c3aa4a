// The last half minute of every signal, in columns that grow and are cut, so that a plot is a view and no copy.

import type { Frame } from "./protocol";

const SIGNALS = 64;
/** Samples that are shown: 30 s at 50 Hz. */
const SHOWN = 1500;

export class History {
  private readonly times = new Float64Array(2 * SHOWN);
  private readonly columns = Array.from({ length: SIGNALS }, () => new Float64Array(2 * SHOWN));
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
    if (this.end === 2 * SHOWN) {
      // Cut to the younger half.
      for (const column of [this.times, ...this.columns]) column.copyWithin(0, SHOWN);
      this.begin = 0;
      this.end = SHOWN;
    }
    this.times[this.end] = frame.period * period;
    // What does not come down is not drawn as if it stood still.
    for (const column of this.columns) column[this.end] = NaN;
    for (const signal of frame.signals) this.columns[signal]![this.end] = this.now[signal]!;
    this.end += 1;
    this.begin = Math.max(this.begin, this.end - SHOWN);
    return anew;
  }

  get time(): Float64Array { return this.times.subarray(this.begin, this.end); }
  column(signal: number): Float64Array { return this.columns[signal]!.subarray(this.begin, this.end); }
}
