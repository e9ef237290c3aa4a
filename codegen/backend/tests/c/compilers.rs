//! The compilers at hand, with every warning that the emitted C must not raise.

use std::path::{Path, PathBuf};
use std::process::Command;

use bessemer_backend::c::{CFile, FLAGS};
use bessemer_store::once;

const COMPILERS: &[&str] = &["gcc", "clang", "arm-linux-gnueabihf-gcc"];

/// Some of the ways to compile, others at each turn: the commit's number chooses, as it does in the tests across the
/// crates (`BESSEMER_TURN`). All of them in a full run.
pub fn by_turn<T: Copy>(ways: &[T], count: usize, shift: usize) -> Vec<T> {
    if std::env::var_os("BESSEMER_FULL").is_some() {
        return ways.to_vec();
    }
    let turn = std::env::var("BESSEMER_TURN").ok().and_then(|turn| turn.parse::<usize>().ok());
    let first = (turn.unwrap_or_default() + shift) * count;
    (0..count).map(|index| ways[(first + index) % ways.len()]).collect()
}

/// Returns true if a program is installed.
pub fn is_there(program: &str) -> bool {
    Command::new(program).arg("--version").output().is_ok_and(|output| output.status.success())
}

/// Writes files into a folder of their own.
pub fn folder(name: &str, files: &[CFile]) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).expect("the target folder is writable");
    for file in files {
        let path = folder.join(&file.name);
        std::fs::create_dir_all(path.parent().unwrap_or(&folder)).expect("it is writable");
        std::fs::write(path, &file.text).expect("the target folder is writable");
    }
    folder
}

/// Compiles every source with every compiler, at a turn's levels, and every header as C and as C++.
pub fn check(name: &str, files: &[CFile]) {
    once(name, &texts(files), || compile_each(name, files));
}

/// Returns the names and texts of the files, on which a check of the C depends.
pub fn texts(files: &[CFile]) -> Vec<(&str, &str)> {
    files.iter().map(|file| (file.name.as_str(), file.text.as_str())).collect()
}

fn compile_each(name: &str, files: &[CFile]) {
    let folder = folder(&format!("check-{name}"), files);
    let sources: Vec<&str> =
        files.iter().map(|file| file.name.as_str()).filter(|name| name.ends_with(".c")).collect();
    let twice = alone(&folder, files, ".c", 2);
    let once = alone(&folder, files, ".cpp", 1);
    let there = COMPILERS.iter().enumerate().filter(|(_, compiler)| is_there(compiler));
    for (index, compiler) in there {
        // Another level of each, so that a run has the least and the most optimised.
        let levels = by_turn(&["-O0", "-O1", "-O2", "-O3"], 1, index);
        for level in levels {
            run(Command::new(compiler).args(FLAGS).args([level, "-c"]).args(&sources), &folder);
        }
        run(Command::new(compiler).args(FLAGS).arg("-fsyntax-only").args(&twice), &folder);
    }
    for compiler in ["g++", "clang++"].iter().filter(|compiler| is_there(compiler)) {
        let flags = [
            "-x",
            "c++",
            "-std=c++11",
            "-Wall",
            "-Wextra",
            "-Wpedantic",
            "-Werror",
            "-fsyntax-only",
        ];
        run(Command::new(compiler).args(flags).args(&once), &folder);
    }
}

/// A source for each header, which includes it so many times and nothing else; their names.
fn alone(folder: &Path, files: &[CFile], end: &str, times: usize) -> Vec<String> {
    let headers = files.iter().filter(|file| file.name.ends_with(".h"));
    let source = |(index, header): (usize, &CFile)| {
        let name = format!("alone_{index}{end}");
        let text = format!("#include \"{}\"\n", header.name).repeat(times);
        let main = "int main(void) { return 0; }\n";
        std::fs::write(folder.join(&name), text + main).expect("the target folder is writable");
        name
    };
    headers.enumerate().map(source).collect()
}

/// Runs a command in a folder; what it prints, or a panic with its complaint.
pub fn run(command: &mut Command, folder: &Path) -> String {
    let output = command.current_dir(folder).output().expect("it is installed");
    assert!(
        output.status.success(),
        "{command:?} in {}:\n{}",
        folder.display(),
        String::from_utf8_lossy(&output.stderr)
    );
    String::from_utf8(output.stdout).expect("UTF-8")
}
