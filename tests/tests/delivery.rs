//! The folder of the C as its users meet it: written whole, compared, never trampled on.

use std::fs;
use std::process::Command;
use std::thread;

use bessemer_codegen::generate::{self, Error, Job};
use bessemer_frontend::diagnostic::Level;
use bessemer_tests::root;
use bessemer_tests::workspace::{Files, Workspace};

const MODEL: &str = "//! One law.
#![no_std]
use bessemer::prelude::*;

/// Twice the value.
#[function]
pub fn twice(x: f64) -> f64 {
    x + x
}
";

/// One test, since all of it is one package, built once.
#[test]
fn the_folder_is_whole_or_as_it_was() {
    let workspace = Workspace::with_source(MODEL).expect("a workspace");
    let mut job = Job::new(workspace.path(""), "models");
    let run = |job: &Job| generate::generate(job).map(|summary| summary.changed);
    let first = run(&job).expect("generated");
    assert_eq!(first.last().map(String::as_str), Some("manifest.json"), "{first:?}");
    assert!(run(&job).expect("generated again").is_empty(), "nothing to do");

    // Compared: nothing is written, the difference is shown.
    job.check = true;
    assert!(run(&job).is_ok());
    let source = job.output.join("models.c");
    let edited = fs::read_to_string(&source).expect("the C").replace("x + x", "x * 2.0");
    fs::write(&source, &edited).expect("an edit by hand");
    let Err(Error::Stale(difference)) = run(&job) else { panic!("the edit was not told") };
    assert!(difference.contains("-    return x * 2.0;"), "{difference}");
    assert!(difference.contains("+    return x + x;"), "{difference}");
    assert_eq!(fs::read_to_string(&source).expect("the C"), edited, "--check never writes");

    // Written again: the edit is gone.
    job.check = false;
    assert_eq!(run(&job).expect("generated"), ["models.c", "manifest.json"]);

    // A stranger's file stops it before anything changes.
    let notes = job.output.join("notes.txt");
    fs::write(&notes, "mine").expect("a file");
    assert!(matches!(run(&job), Err(Error::Foreign { file, .. }) if file == "notes.txt"));
    assert_eq!(fs::read_to_string(&notes).expect("still there"), "mine");
    fs::remove_file(&notes).expect("removed");

    // A model that does not compile leaves the folder as it was.
    let before = fs::read_to_string(&source).expect("the C");
    workspace.set_source(&MODEL.replace("x + x", "x + y")).expect("a source file");
    assert!(matches!(run(&job), Err(Error::Models(said)) if said.to_string().contains("`y`")));
    assert_eq!(fs::read_to_string(&source).expect("the C"), before);
    let left = fs::read_dir(workspace.path("")).expect("the workspace").flatten();
    let stages = left.filter(|entry| entry.file_name().to_string_lossy().starts_with(".bessemer"));
    assert_eq!(stages.count(), 0, "no half-written folder is left");
}

/// Checks a package that is older than the build of another workspace's package of its name, which cargo takes for up
/// to date. A package without marked items does not report its workspace.
#[test]
fn a_package_of_another_workspace_without_anything_marked_is_not_taken_for_ones_own() {
    let [own, other] = [MODEL, "//! Nothing.\n#![no_std]\n"]
        .map(|text| Workspace::with_source(text).expect("a workspace"));
    let nothing = other.generate_anew("1").expect_err("nothing is marked");
    assert!(matches!(nothing, Error::NoModels { .. }), "{nothing}");
    assert!(own.generate_anew("1").expect("generated").contains_key("models.c"));
}

/// Nor is a panic where the other's C is written told as one's own.
#[test]
fn a_panic_of_another_workspace_is_not_ones_own() {
    let limits = "
/// Limits.
#[component]
pub struct Limits {
    /// The least.
    pub least: u8,
}

impl Default for Limits {
    fn default() -> Limits {
        panic!(\"the other's\")
    }
}

#[component]
impl Limits {
    /// Returns true if a value is above the least.
    #[entry(infallible)]
    pub fn step(&mut self, value: u8) -> bool {
        value > self.least
    }
}
";
    let [own, other] = [MODEL.to_owned(), format!("{MODEL}{limits}")]
        .map(|text| Workspace::with_source(&text).expect("a workspace"));
    let Err(Error::Refused(said)) = other.generate_anew("1") else { panic!("it panics") };
    assert!(said.to_string().contains("the other's"), "{said}");
    assert!(own.generate_anew("1").expect("generated").contains_key("models.c"));
}

/// Checks that an author is reported why the only marked item becomes no C.
#[test]
fn a_package_of_which_nothing_becomes_c_says_why() {
    let path = root().join("tests/newcomers/generic_component_without_instance.rs");
    let text = fs::read_to_string(path).expect("a mistake");
    let workspace = Workspace::with_source(&text).expect("a workspace");
    let Err(Error::Refused(said)) = workspace.generate_anew("1") else {
        panic!("it becomes C");
    };
    let [told] = &said.diagnostics[..] else { panic!("{said}") };
    assert_eq!((told.level, told.line), (Level::Error, 6), "{said}");
    assert!(told.help.contains("pub type LagF32 = Lag<f32>;"), "{said}");
}

/// A library may have another name than its package: its modules' paths, by which the author's own functions are known, begin with that.
#[test]
fn a_library_of_another_name_than_its_package_becomes_the_same_c() {
    let workspace = Workspace::with_source(MODEL).expect("a workspace");
    let as_usual = workspace.generate_anew("1").expect("generated");
    let path = workspace.folder().join("Cargo.toml");
    let manifest = fs::read_to_string(&path).expect("a manifest");
    let renamed = manifest.replace("[lib]\n", "[lib]\nname = \"flight_software\"\n");
    assert_ne!(renamed, manifest);
    fs::write(&path, renamed).expect("a manifest");
    let text = |files: &Files, name: &str| files.get(name).map(|it| it.replace(name, "NAME"));
    fs::remove_dir_all(workspace.job().output).expect("the C of the package before");
    let other = workspace.generate_anew("1").expect("generated");
    let [usual, other] = [(&as_usual, "models.c"), (&other, "flight_software.c")]
        .map(|(files, name)| text(files, name).unwrap_or_else(|| panic!("{:?}", files.keys())));
    let same =
        |text: &str| text.replace("flight_software", "models").replace("FLIGHT_SOFTWARE", "MODELS");
    assert_eq!(same(&usual), same(&other));
}

/// Cargo builds the DSL once for all workspaces that link to it. What it was built by may be gone when the next one uses
/// it: taken for another's, it and all that uses it would be built anew.
#[test]
fn a_dsl_that_workspaces_link_to_is_built_once() {
    let source = root().join("dsl/src/lib.rs");
    let modified = || source.metadata().and_then(|it| it.modified()).expect("a time");
    let before = modified();
    for version in ["1", "2"] {
        let workspace = Workspace::with_source(MODEL).expect("a workspace");
        workspace.generate_anew(version).expect("generated");
    }
    assert_eq!(modified(), before, "it was taken for another workspace's");
}

#[test]
fn workspaces_that_share_a_target_folder_do_not_mix() {
    // Both are packages of one name: what one has built stands where the other looks for its own.
    thread::scope(|scope| {
        for constant in ["2.0", "3.0"] {
            scope.spawn(move || {
                let text = MODEL.replace("x + x", &format!("x * {constant}"));
                let workspace = Workspace::with_source(&text).expect("a workspace");
                for version in ["1", "2", "3", "4", "5"] {
                    let files = workspace.generate_anew(version).expect("generated");
                    assert!(files["models.c"].contains(&format!("x * {constant}")));
                }
            });
        }
    });
}

/// A program is linked with its own workspace's Rust, whoever built into the target folder since its sources were written.
#[test]
fn programs_run_their_own_workspaces_rust() {
    let both = ["2.0", "3.0"].map(|constant| {
        let text = MODEL.replace("x + x", &format!("x * {constant}"));
        Workspace::with_source(&text).expect("a workspace")
    });
    for (workspace, expected) in both.iter().zip(["4\n", "6\n"]) {
        let text = "fn main() { println!(\"{}\", models::twice(2.0)); }";
        let program =
            generate::native(&workspace.job(), text, false).expect("built").expect("linked");
        let output = Command::new(program.path()).output().expect("it runs");
        assert_eq!(String::from_utf8_lossy(&output.stdout), expected);
    }
}
