// A pilot's hands: keys or a gamepad, twenty times a second.

export interface Sticks { roll: number; pitch: number; yaw_rate: number; climb: number }

/** Largest lean, rad, rate of yaw, rad/s, and rate of climb, m/s, that hands ask for. */
const LEAN = 0.12, TURN = 1, RISE = 0.4;

export function pilot(flies: () => boolean, move: (sticks: Sticks) => void): void {
  const held = new Set<string>();
  addEventListener("keydown", (event) => {
    if (!(event.target instanceof HTMLInputElement)) held.add(event.key.toLowerCase());
  });
  addEventListener("keyup", (event) => held.delete(event.key.toLowerCase()));
  addEventListener("blur", () => held.clear());
  setInterval(() => {
    if (!flies()) return;
    const key = (more: string, less: string) => Number(held.has(more)) - Number(held.has(less));
    const pad = navigator.getGamepads().find((it) => it?.connected);
    const axis = (n: number) => Math.abs(pad?.axes[n] ?? 0) > 0.08 ? pad?.axes[n] ?? 0 : 0;
    const limit = (value: number) => Math.min(1, Math.max(-1, value));
    move({
      // A positive roll flies along y, a negative pitch along x: the angles are passive.
      roll: LEAN * limit(key("a", "d") - axis(2)),
      pitch: LEAN * limit(key("s", "w") + axis(3)),
      // A positive yaw turns to the right, for the same reason.
      yaw_rate: TURN * limit(key("e", "q") + axis(0)),
      climb: RISE * limit(key("r", "f") - axis(1)),
    });
  }, 50);
}
