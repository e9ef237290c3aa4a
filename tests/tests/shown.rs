//! Execution of the commands in the book. Each `sh` block of the pages about firmware runs in a package that follows
//! these pages. A block that cannot run here has the reason above it: `<!-- not run: … -->`.
//!
//! `cargo bessemer` is called as the function that the command is; everything else goes to a shell. A run takes some of the
//! blocks alternately, and a full run each of them.

use std::fs;
use std::path::Path;
use std::process::Command;

use bessemer_tests::{root, toolchain, turn};
use cargo_bessemer::args::{Arguments, Task};
use cargo_bessemer::perform;
use clap::Parser as _;

const PAGES: [&str; 4] = ["tutorial", "build-systems", "target", "updating"];

/// Blocks of a run.
const AT_ONCE: usize = 3;

const NOT_RUN: &str = "<!-- not run: ";

/// A block of commands.
struct Block {
    page: &'static str,
    lines: Vec<String>,
}

/// Carries out the blocks in `package`, which is left as it was but for its C, which is generated anew.
pub(super) fn run(package: &Path) {
    let before = entries(package);
    let log =
        "time,speed,gains.proportional,gains.integral,gains.period,target\n0,0,0.1,0.5,0.005,100\n";
    fs::write(package.join("flight.csv"), log).expect("a recording");
    // As the page of build systems requests it.
    let settings = package.join("bessemer.toml");
    let sound = fs::read_to_string(&settings).expect("the settings");
    fs::write(&settings, format!("build_files = true\n{sound}")).expect("the settings");
    performed(package, "gen").unwrap_or_else(|said| panic!("{said}"));
    firmware(package);
    for block in turn::some_of(blocks(), AT_ONCE) {
        for line in &block.lines {
            if let Err(said) = carried_out(package, line) {
                panic!("docs/book/{}.md: {line}\n{said}", block.page);
            }
        }
    }
    fs::write(&settings, sound).expect("the settings");
    performed(package, "gen").unwrap_or_else(|said| panic!("{said}"));
    let _ = fs::remove_dir_all(package.join("firmware/verify"));
    for path in entries(package).into_iter().filter(|path| !before.contains(path)) {
        let removed =
            if path.is_dir() { fs::remove_dir_all(&path) } else { fs::remove_file(&path) };
        removed.expect("what the commands made");
    }
}

fn entries(folder: &Path) -> Vec<std::path::PathBuf> {
    fs::read_dir(folder).expect("the package").flatten().map(|it| it.path()).collect()
}

/// The firmware of a reader's own that the pages name: `build/firmware.elf`.
fn firmware(package: &Path) {
    let folder = package.join("build");
    fs::create_dir_all(&folder).expect("a folder");
    let source = folder.join("firmware.c");
    let text = "#include \"motor.h\"\nmotor_t controller;\ngains_t gains;\nint main(void)\n{\n    motor_init(&controller);\n    return 0;\n}\n";
    fs::write(&source, text).expect("a file");
    let include = format!("-I{}", package.join("generated").display());
    toolchain::GCC
        .link(
            &[source, package.join("generated/motor.c")],
            &folder.join("firmware.elf"),
            &[&include],
        )
        .unwrap_or_else(|said| panic!("{said}"));
}

/// The blocks that can run, each line without its comment.
fn blocks() -> Vec<Block> {
    let mut blocks = Vec::new();
    for page in PAGES {
        let text = fs::read_to_string(root().join(format!("docs/book/{page}.md"))).expect("a page");
        let (mut before, mut lines) = ("", text.lines().map(str::trim));
        while let Some(line) = lines.next() {
            if line == "```sh" {
                let own = lines.by_ref().take_while(|line| *line != "```");
                let own = own.map(|line| line.split(" #").next().unwrap_or_default().trim_end());
                let own = own.filter(|line| !line.is_empty()).map(str::to_owned).collect();
                if !before.starts_with(NOT_RUN) {
                    blocks.push(Block { page, lines: own });
                }
                before = "";
            } else if !line.is_empty() {
                before = line;
            }
        }
    }
    assert!(blocks.len() >= 12, "{} blocks", blocks.len());
    blocks
}

/// Carries out a line, unless this run leaves out a program that it needs.
fn carried_out(package: &Path, line: &str) -> Result<(), String> {
    let mut needed = line.split(" && ").filter_map(|it| it.split_whitespace().next());
    let known = |program: &str| ["cargo", "cc"].contains(&program) || program.starts_with("./");
    let arm = ["arm-none-eabi-gcc", "qemu-system-arm"];
    let emulated = line.contains("--target").then_some(arm).into_iter().flatten();
    let missing = needed.find(|it| !known(it) && !toolchain::is_asked_for(it));
    let mut emulated = emulated.filter(|it| !toolchain::is_asked_for(it));
    if let Some(program) = missing.or_else(|| emulated.next()) {
        println!("left out: {program} is not installed: {line}");
        return Ok(());
    }
    match line.strip_prefix("cargo bessemer ") {
        Some(words) => performed(package, words),
        None => {
            let mut shell = Command::new("sh");
            shell.args(["-ec", line]).current_dir(package).env("CARGO_NET_OFFLINE", "true");
            toolchain::run(&mut shell)
        }
    }
}

/// A command of `cargo bessemer`, which takes paths from the folder that it is called in.
fn performed(package: &Path, words: &str) -> Result<(), String> {
    let (words, to) = match words.split_once(" > ") {
        Some((words, to)) => (words, Some(to)),
        None => (words, None),
    };
    let words = ["cargo", "bessemer"].into_iter().chain(words.split_whitespace());
    let mut task = Arguments::try_parse_from(words).map_err(|error| error.to_string())?.task();
    match &mut task {
        Task::Pack(it) => it.output = package.join(&it.output),
        Task::Fmu(it) => it.output = package.join(&it.output),
        Task::Py(it) => it.output = package.join(&it.output),
        Task::Verify(it) => {
            for path in [&mut it.inputs, &mut it.board].into_iter().flatten() {
                *path = package.join(&*path);
            }
        }
        _ => {}
    }
    let (text, good) = perform(package, task).map_err(|error| error.to_string())?;
    if let Some(to) = to {
        fs::write(package.join(to), &text).map_err(|error| error.to_string())?;
    }
    if good { Ok(()) } else { Err(text) }
}
