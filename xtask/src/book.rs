//! `cargo xtask book`: the book, and the pages that its contents list, as pages with a search, by mdBook.
//!
//! The pages read well as they are; mdBook wants those of a book in one folder. So they are copied below
//! `target/book/`, with links that lead there, and links to anything else that lead to this checkout.
//!
//! Invariant: nothing below `docs/` changes.
//!
//! What it must not know: what the pages say.

use crate::error::{Error, Outcome};
use crate::stages::{self, Progress};
use crate::tools::Machine;
use std::collections::BTreeSet;
use std::path::Path;
use std::process::Command;

/// The contents, from the folder of the pages.
const SUMMARY: &str = "book/SUMMARY.md";
const PAGES: &str = "docs";
const PICTURES: &str = "docs/figures";
/// Their folder, from that of the pages.
const FIGURES: &str = "figures";
const TARGET: &str = "target/book";
const SETTINGS: &str = "[book]\ntitle = \"Bessemer\"\nlanguage = \"en\"\nsrc = \"pages\"\n\n[build]\nbuild-dir = \"html\"\n";
/// Installs mdBook.
pub const INSTALL: &str = "cargo install mdbook";

/// Makes the pages.
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
        let text = relinked(&read(&pages.join(page))?, page, &listed, root);
        write(&to.join(placed(page)), &text)?;
    }
    let contents = replaced(&summary, |target| placed(&resolved(SUMMARY, target)).to_owned());
    write(&to.join("SUMMARY.md"), &contents)?;
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

/// A page whose links lead to where the pages go, and those to what is not copied to the checkout.
fn relinked(text: &str, page: &str, listed: &BTreeSet<String>, root: &Path) -> String {
    replaced(text, |target| {
        let (path, anchor) = target.find('#').map_or((target, ""), |at| target.split_at(at));
        if path.is_empty() || path.contains("://") {
            return target.to_owned();
        }
        let meant = resolved(page, path);
        if !listed.contains(&meant) && !meant.starts_with(FIGURES) {
            return format!("file://{}{anchor}", root.join(PAGES).join(&meant).display());
        }
        let up = "../".repeat(placed(page).matches('/').count());
        // mdBook calls the page of a folder so.
        let there = match placed(&meant).strip_suffix("README.md") {
            Some(folder) => format!("{folder}index.md"),
            None => placed(&meant).to_owned(),
        };
        format!("{up}{there}{anchor}")
    })
}

/// A page with other targets of its links.
fn replaced(text: &str, target: impl Fn(&str) -> String) -> String {
    let mut parts = text.split("](");
    let mut whole = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let end = part.find([')', '\n']).unwrap_or(part.len());
        let (old, rest) = part.split_at(end);
        // Code has brackets, too: what is no path stays.
        let is_path = old.contains(['/', '.', '#']) && !old.contains([' ', '"', ',', '|', '&']);
        whole += "](";
        whole += &if is_path && rest.starts_with(')') { target(old) } else { old.to_owned() };
        whole += rest;
    }
    whole
}

/// The targets of the links in a page.
fn targets(text: &str) -> impl Iterator<Item = &str> {
    text.split("](").skip(1).filter_map(|rest| rest.split([')', '\n']).next())
}

/// A path from the folder of the pages, as a page means it. It may lead out of that folder.
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
    fn links_between_pages_stay_and_others_lead_to_the_checkout() {
        let listed = ["book/README.md", "book/cookbook/README.md", "kernels.md"];
        let listed = listed.map(str::to_owned).into();
        let page = "[a](../../kernels.md#x) [b](../../../README.md) [c](#y) [d](https://e.org) [e](../README.md) ![f](../../figures/f.svg)";
        let expected = "[a](../kernels.md#x) [b](file:///here/docs/../README.md) [c](#y) [d](https://e.org) [e](../index.md) ![f](../figures/f.svg)";
        assert_eq!(
            relinked(page, "book/cookbook/README.md", &listed, Path::new("/here")),
            expected
        );
    }

    #[test]
    fn what_the_contents_list_is_copied() {
        let folder = tempfile::tempdir().expect("a folder");
        copy(&crate::project::root(), folder.path()).expect("the pages are there");
        let contents = read(&folder.path().join("SUMMARY.md")).expect("the contents");
        assert!(contents.contains("](tutorial.md)") && contents.contains("](kernels.md)"));
        for target in targets(&contents) {
            assert!(folder.path().join(target).is_file(), "{target}");
        }
    }
}
