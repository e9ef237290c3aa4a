//! The page's server as a client sees it: HTTP and WebSocket, without a browser.
//!
//! The testbed is moved by the test, so that nothing waits for the clock: a test moves it until it sees what it
//! waits for. What is to come from the server's thread, however late that runs, is waited for, too.

use ground::live::{self, Live};
use ground::player::Player;
use ground::program::{Program, Target};
use ground::server::{self, Hub};
use ground::testbed::{Pace, Testbed, Wanted};
use serde_json::{Value, json};
use std::io::ErrorKind::Interrupted;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::{SocketAddr, TcpStream};
use std::sync::Arc;
use std::time::{Duration, Instant};
use tungstenite::client::IntoClientRequest;
use tungstenite::{HandshakeError, Message, WebSocket};

#[path = "server/links.rs"]
mod links;

use links::answered;

#[test]
fn the_page_is_what_its_sources_give() {
    let web = bessemer_legs::root().join("ground/web");
    let told = "build it: `npm ci && npm run build` in ground/web";
    let checked = std::process::Command::new("sha256sum")
        .args(["--check", "--strict", "--quiet", "../page/sums.txt"])
        .current_dir(&web)
        .output()
        .expect("coreutils are here");
    assert!(checked.status.success(), "{}{told}", String::from_utf8_lossy(&checked.stdout));
    let sums = std::fs::read_to_string(web.join("../page/sums.txt")).expect("the sums");
    for source in std::fs::read_dir(web.join("src")).expect("the sources") {
        let name = source.expect("a file").file_name();
        let line = format!("  src/{}\n", name.to_string_lossy());
        assert!(sums.contains(&line), "{line}{told}");
    }
}

struct Served {
    live: Live,
    hub: Arc<Hub>,
    address: SocketAddr,
    folder: tempfile::TempDir,
}

fn served() -> Served {
    let program = Program::build(&bessemer_legs::root(), Target::Native)
        .unwrap_or_else(|error| panic!("{error}"));
    let testbed = Testbed::start(&program, &Wanted { pace: Pace::Virtual, ..Wanted::default() })
        .unwrap_or_else(|error| panic!("{error}"));
    let (asked, asks) = live::queue();
    let hub = Hub::new(asked, &live::hello(sim::Aircraft::Mambo, false)).expect("random bytes");
    let address = server::start(([127, 0, 0, 1], 0).into(), hub.clone()).expect("a port");
    let folder = tempfile::tempdir().expect("a folder");
    let live = Live::new(testbed, hub.clone(), asks, folder.path().to_owned());
    Served { live, hub, address, folder }
}

/// Time limit of a wait. Only a broken server exceeds it.
const LIMIT: Duration = Duration::from_secs(120);

struct Page {
    socket: WebSocket<TcpStream>,
    /// First message to it: with that it receives all later messages to every page.
    hello: Value,
    /// Texts of the events that it has received.
    events: Vec<String>,
}

/// A page with an `Origin`; or the status with which it is turned away, if there is one.
fn page_from(address: SocketAddr, origin: Option<&str>) -> Result<Page, Option<u16>> {
    let mut request = format!("ws://{address}/live").into_client_request().expect("an address");
    if let Some(origin) = origin {
        request.headers_mut().insert("origin", origin.parse().expect("an origin"));
    }
    let stream = TcpStream::connect(address).expect("the server listens");
    match tungstenite::client(request, stream) {
        Ok((socket, _)) => {
            socket.get_ref().set_read_timeout(Some(LIMIT)).expect("a socket has a limit");
            let mut page = Page { socket, hello: Value::Null, events: Vec::new() };
            page.hello = page.hear("hello");
            Ok(page)
        }
        Err(HandshakeError::Failure(tungstenite::Error::Http(answer))) => {
            Err(Some(answer.status().as_u16()))
        }
        // Closed without a word.
        Err(HandshakeError::Failure(
            tungstenite::Error::Io(_) | tungstenite::Error::Protocol(_),
        )) => Err(None),
        Err(error) => panic!("{error}"),
    }
}

impl Page {
    fn open(served: &Served) -> Self {
        page_from(served.address, None).unwrap_or_else(|status| panic!("{status:?}"))
    }

    fn ask(&mut self, what: &Value) {
        self.socket.send(Message::text(what.to_string())).expect("the server listens");
    }

    /// Reads until a message of a type comes.
    fn hear(&mut self, kind: &str) -> Value {
        loop {
            let heard = match self.socket.read() {
                // This process was stopped, and goes on.
                Err(tungstenite::Error::Io(error)) if error.kind() == Interrupted => continue,
                heard => heard.expect("the server speaks"),
            };
            let message: Value =
                serde_json::from_str(heard.to_text().expect("it is text")).expect("it is JSON");
            if message["type"] == "event" {
                self.events.push(message["text"].as_str().expect("it has a text").to_owned());
            }
            if message["type"] == kind {
                return message;
            }
        }
    }

    /// Reads until a state comes for which something holds: earlier ones may still wait in the socket.
    fn state(&mut self, holds: impl Fn(&Value) -> bool) -> Value {
        loop {
            let state = self.hear("state");
            if holds(&state) {
                return state;
            }
        }
    }

    /// Commands, which the server grants or not.
    fn claim(&mut self, token: &str, force: bool) -> bool {
        self.ask(&json!({ "type": "claim", "token": token, "force": force }));
        self.hear("command")["granted"] == true
    }

    /// Waits until the server has read everything that was asked.
    fn settle(&mut self) {
        self.ask(&json!({ "type": "ping", "number": 1 }));
        self.hear("pong");
    }
}

impl Served {
    /// Moves the testbed until something holds.
    fn until(&mut self, what: &str, holds: impl Fn(&Testbed) -> bool) {
        let begun = Instant::now();
        while !holds(&self.live.testbed) {
            assert!(begun.elapsed() < LIMIT, "{what}: never");
            self.live.step().unwrap_or_else(|error| panic!("{error}"));
        }
    }

    fn get(&self, request: &str) -> String {
        self.get_from(request, &self.address.to_string())
    }

    fn get_from(&self, request: &str, host: &str) -> String {
        answered(self.address, &format!("{request} HTTP/1.1"), host)
    }
}

/// Arms the aircraft from a page, and waits until it is armed.
fn arm(served: &mut Served, page: &mut Page) {
    let now = served.live.testbed.now();
    served.until("telemetry", |testbed| testbed.now() > now + 1.0);
    page.ask(&json!({ "type": "arm" }));
    page.settle();
    served.until("armed", |testbed| testbed.station.phase() == models::Phase::Ready as u8);
}

fn height(testbed: &Testbed) -> f64 {
    testbed.bench.state().position.z
}

#[test]
fn a_page_takes_off_moves_lands_and_stops() {
    let mut served = served();
    let mut page = Page::open(&served);
    assert_eq!(page.hello["authenticated"], false);
    assert_eq!(page.hello["parameters"].as_array().map(Vec::len), Some(23));
    assert!(page.claim(served.hub.token(), false));
    let there = |x: f64| json!({ "type": "fly", "points": [{ "time": 0, "x": x, "y": 0, "z": 1, "yaw": 0 }] });
    page.ask(&there(0.0));
    arm(&mut served, &mut page);
    page.ask(&json!({ "type": "take_off" }));
    page.settle();
    served.until("in the air", |testbed| height(testbed) > 0.9);
    page.ask(&there(0.8));
    page.settle();
    served.until("there", |testbed| testbed.bench.state().position.x > 0.75);
    page.ask(&json!({ "type": "land" }));
    page.settle();
    served.until("down", |testbed| height(testbed) == 0.0);
    page.ask(&json!({ "type": "stop" }));
    page.settle();
    served.until("stopped", |testbed| testbed.station.signal(35) == 1.0);
}

#[test]
fn whoever_has_no_token_watches() {
    let mut served = served();
    let mut page = Page::open(&served);
    assert!(!page.claim("", false) && !page.claim(&"0".repeat(32), true));
    for request in [json!({ "type": "stop" }), json!({ "type": "take_off" })] {
        page.ask(&request);
        assert_eq!(page.hear("refused")["reason"], "this page does not command");
    }
    page.ask(&json!({ "type": "nonsense" }));
    let unknown = "the server does not know the request \"nonsense\" in this form: reload the page";
    assert_eq!(page.hear("refused")["reason"], unknown);
    served.until("frames", |testbed| testbed.now() > 1.0);
    page.hear("frame");
    assert_eq!(page.hear("state")["commanded"], false);
}

#[test]
fn one_page_commands_and_any_with_the_token_stops() {
    let mut served = served();
    let token = served.hub.token().to_owned();
    let (mut one, mut other) = (Page::open(&served), Page::open(&served));
    assert!(one.claim(&token, false));
    assert!(!other.claim(&token, false));
    other.ask(&json!({ "type": "take_off" }));
    assert_eq!(other.hear("refused")["reason"], "this page does not command");
    other.ask(&json!({ "type": "stop" }));
    other.settle();
    served.until("stopped", |testbed| testbed.station.signal(35) == 1.0);
    assert!(other.claim(&token, true), "taken away");
    served.until("a frame", |testbed| testbed.now() > 3.0);
    assert_eq!(one.hear("command")["reason"], "another client has taken command");
    one.ask(&json!({ "type": "arm" }));
    assert_eq!(one.hear("refused")["reason"], "this page does not command");
    // Whoever leaves, commands no more.
    drop(other);
    let hub = served.hub.clone();
    served.until("free", |_| !hub.is_commanded());
    assert!(one.claim(&token, false));
}

#[test]
fn pages_of_others_are_turned_away() {
    let served = served();
    let own = format!("http://{}", served.address);
    assert!(page_from(served.address, Some(&own)).is_ok());
    for origin in ["http://example.org", "null", "http://127.0.0.1:1", "file://"] {
        assert_eq!(page_from(served.address, Some(origin)).err(), Some(Some(403)), "{origin}");
    }
}

#[test]
fn nothing_is_commanded_by_a_get() {
    let mut served = served();
    for path in ["/take_off", "/stop", "/live", "/../Cargo.toml", "/live?type=stop", "/flight.mcap"]
    {
        let answer = served.get(&format!("GET {path}"));
        assert!(answer.starts_with("HTTP/1.1 4"), "{path}: {answer}");
    }
    assert!(served.get("POST /").starts_with("HTTP/1.1 405"));
    let page = served.get("GET /");
    assert!(page.starts_with("HTTP/1.1 200") && page.contains("page.js"), "{page}");
    served.until("a second", |testbed| testbed.now() > 1.0);
    assert_eq!(served.live.testbed.station.signal(35), 0.0);
}

#[test]
fn a_page_that_reads_nothing_holds_nobody_up() {
    let mut served = served();
    let _slow = Page::open(&served);
    let pages: Vec<Page> = (0..100).map(|_| Page::open(&served)).collect();
    served.until("most of a minute", |testbed| testbed.now() > 45.0);
    assert_eq!(served.live.timing().missed, 0);
    let mut last = pages.into_iter().next_back().expect("a hundred");
    assert!(last.hear("state")["pages"].as_u64().is_some_and(|pages| pages >= 101));
}

/// Number of simultaneous clients.
const CLIENTS: usize = 1000;

/// Address of the server, set only for the process that plays the clients.
const SERVER_ADDRESS: &str = "GROUND_CROWD";

/// A crowd of its own files: this program once more, in which only this test runs.
fn crowd(address: SocketAddr) -> std::process::Child {
    let here = std::env::current_exe().expect("this program");
    std::process::Command::new(here)
        .args(["--exact", "a_thousand_connections_keep_nobody_from_flying", "--nocapture"])
        .env(SERVER_ADDRESS, address.to_string())
        .stdin(std::process::Stdio::piped())
        .stdout(std::process::Stdio::piped())
        .spawn()
        .expect("it starts")
}

/// Connects, every second one as a page as far as that is granted, and stays until nobody is interested any more.
fn be_a_crowd(address: &str) {
    let address: SocketAddr = address.parse().expect("an address");
    let mut waiting = Vec::new();
    for n in 0..CLIENTS {
        let mut stream = TcpStream::connect(address).expect("it is let in, or turned away");
        if n % 2 == 0 {
            let opening = format!(
                "GET /live HTTP/1.1\r\nHost: {address}\r\nConnection: Upgrade\r\nUpgrade: websocket\r\n\
                 Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n"
            );
            // Whoever is turned away need not say anything.
            let _ = stream.write_all(opening.as_bytes());
        }
        waiting.push(stream);
    }
    println!("\ncrowded");
    let _ = std::io::stdin().read(&mut [0]);
}

#[test]
fn a_thousand_connections_keep_nobody_from_flying() {
    if let Ok(address) = std::env::var(SERVER_ADDRESS) {
        return be_a_crowd(&address);
    }
    let mut served = served();
    let mut page = Page::open(&served);
    assert!(page.claim(served.hub.token(), false));
    let mut crowd = crowd(served.address);
    let mut said = BufReader::new(crowd.stdout.take().expect("it is piped")).lines();
    assert!(said.any(|line| line.is_ok_and(|line| line == "crowded")));
    let (hub, served_at) = (served.hub.clone(), served.address);
    served.until("crowded", |_| hub.pages() > 200);
    arm(&mut served, &mut page);

    let points = json!([{ "time": 0, "x": 0, "y": 0, "z": 1, "yaw": 0 }]);
    page.ask(&json!({ "type": "fly", "points": points }));
    page.ask(&json!({ "type": "take_off" }));
    page.ask(&json!({ "type": "record" }));
    page.settle();
    served.until("in the air", |testbed| height(testbed) > 0.9);
    // The software, too, can be started anew: there are files left for it.
    page.ask(&json!({ "type": "kill" }));
    page.settle();
    let now = served.live.testbed.now();
    served.until("met again", |testbed| testbed.restarts == 1 && testbed.now() > now + 3.0);
    assert!(served.live.testbed.bench.is_answered() && served.live.timing().missed == 0);
    let state = page.state(|state| state["time"].as_f64().is_some_and(|time| time > now));
    assert!(state["pages"].as_u64().is_some_and(|pages| pages <= 256), "{state}");

    // They leave; whoever comes now is let in.
    drop(crowd.stdin.take());
    crowd.wait().expect("it has left");
    served.until("let in", |_| page_from(served_at, None).is_ok());
}

#[test]
fn a_full_disk_ends_the_recording_and_nothing_else() {
    let mut served = served();
    served.live.record("/dev/full".into()).expect("it can be opened");
    let mut page = Page::open(&served);
    served.until("a while", |testbed| testbed.now() > 30.0);
    served.live.save();
    served.until("told", |testbed| testbed.now() > 31.0);
    let state = page.state(|state| state["time"].as_f64().is_some_and(|time| time >= 30.5));
    let error = state["recording"]["error"].as_str().unwrap_or_default().to_owned();
    assert!(error.contains("No space left"), "{state}");
    assert!(served.live.testbed.bench.is_answered());
}

#[test]
fn a_recording_that_cannot_begin_is_shown_on_the_page() {
    let mut served = served();
    let token = served.hub.token().to_owned();
    let mut page = Page::open(&served);
    assert!(page.claim(&token, false));
    std::fs::remove_dir(served.folder.path()).expect("it is empty");
    page.ask(&json!({ "type": "record" }));
    page.settle();
    served.until("a second", |testbed| testbed.now() > 1.0);
    let state = page.state(|state| !state["recording"]["error"].is_null());
    let error = state["recording"]["error"].as_str().unwrap_or_default().to_owned();
    assert!(error.contains("cannot be written: No such file or directory"), "{state}");
    assert_eq!(served.live.failure().as_ref(), Some(&error), "and on the terminal");
    assert_eq!(served.live.failure(), None, "once");
}

#[test]
fn a_seed_of_a_campaign_is_shown() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("seed.mcap");
    let scenario = sim::campaign::Kind::Failures.scenario(7);
    ground::recorder::simulated(&scenario, path.clone()).expect("it is written");
    let (sender, asks) = live::queue();
    let hub = Hub::new(sender, &live::hello(sim::Aircraft::Mambo, false)).expect("random bytes");
    let player = Player::open(&path, hub, asks).expect("a recording");
    assert!((player.playing().to - scenario.duration).abs() < 0.1, "the whole flight");
}

#[test]
fn a_flight_that_is_over_is_shown_again() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("flight.mcap");
    let mut served = served();
    served.live.record(path.clone()).expect("it can be written");
    served.until("two seconds", |testbed| testbed.now() > 2.0);
    served.live.save();

    let (asked, asks) = live::queue();
    let hub = Hub::new(asked, &live::hello(sim::Aircraft::Mambo, false)).expect("random bytes");
    let mut player = Player::open(&path, hub.clone(), asks).expect("a recording");
    let address = server::start(([127, 0, 0, 1], 0).into(), hub.clone()).expect("a port");
    let mut page = page_from(address, None).unwrap_or_else(|status| panic!("{status:?}"));
    // The whole flight comes first: 50 samples a second of each signal.
    let flight = page.hear("flight");
    let lengths = |it: &Value| it.as_array().map(Vec::len);
    assert_eq!((lengths(&flight["times"]), lengths(&flight["columns"][0])), (Some(101), Some(101)));
    assert_eq!((lengths(&flight["signals"]), lengths(&flight["columns"])), (Some(57), Some(57)));
    assert!(page.claim(hub.token(), false));
    page.settle();
    player.step(0.0);
    assert_eq!(page.hear("frame")["period"], 0);
    player.step(0.021);
    let second = page.hear("frame");
    assert_eq!(second["period"], 4);
    assert_eq!(second["signals"].as_array().map(Vec::len), Some(57));
    // Back and forth, and at another pace.
    page.ask(&json!({ "type": "play", "speed": 0 }));
    page.ask(&json!({ "type": "seek", "time": 1.501 }));
    page.settle();
    player.step(10.0);
    assert_eq!(page.hear("frame")["period"], 300);
    let playing = page.hear("playing");
    assert_eq!((&playing["time"], &playing["speed"]), (&json!(1.501), &json!(0.0)));
    page.ask(&json!({ "type": "play", "speed": 2 }));
    page.ask(&json!({ "type": "seek", "time": 0.501 }));
    page.settle();
    player.step(0.25);
    assert_eq!(page.hear("frame")["period"], 100);
    assert!((player.playing().time - 1.001).abs() < 1e-9);
    page.ask(&json!({ "type": "take_off" }));
    page.settle();
    player.step(0.0);
    assert_eq!(page.hear("refused")["reason"], "a flight that is over takes no orders");
}

#[test]
fn what_happens_to_the_aircraft_is_an_event_for_pages_and_recordings() {
    let mut served = served();
    let path = served.folder.path().join("events.mcap");
    served.live.record(path.clone()).expect("it can be written");
    let mut page = Page::open(&served);
    assert!(page.claim(served.hub.token(), false));
    page.ask(
        &json!({ "type": "fly", "points": [{ "time": 0, "x": 0, "y": 0, "z": 1, "yaw": 0 }] }),
    );
    arm(&mut served, &mut page);
    page.ask(&json!({ "type": "take_off" }));
    page.settle();
    served.until("in the air", |testbed| height(testbed) > 0.9);
    page.ask(&json!({ "type": "inject", "injection": { "what": "vicon", "away": true } }));
    page.settle();
    let now = served.live.testbed.now();
    served.until("without motion capture", |testbed| testbed.now() > now + 1.0);
    page.ask(&json!({ "type": "inject", "injection": { "what": "vicon", "away": false } }));
    page.ask(&json!({ "type": "inject", "injection": { "what": "motor", "number": 0 } }));
    page.settle();
    served.until("down", |testbed| height(testbed) == 0.0);
    page.ask(&json!({ "type": "kill" }));
    page.settle();
    served.until("again", |testbed| testbed.restarts == 1);
    served.live.step().unwrap_or_else(|error| panic!("{error}"));
    served.live.save();

    let expected = [
        "armed",
        "take-off",
        "flight",
        "fault injection: motion capture lost",
        "motion capture lost",
        "fault injection: motor 1 stopped",
        "motion capture back after",
        "alarm: ",
        "crash: hit the ground at",
        "fault injection: onboard software stopped",
        "the onboard software ended and was restarted",
    ];
    // The page that looked on, one that opens later, and one that looks at the recording.
    let (requests, queue) = live::queue();
    let hub = Hub::new(requests, &live::hello(sim::Aircraft::Mambo, false)).expect("random bytes");
    let _player = Player::open(&path, hub.clone(), queue).expect("a recording");
    let replayed = server::start(([127, 0, 0, 1], 0).into(), hub).expect("a port");
    let replayed = page_from(replayed, None).unwrap_or_else(|status| panic!("{status:?}"));
    for mut page in [page, Page::open(&served), replayed] {
        // Events follow the next message.
        page.settle();
        page.settle();
        let mut events = page.events.iter();
        for text in expected {
            assert!(events.any(|event| event.contains(text)), "{text}: {:?}", page.events);
        }
    }
}

#[test]
fn what_is_refused_is_reported_at_once_with_its_reason() {
    let mut served = served();
    let mut page = Page::open(&served);
    assert!(page.claim(served.hub.token(), false));
    let point = |x: f64| json!({ "type": "fly", "points": [{ "time": 0, "x": x, "y": 0, "z": 1, "yaw": 0 }] });
    served.until("telemetry", |testbed| testbed.now() > 1.5);
    for ask in [
        json!({ "type": "take_off" }),
        point(99.0),
        json!({ "type": "set", "number": 0, "value": 99 }),
    ] {
        page.ask(&ask);
    }
    page.settle();
    served.live.step().unwrap_or_else(|error| panic!("{error}"));
    // A flight, after which its trajectory is not flown again.
    arm(&mut served, &mut page);
    page.ask(&point(0.0));
    page.ask(&json!({ "type": "take_off" }));
    page.settle();
    served.until("in the air", |testbed| height(testbed) > 0.9);
    page.ask(&json!({ "type": "arm" }));
    page.ask(&json!({ "type": "disarm" }));
    page.ask(&json!({ "type": "land" }));
    page.settle();
    served.until("over", |testbed| testbed.station.phase() == models::Phase::Over as u8);
    page.ask(&json!({ "type": "take_off" }));
    arm(&mut served, &mut page);
    page.ask(&json!({ "type": "take_off" }));
    page.settle();
    served.live.step().unwrap_or_else(|error| panic!("{error}"));
    page.settle();
    page.settle();
    let refused: Vec<&str> = page
        .events
        .iter()
        .filter_map(|event| event.split_once(" refused: ").map(|(_, reason)| reason))
        .collect();
    let expected = [
        "the aircraft is disarmed: arm it first",
        "x of point 1 is 99 m; allowed are -3 to 3 m",
        "99 N/m; allowed are 0.5 to 3 N/m",
        "the aircraft is flying",
        "the aircraft is flying: land it, or press STOP",
        "the aircraft is disarmed: arm it first",
        "no trajectory since the last flight: send one first",
    ];
    assert_eq!(refused, expected);
}

#[test]
fn a_recording_is_made_and_downloaded() {
    let mut served = served();
    let token = served.hub.token().to_owned();
    let mut page = Page::open(&served);
    assert!(page.claim(&token, false));
    page.ask(&json!({ "type": "record" }));
    page.settle();
    served.until("a second", |testbed| testbed.now() > 1.0);
    page.ask(&json!({ "type": "save" }));
    page.settle();
    served.until("saved", |testbed| testbed.now() > 2.0);
    let answer = served.get(&format!("GET /flight.mcap?token={token}"));
    assert!(answer.starts_with("HTTP/1.1 200") && answer.contains("MCAP0"));
    let state = page.state(|state| state["time"].as_f64().is_some_and(|time| time > 1.5));
    let name = state["recordings"][0]["name"].as_str().unwrap_or_default().to_owned();
    assert!(name.starts_with("flight-") && name.ends_with(".mcap"), "{state}");
    let file = served.folder.path().join(&name);
    let length = file.metadata().expect("the file").len();
    assert_eq!(state["recordings"][0]["bytes"], length);
    assert!(state["recordings"][0]["written"].as_f64().is_some_and(|it| it > 1.7e9), "{state}");
    let names: Vec<&str> = state["sensors"]
        .as_array()
        .into_iter()
        .flatten()
        .filter_map(|it| it["name"].as_str())
        .collect();
    assert_eq!(names, ["gyroscope", "motion capture", "height", "horizontal motion"]);
    assert!(state["sensors"].as_array().is_some_and(|it| it.iter().all(|it| it["lost"].is_null())));
    let path = format!("GET /recordings/{name}");
    let answer = served.get(&format!("{path}?token={token}"));
    assert!(answer.starts_with("HTTP/1.1 200") && answer.contains("MCAP0"));
    for (name, status) in [(path.as_str(), 403), ("GET /recordings/..%2FCargo.toml", 403)] {
        assert!(served.get(name).starts_with(&format!("HTTP/1.1 {status}")), "{name}");
    }
    let other = served.get(&format!("GET /recordings/..%2FCargo.toml?token={token}"));
    assert!(other.starts_with("HTTP/1.1 404"), "{other}");
    for query in ["", "?token=", "?token=0", "?other=1"] {
        let answer = served.get(&format!("GET /flight.mcap{query}"));
        assert!(answer.starts_with("HTTP/1.1 403"), "{query}: {answer}");
    }
    let answer = served.get_from(&format!("GET /flight.mcap?token={token}"), "example.org");
    assert!(answer.starts_with("HTTP/1.1 403"), "{answer}");
    assert!(std::fs::read_dir(served.folder.path()).expect("the folder").count() == 1);
}
