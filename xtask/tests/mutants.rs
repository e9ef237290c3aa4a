//! The mutants do not rot: each patch still applies, and says what `cargo xtask mutate` needs. Whether a test finds it is for
//! that command to see.

use xtask::mutate::mutant::{Mutant, git_apply};

#[test]
fn every_patch_applies() {
    let root = xtask::project::root();
    let mutants = Mutant::all(&root).unwrap_or_else(|error| panic!("{error}"));
    assert!(!mutants.is_empty(), "no mutant was found");
    let mut offences = Vec::new();
    for mutant in &mutants {
        let output = git_apply(&root, &mutant.patch).arg("--check").output().expect("git runs");
        if !output.status.success() {
            let said = String::from_utf8_lossy(&output.stderr).into_owned();
            offences.push(format!("{}: {}", mutant.name, said.trim()));
        }
        if mutant.packages(&root).is_empty() {
            offences.push(format!("{}: it changes no package", mutant.name));
        }
    }
    assert!(
        offences.is_empty(),
        "make these patches anew, from the code as it is now:\n  {}\n",
        offences.join("\n  ")
    );
}

#[test]
fn every_file_is_a_mutant() {
    let folder = xtask::project::root().join(xtask::mutate::mutant::FOLDER);
    for entry in std::fs::read_dir(folder).expect("the folder of the mutants").flatten() {
        let path = entry.path();
        let named = path.extension().is_some_and(|ending| ending == "patch");
        assert!(named, "{} is no patch: name it `<area>_<what>.patch`", path.display());
    }
}
