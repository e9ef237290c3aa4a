//! `cargo bessemer sizes`: prints what each entry point adds to a firmware, on this machine or another one. Columns:
//! instructions and constants, initialised and zeroed memory, stack, state, executed instructions at most.
//!
//! The sizes of an entry point include its callees, so two entry points may share a part. Callees in the C library
//! are not included. Stack and state are the bounds that `gen` reports. The executed instructions are those of the longest
//! path through the target's machine code ([`longest`]); where that model has no figures for the processor, they are an
//! [`estimate`]. `verify --target` measures the used stack and the instructions.

use std::fmt::Write as _;
use std::path::Path;

use bessemer_backend::c::EntryReport;
use bessemer_codegen::compile::Compiled;
use bessemer_codegen::estimate;
use bessemer_legs::toolchain::{GCC, Sizes, Toolchain};
use bessemer_legs::{longest, process};
use bessemer_project::{Wanted, compile};

use crate::args::Sizes as Asked;
use crate::error::Error;
use crate::verify;

/// By sections, so that what nobody calls can be left out.
const SECTIONS: &[&str] = &["-ffunction-sections", "-fdata-sections"];

/// Sizes of the C on one target.
pub(crate) struct Measured {
    /// Each entry point with its callees.
    pub entries: Vec<(String, Sizes)>,
    /// All of the C.
    pub all: Sizes,
}

/// Measures the C of a package on one target.
///
/// # Errors
/// The compiler's message.
pub(crate) fn measured(compiled: &Compiled, toolchain: &Toolchain) -> Result<Measured, Error> {
    let failed = |said: String| Error::Compiler { name: toolchain.name(), said };
    let laid = process::lay_out(compiled).map_err(|error| failed(error.to_string()))?;
    let (objects, _) = toolchain.objects(laid.sources(), SECTIONS).map_err(failed)?;
    let kept = laid.path().join("sizes.o");
    let entry = |entry: &EntryReport| {
        let sizes = toolchain.brought(&objects, &entry.entry, &kept).map_err(failed)?;
        Ok((entry.entry.clone(), sizes))
    };
    let entries = compiled.entries.iter().map(entry).collect::<Result<_, Error>>()?;
    Ok(Measured { entries, all: toolchain.sizes(&objects).map_err(failed)? })
}

/// The table of sizes for each target that is requested, or for this machine.
///
/// # Errors
/// Errors of the models or the system, or that a compiler is missing.
pub fn run(folder: &Path, asked: &Asked, colour: bool) -> Result<String, Error> {
    let wanted = Wanted { package: asked.package.name(), colour, ..Wanted::default() };
    let named = asked.target.iter().map(|target| verify::machine(*target));
    let mut targets: Vec<(&str, Toolchain)> = named.collect();
    if targets.is_empty() {
        targets.push(("this machine", GCC));
    }
    // Before a build of a minute, the compilers that it would be in vain without.
    targets.iter().try_for_each(|(_, it)| bessemer_tools::check(&[it.compiler]))?;
    let (project, compiled) = compile(folder, wanted)?;
    let estimates = estimate::estimates(&compiled.explicit);
    let estimated = |entry: &EntryReport| {
        estimates.get(entry.function.index()).and_then(|it| it.cost).map(|it| it.instructions)
    };
    let mut text = String::new();
    for (index, (name, toolchain)) in targets.into_iter().enumerate() {
        let toolchain = toolchain.of(project.settings.options.standard);
        let measured = measured(&compiled, &toolchain)?;
        let failed = |said: String| Error::Compiler { name: toolchain.name(), said };
        let longest = longest::longest(&compiled, &toolchain).map_err(failed)?;
        let width = compiled.entries.iter().map(|it| it.entry.len()).max().unwrap_or(0).max(11);
        // Writing to a string cannot fail.
        let _ = write!(
            text,
            "{}on {name}, by {}; bytes:\n  {:width$}    text  data   bss  stack  state  executed\n",
            if index == 0 { "" } else { "\n" },
            toolchain.name(),
            "entry point"
        );
        for (at, (entry, (_, sizes))) in compiled.entries.iter().zip(&measured.entries).enumerate()
        {
            let executed = match &longest {
                Some(list) => list[at].cost.as_ref().ok().map(|it| it.instructions),
                None => estimated(entry),
            };
            let executed = executed.map_or_else(|| "no bound".to_owned(), |it| it.to_string());
            let Sizes { text: code, data, bss } = sizes;
            let _ = writeln!(
                text,
                "  {:width$}  {code:>6}  {data:>4}  {bss:>4}  {:>5}  {:>5}  {:>8}",
                entry.entry, entry.stack_bytes, entry.state_bytes, executed
            );
        }
        let Sizes { text: code, data, bss } = measured.all;
        let _ = writeln!(text, "  {:width$}  {code:>6}  {data:>4}  {bss:>4}", "all of the C");
    }
    Ok(text)
}
