//! `gen`: the C of a package written, compared or explained, and held against the limits of its user.

use std::fmt::Write as _;
use std::path::Path;

use bessemer_backend::c::{CFile, EntryReport};
use bessemer_backend::passes;
use bessemer_codegen::compile::Compiled;
use bessemer_codegen::estimate;
use bessemer_codegen::generate::{self, Job, Made};
use bessemer_frontend::diagnostic::{self, Diagnostic, Told};
use bessemer_frontend::source::Sources;

use crate::error::Error;
use crate::project::Project;
use crate::settings::{Limit, Settings};
use crate::{build_files, interface, parameters};

/// The choices of one generation.
#[derive(Clone, Copy, Debug, Default)]
pub struct Wanted<'a> {
    /// The name of the package, if the user gave one.
    pub package: Option<&'a str>,
    /// Compares instead of writing.
    pub check: bool,
    /// Also lists the checks that are left.
    pub explain: bool,
    /// Colours diagnostics and differences.
    pub colour: bool,
}

/// The outcome of a generation, for the user.
#[derive(Debug)]
pub struct Generated {
    /// The report.
    pub text: String,
    /// Warnings for the author of the models.
    pub remarks: Told,
}

/// The texts that a generation prints.
pub struct Said {
    /// Text for standard output.
    pub text: String,
    /// Text for standard error.
    pub remarks: String,
    /// True if the C is as it should be.
    pub good: bool,
}

/// The texts to print. With `for_tools`, errors in the models are no failure, but one JSON object a line.
///
/// # Errors
/// The error of `done`, unless it is about the models and `for_tools` is set.
pub fn said(done: Result<Generated, Error>, for_tools: bool) -> Result<Said, Error> {
    use generate::Error as Of;
    let lines = |told: &Told, good| Said {
        text: told.json_lines().to_owned(),
        remarks: String::new(),
        good,
    };
    match done {
        Err(Error::Generate(Of::Models(told) | Of::Refused(told))) if for_tools => {
            Ok(lines(&told, false))
        }
        Ok(done) if for_tools => Ok(lines(&done.remarks, true)),
        done => done.map(|Generated { text, remarks }| Said {
            text,
            remarks: remarks.to_string(),
            good: true,
        }),
    }
}

/// Generates the C of the package that `folder` belongs to.
///
/// # Errors
/// Errors of the models, the settings or the file system. The folder of the C is then as it was before.
pub fn generate(folder: &Path, wanted: Wanted<'_>) -> Result<Generated, Error> {
    let project = Project::find(folder, wanted.package, wanted.colour)?;
    let mut job = project.job(wanted.colour);
    job.check = wanted.check;
    if !job.check {
        generate::ready(&job)?;
    }
    let Made { compiled, remarks } = limited(&project, &job)?;
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
    Ok(Generated { text, remarks })
}

/// Compiles the package that `folder` belongs to, and writes nothing.
///
/// # Errors
/// Errors of the models or the settings.
pub fn compile(folder: &Path, wanted: Wanted<'_>) -> Result<(Project, Compiled), Error> {
    let project = Project::find(folder, wanted.package, wanted.colour)?;
    let made = generate::compiled(&project.job(wanted.colour))?;
    Ok((project, made.compiled))
}

fn limited(project: &Project, job: &Job) -> Result<Made, Error> {
    let mut made = generate::compiled_from(job, &generate::renewed(job)?)?;
    let limits = &project.settings.limits;
    let figures = made.compiled.entries.iter().flat_map(|entry| {
        let whose = format!("`{}`", entry.entry);
        [
            (limits.stack_bytes, entry.stack_bytes, "bytes of stack"),
            (limits.state_bytes, entry.state_bytes, "bytes of state"),
            (limits.checks, u64::from(entry.checks), "checks"),
        ]
        .map(|(limit, found, what)| Figure { limit, whose: whose.clone(), found, what })
    });
    let estimated = estimated(&made.compiled, limits.estimated_instructions);
    hold(project, figures.chain(estimated), job.colour)?;
    made.compiled.files.extend(parameter_tables(project, &made.compiled));
    if project.settings.build_files {
        let more = build_files::files(&made.compiled, &project.settings.options);
        made.compiled.files.extend(more);
    }
    if project.settings.interface {
        let (name, map) = (interface::NAME.to_owned(), Vec::new());
        let text = interface::text(&made.compiled.module.name, &made.compiled.interface);
        made.compiled.files.push(CFile { name, text, map });
    }
    Ok(made)
}

/// Estimates of the instructions of each entry point, if there is a limit for them.
fn estimated(compiled: &Compiled, limit: Option<Limit>) -> Vec<Figure> {
    let Some(limit) = limit else { return Vec::new() };
    let estimates = estimate::estimates(&compiled.explicit);
    let figure = |entry: &EntryReport| {
        let whose = format!("`{}`", entry.entry);
        match estimates.get(entry.function.index()).and_then(|it| it.cost) {
            Some(cost) => Figure {
                limit: Some(limit),
                whose,
                found: cost.instructions,
                what: "estimated instructions",
            },
            None => {
                let reached = passes::reached(&compiled.explicit, entry.function.index());
                let loops = reached.iter().flat_map(|at| &estimates[*at].loops);
                let unbounded = loops.filter(|it| it.passes.is_none()).count() as u64;
                let none = Limit { most: 0, ..limit };
                let what = "loops without a known number of passes";
                Figure { limit: Some(none), whose, found: unbounded, what }
            }
        }
    };
    compiled.entries.iter().map(figure).collect()
}

/// The files of the tables of parameters, where the settings request them.
pub fn parameter_tables(project: &Project, compiled: &Compiled) -> Vec<CFile> {
    let Settings { options, parameters: wanted, .. } = &project.settings;
    let files = || parameters::files(&compiled.interface, options, &compiled.license);
    wanted.then(files).unwrap_or_default()
}

/// A measured or bounded figure of the C, and its limit.
pub struct Figure {
    /// Upper limit, if there is one.
    pub limit: Option<Limit>,
    /// The function or the C that the figure is of, in the form that begins a sentence: `` `motor_step` ``.
    pub whose: String,
    /// Value of the figure.
    pub found: u64,
    /// Unit of the figure: `bytes of stack`.
    pub what: &'static str,
}

/// Compares figures with the limits of a project.
///
/// # Errors
///
/// [`Error::Limit`] with all exceeded limits, each at its place in `bessemer.toml`.
pub fn hold(
    project: &Project,
    figures: impl Iterator<Item = Figure>,
    colour: bool,
) -> Result<(), Error> {
    let mut beyond = Vec::new();
    for Figure { limit, whose, found, what } in figures {
        let Some(Limit { most, line, column }) = limit else { continue };
        if found > u64::from(most) {
            beyond.push(Diagnostic {
                file: project.file_name(),
                line,
                column,
                message: format!("{whose} has {found} {what}, more than {most}"),
                help: "make it smaller, or raise the limit".to_owned(),
                ..Diagnostic::default()
            });
        }
    }
    if beyond.is_empty() {
        return Ok(());
    }
    Err(Error::Limit(diagnostic::render(&beyond, &Sources::new(&project.workspace.root), colour)))
}
