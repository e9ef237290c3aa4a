//! The cargo workspace of a folder: root and packages.
//!
//! Must not know: what is generated from them.

use std::ffi::OsString;
use std::fs::{self, File};
use std::io::IsTerminal;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use serde_json::Value;

use super::error::Error;

/// Crate in which models are written.
const DSL: &str = "bessemer";
/// Feature with which functions of `f32` compute only in `f32`.
const SINGLE: &str = "single";

/// A cargo workspace.
#[derive(Clone, Debug)]
pub struct Workspace {
    /// Root folder.
    pub root: PathBuf,
    /// Target folder of cargo.
    pub target: PathBuf,
    /// Packages.
    pub members: Vec<Member>,
}

/// A package of a workspace.
#[derive(Clone, Debug)]
pub struct Member {
    /// Name.
    pub name: String,
    /// Version.
    pub version: String,
    /// Folder.
    pub folder: PathBuf,
    /// Licence in its manifest.
    pub license: Option<String>,
    /// Name of its library in Rust.
    pub library: Option<String>,
    /// True if Rust code can be linked with that library.
    pub linked: bool,
    /// True if its dependencies include the DSL.
    pub uses_dsl: bool,
    /// True if it enables the feature for `f32`.
    pub single: bool,
}

impl Workspace {
    /// Returns the workspace of `folder`.
    ///
    /// # Errors
    ///
    /// [`Error::Workspace`] if there is none, or if cargo cannot read one of its manifests.
    pub fn of(folder: &Path) -> Result<Workspace, Error> {
        let mut command = cargo(&["metadata", "--no-deps", "--format-version", "1"]);
        let output = command.current_dir(folder).stdin(Stdio::null()).output();
        let output = output.map_err(|source| Error::Run { program: program(), source })?;
        let failed = |said: &str| {
            let said = said.trim().trim_start_matches("error: ").to_owned();
            Error::Workspace { folder: folder.to_owned(), said }
        };
        if !output.status.success() {
            return Err(failed(&String::from_utf8_lossy(&output.stderr)));
        }
        let metadata: Value =
            serde_json::from_slice(&output.stdout).map_err(|error| failed(&error.to_string()))?;
        let path = |key: &str| metadata[key].as_str().map(PathBuf::from);
        let (Some(root), Some(target)) = (path("workspace_root"), path("target_directory")) else {
            return Err(failed("`cargo metadata` names no root"));
        };
        let packages = metadata["packages"].as_array().into_iter().flatten();
        Ok(Workspace { root, target, members: packages.filter_map(Member::of).collect() })
    }

    /// Returns the member of this name, unless another member would change its bits. Cargo builds the DSL once for all
    /// members, with the features that any of them requests.
    ///
    /// # Errors
    /// [`Error::NoPackage`] if there is none; [`Error::Singles`] if the members do not compute their `f32` alike.
    pub fn agreed(&self, name: &str) -> Result<&Member, Error> {
        let member = self.member(name)?;
        let other = self.members.iter().find(|it| it.uses_dsl && it.single != member.single);
        match other.filter(|_| member.uses_dsl) {
            None => Ok(member),
            Some(other) => {
                let (with, without) = if member.single { (member, other) } else { (other, member) };
                Err(Error::Singles { with: with.name.clone(), without: without.name.clone() })
            }
        }
    }

    /// Locks a file, and says so if that has to wait.
    fn lock(&self, file: File) -> std::io::Result<File> {
        if file.try_lock().is_err() {
            if std::io::stderr().is_terminal() {
                eprintln!("    Blocking waiting for another build in {}", self.target.display());
            }
            file.lock()?;
        }
        Ok(file)
    }

    /// Waits until no other run holds the lock of this name in the target folder, and holds it until the result is
    /// dropped.
    pub(super) fn alone(&self, name: &str) -> Result<File, Error> {
        let path = self.target.join(name);
        let locked = fs::create_dir_all(&self.target)
            .and_then(|()| File::create(&path))
            .and_then(|file| self.lock(file));
        locked.map_err(|source| Error::File { path, source })
    }

    /// Returns true if other workspaces may build into the target folder, which is outside of this one.
    pub(super) fn may_share(&self) -> bool {
        let real = |path: &Path| path.canonicalize().unwrap_or_else(|_| path.to_owned());
        !real(&self.target).starts_with(real(&self.root))
    }

    /// Returns the member of this name.
    ///
    /// # Errors
    ///
    /// [`Error::NoPackage`] if there is none.
    pub fn member(&self, name: &str) -> Result<&Member, Error> {
        let found = self.members.iter().find(|member| member.name == name);
        found.ok_or_else(|| Error::NoPackage {
            package: name.to_owned(),
            known: self.members.iter().map(|member| member.name.clone()).collect(),
        })
    }
}

impl Member {
    fn of(package: &Value) -> Option<Member> {
        let list = |key: &str| package[key].as_array().into_iter().flatten();
        let has = |of: &Value, words: &[&str]| {
            let all = of.as_array().into_iter().flatten().filter_map(Value::as_str);
            all.into_iter().any(|word| words.contains(&word))
        };
        let kinds = ["lib", "rlib", "dylib", "cdylib", "staticlib"];
        let library = list("targets").find(|target| has(&target["kind"], &kinds));
        let dsl = list("dependencies")
            .find(|it| it["name"] == DSL && it["kind"].is_null() && it["rename"].is_null());
        Some(Member {
            name: package["name"].as_str()?.to_owned(),
            folder: Path::new(package["manifest_path"].as_str()?).parent()?.to_owned(),
            version: package["version"].as_str().unwrap_or("0.0.0").to_owned(),
            license: package["license"].as_str().map(str::to_owned),
            library: library
                .and_then(|library| library["name"].as_str())
                .map(|it| it.replace('-', "_")),
            linked: library.is_some_and(|library| has(&library["crate_types"], &["lib", "rlib"])),
            uses_dsl: dsl.is_some(),
            single: dsl.is_some_and(|it| has(&it["features"], &[SINGLE])),
        })
    }

    /// Returns the name of the library, if models can be generated from the package.
    ///
    /// # Errors
    ///
    /// The unmet condition.
    pub fn models(&self) -> Result<&str, Error> {
        let package = self.name.clone();
        match &self.library {
            None => Err(Error::NoLibrary { package }),
            Some(_) if !self.linked => Err(Error::NotLinked { package }),
            Some(_) if !self.uses_dsl => Err(Error::NotOfTheDsl { package }),
            Some(library) => Ok(library),
        }
    }
}

/// Returns the running cargo, or the one on the path, without the variables that `cargo run` sets for its caller. They
/// describe another package and would cause rebuilds.
pub(super) fn cargo(arguments: &[&str]) -> Command {
    let mut command = Command::new(program());
    command.args(arguments);
    for (name, _) in std::env::vars_os() {
        let name = name.to_string_lossy();
        if name.starts_with("CARGO_PKG_") || name.starts_with("CARGO_MANIFEST_") {
            command.env_remove(&*name);
        }
    }
    command
}

/// Returns the cargo to run: the one that runs this process, or the one on the path.
pub(super) fn program() -> String {
    std::env::var_os("CARGO").unwrap_or_else(|| OsString::from("cargo")).to_string_lossy().into()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn member(name: &str, uses_dsl: bool, single: bool) -> Member {
        Member {
            name: name.to_owned(),
            folder: PathBuf::new(),
            version: "0.0.0".to_owned(),
            license: None,
            library: None,
            linked: false,
            uses_dsl,
            single,
        }
    }

    #[test]
    fn members_with_other_bits_are_refused_and_named() {
        let of = |members: Vec<Member>| Workspace {
            root: PathBuf::new(),
            target: PathBuf::new(),
            members,
        };
        let drive = || member("drive", true, true);
        let alike = of(vec![drive(), member("tool", false, false), member("pump", true, true)]);
        assert!(alike.agreed("drive").is_ok() && alike.agreed("tool").is_ok());
        let apart = of(vec![drive(), member("pump", true, false)]);
        for name in ["drive", "pump"] {
            let error = apart.agreed(name).expect_err("they disagree");
            let said = error.to_string();
            assert!(said.contains("`drive` enables") && said.contains("`pump` does not"), "{said}");
            assert!(error.remedy().is_some_and(|it| it.contains("workspace.dependencies")));
        }
    }
}
