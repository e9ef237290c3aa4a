//! Measures a control period of the onboard software on the Cortex-A9: executed instructions, counted exactly under
//! QEMU, over whole flights.
//!
//! The models fly each flight first; then the C gets the same inputs. The result is valid only if every output and
//! state of every period has the same bits.

use bessemer_tests::toolchain;
use bessemer_tests::{entry, flight_models, harness, process, words};
use models::{Inputs, Outputs, Settings};
use serde_json::{Value, json};
use sim::computer::{Computer, Native};
use sim::flights::find;
use sim::voyage::fly;
use std::fmt::Write as _;
use std::fs::File;

use crate::count::fed;
use crate::moved;

/// The flights: of each candidate, of each airframe, with and without feed-forward.
const FLIGHTS: [&str; 5] = ["hover", "gravity-64", "vicon-lost", "geometric", "hexacopter"];

/// Cycles in a millisecond of a Cortex-A9 at the clock of a Zynq-7020.
const CYCLES: f64 = 667_000.0;

/// A flight's control periods.
#[derive(Clone, Debug)]
pub struct Row {
    /// The flight.
    pub flight: &'static str,
    /// Executed instructions of each period, in order.
    pub counts: Vec<u64>,
    /// Bytes that all periods together copy or clear.
    pub moved: u64,
}

impl Row {
    /// Returns the mean of the counts.
    pub fn mean(&self) -> f64 {
        self.counts.iter().sum::<u64>() as f64 / self.counts.len().max(1) as f64
    }

    /// Returns the mean of the bytes that a period copies or clears.
    pub fn mean_moved(&self) -> f64 {
        self.moved as f64 / self.counts.len().max(1) as f64
    }

    /// Returns the number below which a fraction `share` of the periods are.
    pub fn at(&self, share: f64) -> u64 {
        let mut sorted = self.counts.clone();
        sorted.sort_unstable();
        let last = sorted.len().saturating_sub(1);
        sorted.get((share * last as f64).round() as usize).copied().unwrap_or_default()
    }
}

/// The models, with all their inputs and outputs recorded.
#[derive(Default)]
struct Recorded {
    models: Native,
    arguments: Vec<u64>,
    results: Vec<u64>,
}

impl Computer for Recorded {
    fn step(&mut self, settings: &Settings, inputs: &Inputs) -> Outputs {
        self.arguments.extend(words(settings).into_iter().chain(words(inputs)));
        let outputs = self.models.step(settings, inputs);
        self.results.push(0);
        self.results.extend(self.models.words());
        outputs
    }

    fn digest(&self) -> u64 {
        self.models.digest()
    }
}

/// Counts the periods of each flight, or of its first `longest` seconds.
///
/// # Errors
/// What a tool said, or that the C does not compute what the Rust does.
pub fn measure(longest: f64) -> Result<Vec<Row>, String> {
    let failed = |error: std::io::Error| error.to_string();
    let compiled = flight_models();
    let step = entry(compiled, "Onboard", "step").ok_or("the models have no `Onboard::step`")?;
    let params = compiled.module.functions[step.index()].params;
    let laid = process::lay_out(compiled).map_err(|error| error.to_string())?;
    let main = laid.path().join("harness_main.c");
    std::fs::write(&main, harness::marked(&compiled.explicit, step, params)).map_err(failed)?;
    let program = laid.path().join("harness");
    toolchain::ARM.around(&main, laid.sources(), &program, &[])?;
    let (main, moving) = (laid.path().join("harness_moved.c"), laid.path().join("moved"));
    let text = harness::marked_by(&compiled.explicit, step, params, moved::MARKS);
    std::fs::write(&main, text).map_err(failed)?;
    moved::build(&main, laid.sources(), &moving)?;

    let mut rows = Vec::new();
    for name in FLIGHTS {
        let flight = find(name).ok_or_else(|| format!("there is no flight `{name}`"))?;
        let mut scenario = (flight.scenario)(1);
        scenario.duration = scenario.duration.min(longest);
        let mut recorded = Recorded::default();
        fly(&scenario, &mut recorded);
        let input = laid.path().join("input");
        std::fs::write(&input, bytes(&recorded.arguments)).map_err(failed)?;
        let open = || File::open(&input).map_err(failed);
        let (counts, written) = fed(&program, laid.path(), &[], open()?.into())?;
        if !same(&recorded.results, &written) {
            return Err(format!("{name}: the C does not compute what the Rust does"));
        }
        let moved = moved::count(&moving, open()?.into())?;
        rows.push(Row { flight: name, counts, moved });
    }
    Ok(rows)
}

fn bytes(words: &[u64]) -> Vec<u8> {
    words.iter().flat_map(|word| word.to_le_bytes()).collect()
}

/// Returns true if the bits are equal; any two NaN are equal.
fn same(words: &[u64], written: &[u8]) -> bool {
    let plain = |word: u64| if f64::from_bits(word).is_nan() { u64::MAX } else { word };
    let (there, rest) = written.as_chunks::<8>();
    let there = there.iter().map(|bytes| plain(u64::from_le_bytes(*bytes)));
    rest.is_empty() && words.iter().map(|word| plain(*word)).eq(there)
}

/// The rows for a terminal.
pub fn table(rows: &[Row]) -> String {
    let mut text = format!(
        "{:<12} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8}  instructions of a control period (A9, gcc -O2)\n",
        "flight", "periods", "mean", "median", "99 %", "most", "bytes"
    );
    for row in rows {
        let (name, count) = (row.flight, row.counts.len());
        let (median, high, most) = (row.at(0.5), row.at(0.99), row.at(1.0));
        let _ = writeln!(
            text,
            "{name:<12} {count:>8} {:>8.0} {median:>8} {high:>8} {most:>8} {:>8.0}",
            row.mean(),
            row.mean_moved()
        );
    }
    let most = rows.iter().map(|row| row.at(1.0)).max().unwrap_or_default() as f64;
    let _ = write!(
        text,
        "at one instruction a cycle and 667 MHz the longest takes {:.3} ms of 5 ms",
        most / CYCLES
    );
    text
}

/// The rows for machines.
pub fn json(rows: &[Row]) -> Value {
    let rows: Vec<Value> = rows
        .iter()
        .map(|row| {
            json!({
                "flight": row.flight, "periods": row.counts.len(), "mean": row.mean().round(),
                "median": row.at(0.5), "99 %": row.at(0.99), "most": row.at(1.0),
                "bytes copied or cleared": row.mean_moved().round(),
            })
        })
        .collect();
    json!({
        "command": "cargo xtask bench --only onboard",
        "what": "executed instructions of a control period on the Cortex-A9, under QEMU",
        "flags": toolchain::ARM.command().get_args().map(|a| a.to_string_lossy().into_owned()).collect::<Vec<_>>().join(" "),
        "flights": rows,
    })
}
