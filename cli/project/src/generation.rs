//! `gen`: the C of a package written, compared or explained, and held against the limits of its user.

use std::fmt::Write as _;
use std::path::Path;

use bessemer_codegen::compile::Compiled;
use bessemer_codegen::diagnostic::{self, Diagnostic};
use bessemer_codegen::generate::{self, Job};
use bessemer_codegen::source::Sources;

use crate::error::Error;
use crate::project::Project;
use crate::settings::Limit;

/// What is asked of a generation.
#[derive(Clone, Copy, Debug, Default)]
pub struct Wanted<'a> {
    /// The package, if its name is given.
    pub package: Option<&'a str>,
    /// Compare instead of writing.
    pub check: bool,
    /// Also list the checks that are left.
    pub explain: bool,
    /// Colour in diagnostics and differences.
    pub colour: bool,
}

/// Generates the package that is meant in `folder`; what there is to say of it.
///
/// # Errors
/// What the models, the settings or the file system said: the folder of the C is as it was then.
pub fn generate(folder: &Path, wanted: Wanted<'_>) -> Result<String, Error> {
    let project = Project::find(folder, wanted.package, wanted.colour)?;
    let mut job = project.job(wanted.colour);
    job.check = wanted.check;
    if !job.check {
        generate::ready(&job)?;
    }
    let compiled = limited(&project, &job)?;
    let changed = generate::deliver(&job, &compiled)?;
    let mut text = String::new();
    if !wanted.check {
        let output = job.output.strip_prefix(&job.root).unwrap_or(&job.output).display();
        let files = compiled.files.len();
        text += &generate::table(&compiled);
        // Writing to a string cannot fail.
        let _ = match changed.as_slice() {
            [] => writeln!(text, "\n{files} files in {output}/, all up to date"),
            changed => writeln!(
                text,
                "\n{files} files in {output}/, {} changed: {}",
                changed.len(),
                changed.join(" ")
            ),
        };
    }
    if wanted.explain {
        let _ = write!(text, "\n{}", generate::explanation(&compiled));
    }
    Ok(text)
}

/// Compiles the package that is meant in `folder`, and writes nothing.
///
/// # Errors
/// What the models or the settings said.
pub fn compile(folder: &Path, wanted: Wanted<'_>) -> Result<(Project, Compiled), Error> {
    let project = Project::find(folder, wanted.package, wanted.colour)?;
    let compiled = generate::compiled(&project.job(wanted.colour))?;
    Ok((project, compiled))
}

fn limited(project: &Project, job: &Job) -> Result<Compiled, Error> {
    let compiled = generate::compiled(job)?;
    let limits = &project.settings.limits;
    let mut beyond = Vec::new();
    for entry in &compiled.entries {
        let held = [
            (limits.stack_bytes, entry.stack_bytes, "bytes of stack"),
            (limits.state_bytes, entry.state_bytes, "bytes of state"),
            (limits.checks, u64::from(entry.checks), "checks"),
        ];
        for (limit, found, what) in held {
            let Some(Limit { most, line, column }) = limit else { continue };
            if found > u64::from(most) {
                beyond.push(Diagnostic {
                    file: project.file_name(),
                    line,
                    column,
                    message: format!("`{}` has {found} {what}, more than {most}", entry.entry),
                    help: "make it smaller, or raise the limit".to_owned(),
                });
            }
        }
    }
    if beyond.is_empty() {
        return Ok(compiled);
    }
    Err(Error::Limit(diagnostic::render(&beyond, &Sources::new(&job.root), job.colour)))
}
