//! Stores objects by their inputs, so that no C is compiled twice in the same way.
//!
//! The key of an object consists of everything on which it depends: the compiler's version, the flags, the text of
//! the source, and the texts of the included files of its folder. So kernels, helpers and the files of unchanged
//! programs come from an earlier run or another test.
//!
//! Invariant: an object is stored only if its compiler gave no warnings.
//!
//! What it must not know: the purpose of the C.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Debug;
use std::hash::Hash;
use std::path::{Path, PathBuf};

use crate::store;

/// Returns the path of the stored object for this content; none if nothing is to be stored.
///
/// `flags` are those of the command that makes it; `source` is the file that it compiles.
pub fn place(compiler: &str, flags: &[String], source: &Path) -> Option<PathBuf> {
    store::place("objects", &content(compiler, flags, source)?)
}

/// Returns everything on which an object depends.
fn content(
    compiler: &str,
    flags: &[String],
    source: &Path,
) -> Option<impl Hash + PartialEq + Debug + use<>> {
    Some((store::version(compiler)?, compiler.to_owned(), flags.to_vec(), texts(source)?))
}

/// Returns the name and the text of the source and of each file that it includes from its folder.
fn texts(source: &Path) -> Option<BTreeMap<String, String>> {
    let folder = source.parent()?;
    let mut texts = BTreeMap::new();
    let mut open = BTreeSet::from([source.file_name()?.to_str()?.to_owned()]);
    while let Some(name) = open.pop_first() {
        // A header of the system's is part of the compiler.
        let Ok(text) = std::fs::read_to_string(folder.join(&name)) else { continue };
        let included =
            text.lines().filter_map(|line| line.trim_start().strip_prefix("#include \""));
        let included = included.filter_map(|rest| rest.split_once('"').map(|(name, _)| name));
        open.extend(included.filter(|name| !texts.contains_key(*name)).map(str::to_owned));
        texts.insert(name, text);
    }
    Some(texts)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_object_moves_with_all_that_decides_it() -> std::io::Result<()> {
        let folder = tempfile::tempdir()?;
        let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text);
        write("a.c", "#include \"a.h\"\nint a;\n")?;
        write("a.h", "#include \"b.h\"\n")?;
        write("b.h", "#include <math.h>\nint b;\n")?;
        write("c.h", "int c;\n")?;
        let source = folder.path().join("a.c");
        let of = |flags: &[&str]| {
            let flags: Vec<String> = flags.iter().map(|flag| (*flag).to_owned()).collect();
            content("gcc", &flags, &source)
        };
        let first = of(&["-O2"]);
        assert!(first.is_some());
        assert_eq!(first, of(&["-O2"]));
        assert_ne!(first, of(&["-O3"]));
        write("c.h", "int other;\n")?;
        assert_eq!(first, of(&["-O2"]), "nobody includes it");
        write("b.h", "int other;\n")?;
        assert_ne!(first, of(&["-O2"]), "a file that is included by an included one");
        assert_eq!(content("no-such-compiler", &[], &source), None);
        Ok(())
    }
}
