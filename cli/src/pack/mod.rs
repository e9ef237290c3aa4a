//! `cargo bessemer pack`: writes the C as a part of a firmware's system, such as a module, a library, a component or
//! a node.
//!
//! Invariants: the folder is complete; the same C gives the same folder; a parameter that no message can contain is
//! listed as omitted. The systems are data ([`systems`]). It must not know what the C computes.

pub mod bridge;
mod context;
mod fields;
mod systems;

use std::path::Path;

use bessemer_project::{Wanted, compile, parameter_tables};
use tera::{Context, Tera};

use crate::args::Pack;
use crate::error::Error;
use systems::{Each, Template};

/// Writes the folder. Returns its place, the parts that were left out, and the next steps.
///
/// # Errors
/// Errors of the models or the system; [`Error::Exists`] if the folder is there already.
pub fn run(folder: &Path, wanted: &Pack, colour: bool) -> Result<String, Error> {
    let package = Wanted { package: wanted.package.name(), colour, ..Wanted::default() };
    let (project, mut compiled) = compile(folder, package)?;
    compiled.files.extend(parameter_tables(&project, &compiled));
    let system = systems::form(wanted.system);
    let context = context::package(&project, &compiled, &system.style)?;
    let place = wanted.output.join(&context.name);
    if place.symlink_metadata().is_ok() {
        return Err(Error::Exists { folder: place });
    }
    let is_c = |name: &str| name.ends_with(".c") || name.ends_with(".h");
    let c = compiled.files.iter().filter(|it| is_c(&it.name));
    let mut files: Vec<(String, String)> =
        c.map(|it| (format!("{}{}", system.sources, it.name), it.text.clone())).collect();
    if system.build_files {
        files.extend(context.build_files.iter().cloned());
    }
    let next = text(system.next, &base(&context)).trim_end().to_owned();
    for template in system.templates.iter().chain(systems::COMMON) {
        files.extend(rendered(template, &context, &next));
    }
    for (path, text) in &files {
        let path = place.join(path);
        let failed = |source| Error::File { path: path.clone(), source };
        std::fs::create_dir_all(path.parent().unwrap_or(&place)).map_err(failed)?;
        std::fs::write(&path, text).map_err(failed)?;
    }
    let mut said = format!("{}: {} files\n", place.display(), files.len());
    for it in &context.left_out {
        said += &format!("left out: {it}\n");
    }
    Ok(format!("{said}Next:\n{}\n", next.replace("FOLDER", &place.display().to_string())))
}

/// The files of a template: one for all, or one for each component or entry point.
fn rendered(template: &Template, package: &context::Package, next: &str) -> Vec<(String, String)> {
    let mut base = base(package);
    base.insert("next", next);
    let mut files = Vec::new();
    let mut add = |context: &Context| {
        let (path, text) = (text(template.path, context), text(template.text, context));
        // A file that an entry point does not need is empty.
        if !text.is_empty() {
            files.push((path, text));
        }
    };
    match template.each {
        Each::Package => add(&base),
        Each::Component => {
            for component in &package.components {
                base.insert("component", component);
                add(&base);
            }
        }
        Each::Entry => {
            for entry in package.components.iter().flat_map(|it| &it.entries) {
                base.insert("entry", entry);
                add(&base);
            }
        }
    }
    files
}

fn base(package: &context::Package) -> Context {
    Context::from_serialize(package).expect("a struct becomes a context")
}

fn text(template: &str, context: &Context) -> String {
    Tera::one_off(template, context, false).expect("the templates render: a test renders them")
}
