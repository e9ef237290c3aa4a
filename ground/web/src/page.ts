// The page: what comes from the server is shown, and what the operator does is sent.

import "uplot/dist/uPlot.min.css";
import "./page.css";
import { History } from "./history";
import { Horizon } from "./horizon";
import { Plan } from "./plan";
import { Plots } from "./plots";
import { ALARM, CLOSED_LOOP, FEED_FORWARD, PHASE, ROLL, TAKEN, TIME, WANTED, X, Y, YAW, Z } from "./protocol";
import type { Ask, Flight, Frame, Happened, Hello, Playing, Point, Saved, State, Tell } from "./protocol";
import { Scene } from "./scene";
import { Socket } from "./socket";
import { pilot } from "./sticks";

const MODES = ["closed loop", "feed-forward", "manual"];

function get<T extends HTMLElement>(id: string): T {
  const found = document.getElementById(id);
  if (!found) throw new Error(`the page has no #${id}`);
  return found as T;
}
function make<K extends keyof HTMLElementTagNameMap>(tag: K, text = "", attributes: Record<string, string> = {}): HTMLElementTagNameMap[K] {
  const made = document.createElement(tag);
  made.textContent = text;
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  return made;
}
/** A number without a minus before zeros. */
const fixed = (value: number | null | undefined, digits: number): string =>
  value == null || !Number.isFinite(value) ? "–" : value.toFixed(digits).replace(/^-(0\.?0*)$/, "$1");

const history = new History();
history.shown = 30;
const plots = new Plots(get("plots"), (paused) => {
  get("pause").textContent = paused ? "Resume plots" : "Pause plots";
  get("pause").setAttribute("aria-pressed", `${paused}`);
});
const horizon = new Horizon(get<HTMLCanvasElement>("horizon"));
const scene = new Scene(get<HTMLCanvasElement>("scene"));
let hello: Hello | undefined;
let bars: { bar: HTMLElement; closed: HTMLElement; forward: HTMLElement; text: HTMLElement }[] = [];
let commands = false;
/** Whether this page commands as soon as nobody else does. */
let waits = false;
let open = false;
let fresh = false;
let mode = "";

const socket = new Socket(take, (is) => {
  open = is;
  if (!is) granted(false, "");
  link(undefined);
});
const ask = (type: string, more: Record<string, unknown> = {}): void => socket.send({ type, ...more } as Ask);

const plan = new Plan(get<HTMLCanvasElement>("plan"), (x, y) => {
  const round = (value: number) => Math.round(value * 100) / 100;
  // The height of the trajectory; without one, that of the set point, which may be on its way.
  const wanted = plan.course[plan.course.length - 1]?.z ?? history.now[WANTED + 2];
  points = [{ time: 0, x: round(x), y: round(y), z: wanted && wanted > 0.2 ? round(wanted) : 1, yaw: 0 }];
  list();
  send();
});

// --- what comes ---

function take(tell: Tell): void {
  switch (tell.type) {
    case "hello": return begin(tell);
    case "frame": return frame(tell);
    case "state": return state(tell);
    case "flight": return flight(tell);
    case "playing": return playing(tell);
    case "command": return granted(tell.granted, tell.reason);
    // One that failed is an event, too.
    case "outcome": return tell.outcome === "done" ? say(`${tell.order}: done`) : undefined;
    case "event": return happened(tell);
    case "refused": return say(tell.reason, true);
    case "pong": return;
  }
}

function begin(tell: Hello): void {
  hello = tell;
  // The events until now follow.
  get("events").replaceChildren();
  plots.forget();
  plan.space = tell.space[0];
  craft(tell.motors);
  get<HTMLInputElement>("wind").max = `${tell.wind}`;
  get<HTMLInputElement>("wind").step = `${tell.wind / 30}`;
  list();
  const seal = get("seal");
  seal.textContent = tell.authenticated ? "authenticated" : "unauthenticated";
  seal.className = tell.authenticated ? "good" : "poor";
  const parameters = get("parameters");
  parameters.replaceChildren(...tell.parameters.map((it) => {
    const row = make("tr"), named = { "aria-label": it.name, id: `parameter-${it.number}` };
    const input = it.choices.length > 0 ? make("select", "", named)
      : make("input", "", { type: "number", min: `${it.least}`, max: `${it.most}`, step: "any", ...named });
    input.append(...it.choices.map((choice, number) => make("option", choice, { value: `${number}` })));
    input.addEventListener("change", () => {
      if (input.checkValidity() && input.value !== "") ask("set", { number: it.number, value: Number(input.value) });
      else say(`${it.name}: ${it.least} to ${it.most}`, true);
    });
    const cell = make("td");
    cell.append(input);
    row.append(make("th", it.name), cell, make("td", it.unit), make("td", it.choices[it.initial] ?? `${it.initial}`),
      make("td", [it.choices.length > 0 ? "" : `${it.least} … ${it.most}`, it.in_flight ? "" : "on the ground"].filter(Boolean).join(", "), { class: "hint" }));
    return row;
  }));
  const plotted = get("plotted");
  plotted.replaceChildren(plotted.firstElementChild!, ...tell.signals.map((it) =>
    make("option", it.unit ? `${it.name}, ${it.unit}` : it.name, { value: `${it.number}` })));
  get("signals").replaceChildren(...tell.signals.map((it) => {
    const label = make("label"), box = make("input", "", { type: "checkbox", value: `${it.number}` });
    label.append(box, ` ${it.name}${it.unit ? `, ${it.unit}` : ""}`);
    return label;
  }));
}

/** All of a recorded flight: its plots, and its way in the plan. */
function flight(tell: Flight): void {
  history.fill(tell);
  const [x, y] = [X, Y].map((signal) => tell.columns[tell.signals.indexOf(signal)] ?? []);
  const way = tell.times.map((_, n): [number, number] => [x?.[n] ?? NaN, y?.[n] ?? NaN]);
  plan.recorded = way.filter(([x, y]) => Number.isFinite(x) && Number.isFinite(y));
  document.body.dataset["samples"] = `${tell.times.length}`;
  get("span").closest("label")!.hidden = true;
  plots.show(history);
}

function frame(tell: Frame): void {
  if (!hello) return;
  if (history.take(tell, hello.period)) {
    scene.forget();
    plan.forget();
  }
  document.body.dataset["frames"] = `${Number(document.body.dataset["frames"] ?? 0) + 1}`;
  document.body.dataset["gaps"] = `${history.gaps}`;
  fresh = true;
}

function state(tell: State): void {
  link(tell);
  if (waits && socket.wants && !tell.commanded) {
    waits = false;
    socket.claim(false);
  }
  mode = tell.mode == null ? "" : MODES[tell.mode] ?? "";
  get("mode").textContent = mode || "–";
  get("planned").textContent = flies() ? progress() : tell.planned ? "is on board: flown after the take-off" : "was not sent since the last flight";
  get("checks").replaceChildren(...tell.checks.map(({ name, known, problem }) =>
    make("li", `${name}: ${problem ?? (known ? "passed" : "not received")}`, { class: problem ? "bad" : known ? "good" : "poor" })));
  get("checks").hidden = flies();
  tell.parameters.forEach((value, number) => {
    const input = document.getElementById(`parameter-${number}`) as HTMLInputElement | HTMLSelectElement | null;
    if (input && value != null && document.activeElement !== input) input.value = `${Number(value.toPrecision(6))}`;
    const initial = hello?.parameters[number]?.initial;
    input?.closest("tr")?.classList.toggle("modified", value != null && value !== initial);
  });
  values = tell.parameters;
  get("modified").textContent = `${document.querySelectorAll("#parameters .modified").length}`;
  const { battery } = tell;
  get("battery").textContent = `${fixed(100 * battery.left, 0)} %, ${fixed(battery.voltage, 2)} V`;
  get("battery").className = battery.left > 0.3 ? "good" : battery.left > 0.15 ? "poor" : "bad";
  get("sensors").replaceChildren(...tell.sensors.map(({ name, lost }) =>
    make("li", lost == null ? name : `${name} lost for ${fixed(tell.time - lost, 0)} s`, { class: lost == null ? "good" : "bad" })));
  recordings(tell.recordings);
  const { recording, timing, up, down, heard, counts } = tell;
  get("record").textContent = recording.running ? "Stop recording" : "Record";
  get("recording").textContent = recording.error ?? (recording.running ? `${fixed(recording.periods * (hello?.period ?? 0), 0)} s` : "");
  get("recording").className = recording.error ? "bad" : "";
  get("download").hidden = !recording.ready || !socket.trusted;
  get<HTMLAnchorElement>("download").href = `flight.mcap?token=${socket.token}`;
  get("claim").textContent = commands ? "Give up command" : tell.commanded ? "Take command from other client" : "Take command";
  const rows: [string, string][] = [
    ["uplink: sent, lost, duplicated, reordered", [up.sent, up.lost, up.doubled, up.overtaken].join(", ")],
    ["downlink: sent, lost, duplicated, reordered", [down.sent, down.lost, down.doubled, down.overtaken].join(", ")],
    ["received, corrupt, lost", [heard.heard, heard.broken, heard.missing].join(", ")],
    ["on board: accepted, corrupt, outdated, invalid", counts?.slice(0, 4).join(", ") ?? "–"],
    ["unsealed, forged, replayed", counts?.slice(4, 7).join(", ") ?? "–"],
    ["periods, missed, slowest", `${timing.periods}, ${timing.missed}, ${timing.slowest} µs`],
    ["pages, skipped frames", `${tell.pages}, ${tell.skipped}`],
    ["MAVLink: unsigned, forged, repeated", `${tell.refused}`],
    ["software restarts", `${tell.restarts}`],
  ];
  get("counts").replaceChildren(...rows.flatMap(([name, value]) => [make("dt", name), make("dd", value)]));
}

/** Makes what depends on the number of motors. */
function craft(motors: number): void {
  if (bars.length === motors) return;
  bars = Array.from({ length: motors }, (_, n) => {
    const bar = make("div", "", { class: "motor" }), closed = make("i", "", { class: "closed" }), forward = make("i", "", { class: "forward" });
    bar.append(make("span", `motor ${n + 1}`), forward, closed, make("b"));
    return { bar, closed, forward, text: bar.lastChild as HTMLElement };
  });
  get("motors").replaceChildren(...bars.map((it) => it.bar));
  get("motor").replaceChildren(make("option", "all run", { value: "" }),
    ...bars.map((_, n) => make("option", `${n + 1} stops`, { value: `${n}` })));
  plots.craft = motors;
  scene.motors = motors;
}

/** Which point of the trajectory is flown, and for how long. */
function progress(): string {
  const time = history.now[TIME] ?? NaN, points = plan.course, reached = Plan.reached(points, time), next = points[reached];
  if (points.length === 0 || !Number.isFinite(time)) return "is flown";
  return `is flown: point ${Math.max(reached, 1)} of ${points.length}${next ? `, the next in ${fixed(next.time - time, 0)} s` : ""}`;
}

/** The recordings that can be downloaded, the newest first; they are drawn anew only when there are others. */
let listed = "";
function recordings(saved: Saved[]): void {
  const now = JSON.stringify(saved);
  if (now === listed || !socket.trusted) return;
  listed = now;
  get("recordings").replaceChildren(...saved.reverse().map(({ name, bytes, written }) => {
    const line = make("li"), at = written > 0 ? `, ${new Date(1000 * written).toLocaleString()}` : "";
    line.append(make("a", name, { href: `recordings/${encodeURIComponent(name)}?token=${socket.token}`, download: name }),
      make("span", ` ${fixed(bytes / 1e6, 1)} MB${at}`, { class: "hint" }));
    return line;
  }));
}

function playing(tell: Playing): void {
  document.body.dataset["playing"] = fixed(tell.time, 2);
  if (get("player").hidden) {
    get("player").hidden = false;
    // A recording takes no commands: the events take their column.
    get("middle").prepend(get("events-title"), get("events"));
  }
  get("link").textContent = "recording";
  get("link").className = "";
  get("play").textContent = tell.speed > 0 ? "Pause" : "Play";
  const at = get<HTMLInputElement>("at");
  [at.min, at.max] = [`${tell.from}`, `${tell.to}`];
  if (!at.matches(":active")) at.value = `${tell.time}`;
  get("at-is").textContent = `${fixed(tell.time, 1)} of ${fixed(tell.to, 1)} s`;
  plots.played = tell.time;
}

/** Whether the aircraft is in a phase with motors on. */
const flies = (): boolean => !["armed", "disarmed"].includes(hello?.phases[history.now[PHASE] ?? 0] ?? "disarmed");

function link(tell: State | undefined): void {
  const element = get("link");
  const [text, how] = !open ? ["page disconnected", "bad"]
    : !tell ? ["connecting", "poor"]
    : !tell.alive ? ["software silent", "bad"]
    : tell.silence == null || tell.silence > 1 ? [`lost for ${fixed(tell.silence, 0)} s`, "bad"]
    : [`${Math.round(100 * (1 - lossOf(tell)))} %`, lossOf(tell) > 0.1 ? "poor" : "good"];
  element.textContent = text ?? "";
  element.className = how ?? "";
}

/** The share of what came down that was missing, of late. */
let before = { heard: 0, missing: 0 };
let share = 0;
function lossOf({ heard }: State): number {
  const came = heard.heard - before.heard, missing = heard.missing - before.missing;
  if (came < 0) before = { heard: 0, missing: 0 };
  if (came + missing > 100) {
    share = missing / (came + missing);
    before = { heard: heard.heard, missing: heard.missing };
  }
  return share;
}

function granted(is: boolean, reason: string): void {
  commands = is;
  waits = reason === TAKEN;
  document.body.dataset["commands"] = `${is}`;
  if (reason) say(reason, true);
  for (const control of document.querySelectorAll<HTMLButtonElement | HTMLInputElement | HTMLSelectElement>(
    "#middle button, #middle input, #middle select")) control.disabled = !is;
}

function happened(event: Happened): void {
  const { time, severity, text } = event;
  plots.mark(time, severity);
  const line = make("li", "", { class: severity });
  const at = make("button", `${fixed(time, 1)} s`, { type: "button", class: "quiet", title: "Go to this time of a recording" });
  at.addEventListener("click", () => { if (!get("player").hidden) ask("seek", { time }); });
  line.append(at, ` ${text}`);
  const events = get("events");
  events.prepend(line);
  while (events.children.length > 200) events.lastChild?.remove();
  document.body.dataset["event"] = text;
}

function say(text: string, bad = false): void {
  const line = make("li", `${new Date().toLocaleTimeString()} ${text}`);
  if (bad) line.className = "bad";
  const log = get("log");
  log.prepend(line);
  while (log.children.length > 30) log.lastChild?.remove();
}

// --- what is drawn ---

function draw(): void {
  requestAnimationFrame(draw);
  if (!fresh) return;
  fresh = false;
  document.body.dataset["pictures"] = `${Number(document.body.dataset["pictures"] ?? 0) + 1}`;
  const { now } = history;
  const phase = hello?.phases[now[PHASE] ?? 0] ?? "–", alarm = hello?.alarms[now[ALARM] ?? 0] ?? "–";
  document.body.dataset["phase"] = phase;
  document.body.dataset["alarm"] = alarm;
  document.body.dataset["height"] = fixed(now[Z], 3);
  document.body.dataset["place"] = `${fixed(now[X], 2)},${fixed(now[Y], 2)}`;
  get("phase").textContent = phase;
  get("phase").className = phase === "hold" ? "poor" : "";
  get("armed").textContent = phase === "–" ? "–" : phase === "disarmed" ? "disarmed" : flies() ? "running" : "armed";
  get("armed").className = phase === "disarmed" || phase === "–" ? "" : "poor";
  get("alarm").textContent = alarm === "clear" ? "none" : alarm;
  get("alarm").className = alarm === "clear" ? "good" : "bad";
  const wanted: [number, number, number] = [now[WANTED] ?? 0, now[WANTED + 1] ?? 0, now[WANTED + 2] ?? 0];
  get("readout").textContent = `x ${fixed(now[X], 2)}  y ${fixed(now[Y], 2)}  z ${fixed(now[Z], 2)} m`;
  scene.show(now, history.truth, wanted);
  horizon.show(now[ROLL] ?? 0, now[ROLL + 1] ?? 0, now[YAW] ?? 0);
  plan.show([now[X] ?? 0, now[Y] ?? 0], now[YAW] ?? 0, [wanted[0], wanted[1]], flies() ? now[TIME] ?? NaN : NaN);
  if (!history.recorded) plots.show(history);
  const fastest = hello?.fastest ?? 1;
  bars.forEach(({ closed, forward, text }, n) => {
    const [own, given] = [Math.abs(now[CLOSED_LOOP + n] ?? 0), Math.abs(now[FEED_FORWARD + n] ?? 0)];
    forward.style.width = `${100 * given / fastest}%`;
    closed.style.width = `${100 * own / fastest}%`;
    text.textContent = fixed(own + given, 0);
  });
}

// --- what is asked for ---

let points: Point[] = [{ time: 0, x: 0, y: 0, z: 1, yaw: 0 }];

/** Limits of a column of the trajectory, in the units that are shown. */
function bounds(name: keyof Point): [number, number] {
  const [reach, low, high] = hello?.space ?? [3, 0, 3];
  switch (name) {
    case "time": return [0, 3600];
    case "x": case "y": return [-reach, reach];
    case "z": return [low, high];
    case "yaw": return [-360, 360];
  }
}

function list(): void {
  get("points").replaceChildren(...points.map((point, index) => {
    const row = make("tr");
    const cell = (name: keyof Point, scale = 1) => {
      const input = make("input", "", { type: "number", step: "any", "aria-label": `${name} of point ${index + 1}` });
      [input.min, input.max] = bounds(name).map(String) as [string, string];
      input.required = true;
      input.value = `${Math.round(point[name] * scale * 1000) / 1000}`;
      input.disabled = !commands;
      input.addEventListener("change", () => { point[name] = Number(input.value) / scale; });
      const place = make("td");
      place.append(input);
      return place;
    };
    const away = make("button", "×", { type: "button", class: "quiet", "aria-label": `remove point ${index + 1}` });
    away.addEventListener("click", () => { points.splice(index, 1); list(); });
    const last = make("td");
    last.append(away);
    row.append(cell("time"), cell("x"), cell("y"), cell("z"), cell("yaw", 180 / Math.PI), last);
    return row;
  }));
}

function send(): void {
  const wrong = get("points").querySelector<HTMLInputElement>("input:invalid");
  if (wrong) return say(`${wrong.ariaLabel}: ${wrong.min} to ${wrong.max}`, true);
  ask("fly", { points });
  plan.course = points;
}

/** Values of the parameters on board. */
let values: (number | null)[] = [];

/** Saves the parameters as an object from names to values. */
function save(): void {
  const named = Object.fromEntries((hello?.parameters ?? []).map((it) => [it.name, values[it.number] ?? null]));
  const link = make("a", "", { download: "parameters.json" });
  link.href = URL.createObjectURL(new Blob([`${JSON.stringify(named, null, 2)}\n`], { type: "application/json" }));
  link.click();
  URL.revokeObjectURL(link.href);
}

/** Sets the parameters of a file; says which names and values it does not take. */
async function load(file: File): Promise<void> {
  let read: unknown;
  try { read = JSON.parse(await file.text()); } catch { read = null; }
  if (typeof read !== "object" || read === null || Array.isArray(read)) {
    return say(`${file.name} is no file of parameters: an object from names to numbers`, true);
  }
  let set = 0;
  for (const [name, value] of Object.entries(read)) {
    const known = hello?.parameters.find((it) => it.name === name);
    if (!known) say(`${file.name}: there is no parameter ${name}`, true);
    else if (typeof value !== "number" || value < known.least || value > known.most) say(`${name}: ${known.least} to ${known.most}`, true);
    else if (value !== values[known.number]) { ask("set", { number: known.number, value }); set += 1; }
  }
  say(`${file.name}: ${set} parameters are set`);
}

function restore(): void {
  for (const it of hello?.parameters ?? []) {
    if (values[it.number] !== it.initial) ask("set", { number: it.number, value: it.initial });
  }
}

const order = (type: string): void => ask(type);

function choose(button: HTMLElement): void {
  const gain = button.dataset["gain"];
  if (gain) ask("set", { number: hello?.parameters.find((it) => it.name === "feed-forward gain")?.number ?? 0, value: Number(gain) });
  ask("mode", { mode: button.dataset["mode"] });
}

for (const button of document.querySelectorAll<HTMLElement>("[data-order]")) button.addEventListener("click", () => order(button.dataset["order"] ?? ""));
for (const button of document.querySelectorAll<HTMLElement>("[data-mode]")) button.addEventListener("click", () => choose(button));
get("stop").addEventListener("click", () => ask("stop"));
get("claim").addEventListener("click", () => {
  if (!socket.trusted) return say("open the address with the token that the program printed", true);
  if (commands) { socket.wants = false; ask("release"); } else socket.claim(get("claim").textContent?.includes("from") ?? false);
});
get("add").addEventListener("click", () => {
  const last = points[points.length - 1] ?? { time: -5, x: 0, y: 0, z: 1, yaw: 0 };
  points.push({ ...last, time: last.time + 5 });
  list();
});
get("fly").addEventListener("click", send);
get("parameters-save").addEventListener("click", save);
get("parameters-load").addEventListener("click", () => get("parameters-file").click());
get<HTMLInputElement>("parameters-file").addEventListener("change", (event) => {
  const chosen = event.target as HTMLInputElement, file = chosen.files?.[0];
  if (file) void load(file);
  chosen.value = "";
});
get("parameters-reset").addEventListener("click", restore);
get("pause").addEventListener("click", () => { plots.paused = !plots.paused; fresh = true; });
get<HTMLSelectElement>("span").addEventListener("change", (event) => {
  history.shown = Number((event.target as HTMLSelectElement).value);
  plots.paused = false;
  fresh = true;
});
get<HTMLSelectElement>("plotted").addEventListener("change", (event) => {
  const chosen = event.target as HTMLSelectElement, signal = hello?.signals.find((it) => `${it.number}` === chosen.value);
  if (signal) plots.add(signal.unit ? `${signal.name}, ${signal.unit}` : signal.name, signal.number);
  chosen.value = "";
});
get("kill").addEventListener("click", () => ask("kill"));
get("record").addEventListener("click", () => ask(get("record").textContent === "Record" ? "record" : "save"));
const speed = get<HTMLSelectElement>("speed");
get("play").addEventListener("click", () => ask("play", { speed: get("play").textContent === "Play" ? Number(speed.value) : 0 }));
speed.addEventListener("change", () => ask("play", { speed: Number(speed.value) }));
get("at").addEventListener("input", (event) => ask("seek", { time: Number((event.target as HTMLInputElement).value) }));
get("choose").addEventListener("click", () => {
  const chosen = [...document.querySelectorAll<HTMLInputElement>("#signals input:checked")].map((box) => Number(box.value));
  if (chosen.length === 0 || chosen.length > 36) return say("1 to 36 signals", true);
  ask("choose", { every: 4, signals: chosen });
});
const inject = (what: string, more: Record<string, unknown>): void => ask("inject", { injection: { what, ...more } });
get("back").addEventListener("click", () => inject("back", {}));
get<HTMLSelectElement>("motor").addEventListener("change", (event) => {
  const { value } = event.target as HTMLSelectElement;
  inject("motor", { number: value === "" ? null : Number(value) });
});
get("gyroscope").addEventListener("change", (event) => inject("gyroscope", { stuck: (event.target as HTMLInputElement).checked }));
get("vicon").addEventListener("change", (event) => inject("vicon", { away: (event.target as HTMLInputElement).checked }));
get("wind").addEventListener("input", (event) => {
  const force = Number((event.target as HTMLInputElement).value);
  get("wind-is").textContent = `${fixed(force * 1000, 0)} mN`;
  inject("wind", { force: [force, 0], gusts: (hello?.wind ?? 0) / 30 + force / 4 });
});
get("loss").addEventListener("input", (event) => {
  const loss = Number((event.target as HTMLInputElement).value);
  get("loss-is").textContent = `${fixed(loss * 100, 0)} %`;
  ask("link", { loss, duplication: 0, reordering: 0, delay: 0 });
});

addEventListener("keydown", (event) => {
  if (event.key === "Escape") { event.preventDefault(); return ask("stop"); }
  const typing = event.target instanceof HTMLInputElement || event.target instanceof HTMLSelectElement;
  if (typing || event.repeat || event.ctrlKey || event.altKey || event.metaKey) return;
  const key = event.key.toLowerCase();
  const orders: Record<string, string> = { m: "arm", n: "disarm", t: "take_off", l: "land" };
  if (orders[key]) order(orders[key]);
  const buttons = document.querySelectorAll<HTMLElement>("[data-mode]");
  if (/^[1-5]$/.test(key)) choose(buttons[Number(key) - 1]!);
});
pilot(() => commands && mode === "manual", (sticks) => ask("sticks", { ...sticks }));

addEventListener("error", (event) => {
  document.body.dataset["failure"] = event.message;
  say(event.message, true);
});
granted(false, "");
list();
draw();
