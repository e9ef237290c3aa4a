//! `cargo bessemer where`: the Rust of a line of C, and the C of a line of Rust.

use std::path::{Path, PathBuf};

use bessemer_codegen::generate::Workspace as Packages;
use bessemer_dossier::manifest;
use bessemer_dossier::trace::{self, Folder, Line, Workspace};
use bessemer_project::Project;

use crate::args::Where;
use crate::error::Error;

/// Returns the counterpart of a line, with the text of both.
///
/// # Errors
/// The package is not found, its C is not generated, or the line has no counterpart.
pub fn run(folder: &Path, wanted: &Where, colour: bool) -> Result<String, Error> {
    let line = Line::of(&wanted.line)?;
    let (root, output) = match (wanted.package.name(), generated(&folder.join(&line.file))) {
        // The maps beside the file say all, whichever package they are of.
        (None, Some(output)) => {
            let packages = Packages::of(folder).map_err(bessemer_project::Error::from)?;
            (packages.root, output)
        }
        (name, _) => {
            let project = Project::find(folder, name, colour)?;
            let output = project.job(colour).output;
            (project.workspace.root, output)
        }
    };
    let c = Folder::read(&output)?;
    Ok(trace::described(&c, &Workspace(&root), &line)?)
}

/// Returns the folder of generated C that a file is in; none if it has no map beside it.
fn generated(file: &Path) -> Option<PathBuf> {
    let mut map = file.as_os_str().to_owned();
    map.push(".map");
    let parent = file.parent().filter(|_| Path::new(&map).is_file())?;
    let has_manifest = |it: &&Path| it.join(manifest::NAME).is_file();
    Some(parent.ancestors().find(has_manifest).unwrap_or(parent).to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_folder_of_a_generated_file_has_its_manifest() {
        let folder = tempfile::tempdir().expect("a folder");
        let below = folder.path().join("acme");
        std::fs::create_dir(&below).expect("a folder");
        for name in ["manifest.json", "a.c", "acme/b.h", "acme/b.h.map"] {
            std::fs::write(folder.path().join(name), "").expect("a file");
        }
        assert_eq!(generated(&below.join("b.h")), Some(folder.path().to_owned()));
        assert_eq!(generated(&folder.path().join("a.c")), None);
    }
}
