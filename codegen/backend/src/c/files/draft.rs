//! A file before it is printed: its items, its includes, and the data of its shell.

use super::includes::Includes;
use crate::c::assemble::assemble;
use crate::c::context::Context;
use crate::c::file::CFile;
use crate::c::options::Options;
use crate::c::shell::Shell;
use crate::c::tree::{Item, Storage};

/// A file that is not printed yet.
pub(super) struct Draft {
    /// Name of the file.
    pub name: String,
    /// Header of a source; the file itself if it is a header.
    pub header: String,
    /// One line about the content.
    pub summary: String,
    /// Author's comment of the module.
    pub about: Vec<String>,
    /// Rust modules of the content.
    pub source: String,
    /// True if it is a header that firmware may include.
    pub public: bool,
    /// True if it is a header with computing functions that other files may include.
    pub computes: bool,
    /// Items in order.
    pub items: Vec<Item>,
    /// Includes.
    pub includes: Includes,
}

impl Draft {
    /// Prints the file.
    pub fn print(self, context: Context<'_>, options: &Options) -> CFile {
        let shell = Shell {
            about: &self.about,
            file: &self.name,
            header: &self.header,
            summary: &self.summary,
            source: &self.source,
            license: &options.license,
            pragmas: options.pragmas,
            system_includes: self.includes.system(),
            own_includes: self.includes.own(&self.header),
            calls: self.public && self.items.iter().any(declares),
            refuses: true,
            computes: self.computes,
        };
        let is_header = self.name == self.header;
        assemble(context, &self.name, &shell, is_header, &self.items)
    }
}

/// Returns true if the item declares a function that other files may call.
fn declares(item: &Item) -> bool {
    match item {
        Item::Prototype { .. } => true,
        Item::Function { head, .. } => head.storage == Storage::Inline,
        _ => false,
    }
}
