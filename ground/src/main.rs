//! The program behind `cargo xtask fly` and `cargo xtask replay`.

use clap::Parser;
use ground::key::Key;
use ground::live::{self, Live};
use ground::player::Player;
use ground::program::{Program, Target};
use ground::radio::Quality;
use ground::recorded::Recorded;
use ground::server::{self, Hub};
use ground::testbed::{Pace, Testbed, Wanted};
use ground::{ending, mocap, recorder, replay, seeds, testbed};
use ground_args::{Airframe, Axis, Campaign, Fly, Machine, Replay, Task};
use sim::Aircraft;
use sim::campaign::Kind;
use std::error::Error;
use std::io::Write as _;
use std::net::{Ipv4Addr, SocketAddr};
use std::path::Path;
use std::process::{Command, ExitCode, Stdio};
use std::sync::atomic::Ordering;
use std::time::{Duration, Instant};

/// Prints a line. A closed standard output is no failure.
macro_rules! say {
    ($($text:tt)*) => {{
        let _ = writeln!(std::io::stdout(), $($text)*);
    }};
}

/// Prints a line to standard error. A closed standard error is no failure.
macro_rules! warn {
    ($($text:tt)*) => {{
        let _ = writeln!(std::io::stderr(), $($text)*);
    }};
}

/// Command line of the ground station.
#[derive(Parser)]
#[command(name = "cargo xtask", bin_name = "cargo xtask")]
struct Arguments {
    #[command(subcommand)]
    task: Task,
}

fn main() -> ExitCode {
    let outcome = match Arguments::parse().task {
        Task::Fly(wanted) => fly(&wanted),
        Task::Replay(wanted) if wanted.page => play(&wanted).map(|()| true),
        Task::Replay(wanted) => run_again(&wanted),
    };
    match outcome {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            warn!("error: {error}");
            ExitCode::from(2)
        }
    }
}

/// Flies until a signal arrives or `--seconds` have passed. Returns false if a recording failed.
fn fly(wanted: &Fly) -> Result<bool, Box<dyn Error>> {
    let ending = ending::requested()?;
    if let Some(path) = &wanted.record {
        recorder::check(path)?;
    }
    let key = wanted.key.as_deref().map(Key::read).transpose()?;
    let authenticated = key.is_some();
    warn!("compiling the onboard software …");
    let program = Program::build(&bessemer_legs::root(), target(wanted.target))?;
    let quality = Quality {
        loss: wanted.loss,
        duplication: wanted.duplicate,
        reordering: wanted.reorder,
        delay: f64::from(wanted.delay) / 1000.0,
    };
    let aircraft = flown(wanted.airframe);
    let testbed = Testbed::start(
        &program,
        &Wanted {
            aircraft,
            link: wanted.link,
            pace: Pace::Real,
            quality,
            key,
            other_key: None,
            mocap: wanted.mocap.map(|server| mocap::Source {
                server,
                body: wanted.body.clone(),
                up: match wanted.up {
                    Axis::Y => mocap::Up::Y,
                    Axis::Z => mocap::Up::Z,
                },
            }),
            natnet: wanted.natnet,
            seed: wanted.seed,
        },
    )?;

    let (asked, asks) = live::queue();
    let hub = Hub::new(asked, &live::hello(aircraft, authenticated))?;
    let wish = SocketAddr::new(wanted.bind, wanted.port);
    let address = server::start(wish, hub.clone())
        .map_err(|error| format!("`{wish}`: {error}; `--port 0` takes a port that is free"))?;
    let page = format!("http://{address}/#token={}", hub.token());
    say!("{page}");
    if let Some(server) = &testbed.bench.stream {
        say!("natnet: udp at {}, body `{}`, y upwards", server.address(), mocap::BODY);
    }
    if !authenticated {
        warn!("commands are not sealed: `--key FILE` seals them");
    }
    if !wanted.bind.is_loopback() {
        warn!("the page can be reached from outside, without encryption");
    }
    if !wanted.headless {
        show(&page);
    }

    let folder = bessemer_legs::root().join("target/fly/recordings");
    std::fs::create_dir_all(&folder)?;
    hub.keep_all(&folder);
    let mut live = Live::new(testbed, hub, asks, folder);
    add_tools(wanted, &mut live)?;
    if let Some(path) = &wanted.record {
        live.record(path.clone())?;
    }
    let (mut restarts, mut recorded) = (0, true);
    let mut report_failure = |live: &mut Live| {
        if let Some(error) = live.failure() {
            recorded = false;
            warn!("the recording has ended: {error}");
        }
    };
    let mut flown = Ok(());
    let goes_on =
        |now: f64| !ending.load(Ordering::Relaxed) && wanted.seconds.is_none_or(|end| now < end);
    while flown.is_ok() && goes_on(live.testbed.now()) {
        flown = live.step().map(drop);
        if let Some(why) = &live.testbed.ended
            && live.testbed.restarts > restarts
        {
            restarts = live.testbed.restarts;
            warn!("the onboard software is started anew: {why}");
        }
        report_failure(&mut live);
    }
    live.save();
    report_failure(&mut live);
    flown?;
    let timing = live.timing();
    say!(
        "{} periods of {} ms, {} missed, slowest answer {} µs",
        timing.periods,
        1000.0 * testbed::period(),
        timing.missed,
        timing.slowest
    );
    Ok(recorded)
}

/// Starts the requested external tools.
fn add_tools(wanted: &Fly, live: &mut Live) -> Result<(), Box<dyn Error>> {
    if let Some(address) = wanted.foxglove {
        #[cfg(feature = "foxglove")]
        {
            let tool = ground::tools::foxglove::Foxglove::start(address)
                .map_err(|error| format!("Foxglove's port `{address}`: {error}"))?;
            say!("foxglove: ws://{}", tool.address());
            live.add(tool);
        }
        #[cfg(not(feature = "foxglove"))]
        return Err(unbuilt(live, "foxglove", address));
    }
    if let Some(address) = wanted.mavlink {
        #[cfg(feature = "mavlink")]
        {
            use ground::tools::mavlink::{Mavlink, Signature};
            let signed = wanted.mavlink_key.as_deref().map(Signature::read).transpose()?;
            if signed.is_none() {
                warn!("MAVLink is not signed: `--mavlink-key FILE` signs it");
            }
            live.add(Mavlink::start(address, signed.unwrap_or_default())?);
            say!("mavlink: udp to {address}");
        }
        #[cfg(not(feature = "mavlink"))]
        return Err(unbuilt(live, "mavlink", address));
    }
    Ok(())
}

/// The error for a tool that was not built into this program.
#[cfg(not(all(feature = "foxglove", feature = "mavlink")))]
fn unbuilt(_: &mut Live, tool: &str, address: SocketAddr) -> Box<dyn Error> {
    format!("this program was built without `{tool}`, for {address}: `cargo xtask fly` builds it with it").into()
}

/// Shows a recording until the program is ended.
fn play(wanted: &Replay) -> Result<(), Box<dyn Error>> {
    let (asked, asks) = live::queue();
    let folder = bessemer_legs::root().join("target/campaign");
    let file = match wanted.seed {
        Some(seed) => seeds::fly(kind(wanted.campaign), seed, &folder)?,
        None => named(wanted)?.to_owned(),
    };
    if wanted.seed.is_some() {
        say!("{}", file.display());
    }
    let recorded = Recorded::read(&file)?;
    let aircraft = recorded.aircraft(&file)?;
    let hub = Hub::new(asked, &live::hello(aircraft, false))?;
    // The campaigns fly this aircraft, whose parameters and signals the page has.
    let seeds = (aircraft == Aircraft::Mambo).then(|| hub.seeds());
    let mut player = Player::of(&recorded, &file, hub.clone(), asks)?;
    drop(recorded);
    report_missing(player.missing, player.playing().to);
    let wish = SocketAddr::new(Ipv4Addr::LOCALHOST.into(), wanted.port);
    let address = server::start(wish, hub.clone())
        .map_err(|error| format!("`{wish}`: {error}; `--port 0` takes a port that is free"))?;
    let page = format!("http://{address}/#token={}", hub.token());
    say!("{page}");
    if !wanted.headless {
        show(&page);
    }
    let mut before = Instant::now();
    loop {
        std::thread::sleep(Duration::from_millis(10));
        seeds.iter().flat_map(|seeds| seeds.try_iter()).for_each(|it| player.fly(it, &folder));
        let now = Instant::now();
        player.step((now - before).as_secs_f64());
        before = now;
    }
}

/// Returns the recording that the command line names.
fn named(wanted: &Replay) -> Result<&Path, Box<dyn Error>> {
    wanted.file.as_deref().ok_or_else(|| "name a recording".into())
}

fn kind(campaign: Campaign) -> Kind {
    match campaign {
        Campaign::Spread => Kind::Spread,
        Campaign::Failures => Kind::Failures,
    }
}

fn run_again(wanted: &Replay) -> Result<bool, Box<dyn Error>> {
    let program = Program::build(&bessemer_legs::root(), target(wanted.target))?;
    let report = replay::replay(&program, named(wanted)?)?;
    if report.difference.is_none() {
        report_missing(report.missing, report.until);
    }
    match &report.difference {
        None => say!("{} steps, every output the same bits", report.steps),
        Some(replay::Difference { count, time, signal, words: (then, now) }) => say!(
            "step {count}, at {time:.3} s: {signal} was {then:#018x} ({}), is {now:#018x} ({})",
            f64::from_bits(*then),
            f64::from_bits(*now)
        ),
    }
    Ok(report.difference.is_none())
}

/// Prints how much of a truncated recording is missing.
fn report_missing(missing: Option<usize>, until: f64) {
    if let Some(missing) = missing {
        warn!(
            "the recording was cut off: it ends at {until:.3} s, and {missing} bytes at its end are no whole chunk"
        );
    }
}

fn flown(airframe: Airframe) -> Aircraft {
    match airframe {
        Airframe::Mambo => Aircraft::Mambo,
        Airframe::F550 => Aircraft::F550,
    }
}

fn target(machine: Machine) -> Target {
    match machine {
        Machine::Native => Target::Native,
        Machine::A9 => Target::A9,
        Machine::Zynq => Target::Zynq,
    }
}

/// Opens the page in the browser; without a browser, the printed address remains.
fn show(page: &str) {
    let quiet = Stdio::null;
    let _ =
        Command::new("xdg-open").arg(page).stdin(quiet()).stdout(quiet()).stderr(quiet()).spawn();
}
