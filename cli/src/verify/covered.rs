//! Coverage of the C by made inputs, by recordings, by the calls of the author's tests, and by a search.
//!
//! The C is instrumented (`bessemer_dossier::coverage`), compiled once, and run with each set of inputs. Components begin
//! in their initial state.

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
use bessemer_words::record::{self, Calls};
use tempfile::TempDir;

use super::lives;
use super::parts::widths;
use super::search::{Life, Search};
use super::{Inputs, chosen, recorded};
use crate::error::Error;

/// Sources of inputs besides made ones.
#[derive(Debug, Default)]
pub struct Sources {
    /// Recordings: the entry point and the file.
    pub recordings: Vec<(String, PathBuf)>,
    /// Folder of the calls of tests.
    pub tests: Option<TempDir>,
    /// Number of rounds of the search.
    pub fill: u64,
}

/// Measures the coverage of the C. Returns also the search, which knows the lives that did it.
///
/// # Errors
/// There is no compiler, the C does not compile, or a recording cannot be read.
pub fn covered<'c>(
    project: &Project,
    compiled: &'c Compiled,
    folder: &Folder,
    sources: &Sources,
) -> Result<(Report, Search<'c>), Error> {
    let mut search = Search::new(&compiled.module);
    let toolchain = toolchain::host().into_iter().next().ok_or(Error::NoCompiler)?;
    let standard = project.settings.options.standard;
    let toolchain = Toolchain { level: 0, ..toolchain.of(standard) };
    let options = lives::options(project);
    let without_hook = lives::without_hook(project, compiled)?;
    let compiled = without_hook.as_ref().unwrap_or(compiled);
    let texts = compiled.files.iter().map(|it| (it.name.as_str(), it.text.as_str()));
    let authored = |name: &str| {
        let file = compiled.files.iter().find(|it| it.name == name);
        file.is_some_and(|it| it.map.iter().any(|row| !row.function.contains("::kernels::")))
    };
    let done = instrument::instrument(texts, authored);
    let program = Program::build(&options, compiled, &done, &search, &toolchain)?;
    let mut covered = Covered { program, seen: Seen::default() };
    let mut names = Vec::new();

    let first = search.first();
    let calls: usize = first.iter().map(|it| it.calls.len()).sum();
    names.push(format!(
        "{calls} calls of {} entry points and functions: edge values, small numbers, constants of the code",
        search.targets.len()
    ));
    for of_one in first.chunk_by(|one, other| one.target == other.target) {
        covered.add(&mut search, of_one)?;
    }
    for (entry, path) in &sources.recordings {
        let inputs = recorded(project, compiled, path, Some(entry.as_str()))?;
        let Inputs::Recorded { entry: id, calls, .. } = inputs else { continue };
        let calls = calls.iter().map(|call| call.concat()).collect();
        let calls = covered.record(&mut search, id, calls)?;
        let file = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        names.push(format!("{calls} recorded calls of {entry} ({file})"));
    }
    let mut of_tests = 0;
    if let Some(folder) = &sources.tests {
        each_of_tests(compiled, folder.path(), |entry, calls| {
            of_tests += covered.record(&mut search, entry, calls)?;
            Ok(())
        })?;
    }
    if of_tests > 0 {
        names.push(format!("{of_tests} calls of tests"));
    }
    let mut found = 0;
    for _ in 0..sources.fill {
        for place in 0..search.targets.len() {
            let lives = search.changed(place);
            found += covered.add(&mut search, &lives)?;
        }
    }
    if sources.fill > 0 {
        names.push(format!(
            "{found} sequences of calls, found by --fill in {} rounds",
            sources.fill
        ));
    }
    let report = coverage::report(&done, &covered.seen, folder, names);
    Ok((report, search))
}

/// Calls `done` with an entry point and the words of its calls, for each file that tests recorded.
///
/// # Errors
/// A file cannot be read, or an error of `done`.
pub fn each_of_tests(
    compiled: &Compiled,
    folder: &Path,
    mut done: impl FnMut(FunctionId, Vec<Vec<u64>>) -> Result<(), Error>,
) -> Result<(), Error> {
    let file = |path: PathBuf| move |source| Error::File { path, source };
    for path in record::files(folder).map_err(file(folder.to_owned()))? {
        // One file after the other: those of a simulation have gigabytes.
        let Calls { entry, calls } = Calls::read(&path).map_err(file(path))?;
        let entry = chosen(compiled, Some(entry.as_str()))?;
        widths(&compiled.module, entry, &calls)?;
        done(entry, calls)?;
    }
    Ok(())
}

/// The program, and all that its runs have covered.
struct Covered {
    program: Program,
    seen: Seen,
}

impl Covered {
    /// Runs lives; those that reach something new are kept for the search. Returns their number.
    fn add(&mut self, search: &mut Search<'_>, lives: &[Life]) -> Result<usize, Error> {
        let seen = self.program.run(lives)?;
        if !self.seen.lacks(&seen) {
            return Ok(0);
        }
        if let [life] = lives {
            self.seen.add(&seen);
            search.keep(life);
            return Ok(1);
        }
        let (one, other) = lives.split_at(lives.len() / 2);
        Ok(self.add(search, one)? + self.add(search, other)?)
    }

    /// Runs the calls of a recording. Returns their number.
    fn record(
        &mut self,
        search: &mut Search<'_>,
        entry: FunctionId,
        calls: Vec<Vec<u64>>,
    ) -> Result<usize, Error> {
        let Some(target) = search.targets.iter().position(|it| it.id == entry) else {
            return Ok(0);
        };
        let count = calls.len();
        self.add(search, &[Life { target, calls }])?;
        Ok(count)
    }
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
        search: &Search<'_>,
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
        let functions: Vec<FunctionId> = search.targets.iter().map(|it| it.id).collect();
        let taken = lives::taken(&compiled.module, &functions);
        let main = harness::lives(&compiled.explicit, &taken, options);
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

    fn run(&self, lives: &[Life]) -> Result<Seen, Error> {
        use std::io::{Seek, Write};
        let here = self.folder.path();
        let failed = |source| Error::File { path: here.to_owned(), source };
        let bytes: Vec<u8> = lives.iter().flat_map(Life::bytes).collect();
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
