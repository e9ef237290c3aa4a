//! Header of the helpers, which all sources share and firmware does not include.
//!
//! Invariants: it contains exactly the helpers that the sources call. A source's own text does not depend on the
//! other helpers in it. It includes the target header before it computes, so it may be included first.

use std::collections::BTreeSet;

use super::asked;
use super::assemble::assemble;
use super::context::Context;
use super::file::CFile;
use super::helpers::{Helper, closure};
use super::options::Options;
use super::shell::Shell;
use super::spelling::identifier;
use super::target;
use super::tree::Item;

/// Returns the header's name.
pub fn name(options: &Options) -> String {
    options.header(&format!("{}_helpers", identifier(&options.status)))
}

/// Returns the header of these helpers; none if there are none.
pub fn header(
    context: Context<'_>,
    options: &Options,
    helpers: &BTreeSet<Helper>,
) -> Option<CFile> {
    let helpers = closure(helpers);
    if helpers.is_empty() {
        return None;
    }
    let name = name(options);
    let mut system = vec!["stdbool.h".to_owned(), "stdint.h".to_owned()];
    system.extend(helpers.iter().any(|it| it.needs_math()).then(|| "math.h".to_owned()));
    system.extend(helpers.iter().any(|it| it.needs_string()).then(|| "string.h".to_owned()));
    system.sort();
    let shell = Shell {
        about: &[],
        file: &name,
        header: &name,
        summary: "operations of Rust that C has no operator for; for the sources beside it alone.",
        source: &context.module.name,
        license: &options.license,
        pragmas: options.pragmas,
        system_includes: system,
        own_includes: vec![target::name(options)],
        calls: false,
        refuses: true,
        computes: false,
    };
    let copy = asked::Macro::Copy;
    let copies = helpers.iter().any(|it| it.needs_string()).then(|| copy.text(options));
    // Helpers have no state and write nothing.
    let contract = if options.contracts { "/*@ assigns \\nothing; */\n" } else { "" };
    let begin = format!("{contract}static inline ");
    let texts = helpers.iter().map(|it| it.text(&copy.name(options)));
    let texts = texts.map(|text| text.replace("static inline ", &begin));
    let items: Vec<Item> = copies.into_iter().chain(texts).map(Item::Verbatim).collect();
    Some(assemble(context, &name, &shell, true, &items))
}
