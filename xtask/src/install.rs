//! Installation of missing tools: the plan, the line that shows it, and its execution.
//!
//! Invariants:
//! - the line printed and the steps run are made of the same words;
//! - apt-get is requested nothing but what is missing, asks nothing, and waits for a lock held by another;
//! - the environment of Python is made whole: if one of its packages is missing, it is made anew with all of them, so that no
//!   part depends on what was there;
//! - what requests a password, and what a build needs, is installed before anything else begins; the rest, which waits for the
//!   network and the disk, goes on beside the build;
//! - a [`Plan`] is only made where apt-get works, or where nothing has to come from it.
//!
//! What it must not know: why a tool is needed.

use crate::error::Error;
use crate::stages::{self, Progress};
use crate::tools::{self, Machine, Source, Tool};
use std::process::{Command, ExitStatus};
use std::thread::JoinHandle;

/// Ways to run commands as root.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Rights {
    /// This process is root.
    Root,
    /// By sudo.
    Sudo,
    /// There is no way; the user must become root.
    None,
}

/// A plan of the commands that install missing tools.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Plan {
    components: Vec<&'static str>,
    packages: Vec<&'static str>,
    python: Vec<&'static str>,
    rights: Rights,
}

/// One command of the installation.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Step {
    name: &'static str,
    words: Vec<String>,
    as_root: bool,
}

const WAIT: &str = "DPkg::Lock::Timeout=900";

impl Plan {
    /// Returns the plan to install `tools` on this machine; none if nothing is needed, or apt-get is needed and absent.
    #[must_use]
    pub fn of(tools: &[&'static Tool], machine: &dyn Machine) -> Option<Self> {
        let (mut components, mut packages, mut python) = (Vec::new(), Vec::new(), Vec::new());
        for tool in tools {
            match tool.source {
                Source::Component(name) => components.push(name),
                Source::Package(name) => packages.push(name),
                Source::Python(_) => python = tools::requirements().collect(),
                Source::Rust => {}
            }
        }
        let possible = packages.is_empty() || machine.version("apt-get").is_some();
        let needed = !(packages.is_empty() && components.is_empty() && python.is_empty());
        (possible && needed).then(|| Self { components, packages, python, rights: rights(machine) })
    }

    /// Returns the line that installs the tools, for a shell.
    #[must_use]
    pub fn line(&self) -> String {
        let joined = |steps: &[Step]| {
            steps.iter().map(|step| step.words.join(" ")).collect::<Vec<_>>().join(" && ")
        };
        let steps = self.steps();
        let parts = steps.chunk_by(|one, next| one.as_root == next.as_root).map(|part| {
            match self.rights == Rights::None && part[0].as_root {
                true => format!("su -c '{}'", joined(part)),
                false => joined(part),
            }
        });
        parts.collect::<Vec<_>>().join(" && ")
    }

    /// Executes the plan.
    ///
    /// # Errors
    ///
    /// [`Error::NoRights`] before anything is changed, [`Error::Install`] at the first step that fails.
    pub fn carry_out(&self, tools: &[&'static Tool], progress: &mut Progress) -> Result<(), Error> {
        self.begin(tools, "")?;
        self.steps().iter().try_for_each(|step| self.run(step, progress))
    }

    /// Starts to execute the plan while other work goes on. Executes it at once if a build needs a part of it, or a
    /// password is requested.
    ///
    /// # Errors
    ///
    /// Those of [`carry_out`](Self::carry_out).
    pub fn start(
        self,
        tools: &[&'static Tool],
        progress: &mut Progress,
    ) -> Result<Option<Installation>, Error> {
        let asks = self.rights == Rights::Sudo && !self.packages.is_empty();
        if asks || !self.components.is_empty() {
            return self.carry_out(tools, progress).map(|()| None);
        }
        self.begin(tools, ", beside the build")?;
        let work = move || {
            let mut progress = Progress::silent();
            self.steps().iter().try_for_each(|step| self.run(step, &mut progress))?;
            Ok(progress)
        };
        Ok(Some(Installation(std::thread::spawn(work))))
    }

    /// Prints which tools are installed, if that is possible.
    fn begin(&self, tools: &[&'static Tool], how: &str) -> Result<(), Error> {
        let tools: Vec<_> = tools.iter().map(|tool| tool.name).collect();
        if self.rights == Rights::None && !self.packages.is_empty() {
            return Err(Error::NoRights { tools, line: self.line() });
        }
        anstream::eprintln!("installing what is missing{how}: {}", tools.join(", "));
        Ok(())
    }

    /// Runs a step. Sudo may request a password, so it uses the terminal directly; other commands run behind the
    /// progress line.
    fn run(&self, step: &Step, progress: &mut Progress) -> Result<(), Error> {
        let Some((program, arguments)) = step.words.split_first() else {
            return Ok(());
        };
        let mut command = Command::new(program);
        command.args(arguments);
        let verdict = |status: ExitStatus| match status.success() {
            true => Ok(()),
            false => Err(Error::Install { step: step.words.join(" "), status }),
        };
        if step.as_root && self.rights == Rights::Sudo {
            progress.open(step.name, || verdict(stages::attached(&mut command)?))
        } else {
            progress.closed(step.name, |voice| verdict(stages::captured(&mut command, voice)?))
        }
    }

    fn steps(&self) -> Vec<Step> {
        let mut steps = Vec::new();
        if !self.components.is_empty() {
            let words = words("rustup component add", &self.components);
            steps.push(Step { name: "rustup component add", words, as_root: false });
        }
        if !self.packages.is_empty() {
            let sudo = if self.rights == Rights::Sudo { "sudo " } else { "" };
            let update = words(&format!("{sudo}apt-get update -o {WAIT}"), &[]);
            let quiet = format!("{sudo}env DEBIAN_FRONTEND=noninteractive apt-get install -y");
            let install =
                words(&format!("{quiet} --no-install-recommends -o {WAIT}"), &self.packages);
            steps.push(Step { name: "apt-get update", words: update, as_root: true });
            steps.push(Step { name: "apt-get install", words: install, as_root: true });
        }
        if !self.python.is_empty() {
            let folder = tools::python();
            let pip = folder.join("bin/pip").display().to_string();
            let create = words("python3 -m venv --clear", &[&folder.display().to_string()]);
            let install = [vec![pip], words("install --quiet --no-compile", &self.python)].concat();
            steps.push(Step { name: "python3 -m venv", words: create, as_root: false });
            steps.push(Step { name: "pip install", words: install, as_root: false });
        }
        steps
    }
}

/// An installation that runs concurrently with other work.
#[derive(Debug)]
pub struct Installation(JoinHandle<Result<Progress, Error>>);

impl Installation {
    /// Waits for the end of the installation.
    ///
    /// # Errors
    /// [`Error::Install`] or [`Error::Spawn`] if a step failed.
    pub fn end(self, progress: &mut Progress) -> Result<(), Error> {
        let own = progress.closed("rest of the installation", |_| match self.0.join() {
            Ok(outcome) => outcome,
            Err(panic) => std::panic::resume_unwind(panic),
        })?;
        progress.done_beside(&own);
        Ok(())
    }
}

fn rights(machine: &dyn Machine) -> Rights {
    if machine.is_root() {
        Rights::Root
    } else if machine.version("sudo").is_some() {
        Rights::Sudo
    } else {
        Rights::None
    }
}

fn words(start: &str, rest: &[&str]) -> Vec<String> {
    start.split_whitespace().chain(rest.iter().copied()).map(str::to_owned).collect()
}
