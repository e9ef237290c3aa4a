//! `cargo bessemer vectors`: an entry point as Rust that computes eight runs at once, for simulations.
//!
//! It must not know how vectors are emitted.

use std::path::Path;

use bessemer_backend::passes;
use bessemer_ir::FunctionId;
use bessemer_legs::entries::{all, named};
use bessemer_project::{Wanted, compile};

use crate::args::Vectors;
use crate::error::Error;

/// Writes the file; returns a text that says how it is used.
///
/// # Errors
/// Errors of the models or the system, an entry point that does not exist, or one that vectors cannot compute.
pub fn run(folder: &Path, wanted: &Vectors, colour: bool) -> Result<String, Error> {
    let package = Wanted { package: wanted.package.name(), colour, ..Wanted::default() };
    let (_, compiled) = compile(folder, package)?;
    // The IR of the C has memory of the caller for large locals; vectors need none. The models have compiled, so this IR exists.
    let explicit = passes::explicit(compiled.module.clone());
    let module = explicit.map_or_else(|_| compiled.explicit.clone(), |it| it.0);
    let name = |id: &FunctionId| named(&module, &module.functions[id.index()]);
    let known: Vec<String> = all(&module).map(|id| name(&id)).collect();
    let chosen: Vec<FunctionId> = all(&module)
        .filter(|id| wanted.entry.as_ref().is_none_or(|entry| *entry == name(id)))
        .collect();
    let entry = match (chosen.as_slice(), &wanted.entry) {
        ([entry], _) => *entry,
        (_, Some(name)) => return Err(Error::NoEntry { name: name.clone(), known }),
        (_, None) => return Err(Error::WhichEntry { known }),
    };
    let text = bessemer_vectors::emit(&module, &[entry])?;
    let path = folder.join(&wanted.output);
    let failed = |source| Error::File { path: path.clone(), source };
    if let Some(parent) = path.parent() {
        std::fs::create_dir_all(parent).map_err(failed)?;
    }
    std::fs::write(&path, text).map_err(failed)?;
    Ok(format!(
        "{}: {} for eight runs at once, of the types of bessemer-lanes\n  #[allow(unused, clippy::all)]\n  mod eight {{ include!(…); }}\n",
        wanted.output.display(),
        name(&entry)
    ))
}
