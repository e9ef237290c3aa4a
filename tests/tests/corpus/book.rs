//! The book, docs/book/, with programs of the corpus and some lines of the C of each. The whole C of each is golden, in
//! `tests/corpus/golden/`.
//!
//! Between `<!-- example: chapter/name -->` and `<!-- end -->` stand the program's own words, its Rust, at most
//! [`LINES`] lines of its C and a link to all of it; ` of NAME` behind the name chooses the function or type whose C is
//! shown. After `<!-- contents -->` stands the list of a page's examples, after `<!-- mistakes -->` the table of newcomers'
//! mistakes, after `<!-- blocks: pid of pid_f32_step -->` the documentation of a module of blocks
//! and some of its C. `UPDATE_DOCS=1 cargo test -p bessemer-tests
//! book::` writes pages and golden files anew. Every program of a chapter of the language is on one page, so that
//! nothing is taken that the book does not show.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

use super::{blocks, mistakes};
use bessemer_codegen::compile::Compiled;
use bessemer_tests::{corpus, golden, root};

const BOOK: &str = "docs/book";
const PROGRAMS: &str = "tests/corpus/src/programs";
const GOLDEN: &str = "tests/corpus/golden";
/// The header of the functions that stand where they are called, which is golden as it is.
const INLINE: &str = "bessemer_inline.h";
/// Before the name of an example.
const EXAMPLE: &str = "<!-- example: ";
/// Folders whose programs are not part of the book.
const APART: [&str; 3] = ["corner_cases", "algorithms", "kinds"];
/// The folder of the golden files that are those of the package which the tutorial begins (`tests/tests/command.rs`).
const TUTORIAL: &str = "tutorial";
/// The most lines of C that a page shows of a program.
const LINES: usize = 15;
const ASKED: &str = "UPDATE_DOCS=1 cargo test -p bessemer-tests book::";

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("`{}`: {error}", path.display()))
}

/// The files below a folder that end so, each as its path from there.
fn below(folder: &Path, ending: &str) -> BTreeSet<PathBuf> {
    let mut found = BTreeSet::new();
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let (path, name) = (entry.path(), PathBuf::from(entry.file_name()));
        if path.is_dir() {
            found.extend(below(&path, ending).into_iter().map(|inner| name.join(inner)));
        } else if path.extension().is_some_and(|it| it == ending) {
            found.insert(name);
        }
    }
    found
}

/// The programs of the book, `chapter/name`.
fn programs() -> Vec<String> {
    let files = below(&root().join(PROGRAMS), "rs").into_iter();
    let names = files.map(|path| path.with_extension("").to_string_lossy().replace('\\', "/"));
    names.filter(|name| !name.split('/').any(|folder| APART.contains(&folder))).collect()
}

/// The example that a line begins: the program, and what of its C is shown.
fn marked(line: &str) -> Option<(&str, Option<&str>)> {
    let name = line.strip_prefix(EXAMPLE)?.trim_end_matches(" -->");
    Some(match name.split_once(" of ") {
        Some((name, chosen)) => (name, Some(chosen)),
        None => (name, None),
    })
}

/// The C of a program: of each of its files what is there, without the frame that every file has.
fn whole(compiled: &Compiled, name: &str) -> String {
    let module = format!("corpus::programs::{}", name.replace('/', "::"));
    c_of(compiled, &module, &format!("{PROGRAMS}/{name}.rs"))
}

/// The C of a module, whose source is at a path.
fn c_of(compiled: &Compiled, module: &str, path: &str) -> String {
    let module = format!("from {module};");
    let mut text = format!("/* The C of {path}. Written by a test. */\n");
    for file in compiled.files.iter().filter(|file| file.text.contains(&module)) {
        let inside = match file.name.ends_with(".h") {
            true => declared(&file.text),
            false => defined(&file.text),
        };
        if !inside.is_empty() {
            let _ = write!(text, "\n/* {} */\n\n{inside}\n", file.name);
        }
    }
    text
}

/// The types of a header, without the declarations of functions, which the source repeats.
fn declared(header: &str) -> String {
    // Behind the guard, where it declares no functions.
    let inside = header.split_once("extern \"C\" {\n#endif\n").or(header.split_once("\n#define "));
    let (_, inside) = inside.unwrap_or_default();
    let inside = inside.split("\n#ifdef __cplusplus").next().unwrap_or_default();
    let blocks = inside.split("\n\n").filter(|block| {
        let code = block.trim_start().trim_start_matches("/**");
        code.contains("typedef") || code.contains("#define")
    });
    blocks.map(str::trim).collect::<Vec<_>>().join("\n\n")
}

/// Returns the text after the head of a source file.
fn defined(source: &str) -> String {
    let head = source.rfind("\n#include ").map_or(0, |last| last + 1);
    let body = source[head..].split_once('\n').map(|(_, body)| body);
    body.unwrap_or_default().trim().to_owned()
}

/// The types, constants and functions of a golden file, each with the comment above it.
fn definitions(golden: &str) -> Vec<String> {
    let (mut all, mut one, mut depth) = (Vec::new(), String::new(), 0);
    for line in golden.lines().skip(1) {
        if line.is_empty() && depth == 0 {
            all.push(std::mem::take(&mut one));
        } else {
            let _ = writeln!(one, "{line}");
            depth += line.matches('{').count();
            depth -= line.matches('}').count().min(depth);
        }
    }
    all.push(one);
    // Names of files stand between.
    all.retain(|it| it.lines().count() > 1 || !it.is_empty() && !it.starts_with("/* "));
    all
}

/// A definition without the comment above it.
fn bare(definition: &str) -> &str {
    match definition.strip_prefix("/**").and_then(|rest| rest.split_once("*/\n")) {
        Some((_, code)) => code,
        None => definition,
    }
}

fn is_function(definition: &str) -> bool {
    bare(definition).contains(")\n{\n")
}

/// Returns true if a definition is that of a function or a type of this name.
fn is_called(definition: &str, name: &str) -> bool {
    let code = bare(definition);
    let head = code.split("\n{\n").next().unwrap_or_default();
    is_function(definition) && head.contains(&format!("{name}("))
        || code.contains(&format!("}} {name};"))
}

/// Returns the part of a program's C for a page. It is all of it if short, else the selected function, else the longest
/// function that fits.
fn excerpt(golden: &str, chosen: Option<&str>) -> String {
    let lines = |text: &str| text.lines().count();
    let all = definitions(golden);
    let together = all.iter().map(|it| it.trim_end()).collect::<Vec<_>>().join("\n\n");
    if chosen.is_none() && lines(&together) <= LINES {
        return together;
    }
    let shown = match chosen {
        Some(name) => all.iter().find(|it| is_called(it, name)),
        None => {
            let fits = |it: &&String| lines(bare(it)) <= LINES;
            let fitting = || all.iter().rev().filter(fits);
            let longest = fitting().filter(|it| is_function(it)).max_by_key(|it| lines(bare(it)));
            longest.or_else(|| all.iter().find(|it| is_function(it)))
        }
    };
    let shown = shown.unwrap_or_else(|| panic!("no `{chosen:?}` in\n{golden}"));
    let shown = if lines(shown) <= LINES { shown } else { bare(shown) };
    if lines(shown) <= LINES {
        return shown.trim_end().to_owned();
    }
    let some = shown.lines().take(LINES - 1).chain(["    /* … */"]);
    some.collect::<Vec<_>>().join("\n")
}

/// `control/bounded_while` is headed `Bounded while`.
fn title(name: &str) -> String {
    let words = name.rsplit('/').next().unwrap_or_default().replace('_', " ");
    let (first, rest) = words.split_at(1);
    first.to_uppercase() + rest
}

/// Returns the text between the marks of one example on a page at a depth below the root.
fn example(golden: &str, name: &str, chosen: Option<&str>, depth: usize) -> String {
    let source = read(&root().join(PROGRAMS).join(format!("{name}.rs")));
    let (prose, rust): (Vec<&str>, Vec<&str>) =
        source.lines().partition(|line| line.starts_with("//!"));
    // A recipe has a page, and so a heading, of its own.
    let mut text = match name {
        _ if name.starts_with("cookbook/") => "\n".to_owned(),
        _ if name.starts_with("blocks/") => "\n## Example\n\n".to_owned(),
        _ => format!("\n## {}\n\n", title(name)),
    };
    for line in prose {
        let _ = writeln!(text, "{}", line.trim_start_matches("//!").trim_start());
    }
    let rust = rust.join("\n").replace("use bessemer::prelude::*;\n", "");
    let _ = write!(text, "\n```rust\n{}\n```\n", rust.trim());
    let _ = write!(text, "\n```c\n{}\n```\n", excerpt(golden, chosen));
    let up = "../".repeat(depth);
    let _ = writeln!(text, "\n[All of its C]({up}{GOLDEN}/{name}.c)");
    text
}

/// The list of a page's examples, with links.
fn contents(page: &str) -> String {
    let names = page.lines().filter_map(marked).map(|(name, _)| title(name).to_lowercase());
    let links = names.map(|title| format!("[{title}](#{})", title.replace(' ', "-")));
    format!("\n{}\n\n", links.collect::<Vec<_>>().join(" · "))
}

/// A page with every example as it is today.
fn current(golden: &BTreeMap<String, String>, page: &str, depth: usize) -> String {
    let mut text = String::new();
    let mut inside = false;
    for line in page.lines() {
        inside &= line != "<!-- end -->";
        if !inside {
            let _ = writeln!(text, "{line}");
        }
        if let Some((name, chosen)) = marked(line) {
            let golden = golden.get(name).unwrap_or_else(|| panic!("no program `{name}`"));
            text.push_str(&example(golden, name, chosen, depth));
            inside = true;
        } else if line == "<!-- contents -->" {
            text.push_str(&contents(page));
            inside = true;
        } else if let Some((module, chosen)) = blocks::marked(line) {
            text.push_str(&blocks::documentation(module));
            let (name, up) = (blocks::golden(module), "../".repeat(depth));
            let shown = excerpt(&golden[&name], Some(chosen));
            let _ = write!(
                text,
                "## C\n\n```c\n{shown}\n```\n\n[All of its C]({up}{GOLDEN}/{name}.c)\n\n"
            );
            inside = true;
        } else if line == "<!-- mistakes -->" {
            text.push_str(&mistakes::table(&"../".repeat(depth)));
            inside = true;
        }
    }
    text
}

#[test]
fn pages_and_golden_files_are_as_the_programs_are() {
    let compiled = corpus();
    let mut all: BTreeMap<String, String> =
        programs().into_iter().map(|name| (name.clone(), whole(compiled, &name))).collect();
    // The instances of the blocks that the programs call.
    all.extend(blocks::modules().into_iter().map(|module| {
        let path = format!("{}/{module}.rs", blocks::SOURCES);
        let c = c_of(compiled, &format!("bessemer_blocks::{module}"), &path);
        (blocks::golden(&module), c)
    }));
    let file = |name: &String| Path::new(GOLDEN).join(format!("{name}.c"));
    let mut wanted: BTreeMap<PathBuf, String> =
        all.iter().map(|(name, c)| (file(name), c.clone())).collect();
    // What several programs call, once.
    let inline = compiled.files.iter().filter(|file| file.name == INLINE);
    wanted.extend(inline.map(|file| (Path::new(GOLDEN).join(INLINE), file.text.clone())));
    for path in below(&root().join(BOOK), "md") {
        let path = Path::new(BOOK).join(path);
        let depth = path.components().count() - 1;
        let text = current(&all, &read(&root().join(&path)), depth);
        wanted.insert(path, text);
    }
    let mut stale: Vec<PathBuf> = Vec::new();
    stale.extend(
        wanted
            .iter()
            .filter(|(path, text)| !golden::holds(path, text))
            .map(|(path, _)| path.clone()),
    );
    let held = below(&root().join(GOLDEN), "c").into_iter().filter(|it| !it.starts_with(TUTORIAL));
    stale.extend(held.map(|it| Path::new(GOLDEN).join(it)).filter(|it| !wanted.contains_key(it)));
    assert!(stale.is_empty(), "stale, or of no program: {stale:#?}\n{ASKED}");
}

#[test]
fn every_program_of_the_language_is_on_one_page() {
    let mut times: BTreeMap<String, usize> = programs().into_iter().map(|it| (it, 0)).collect();
    for path in below(&root().join(BOOK), "md") {
        let page = read(&root().join(BOOK).join(path));
        for (name, _) in page.lines().filter_map(marked) {
            *times.entry(name.to_owned()).or_default() += 1;
        }
    }
    times.retain(|_, times| *times != 1);
    assert!(times.is_empty(), "on no page of {BOOK}, or on more than one: {times:#?}");
}

#[test]
fn an_excerpt_is_what_was_chosen_or_the_longest_function_with_room() {
    let function = |name: &str, lines: usize| {
        let body = "    x = 1;\n".repeat(lines);
        format!("/** Says something. */\nvoid {name}(int x)\n{{\n{body}}}\n")
    };
    let golden = format!(
        "/* Head. */\n\n/* a.c */\n\n{}\n{}\n{}",
        function("short", 2),
        function("fit", 8),
        function("long", 30)
    );
    let shown = |chosen| excerpt(&golden, chosen);
    assert!(shown(None).contains("void fit(") && !shown(None).contains("void short("));
    assert!(shown(Some("short")).starts_with("/** Says"));
    let cut = shown(Some("long"));
    assert_eq!((cut.lines().count(), cut.lines().last()), (LINES, Some("    /* … */")));
}
