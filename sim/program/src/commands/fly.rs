//! `cargo xtask sim`: flies one flight, or all, and prints the results.

use super::{Outcome, write};
use bessemer_legs::toolchain::{GCC, ZYNQ};
use indicatif::{ProgressBar, ProgressStyle};
use models::Parameters;
use sim::computer::{Computer, Native};
use sim::flights::{FLIGHTS, Flight, find};
use sim::scenario::{LEAD, Scenario};
use sim::voyage::{Voyage, follow};
use sim::{Mission, Tolerance, Vehicle, recording, report, summary, verdict};
use sim_args::{Fly, Machine};
use sim_program::board::Loaded;
use sim_program::emitted::Emitted;
use std::collections::BTreeMap;
use std::path::Path;
use std::time::Instant;

/// Name and description of the flight of the closed loop alone, with a perfect estimator.
const CLOSED_LOOP: (&str, &str) =
    ("every-channel", "the closed loop alone, every channel of it: yaw step, x step, gusts");

/// Flies the requested flights.
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
        true => Some(CLeg::start(wanted.target)?),
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
    let mut digests = Vec::new();
    let voyage = flown(flight.name, &scenario, &mut Native::default(), &mut digests);
    let checks = (flight.checks)(&scenario, &voyage);
    println!("{}", summary::table(&checks));
    let mut good = checks.iter().all(|check| check.passes());
    if let Some(leg) = carried {
        let mut others = Vec::new();
        leg.fly(&scenario, &mut others)?;
        let parted = parting(&digests, &others).map(|period| voyage.moments.get(period));
        match parted {
            None => println!(
                "the C: {} periods, each output and state the same bits\n",
                voyage.moments.len()
            ),
            Some(moment) => {
                let time = moment.map_or(scenario.duration, |moment| moment.time);
                println!("the C parts from the Rust at {time:.3} s\n");
            }
        }
        good &= parted.is_none();
    }
    if let Some(folder) = &wanted.out {
        record(folder, flight, wanted.seed, &voyage)?;
    }
    Ok(good)
}

/// The emitted C, compiled once for all flights.
enum CLeg {
    Native(Emitted),
    Zynq { firmware: Loaded, bound: u64 },
}

impl CLeg {
    fn start(machine: Machine) -> Result<Self, Box<dyn std::error::Error>> {
        eprintln!("compiling the models to C …");
        let compiled = bessemer_legs::compiled("models");
        Ok(match machine {
            Machine::Native => Self::Native(Emitted::start(&compiled, &GCC)?),
            Machine::Zynq => {
                let entry = compiled.entries.iter().find(|it| it.entry == "onboard_step");
                let bound = entry.map_or(0, |it| it.stack_bytes);
                ZYNQ.check().map_err(|missing| format!("{missing}: {}", missing.install))?;
                Self::Zynq { firmware: Loaded::zynq(&compiled, &ZYNQ)?, bound }
            }
        })
    }

    /// Flies, and stores the hash of each period.
    fn fly(
        &mut self,
        scenario: &Scenario,
        digests: &mut Vec<u64>,
    ) -> Result<(), Box<dyn std::error::Error>> {
        match self {
            Self::Native(emitted) => {
                emitted.restart(&GCC)?;
                flown("its C", scenario, emitted, digests);
            }
            Self::Zynq { firmware, bound } => {
                let mut board = firmware.start(|line| line)?;
                let begun = Instant::now();
                flown("its C on a Zynq", scenario, &mut board, digests);
                let took = begun.elapsed().as_secs_f64();
                if let Some(failure) = board.failure() {
                    return Err(failure.to_string().into());
                }
                let (sizes, stack) = (firmware.sizes()?, board.stack()?);
                println!(
                    "the Zynq: {:.1} s of flight in {took:.1} s\n\
                     firmware: {} bytes of text, {} of data, {} of bss\n\
                     stack: {} bytes by `onboard_step`, of {bound} that `gen` reports; {} of {} by all",
                    scenario.duration + LEAD,
                    sizes.text,
                    sizes.data,
                    sizes.bss,
                    stack.step,
                    stack.all,
                    stack.size
                );
            }
        }
        Ok(())
    }
}

/// Flies with a progress bar; returns for each period a hash of the software's outputs and state.
fn flown(
    name: &str,
    scenario: &Scenario,
    computer: &mut impl Computer,
    digests: &mut Vec<u64>,
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
        digests.push(computer.digest());
        moments.push(moment.clone());
        true
    });
    bar.finish_and_clear();
    Voyage { moments, records }
}

/// Returns the first period in which two flights differ.
fn parting(one: &[u64], other: &[u64]) -> Option<usize> {
    let common = one.len().min(other.len());
    let parted = one.iter().zip(other).position(|(here, there)| here != there);
    parted.or((one.len() != other.len()).then_some(common))
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
    write(&file(".csv"), recording::csv(voyage)?)?;
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
