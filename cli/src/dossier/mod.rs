//! `cargo bessemer dossier`: writes the folder that a reviewer reads, or compares one with the sources.
//!
//! Invariants: the folder is written whole or not at all; what could not be run is in it with the reason. It must not know
//! how a page looks.

mod checks;
mod climb;
mod contracts;
mod known;
mod sanitized;
mod sources;
mod worst;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use bessemer_codegen::compile::Compiled;
use bessemer_codegen::estimate::{self, Estimate};
use bessemer_codegen::generate;
use bessemer_dossier::calls::Calls;
use bessemer_dossier::change::{self, Version};
use bessemer_dossier::content::{self, Content, Outcome};
use bessemer_dossier::coverage::reasons;
use bessemer_dossier::evidence::{self, Evidence};
use bessemer_dossier::manifest;
use bessemer_dossier::requirements::table::{self, Requirement};
use bessemer_dossier::requirements::{Matrix, Results};
use bessemer_dossier::scan::Kind;
use bessemer_dossier::trace::{Folder, Workspace};
use bessemer_dossier::{output, page};
use bessemer_project::Project;

use crate::args::Dossier;
use crate::error::Error;
use crate::verify::covered::{self, Sources};
use crate::verify::search::Search;

/// Names of the list of requirements beside the package's manifest.
const REQUIREMENTS: [&str; 2] = ["requirements.csv", "requirements.reqif"];
/// Name of the table of reasons beside the package's manifest.
const REASONS: &str = "coverage.csv";

/// Reason why a dossier cannot be made.
#[derive(Debug, thiserror::Error)]
pub enum Wrong {
    /// The C in the folder differs from the output of a new generation.
    #[error("the C in `{folder}` is stale: {}", files.join(", "))]
    Stale {
        /// The folder.
        folder: PathBuf,
        /// Names of files, each with the difference.
        files: Vec<String>,
    },
    /// A source or an attribute cannot be read.
    #[error("`{file}`, line {line}: {why}")]
    Source {
        /// The file.
        file: String,
        /// The line.
        line: u32,
        /// The mistake.
        why: String,
    },
    /// The list of requirements cannot be read.
    #[error("`{path}`: {why}")]
    Requirements {
        /// The file.
        path: PathBuf,
        /// The mistake.
        why: table::Error,
    },
    /// The table of reasons cannot be read.
    #[error("`{path}`: {why}")]
    Reasons {
        /// The file.
        path: PathBuf,
        /// The mistake.
        why: reasons::Error,
    },
    /// An input is no `ENTRY=FILE`.
    #[error("`{said}` is no entry point with a file")]
    Input {
        /// The user's text.
        said: String,
    },
    /// The earlier version is not there.
    #[error("git knows no version `{tag}`: {said}")]
    Tag {
        /// The user's text.
        tag: String,
        /// Message of git.
        said: String,
    },
    /// The earlier version has no C.
    #[error("`{tag}` has no C in `{folder}`")]
    NoC {
        /// The version.
        tag: String,
        /// The folder of the C.
        folder: String,
    },
    /// The folder cannot be written or read.
    #[error(transparent)]
    Output(#[from] output::Error),
}

impl Wrong {
    /// Returns a step that resolves the error.
    pub fn remedy(&self) -> Option<String> {
        Some(match self {
            Wrong::Stale { .. } => "write it anew: `cargo bessemer gen`, and review it".to_owned(),
            Wrong::Source { .. } => return None,
            Wrong::Requirements { why, .. } => why.remedy().to_owned(),
            Wrong::Reasons { .. } => {
                "pass CSV whose first line is `function,code,reason`".to_owned()
            }
            Wrong::Input { .. } => "write `--inputs Motor::step=flight.csv`".to_owned(),
            Wrong::Tag { .. } => "name a tag or a commit of this repository: `git tag`".to_owned(),
            Wrong::NoC { .. } => {
                "name a version in which the C is committed, with its maps".to_owned()
            }
            Wrong::Output(error) => return error.remedy(),
        })
    }
}

/// Writes the dossier, or compares one. Returns the text to print, and true if all checks passed.
///
/// # Errors
/// Errors of the models, the C or the system; nothing is then written.
pub fn run(folder: &Path, wanted: &Dossier, colour: bool) -> Result<(String, bool), Error> {
    let project = Project::find(folder, wanted.package.name(), colour)?;
    if let Some(dossier) = &wanted.check {
        return compared(&project, dossier, colour);
    }
    let place = folder.join(&wanted.output);
    // Before minutes of work, everything that it would be in vain without.
    output::ready(&place).map_err(Wrong::from)?;
    for package in &wanted.tests {
        project.workspace.member(package).map_err(bessemer_project::Error::from)?;
    }
    let inputs = wanted.inputs.iter().map(|said| input(said));
    let recordings = inputs.collect::<Result<Vec<_>, _>>()?;
    let root = &project.workspace.root;
    let say = |step: &str| anstream::eprintln!("dossier: {step}");
    let list_file = beside(&project, &wanted.requirements, &REQUIREMENTS);
    let reasons_file = beside(&project, &wanted.reasons, &[REASONS]);
    for (what, path) in [("requirements", &list_file), ("reasons", &reasons_file)] {
        if let Some(path) = path {
            say(&format!("{what} are those of {}", shown(root, path)));
        }
    }
    let list = list_file.as_deref().map(requirements).transpose()?;
    let reasons = reasons_file.as_deref().map(reasons).transpose()?.unwrap_or_default();
    let items = sources::items(&project, &wanted.tests)?;
    let earlier = wanted.since.as_deref().map(|tag| sources::earlier(&project, tag, colour));
    let earlier = earlier.transpose()?;

    say("compiling the models");
    let job = project.job(colour);
    let compiled = generate::compiled(&job).map_err(bessemer_project::Error::from)?.compiled;
    current(&job.output, &compiled)?;
    let c = Folder::read(&job.output)?;
    let calls = Calls::of(&c);
    let estimates = estimate::estimates(&compiled.explicit);

    let mut results = vec![checks::current(&compiled)];
    let mut of_tests = Results::new();
    let mut own = Sources { recordings, fill: wanted.fill, ..Sources::default() };
    let (mut sizes, mut paths, mut proved) = (Vec::new(), Vec::new(), Vec::new());
    let mut coverage = None;
    if wanted.quick {
        results.extend(checks::not_run("`--quick` was passed"));
    } else {
        say("running the tests");
        let tested = checks::tests(&project, &wanted.tests, &items);
        results.push(tested.outcome);
        (of_tests, own.tests) = (tested.results, tested.calls);
        say("comparing Rust, interpreter and C");
        results.push(checks::verified(folder, wanted.package.name()));
        say("measuring the coverage of the C");
        let measured = covered::covered(&project, &compiled, &c, &own);
        let (measured, search) = match measured {
            Ok((report, search)) => (Ok(report), search),
            Err(error) => (Err(error), Search::new(&compiled.module)),
        };
        let (outcomes, report) = checks::covered(measured, &reasons)?;
        results.extend(outcomes);
        coverage = report;
        let calls = known::Known::of(search, own.tests.as_ref(), wanted.fill);
        let targets = checks::targets();
        let (project, compiled, calls) = (&project, &compiled, &calls);
        // Each of them leaves a processor idle at times.
        let (others, found) = std::thread::scope(|scope| {
            let others = scope.spawn(|| {
                say("running the calls with sanitizers");
                let outcomes = sanitized::checked(project, compiled, calls);
                say("proving contracts");
                (outcomes, contracts::proved(project, compiled, &c))
            });
            say("finding the longest paths, and counting calls");
            let found = worst::on_all(project, compiled, &targets, calls);
            (joined(others), found)
        });
        let (sanitized, (contracts, rows)) = others;
        results.extend(sanitized);
        results.push(contracts);
        proved = rows;
        for (outcome, rows) in found {
            results.push(outcome);
            paths.extend(rows);
        }
        for (name, toolchain) in targets {
            say(&format!("measuring sizes on {name}"));
            let (outcome, rows) = checks::sizes(project, compiled, name, toolchain);
            results.push(outcome);
            sizes.extend(rows);
        }
    }
    say("writing the pages");
    let rust = sources::rust_texts(root, &c);
    let change = earlier.as_ref().map(|earlier| {
        let now_manifest = std::fs::read_to_string(job.output.join("manifest.json"));
        let now_manifest = now_manifest.unwrap_or_default();
        let options = sources::options(&project);
        let now = Version {
            folder: &c,
            manifest: &now_manifest,
            rust: &rust,
            options: options.as_deref(),
        };
        let before = Version {
            folder: &earlier.folder,
            manifest: &earlier.manifest,
            rust: &earlier.rust,
            options: earlier.options.as_deref(),
        };
        change::change(&earlier.tag, &before, &now, &items)
    });
    let lock = std::fs::read_to_string(root.join("Cargo.lock")).unwrap_or_default();
    let path = list_file.as_deref().map(|path| shown(root, path)).unwrap_or_default();
    let list = list.as_deref().map(|list| (&*path, list));
    let matrix = Matrix::of(list, &items, &c, &of_tests);
    let failed = results.iter().any(|it| it.verdict == checks::FAILED);
    let content = Content {
        package: project.package.name.clone(),
        tool: job.version.clone(),
        rustc: checks::rustc(),
        license: compiled.license.clone(),
        results,
        sizes,
        paths,
        proved,
        coverage,
        change,
        evidence: Evidence::of(&c, &lock, &project.package.name),
        traced: traced(&c),
        ..content(&compiled, &c, &calls, &estimates, matrix)
    };
    let tests = items.iter().filter(|it| it.is_test).map(|it| PathBuf::from(&it.file));
    let lists = list_file.iter().chain(&reasons_file).filter_map(|path| within(root, path));
    let others: Vec<PathBuf> = tests.chain(lists).map(|path| root.join(path)).collect();
    let files = files(&project, &c, &content, &lock, &others)?;
    output::write(&place, &files).map_err(Wrong::from)?;
    let mut text = String::new();
    for it in &content.results {
        text += &format!("{:<8}  {}: {}\n", it.verdict, it.what, it.detail);
    }
    for line in content.matrix.summary() {
        text += &format!("requirements: {line}\n");
    }
    text += &format!("{} files in {}\n", files.len(), wanted.output.display());
    Ok((text, !failed))
}

fn content(
    compiled: &Compiled,
    c: &Folder,
    calls: &Calls,
    estimates: &[Estimate],
    matrix: Matrix,
) -> Content {
    let (components, structs, enums) = content::types(compiled, c, calls, estimates);
    let number = |it: u64| it.to_string();
    let weights = estimate::WEIGHTS.map(|(_, name, instructions, a9, m4f)| {
        [name.to_owned(), number(instructions), number(a9), number(m4f)]
    });
    Content {
        components,
        structs,
        enums,
        functions: content::functions(compiled, c, calls, estimates),
        loops: content::loops(compiled, estimates),
        weights: weights.to_vec(),
        matrix,
        ..Content::default()
    }
}

/// Numbers of statements with a counterpart, and of all, in files with maps.
fn traced(c: &Folder) -> (usize, usize) {
    let files = c.files.iter().filter(|file| !file.rows.is_empty());
    let mut numbers = (0, 0);
    for file in files {
        let statements = file.functions.iter().flat_map(|function| &function.statements);
        for statement in statements.filter(|it| it.kind != Kind::Declaration) {
            numbers.0 += usize::from(file.counterpart(statement.line).is_some());
            numbers.1 += 1;
        }
    }
    numbers
}

/// The files of the dossier, with the manifest.
fn files(
    project: &Project,
    c: &Folder,
    content: &Content,
    lock: &str,
    others: &[PathBuf],
) -> Result<BTreeMap<String, String>, Error> {
    let root = &project.workspace.root;
    let mut manifest = sources::manifest(project, c, &content.tool, &content.rustc, others)?;
    let identity = vec![
        ("package".to_owned(), format!("{} {}", content.package, project.package.version)),
        ("bessemer".to_owned(), content.tool.clone()),
        ("rustc".to_owned(), content.rustc.clone()),
        ("sources".to_owned(), sources::digest(&manifest.sources)),
        ("C".to_owned(), sources::digest(&manifest.c)),
    ];
    let cells = content.matrix.cells();
    let mut files = BTreeMap::from([
        ("index.html".to_owned(), page::index(content, &identity)),
        (page::TRACE_PAGE.to_owned(), page::trace(&content.package, c, &Workspace(root))),
        ("requirements.csv".to_owned(), table::to_csv(&cells)),
        ("requirements.reqif".to_owned(), table::to_reqif(&content.package, &cells)),
        (
            "sbom.cdx.json".to_owned(),
            evidence::sbom(lock, &content.package, &content.tool, &content.rustc),
        ),
    ]);
    if !content.paths.is_empty() {
        files.insert("worst.csv".to_owned(), content::paths_csv(&content.paths));
    }
    manifest.outputs =
        files.iter().map(|(name, text)| (name.clone(), manifest::hash(text.as_bytes()))).collect();
    files.insert(manifest::NAME.to_owned(), manifest.text());
    Ok(files)
}

/// Compares a dossier with the sources of today.
fn compared(project: &Project, dossier: &Path, colour: bool) -> Result<(String, bool), Error> {
    let before = output::manifest(dossier).map_err(Wrong::from)?;
    let c = Folder::read(&project.job(colour).output)?;
    let tool = env!("CARGO_PKG_VERSION");
    // Tests of other packages, and lists elsewhere, are in the dossier only.
    let others: Vec<PathBuf> =
        before.sources.keys().map(|path| project.workspace.root.join(path)).collect();
    let mut today = sources::manifest(project, &c, tool, &checks::rustc(), &others)?;
    let is_page = |path: &Path| path.file_name().is_some_and(|name| name != manifest::NAME);
    manifest::add_folder(dossier, dossier, &is_page, &mut today.outputs)
        .map_err(|(path, source)| Error::File { path, source })?;
    let mut found = before.compare(&today);
    if before.package != project.package.name {
        found.differ.insert(0, format!("it is the dossier of `{}`", before.package));
    }
    let mut text: String = found.differ.iter().map(|it| format!("{it}\n")).collect();
    for note in &found.notes {
        text += &format!("note: {note}\n");
    }
    text += &match found.differ.len() {
        0 => format!("the dossier is of these sources: {} files are equal\n", found.equal),
        count => format!("{} files are equal, {count} differ\n", found.equal),
    };
    Ok((text, found.differ.is_empty()))
}

/// Checks that the C in the folder equals the output of a new generation.
fn current(output: &Path, compiled: &Compiled) -> Result<(), Error> {
    let mut files: Vec<String> = Vec::new();
    for file in &compiled.files {
        match std::fs::read(output.join(&file.name)) {
            Ok(bytes) if bytes == file.text.as_bytes() => {}
            Ok(_) => files.push(format!("`{}` differs", file.name)),
            Err(_) => files.push(format!("`{}` is missing", file.name)),
        }
    }
    if files.is_empty() {
        return Ok(());
    }
    if files.len() > 4 {
        let more = files.len() - 3;
        files.truncate(3);
        files.push(format!("and {more} more"));
    }
    Err(Wrong::Stale { folder: output.to_owned(), files }.into())
}

fn input(said: &str) -> Result<(String, PathBuf), Error> {
    let wrong = || Wrong::Input { said: said.to_owned() };
    let (entry, file) = said.split_once('=').ok_or_else(wrong)?;
    let path = PathBuf::from(file);
    if entry.is_empty() || file.is_empty() {
        return Err(wrong().into());
    }
    match std::fs::metadata(&path) {
        Ok(_) => Ok((entry.to_owned(), path)),
        Err(source) => Err(Error::File { path, source }),
    }
}

/// Returns the file that a user passed, or the first of these names beside the package's manifest.
fn beside(project: &Project, passed: &Option<PathBuf>, names: &[&str]) -> Option<PathBuf> {
    let own = names.iter().map(|name| project.package.folder.join(name));
    passed.clone().or_else(|| own.into_iter().find(|path| path.is_file()))
}

/// Returns the path of a file from the workspace; none if it is elsewhere.
fn within(root: &Path, path: &Path) -> Option<PathBuf> {
    let (root, path) = (root.canonicalize().ok()?, path.canonicalize().ok()?);
    path.strip_prefix(root).ok().map(Path::to_owned)
}

/// Returns a path from the workspace, or the name of a file that is elsewhere.
fn shown(root: &Path, path: &Path) -> String {
    let short = within(root, path).or_else(|| path.file_name().map(PathBuf::from));
    sources::relative(root, &short.unwrap_or_default())
}

fn requirements(path: &Path) -> Result<Vec<Requirement>, Error> {
    let bytes = std::fs::read(path);
    let bytes = bytes.map_err(|source| Error::File { path: path.to_owned(), source })?;
    let text = String::from_utf8_lossy(&bytes);
    let read = table::read(&text);
    read.map_err(|why| Wrong::Requirements { path: path.to_owned(), why }.into())
}

fn reasons(path: &Path) -> Result<Vec<reasons::Row>, Error> {
    let text = std::fs::read_to_string(path);
    let text = text.map_err(|source| Error::File { path: path.to_owned(), source })?;
    let read = reasons::read(&text);
    read.map_err(|why| Wrong::Reasons { path: path.to_owned(), why }.into())
}

/// An outcome of a check.
fn outcome(
    what: &str,
    command: &str,
    version: String,
    verdict: &'static str,
    detail: String,
) -> Outcome {
    Outcome { what: what.to_owned(), command: command.to_owned(), version, verdict, detail }
}

/// Returns the result of a thread; a panic goes on in this one.
fn joined<T>(thread: std::thread::ScopedJoinHandle<'_, T>) -> T {
    thread.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic))
}
