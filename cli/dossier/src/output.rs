//! Writes the folder of a dossier, whole or not at all.
//!
//! The files are written beside the folder, and renamed to it in one step. A folder that is no dossier is never
//! replaced.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use crate::manifest::{self, Manifest};

/// Reason why a folder could not be written or read.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The folder has files that no dossier has.
    #[error("`{folder}` has `{file}`, which no dossier wrote")]
    Foreign {
        /// The folder.
        folder: PathBuf,
        /// A file in it.
        file: String,
    },
    /// The folder is no dossier.
    #[error("`{folder}` is no dossier: it has no `manifest.json` of one")]
    NoDossier {
        /// The folder.
        folder: PathBuf,
    },
    /// A file or folder could not be read or written.
    #[error("`{path}`: {source}")]
    File {
        /// The file or folder.
        path: PathBuf,
        /// The system's reason.
        source: std::io::Error,
    },
}

impl Error {
    /// Returns a step that resolves the error.
    pub fn remedy(&self) -> Option<String> {
        match self {
            Error::Foreign { .. } => {
                Some("choose another folder with `--output`, or move that file".to_owned())
            }
            Error::NoDossier { .. } => {
                Some("name the folder that `cargo bessemer dossier` wrote".to_owned())
            }
            Error::File { .. } => None,
        }
    }
}

fn failed(path: &Path) -> impl FnOnce(std::io::Error) -> Error + use<> {
    let path = path.to_owned();
    move |source| Error::File { path, source }
}

/// Reads the manifest of a dossier.
///
/// # Errors
/// [`Error::NoDossier`] if the folder is none.
pub fn manifest(folder: &Path) -> Result<Manifest, Error> {
    let text = std::fs::read(folder.join(manifest::NAME));
    let text = text.map(|bytes| String::from_utf8_lossy(&bytes).into_owned());
    text.ok()
        .and_then(|text| Manifest::read(&text).ok())
        .ok_or_else(|| Error::NoDossier { folder: folder.to_owned() })
}

/// Checks before long work that a dossier may be written to the folder.
///
/// # Errors
/// [`Error::Foreign`] or [`Error::File`].
pub fn ready(folder: &Path) -> Result<(), Error> {
    let list = match std::fs::read_dir(folder) {
        Ok(list) => list,
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => return Ok(()),
        Err(source) => return Err(Error::File { path: folder.to_owned(), source }),
    };
    let own = manifest(folder).map(|it| it.outputs).unwrap_or_default();
    for entry in list {
        let entry = entry.map_err(failed(folder))?;
        let file = entry.file_name().to_string_lossy().into_owned();
        if file != manifest::NAME && !own.contains_key(&file) {
            return Err(Error::Foreign { folder: folder.to_owned(), file });
        }
    }
    match folder.join(manifest::NAME).exists() && own.is_empty() {
        true => Err(Error::Foreign { folder: folder.to_owned(), file: manifest::NAME.to_owned() }),
        false => Ok(()),
    }
}

/// Writes the files of a dossier to the folder, in place of an earlier dossier.
///
/// # Errors
/// [`Error::Foreign`] or [`Error::File`]; the folder is then as it was.
pub fn write(folder: &Path, files: &BTreeMap<String, String>) -> Result<(), Error> {
    ready(folder)?;
    let parent = match folder.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent.to_owned(),
        _ => PathBuf::from("."),
    };
    std::fs::create_dir_all(&parent).map_err(failed(&parent))?;
    let stage = tempfile::Builder::new()
        .prefix(".bessemer-dossier-")
        .tempdir_in(&parent)
        .map_err(failed(&parent))?;
    let (fresh, old) = (stage.path().join("new"), stage.path().join("old"));
    std::fs::create_dir(&fresh).map_err(failed(&fresh))?;
    for (name, text) in files {
        let path = fresh.join(name);
        std::fs::write(&path, text).map_err(failed(&path))?;
    }
    if folder.exists() {
        std::fs::rename(folder, &old).map_err(failed(folder))?;
    }
    if let Err(source) = std::fs::rename(&fresh, folder) {
        if old.exists() && std::fs::rename(&old, folder).is_err() {
            // The earlier dossier is still in the stage.
            let _ = stage.keep();
        }
        return Err(Error::File { path: folder.to_owned(), source });
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::manifest::Hashes;

    fn dossier(texts: &[(&str, &str)]) -> BTreeMap<String, String> {
        let mut files: BTreeMap<String, String> =
            texts.iter().map(|(name, text)| ((*name).to_owned(), (*text).to_owned())).collect();
        let outputs: Hashes = files
            .iter()
            .map(|(name, text)| (name.clone(), manifest::hash(text.as_bytes())))
            .collect();
        let manifest = Manifest { outputs, ..Manifest::default() };
        files.insert(manifest::NAME.to_owned(), manifest.text());
        files
    }

    #[test]
    fn a_dossier_is_replaced_as_a_whole() {
        let place = tempfile::tempdir().expect("a folder");
        let folder = place.path().join("a/dossier");
        write(&folder, &dossier(&[("index.html", "1"), ("old.html", "1")])).expect("it is new");
        write(&folder, &dossier(&[("index.html", "2")])).expect("it is a dossier");
        assert_eq!(std::fs::read_to_string(folder.join("index.html")).expect("it"), "2");
        assert!(!folder.join("old.html").exists());
        assert_eq!(std::fs::read_dir(place.path().join("a")).expect("it").count(), 1);
    }

    #[test]
    fn a_folder_of_other_files_is_left_alone() {
        let place = tempfile::tempdir().expect("a folder");
        let folder = place.path();
        for (name, text) in [("notes.txt", "mine"), ("manifest.json", "{}")] {
            std::fs::write(folder.join(name), text).expect("a file");
            let error = write(folder, &dossier(&[("index.html", "1")]));
            assert!(matches!(error, Err(Error::Foreign { .. })), "{name}");
            assert!(!folder.join("index.html").exists());
            std::fs::remove_file(folder.join(name)).expect("it is there");
        }
        assert!(matches!(manifest(folder), Err(Error::NoDossier { .. })));
    }

    #[test]
    fn a_file_in_the_way_is_reported() {
        let place = tempfile::tempdir().expect("a folder");
        let folder = place.path().join("dossier");
        std::fs::write(&folder, "").expect("a file");
        assert!(matches!(write(&folder, &dossier(&[])), Err(Error::File { .. })));
    }
}
