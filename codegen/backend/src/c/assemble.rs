//! Assembles a file from its items: the enclosing shell, the text, and the map of source lines.

use super::context::Context;
use super::file::CFile;
use super::print::Printer;
use super::shell::{Shell, frame};
use super::tree::{Item, Storage};

pub(super) fn assemble(
    context: Context<'_>,
    name: &str,
    shell: &Shell<'_>,
    is_header: bool,
    items: &[Item],
) -> CFile {
    let (before, after) = frame(shell, is_header, items.iter().any(links));
    let first_line = before.matches('\n').count() as u32 + 1;
    let mut printer = Printer::new(&context.module.files, first_line);
    let mut before_it: Option<&Item> = None;
    for item in items {
        // Constants stand together, and so do prototypes without a comment.
        let together = match (before_it, item) {
            (None, _) => true,
            (Some(Item::Constant { .. }), Item::Constant { docs, .. })
            | (Some(Item::Define { .. }), Item::Define { docs, .. }) => docs.is_empty(),
            (Some(Item::Prototype { .. }), Item::Prototype { docs, .. }) => docs.is_empty(),
            _ => false,
        };
        printer.item(item, !together);
        before_it = Some(item);
    }
    let (body, map) = printer.finish();
    let gap = if is_header { "\n" } else { "" };
    let text = format!("{before}{body}{gap}{}", after.trim_start_matches('\n'));
    CFile { name: name.to_owned(), text, map }
}

/// Returns true if another file than this one defines the item.
fn links(item: &Item) -> bool {
    matches!(item, Item::Prototype { .. } | Item::Constant { storage: Storage::Extern, .. })
}
