//! A file of its items: the shell around them, the text, and the map.

use super::context::Context;
use super::file::CFile;
use super::print::Printer;
use super::shell::{Shell, frame};
use super::tree::Item;

pub(super) fn assemble(
    context: Context<'_>,
    name: &str,
    shell: &Shell<'_>,
    is_header: bool,
    items: &[Item],
) -> CFile {
    let (before, after) = frame(shell, is_header);
    let first_line = before.matches('\n').count() as u32 + 1;
    let mut printer = Printer::new(&context.module.files, first_line);
    let mut before_it: Option<&Item> = None;
    for item in items {
        // Constants stand together, and so do prototypes without a comment.
        let together = match (before_it, item) {
            (None, _) => true,
            (Some(Item::Constant { .. }), Item::Constant { docs, .. }) => docs.is_empty(),
            (Some(Item::Prototype { .. }), Item::Prototype { docs, .. }) => docs.is_empty(),
            _ => false,
        };
        printer.item(item, !together);
        before_it = Some(item);
    }
    let (body, map) = printer.finish();
    let text = format!("{before}{body}{}", after.trim_start_matches('\n'));
    let text = if is_header {
        text.replacen("#ifdef __cplusplus\n}", "\n#ifdef __cplusplus\n}", 1)
    } else {
        text
    };
    CFile { name: name.to_owned(), text, map }
}
