//! Programs that make calls of the C in lives (`harness::lives`): their folder and their text, and the C that they can call.

use std::path::PathBuf;

use bessemer_codegen::compile::{Compiled, Options};
use bessemer_ir::{FunctionId, Module};
use bessemer_legs::process;
use bessemer_project::Project;

use crate::error::Error;

/// Returns the functions with the number of parameters that their author wrote.
pub fn taken(module: &Module, functions: &[FunctionId]) -> Vec<(FunctionId, u32)> {
    functions.iter().map(|id| (*id, module.functions[id.index()].params)).collect()
}

/// Writes the C and the text of a program for these functions. Returns the folder, and the path of the text.
///
/// # Errors
/// An error of the file system.
pub fn laid_out(
    compiled: &Compiled,
    functions: &[FunctionId],
    text: impl FnOnce(&Module, &[(FunctionId, u32)]) -> String,
) -> Result<(process::Folder, PathBuf), Error> {
    let folder = process::lay_out(compiled).map_err(|error| Error::Compiler {
        name: "bessemer".to_owned(),
        said: error.to_string(),
    })?;
    let main = folder.path().join("lives_main.c");
    let text = text(&compiled.explicit, &taken(&compiled.module, functions));
    std::fs::write(&main, text).map_err(|source| Error::File { path: main.clone(), source })?;
    Ok((folder, main))
}

/// Returns the options of a program: the firmware's own function at a fault is not in it.
pub fn options(project: &Project) -> Options {
    Options { hook: None, ..project.settings.options.clone() }
}

/// Returns the C without the firmware's own function at a fault; none if it has no such function.
///
/// # Errors
/// The models do not become such C.
pub fn without_hook(project: &Project, compiled: &Compiled) -> Result<Option<Compiled>, Error> {
    if project.settings.options.hook.is_none() {
        return Ok(None);
    }
    let anew = compiled.anew(&options(project)).map_err(|wrong| Error::Compiler {
        name: "bessemer".to_owned(),
        said: wrong.into_iter().map(|it| it.message).collect(),
    })?;
    Ok(Some(anew))
}
