//! `cargo bessemer new`: a package with a small model, its closed-loop test and a firmware stub.
//!
//! The files are those of `cli/templates/`, with the name in place of `motor`. A template has a model, a test and a stub of its own.

use std::fs;
use std::path::{Path, PathBuf};

use bessemer_backend::c::is_reserved;
use bessemer_codegen::generate::Workspace;

use crate::args::{New, Template};
use crate::error::Error;

/// Path in the package, and text.
const FILES: &[(&str, &str)] = &[
    ("Cargo.toml", include_str!("../templates/Cargo.toml.in")),
    ("bessemer.toml", include_str!("../templates/bessemer.toml")),
    ("README.md", include_str!("../templates/README.md")),
    (".gitignore", "/target\n/build\n"),
    ("firmware/CMakeLists.txt", include_str!("../templates/firmware/CMakeLists.txt")),
];

/// Returns the paths and texts of the model, of its closed-loop test and of the firmware's stub.
fn model(template: Option<Template>) -> [(&'static str, &'static str); 3] {
    let [model, test, stub] = match template {
        None => [
            include_str!("../templates/src/lib.rs.in"),
            include_str!("../templates/tests/closed_loop.rs.in"),
            include_str!("../templates/firmware/main.c"),
        ],
        Some(Template::Drive) => [
            include_str!("../templates/drive/lib.rs.in"),
            include_str!("../templates/drive/closed_loop.rs.in"),
            include_str!("../templates/drive/main.c"),
        ],
        Some(Template::Estimator) => [
            include_str!("../templates/estimator/lib.rs.in"),
            include_str!("../templates/estimator/closed_loop.rs.in"),
            include_str!("../templates/estimator/main.c"),
        ],
        Some(Template::Vehicle) => [
            include_str!("../templates/vehicle/lib.rs.in"),
            include_str!("../templates/vehicle/closed_loop.rs.in"),
            include_str!("../templates/vehicle/main.c"),
        ],
    };
    [("src/lib.rs", model), ("tests/closed_loop.rs", test), ("firmware/main.c", stub)]
}

/// Returns the paths and texts of the files that only this template has.
fn more(template: Option<Template>) -> &'static [(&'static str, &'static str)] {
    match template {
        Some(Template::Vehicle) => &[
            ("tests/vehicle/mod.rs", include_str!("../templates/vehicle/vehicle.rs.in")),
            ("examples/campaign.rs", include_str!("../templates/vehicle/campaign.rs.in")),
        ],
        _ => &[],
    }
}

/// The lines that a workspace needs in its own manifest.
const PROFILE: &str = "
# The C faults on overflow, so the Rust must, too, in every profile that simulates.
[profile.release]
overflow-checks = true
";

/// Names that Rust, cargo or the templates have taken.
const TAKEN: &[&str] = &[
    "abstract",
    "alloc",
    "as",
    "async",
    "await",
    "become",
    "bessemer",
    "box",
    "break",
    "build",
    "const",
    "continue",
    "core",
    "crate",
    "deps",
    "do",
    "dyn",
    "else",
    "enum",
    "examples",
    "extern",
    "false",
    "final",
    "fn",
    "for",
    "gen",
    "if",
    "impl",
    "in",
    "incremental",
    "let",
    "loop",
    "macro",
    "main",
    "match",
    "mod",
    "move",
    "mut",
    "nalgebra",
    "override",
    "priv",
    "proc_macro",
    "pub",
    "ref",
    "return",
    "self",
    "static",
    "std",
    "struct",
    "super",
    "test",
    "trait",
    "true",
    "try",
    "type",
    "typeof",
    "unsafe",
    "unsized",
    "use",
    "virtual",
    "where",
    "while",
    "yield",
    "gains",
];

/// Writes the package; what to do next.
///
/// # Errors
/// A name that is none, a folder that is there, and what the file system said: nothing is left then.
pub fn run(folder: &Path, wanted: &New) -> Result<String, Error> {
    let name = wanted.name.as_str();
    named(name)?;
    let package = folder.join(name);
    if package.symlink_metadata().is_ok() {
        return Err(Error::Exists { folder: package });
    }
    // Inside of a workspace, its manifest says what holds for all.
    let profile = if Workspace::of(folder).is_ok() { "" } else { PROFILE };
    let dependency = dependencies(folder, wanted)?;
    let all = FILES.iter().copied().chain(model(wanted.template));
    let all = all.chain(more(wanted.template).iter().copied());
    let written = all.into_iter().try_for_each(|(path, text)| {
        let path = package.join(path);
        let text = text.replace("@DEPENDENCY@", &dependency).replace("@PROFILE@", profile);
        write(&path, &renamed(&text, name)).map_err(|source| Error::File { path, source })
    });
    if let Err(error) = written {
        // What was begun here is ours alone.
        let _ = fs::remove_dir_all(&package);
        return Err(error);
    }
    let first = match Workspace::of(&package) {
        Ok(_) => String::new(),
        Err(_) => format!(
            "  Add \"{name}\" to `members` in the Cargo.toml of the workspace around it, or move the folder out of there.\n"
        ),
    };
    Ok(format!(
        "{name}/ is there. Next:\n{first}  cd {name}\n  cargo test             # simulates it\n  \
         cargo bessemer gen     # writes its C into generated/\n  \
         cargo bessemer verify  # compares Rust and C, to the bit\n"
    ))
}

fn write(path: &Path, text: &str) -> std::io::Result<()> {
    fs::create_dir_all(path.parent().unwrap_or(path))?;
    fs::write(path, text)
}

/// Checks that Rust and C can both use the name.
fn named(name: &str) -> Result<(), Error> {
    let wrong = |why| Err(Error::Name { name: name.to_owned(), why });
    let small = |it: char| it.is_ascii_lowercase() || it.is_ascii_digit() || it == '_' || it == '-';
    if !name.starts_with(|it: char| it.is_ascii_lowercase()) || !name.chars().all(small) {
        return wrong("it takes small letters, digits, `_` and `-`, and begins with a letter");
    }
    if name.ends_with(['_', '-']) || name.contains("--") || name.contains("__") {
        return wrong("each `_` and `-` stands between two words");
    }
    let word = name.replace('-', "_");
    if TAKEN.contains(&word.as_str()) {
        return wrong("Rust, cargo or the model itself has taken the name");
    }
    if is_reserved(&word) || is_reserved(&format!("{word}_t")) {
        return wrong("C or POSIX has taken the name");
    }
    Ok(())
}

/// The text of a template, with the name in place of `motor`, in each of its spellings.
fn renamed(text: &str, name: &str) -> String {
    let word = name.replace('-', "_");
    let camel: String = word
        .split('_')
        .flat_map(|part| {
            let mut letters = part.chars();
            letters.next().map(|it| it.to_ascii_uppercase()).into_iter().chain(letters)
        })
        .collect();
    text.replace("@PACKAGE@", name).replace("@NAME@", &word).replace("@Name@", &camel)
}

/// Returns the lines of the manifest that name the DSL and, for a template that simulates with it, `bessemer-sim`.
fn dependencies(folder: &Path, wanted: &New) -> Result<String, Error> {
    let source = source(folder, wanted)?;
    let line = |name: &str, part: &str, more: &str| match &source {
        Source::Git(url) => format!("{name} = {{ git = \"{url}\"{more} }}"),
        Source::Checkout(path) => {
            format!("{name} = {{ path = \"{}\"{more} }}", path.join(part).display())
        }
    };
    let mut lines = line("bessemer", "dsl", "");
    if wanted.template == Some(Template::Vehicle) {
        let simulation = line("bessemer-sim", "sim/kit", ", default-features = false");
        let campaign = line("bessemer-campaign", "sim/campaign", "");
        lines += &format!("\n\n[dev-dependencies]\n{campaign}\n{simulation}");
    }
    Ok(lines)
}

/// Place of Bessemer's packages.
enum Source {
    /// URL of a repository.
    Git(String),
    /// Folder, as the new package names it.
    Checkout(PathBuf),
}

/// Returns the place of the packages on which a new one depends.
fn source(folder: &Path, wanted: &New) -> Result<Source, Error> {
    let repository = env!("CARGO_PKG_REPOSITORY");
    if let Some(url) = &wanted.git {
        return Ok(Source::Git(url.clone()));
    }
    let checkout = match &wanted.path {
        Some(path) => folder.join(path),
        None if !repository.is_empty() => return Ok(Source::Git(repository.to_owned())),
        // Built from a checkout that nobody has published.
        None => PathBuf::from(env!("CARGO_MANIFEST_DIR")).join(".."),
    };
    if !checkout.join("dsl/Cargo.toml").is_file() {
        return Err(Error::NoCheckout { folder: checkout });
    }
    Ok(Source::Checkout(match wanted.path.as_deref().filter(|path| path.is_relative()) {
        // As the user wrote it, so that the two can be moved together.
        Some(path) => Path::new("..").join(path),
        None => between(&folder.join(&wanted.name), &checkout),
    }))
}

/// The relative path from a folder that need not exist yet to another. No manifest then names a folder of one machine.
fn between(from: &Path, to: &Path) -> PathBuf {
    let real = |path: &Path| path.canonicalize().unwrap_or_else(|_| path.to_owned());
    let parent =
        real(from.parent().filter(|it| !it.as_os_str().is_empty()).unwrap_or(".".as_ref()));
    let (from, to) = (parent.join(from.file_name().unwrap_or_default()), real(to));
    let common = from.components().zip(to.components()).take_while(|(a, b)| a == b).count();
    let up = from.components().skip(common).map(|_| Path::new("..").to_owned());
    up.chain(to.components().skip(common).map(|it| PathBuf::from(it.as_os_str()))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Accepted names of packages; `tests/refusals/settings.rs` has the rejected ones.
    #[test]
    fn names_that_mean_nothing_yet_are_taken() {
        for name in ["motor", "height_loop", "pid2", "a-b"] {
            assert!(named(name).is_ok(), "{name}");
        }
    }

    #[test]
    fn the_name_is_spelled_as_each_place_wants_it() {
        assert_eq!(
            renamed("@PACKAGE@ @NAME@ @Name@", "height-loop2"),
            "height-loop2 height_loop2 HeightLoop2"
        );
    }

    #[test]
    fn a_relative_checkout_stays_relative() {
        let folder = tempfile::tempdir().expect("a folder");
        let new = |path: &str| New {
            name: "m".to_owned(),
            template: None,
            path: Some(path.into()),
            git: None,
        };
        assert!(matches!(dependencies(folder.path(), &new("b")), Err(Error::NoCheckout { .. })));
        fs::create_dir_all(folder.path().join("b/dsl")).expect("a folder");
        fs::write(folder.path().join("b/dsl/Cargo.toml"), "").expect("a file");
        let line = dependencies(folder.path(), &new("b")).expect("it is there");
        assert_eq!(line, "bessemer = { path = \"../b/dsl\" }");

        let vehicle = New { template: Some(Template::Vehicle), ..new("b") };
        let lines = dependencies(folder.path(), &vehicle).expect("it is there");
        let simulation = "bessemer-sim = { path = \"../b/sim/kit\", default-features = false }";
        let campaign = "bessemer-campaign = { path = \"../b/sim/campaign\" }";
        assert_eq!(lines, format!("{line}\n\n[dev-dependencies]\n{campaign}\n{simulation}"));
    }

    #[test]
    fn a_checkout_of_this_machine_is_named_from_the_package_on() {
        let folder = tempfile::tempdir().expect("a folder");
        let (work, checkout) = (folder.path().join("work"), folder.path().join("b"));
        fs::create_dir_all(&work).expect("a folder");
        fs::create_dir_all(checkout.join("dsl")).expect("a folder");
        fs::write(checkout.join("dsl/Cargo.toml"), "").expect("a file");
        let new = New { name: "m".to_owned(), template: None, path: Some(checkout), git: None };
        let line = dependencies(&work, &new).expect("it is there");
        assert_eq!(line, "bessemer = { path = \"../../b/dsl\" }");
        assert_eq!(
            dependencies(folder.path(), &new).expect("it is there").replace("../b", ""),
            "bessemer = { path = \"/dsl\" }"
        );
    }

    #[test]
    fn what_is_there_stays() {
        let folder = tempfile::tempdir().expect("a folder");
        fs::write(folder.path().join("motor"), "mine").expect("a file");
        let wanted =
            New { name: "motor".to_owned(), template: None, path: None, git: Some("u".to_owned()) };
        assert!(matches!(run(folder.path(), &wanted), Err(Error::Exists { .. })));
        assert_eq!(fs::read_to_string(folder.path().join("motor")).expect("there"), "mine");
    }
}
