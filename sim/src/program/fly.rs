//! `cargo xtask sim`: flies one flight, or all, and says how it went.

use super::{Outcome, write};
use bessemer_legs::toolchain::{self, Toolchain};
use indicatif::{ProgressBar, ProgressStyle};
use models::Parameters;
use sim::computer::{Computer, Emitted, Native};
use sim::flights::{FLIGHTS, Flight, find};
use sim::scenario::{LEAD, Scenario};
use sim::voyage::{Voyage, follow};
use sim::{Mission, Tolerance, Vehicle, recording, report, summary, verdict};
use sim_args::Fly;
use std::collections::BTreeMap;
use std::path::Path;

/// The flight of the closed loop alone, with a perfect estimator.
const CLOSED_LOOP: (&str, &str) =
    ("every-channel", "the closed loop alone, every channel of it: yaw step, x step, gusts");

/// Flies what was asked for.
pub fn run(wanted: &Fly) -> Outcome {
    let name = match &wanted.flight {
        Some(name) if !wanted.list => name.as_str(),
        _ => {
            list();
            return Ok(true);
        }
    };
    if name == CLOSED_LOOP.0 {
        return Ok(closed_loop());
    }
    let flights: Vec<&Flight> = match (name, find(name)) {
        ("all", _) => FLIGHTS.iter().collect(),
        (_, Some(flight)) => vec![flight],
        _ => {
            return Err(format!(
                "there is no flight `{name}`; `cargo xtask sim --list` shows them"
            )
            .into());
        }
    };
    let mut carried = match wanted.c {
        true => Some(CLeg::start()?),
        false => None,
    };
    let mut good = true;
    for flight in flights {
        good &= one(wanted, flight, carried.as_mut())?;
    }
    Ok(good)
}

fn list() {
    for Flight { name, about, .. } in FLIGHTS {
        println!("{name:<15} {about}");
    }
    println!("{:<15} {}", CLOSED_LOOP.0, CLOSED_LOOP.1);
}

fn one(wanted: &Fly, flight: &Flight, carried: Option<&mut CLeg>) -> Outcome {
    let scenario = Scenario { seed: wanted.seed, ..(flight.scenario)(wanted.seed) };
    println!("## {}: {}\n", flight.name, flight.about);
    let mut memories = Vec::new();
    let voyage = flown(flight.name, &scenario, &mut Native::default(), &mut memories);
    let checks = (flight.checks)(&scenario, &voyage);
    println!("{}", summary::table(&checks));
    let mut good = checks.iter().all(|check| check.passes());
    if let Some(leg) = carried {
        leg.emitted.restart(&leg.toolchain)?;
        let mut others = Vec::new();
        let other = flown("its C", &scenario, &mut leg.emitted, &mut others);
        let parted = parting(&voyage, &other, &memories, &others);
        match parted {
            None => println!(
                "the C: {} periods, each output and state the same bits\n",
                voyage.moments.len()
            ),
            Some(time) => println!("the C parts from the Rust at {time:.3} s\n"),
        }
        good &= parted.is_none();
    }
    if let Some(folder) = &wanted.out {
        record(folder, flight, wanted.seed, &voyage)?;
    }
    Ok(good)
}

/// The emitted C, compiled once for all flights.
struct CLeg {
    emitted: Emitted,
    toolchain: Toolchain,
}

impl CLeg {
    fn start() -> Result<Self, Box<dyn std::error::Error>> {
        eprintln!("compiling the models to C …");
        let toolchain = toolchain::GCC;
        let compiled = bessemer_legs::compiled("models");
        Ok(Self { emitted: Emitted::start(&compiled, &toolchain)?, toolchain })
    }
}

/// Flies with a progress bar, and keeps what the software remembered after each period, as one word.
fn flown(
    name: &str,
    scenario: &Scenario,
    computer: &mut impl Computer,
    memories: &mut Vec<u64>,
) -> Voyage {
    let periods = (scenario.duration + LEAD) / scenario.settings.parameters.period;
    let bar = ProgressBar::new(periods.round() as u64);
    if let Ok(style) = ProgressStyle::with_template("{msg:<15} {bar:40} {percent:>3} %") {
        bar.set_style(style);
    }
    bar.set_message(name.to_owned());
    let mut moments = Vec::new();
    let records = follow(scenario, computer, |moment, computer| {
        bar.inc(1);
        memories.push(digest(&computer.state()));
        moments.push(moment.clone());
        true
    });
    bar.finish_and_clear();
    Voyage { moments, records }
}

/// FNV-1a over words: any NaN counts as any other.
fn digest(words: &[u64]) -> u64 {
    let plain = |word: &u64| if f64::from_bits(*word).is_nan() { u64::MAX } else { *word };
    words.iter().fold(0xCBF2_9CE4_8422_2325, |sum, word| {
        (sum ^ plain(word)).wrapping_mul(0x0000_0100_0000_01B3)
    })
}

/// When two flights part, s.
fn parting(one: &Voyage, other: &Voyage, memory: &[u64], others: &[u64]) -> Option<f64> {
    let pairs = one.moments.iter().zip(&other.moments).zip(memory.iter().zip(others));
    for ((here, there), (state, other)) in pairs {
        let outputs = |moment: &sim::voyage::Moment| digest(&bessemer_legs::words(&moment.outputs));
        if outputs(here) != outputs(there) || state != other {
            return Some(here.time);
        }
    }
    (one.moments.len() != other.moments.len()).then_some(0.0)
}

fn record(
    folder: &Path,
    flight: &Flight,
    seed: u64,
    voyage: &Voyage,
) -> Result<(), Box<dyn std::error::Error>> {
    std::fs::create_dir_all(folder).map_err(|error| format!("`{}`: {error}", folder.display()))?;
    let about = BTreeMap::from([
        ("flight".to_owned(), flight.name.to_owned()),
        ("seed".to_owned(), seed.to_string()),
    ]);
    let file = |ending: &str| folder.join(format!("{}{ending}", flight.name));
    write(&file(".csv"), recording::csv(voyage))?;
    write(&file(".mcap"), recording::mcap(voyage, &about)?)?;
    for figure in flight.figures {
        let drawn = figure.draw(flight.name, voyage)?;
        write(&file(&format!("-{}.svg", figure.file)), drawn)?;
    }
    println!("written to {}: CSV, MCAP and {} pictures\n", folder.display(), flight.figures.len());
    Ok(())
}

fn closed_loop() -> bool {
    let (mission, parameters) = (Mission::every_channel(), Parameters::mambo());
    let mut pilot = sim::Native::new(parameters);
    let flight = sim::fly(&Vehicle::mambo(), &parameters, &mission, &mut pilot);
    print!("{}", report::page(&flight, &mission, parameters.mixer.largest_command));
    verdict::judge(&flight, &mission, &Tolerance::default()).is_empty()
}
