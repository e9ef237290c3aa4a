//! Coverage of the C by the inputs of `verify`, by recordings, and by the calls of the author's tests.
//!
//! The C is instrumented (`bessemer_dossier::coverage`), compiled once, and run with each set of inputs.

use std::path::{Path, PathBuf};
use std::process::Stdio;

use bessemer_codegen::compile::{Compiled, Options};
use bessemer_dossier::coverage::instrument::{self, Instrumented};
use bessemer_dossier::coverage::{self, Report, Seen};
use bessemer_dossier::trace::Folder;
use bessemer_ir::FunctionId;
use bessemer_legs::harness;
use bessemer_legs::toolchain::{self, Toolchain};
use bessemer_project::Project;

use super::{Case, Inputs, all, cases, chosen, parted, recorded};
use crate::error::Error;

/// Sources of inputs besides generated ones.
#[derive(Debug, Default)]
pub struct Sources {
    /// Recordings: the entry point and the file.
    pub recordings: Vec<(String, PathBuf)>,
    /// Calls of tests: the entry point, and the words of each call.
    pub tests: Vec<(String, Vec<Vec<u64>>)>,
    /// Largest number of further seeds, as long as one closes a pair.
    pub fill: u64,
}

/// Number of seeds in a row without a new pair after which no more are tried.
const PATIENCE: u64 = 10;

/// Measures the coverage of the C.
///
/// # Errors
/// There is no compiler, the C does not compile, or a recording cannot be read.
pub fn covered(
    project: &Project,
    compiled: &Compiled,
    folder: &Folder,
    sources: &Sources,
) -> Result<Report, Error> {
    let toolchain = toolchain::host().into_iter().next().ok_or(Error::NoCompiler)?;
    let standard = project.settings.options.standard;
    let toolchain = Toolchain { level: 0, ..toolchain.of(standard) };
    // The firmware's own function at a fault is not in the program.
    let options = Options { hook: None, ..project.settings.options.clone() };
    let without_hook;
    let compiled = match project.settings.options.hook {
        None => compiled,
        Some(_) => {
            let anew = compiled.anew(&options);
            without_hook = anew.map_err(|wrong| Error::Compiler {
                name: "bessemer".to_owned(),
                said: wrong.into_iter().map(|it| it.message).collect(),
            })?;
            &without_hook
        }
    };
    let module = &compiled.module;
    let texts = compiled.files.iter().map(|it| (it.name.as_str(), it.text.as_str()));
    let authored = |name: &str| {
        let file = compiled.files.iter().find(|it| it.name == name);
        file.is_some_and(|it| it.map.iter().any(|row| !row.function.contains("::kernels::")))
    };
    let done = instrument::instrument(texts, authored);
    let entries: Vec<FunctionId> = all(module).collect();
    let program = Program::build(&options, compiled, &done, &entries, &toolchain)?;

    let mut seen = Seen::default();
    let mut names = Vec::new();
    let add = |seen: &mut Seen, inputs: &Inputs| -> Result<usize, Error> {
        let cases = cases(module, inputs);
        let calls = cases.iter().map(|it| it.calls.len()).sum();
        seen.add(&program.run(&cases, &entries)?);
        Ok(calls)
    };
    let calls = add(&mut seen, &Inputs::Made { seed: 0 })?;
    names.push(format!("{calls} calls with edge values and small numbers, as of verify"));
    for (entry, path) in &sources.recordings {
        let inputs = recorded(project, compiled, path, Some(entry.as_str()))?;
        let calls = add(&mut seen, &inputs)?;
        let file = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        names.push(format!("{calls} recorded calls of {entry} ({file})"));
    }
    let mut of_tests = 0;
    for (entry, calls) in &sources.tests {
        let entry = chosen(compiled, Some(entry.as_str()))?;
        let calls = parted(module, entry, calls)?;
        of_tests += add(&mut seen, &Inputs::Recorded { entry, calls, notes: Vec::new() })?;
    }
    if of_tests > 0 {
        names.push(format!("{of_tests} calls of tests by same_bits"));
    }
    let pairs = |seen: &Seen| {
        let counts = coverage::report(&done, seen, folder, Vec::new()).counts;
        (counts.conditions.covered, counts.branches.covered, counts.statements.covered)
    };
    let (mut best, mut waited, mut tried) = (pairs(&seen), 0, 0);
    while tried < sources.fill && waited < PATIENCE {
        tried += 1;
        add(&mut seen, &Inputs::Made { seed: tried })?;
        let now = pairs(&seen);
        waited = if now == best { waited + 1 } else { 0 };
        best = now;
    }
    if tried > 0 {
        names.push(format!("{tried} further seeds of --fill"));
    }
    Ok(coverage::report(&done, &seen, folder, names))
}

/// The instrumented C as a program.
struct Program {
    folder: tempfile::TempDir,
    toolchain: Toolchain,
    sizes: Instrumented,
}

impl Program {
    fn build(
        options: &Options,
        compiled: &Compiled,
        done: &Instrumented,
        entries: &[FunctionId],
        toolchain: &Toolchain,
    ) -> Result<Program, Error> {
        let failed = |said: String| Error::Compiler { name: toolchain.name(), said };
        let file = |path: &Path| {
            let path = path.to_owned();
            move |source| Error::File { path, source }
        };
        let folder = tempfile::tempdir().map_err(file(&std::env::temp_dir()))?;
        let mut sources = Vec::new();
        for (name, text) in &done.files {
            let path = folder.path().join(name);
            let parent = path.parent().unwrap_or(folder.path());
            std::fs::create_dir_all(parent).map_err(file(parent))?;
            std::fs::write(&path, text).map_err(file(&path))?;
            if name.ends_with(".c") {
                sources.push(path);
            }
        }
        let taken: Vec<(FunctionId, u32)> =
            entries.iter().map(|id| (*id, compiled.module.functions[id.index()].params)).collect();
        let main = harness::programs_with(&compiled.explicit, &taken, options);
        let main = instrument::writing(&main);
        let main = main.ok_or_else(|| failed("the program has no `main`".to_owned()))?;
        let path = folder.path().join("covered_main.c");
        std::fs::write(&path, main).map_err(file(&path))?;
        let program = folder.path().join("covered");
        let include = format!("-I{}", folder.path().display());
        toolchain.around(&path, &sources, &program, &[include.as_str()]).map_err(failed)?;
        let sizes = Instrumented {
            points: done.points.clone(),
            bytes: done.bytes,
            ..Instrumented::default()
        };
        Ok(Program { folder, toolchain: toolchain.clone(), sizes })
    }

    fn run(&self, cases: &[Case], entries: &[FunctionId]) -> Result<Seen, Error> {
        use std::io::{Seek, Write};
        let here = self.folder.path();
        let failed = |source| Error::File { path: here.to_owned(), source };
        let mut bytes = Vec::new();
        for case in cases {
            let place = entries.iter().position(|id| *id == case.id).unwrap_or_default() as u64;
            for call in &case.calls {
                bytes.extend(place.to_le_bytes());
                call.iter().flatten().for_each(|word| bytes.extend(word.to_le_bytes()));
            }
        }
        let mut file = tempfile::tempfile().map_err(failed)?;
        file.write_all(&bytes).and_then(|()| file.rewind()).map_err(failed)?;
        let seen = here.join("seen");
        let mut command = self.toolchain.runner(&here.join("covered"));
        command.arg(&seen).stdin(Stdio::from(file)).stdout(Stdio::null());
        let status = command.status().map_err(failed)?;
        let bytes = std::fs::read(&seen).map_err(failed)?;
        Seen::read(&bytes, &self.sizes).ok_or_else(|| Error::Compiler {
            name: self.toolchain.name(),
            said: format!("the instrumented program ended with {status}"),
        })
    }
}
