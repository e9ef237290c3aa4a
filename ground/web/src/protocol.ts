// What goes between the page and the server: the shapes of ground/src/messages.rs.

export interface Signal { number: number; name: string; unit: string }
export interface Parameter { number: number; name: string; unit: string; least: number; most: number; initial: number; in_flight: boolean; choices: string[] }
export interface Counts { sent: number; lost: number; doubled: number; overtaken: number }
export interface Hello {
  type: "hello"; signals: Signal[]; parameters: Parameter[]; phases: string[]; alarms: string[];
  authenticated: boolean; motors: number; fastest: number; wind: number; space: [number, number, number]; period: number;
}
/** A check before arming: passed, failed for a reason, or not known from the signals that are received. */
export interface Check { name: string; known: boolean; problem: string | null }
export interface Frame { type: "frame"; period: number; signals: number[]; values: (number | null)[]; truth: number[] }
export interface State {
  type: "state"; time: number; alive: boolean; restarts: number; silence: number | null;
  timing: { periods: number; missed: number; slowest: number };
  up: Counts; down: Counts; heard: { heard: number; broken: number; missing: number };
  counts: number[] | null; mode: number | null; planned: boolean; battery: { voltage: number; left: number }; recordings: Saved[]; sensors: Health[]; checks: Check[]; parameters: (number | null)[];
  pages: number; commanded: boolean; skipped: number; refused: number;
  recording: { running: boolean; periods: number; error: string | null; ready: boolean };
}
/** A finished recording: its size in bytes, and when it was written, s since 1970. */
export interface Saved { name: string; bytes: number; written: number }
/** A sensor, and since when it is lost, s. */
export interface Health { name: string; lost: number | null }
/** A recorded flight, sampled evenly: a column for each signal. */
export interface Flight { type: "flight"; times: number[]; signals: number[]; columns: (number | null)[][] }
export interface Playing { type: "playing"; from: number; to: number; time: number; speed: number }
export interface Happened { type: "event"; time: number; severity: "info" | "warning" | "critical"; text: string }
export type Tell = Hello | Frame | State | Flight | Playing | Happened
  | { type: "command"; granted: boolean; reason: string }
  | { type: "outcome"; order: string; outcome: "done" | "given_up" | "refused" }
  | { type: "refused"; reason: string }
  | { type: "pong"; number: number };

export interface Point { time: number; x: number; y: number; z: number; yaw: number }
export type Ask = { type: string } & Record<string, unknown>;

/** Why a page may not command that could, if another did not. */
export const TAKEN = "somebody else commands";

// Numbers of signals on board.
export const X = 0, Y = 1, Z = 2, ROLL = 3, YAW = 5, WANTED = 12, WANTED_YAW = 15, PHASE = 16, TIME = 17;
export const CLOSED_LOOP = 18, FEED_FORWARD = 26, GAIN = 34, ALARM = 35, VARIANCE = 51;
