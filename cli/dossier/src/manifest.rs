//! `manifest.json` of a dossier: hashes of everything that it is made of and of everything in it.
//!
//! Invariants: the same sources give the same bytes; paths are relative to the workspace or to the dossier. Must not
//! know: what the files contain.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;

use serde_json::{Value, json};
use sha2::{Digest, Sha256};

/// Name of the manifest in the dossier.
pub const NAME: &str = "manifest.json";
/// Kind of the manifest, by which a dossier is recognised.
const KIND: &str = "bessemer-dossier";

/// Hashes of files by their path.
pub type Hashes = BTreeMap<String, String>;

/// Content of the manifest.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Manifest {
    /// Name of the package.
    pub package: String,
    /// Version of the tool.
    pub tool: String,
    /// Version of rustc.
    pub rustc: String,
    /// Path of the folder of the C from the workspace.
    pub c_folder: String,
    /// Sources: those of the package and those of other crates that become C, with the settings.
    pub sources: Hashes,
    /// Files of the C.
    pub c: Hashes,
    /// Files of the dossier, without this one.
    pub outputs: Hashes,
}

/// Reason why a text is no manifest of a dossier.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("this is no manifest of a dossier")]
pub struct NoManifest;

/// Returns the SHA-256 of bytes, in hexadecimal.
pub fn hash(bytes: &[u8]) -> String {
    let mut text = String::new();
    for byte in Sha256::digest(bytes) {
        // Writing to a string cannot fail.
        let _ = write!(text, "{byte:02x}");
    }
    text
}

impl Manifest {
    /// Returns the manifest as JSON.
    pub fn text(&self) -> String {
        let json = json!({
            "kind": KIND,
            "package": self.package,
            "tool": self.tool,
            "rustc": self.rustc,
            "c_folder": self.c_folder,
            "hash": "SHA-256",
            "sources": self.sources,
            "c": self.c,
            "outputs": self.outputs,
        });
        format!("{json:#}\n")
    }

    /// Reads a manifest.
    ///
    /// # Errors
    /// [`NoManifest`] if the text is none.
    pub fn read(text: &str) -> Result<Manifest, NoManifest> {
        let json: Value = serde_json::from_str(text).map_err(|_| NoManifest)?;
        let word = |key: &str| json[key].as_str().map(str::to_owned).ok_or(NoManifest);
        let hashes = |key: &str| {
            let map = json[key].as_object().ok_or(NoManifest)?;
            let one = |(path, hash): (&String, &Value)| {
                Ok((path.clone(), hash.as_str().ok_or(NoManifest)?.to_owned()))
            };
            map.iter().map(one).collect::<Result<Hashes, NoManifest>>()
        };
        if word("kind")? != KIND {
            return Err(NoManifest);
        }
        Ok(Manifest {
            package: word("package")?,
            tool: word("tool")?,
            rustc: word("rustc")?,
            c_folder: word("c_folder")?,
            sources: hashes("sources")?,
            c: hashes("c")?,
            outputs: hashes("outputs")?,
        })
    }

    /// Compares the manifest with the files of today: `outputs` are those of the dossier, the others of the workspace.
    pub fn compare(&self, today: &Manifest) -> Comparison {
        let mut found = Comparison::default();
        let parts = [
            ("source", &self.sources, &today.sources),
            ("C", &self.c, &today.c),
            ("dossier", &self.outputs, &today.outputs),
        ];
        for (what, before, now) in parts {
            for (path, hash) in before {
                match now.get(path) {
                    Some(other) if other == hash => found.equal += 1,
                    Some(_) => found.differ.push(format!("{what}: `{path}` was changed")),
                    None => found.differ.push(format!("{what}: `{path}` is missing")),
                }
            }
            for path in now.keys().filter(|path| !before.contains_key(*path)) {
                found.differ.push(format!("{what}: `{path}` is new"));
            }
        }
        for (what, before, now) in
            [("bessemer", &self.tool, &today.tool), ("rustc", &self.rustc, &today.rustc)]
        {
            if before != now {
                found.notes.push(format!("made by {what} {before}; here is {now}"));
            }
        }
        found
    }
}

/// Result of a comparison.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Comparison {
    /// Number of equal files.
    pub equal: usize,
    /// Differences.
    pub differ: Vec<String>,
    /// Differences of tools, which do not change what the dossier is of.
    pub notes: Vec<String>,
}

/// Adds the hashes of all files below a folder, by their paths from `root`, if `wanted`.
///
/// # Errors
/// The path and the system's reason for the first file or folder that cannot be read.
pub fn add_folder(
    root: &Path,
    folder: &Path,
    wanted: &dyn Fn(&Path) -> bool,
    hashes: &mut Hashes,
) -> Result<(), (std::path::PathBuf, std::io::Error)> {
    let list = std::fs::read_dir(folder).map_err(|error| (folder.to_owned(), error))?;
    for entry in list {
        let path = entry.map_err(|error| (folder.to_owned(), error))?.path();
        if !wanted(&path) {
            continue;
        }
        if path.is_dir() {
            add_folder(root, &path, wanted, hashes)?;
        } else {
            add_file(root, &path, hashes)?;
        }
    }
    Ok(())
}

/// Adds the hash of a file, by its path from `root`.
///
/// # Errors
/// The path and the system's reason if the file cannot be read.
pub fn add_file(
    root: &Path,
    path: &Path,
    hashes: &mut Hashes,
) -> Result<(), (std::path::PathBuf, std::io::Error)> {
    let bytes = std::fs::read(path).map_err(|error| (path.to_owned(), error))?;
    let name = path.strip_prefix(root).unwrap_or(path).to_string_lossy().replace('\\', "/");
    hashes.insert(name, hash(&bytes));
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn manifest() -> Manifest {
        let one = |name: &str| Hashes::from([(name.to_owned(), hash(name.as_bytes()))]);
        Manifest {
            package: "motor".to_owned(),
            tool: "0.1.0".to_owned(),
            rustc: "1.95.0".to_owned(),
            c_folder: "generated".to_owned(),
            sources: one("src/lib.rs"),
            c: one("motor.c"),
            outputs: one("index.html"),
        }
    }

    #[test]
    fn it_is_read_as_it_was_written() {
        let manifest = manifest();
        assert_eq!(Manifest::read(&manifest.text()), Ok(manifest));
        for text in ["", "{}", "[]", "{\"kind\": \"bessemer-dossier\"}"] {
            assert_eq!(Manifest::read(text), Err(NoManifest), "{text}");
        }
    }

    #[test]
    fn each_difference_is_named() {
        let before = manifest();
        let same = before.compare(&before);
        assert_eq!((same.equal, same.differ.len(), same.notes.len()), (3, 0, 0));
        let mut now = before.clone();
        now.sources.insert("src/lib.rs".to_owned(), hash(b"other"));
        now.c.clear();
        now.outputs.insert("more.html".to_owned(), hash(b""));
        now.rustc = "1.96.0".to_owned();
        let found = before.compare(&now);
        assert_eq!(
            found.differ,
            [
                "source: `src/lib.rs` was changed",
                "C: `motor.c` is missing",
                "dossier: `more.html` is new"
            ]
        );
        assert_eq!(found.notes, ["made by rustc 1.95.0; here is 1.96.0"]);
    }

    #[test]
    fn the_hash_is_sha_256() {
        assert!(hash(b"abc").starts_with("ba7816bf8f01cfea"));
    }
}
