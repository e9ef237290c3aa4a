//! Measures the emitted C beside C that is made of WebAssembly, on the Cortex-A9. The figures are instructions of a period of
//! the height control and of the whole onboard software over a flight, and bytes of code.
//!
//! rustc compiles the models to WebAssembly, of which wasm2c and w2c2 make C. Its own code for the processor is a contender,
//! too. Each one must return the flight's bits in every period.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;

use bessemer_ir::FunctionId;
use bessemer_tests::linked::{self, Flight, WASM};
use bessemer_tests::toolchain::{ARM, Toolchain, run};
use bessemer_tests::{entry, flight_models, harness, process, watch};
use serde_json::{Value, json};

use crate::dsp::page::grouped;

/// The flight.
const FLIGHT: &str = "hover";

/// Target of rustc for the Cortex-A9.
const NATIVE: &str = "armv7-unknown-linux-gnueabihf";

/// Folder of wasm2c's run-time library.
const RUN_TIME: &str = "/usr/share/wabt/wasm2c";

/// Bytes of a page of WebAssembly's memory.
pub const PAGE: u64 = 65_536;

/// Flags for the size of the reachable code.
const SECTIONS: [&str; 2] = ["-ffunction-sections", "-fdata-sections"];

/// The C of others: its own standard, without our warnings.
const THEIRS: Toolchain = Toolchain { more: &["-std=gnu99", "-w"], ..ARM };

/// Figures of a contender.
#[derive(Clone, Debug)]
pub struct Row {
    /// Name of the contender.
    pub contender: &'static str,
    /// Mean instructions of a period of the height control.
    pub height: f64,
    /// Mean instructions of a period of the onboard software.
    pub onboard: f64,
    /// Code and constants that a period of the onboard software reaches, bytes. Not of rustc, whose library has
    /// std's panics.
    pub text: Option<u64>,
    /// Linear memory, bytes.
    pub memory: u64,
}

/// Measures every contender over the flight, or its first `longest` seconds; `peers` is the folder with w2c2.
///
/// # Errors
/// The message of a tool, or that a contender has other bits.
pub fn measure(longest: f64, peers: Option<&Path>) -> Result<Vec<Row>, String> {
    let flight = Flight::of(FLIGHT, longest)?;
    let mut rows = vec![emitted(&flight)?];
    let native = [linked::library(NATIVE)?];
    rows.push(contended("rustc", &flight, &THEIRS, &native, "linked_step", &[])?);
    let made = tempfile::tempdir().map_err(|error| error.to_string())?;
    let source = made.path().join("linked.c");
    let module = linked::library(WASM)?;
    let bytes = std::fs::read(&module).map_err(|error| format!("{}: {error}", module.display()))?;
    let memory =
        linear_memory(&bytes).ok_or_else(|| format!("{} declares no memory", module.display()))?;
    run(Command::new("wasm2c").arg(&module).arg("-o").arg(&source))?;
    let sources = [source.clone(), Path::new(RUN_TIME).join("wasm-rt-impl.c")];
    let include = format!("-I{}", made.path().display());
    let flags = ["-DWASM2C", "-D_GNU_SOURCE", include.as_str()];
    let row = contended("wasm2c", &flight, &THEIRS, &sources, "Z_linkedZ_linked_step", &flags)?;
    rows.push(Row { memory, ..row });
    if let Some(peers) = peers {
        // The file is written anew.
        run(Command::new(peers.join("w2c2/build/w2c2")).arg(&module).arg(&source))?;
        let base = format!("-I{}", peers.join("w2c2/w2c2").display());
        let flags = ["-DW2C2", include.as_str(), base.as_str()];
        let step = "linked_linked_step";
        let row = contended("w2c2", &flight, &THEIRS, &[source], step, &flags)?;
        rows.push(Row { memory, ..row });
    }
    Ok(rows)
}

/// Measures the emitted C: a program for each of the two.
fn emitted(flight: &Flight) -> Result<Row, String> {
    let compiled = flight_models();
    let step = |owner: &str| {
        let id = entry(compiled, owner, "step").ok_or(format!("no `{owner}::step`"))?;
        let laid = process::lay_out(compiled).map_err(|error| error.to_string())?;
        Ok::<_, String>((id, laid))
    };
    let count = |id: FunctionId, laid: &process::Folder, words: &[u64]| {
        let params = compiled.module.functions[id.index()].params;
        let main = laid.path().join("main.c");
        let text = harness::marked(&compiled.explicit, id, params);
        std::fs::write(&main, text).map_err(|error| error.to_string())?;
        let bytes: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).collect();
        watch::watched(&ARM, laid.path(), &main, laid.sources(), &bytes)
    };
    let (id, laid) = step("Height")?;
    let height = count(id, &laid, &flight.heights)?;
    let (id, laid) = step("Onboard")?;
    let onboard = count(id, &laid, &flight.arguments)?;
    let own =
        height.words.chunks(3).zip(onboard.words.chunks(onboard.words.len() / flight.periods()));
    // A status before the results; of the height control the thrust, then its state.
    let results: Vec<u64> = own
        .flat_map(|(height, onboard)| [&onboard[1..], &height[2..], &height[1..2]].concat())
        .collect();
    if !flight.has(&results) {
        return Err("the emitted C has other bits".to_owned());
    }
    let (objects, _) = ARM.objects(laid.sources(), &SECTIONS)?;
    let text = ARM.brought(&objects, "onboard_step", &laid.path().join("kept"))?.text;
    let text = Some(text);
    let (height, onboard) = (mean(&height.counts), mean(&onboard.counts));
    Ok(Row { contender: "emitted C", height, onboard, text, memory: 0 })
}

/// Measures code of rustc, or C of its WebAssembly; `step` is the name of the onboard software's period in it.
fn contended(
    contender: &'static str,
    flight: &Flight,
    toolchain: &Toolchain,
    sources: &[PathBuf],
    step: &str,
    flags: &[&str],
) -> Result<Row, String> {
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let program = linked::program(toolchain, sources, folder.path(), flags)?;
    let found = watch::counted(toolchain, folder.path(), &program, &flight.input())?;
    if !flight.has(&found.words) {
        return Err(format!("{contender} has other bits"));
    }
    let every_second =
        |from: usize| mean(&found.counts.iter().skip(from).step_by(2).copied().collect::<Vec<_>>());
    let is_c = sources.iter().all(|it| it.extension().is_some_and(|it| it == "c"));
    let text = match is_c {
        true => {
            let (objects, _) = toolchain.objects(sources, &[flags, &SECTIONS].concat())?;
            let kept = folder.path().join("kept");
            Some(toolchain.brought(&objects, step, &kept)?.text)
        }
        false => None,
    };
    Ok(Row { contender, height: every_second(1), onboard: every_second(0), text, memory: 0 })
}

/// Returns the bytes of the first memory that a module of WebAssembly declares, from the least number of pages in section 5.
///
/// None if it declares no memory, or is no such module.
pub fn linear_memory(module: &[u8]) -> Option<u64> {
    const MEMORIES: u8 = 5;
    // The magic number and the version come first.
    let mut rest = module.get(8..)?;
    loop {
        let (id, after) = rest.split_first()?;
        let (length, content) = number(after)?;
        let (content, next) = content.split_at_checked(usize::try_from(length).ok()?)?;
        if *id == MEMORIES {
            let (count, memories) = number(content)?;
            let (_limits, pages) = memories.split_first().filter(|_| count > 0)?;
            return Some(PAGE * number(pages)?.0);
        }
        rest = next;
    }
}

/// Reads a number in LEB128; returns the bytes after it, too.
fn number(bytes: &[u8]) -> Option<(u64, &[u8])> {
    let end = bytes.iter().take(9).position(|byte| byte & 0x80 == 0)?;
    let (own, rest) = bytes.split_at(end + 1);
    let value = own.iter().rev().fold(0, |value, byte| value << 7 | u64::from(byte & 0x7F));
    Some((value, rest))
}

fn mean(counts: &[u64]) -> f64 {
    counts.iter().sum::<u64>() as f64 / counts.len().max(1) as f64
}

/// The rows for a terminal.
pub fn table(rows: &[Row]) -> String {
    let mut text = format!(
        "{:<12} {:>8} {:>8} {:>9} {:>9}  instructions of a period (A9, gcc -O2), bytes\n",
        "contender", "height", "onboard", "text", "memory"
    );
    for row in rows {
        let _ = writeln!(
            text,
            "{:<12} {:>8.0} {:>8} {:>9} {:>9}",
            row.contender,
            row.height,
            grouped(row.onboard.round() as u64),
            row.text.map_or_else(|| "–".to_owned(), grouped),
            grouped(row.memory)
        );
    }
    text
}

/// The rows for machines.
pub fn json(rows: &[Row]) -> Value {
    let two = |ratio: f64| (ratio * 100.0).round() / 100.0;
    let first = &rows[0];
    let rows: BTreeMap<&str, Value> = rows
        .iter()
        .map(|row| {
            let value = json!({
                "height": row.height.round(), "onboard": row.onboard.round(), "text": row.text,
                "linear memory": row.memory,
                "ratios": {
                    "height": two(row.height / first.height),
                    "onboard": two(row.onboard / first.onboard),
                    "text": row.text.zip(first.text).map(|(text, ours)| two(text as f64 / ours as f64)),
                },
            });
            (row.contender, value)
        })
        .collect();
    json!({
        "command": "cargo xtask bench --only wasm --peers FOLDER",
        "what": "mean instructions of a period on the Cortex-A9 under QEMU, over a flight in which every period has the same bits; code and constants in bytes, without the data of the linear memory",
        "flight": FLIGHT,
        "flags": ARM.command().get_args().map(|a| a.to_string_lossy().into_owned()).collect::<Vec<_>>().join(" "),
        "contenders": rows,
    })
}
