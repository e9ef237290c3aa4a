//! Root of the project, and calls of its own cargo.
//!
//! Invariant: a nested cargo sees none of the variables that `cargo run` sets for this program; they would describe
//! the wrong package to it, and could make it rebuild.
//!
//! What it must not know: which commands there are.

use std::path::{Path, PathBuf};
use std::process::Command;

/// Returns the root of the workspace: the folder above this crate.
///
/// The value of cargo at run time has priority, so that a checkout can be moved without a rebuild.
#[must_use]
pub fn root() -> PathBuf {
    let here = std::env::var_os("CARGO_MANIFEST_DIR")
        .map_or_else(|| PathBuf::from(env!("CARGO_MANIFEST_DIR")), PathBuf::from);
    here.parent().map_or_else(|| here.clone(), Path::to_path_buf)
}

/// Returns a call of the cargo that started this program, in `root`.
#[must_use]
pub fn cargo(root: &Path, arguments: &[&str]) -> Command {
    let program = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut command = Command::new(program);
    command.args(arguments).current_dir(root);
    for (name, _) in std::env::vars_os() {
        if name.to_str().is_some_and(describes_this_package) {
            command.env_remove(name);
        }
    }
    command
}

/// Arguments that select the workspace's features for a single package, so that its dependencies are built as for all
/// packages.
pub const UNIFIED: [&str; 4] = ["-p", "unified", "--features", "unified/tests"];

/// Makes cargo build the workspace's packages with the compiler that also lints. `cargo clippy` would check
/// everything a second time, separately from the build.
pub fn lint(cargo: &mut Command) -> &mut Command {
    cargo.env("RUSTC_WORKSPACE_WRAPPER", "clippy-driver")
}

/// Returns true if cargo sets the variable for the package that it runs, not for itself.
fn describes_this_package(variable: &str) -> bool {
    variable.starts_with("CARGO_PKG_")
        || matches!(variable, "CARGO_MANIFEST_DIR" | "CARGO_MANIFEST_PATH")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_root_holds_the_workspace() {
        assert!(root().join("xtask").join("Cargo.toml").is_file());
    }

    #[test]
    fn the_users_own_settings_of_cargo_stay() {
        assert!(describes_this_package("CARGO_PKG_NAME"));
        assert!(describes_this_package("CARGO_MANIFEST_DIR"));
        assert!(!describes_this_package("CARGO_TARGET_DIR"));
        assert!(!describes_this_package("CARGO_HOME"));
    }
}
