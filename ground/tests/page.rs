//! The page in a real Chromium: only where `BESSEMER_FULL` is 1 (`cargo xtask test --full`), since a browser is long to install.
//!
//! `BESSEMER_REACH=600 cargo test --profile fast -p ground --test page -- smooth --nocapture` flies it for so many seconds,
//! and writes how many messages and pictures there were to `docs/results/smooth.md`.
//!
//! `BESSEMER_PICTURES=docs/figures` writes the pictures that README and results show.
//!
//! The testbed runs in real time, as the program does, but waits for the software: on a busy machine an aircraft whose
//! periods are missed falls, and the test is not about that. It waits for what the page shows.

mod browser;
mod conditions;

use browser::Browser;
use conditions::Conditions;
use ground::events::{Event, Severity};
use ground::live::{self, Live};
use ground::player::Player;
use ground::program::{Program, Target};
use ground::server::{self, Hub};
use ground::testbed::{Pace, Testbed, Wanted};
use sim::Aircraft;
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
    fn start(pace: Pace) -> Self {
        Self::flying(Aircraft::Mambo, pace)
    }

    fn flying(aircraft: Aircraft, pace: Pace) -> Self {
        let program = Program::build(&bessemer_legs::root(), Target::Native)
            .unwrap_or_else(|error| panic!("{error}"));
        let testbed = Testbed::start(&program, &Wanted { aircraft, pace, ..Wanted::default() })
            .unwrap_or_else(|error| panic!("{error}"));
        let (asked, asks) = live::queue();
        let hub = Hub::new(asked, &live::hello(aircraft, false)).expect("random bytes");
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

/// Returns true if the run is complete and a browser is installed.
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
    let running = Running::start(Pace::Patient);
    let mut browser = Browser::start();
    browser.prefer("light");
    browser.go(&running.address);
    browser.until("document.body.dataset.commands === 'true'");
    browser.until("document.body.dataset.phase === 'disarmed'");

    // By keys alone: arm, disarm, arm, take off.
    browser.until("document.querySelectorAll('#checks .good').length === 5");
    browser.press("m");
    browser.until("document.body.dataset.phase === 'armed'");
    browser.press("n");
    browser.until("document.body.dataset.phase === 'disarmed'");
    browser.until("document.querySelectorAll('#checks .good').length === 5");
    browser.press("m");
    browser.until("document.body.dataset.phase === 'armed'");
    browser.click("#fly", (0.5, 0.5));
    browser.until("document.querySelector('#log').innerText.includes('trajectory: done')");
    browser.press("t");
    browser.until("Number(document.body.dataset.height) > 0.9");

    // To a place in the plan: a quarter of the way right of its middle is 1.5 m along x.
    browser.click("#plan", (0.75, 0.5));
    browser.until("Number(document.body.dataset.place.split(',')[0]) > 1.3");
    // At the height of the trajectory, though the set point was on its way there.
    let height = "document.querySelector('[aria-label=\"z of point 1\"]').value";
    assert_eq!(browser.see(height), "1");
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
    browser.until("document.querySelector('#counts').innerText.includes('software restarts\\n1') || document.querySelector('#counts').lastChild.innerText === '1'");
    browser.until("document.body.dataset.phase === 'disarmed' && document.querySelector('#link').innerText.includes('%')");
    browser.click("#back", (0.5, 0.5));
    // The software has seen at its place now.
    browser.until("Math.abs(Number(document.body.dataset.height)) < 0.05 && document.body.dataset.place.split(',').slice(0, 2).every((it) => Math.abs(Number(it)) < 0.2)");
    browser.until("document.querySelectorAll('#checks .good').length === 5");
    browser.press("m");
    browser.until("document.body.dataset.phase === 'armed'");
    browser.click("#fly", (0.5, 0.5));
    browser.until("document.querySelector('#log').innerText.includes('trajectory: done')");
    browser.press("t");
    browser.until("Number(document.body.dataset.height) > 0.9");

    browser.press("Escape");
    browser.until("document.body.dataset.alarm === 'commanded'");
    browser.until("document.body.dataset.phase === 'disarmed'");

    assert_eq!(browser.see("document.body.dataset.failure ?? ''"), "");
}

#[test]
fn the_page_shows_six_motors_and_fits_a_phone() {
    if !is_asked_for() {
        return;
    }
    let running = Running::flying(Aircraft::F550, Pace::Patient);
    let mut browser = Browser::start();
    browser.size(390, 844);
    browser.go(&running.address);
    browser.until("document.body.dataset.commands === 'true'");
    browser.until("document.body.dataset.phase === 'disarmed'");
    // STOP is as wide as the screen, at its lower edge, and actions come before pictures.
    let stop = browser.see(
        "(() => { const { left, right, bottom } = document.querySelector('#stop').getBoundingClientRect(); return [left, right, bottom]; })()",
    );
    assert_eq!(stop, serde_json::json!([8, 382, 836]));
    let top = "document.querySelector('{}').getBoundingClientRect().top";
    let first = |one: &str, other: &str| {
        format!("{} < {}", top.replace("{}", one), top.replace("{}", other))
    };
    assert_eq!(browser.see(&first("#flight", "#scene")), true);
    assert_eq!(browser.see(&first("#scene", "#plots")), true);
    let overflow = "document.documentElement.scrollWidth - innerWidth";
    assert_eq!(browser.see(overflow), 0);
    picture(&mut browser, "phone");

    browser.size(1500, 1150);
    assert_eq!(browser.see("document.querySelectorAll('#motors .motor').length"), 6);
    assert_eq!(browser.see("document.querySelectorAll('#motor option').length"), 7);
    browser.until("document.querySelectorAll('#checks .good').length === 5");
    browser.until("document.querySelector('#armed').innerText === 'disarmed'");
    browser.press("m");
    browser.until("document.querySelector('#armed').innerText === 'armed'");
    browser.until("document.querySelector('#parameter-0').value === '16'");
    browser.click("#fly", (0.5, 0.5));
    browser.until("document.querySelector('#log').innerText.includes('trajectory: done')");
    browser.press("t");
    browser.until("document.querySelector('#armed').innerText === 'running'");
    browser.until("document.querySelector('#planned').innerText === 'is flown: point 1 of 1'");
    browser.until(
        "[...document.querySelectorAll('#motors b')].every((it) => Number(it.innerText) > 100)",
    );
    browser.until("Number(document.body.dataset.height) > 0.9");
    browser.click("#vicon", (0.5, 0.5));
    browser.until(
        "document.querySelector('#sensors .bad').innerText.startsWith('motion capture lost for ')",
    );
    picture(&mut browser, "hexacopter");
    assert_eq!(browser.see("document.body.dataset.failure ?? ''"), "");
}

/// Selector of everything that the tabulator must reach.
const CONTROLS: &str = "[...document.querySelectorAll('button, input, select, summary, a[href], [tabindex]')]\
    .filter((it) => !it.disabled && it.checkVisibility())";

#[test]
fn the_page_is_used_by_keys_alone() {
    if !is_asked_for() {
        return;
    }
    let running = Running::start(Pace::Patient);
    let mut browser = Browser::start();
    browser.go(&running.address);
    browser.until("document.body.dataset.commands === 'true'");
    browser.until("document.body.dataset.phase === 'disarmed'");

    // The tabulator comes to everything.
    for part in ["#tuning", "#logging"] {
        assert!(browser.tab_to(&format!("{part} summary")), "{part}");
        browser.press("Enter");
        browser.until(&format!("document.querySelector('{part}').open"));
    }
    let count = browser.see(&format!("{CONTROLS}.length")).as_u64().expect("a number");
    assert!(count > 100, "{count}");
    browser.see(
        "addEventListener('focusin', (event) => { event.target.dataset.focused = 1; }); document.activeElement.blur()",
    );
    for _ in 0..count + 5 {
        browser.press("Tab");
    }
    let left = browser.see(&format!(
        "{CONTROLS}.filter((it) => !it.dataset.focused).map((it) => it.outerHTML.slice(0, 80)).join('\\n')"
    ));
    assert_eq!(left, "", "out of reach");

    // A parameter, within its range and out of it; another law, which is changed on the ground.
    assert!(browser.tab_to("#parameter-0"));
    browser.write("2");
    browser.press("Enter");
    browser.until("document.querySelector('#log').innerText.includes('set parameter 0: done')");
    browser.until("document.querySelector('#modified').innerText === '1'");
    browser.until("document.querySelector('#parameter-0').closest('tr').className === 'modified'");
    browser.write("99");
    browser.press("Enter");
    browser.until("document.querySelector('#log').innerText.includes('height P: 0.5 to 3')");
    assert!(browser.tab_to("#parameter-19"));
    browser.press("ArrowDown");
    browser.press("ArrowDown");
    browser.until("document.querySelector('#parameter-19').value === '2'");
    browser.until("document.querySelector('#log').innerText.includes('set parameter 19: done')");
    assert!(browser.tab_to("#parameters-reset"));
    browser.press("Enter");
    browser.until("document.querySelector('#modified').innerText === '0'");

    // Into the air, and to a point of the plan: eleven steps of 10 cm along x.
    assert!(browser.tab_to("[data-order=take_off]"));
    browser.press("Enter");
    let refused = "the aircraft is disarmed: arm it first";
    browser.until(&format!("(document.body.dataset.event ?? '').includes('{refused}')"));
    assert!(browser.tab_to("#fly"));
    browser.press("Enter");
    browser.until("document.querySelector('#log').innerText.includes('trajectory: done')");
    assert!(browser.tab_to("[data-order=arm]"));
    browser.press("Enter");
    browser.until("document.body.dataset.phase === 'armed'");
    assert!(browser.tab_to("[data-order=take_off]"));
    browser.press(" ");
    browser.until("Number(document.body.dataset.height) > 0.9");
    assert!(browser.tab_to("#plan"));
    for _ in 0..11 {
        browser.press("ArrowRight");
    }
    browser.press("Enter");
    browser.until("Number(document.body.dataset.place.split(',')[0]) > 0.9");

    // By hand, to the left: y grows.
    browser.see("document.activeElement.blur()");
    browser.press("5");
    browser.until("document.querySelector('#mode').innerText === 'manual'");
    browser.hold("a", "Number(document.body.dataset.place.split(',')[1]) > 0.2");
    browser.press("1");
    browser.until("document.querySelector('#mode').innerText === 'closed loop'");

    // Plots pause and go on; one more is added and removed.
    assert!(browser.tab_to("#pause"));
    browser.press("Enter");
    browser.until("document.querySelector('#pause').innerText === 'Resume plots'");
    browser.press("Enter");
    browser.until("document.querySelector('#pause').innerText === 'Pause plots'");
    let charts = "document.querySelectorAll('.uplot').length";
    assert!(browser.tab_to("#plotted"));
    browser.press("ArrowDown");
    browser.until(&format!("{charts} === 7"));
    assert!(browser.tab_to(".uplot .away"));
    browser.press("Enter");
    browser.until(&format!("{charts} === 6"));

    // A recording is listed when it has ended.
    assert!(browser.tab_to("#record"));
    browser.press("Enter");
    browser.until("document.querySelector('#record').innerText === 'Stop recording'");
    browser.press("Enter");
    browser.until("document.querySelectorAll('#recordings a').length === 1");
    browser.until("document.querySelectorAll('#sensors .good').length === 4");
    browser.until("document.querySelector('#battery').innerText.includes(' %, ')");

    // Other signals come down.
    assert!(browser.tab_to("#signals input[value=\"47\"]"));
    browser.press(" ");
    for signal in [0, 1, 2, 16, 35] {
        browser.see(&format!(
            "document.querySelector('#signals input[value=\"{signal}\"]').checked = true"
        ));
    }
    assert!(browser.tab_to("#choose"));
    browser.press("Enter");
    browser.until("document.querySelector('#log').innerText.includes('signals: done')");
    // What is missing is reported as missing.
    let gaps = "Number(document.body.dataset.gaps)";
    let before = browser.see(gaps).as_f64().expect("a number");
    assert!(browser.tab_to("#loss"));
    for _ in 0..20 {
        browser.press("ArrowRight");
    }
    browser.until(&format!("{gaps} > {before} + 5"));
    assert_eq!(browser.see("document.body.dataset.failure ?? ''"), "");
    browser.press("Escape");
    browser.until("document.body.dataset.alarm === 'commanded'");
}

/// Counts the pictures that a page draws, second by second, and how long each stands.
const COUNT: &str = "
    window.smooth = { begun: performance.now(), frames: Number(document.body.dataset.frames), pictures: 0, last: 0, longest: 0, late: 0,
        seconds: {}, heap: performance.memory?.usedJSHeapSize ?? 0 };
    new MutationObserver(() => {
        const it = window.smooth, now = performance.now(), stood = it.last ? now - it.last : 0;
        it.pictures += 1; it.last = now; it.longest = Math.max(it.longest, stood); it.late += Number(stood > 100);
        const second = Math.floor((now - it.begun) / 1000);
        it.seconds[second] = (it.seconds[second] ?? 0) + 1;
    }).observe(document.body, { attributeFilter: ['data-pictures'] })";

/// Measurements of the page. Seconds, messages and pictures; fewest pictures in a second; pictures shown longer than
/// 0.1 s; the longest, ms; memory at the start and now, MB.
const COUNTED: &str = "(() => {
    const it = window.smooth, whole = Object.entries(it.seconds).filter(([second]) => Number(second) < Math.floor((it.last - it.begun) / 1000));
    return [(performance.now() - it.begun) / 1000, Number(document.body.dataset.frames) - it.frames, it.pictures,
        Math.min(...whole.map(([, count]) => count)), it.late, it.longest, it.heap / 1e6, (performance.memory?.usedJSHeapSize ?? 0) / 1e6];
})()";

#[test]
fn the_page_is_smooth() {
    let asked = std::env::var("BESSEMER_REACH").ok().and_then(|it| it.parse::<f64>().ok());
    let Some(seconds) = asked.filter(|_| Browser::is_there()) else {
        println!("left out: BESSEMER_REACH says for how many seconds it is measured, in chromium");
        return;
    };
    let conditions = Conditions::begin();
    let running = Running::start(Pace::Patient);
    let mut browser = Browser::start();
    browser.go(&running.address);
    browser.until("document.body.dataset.commands === 'true'");
    browser.until("document.body.dataset.phase === 'disarmed'");
    browser.until("document.querySelectorAll('#checks .good').length === 5");
    browser.press("m");
    browser.until("document.body.dataset.phase === 'armed'");
    browser.click("#fly", (0.5, 0.5));
    browser.until("document.querySelector('#log').innerText.includes('trajectory: done')");
    browser.press("t");
    browser.until("Number(document.body.dataset.height) > 0.9");
    browser.see(COUNT);
    let idle = browser.busy();
    let begun = Instant::now();
    let mut turn = 0;
    while begun.elapsed().as_secs_f64() < seconds {
        // It flies to and fro, so that there is something to draw.
        turn += 1;
        browser.click("#plan", if turn % 2 == 0 { (0.35, 0.5) } else { (0.65, 0.4) });
        std::thread::sleep(Duration::from_secs_f64(seconds.min(5.0)));
    }
    let counted = browser.see(COUNTED);
    let busy = browser.busy();
    assert_eq!(browser.see("document.body.dataset.failure ?? ''"), "");
    assert_eq!(browser.see("document.body.dataset.phase"), "flight");
    let [time, messages, pictures, fewest, late, longest, before, after] =
        std::array::from_fn(|n| counted[n].as_f64().expect("a number"));
    let text = format!(
        "{}{time:.0} s of flight in Chromium without a window: {:.1} messages and {:.1} pictures a second\n\
         the fewest pictures in a second: {fewest}; {late} stood longer than 0.1 s, the longest {longest:.0} ms\n\
         the page's thread was busy for {:.0} % of the time, with scripts for {:.0} %\n\
         memory of the page: {before:.1} MB at the beginning, {after:.1} MB at the end\n",
        conditions.told(),
        messages / time,
        pictures / time,
        100.0 * (busy[0] - idle[0]) / time,
        100.0 * (busy[1] - idle[1]) / time,
    );
    print!("{text}");
    let path = bessemer_legs::root().join("docs/results/smooth.md");
    std::fs::write(path, text).expect("docs/results is there");
}

/// A recording of two seconds on the ground, played in a thread of its own: the address of its page.
fn played(path: &std::path::Path) -> String {
    let program = Program::build(&bessemer_legs::root(), Target::Native)
        .unwrap_or_else(|error| panic!("{error}"));
    let wanted = Wanted { pace: Pace::Virtual, ..Wanted::default() };
    let mut testbed = Testbed::start(&program, &wanted).unwrap_or_else(|error| panic!("{error}"));
    let mut recorder =
        ground::recorder::Recorder::start(path.to_owned(), sim::Aircraft::Mambo, None, true)
            .unwrap_or_else(|error| panic!("{error}"));
    let happened = Event { time: 1.0, severity: Severity::Warning, text: "height lost".into() };
    let run = testbed.run_until(2.0, |done, _| {
        let now = done.number == 200;
        recorder.take(done, now.then(|| happened.clone()).into_iter().collect());
    });
    run.unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(recorder.finish().error, None);

    let (asked, asks) = live::queue();
    let hub = Hub::new(asked, &live::hello(sim::Aircraft::Mambo, false)).expect("random bytes");
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
    // The whole flight is there before it is played: two seconds of 50 samples.
    browser.until("document.body.dataset.samples === '100'");
    // The events are in the column of the commands, and lead to their time.
    browser.until("document.querySelector('#middle #events button') !== null");
    assert_eq!(browser.see("document.querySelector('#flight').checkVisibility()"), false);
    browser.click("#play", (0.5, 0.5));
    browser.until("document.querySelector('#play').innerText === 'Play'");
    browser.see("const at = document.querySelector('#at'); at.value = 1.5; at.dispatchEvent(new Event('input'))");
    browser.until("document.body.dataset.playing === '1.50'");
    browser.until("document.body.dataset.phase === 'disarmed'");
    browser.click("#events button", (0.5, 0.5));
    browser.until("document.body.dataset.playing === '1.00'");
    picture(&mut browser, "recording");
    browser.click("#play", (0.5, 0.5));
    browser.until("Number(document.body.dataset.playing) > 1.9");
    assert_eq!(browser.see("document.body.dataset.failure ?? ''"), "");
}
