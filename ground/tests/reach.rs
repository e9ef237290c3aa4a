//! Capacity of the ground station in real time, measured only if `BESSEMER_REACH` sets a number of seconds.
//!
//! `BESSEMER_REACH=600 cargo test --profile fast -p ground --test reach -- --nocapture`, on a machine that does nothing else, writes
//! `docs/results/reach.md`. A page moves the sticks twenty times a second, each time to another place, by which the
//! period is known in which the software has taken it: its motors' command is there at the end of it. Beside it an echo
//! keeps the same period, which tells how many of them the machine itself misses.

mod conditions;
mod echo;

use conditions::Conditions;
use echo::Echo;
use ground::live::{self, Live};
use ground::program::{Program, Target};
use ground::server::{self, Hub};
use ground::testbed::{Pace, Testbed, Wanted};
use models::receiver::STICKS;
use serde_json::json;
use std::net::SocketAddr;
use std::sync::mpsc::{Sender, channel};
use std::time::{Duration, Instant};
use tungstenite::Message;

/// Distance between two positions of the sticks, rad.
const STICK_STEP: f64 = 1e-6;

/// A page that moves the sticks until nobody listens: which place, and when it was sent there.
fn pilot(address: SocketAddr, token: &str, sent: &Sender<(u64, Instant)>) {
    let (mut page, _) = tungstenite::connect(format!("ws://{address}/live")).expect("it listens");
    let claim = json!({ "type": "claim", "token": token });
    page.send(Message::text(claim.to_string())).expect("it listens");
    let (mut next, begun) = (0_u64, Instant::now());
    loop {
        // What the page is reported sets its pace, as it does for a pilot who looks at it.
        if page.read().is_err() {
            return;
        }
        if begun.elapsed() < Duration::from_millis(50) * next as u32 {
            continue;
        }
        next += 1;
        let roll = STICK_STEP * next as f64;
        let sticks =
            json!({ "type": "sticks", "roll": roll, "pitch": 0, "yaw_rate": 0, "climb": 0 });
        let now = Instant::now();
        if page.send(Message::text(sticks.to_string())).is_err() || sent.send((next, now)).is_err()
        {
            return;
        }
    }
}

/// The processor time of this process, s: the testbed, the station, the server and the measuring page.
fn spent() -> f64 {
    let stat = std::fs::read_to_string("/proc/self/stat").unwrap_or_default();
    let fields: Vec<&str> =
        stat.rsplit(')').next().unwrap_or_default().split_whitespace().collect();
    // utime and stime, in hundredths.
    [11, 12].iter().filter_map(|n| fields.get(*n)?.parse::<f64>().ok()).sum::<f64>() / 100.0
}

#[test]
fn the_reach_is_measured() {
    let asked = std::env::var("BESSEMER_REACH").ok().and_then(|it| it.parse::<f64>().ok());
    let Some(seconds) = asked else {
        println!("left out: BESSEMER_REACH says for how many seconds it is measured");
        return;
    };
    let conditions = Conditions::begin();
    let (target, name) = match std::env::var("BESSEMER_REACH_TARGET").as_deref() {
        Ok("a9") => (Target::A9, "reach-a9.md"),
        Ok("zynq") => (Target::Zynq, "reach-zynq.md"),
        _ => (Target::Native, "reach.md"),
    };
    let root = bessemer_legs::root();
    let program = Program::build(&root, target).unwrap_or_else(|error| panic!("{error}"));
    let testbed = Testbed::start(&program, &Wanted { pace: Pace::Real, ..Wanted::default() })
        .unwrap_or_else(|error| panic!("{error}"));
    let (asked, asks) = live::queue();
    let hub = Hub::new(asked, &live::hello(sim::Aircraft::Mambo, false)).expect("random bytes");
    let address = server::start(([127, 0, 0, 1], 0).into(), hub.clone()).expect("a port");
    let mut live = Live::new(testbed, hub.clone(), asks, std::env::temp_dir());
    let (sender, sent) = channel();
    let token = hub.token().to_owned();
    std::thread::spawn(move || pilot(address, &token, &sender));

    let echo = Echo::begin();
    let (begun, before) = (Instant::now(), spent());
    let (mut waiting, mut took) = (std::collections::BTreeMap::new(), Vec::new());
    while live.testbed.now() < seconds {
        let done = live.step().unwrap_or_else(|error| panic!("{error}"));
        let packet = done.moment.inputs.uplink;
        if done.count.is_none() || packet.length == 0 || packet.kind() != STICKS {
            continue;
        }
        let now = Instant::now();
        waiting.extend(sent.try_iter());
        let place = (packet.number(0) / STICK_STEP).round() as u64;
        took.extend(waiting.remove(&place).map(|at: Instant| now.saturating_duration_since(at)));
    }
    let share = (spent() - before) / begun.elapsed().as_secs_f64();
    let echoed = echo.end();
    took.sort();
    assert!(!took.is_empty(), "the page moved no stick");
    let of =
        |share: f64| 1e3 * took[((took.len() - 1) as f64 * share).round() as usize].as_secs_f64();
    let timing = live.timing();
    let text = format!(
        "{}{} periods of 5 ms, {} missed, slowest answer {} µs\n{} periods of an echo, {} missed\n{} movements of a stick from page to motor command: \
         median {:.1} ms, 99 of 100 below {:.1} ms, longest {:.1} ms\nprocessor: {:.1} % of one\n",
        conditions.told(),
        timing.periods,
        timing.missed,
        timing.slowest,
        echoed.periods,
        echoed.missed,
        took.len(),
        of(0.5),
        of(0.99),
        of(1.0),
        100.0 * share
    );
    print!("{text}");
    std::fs::write(root.join("docs/results").join(name), text).expect("docs/results is there");
}
