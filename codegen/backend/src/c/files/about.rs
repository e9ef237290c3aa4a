//! Head comment of a file: the author's `//!` comment of the module for which the file is named.

use super::{Callable, TypeId, Writer, place, type_span};
use crate::c::spelling::{identifier, last_segment};

impl Writer<'_> {
    /// Returns the author's comment of the file's module; a header that has a source gets the first paragraph.
    pub(super) fn about(&self, extension: &str) -> &[String] {
        let module = self.context.module;
        let types = self.unit.types.iter().map(|id| match id {
            TypeId::Struct(id) => {
                (&module.structs[id.index()].module, type_span(self.context, TypeId::Struct(*id)))
            }
            TypeId::Enum(id) => {
                (&module.enums[id.index()].module, type_span(self.context, TypeId::Enum(*id)))
            }
        });
        let functions = self.unit.functions.iter().filter_map(|callable| match callable {
            Callable::Function(id) => Some(&module.functions[id.index()]),
            Callable::Init(_) => None,
        });
        let all = types.chain(functions.map(|function| (&function.module, function.span)));
        let about = all.into_iter().find_map(|(path, span)| {
            let (file, ..) = place(self.context, span);
            let name = last_segment(path);
            let own = self.name.ends_with(&identifier(&name)) && is_of(&file, &name);
            module.about.get(&file).filter(|_| own)
        });
        let about = about.map_or(&[][..], Vec::as_slice);
        let paragraph = about.iter().position(String::is_empty).unwrap_or(about.len());
        match extension == "h" && !self.unit.functions.is_empty() {
            true => &about[..paragraph],
            false => about,
        }
    }
}

/// Returns true if the Rust file contains the module with this name.
fn is_of(file: &str, name: &str) -> bool {
    let path = file.strip_suffix(".rs").unwrap_or(file);
    let path = path.strip_suffix("/mod").unwrap_or(path);
    path.rsplit('/').next() == Some(name)
}
