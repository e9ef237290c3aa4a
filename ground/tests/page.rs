//! The page in a real Chromium: only where `BESSEMER_FULL` is 1 (`cargo xtask test --full`), since a browser is long to install.
//!
//! `BESSEMER_PICTURES=docs/figures` writes the pictures that README and results show.
//!
//! The testbed runs in real time, as the program does, but waits for the software: on a busy machine an aircraft whose
//! periods are missed falls, and the test is not about that. It waits for what the page shows.

mod browser;

use browser::Browser;
use ground::live::{self, Live};
use ground::player::Player;
use ground::program::{Program, Target};
use ground::server::{self, Hub};
use ground::testbed::{Pace, Testbed, Wanted};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

/// A testbed in real time with its server, in a thread of its own.
struct Running {
    address: String,
    end: Arc<AtomicBool>,
    thread: Option<JoinHandle<()>>,
    _folder: tempfile::TempDir,
}

impl Running {
    fn start() -> Self {
        let program = Program::build(&bessemer_legs::root(), Target::Native)
            .unwrap_or_else(|error| panic!("{error}"));
        let testbed =
            Testbed::start(&program, &Wanted { pace: Pace::Patient, ..Wanted::default() })
                .unwrap_or_else(|error| panic!("{error}"));
        let (asked, asks) = live::queue();
        let hub = Hub::new(asked, &live::hello(false)).expect("random bytes");
        let served = server::start(([127, 0, 0, 1], 0).into(), hub.clone()).expect("a port");
        let folder = tempfile::tempdir().expect("a folder");
        let address = format!("http://{served}/#token={}", hub.token());
        let end = Arc::new(AtomicBool::new(false));
        let (ended, place) = (end.clone(), folder.path().to_owned());
        let thread = std::thread::spawn(move || {
            let mut live = Live::new(testbed, hub, asks, place);
            while !ended.load(Ordering::Relaxed) {
                live.step().unwrap_or_else(|error| panic!("{error}"));
            }
        });
        Self { address, end, thread: Some(thread), _folder: folder }
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        self.end.store(true, Ordering::Relaxed);
        let _ = self.thread.take().map(JoinHandle::join);
    }
}

/// Whether the run leaves nothing out, and there is a browser.
fn is_asked_for() -> bool {
    if !std::env::var("BESSEMER_FULL").is_ok_and(|value| value == "1") {
        println!("left out: it takes a browser; BESSEMER_FULL=1 brings it in");
        return false;
    }
    let there = Browser::is_there();
    if !there {
        println!("left out: there is no chromium");
    }
    there
}

/// Writes a picture where `BESSEMER_PICTURES` says, if it does.
fn picture(browser: &mut Browser, name: &str) {
    if let Some(folder) = std::env::var_os("BESSEMER_PICTURES") {
        browser.see("scrollTo(0, 0)");
        browser.until("scrollY === 0");
        let path = bessemer_legs::root().join(folder).join(format!("ground-{name}.png"));
        std::fs::write(path, browser.picture()).expect("a folder for the pictures");
    }
}

#[test]
fn the_page_flies_the_aircraft() {
    if !is_asked_for() {
        return;
    }
    let running = Running::start();
    let mut browser = Browser::start();
    browser.prefer("light");
    browser.go(&running.address);
    browser.until("document.body.dataset.commands === 'true'");
    browser.until("document.body.dataset.phase === 'ready'");

    // By keys alone: arm, take off.
    browser.press("m");
    browser.until("document.querySelector('#log').innerText.includes('trajectory: done')");
    browser.press("t");
    browser.until("Number(document.body.dataset.height) > 0.9");

    // To a place in the plan: a quarter of the way right of its middle is 1.5 m along x.
    browser.click("#plan", (0.75, 0.5));
    browser.until("Number(document.body.dataset.place.split(',')[0]) > 1.3");
    // Weight taken away.
    browser.press("2");
    browser.until("document.querySelector('#mode').innerText === 'feed-forward'");
    picture(&mut browser, "flight-light");
    browser.prefer("dark");
    picture(&mut browser, "flight-dark");

    // The page dies: the flight goes on, and another page takes over.
    browser.close();
    browser.open();
    browser.go(&running.address);
    browser.until("document.body.dataset.commands === 'true'");
    browser.until("document.body.dataset.phase === 'flight'");

    // The software dies: it falls, comes back, and can be flown again.
    browser.click("#kill", (0.5, 0.5));
    browser.until("document.querySelector('#counts').innerText.includes('software started anew\\n1') || document.querySelector('#counts').lastChild.innerText === '1'");
    browser.until("document.body.dataset.phase === 'ready' && document.querySelector('#link').innerText.includes('%')");
    browser.click("#back", (0.5, 0.5));
    // The software has seen where it stands now.
    browser.until("Math.abs(Number(document.body.dataset.height)) < 0.05 && document.body.dataset.place.split(',').slice(0, 2).every((it) => Math.abs(Number(it)) < 0.2)");
    browser.press("m");
    browser.press("t");
    browser.until("Number(document.body.dataset.height) > 0.9");

    browser.press("Escape");
    browser.until("document.body.dataset.alarm === 'asked'");
    browser.until("document.body.dataset.phase === 'over'");

    assert_eq!(browser.see("document.body.dataset.failure ?? ''"), "");
}

/// A recording of two seconds on the ground, played in a thread of its own: the address of its page.
fn played(path: &std::path::Path) -> String {
    let program = Program::build(&bessemer_legs::root(), Target::Native)
        .unwrap_or_else(|error| panic!("{error}"));
    let wanted = Wanted { pace: Pace::Virtual, ..Wanted::default() };
    let mut testbed = Testbed::start(&program, &wanted).unwrap_or_else(|error| panic!("{error}"));
    let mut recorder = ground::recorder::Recorder::start(path.to_owned(), None);
    let run = testbed.run_until(2.0, |done, _| recorder.take(done));
    run.unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(recorder.finish().error, None);

    let (asked, asks) = live::queue();
    let hub = Hub::new(asked, &live::hello(false)).expect("random bytes");
    let mut player = Player::open(path, hub.clone(), asks).expect("a recording");
    let served = server::start(([127, 0, 0, 1], 0).into(), hub.clone()).expect("a port");
    // As the program does, until the test ends.
    std::thread::spawn(move || {
        let mut before = Instant::now();
        loop {
            std::thread::sleep(Duration::from_millis(10));
            player.step(before.elapsed().as_secs_f64());
            before = Instant::now();
        }
    });
    format!("http://{served}/#token={}", hub.token())
}

#[test]
fn the_page_shows_a_recording() {
    if !is_asked_for() {
        return;
    }
    let folder = tempfile::tempdir().expect("a folder");
    let address = played(&folder.path().join("flight.mcap"));
    let mut browser = Browser::start();
    browser.go(&address);
    browser.until("document.body.dataset.commands === 'true'");
    browser.until("document.querySelector('#link').innerText === 'recording'");
    browser.click("#play", (0.5, 0.5));
    browser.until("document.querySelector('#play').innerText === 'Play'");
    browser.see("const at = document.querySelector('#at'); at.value = 1.5; at.dispatchEvent(new Event('input'))");
    browser.until("document.body.dataset.playing === '1.50'");
    browser.until("document.body.dataset.phase === 'ready'");
    browser.click("#play", (0.5, 0.5));
    browser.until("Number(document.body.dataset.playing) > 1.9");
    assert_eq!(browser.see("document.body.dataset.failure ?? ''"), "");
}
