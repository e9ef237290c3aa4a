//! Selection of the package and its `bessemer.toml` from a user's current folder.

use std::fs;

use bessemer_project::Project;
use tempfile::TempDir;

/// A file of the workspace: its path and its text.
type File = (&'static str, &'static str);

const DSL: File = ("dsl/Cargo.toml", "[package]\nname = \"bessemer\"\nedition = \"2024\"\n");
const DSL_LIB: File = ("dsl/src/lib.rs", "");

fn laid_out(files: &[File]) -> TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    for (path, text) in files {
        let path = folder.path().join(path);
        fs::create_dir_all(path.parent().expect("it is in the folder")).expect("a folder");
        fs::write(path, text).expect("a file");
    }
    folder
}

/// From each folder the package around it; what holds for it is the nearest `bessemer.toml`.
#[test]
fn a_workspace_of_several_packages_is_found_its_way_in() {
    const MODELS: &str = "[package]\nname = \"a\"\nedition = \"2024\"\nlicense = \"MIT\"\n[dependencies]\nbessemer = { path = \"../dsl\" }\n";
    const OTHER: &str = "[package]\nname = \"b\"\nedition = \"2024\"\nlicense = \"MIT\"\n[dependencies]\nbessemer = { path = \"../dsl\" }\n";
    let workspace = laid_out(&[
        (
            "Cargo.toml",
            "[workspace]\nmembers = [\"a\", \"b\", \"c\"]\n[profile.release]\noverflow-checks = true\n",
        ),
        ("a/Cargo.toml", MODELS),
        ("b/Cargo.toml", OTHER),
        ("c/Cargo.toml", "[package]\nname = \"c\"\nedition = \"2024\"\n"),
        ("a/src/lib.rs", ""),
        ("a/src/deep/er.rs", ""),
        ("b/src/lib.rs", ""),
        ("c/src/lib.rs", ""),
        ("bessemer.toml", "output = \"out\"\nprefix = \"all_\"\n"),
        ("b/bessemer.toml", "prefix = \"b_\"\n"),
        DSL,
        DSL_LIB,
    ]);
    let root = workspace.path().canonicalize().expect("it is there");
    let find = |folder: &str, package| Project::find(&root.join(folder), package, false);
    let a = find("a/src/deep", None).expect("it is within a");
    assert_eq!((a.package.name.as_str(), a.settings.options.prefix.as_str()), ("a", "all_"));
    assert_eq!(a.job(false).output, root.join("out"));
    assert!(a.checks_overflow());
    let b = find("c", Some("b")).expect("it is asked for");
    assert_eq!((b.package.name.as_str(), b.settings.options.prefix.as_str()), ("b", "b_"));
    assert_eq!(b.job(false).output, root.join("generated"));
    assert_eq!(b.file_name(), "b/bessemer.toml");
    assert!(find("c", None).is_err(), "either may be meant");
    std::fs::remove_file(root.join("bessemer.toml")).expect("the settings of both");
    assert_eq!(find("c", None).expect("one has settings").package.name, "b");
}
