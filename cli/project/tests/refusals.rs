//! A user's mistakes that show before anything is built. Each is reported with a remedy.

use std::fs;
use std::path::Path;

use bessemer_project::{Project, Wanted, generate};
use tempfile::TempDir;

/// A file of the workspace: its path and its text; a folder where the path ends with `/`.
type File = (&'static str, &'static str);

struct Case {
    name: &'static str,
    files: &'static [File],
    /// Where the user is.
    folder: &'static str,
    package: Option<&'static str>,
    said: &'static str,
    remedy: &'static str,
}

/// A sound package, as far as it is looked at here; its library is never built.
const SOUND: &str = "[package]\nname = \"motor\"\nedition = \"2024\"\nlicense = \"MIT\"\n\
    [dependencies]\nbessemer = { path = \"dsl\" }\n";
const UNLICENSED: &str = "[package]\nname = \"motor\"\nedition = \"2024\"\n[dependencies]\nbessemer = { path = \"dsl\" }\n";
const DSL: File = ("dsl/Cargo.toml", "[package]\nname = \"bessemer\"\nedition = \"2024\"\n");
const DSL_LIB: File = ("dsl/src/lib.rs", "");
const LIB: File = ("src/lib.rs", "");

const PLAIN: Case = Case { name: "", files: &[], folder: "", package: None, said: "", remedy: "" };

const CASES: &[Case] = &[
    Case {
        name: "no workspace",
        said: "could not find `Cargo.toml`",
        remedy: "cargo bessemer new motor",
        ..PLAIN
    },
    Case {
        name: "a manifest that is no TOML",
        files: &[("Cargo.toml", "[package\n"), LIB],
        said: "unclosed table",
        ..PLAIN
    },
    Case {
        name: "a manifest without a target",
        files: &[("Cargo.toml", "[package]\nname = \"motor\"\nedition = \"2024\"\n")],
        said: "no targets specified",
        ..PLAIN
    },
    Case {
        name: "a package that is not there",
        files: &[("Cargo.toml", SOUND), LIB],
        package: Some("motr"),
        said: "the workspace has no package `motr`",
        remedy: "choose from motor",
        ..PLAIN
    },
    Case {
        name: "a program and no library",
        files: &[("Cargo.toml", SOUND), ("src/main.rs", "fn main() {}"), DSL, DSL_LIB],
        said: "the package `motor` has no library",
        remedy: "src/lib.rs",
        ..PLAIN
    },
    Case {
        name: "a library that Rust cannot link",
        files: &[
            (
                "Cargo.toml",
                "[package]\nname = \"motor\"\nedition = \"2024\"\n[lib]\ncrate-type = [\"staticlib\"]\n",
            ),
            LIB,
        ],
        said: "nothing can be linked with the library of `motor`",
        remedy: "\"rlib\"",
        ..PLAIN
    },
    Case {
        name: "a package without the DSL",
        files: &[("Cargo.toml", "[package]\nname = \"motor\"\nedition = \"2024\"\n"), LIB],
        said: "`motor` does not depend on `bessemer`",
        remedy: "`[dependencies]`",
        ..PLAIN
    },
    Case {
        name: "the DSL under another name",
        files: &[
            (
                "Cargo.toml",
                "[package]\nname = \"motor\"\nedition = \"2024\"\n[dependencies]\nb = { package = \"bessemer\", path = \"dsl\" }\n",
            ),
            LIB,
            DSL,
            DSL_LIB,
        ],
        said: "does not depend on `bessemer`",
        remedy: "by that name",
        ..PLAIN
    },
    Case {
        name: "the DSL for tests only",
        files: &[
            (
                "Cargo.toml",
                "[package]\nname = \"motor\"\nedition = \"2024\"\n[dev-dependencies]\nbessemer = { path = \"dsl\" }\n",
            ),
            LIB,
            DSL,
            DSL_LIB,
        ],
        said: "does not depend on `bessemer`",
        remedy: "`[dependencies]`",
        ..PLAIN
    },
    Case {
        name: "several packages, none of models",
        files: &[
            ("Cargo.toml", "[workspace]\nmembers = [\"a\", \"b\"]\n"),
            ("a/Cargo.toml", "[package]\nname = \"a\"\nedition = \"2024\"\n"),
            ("b/Cargo.toml", "[package]\nname = \"b\"\nedition = \"2024\"\n"),
            ("a/src/lib.rs", ""),
            ("b/src/lib.rs", ""),
        ],
        said: "no package of the workspace at",
        remedy: "cargo bessemer new",
        ..PLAIN
    },
    Case {
        name: "several packages of models",
        files: &[
            ("Cargo.toml", "[workspace]\nmembers = [\"a\", \"b\"]\n"),
            (
                "a/Cargo.toml",
                "[package]\nname = \"a\"\nedition = \"2024\"\n[dependencies]\nbessemer = { path = \"../dsl\" }\n",
            ),
            (
                "b/Cargo.toml",
                "[package]\nname = \"b\"\nedition = \"2024\"\n[dependencies]\nbessemer = { path = \"../dsl\" }\n",
            ),
            ("a/src/lib.rs", ""),
            ("b/src/lib.rs", ""),
            DSL,
            DSL_LIB,
        ],
        said: "several packages may have models: a, b",
        remedy: "--package a",
        ..PLAIN
    },
    Case {
        name: "no licence",
        files: &[("Cargo.toml", UNLICENSED), LIB, DSL, DSL_LIB],
        said: "names no licence",
        remedy: "`license = \"MIT OR Apache-2.0\"`",
        ..PLAIN
    },
    Case {
        name: "a key that there is not",
        files: &[("Cargo.toml", SOUND), LIB, ("bessemer.toml", "\nprefx = \"a\"\n"), DSL, DSL_LIB],
        said: " --> bessemer.toml:2:1",
        remedy: "write `prefix`",
        ..PLAIN
    },
    Case {
        name: "settings that are a folder",
        files: &[("Cargo.toml", SOUND), LIB, ("bessemer.toml/", ""), DSL, DSL_LIB],
        said: "bessemer.toml`: Is a directory",
        ..PLAIN
    },
    Case {
        name: "a file where the C should go",
        files: &[("Cargo.toml", SOUND), LIB, ("generated", "mine"), DSL, DSL_LIB],
        said: "generated` is a file, not a folder",
        remedy: "generate into another folder",
        ..PLAIN
    },
    Case {
        name: "a file above where the C should go",
        files: &[
            ("Cargo.toml", SOUND),
            LIB,
            ("bessemer.toml", "output = \"src/lib.rs/c\""),
            DSL,
            DSL_LIB,
        ],
        said: "is a file, not a folder",
        remedy: "generate into another folder",
        ..PLAIN
    },
    Case {
        name: "somebody's notes where the C should go",
        files: &[("Cargo.toml", SOUND), LIB, ("generated/notes.txt", "mine"), DSL, DSL_LIB],
        said: "holds `notes.txt`, which Bessemer did not write",
        remedy: "move it elsewhere",
        ..PLAIN
    },
    Case {
        name: "somebody's folder where the C should go",
        files: &[("Cargo.toml", SOUND), LIB, ("generated/inner/", ""), DSL, DSL_LIB],
        said: "holds `inner`, which Bessemer did not write",
        remedy: "move it elsewhere",
        ..PLAIN
    },
    Case {
        name: "sources where the C should go",
        files: &[("Cargo.toml", SOUND), LIB, ("bessemer.toml", "output = \"src\""), DSL, DSL_LIB],
        said: "holds `lib.rs`, which Bessemer did not write",
        remedy: "generate into another folder",
        ..PLAIN
    },
    Case {
        name: "another package's C",
        files: &[
            ("Cargo.toml", SOUND),
            LIB,
            ("generated/manifest.json", "{ \"package\": \"pump\", \"files\": [] }"),
            DSL,
            DSL_LIB,
        ],
        said: "generated` holds the C of the package `pump`",
        remedy: "`output = \"…\"`",
        ..PLAIN
    },
    Case {
        name: "a folder beside the workspace's packages",
        files: &[
            ("Cargo.toml", SOUND),
            LIB,
            ("bessemer.toml", "[limits]\nstack = 3\n"),
            DSL,
            DSL_LIB,
        ],
        folder: "src",
        said: " --> bessemer.toml:2:1",
        remedy: "write `limits.stack_bytes`",
        ..PLAIN
    },
];

fn laid_out(files: &[File]) -> TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    for (path, text) in files {
        let path = folder.path().join(path);
        let parent =
            if path.to_string_lossy().ends_with('/') { Some(&*path) } else { path.parent() };
        fs::create_dir_all(parent.expect("it is in the folder")).expect("a folder");
        if parent != Some(&*path) {
            fs::write(path, text).expect("a file");
        }
    }
    folder
}

fn tree(folder: &Path) -> Vec<String> {
    let mut names = Vec::new();
    for entry in fs::read_dir(folder).expect("a folder").flatten() {
        let name = entry.file_name().to_string_lossy().into_owned();
        if entry.path().is_dir() && name != "target" {
            names.extend(tree(&entry.path()).into_iter().map(|it| format!("{name}/{it}")));
        }
        if !matches!(name.as_str(), "target" | "Cargo.lock") {
            names.push(name);
        }
    }
    names.sort();
    names
}

#[test]
fn each_is_told_with_what_to_do() {
    for case in CASES {
        let workspace = laid_out(case.files);
        let before = tree(workspace.path());
        let wanted = Wanted { package: case.package, ..Wanted::default() };
        let error = generate(&workspace.path().join(case.folder), wanted).expect_err(case.name);
        let text = anstream::adapter::strip_str(&error.text()).to_string();
        assert!(text.contains(case.said), "{}: {text}", case.name);
        assert!(text.contains(case.remedy), "{}: {text}", case.name);
        assert!(text.contains("error: "), "{}: {text}", case.name);
        assert!(!text.contains("\\n") && !text.contains("Error::"), "{}: {text}", case.name);
        assert_eq!(tree(workspace.path()), before, "{}: something was written", case.name);
    }
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
}
