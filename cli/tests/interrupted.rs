//! Interrupted and concurrent generations: a full disk, a kill, and two at once. The folder of the C is complete at
//! each moment, and the next run recovers.
//!
//! The system does the cutting, at the same byte each time: a limit on the size of files (`ulimit -f`) makes the write beyond it fail
//! as on a full disk, or, where nobody ignores its signal, kills the process there. Who writes is this program again, as a process of
//! its own.

use std::collections::BTreeMap;
use std::fs::{self, File};
use std::os::unix::process::ExitStatusExt;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use bessemer_backend::c::CFile;
use bessemer_codegen::compile::{Compiled, Options, compile};
use bessemer_codegen::generate::{Job, Workspace, deliver};
use bessemer_frontend::source::Sources;
use bessemer_ir::tree::Package;
use tempfile::TempDir;

/// Environment variable with the workspace of a child process.
const WORKSPACE: &str = "BESSEMER_TEST_WORKSPACE";
const VERSION: &str = "BESSEMER_TEST_VERSION";

/// More than the limit, in bytes; that is in blocks of 512 or 1024, by the shell.
const LARGE: usize = 16 << 20;
const LIMIT: &str = "ulimit -c 0; ulimit -f 8192";

/// The C of a version: a small file, a large one, a small one, in the order in which they are written.
fn version(text: &str) -> Compiled {
    let package = Package { name: "motor".into(), license: "MIT".into(), ..Package::default() };
    let compiled = compile(&package, &Sources::new("."), &Options::default());
    let mut compiled = compiled.unwrap_or_else(|_| panic!("nothing is wrong with nothing"));
    let file = |name: &str, text: String| CFile { name: name.into(), text, map: Vec::new() };
    compiled.files = vec![
        file("acme/motor.h", format!("/* {text} */\n")),
        file("large.c", format!("/* {text} */\n") + &" ".repeat(LARGE)),
        file("motor.c", format!("/* {text} */\n")),
    ];
    compiled
}

fn workspace() -> TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    let manifest = "[package]\nname = \"motor\"\nedition = \"2024\"\n";
    fs::create_dir(folder.path().join("src")).expect("a folder");
    fs::write(folder.path().join("Cargo.toml"), manifest).expect("a file");
    fs::write(folder.path().join("src/lib.rs"), "").expect("a file");
    deliver(&Job::new(folder.path(), "motor"), &version("old")).expect("there is room");
    folder
}

/// Each file of the C, the large one by its first line.
fn files(workspace: &Path) -> BTreeMap<PathBuf, String> {
    let mut all = BTreeMap::new();
    let mut open = vec![workspace.join("generated")];
    while let Some(folder) = open.pop() {
        for entry in fs::read_dir(folder).expect("the C is there").flatten() {
            let path = entry.path();
            match path.is_dir() {
                true => open.push(path),
                false => {
                    let text = fs::read_to_string(&path).expect("a file");
                    all.insert(path, text.lines().next().unwrap_or_default().to_owned());
                }
            }
        }
    }
    all
}

/// The folders of runs that did not come to their end.
fn stages(workspace: &Path) -> Vec<PathBuf> {
    let all = fs::read_dir(workspace).expect("the workspace").flatten().map(|it| it.path());
    let is_stage = |path: &PathBuf| path.to_string_lossy().contains("/.bessemer-generated-");
    all.filter(is_stage).collect()
}

/// A process that writes a version.
fn writer(workspace: &Path, version: &str, before: &str) -> Command {
    let mut command = Command::new("sh");
    let program = std::env::current_exe().expect("this program");
    command
        .arg("-c")
        .arg(format!("{before}; exec \"$0\" --exact in_a_process_of_its_own --nocapture"));
    command.arg(program).env(WORKSPACE, workspace).env(VERSION, version).stdin(Stdio::null());
    command
}

fn written(mut command: Command) -> Output {
    command.output().expect("there is a shell")
}

/// Runs the work of a child process that [`writer`] starts; does nothing as a test.
#[test]
fn in_a_process_of_its_own() {
    let (Some(workspace), Ok(text)) = (std::env::var_os(WORKSPACE), std::env::var(VERSION)) else {
        return;
    };
    let job = Job::new(workspace, "motor");
    if let Err(error) = deliver(&job, &version(&text)) {
        panic!("error: {error}; to do: {}", error.remedy().unwrap_or_default());
    }
}

#[test]
fn a_disk_that_is_full_is_told_and_the_c_stays() {
    let workspace = workspace();
    let before = files(workspace.path());
    let output = written(writer(workspace.path(), "new", &format!("trap '' XFSZ; {LIMIT}")));
    let text = String::from_utf8_lossy(&output.stderr) + String::from_utf8_lossy(&output.stdout);
    assert!(!output.status.success(), "{text}");
    assert!(text.contains("new/large.c`: File too large"), "{text}");
    assert!(
        text.contains("to do: free some space there; the previous output is unchanged"),
        "{text}"
    );
    assert_eq!(files(workspace.path()), before);
    assert_eq!(stages(workspace.path()), Vec::<PathBuf>::new());
}

#[test]
fn a_run_that_is_killed_leaves_the_c_whole_and_the_next_one_takes_it_up() {
    /// SIGXFSZ.
    const BEYOND: i32 = 25;
    let workspace = workspace();
    let before = files(workspace.path());
    let output = written(writer(workspace.path(), "new", LIMIT));
    assert_eq!(output.status.signal(), Some(BEYOND), "{output:?}");
    assert_eq!(files(workspace.path()), before);
    let [stage] = &stages(workspace.path())[..] else { panic!("it was killed while it wrote") };
    assert!(stage.join("new/acme/motor.h").is_file() && !stage.join("new/motor.c").exists());

    let output = written(writer(workspace.path(), "new", ":"));
    assert!(output.status.success(), "{output:?}");
    let after = files(workspace.path());
    assert_eq!(after.keys().collect::<Vec<_>>(), before.keys().collect::<Vec<_>>());
    let manifest = |path: &PathBuf| path.ends_with("manifest.json");
    assert!(after.iter().all(|(path, text)| manifest(path) || text == "/* new */"), "{after:?}");
    assert_eq!(stages(workspace.path()), Vec::<PathBuf>::new());
}

/// A second run waits until the first is done: the system lists it among those that wait for the lock.
#[test]
fn two_at_once_write_one_behind_the_other() {
    let workspace = workspace();
    let before = files(workspace.path());
    let target = Workspace::of(workspace.path()).expect("a workspace").target;
    fs::create_dir_all(&target).expect("a folder");
    let first = File::create(target.join(".bessemer-written")).expect("a lock");
    first.lock().expect("nobody has it");
    let mut second = writer(workspace.path(), "new", ":");
    let mut second = second.stdout(Stdio::null()).spawn().expect("there is a shell");
    // `1: -> FLOCK  ADVISORY  WRITE 4711 …`: the shell became the program, so that the number is its own.
    let waits = |pid: u32| {
        let locks = fs::read_to_string("/proc/locks").expect("Linux lists its locks");
        let number = pid.to_string();
        locks
            .lines()
            .any(|it| it.contains("->") && it.split_whitespace().any(|word| word == number))
    };
    while !waits(second.id()) {
        let ended = second.try_wait().expect("it is ours");
        assert!(ended.is_none(), "it did not wait: {ended:?}");
        std::thread::yield_now();
    }
    assert_eq!(files(workspace.path()), before);
    drop(first);
    assert!(second.wait().expect("it is ours").success());
    assert_ne!(files(workspace.path()), before);
    assert_eq!(stages(workspace.path()), Vec::<PathBuf>::new());
}
