//! Selection of the package, and its user's settings for the C.

use std::path::{Path, PathBuf};

use bessemer_codegen::generate::{Job, Member, Workspace};
use bessemer_frontend::diagnostic;
use bessemer_frontend::source::Sources;
use toml::de::DeTable;

use crate::error::Error;
use crate::file;
use crate::settings::Settings;

/// The folder of the C where nobody says otherwise.
const OUTPUT: &str = "generated";

/// A package of models in its workspace.
#[derive(Clone, Debug)]
pub struct Project {
    /// The workspace.
    pub workspace: Workspace,
    /// The package.
    pub package: Member,
    /// The `bessemer.toml` that holds for it, if there is one.
    pub file: Option<PathBuf>,
    /// Settings in that `bessemer.toml`, or the defaults.
    pub settings: Settings,
}

impl Project {
    /// The package called `package`, or the one that a user in `folder` means.
    ///
    /// # Errors
    /// The workspace or package is not found, or its `bessemer.toml` is wrong.
    pub fn find(folder: &Path, package: Option<&str>, colour: bool) -> Result<Project, Error> {
        let workspace = Workspace::of(folder)?;
        let package = match package {
            Some(name) => workspace.member(name)?,
            None => meant(&workspace, folder)?,
        };
        let package = package.clone();
        let file = nearest(&workspace, &package);
        let settings = match &file {
            Some(path) => read(&workspace, path, colour)?,
            None => Settings::default(),
        };
        Ok(Project { workspace, package, file, settings })
    }

    /// The job for the generator.
    pub fn job(&self, colour: bool) -> Job {
        let mut job = Job::new(&self.workspace.root, &self.package.name);
        let folder = self.file.as_deref().and_then(Path::parent);
        job.output = match (&self.settings.output, folder) {
            (Some(output), Some(folder)) => folder.join(output),
            _ => self.workspace.root.join(OUTPUT),
        };
        job.options = self.settings.options.clone();
        job.license = self.settings.license.clone();
        job.colour = colour;
        job
    }

    /// Tells whether the release profile has overflow checks, so that optimised Rust panics where the C faults.
    pub fn checks_overflow(&self) -> bool {
        let text = std::fs::read_to_string(self.workspace.root.join("Cargo.toml"));
        let text = text.unwrap_or_default();
        let manifest = DeTable::parse(&text).ok().map(|manifest| manifest.into_inner());
        let profile = manifest.as_ref().and_then(|it| it.get("profile")?.get_ref().get("release"));
        let checks = profile.and_then(|it| it.get_ref().get("overflow-checks"));
        checks.and_then(|it| it.get_ref().as_bool()) == Some(true)
    }

    /// The name of `bessemer.toml` in diagnostics: its path from the workspace.
    pub fn file_name(&self) -> String {
        self.file.as_deref().map_or_else(String::new, |path| shown(&self.workspace, path))
    }
}

/// The package whose folder `folder` is in, if it is written in the DSL; else the only one that is. Of several, the only
/// one with settings is meant: the others are libraries that it calls.
fn meant<'w>(workspace: &'w Workspace, folder: &Path) -> Result<&'w Member, Error> {
    let here = folder.canonicalize().unwrap_or_else(|_| folder.to_owned());
    let within = |it: &&Member| {
        let own = it.folder.canonicalize().unwrap_or_else(|_| it.folder.clone());
        here.starts_with(own)
    };
    let models: Vec<&Member> = workspace.members.iter().filter(|it| it.models().is_ok()).collect();
    let around = models.iter().filter(|it| within(it));
    if let Some(package) = around.max_by_key(|it| it.folder.components().count()) {
        return Ok(package);
    }
    match models.as_slice() {
        [only] => Ok(only),
        [] => match workspace.members.as_slice() {
            // The only package there is: what it lacks says more.
            [only] => only.models().map(|_| only).map_err(Error::from),
            _ => Err(Error::NoModels { root: workspace.root.clone() }),
        },
        several => {
            let mut with_settings = several.iter().filter(|it| nearest(workspace, it).is_some());
            if let (Some(only), None) = (with_settings.next(), with_settings.next()) {
                return Ok(only);
            }
            let known = several.iter().map(|it| it.name.clone()).collect();
            Err(Error::WhichPackage { known })
        }
    }
}

/// The `bessemer.toml` beside the package's manifest, or the next above it within the workspace.
fn nearest(workspace: &Workspace, package: &Member) -> Option<PathBuf> {
    let within = |folder: &&Path| folder.starts_with(&workspace.root);
    let folders = package.folder.ancestors().take_while(within);
    folders.map(|folder| folder.join(file::NAME)).find(|path| path.exists())
}

fn shown(workspace: &Workspace, path: &Path) -> String {
    path.strip_prefix(&workspace.root).unwrap_or(path).display().to_string()
}

fn read(workspace: &Workspace, path: &Path, colour: bool) -> Result<Settings, Error> {
    let text = std::fs::read_to_string(path)
        .map_err(|source| Error::File { path: path.to_owned(), source })?;
    file::read(&shown(workspace, path), &text).map_err(|wrong| {
        Error::Settings(diagnostic::render(&wrong, &Sources::new(&workspace.root), colour))
    })
}
