//! `cargo bessemer fmu`: an entry point, or all entry points of a component, as a co-simulation unit of FMI 3.0. It has its
//! sources and a library for this machine.
//!
//! Data that an entry point borrows and that has a `…_defaults()` function becomes parameters. Other inputs become inputs, results
//! become outputs, and the component's state becomes local variables. Enums are enumerations of FMI.
//!
//! Invariants: the unit computes with the C as it is emitted; the same C gives the same unit; no two variables have one name.
//! It must not know what the C computes.

mod description;
mod glue;
mod variables;

use std::io::Write as _;
use std::path::Path;

use bessemer_backend::c::interface::{Entry, Interface};
use bessemer_legs::process;
use bessemer_legs::toolchain::{CLANG, GCC};
use bessemer_project::inputs::Period;
use bessemer_project::{Wanted, compile};

use crate::args::Fmu;
use crate::error::Error;

/// Entry points that share a state.
struct Unit<'f> {
    /// Name in the C, of the entry point or the component.
    name: String,
    /// Name in the Rust.
    rust: String,
    docs: String,
    calls: Vec<Call<'f>>,
    /// Time between two calls of the most frequent entry point, s.
    period: f64,
    /// Compared by an importer, so that no unit takes another's state or parameters.
    token: String,
}

/// An entry point of a unit.
struct Call<'f> {
    entry: &'f Entry,
    /// Beginning of the names of its variables: empty, or `step.` where there are several entry points.
    prefix: String,
    /// Periods of the unit between two calls.
    every: u64,
    /// True if it is called unless the simulation says otherwise.
    starts: bool,
}

/// Writes the unit; where it is.
///
/// # Errors
/// Errors of the models or the system; an entry point that a unit cannot have; that there is no compiler.
pub fn run(folder: &Path, wanted: &Fmu, colour: bool) -> Result<String, Error> {
    let selection = Wanted { package: wanted.package.name(), colour, ..Wanted::default() };
    if wanted.period.is_some_and(|it| !(it.is_finite() && it > 0.0)) {
        return Err(Error::Period);
    }
    let compilers = [GCC, CLANG];
    let compiler = compilers.into_iter().find(|it| it.is_there()).ok_or(Error::NoCompiler)?;
    let (project, compiled) = compile(folder, selection)?;
    let face = &compiled.interface;
    let mut sum = crc32fast::Hasher::new();
    compiled.files.iter().for_each(|file| sum.update(file.text.as_bytes()));
    let mut unit = unit(face, wanted, &project.settings.periods)?;
    unit.token = format!("{{bessemer-{}-{:08x}}}", unit.name, sum.finalize());
    let name = unit.name.as_str();
    let options = &project.settings.options;
    let compiler = compiler.of(options.standard);
    let failed_c = |said: String| Error::Compiler { name: compiler.name(), said };
    let variables = variables::of(face, &unit)?;
    let glue = glue::text(&compiled, &unit, &variables);

    let laid = process::lay_out(&compiled).map_err(|error| failed_c(error.to_string()))?;
    let in_folder = |file: &str| laid.path().join(file);
    let failed = |source| Error::File { path: wanted.output.clone(), source };
    let own = in_folder("fmi3_unit.c");
    std::fs::write(&own, &glue).map_err(failed)?;
    let library = in_folder("unit.so");
    let sources: Vec<_> = laid.sources().iter().cloned().chain([own]).collect();
    // The standard's header, which belongs to the importer, declares the functions of a unit; here nothing does.
    let flags = ["-shared", "-fPIC", "-fvisibility=hidden", "-Wno-missing-prototypes"];
    compiler.link(&sources, &library, &flags).map_err(failed_c)?;

    let names = compiled.files.iter().map(|file| file.name.as_str());
    let c: Vec<&str> = names.filter(|it| it.ends_with(".c")).chain(["fmi3_unit.c"]).collect();
    let binary = format!("binaries/{}/{name}.so", platform());
    let texts =
        compiled.files.iter().filter(|it| it.name.ends_with(".c") || it.name.ends_with(".h"));
    let description = description::model(face, &unit, &variables, &compiled.license);
    let mut files = vec![
        ("modelDescription.xml".to_owned(), description.into_bytes()),
        (
            "sources/buildDescription.xml".to_owned(),
            description::build(name, options, &c).into_bytes(),
        ),
        ("sources/fmi3_unit.c".to_owned(), glue.into_bytes()),
        (binary, std::fs::read(&library).map_err(failed)?),
    ];
    let terminals = description::terminals(&unit, &variables);
    files.extend(
        terminals
            .map(|text| ("terminalsAndIcons/terminalsAndIcons.xml".to_owned(), text.into_bytes())),
    );
    files.extend(texts.map(|it| (format!("sources/{}", it.name), it.text.clone().into_bytes())));
    std::fs::create_dir_all(&wanted.output).map_err(failed)?;
    let path = wanted.output.join(format!("{name}.fmu"));
    let packed = packed(&files).map_err(failed)?;
    std::fs::write(&path, packed).map_err(|source| Error::File { path: path.clone(), source })?;
    let (count, period) = (variables.len(), unit.period);
    let mut said = format!(
        "{}: {} with {count} variables, called every {period} s\n",
        path.display(),
        unit.rust
    );
    if let [_, _, ..] = unit.calls[..] {
        for Call { entry, every, starts, .. } in &unit.calls {
            let period = unit.period * *every as f64;
            let starts = if *starts { "" } else { ", if the simulation sets its `call`" };
            said += &format!("  {} every {period} s{starts}\n", entry.rust);
        }
    }
    Ok(said)
}

/// The folder of binaries for this machine.
fn platform() -> String {
    format!("{}-{}", std::env::consts::ARCH, std::env::consts::OS)
}

fn packed(files: &[(String, Vec<u8>)]) -> std::io::Result<Vec<u8>> {
    let mut zip = zip::ZipWriter::new(std::io::Cursor::new(Vec::new()));
    let options =
        zip::write::SimpleFileOptions::default().compression_method(zip::CompressionMethod::Stored);
    for (name, bytes) in files {
        zip.start_file(name, options)?;
        zip.write_all(bytes)?;
    }
    Ok(zip.finish()?.into_inner())
}

/// Names of the component of an entry point, in the C and in the Rust.
fn component(entry: &Entry) -> (&str, &str) {
    let ty = entry.parameters.first().map_or("", |it| it.value.ty.as_str());
    let rust = entry.rust.split("::").next().unwrap_or_default();
    (ty.strip_suffix("_t").unwrap_or(ty), rust)
}

/// The entry points that are meant: one by its name, or those of a component by its name.
fn chosen<'f>(face: &'f Interface, name: Option<&str>) -> Result<Vec<&'f Entry>, Error> {
    let entries = &face.entries;
    let named = |name: &str| -> Vec<&'f Entry> {
        let one = entries.iter().find(|it| it.name == name || it.rust == name);
        let is_of = |it: &&Entry| component(it).0 == name || component(it).1 == name;
        one.map_or_else(|| entries.iter().filter(is_of).collect(), |it| vec![it])
    };
    let mut known: Vec<String> = entries.iter().map(|it| it.rust.clone()).collect();
    for it in entries {
        let rust = component(it).1;
        let is_of = |other: &&Entry| component(other).1 == rust;
        if entries.iter().filter(is_of).count() > 1 && !known.iter().any(|it| it == rust) {
            known.push(rust.to_owned());
        }
    }
    let found = match name {
        Some(name) => named(name),
        None => match entries.first() {
            Some(first) if entries.iter().all(|it| component(it) == component(first)) => {
                entries.iter().collect()
            }
            _ => return Err(Error::WhichEntry { known }),
        },
    };
    match (found.is_empty(), name) {
        (true, name) => Err(Error::NoEntry { name: name.unwrap_or_default().to_owned(), known }),
        (false, _) => Ok(found),
    }
}

fn unit<'f>(face: &'f Interface, wanted: &Fmu, periods: &[Period]) -> Result<Unit<'f>, Error> {
    let entries = chosen(face, wanted.entry.as_deref())?;
    let is_one = entries.len() == 1;
    let of = |name: &str| periods.iter().find(|it| it.name == name);
    // The period in seconds, and whether it is the entry point's own.
    let period = |entry: &Entry| {
        let own = of(&entry.name).or_else(|| of(&entry.rust));
        let (c, rust) = component(entry);
        let shared = of(c).or_else(|| of(rust));
        let seconds = |it: &Period| it.nanoseconds as f64 / 1e9;
        let set = match (is_one, own) {
            (false, Some(own)) => Some(seconds(own)),
            _ => wanted.period.or(own.or(shared).map(seconds)),
        };
        let set = set.ok_or_else(|| Error::NoPeriod { entry: entry.name.clone() })?;
        Ok::<_, Error>((set, own.is_some()))
    };
    let set = entries.iter().map(|it| period(it)).collect::<Result<Vec<_>, _>>()?;
    let shortest = set.iter().map(|(period, _)| *period).fold(f64::INFINITY, f64::min);
    let any_own = set.iter().any(|(_, own)| *own);
    let mut calls = Vec::new();
    for (entry, (period, own)) in entries.iter().zip(&set) {
        let every = (period / shortest).round();
        if (every * shortest - period).abs() > 1e-9 * period {
            let entry = entry.name.clone();
            return Err(Error::Multiple { entry, period: *period, shortest });
        }
        let method = entry.rust.rsplit("::").next().unwrap_or(&entry.name);
        let prefix = if is_one { String::new() } else { format!("{method}.") };
        calls.push(Call { entry, prefix, every: every as u64, starts: *own || !any_own });
    }
    let (name, rust, docs) = match entries[..] {
        [only] => (only.name.clone(), only.rust.clone(), only.docs.join(" ")),
        _ => {
            let first = entries.first().map_or(("", ""), |it| component(it));
            let state = calls.first().and_then(|it| it.entry.parameters.first());
            let docs = state.and_then(|it| face.structure(&it.value.ty));
            let docs = docs.map_or(String::new(), |it| it.docs.join(" "));
            (first.0.to_owned(), first.1.to_owned(), docs)
        }
    };
    Ok(Unit { name, rust, docs, calls, period: shortest, token: String::new() })
}
