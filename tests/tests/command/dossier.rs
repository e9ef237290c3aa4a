//! The dossier as its users make and check it.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::Command;

use cargo_bessemer::args::{Arguments, Task};
use cargo_bessemer::dossier;
use clap::Parser as _;

type Done = Result<(String, bool), cargo_bessemer::error::Error>;

fn dossier_of(package: &Path, words: &[&str]) -> Done {
    let words = ["cargo", "bessemer", "dossier"].iter().chain(words);
    match Arguments::try_parse_from(words).expect("the words").task() {
        Task::Dossier(wanted) => dossier::run(package, &wanted, false),
        _ => unreachable!("the word `dossier`"),
    }
}

fn read(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let files = fs::read_dir(folder).expect("the dossier").flatten();
    let read = |path: &Path| fs::read(path).expect("a file");
    files.map(|it| (it.file_name().to_string_lossy().into_owned(), read(&it.path()))).collect()
}

/// It is whole, it is the same each time, and it is compared with the sources.
pub fn run(package: &Path) {
    let folder = package.join("dossier");
    let source = package.join("src/lib.rs");
    let sound = fs::read_to_string(&source).expect("the model");
    let test = package.join("tests/closed_loop.rs");
    let plain = fs::read_to_string(&test).expect("the test");
    let named = "#[test]\n#[bessemer::requirement(\"HLR-1\", \"HLR-9\")]";
    fs::write(&test, plain.replacen("#[test]", named, 1)).expect("the test");
    let list = package.join("requirements.csv");
    fs::write(&list, "id,text\nHLR-1,\"The motor settles, soon\"\n").expect("a list");
    let (text, good) =
        dossier_of(package, &["--fill", "2"]).unwrap_or_else(|error| panic!("{error}"));
    assert!(good, "{text}");
    for check in [
        "Tests of the package: ",
        "Rust, interpreter and C agree: ",
        "Coverage of the C: ",
        "Sanitizers of gcc: ",
    ] {
        assert!(text.contains(&format!("passed    {check}")), "{text}");
    }
    // These checks run if the emulator and Frama-C are installed.
    for line in text.lines().filter(|it| it.starts_with("passed    Longest paths on ")) {
        assert!(line.ends_with("none beyond its bound"), "{line}");
    }
    assert!(!text.lines().any(|it| it.contains("WP ends early")), "{text}");
    let page = fs::read_to_string(folder.join("index.html")).expect("the page");
    for part in ["motor_step", "id=\"questions\"", "MC/DC", "closed", "by --fill in 2 rounds"] {
        assert!(page.contains(part), "the page has no {part}");
    }
    requirements(package, &text, &page);
    fs::remove_file(&list).expect("the list");
    fs::write(&test, plain).expect("the test");
    in_a_browser(&folder, package);
    let here = package.to_string_lossy().into_owned();
    for (name, bytes) in read(&folder) {
        let text = String::from_utf8_lossy(&bytes).into_owned();
        assert!(!text.contains(&here), "{name} names a folder of this machine");
    }

    // The same bytes again, in another folder.
    dossier_of(package, &["--quick"]).unwrap_or_else(|error| panic!("{error}"));
    dossier_of(package, &["--quick", "--output", "again"])
        .unwrap_or_else(|error| panic!("{error}"));
    let again = package.join("again");
    assert_eq!(read(&folder), read(&again));
    fs::remove_dir_all(&again).expect("the second");

    let check = |folder: &Path| dossier_of(package, &["--check", &folder.to_string_lossy()]);
    let (text, same) = check(&folder).unwrap_or_else(|error| panic!("{error}"));
    assert!(same && text.starts_with("the dossier is of these sources: "), "{text}");
    fs::write(folder.join("index.html"), "").expect("a page");
    fs::write(&source, format!("{sound}\n// More.\n")).expect("the model");
    let (text, same) = check(&folder).unwrap_or_else(|error| panic!("{error}"));
    assert!(!same, "{text}");
    assert!(
        text.contains("source: `motor/src/lib.rs` was changed")
            || text.contains("source: `src/lib.rs` was changed"),
        "{text}"
    );
    assert!(text.contains("dossier: `index.html` was changed"), "{text}");
    fs::write(&source, &sound).expect("the model");

    // C that was edited: nothing is written.
    let c = package.join("generated/motor.c");
    let whole = fs::read_to_string(&c).expect("the C");
    fs::write(&c, format!("{whole}\n")).expect("the C");
    let error = dossier_of(package, &["--quick", "--output", "other"]).expect_err("edited C");
    assert!(error.to_string().ends_with("is stale: `motor.c` differs"), "{error}");
    assert!(!package.join("other").exists());
    fs::write(&c, whole).expect("the C");
    fs::remove_dir_all(&folder).expect("the dossier");
    since(package);
}

/// The list beside the manifest is found, the matrix leads both ways, and its exports are read again.
fn requirements(package: &Path, text: &str, page: &str) {
    let name = package.file_name().expect("a name").to_string_lossy().into_owned();
    let lines: Vec<&str> =
        text.lines().filter_map(|line| line.strip_prefix("requirements: ")).collect();
    assert_eq!(lines[0], format!("1 of `{name}/requirements.csv`; 1 no Rust"));
    assert!(lines[1].starts_with(&format!("`HLR-9` at {name}/tests/closed_loop.rs:")), "{text}");
    let back = page.split_once("Tests with their requirements").expect("the tests").1;
    let row = back.split_once("</tr>").and_then(|(_, it)| it.split_once("</tr>"));
    let row = row.expect("a row").0;
    for part in ["verdict passed", "#requirement-HLR-1\"", "#requirement-HLR-9\""] {
        assert!(row.contains(part), "{part}: {row}");
    }
    for file in ["requirements.csv", "requirements.reqif"] {
        let own = package.join("dossier").join(file);
        let path = own.to_string_lossy();
        dossier_of(package, &["--quick", "--requirements", &path, "--output", "again"])
            .unwrap_or_else(|error| panic!("{error}"));
        let again = package.join("again");
        for other in ["requirements.csv", "requirements.reqif"] {
            let read = |folder: &Path| fs::read_to_string(folder.join(other)).expect("a list");
            assert_eq!(read(&again), read(&package.join("dossier")), "{other} of {file}");
        }
        fs::remove_dir_all(again).expect("the second");
    }
}

/// Shows a line and a name with their counterparts in Chromium, if it is installed.
fn in_a_browser(folder: &Path, package: &Path) {
    let c = fs::read_to_string(package.join("generated/motor.c")).expect("the C");
    let line = c.lines().position(|it| it.contains("clamp_f64(")).expect("a statement") + 1;
    let shown = |place: &str| {
        let profile = tempfile::tempdir().expect("a folder");
        let mut command = Command::new("chromium");
        command.args(["--headless", "--no-sandbox", "--disable-gpu", "--dump-dom"]);
        command.arg(format!("--user-data-dir={}", profile.path().display()));
        command.arg(format!("file://{}#{place}", folder.join("trace.html").display()));
        let output = command.output().ok()?;
        Some(String::from_utf8_lossy(&output.stdout).into_owned())
    };
    let Some(page) = shown(&format!("motor.c:{line}:clamp_f64")) else { return };
    let rows = |class: &str| page.matches(&format!("class=\"{class}\"")).count();
    assert!(rows("on here") == 1 && rows("on") == 1, "one line on each side");
    let status = page.split_once("role=\"status\">").and_then(|(_, it)| it.split_once('<'));
    let status = status.expect("it says what is shown").0;
    assert!(status.starts_with(&format!("motor.c:{line}  ↔  ")), "{status}");
    assert!(status.ends_with("`clamp_f64` is `clamp` in the Rust"), "{status}");
    assert!(page.contains("<mark>clamp</mark>") && page.contains("<mark>clamp_f64</mark>"));
}

/// Changes since a version of a repository.
fn since(package: &Path) {
    let root = package.parent().expect("the workspace");
    let name = package.file_name().expect("a name").to_string_lossy().into_owned();
    let git = |words: &[&str]| {
        let mut git = Command::new("git");
        git.args(["-c", "user.name=a", "-c", "user.email=a@b"]).args(words).current_dir(root);
        assert!(git.output().expect("git").status.success(), "{words:?}");
    };
    git(&["init", "--quiet", "."]);
    git(&[
        "add",
        "--force",
        &format!("{name}/src"),
        &format!("{name}/generated"),
        &format!("{name}/bessemer.toml"),
    ]);
    git(&["commit", "--quiet", "--message", "a"]);
    git(&["tag", "v1"]);
    let words = ["--quick", "--since", "v1"];
    dossier_of(package, &words).unwrap_or_else(|error| panic!("{error}"));
    let page = fs::read_to_string(package.join("dossier/index.html")).expect("the page");
    assert!(page.contains("Since <code>v1</code>: 0 parts of the C changed"), "nothing changed");
    let error = dossier_of(package, &["--quick", "--since", "v9"]).expect_err("no such tag");
    assert_eq!(error.to_string(), "git knows no version `v9`: it is no tag, branch or commit");
    fs::remove_dir_all(package.join("dossier")).expect("the dossier");
    fs::remove_dir_all(root.join(".git")).expect("the repository");
}
