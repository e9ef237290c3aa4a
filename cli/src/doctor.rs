//! `cargo bessemer doctor`: lists what this machine and this workspace have, what is missing, and the remedies.
//!
//! Invariants: it changes nothing; its text depends only on the findings.

use std::fmt::Write as _;
use std::path::Path;

use anstyle::{AnsiColor, Color, Style};
use bessemer_project::Project;
use bessemer_tools as tools;

const RED: Style = Style::new().bold().fg_color(Some(Color::Ansi(AnsiColor::Red)));
const GREEN: Style = Style::new().fg_color(Some(Color::Ansi(AnsiColor::Green)));
const YELLOW: Style = Style::new().fg_color(Some(Color::Ansi(AnsiColor::Yellow)));

/// The questions that `doctor` asks a machine.
pub trait Machine {
    /// The first line that a program says of its version; none if it does not run.
    fn version(&self, program: &str) -> Option<String>;
}

/// The machine that this runs on.
pub struct ThisMachine;

impl Machine for ThisMachine {
    fn version(&self, program: &str) -> Option<String> {
        let said = tools::version(program)?;
        Some(said.lines().next().unwrap_or_default().to_owned())
    }
}

/// A program that some command runs.
struct Tool {
    program: &'static str,
    purpose: &'static str,
    source: Source,
}

/// The place that a program comes from.
#[derive(Clone, Copy)]
enum Source {
    /// Packages of Debian bring it; without it some commands do not work.
    Debian(tools::Program),
    /// This page says how to install it; without it no command works.
    Page(&'static str),
}

/// A program that packages of Debian bring.
const fn tool(program: tools::Program, purpose: &'static str) -> Tool {
    Tool { program: program.name, purpose, source: Source::Debian(program) }
}

const TOOLS: [Tool; 10] = [
    Tool {
        program: "rustc",
        purpose: "builds the models",
        source: Source::Page("https://rustup.rs"),
    },
    tool(tools::GCC, "compiles the C on this machine"),
    tool(tools::CLANG, "compiles the C a second time"),
    tool(tools::CMAKE, "builds the firmware stub"),
    tool(tools::ARM_LINUX_GCC, "compiles the C for `verify --target cortex-a9`"),
    tool(tools::QEMU_ARM, "runs it"),
    tool(
        tools::ARM_BARE_GCC,
        "compiles the C for `verify --target zynq`, `cortex-m4f` and `cortex-m7`",
    ),
    tool(tools::QEMU_SYSTEM_ARM, "runs it"),
    tool(tools::RISCV_BARE_GCC, "compiles the C for `verify --target riscv32`"),
    tool(tools::QEMU_SYSTEM_RISCV32, "runs it"),
];

/// One thing that was looked at.
struct Finding {
    name: String,
    state: State,
    said: String,
    remedy: Option<String>,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum State {
    Good,
    /// Something cannot be done.
    Lacking,
    /// Nothing can be done.
    Bad,
}

/// Lists what the machine has and lacks, and tells whether models can be generated.
pub fn run(folder: &Path, package: Option<&str>, machine: &dyn Machine) -> (String, bool) {
    let mut findings: Vec<Finding> = TOOLS.iter().map(|tool| tool.found(machine)).collect();
    findings.extend(of_project(folder, package));
    (table(&findings), findings.iter().all(|it| it.state != State::Bad))
}

impl Tool {
    fn found(&self, machine: &dyn Machine) -> Finding {
        let version = machine.version(self.program);
        let state = match (&version, self.source) {
            (Some(_), _) => State::Good,
            (None, Source::Debian(_)) => State::Lacking,
            (None, Source::Page(_)) => State::Bad,
        };
        let said = version.unwrap_or_else(|| format!("missing: it {}", self.purpose));
        let remedy = match self.source {
            _ if state == State::Good => None,
            Source::Debian(program) => Some(program.install()),
            Source::Page(address) => Some(address.to_owned()),
        };
        Finding { name: self.program.to_owned(), state, said, remedy }
    }
}

fn of_project(folder: &Path, package: Option<&str>) -> Vec<Finding> {
    let good = |name: &str, said: String| Finding {
        name: name.to_owned(),
        state: State::Good,
        said,
        remedy: None,
    };
    let project = match Project::find(folder, package, false) {
        Ok(project) => project,
        Err(error) => {
            let (said, remedy) = (error.to_string().trim().to_owned(), error.remedy());
            return vec![Finding { name: "package".to_owned(), state: State::Bad, said, remedy }];
        }
    };
    let name = &project.package.name;
    let mut findings = vec![match project.package.models() {
        Ok(_) => good("package", format!("`{name}` at {}", project.package.folder.display())),
        Err(error) => Finding {
            name: "package".to_owned(),
            state: State::Bad,
            said: error.to_string(),
            remedy: error.remedy(),
        },
    }];
    findings.push(match &project.file {
        Some(path) => good("bessemer.toml", path.display().to_string()),
        None => good("bessemer.toml", "none: everything is as it is without one".to_owned()),
    });
    let license = project.settings.license.as_ref().or(project.package.license.as_ref());
    findings.push(match license {
        Some(license) => good("licence", license.clone()),
        None => Finding {
            name: "licence".to_owned(),
            state: State::Bad,
            said: format!("`{name}` names none, and it stands in each file of the C"),
            remedy: Some(
                "write `license = \"…\"` into the `[package]` section of its Cargo.toml".to_owned(),
            ),
        },
    });
    findings.push(match project.checks_overflow() {
        true => good("overflow", "checked in optimised builds, too".to_owned()),
        false => Finding {
            name: "overflow".to_owned(),
            state: State::Lacking,
            said: "optimised builds of the Rust wrap where the C faults".to_owned(),
            remedy: Some(
                "write `overflow-checks = true` into `[profile.release]` of the workspace's Cargo.toml".to_owned(),
            ),
        },
    });
    findings
}

fn table(findings: &[Finding]) -> String {
    let width = findings.iter().map(|it| it.name.len()).max().unwrap_or_default();
    let mut text = String::new();
    for it in findings {
        let style = match it.state {
            State::Good => GREEN,
            State::Lacking => YELLOW,
            State::Bad => RED,
        };
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{:width$}  {style}{}{style:#}", it.name, it.said);
        if let Some(remedy) = &it.remedy {
            let _ = writeln!(text, "{:width$}  to do: {remedy}", "");
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A machine with these programs.
    struct With(&'static [&'static str]);

    impl Machine for With {
        fn version(&self, program: &str) -> Option<String> {
            self.0.contains(&program).then(|| format!("{program} 1.2"))
        }
    }

    #[test]
    fn what_is_missing_comes_with_its_line() {
        let empty = tempfile::tempdir().expect("a folder");
        let (text, good) = run(empty.path(), None, &With(&["rustc", "gcc"]));
        assert!(!good, "there is no workspace");
        let text = anstream::adapter::strip_str(&text).to_string();
        assert!(text.contains("gcc 1.2"), "{text}");
        assert!(text.contains("to do: apt-get install clang"), "{text}");
        assert!(text.contains("cargo bessemer new motor"), "{text}");
    }

    #[test]
    fn compilers_of_c_may_be_missing() {
        let bad = |programs| {
            let bad = TOOLS.iter().filter(|it| it.found(&With(programs)).state == State::Bad);
            bad.map(|it| it.program).collect::<Vec<_>>()
        };
        assert_eq!(bad(&["rustc"]), [""; 0]);
        assert_eq!(bad(&[]), ["rustc"]);
    }
}
