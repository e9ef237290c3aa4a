// The connection to the server: it comes back by itself, and claims the command again if it had it.

import type { Ask, Tell } from "./protocol";

export class Socket {
  private socket: WebSocket | undefined;
  /** The token in the address of this page, which permits commands and downloads. */
  readonly token = new URLSearchParams(location.hash.slice(1)).get("token") ?? "";
  /** Whether this page wants to command. */
  wants = this.token !== "";

  constructor(private readonly heard: (tell: Tell) => void, private readonly changed: (open: boolean) => void) {
    this.open();
  }

  /** Whether the address of this page has a token. */
  get trusted(): boolean { return this.token !== ""; }

  send(ask: Ask): void {
    if (this.socket?.readyState === WebSocket.OPEN) this.socket.send(JSON.stringify(ask));
  }

  claim(force: boolean): void {
    this.wants = true;
    this.send({ type: "claim", token: this.token, force });
  }

  private open(): void {
    const scheme = location.protocol === "https:" ? "wss" : "ws";
    const socket = new WebSocket(`${scheme}://${location.host}/live`);
    this.socket = socket;
    socket.onopen = () => {
      this.changed(true);
      if (this.wants) this.claim(false);
    };
    socket.onmessage = (event: MessageEvent<string>) => this.heard(JSON.parse(event.data) as Tell);
    socket.onclose = () => {
      this.changed(false);
      setTimeout(() => this.open(), 500);
    };
  }
}
