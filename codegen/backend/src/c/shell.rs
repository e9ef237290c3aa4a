//! Text around the body of a file: banner, guards, includes. It is in `codegen/backend/templates/`. A header that
//! computes has the statements and checks of a source.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};

use tera::{Context, Tera};

use super::comments::comment_lines;

/// Mark in a template that the body replaces.
const BODY: &str = "\u{1}body\u{1}";

/// Pragmas against contraction, per file in a source, and per function in a header, since other files include it.
pub const NO_CONTRACTION: &str = include_str!("../../templates/contraction.tera");

/// Data of a file's template.
pub struct Shell<'a> {
    /// File name, `height.h`.
    pub file: &'a str,
    /// Header of a source: `height.h` for `height.c`.
    pub header: &'a str,
    /// One line about the content.
    pub summary: &'a str,
    /// Author's comment of the module.
    pub about: &'a [String],
    /// Rust modules of the content.
    pub source: &'a str,
    /// SPDX licence expression.
    pub license: &'a str,
    /// True if it may have pragmas.
    pub pragmas: bool,
    /// Included system headers, `<…>`, sorted.
    pub system_includes: Vec<String>,
    /// Included headers of the package, `"…"`, sorted.
    pub own_includes: Vec<String>,
    /// True if it declares functions; then it states the preconditions of callers.
    pub calls: bool,
    /// True if it refuses compilers that compute other bits.
    pub refuses: bool,
    /// True if it is a header with computing functions that other files may include.
    pub computes: bool,
}

/// Returns the text before and after the body. `links` is true if the file declares functions that other files
/// define, which needs `extern "C"` in C++.
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

/// Returns a file whose whole text is a template with a body.
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
    context.insert("pragmas", &shell.pragmas);
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

/// Returns a template with the templates that it includes. It is parsed once, since a package has hundreds of files.
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

/// Returns the lines of a comment, after an empty one.
fn about(lines: &[String]) -> String {
    let lines = comment_lines(lines).into_iter();
    let text: String =
        lines.map(|line| format!(" * {line}").trim_end().to_owned() + "\n").collect();
    if text.is_empty() { text } else { format!(" *\n{text}") }
}

/// Returns the include guard: `HEIGHT_H` for `height.h`, `ACME_HEIGHT_H` for `acme/height.h`.
fn guard(file: &str) -> String {
    file.replace(['.', '-', '/'], "_").to_uppercase()
}
