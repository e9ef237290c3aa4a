//! A real Chromium, driven through its DevTools protocol: one page at a time.
//!
//! Waits for what a page shows, never for a time: the limit only ends a test that would never end.

use serde_json::{Value, json};
use std::io::ErrorKind::Interrupted;
use std::io::{BufRead, BufReader};
use std::net::TcpStream;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};
use tempfile::TempDir;
use tungstenite::stream::MaybeTlsStream;
use tungstenite::{Message, WebSocket};

/// More than a page has controls.
const CONTROLS: usize = 300;

/// So long a test waits for what has to come.
const LIMIT: Duration = Duration::from_secs(120);

const FLAGS: &[&str] = &[
    "--headless",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--remote-debugging-port=0",
    "--window-size=1500,1150",
];

/// A running browser with one page.
pub struct Browser {
    child: Child,
    socket: WebSocket<MaybeTlsStream<TcpStream>>,
    session: String,
    target: String,
    number: u64,
    _profile: TempDir,
}

impl Browser {
    /// Returns true if a browser is installed.
    pub fn is_there() -> bool {
        let asked = Command::new("chromium").arg("--version").stdout(Stdio::null()).status();
        asked.is_ok_and(|status| status.success())
    }

    /// Starts it with an empty page.
    pub fn start() -> Self {
        let profile = tempfile::tempdir().expect("a folder for the profile");
        let mut child = Command::new("chromium")
            .args(FLAGS)
            .arg(format!("--user-data-dir={}", profile.path().display()))
            .arg("about:blank")
            .stderr(Stdio::piped())
            .stdout(Stdio::null())
            .spawn()
            .expect("chromium starts");
        let lines = BufReader::new(child.stderr.take().expect("it is piped")).lines();
        let mut lines = lines.map_while(Result::ok);
        let address = lines
            .find_map(|line| line.strip_prefix("DevTools listening on ").map(str::to_owned))
            .expect("chromium says where it listens");
        // What else it says is nobody's news, but has to go somewhere.
        std::thread::spawn(move || lines.for_each(drop));
        let (socket, _) = tungstenite::connect(address).expect("chromium answers");
        if let MaybeTlsStream::Plain(stream) = socket.get_ref() {
            stream.set_read_timeout(Some(LIMIT)).expect("a socket has a limit");
        }
        let (session, target) = (String::new(), String::new());
        let mut browser = Self { child, socket, session, target, number: 0, _profile: profile };
        browser.open();
        browser
    }

    /// A new page, in place of the one before.
    pub fn open(&mut self) {
        self.session.clear();
        let made = self.ask("Target.createTarget", &json!({ "url": "about:blank" }));
        self.target = made["targetId"].as_str().expect("a page").to_owned();
        let attach = json!({ "targetId": self.target, "flatten": true });
        let attached = self.ask("Target.attachToTarget", &attach);
        self.session = attached["sessionId"].as_str().expect("a session").to_owned();
        self.ask("Page.enable", &json!({}));
    }

    /// Kills the page as a crash would.
    pub fn close(&mut self) {
        self.session.clear();
        let target = self.target.clone();
        self.ask("Target.closeTarget", &json!({ "targetId": target }));
    }

    /// Goes to an address.
    pub fn go(&mut self, address: &str) {
        self.ask("Page.navigate", &json!({ "url": address }));
    }

    /// Light or dark.
    pub fn prefer(&mut self, scheme: &str) {
        let feature = json!([{ "name": "prefers-color-scheme", "value": scheme }]);
        self.ask("Emulation.setEmulatedMedia", &json!({ "features": feature }));
    }

    /// Shows the page on a screen of this size, in pixels.
    pub fn size(&mut self, width: u32, height: u32) {
        let screen = json!({ "width": width, "height": height, "deviceScaleFactor": 1, "mobile": width < 700 });
        self.ask("Emulation.setDeviceMetricsOverride", &screen);
    }

    /// Returns the value of an expression on the page.
    pub fn see(&mut self, expression: &str) -> Value {
        let asked = json!({ "expression": expression, "returnByValue": true });
        self.ask("Runtime.evaluate", &asked)["result"]["value"].clone()
    }

    /// Waits until an expression is true.
    pub fn until(&mut self, expression: &str) {
        let begun = Instant::now();
        while self.see(expression) != json!(true) {
            if begun.elapsed() > LIMIT {
                let body = self.see("JSON.stringify({...document.body.dataset, log: document.querySelector('#log')?.innerText})");
                panic!("`{expression}` never came true: {body}");
            }
            std::thread::sleep(Duration::from_millis(50));
        }
    }

    /// Presses a key, wherever the focus is.
    pub fn press(&mut self, key: &str) {
        let code = match key {
            "Tab" => 9,
            "Enter" => 13,
            "Escape" => 27,
            "ArrowRight" => 39,
            "ArrowDown" => 40,
            letter => i64::from(letter.to_uppercase().as_bytes()[0]),
        };
        // What a key writes is what makes it press a button.
        let text = match key {
            "Enter" => "\r",
            " " => " ",
            _ => "",
        };
        let down = if text.is_empty() { "rawKeyDown" } else { "keyDown" };
        for kind in [down, "keyUp"] {
            let mut event = json!({ "type": kind, "key": key, "windowsVirtualKeyCode": code });
            if kind == "keyDown" {
                event["text"] = json!(text);
            }
            self.ask("Input.dispatchKeyEvent", &event);
        }
    }

    /// Holds a key until an expression is true.
    pub fn hold(&mut self, key: &str, expression: &str) {
        let code = i64::from(key.to_uppercase().as_bytes()[0]);
        let event = |kind: &str| json!({ "type": kind, "key": key, "windowsVirtualKeyCode": code });
        self.ask("Input.dispatchKeyEvent", &event("rawKeyDown"));
        self.until(expression);
        self.ask("Input.dispatchKeyEvent", &event("keyUp"));
    }

    /// Goes from control to control by the tabulator until the focus is on an element; whether it came there.
    pub fn tab_to(&mut self, selector: &str) -> bool {
        let there = format!("document.activeElement === document.querySelector('{selector}')");
        (0..CONTROLS).any(|_| {
            self.press("Tab");
            self.see(&there) == json!(true)
        })
    }

    /// Writes in place of what a field holds.
    pub fn write(&mut self, text: &str) {
        self.see("document.activeElement.select()");
        self.ask("Input.insertText", &json!({ "text": text }));
    }

    /// Clicks in an element: where, as shares of its width and height.
    pub fn click(&mut self, selector: &str, share: (f64, f64)) {
        let place = self.see(&format!(
            "(() => {{ const it = document.querySelector('{selector}'); it.scrollIntoView({{ block: 'center' }}); \
             const box = it.getBoundingClientRect(); return [box.left, box.top, box.width, box.height]; }})()"
        ));
        let edge = |n: usize| place[n].as_f64().expect("the element is there");
        let (x, y) = (edge(0) + share.0 * edge(2), edge(1) + share.1 * edge(3));
        for kind in ["mousePressed", "mouseReleased"] {
            let event = json!({ "type": kind, "x": x, "y": y, "button": "left", "clickCount": 1 });
            self.ask("Input.dispatchMouseEvent", &event);
        }
    }

    /// For how long the page's thread was busy since it began, and with scripts, s.
    pub fn busy(&mut self) -> [f64; 2] {
        self.ask("Performance.enable", &json!({}));
        let told = self.ask("Performance.getMetrics", &json!({}));
        let metrics = told["metrics"].as_array().cloned().unwrap_or_default();
        ["TaskDuration", "ScriptDuration"].map(|name| {
            let found = metrics.iter().find(|it| it["name"] == name);
            found.and_then(|it| it["value"].as_f64()).expect("chromium counts it")
        })
    }

    /// A picture of the page, as PNG.
    pub fn picture(&mut self) -> Vec<u8> {
        let shot = self.ask("Page.captureScreenshot", &json!({ "format": "png" }));
        decoded(shot["data"].as_str().expect("a picture"))
    }

    fn ask(&mut self, method: &str, parameters: &Value) -> Value {
        self.number += 1;
        let number = self.number;
        let mut asked = json!({ "id": number, "method": method, "params": parameters });
        if !self.session.is_empty() {
            asked["sessionId"] = json!(self.session);
        }
        self.socket.send(Message::text(asked.to_string())).expect("chromium listens");
        loop {
            let heard = self.socket.read();
            // This process was stopped, and goes on.
            if matches!(&heard, Err(tungstenite::Error::Io(error)) if error.kind() == Interrupted) {
                continue;
            }
            let heard = heard.unwrap_or_else(|error| panic!("{method} is not answered: {error}"));
            let Ok(text) = heard.to_text() else { continue };
            let Ok(answer) = serde_json::from_str::<Value>(text) else { continue };
            if answer["id"] == json!(number) {
                assert!(answer["error"].is_null(), "{method}: {}", answer["error"]);
                return answer["result"].clone();
            }
        }
    }
}

impl Drop for Browser {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// Base 64.
fn decoded(text: &str) -> Vec<u8> {
    const LETTERS: &[u8] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let value = |letter: u8| LETTERS.iter().position(|it| *it == letter).map(|it| it as u32);
    let mut bytes = Vec::new();
    let (mut bits, mut count) = (0_u32, 0);
    for six in text.bytes().filter_map(value) {
        (bits, count) = (bits << 6 | six, count + 6);
        if count >= 8 {
            count -= 8;
            bytes.push((bits >> count & 0xFF) as u8);
        }
    }
    bytes
}
