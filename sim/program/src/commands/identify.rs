//! `cargo xtask identify`: identifies the thrust coefficients of a logged flight, by the thesis' method and by a
//! well-posed one.

use super::{Outcome, write};
use bessemer_sim::plot::{Axes, Line, draw};
use indicatif::{ProgressBar, ProgressStyle};
use models::Airframe;
use rayon::prelude::*;
use sim::identify::fit::{Fit, fit};
use sim::identify::known::{LAG, log_of, unknown_hover, worst_off};
use sim::identify::logged::Logged;
use sim::identify::segments::Segments;
use sim::identify::swarm::{Found, Swarm, search};
use sim::identify::{replay, with_coefficients};
use sim::recording::Log;
use sim_args::Identify;
use std::error::Error;
use std::fmt::Write as _;
use std::hint::black_box;
use std::path::Path;
use std::time::Instant;

/// Identifies the coefficients of a flight, or runs the study.
pub fn run(wanted: &Identify) -> Outcome {
    match (&wanted.flight, wanted.study) {
        (Some(path), _) => one(wanted, path),
        (None, count) => study(wanted, count.unwrap_or_default()),
    }
}

/// Results of the methods for a flight.
struct Results {
    four: Option<Found>,
    one: Option<Found>,
    fit: Fit,
}

fn identified(
    logged: &Logged,
    sheet: &Airframe,
    seed: u64,
    swarm: bool,
) -> Result<Results, Box<dyn Error>> {
    let cost = |coefficients: &[f64]| replay::cost(logged, sheet, coefficients);
    let by_swarm = |dimensions: usize| {
        let swarm = Swarm::thesis(dimensions, seed);
        let bar = progress(swarm.iterations as u64 + 1);
        let found = search(&swarm, cost, |_, cost| {
            bar.set_message(format!("swarm of {dimensions}: {cost:.4}"));
            bar.inc(1);
        });
        bar.finish_and_clear();
        found
    };
    let segments = Segments::of(logged, sheet);
    let known = sheet.thrust_coefficients;
    let fit = fit(&segments, &[known[0], known[1], known[2], known[3]], |_, _| ())
        .map_err(|error| error.to_string())?;
    Ok(Results { four: swarm.then(|| by_swarm(4)), one: swarm.then(|| by_swarm(1)), fit })
}

fn progress(length: u64) -> ProgressBar {
    let bar = ProgressBar::new(length);
    if let Ok(style) = ProgressStyle::with_template("{bar:40} {pos}/{len} {msg}") {
        bar.set_style(style);
    }
    bar
}

fn one(wanted: &Identify, path: &Path) -> Outcome {
    let sheet = Airframe::mambo();
    let log = Log::read(path)?;
    if log.about.get("flight").is_some_and(|flight| flight == "hexacopter") {
        return Err("the identification knows the data sheet of the Mambo only".into());
    }
    let logged = Logged::of(&log, LAG)?;
    let began = Instant::now();
    let results = identified(&logged, &sheet, wanted.seed, !wanted.no_swarm)?;
    let seconds = began.elapsed().as_secs_f64();
    println!(
        "| method | motor 1 | motor 2 | motor 3 | motor 4 | cost |\n|:--|--:|--:|--:|--:|--:|"
    );
    for (name, found) in [("thesis, four", &results.four), ("thesis, one", &results.one)] {
        if let Some(found) = found {
            println!("| {name} |{} {:.4} |", cells(&found.best), found.cost);
        }
    }
    let fit = &results.fit;
    println!("| well-posed |{} {:.3e} |", cells(&fit.coefficients), fit.cost);
    println!("| ± at 95 % |{} |", cells(&fit.confidence));
    let swarms = [&results.four, &results.one].into_iter().flatten().count();
    let evaluations = swarms * Swarm::thesis(4, 0).evaluations() + fit.evaluations as usize;
    println!("\n{evaluations} costs computed in {seconds:.1} s");
    if let Some(count) = wanted.costs {
        timed(count, &logged, &sheet, &results.fit.coefficients);
    }
    if let Some(folder) = &wanted.out {
        std::fs::create_dir_all(folder)?;
        pictures(folder, &logged, &sheet, &results)?;
    }
    Ok(true)
}

/// Measures the time of costs within 1 % of `found`, where the model stays in the air longest.
fn timed(count: u32, logged: &Logged, sheet: &Airframe, found: &[f64]) {
    let near = |n: u32| -> Vec<f64> {
        let part = f64::from(n) / f64::from(count.max(1));
        found.iter().map(|coefficient| coefficient * (0.99 + 0.02 * part)).collect()
    };
    let airborne = (logged.airborne.1 - logged.airborne.0) as f64 * logged.period;
    let whole = logged.states.len() as f64 * logged.period;
    let segments = Segments::of(logged, sheet);
    let say = |what: &str, seconds: f64| {
        println!(
            "{count} {what}, a flight of {whole:.0} s, {airborne:.0} s airborne: {seconds:.1} s"
        );
    };
    let began = Instant::now();
    for n in 0..count {
        black_box(segments.cost(&near(n)));
    }
    say("well-posed costs", began.elapsed().as_secs_f64());
    let began = Instant::now();
    (0..count).into_par_iter().for_each(|n| {
        black_box(replay::cost(logged, sheet, &near(n)));
    });
    say("costs of the thesis", began.elapsed().as_secs_f64());
}

fn cells(values: &[f64]) -> String {
    (0..4).fold(String::new(), |mut text, n| {
        let _ = write!(text, " {:.6} |", values[n.min(values.len() - 1)]);
        text
    })
}

fn pictures(
    folder: &Path,
    logged: &Logged,
    sheet: &Airframe,
    results: &Results,
) -> Result<(), Box<dyn Error>> {
    let line = |name: &str, history: &[f64]| Line {
        name: name.to_owned(),
        points: history.iter().enumerate().map(|(n, cost)| (n as f64, *cost)).collect(),
        dots: false,
    };
    let mut lines = Vec::new();
    for (name, found) in [("four coefficients", &results.four), ("one", &results.one)] {
        lines.extend(found.as_ref().map(|found| line(name, &found.history)));
    }
    if !lines.is_empty() {
        let axes = [Axes { label: "best cost J".into(), lines, scale_from: None }];
        let title = "convergence of the thesis' swarm (thesis, fig. 5.2)";
        write(&folder.join("identify-convergence.svg"), draw(title, "iteration", &axes)?)?;
    }

    let (first, last) = logged.airborne;
    let curve = |name: &str, states: &[_], output: usize| Line {
        name: name.to_owned(),
        points: states
            .iter()
            .enumerate()
            .step_by((states.len() / 800).max(1))
            .map(|(n, state): (usize, &sim::identify::logged::State)| {
                (n as f64 * logged.period, state[output])
            })
            .collect(),
        dots: false,
    };
    let fitted = with_coefficients(sheet, &results.fit.coefficients);
    let model = replay::flown(logged, &fitted);
    let restarted = Segments::of(logged, sheet).flown(&results.fit.coefficients);
    let panel = |label: &str, output: usize| Axes {
        label: label.to_owned(),
        lines: vec![
            curve("flight", &logged.states[first..last], output),
            curve("model, restarted", &restarted, output),
            curve("model, open loop", &model, output),
        ],
        scale_from: None,
    };
    let axes = [
        panel("altitude, m", 2),
        panel("vertical velocity, m/s", 8),
        panel("roll rate, rad/s", 9),
        panel("yaw rate, rad/s", 11),
    ];
    let title = "the model against the flight (thesis, fig. 5.3)";
    write(&folder.join("identify-model.svg"), draw(title, "time in the air, s", &axes)?)?;
    Ok(())
}

fn study(wanted: &Identify, count: u64) -> Outcome {
    let sheet = Airframe::mambo();
    let mut text = String::from(
        "seed,thesis four (worst off),thesis one (mean off),well-posed (worst off),its 95 % (widest)\n",
    );
    let mut good = true;
    let bar = progress(count);
    for seed in 1..=count {
        let scenario = unknown_hover(seed);
        let logged = log_of(&scenario)?;
        let results = identified(&logged, &sheet, wanted.seed + seed, !wanted.no_swarm)?;
        let truth = &scenario.airframe.thrust_coefficients.as_slice()[..4];
        let off = |found: &[f64]| worst_off(found, truth);
        let mean = truth.iter().sum::<f64>() / 4.0;
        let four = results.four.as_ref().map_or(f64::NAN, |found| off(&found.best));
        let one = results.one.as_ref().map_or(f64::NAN, |found| (found.best[0] / mean - 1.0).abs());
        let ours = off(&results.fit.coefficients);
        let widest =
            results.fit.confidence.iter().zip(truth).map(|(c, t)| c / t).fold(0.0, f64::max);
        let _ = writeln!(text, "{seed},{four:.4},{one:.4},{ours:.5},{widest:.5}");
        good &= ours < 0.01;
        bar.inc(1);
    }
    bar.finish_and_clear();
    print!("{text}");
    if let Some(path) = &wanted.file {
        write(path, &text)?;
    }
    Ok(good)
}
