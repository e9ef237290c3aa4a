//! Compares or replaces the output folder.
//!
//! A new folder is written beside the old one and renamed to it in one step; until then the old one is unchanged.
//! Unchanged files keep their time stamps. A run removes the staging folders of earlier runs that were killed.

use std::collections::BTreeMap;
use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use similar::TextDiff;

use super::error::Error;
use super::files::Files;
use super::manifest::{self, Manifest};

/// Compares the folder with the expected content.
pub(super) fn check(
    folder: &Path,
    files: &Files,
    manifest: &Manifest,
    colour: bool,
) -> Result<(), Error> {
    let present = read(folder)?;
    let mut difference = String::new();
    for (name, text) in &files.0 {
        diff(name, present.get(name), Some(text), colour, &mut difference);
    }
    for (name, text) in &present {
        if name != manifest::NAME && !files.0.contains_key(name) {
            diff(name, Some(text), None, colour, &mut difference);
        }
    }
    let earlier = present.get(manifest::NAME);
    if earlier.and_then(|earlier| manifest.date_if_same(earlier)).is_none() {
        let date = "the day of generation";
        diff(manifest::NAME, earlier, Some(&manifest.text(date)), colour, &mut difference);
    }
    if difference.is_empty() { Ok(()) } else { Err(Error::Stale(difference)) }
}

/// Returns the difference between a committed file and the text that it must have.
pub(super) fn difference(name: &str, old: &str, new: &str, colour: bool) -> String {
    let mut text = String::new();
    diff(name, Some(&old.to_owned()), Some(&new.to_owned()), colour, &mut text);
    text
}

fn diff(name: &str, old: Option<&String>, new: Option<&String>, colour: bool, out: &mut String) {
    let (before, after) = (old.map_or("", String::as_str), new.map_or("", String::as_str));
    if before == after && old.is_some() == new.is_some() {
        return;
    }
    let old_name = if old.is_some() { format!("committed/{name}") } else { "/dev/null".into() };
    let new_name = if new.is_some() { format!("generated/{name}") } else { "/dev/null".into() };
    let diff = TextDiff::from_lines(before, after);
    let text = diff.unified_diff().context_radius(2).header(&old_name, &new_name).to_string();
    if !colour {
        out.push_str(&text);
        return;
    }
    for line in text.lines() {
        let sgr = match line.as_bytes().first() {
            Some(b'+') => "\u{1b}[32m",
            Some(b'-') => "\u{1b}[31m",
            Some(b'@') => "\u{1b}[36m",
            _ => "",
        };
        out.push_str(sgr);
        out.push_str(line);
        out.push_str(if sgr.is_empty() { "\n" } else { "\u{1b}[0m\n" });
    }
}

/// Checks that the folder could be replaced by the C of `package`, judging by its contents, and that the staging folder
/// can be created.
pub(super) fn ready(folder: &Path, package: &str) -> Result<(), Error> {
    let folder = &followed(folder);
    let present = read(folder)?;
    refuse_foreign(folder, &present)?;
    refuse_other(folder, &present, package)?;
    let above = folder.ancestors().skip(1).find(|it| it.is_dir()).unwrap_or(Path::new("."));
    let tried = tempfile::Builder::new().prefix(&stages(folder)).tempdir_in(above);
    tried.map(drop).map_err(|source| Error::File { path: folder.clone(), source })
}

/// Returns the folder behind a symbolic link, which is replaced instead of the link.
fn followed(folder: &Path) -> PathBuf {
    folder.canonicalize().unwrap_or_else(|_| folder.to_owned())
}

/// Writes `files` and the manifest to the folder; returns the names of the changed files.
pub(super) fn write(
    folder: &Path,
    files: Files,
    manifest: &Manifest,
) -> Result<Vec<String>, Error> {
    let folder = &followed(folder);
    recover(folder)?;
    let present = read(folder)?;
    refuse_foreign(folder, &present)?;
    refuse_other(folder, &present, manifest.package())?;
    let mut changed: Vec<String> = files
        .0
        .iter()
        .filter(|(name, text)| present.get(*name) != Some(text))
        .map(|(name, _)| name.clone())
        .collect();
    let removed = present
        .keys()
        .filter(|name| name.as_str() != manifest::NAME && !files.0.contains_key(*name));
    changed.extend(removed.cloned());
    let earlier = present.get(manifest::NAME);
    if changed.is_empty() && earlier.is_some_and(|earlier| manifest.date_if_same(earlier).is_some())
    {
        return Ok(changed);
    }
    let today = time::OffsetDateTime::now_utc().date().to_string();
    let mut all = files.0;
    all.insert(manifest::NAME.to_owned(), manifest.text(&today));
    replace(folder, &all, &present)?;
    changed.push(manifest::NAME.to_owned());
    Ok(changed)
}

/// Reads the files of the folder, and of the folders in it that the manifest lists, by their relative names.
fn read(folder: &Path) -> Result<BTreeMap<String, String>, Error> {
    let mut files = BTreeMap::new();
    let failed = |path: &Path| {
        let path = path.to_owned();
        move |source| Error::File { path, source }
    };
    match fs::metadata(folder) {
        Ok(found) if found.is_dir() => {}
        Ok(_) => return Err(Error::NotAFolder { path: folder.to_owned() }),
        Err(error) if error.kind() == ErrorKind::NotFound && !folder.is_symlink() => {
            return Ok(files);
        }
        Err(error) if [ErrorKind::NotADirectory, ErrorKind::NotFound].contains(&error.kind()) => {
            return Err(Error::NotAFolder { path: folder.to_owned() });
        }
        Err(source) => return Err(failed(folder)(source)),
    }
    let ours = match fs::read(folder.join(manifest::NAME)) {
        Ok(bytes) => manifest::files_of(&String::from_utf8_lossy(&bytes)),
        Err(_) => Vec::new(),
    };
    let mut open = vec![String::new()];
    while let Some(within) = open.pop() {
        let inner = folder.join(&within);
        for entry in fs::read_dir(&inner).map_err(failed(&inner))? {
            let path = entry.map_err(failed(&inner))?.path();
            let last = path.file_name().unwrap_or_default().to_string_lossy();
            let name = format!("{within}{last}");
            if !path.is_dir() {
                let bytes = fs::read(&path).map_err(failed(&path))?;
                files.insert(name, String::from_utf8_lossy(&bytes).into_owned());
                continue;
            }
            let below = format!("{name}/");
            if !ours.iter().any(|file| file.starts_with(&below)) {
                return Err(Error::Foreign { folder: folder.to_owned(), file: name });
            }
            open.push(below);
        }
    }
    Ok(files)
}

/// Refuses a folder with files that the generator did not write, since they would be lost.
fn refuse_foreign(folder: &Path, present: &BTreeMap<String, String>) -> Result<(), Error> {
    let ours = present.get(manifest::NAME).map(|text| manifest::files_of(text)).unwrap_or_default();
    let foreign = present.keys().find(|name| *name != manifest::NAME && !ours.contains(name));
    match foreign {
        Some(file) => Err(Error::Foreign { folder: folder.to_owned(), file: file.clone() }),
        None => Ok(()),
    }
}

/// Refuses a folder with the C of another package, which would be lost.
fn refuse_other(
    folder: &Path,
    present: &BTreeMap<String, String>,
    package: &str,
) -> Result<(), Error> {
    let other = present.get(manifest::NAME).and_then(|text| manifest::package_of(text));
    match other.filter(|other| other != package) {
        Some(package) => Err(Error::Other { folder: folder.to_owned(), package }),
        None => Ok(()),
    }
}

/// Returns the prefix of the names of staging folders.
fn stages(folder: &Path) -> String {
    format!(".bessemer-{}-", folder.file_name().unwrap_or_default().to_string_lossy())
}

/// Returns the parent of `folder`.
fn parent(folder: &Path) -> PathBuf {
    folder.parent().map_or_else(|| PathBuf::from("."), Path::to_path_buf)
}

/// Removes the staging folders of killed runs. If a run was killed between its two renames, the old folder gets its
/// name back.
fn recover(folder: &Path) -> Result<(), Error> {
    let failed = |path: &Path| {
        let path = path.to_owned();
        move |source| Error::File { path, source }
    };
    let parent = parent(folder);
    for entry in fs::read_dir(&parent).into_iter().flatten().flatten() {
        let (stage, name) = (entry.path(), entry.file_name());
        if !name.to_string_lossy().starts_with(&stages(folder)) {
            continue;
        }
        let old = stage.join("old");
        if old.exists() && !folder.exists() {
            fs::rename(&old, folder).map_err(failed(folder))?;
        }
        fs::remove_dir_all(&stage).map_err(failed(&stage))?;
    }
    Ok(())
}

/// Writes the new folder beside the old one, then exchanges the two.
fn replace(
    folder: &Path,
    files: &BTreeMap<String, String>,
    present: &BTreeMap<String, String>,
) -> Result<(), Error> {
    let failed = |path: &Path| {
        let path = path.to_owned();
        move |source| Error::File { path: path.clone(), source }
    };
    let parent = parent(folder);
    fs::create_dir_all(&parent).map_err(failed(&parent))?;
    let stage = tempfile::Builder::new()
        .prefix(&stages(folder))
        .tempdir_in(&parent)
        .map_err(failed(&parent))?;
    let fresh = stage.path().join("new");
    fs::create_dir(&fresh).map_err(failed(&fresh))?;
    for (name, text) in files {
        let path = fresh.join(name);
        let within = path.parent().unwrap_or(&fresh);
        fs::create_dir_all(within).map_err(failed(within))?;
        let kept =
            present.get(name) == Some(text) && fs::hard_link(folder.join(name), &path).is_ok();
        if !kept {
            fs::write(&path, text).map_err(failed(&path))?;
        }
    }
    let old = stage.path().join("old");
    if folder.exists() {
        fs::rename(folder, &old).map_err(failed(folder))?;
    }
    if let Err(source) = fs::rename(&fresh, folder) {
        // Back to how it was; if that fails too, the stage stays, for the old folder is in it.
        if old.exists() && fs::rename(&old, folder).is_err() {
            let _ = stage.keep();
        }
        return Err(Error::File { path: folder.to_owned(), source });
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_folder_with_a_strangers_file_is_left_alone() {
        let present = BTreeMap::from([("notes.txt".to_owned(), String::new())]);
        let error = refuse_foreign(Path::new("out"), &present);
        assert!(matches!(error, Err(Error::Foreign { file, .. }) if file == "notes.txt"));
    }

    /// A killed run, before or between its two renames, is recovered.
    #[test]
    fn what_a_killed_run_left_is_taken_up() -> Result<(), Box<dyn std::error::Error>> {
        let dir = tempfile::tempdir()?;
        let folder = dir.path().join("generated");
        let old = dir.path().join(".bessemer-generated-abc/old");
        fs::create_dir_all(&old)?;
        fs::write(old.join("a.c"), "old")?;
        fs::create_dir_all(dir.path().join(".bessemer-generated-def/new"))?;
        fs::create_dir_all(dir.path().join(".bessemer-other-ghi/new"))?;
        recover(&folder)?;
        assert_eq!(read(&folder)?, BTreeMap::from([("a.c".to_owned(), "old".to_owned())]));
        assert_eq!(
            fs::read_dir(dir.path())?.count(),
            2,
            "another folder's stage is its own affair"
        );
        Ok(())
    }

    #[test]
    fn a_folder_that_cannot_be_replaced_stays_as_it_was() -> Result<(), Box<dyn std::error::Error>>
    {
        let dir = tempfile::tempdir()?;
        let folder = dir.path().join("generated");
        let old = BTreeMap::from([("a.c".to_owned(), "old".to_owned())]);
        replace(&folder, &old, &BTreeMap::new())?;
        // A name that no file can have: the new folder cannot be laid out.
        let bad = BTreeMap::from([
            ("a.c".to_owned(), "new".to_owned()),
            ("a.c/b.c".to_owned(), String::new()),
        ]);
        assert!(replace(&folder, &bad, &old).is_err());
        assert_eq!(read(&folder)?, old);
        assert_eq!(fs::read_dir(dir.path())?.count(), 1, "no stage is left behind");
        Ok(())
    }
}
