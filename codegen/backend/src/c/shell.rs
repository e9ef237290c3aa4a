//! The frame around the body of a file: banner, guards, includes. The text is in
//! `codegen/backend/templates/`. A header that computes by itself states and checks what a source does.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};

use tera::{Context, Tera};

use super::print::comment_lines;

/// The mark that the body takes the place of.
const BODY: &str = "\u{1}body\u{1}";

/// Pragmas against contraction, per file in a source, and per function in a header, since other files include it.
pub const NO_CONTRACTION: &str = include_str!("../../templates/contraction.tera");

/// Data of a file's template.
pub struct Shell<'a> {
    /// `height.h`.
    pub file: &'a str,
    /// `height.h` in `height.c`.
    pub header: &'a str,
    /// A line that says what is inside.
    pub summary: &'a str,
    /// Author's comment of its module.
    pub about: &'a [String],
    /// The Rust modules it comes from.
    pub source: &'a str,
    /// The SPDX expression.
    pub license: &'a str,
    /// `<…>`, sorted.
    pub system_includes: Vec<String>,
    /// `"…"`, sorted.
    pub own_includes: Vec<String>,
    /// True if it declares functions: then it says what they ask of their callers.
    pub calls: bool,
    /// True if it refuses compilers that would compute other bits.
    pub refuses: bool,
    /// True if it is a header of which others, too, may include what computes.
    pub computes: bool,
}

/// The text before and after the body. `links`: whether it declares what other files define, which C++ is reported.
pub fn frame(shell: &Shell<'_>, is_header: bool, links: bool) -> (String, String) {
    let template = if is_header {
        include_str!("../../templates/header.h.tera")
    } else {
        include_str!("../../templates/source.c.tera")
    };
    let text = rendered(shell, is_header, links, template);
    let (before, after) = text.split_once(BODY).expect("the templates have a body");
    (before.to_owned(), after.to_owned())
}

/// The text of a file that is a template as a whole, but for a body.
pub fn whole(shell: &Shell<'_>, template: &'static str, body: &str) -> String {
    rendered(shell, false, false, template).replacen(BODY, body, 1)
}

fn rendered(shell: &Shell<'_>, is_header: bool, links: bool, template: &'static str) -> String {
    let mut context = Context::new();
    context.insert("file", shell.file);
    context.insert("header", shell.header);
    context.insert("summary", shell.summary);
    context.insert("about", &about(shell.about));
    context.insert("source", shell.source);
    context.insert("license", shell.license);
    context.insert("guard", &guard(shell.file));
    context.insert("system_includes", &shell.system_includes);
    context.insert("own_includes", &shell.own_includes);
    context.insert("is_header", &is_header);
    context.insert("links", &links);
    context.insert("calls", &shell.calls);
    context.insert("refuses", &shell.refuses);
    context.insert("computes", &shell.computes);
    context.insert("body", BODY);
    parsed(template).render("file", &context).expect("the templates render: a test renders them")
}

/// A template, with those that it includes. It is parsed once: a package has hundreds of files.
fn parsed(template: &'static str) -> Arc<Tera> {
    static PARSED: Mutex<BTreeMap<&str, Arc<Tera>>> = Mutex::new(BTreeMap::new());
    let parse = || {
        let mut tera = Tera::default();
        let parts = [
            ("conditions", include_str!("../../templates/conditions.tera")),
            ("checks", include_str!("../../templates/checks.tera")),
            ("rounding", include_str!("../../templates/rounding.tera")),
            ("contraction", NO_CONTRACTION),
            ("file", template),
        ];
        tera.add_raw_templates(parts).expect("the templates parse: a test renders them");
        Arc::new(tera)
    };
    let mut parsed = PARSED.lock().unwrap_or_else(PoisonError::into_inner);
    Arc::clone(parsed.entry(template).or_insert_with(parse))
}

/// The lines of a comment, behind an empty one.
fn about(lines: &[String]) -> String {
    let lines = comment_lines(lines).into_iter();
    let text: String =
        lines.map(|line| format!(" * {line}").trim_end().to_owned() + "\n").collect();
    if text.is_empty() { text } else { format!(" *\n{text}") }
}

/// `height.h` → `HEIGHT_H`, `acme/height.h` → `ACME_HEIGHT_H`.
fn guard(file: &str) -> String {
    file.replace(['.', '-', '/'], "_").to_uppercase()
}
