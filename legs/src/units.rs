//! Groups emitted C into fewer translation units, since a compiler that starts for every small file spends most of
//! its time on headers.
//!
//! A unit includes several files. Files are grouped only if none of them has a private name that another one uses.
//! Kernels have macros and attributes of their own, so they are not grouped.
//!
//! A leg that does not use this tests that each file compiles separately.

use std::collections::BTreeSet;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

/// Largest number of files in a unit: more save nothing, and a single processor would have to compile them all.
const MOST: usize = 40;

/// Files of a unit, the words in them, and the names that are private to one of them.
#[derive(Default)]
struct Unit {
    files: Vec<PathBuf>,
    words: BTreeSet<String>,
    own: BTreeSet<String>,
}

/// Writes units that include these sources to the folder; returns the sources to be compiled instead.
///
/// # Errors
///
/// An error of the file system.
pub fn write(folder: &Path, sources: &[PathBuf]) -> std::io::Result<Vec<PathBuf>> {
    let (mut units, mut all): (Vec<Unit>, _) = (Vec::new(), Vec::new());
    for source in sources {
        let text = std::fs::read_to_string(source)?;
        if stands_alone(&text) {
            all.push(source.clone());
            continue;
        }
        let (words, own) = (words(&text), own(&text));
        let takes = |unit: &&mut Unit| {
            unit.files.len() < MOST && unit.own.is_disjoint(&words) && unit.words.is_disjoint(&own)
        };
        let unit = match units.iter_mut().find(takes) {
            Some(unit) => unit,
            None => {
                units.push(Unit::default());
                units.last_mut().expect("just pushed")
            }
        };
        unit.files.push(source.clone());
        unit.words.extend(words);
        unit.own.extend(own);
    }
    for (index, unit) in units.iter().enumerate() {
        let mut text = String::new();
        for file in unit.files.iter().filter_map(|file| file.file_name()) {
            let _ = writeln!(text, "#include \"{}\"", file.to_string_lossy());
        }
        let path = folder.join(format!("harness_unit_{index}.c"));
        std::fs::write(&path, text)?;
        all.push(path);
    }
    Ok(all)
}

/// Returns true if a file defines nothing that affects the files after it.
fn stands_alone(text: &str) -> bool {
    ["#define", "__attribute__", "\ntypedef"].iter().any(|it| text.contains(it))
}

fn words(text: &str) -> BTreeSet<String> {
    let letter = |it: char| it == '_' || it.is_ascii_alphanumeric();
    text.split(|it| !letter(it)).filter(|word| !word.is_empty()).map(str::to_owned).collect()
}

/// Returns the names that are private to a file: each is the last word before the parameters, the dimensions or the
/// value.
fn own(text: &str) -> BTreeSet<String> {
    let name = |line: &str| {
        let head = line.split(['(', '[', '=', ';']).next().unwrap_or_default();
        head.split_whitespace().next_back().map(|word| word.trim_start_matches('*').to_owned())
    };
    text.lines().filter(|line| line.starts_with("static ")).filter_map(name).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_one_file_keep_others_away() -> std::io::Result<()> {
        let folder = tempfile::tempdir()?;
        let texts = [
            "static double level(double x)\n{\n    return x;\n}\n",
            "double of(const it_t *it)\n{\n    return it->level;\n}\n",
            "static const double level[2] = {1.0, 2.0};\n",
            "double other(double x)\n{\n    return x;\n}\n",
            "#define LANES 2U\n",
        ];
        let mut sources = Vec::new();
        for (index, text) in texts.iter().enumerate() {
            let path = folder.path().join(format!("f{index}.c"));
            std::fs::write(&path, text)?;
            sources.push(path);
        }
        let found = write(folder.path(), &sources)?;
        let text = |index: usize| std::fs::read_to_string(&found[index]);
        assert_eq!(found[0], sources[4]);
        assert_eq!(text(1)?, "#include \"f0.c\"\n#include \"f3.c\"\n");
        assert_eq!(text(2)?, "#include \"f1.c\"\n");
        assert_eq!(text(3)?, "#include \"f2.c\"\n");
        Ok(())
    }
}
