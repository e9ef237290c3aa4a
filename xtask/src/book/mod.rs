//! `cargo xtask book`: builds the book with mdBook, with a search: the pages that its contents list.
//!
//! mdBook requires all pages in one folder. So the pages are copied below `target/book/` with adjusted links. Other
//! files that they link are copied as text. The programs of [`algorithms`] become pages.
//!
//! Invariants: nothing below `docs/` changes; no link leads to a folder of this machine.
//!
//! What it must not know: the contents of the pages.

pub mod algorithms;

use crate::error::{Error, Outcome};
use crate::stages::{self, Progress};
use crate::tools::Machine;
use std::collections::BTreeSet;
use std::path::Path;
use std::process::Command;

/// Path of the contents, relative to the folder of the pages.
const SUMMARY: &str = "book/SUMMARY.md";
const PAGES: &str = "docs";
const PICTURES: &str = "docs/figures";
/// Folder of the pictures, relative to that of the pages.
const FIGURES: &str = "figures";
/// Folder in the book for linked files that are not pages.
const FILES: &str = "files";
/// Line of the contents before which the chapter of algorithms is inserted.
const BEFORE: &str = "- [Reference](";
const TARGET: &str = "target/book";
const SETTINGS: &str = "[book]\ntitle = \"Bessemer\"\nlanguage = \"en\"\nsrc = \"pages\"\n\n[build]\nbuild-dir = \"html\"\n";
/// Command that installs mdBook.
pub const INSTALL: &str = "cargo install mdbook";

/// Builds the pages.
///
/// # Errors
/// [`Error::NoBookTool`] without mdBook, [`Error::File`] if a page cannot be copied, [`Error::Stage`] if mdBook fails.
pub fn run(root: &Path, machine: &dyn Machine) -> Result<Outcome, Error> {
    if machine.version("mdbook").is_none() {
        return Err(Error::NoBookTool);
    }
    let target = root.join(TARGET);
    copy(root, &target.join("pages"))?;
    write(&target.join("book.toml"), SETTINGS)?;
    let stage = "book";
    let mut mdbook = Command::new("mdbook");
    mdbook.arg("build").arg(&target);
    let status = Progress::default().closed(stage, |voice| stages::captured(&mut mdbook, voice))?;
    if !status.success() {
        return Err(Error::Stage { stage, status, remedy: None });
    }
    anstream::println!("{}", target.join("html/index.html").display());
    Ok(Outcome::Good)
}

/// Copies the contents, the pages that they list, and the pictures.
fn copy(root: &Path, to: &Path) -> Result<(), Error> {
    let pages = root.join(PAGES);
    let summary = read(&pages.join(SUMMARY))?;
    let listed: BTreeSet<String> = targets(&summary).map(|it| resolved(SUMMARY, it)).collect();
    for page in &listed {
        let text = read(&pages.join(page))?;
        for file in targets(&text).filter_map(|it| linked(it, page, &listed, root)) {
            write(&to.join(as_text(&file)), &read(&root.join(&file))?)?;
        }
        write(&to.join(placed(page)), &relinked(&text, page, &listed, root))?;
    }
    let contents = replaced(&summary, |target| placed(&resolved(SUMMARY, target)).to_owned());
    let (before, after) = contents.split_at(contents.find(BEFORE).unwrap_or(contents.len()));
    write(&to.join("SUMMARY.md"), &format!("{before}{}{after}", algorithms::contents()))?;
    for (page, text) in algorithms::pages(root)? {
        write(&to.join(page), &text)?;
    }
    for picture in std::fs::read_dir(root.join(PICTURES)).into_iter().flatten().flatten() {
        let (from, to) = (picture.path(), to.join(FIGURES).join(picture.file_name()));
        std::fs::create_dir_all(to.parent().unwrap_or(&to))
            .and_then(|()| std::fs::copy(&from, to))
            .map_err(|source| Error::File { path: from, source })?;
    }
    Ok(())
}

/// Returns the path of a page in the book. The book's own pages are at the top, since the first of them is the front
/// page.
fn placed(page: &str) -> &str {
    page.strip_prefix("book/").unwrap_or(page)
}

/// Returns the path, from the root, of a linked file that is not a page of the book.
fn linked(target: &str, page: &str, listed: &BTreeSet<String>, root: &Path) -> Option<String> {
    let path = target.split('#').next().filter(|it| is_path(it) && !it.contains("://"))?;
    let meant = resolved(page, path);
    if listed.contains(&meant) || meant.starts_with(FIGURES) {
        return None;
    }
    let file = resolved(&format!("{PAGES}/{page}"), path);
    root.join(&file).is_file().then_some(file)
}

/// Returns the path of a linked file in the book; its ending makes browsers show it as text.
fn as_text(file: &str) -> String {
    format!("{FILES}/{file}.txt")
}

/// Adjusts the links of a page to the paths in the book. A link to a folder would lead nowhere, so it leads to the
/// top of its own page.
fn relinked(text: &str, page: &str, listed: &BTreeSet<String>, root: &Path) -> String {
    replaced(text, |target| {
        let (path, anchor) = target.find('#').map_or((target, ""), |at| target.split_at(at));
        if path.is_empty() || path.contains("://") {
            return target.to_owned();
        }
        let up = "../".repeat(placed(page).matches('/').count());
        if let Some(file) = linked(target, page, listed, root) {
            return format!("{up}{}", as_text(&file));
        }
        let meant = resolved(page, path);
        if !listed.contains(&meant) && !meant.starts_with(FIGURES) {
            return "#".to_owned();
        }
        // mdBook calls the page of a folder so.
        let there = match placed(&meant).strip_suffix("README.md") {
            Some(folder) => format!("{folder}index.md"),
            None => placed(&meant).to_owned(),
        };
        format!("{up}{there}{anchor}")
    })
}

/// Returns true if the target of a link is a path. Brackets in code can look like links.
fn is_path(target: &str) -> bool {
    target.contains(['/', '.', '#']) && !target.contains([' ', '"', ',', '|', '&'])
}

/// Returns a page with replaced link targets.
fn replaced(text: &str, target: impl Fn(&str) -> String) -> String {
    let mut parts = text.split("](");
    let mut whole = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let end = part.find([')', '\n']).unwrap_or(part.len());
        let (old, rest) = part.split_at(end);
        whole += "](";
        whole += &if is_path(old) && rest.starts_with(')') { target(old) } else { old.to_owned() };
        whole += rest;
    }
    whole
}

/// Returns the targets of the links in a page.
fn targets(text: &str) -> impl Iterator<Item = &str> {
    text.split("](").skip(1).filter_map(|rest| rest.split([')', '\n']).next())
}

/// Resolves a path relative to a page. The result may be outside the pages' folder.
fn resolved(page: &str, target: &str) -> String {
    let mut parts: Vec<&str> = page.split('/').collect();
    parts.pop();
    for part in target.split('/') {
        match part {
            ".." if parts.last().is_some_and(|it| *it != "..") => _ = parts.pop(),
            part => parts.push(part),
        }
    }
    parts.join("/")
}

fn read(path: &Path) -> Result<String, Error> {
    std::fs::read_to_string(path).map_err(|source| Error::File { path: path.into(), source })
}

fn write(path: &Path, text: &str) -> Result<(), Error> {
    std::fs::create_dir_all(path.parent().unwrap_or(path))
        .and_then(|()| std::fs::write(path, text))
        .map_err(|source| Error::File { path: path.into(), source })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn links_between_pages_stay_and_others_lead_to_copies() {
        let listed = ["book/README.md", "book/cookbook/README.md", "kernels.md"];
        let listed = listed.map(str::to_owned).into();
        let page = "[a](../../kernels.md#x) [b](../../../README.md#y) [c](#y) [d](https://e.org) [e](../README.md) ![f](../../figures/f.svg) [g](../../../tests)";
        let expected = "[a](../kernels.md#x) [b](../files/README.md.txt) [c](#y) [d](https://e.org) [e](../index.md) ![f](../figures/f.svg) [g](#)";
        let root = crate::project::root();
        assert_eq!(relinked(page, "book/cookbook/README.md", &listed, &root), expected);
    }

    #[test]
    fn what_the_contents_list_is_copied() {
        let folder = tempfile::tempdir().expect("a folder");
        copy(&crate::project::root(), folder.path()).expect("the pages are there");
        let contents = read(&folder.path().join("SUMMARY.md")).expect("the contents");
        assert!(contents.contains("](tutorial.md)") && contents.contains("](kernels.md)"));
        for target in targets(&contents) {
            let page = read(&folder.path().join(target)).expect("a page");
            assert!(!page.contains("file://"), "{target}");
            let (inside, _) = target.rsplit_once('/').unwrap_or_default();
            for linked in targets(&page).filter(|it| it.contains("files/")) {
                let path = resolved(&format!("{inside}/page"), linked);
                let path = folder.path().join(path.trim_start_matches('/'));
                assert!(path.is_file(), "{target}: {linked}");
            }
        }
    }

    /// A section of a page: its page, its title and its text, in words.
    struct Section {
        page: String,
        title: Vec<String>,
        text: Vec<String>,
    }

    fn words(text: &str) -> Vec<String> {
        let words = text.split(|it: char| !it.is_alphanumeric()).filter(|it| !it.is_empty());
        words.map(str::to_lowercase).collect()
    }

    /// The sections of all pages, in the form of mdBook's index.
    fn sections(folder: &Path) -> Vec<Section> {
        let contents = read(&folder.join("SUMMARY.md")).expect("the contents");
        let mut sections = Vec::new();
        for target in targets(&contents) {
            let text = read(&folder.join(target)).expect("a page");
            for part in format!("\n{text}").split("\n#").skip(1) {
                let (title, text) = part.split_once('\n').unwrap_or((part, ""));
                let (title, text) = (words(title.trim_start_matches('#')), words(text));
                sections.push(Section { page: target.to_owned(), title, text });
            }
        }
        sections
    }

    /// The page that mdBook's search would list first. Rare words, short fields and titles have more weight.
    fn found<'s>(sections: &'s [Section], query: &str) -> &'s str {
        let query = words(query);
        let weight = |field: &[String], word: &String| {
            let count = field.iter().filter(|it| *it == word).count() as f64;
            count.sqrt() / (field.len().max(1) as f64).sqrt()
        };
        let rarity = |word: &String| {
            let holds = |it: &&Section| it.title.contains(word) || it.text.contains(word);
            1.0 + (sections.len() as f64 / (sections.iter().filter(holds).count() as f64 + 1.0))
                .ln()
        };
        let query: Vec<(String, f64)> =
            query.into_iter().map(|it| (it.clone(), rarity(&it))).collect();
        let score = |it: &Section| {
            let each = query.iter().map(|(word, rarity)| {
                let (title, text) = (weight(&it.title, word), weight(&it.text, word));
                if title + text > 0.0 { rarity * (2.0 * title + text) } else { f64::NEG_INFINITY }
            });
            each.sum::<f64>()
        };
        let first = sections.iter().max_by(|a, b| score(a).total_cmp(&score(b)));
        first.map_or("", |it| &it.page)
    }

    #[test]
    fn a_search_finds_each_word_on_its_page_first() {
        let folder = tempfile::tempdir().expect("a folder");
        let root = crate::project::root();
        copy(&root, folder.path()).expect("the pages are there");
        let sections = sections(folder.path());
        for (query, page) in [
            ("CRC", "blocks/bytes"),
            ("CAN signals", "blocks/bytes"),
            ("FFT", "blocks/spectrum"),
            ("MPC", "blocks/quadratic"),
            ("hysteresis", "blocks/limits"),
            ("notch", "blocks/filters"),
            ("moving average", "blocks/windows"),
            ("timeout", "blocks/logic"),
            ("ring buffer", "blocks/bytes"),
            ("transfer function", "blocks/filters"),
            ("2-D table", "blocks/tables"),
            ("EKF", "algorithms/attitude_filter"),
        ] {
            assert_eq!(found(&sections, query), format!("{page}.md"), "{query}");
        }
        let programs = std::fs::read_dir(root.join(algorithms::PROGRAMS)).expect("programs");
        let programs = programs.flatten().map(|it| it.path().with_extension(""));
        let programs: BTreeSet<String> = programs
            .filter_map(|it| Some(it.file_name()?.to_string_lossy().into_owned()))
            .collect();
        let titled = algorithms::TITLES.iter().map(|it| it.0.to_owned()).collect();
        assert_eq!(programs, titled, "each program has a title");
    }
}
