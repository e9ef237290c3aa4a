//! A test program built by cargo: its path, its tests, and the environment in which cargo would run it.
//!
//! What it must not know: when a test runs, and how its result is used.

use crate::error::Error;
use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// A test program.
#[derive(Clone, Debug)]
pub struct Program {
    package: String,
    target: String,
    path: PathBuf,
    folder: PathBuf,
    version: String,
}

impl Program {
    /// Returns the programs named in cargo's messages.
    #[must_use]
    pub fn of(messages: &str) -> Vec<Self> {
        let messages = messages.lines().filter_map(|line| serde_json::from_str::<Value>(line).ok());
        messages.filter_map(|message| Self::of_message(&message)).collect()
    }

    fn of_message(message: &Value) -> Option<Self> {
        if message["reason"] != "compiler-artifact" || message["profile"]["test"] != true {
            return None;
        }
        let path = PathBuf::from(message["executable"].as_str()?);
        let folder = Path::new(message["manifest_path"].as_str()?).parent()?.to_owned();
        // `path+file:///…/tests#bessemer-tests@0.1.0`, or `…/sim#0.1.0` where folder and package have one name.
        let (before, name) = message["package_id"].as_str()?.rsplit_once('#')?;
        let (package, version) = match name.split_once('@') {
            Some((package, version)) => (package, version),
            None => (before.rsplit('/').next()?, name),
        };
        let (package, version) = (package.to_owned(), version.to_owned());
        Some(Self {
            package,
            version,
            target: message["target"]["name"].as_str()?.to_owned(),
            path,
            folder,
        })
    }

    /// Returns the package, and the program unless it is the package's own.
    #[must_use]
    pub fn title(&self) -> String {
        if self.target.replace('_', "-") == self.package {
            self.package.clone()
        } else {
            format!("{}/{}", self.package, self.target)
        }
    }

    /// Returns the title of a test: `package/program::test`.
    #[must_use]
    pub fn title_of(&self, test: &str) -> String {
        format!("{}::{test}", self.title())
    }

    /// Returns the names of its tests.
    ///
    /// # Errors
    ///
    /// [`Error::Spawn`] if the program does not start.
    pub fn tests(&self, environment: &[(&str, String)]) -> Result<Vec<String>, Error> {
        let mut command = self.command(environment);
        command.args(["--list", "--format", "terse"]).stdin(Stdio::null());
        let output = command
            .output()
            .map_err(|source| Error::Spawn { program: self.path.display().to_string(), source })?;
        let text = String::from_utf8_lossy(&output.stdout);
        let names = text.lines().filter_map(|line| line.strip_suffix(": test"));
        Ok(names.map(str::to_owned).collect())
    }

    /// Returns a command that runs the program as cargo would.
    #[must_use]
    pub fn command(&self, environment: &[(&str, String)]) -> Command {
        let mut command = Command::new(&self.path);
        command
            .current_dir(&self.folder)
            .env("CARGO_MANIFEST_DIR", &self.folder)
            .env("CARGO_PKG_NAME", &self.package)
            .env("CARGO_PKG_VERSION", &self.version)
            .envs(environment.iter().map(|(name, value)| (name, value)));
        command
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MESSAGES: &str = r##"{"reason":"compiler-artifact","package_id":"path+file:///a/tests#bessemer-tests@0.1.0","manifest_path":"/a/tests/Cargo.toml","target":{"name":"all"},"profile":{"test":true},"executable":"/a/target/all-1"}
not JSON
{"reason":"compiler-artifact","package_id":"path+file:///a/sim#0.1.0","manifest_path":"/a/sim/Cargo.toml","target":{"name":"sim"},"profile":{"test":true},"executable":"/a/target/sim-1"}
{"reason":"compiler-artifact","package_id":"path+file:///a/sim#0.1.0","manifest_path":"/a/sim/Cargo.toml","target":{"name":"sim"},"profile":{"test":false},"executable":"/a/target/sim"}"##;

    #[test]
    fn programs_are_read_from_cargos_messages() {
        let programs = Program::of(MESSAGES);
        let titles: Vec<_> = programs.iter().map(Program::title).collect();
        assert_eq!(titles, ["bessemer-tests/all", "sim"]);
        assert_eq!(programs[0].folder, Path::new("/a/tests"));
        assert_eq!(programs[1].version, "0.1.0");
    }
}
