//! docs/language.md shows programs of the corpus as they are, with the C that comes of them.
//!
//! Between `<!-- example: chapter/name -->` and `<!-- end -->` stand the program's own words, its Rust and
//! its C; after `<!-- contents -->` the list of them. `UPDATE_DOCS=1 cargo test -p bessemer-tests language::` writes them anew. Every program of
//! a chapter of the language is on the page, so that nothing is taken that the page does not show.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use bessemer_codegen::compile::Compiled;
use bessemer_tests::{corpus, root};

const PAGE: &str = "docs/language.md";
const PROGRAMS: &str = "tests/corpus/src/programs";
/// Before the name of an example.
const EXAMPLE: &str = "<!-- example: ";
/// Folders whose programs are no part of the page.
const APART: [&str; 3] = ["trouble", "algorithms", "kinds"];

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("`{}`: {error}", path.display()))
}

/// What stands between the marks of one example.
fn example(compiled: &Compiled, name: &str) -> String {
    let source = read(&root().join(PROGRAMS).join(format!("{name}.rs")));
    let (prose, rust): (Vec<&str>, Vec<&str>) =
        source.lines().partition(|line| line.starts_with("//!"));
    let mut text = format!("\n### {}\n\n", title(name));
    for line in prose {
        let _ = writeln!(text, "{}", line.trim_start_matches("//!").trim_start());
    }
    let rust = rust.join("\n").replace("use bessemer::prelude::*;\n", "");
    let _ = write!(text, "\n```rust\n{}\n```\n", rust.trim());
    let module = format!("from corpus::programs::{};", name.replace('/', "::"));
    let of_module = || compiled.files.iter().filter(|file| file.text.contains(&module));
    let headers = of_module().filter(|file| file.name.ends_with(".h"));
    let sources = of_module().filter(|file| file.name.ends_with(".c"));
    let parts = headers.map(|file| types(&file.text)).chain(sources.map(|file| body(&file.text)));
    let c = parts.filter(|part| !part.is_empty()).collect::<Vec<_>>().join("\n\n");
    let _ = writeln!(text, "\n```c\n{c}\n```");
    text
}

/// `control/bounded_while` is headed `Bounded while`.
fn title(name: &str) -> String {
    let words = name.rsplit('/').next().unwrap_or_default().replace('_', " ");
    let (first, rest) = words.split_at(1);
    first.to_uppercase() + rest
}

/// The list of the examples, with links.
fn contents(page: &str) -> String {
    let mut text = String::new();
    for line in page.lines() {
        if let Some(chapter) = line.strip_prefix("## ") {
            let _ = write!(text, "\n* {chapter}");
            text.push(':');
        } else if let Some(name) = line.strip_prefix(EXAMPLE) {
            let title = title(name.trim_end_matches(" -->"));
            let link = title.to_lowercase().replace(' ', "-");
            let separator = if text.ends_with(':') { " " } else { " · " };
            let _ = write!(text, "{separator}[{}](#{link})", title.to_lowercase());
        }
    }
    let chapters = text.lines().filter(|line| line.contains('[')).map(|it| format!("{it}\n"));
    format!("\n{}\n", chapters.collect::<String>())
}

/// The types of a header, without the declarations of functions, which the source repeats.
fn types(header: &str) -> String {
    let inside = header.split("extern \"C\" {\n#endif\n").nth(1).unwrap_or_default();
    let inside = inside.split("\n#ifdef __cplusplus").next().unwrap_or_default();
    let blocks = inside.split("\n\n").filter(|block| {
        let code = block.trim_start().trim_start_matches("/**");
        code.contains("typedef") || code.contains("#define")
    });
    blocks.map(str::trim).collect::<Vec<_>>().join("\n\n")
}

/// What follows the head of a source file.
fn body(source: &str) -> String {
    let head = source.rfind("\n#include ").map_or(0, |last| last + 1);
    let body = source[head..].split_once('\n').map(|(_, body)| body);
    body.unwrap_or_default().trim().to_owned()
}

/// The page with every example as it is today.
fn current(compiled: &Compiled, page: &str) -> String {
    let mut text = String::new();
    let mut inside = false;
    for line in page.lines() {
        inside &= line != "<!-- end -->";
        if !inside {
            let _ = writeln!(text, "{line}");
        }
        if let Some(rest) = line.strip_prefix(EXAMPLE) {
            text.push_str(&example(compiled, rest.trim_end_matches(" -->")));
            inside = true;
        } else if line == "<!-- contents -->" {
            text.push_str(&contents(page));
            inside = true;
        }
    }
    text
}

#[test]
fn the_page_shows_the_programs_as_they_are() {
    let page = read(&root().join(PAGE));
    let current = current(corpus(), &page);
    if std::env::var_os("UPDATE_DOCS").is_some() {
        fs::write(root().join(PAGE), current).expect("the page can be written");
    } else {
        let differs = page.lines().zip(current.lines()).position(|(old, new)| old != new);
        assert!(
            page == current,
            "{PAGE} is stale from line {}: UPDATE_DOCS=1 cargo test -p bessemer-tests language::",
            differs.unwrap_or_default() + 1
        );
    }
}

#[test]
fn every_program_of_the_language_is_on_the_page() {
    let page = read(&root().join(PAGE));
    let folder = root().join(PROGRAMS);
    let chapters = fs::read_dir(&folder).expect("the corpus is there").flatten();
    let mut missing = Vec::new();
    for chapter in chapters.filter(|it| it.path().is_dir()) {
        let chapter = chapter.file_name().to_string_lossy().into_owned();
        if APART.contains(&chapter.as_str()) {
            continue;
        }
        for program in fs::read_dir(folder.join(&chapter)).expect("a folder").flatten() {
            let path = program.path();
            let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
            if !page.contains(&format!("{EXAMPLE}{chapter}/{stem} -->")) {
                missing.push(format!("{chapter}/{stem}"));
            }
        }
    }
    missing.sort();
    assert!(missing.is_empty(), "not on {PAGE}: {missing:#?}");
}
