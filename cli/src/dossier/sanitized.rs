//! Runs of the C with the sanitizers of gcc and clang, at the same time.

use bessemer_codegen::compile::Compiled;
use bessemer_dossier::content::{Outcome, grouped};
use bessemer_legs::toolchain::Toolchain;
use bessemer_project::Project;

use super::checks::{FAILED, NOT_RUN, PASSED, first_error, version};
use super::known::Known;
use super::{joined, outcome};
use crate::error::Error;
use crate::verify::lives;
use crate::verify::sanitized::{Program, compilers};
use crate::verify::search::Life;

/// Runs all calls with each compiler's sanitizers.
pub fn checked(project: &Project, compiled: &Compiled, calls: &Known<'_>) -> Vec<Outcome> {
    let standard = project.settings.options.standard;
    let one = &|toolchain: Toolchain, with_tests: bool| {
        let compiler = version(toolchain.compiler);
        let of = |verdict, detail| {
            let what = format!("Sanitizers of {}", toolchain.compiler);
            outcome(&what, "cargo bessemer dossier", compiler.clone(), verdict, detail)
        };
        match run(project, compiled, &toolchain.clone().of(standard), (calls, with_tests)) {
            Ok((count, None)) => {
                let count = grouped(count as u64);
                of(PASSED, format!("{count} calls, no report of an address or undefined behaviour"))
            }
            Ok((count, Some(report))) => of(FAILED, format!("within {count} calls: {report}")),
            // The libraries of the sanitizers may be missing, or the emitted C may be at fault: verify compiles it, too.
            Err(Error::Compiler { said, .. }) => {
                of(NOT_RUN, format!("no program: {}", first_error(&said)))
            }
            Err(error) => of(FAILED, error.to_string()),
        }
    };
    let compilers = compilers();
    // The calls of tests, which may be millions, under the first compiler alone.
    let first = compilers.first().map(|it| it.compiler);
    std::thread::scope(|scope| {
        let one = |it: Toolchain| {
            let with_tests = first == Some(it.compiler);
            move || one(it, with_tests)
        };
        let runs: Vec<_> = compilers.into_iter().map(|it| scope.spawn(one(it))).collect();
        runs.into_iter().map(joined).collect()
    })
}

/// Returns the number of calls, and a report if there is one.
fn run(
    project: &Project,
    compiled: &Compiled,
    toolchain: &Toolchain,
    (calls, with_tests): (&Known<'_>, bool),
) -> Result<(usize, Option<String>), Error> {
    let without_hook = lives::without_hook(project, compiled)?;
    let c = without_hook.as_ref().unwrap_or(compiled);
    let options = lives::options(project);
    let mut program = Program::build(c, &options, &calls.functions, toolchain)?;
    if let Some(report) = program.run(&calls.lives)? {
        return Ok((program.calls, Some(report)));
    }
    let mut found = None;
    if !with_tests {
        return Ok((program.calls, found));
    }
    calls.of_tests(compiled, |life: Life| {
        if found.is_none() {
            found = program.run(&[life])?;
        }
        Ok(())
    })?;
    Ok((program.calls, found))
}
