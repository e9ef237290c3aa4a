//! Links of pages, and pages that anything else names.

use std::collections::{BTreeMap, BTreeSet};

use super::shared::{File, files, none, root};
use super::{pages, prose, resolved};

/// A line without what is in backticks.
fn without_code(line: &str) -> String {
    line.split('`').step_by(2).collect::<Vec<_>>().join("`")
}

/// The targets of the links in a line.
fn targets(line: &str) -> Vec<String> {
    // The words of a link may be code, its target is none.
    let plain = without_code(line);
    let ends = plain.split("](").skip(1).filter_map(|rest| rest.split(')').next());
    ends.map(str::to_owned).collect()
}

/// The anchors of a page: its headings as GitHub and mdBook name them.
fn anchors(page: &File) -> BTreeSet<String> {
    let mut times: BTreeMap<String, usize> = BTreeMap::new();
    let mut found = BTreeSet::new();
    for (_, line) in prose(&page.text).into_iter().filter(|(_, line)| line.starts_with('#')) {
        let words = line.trim_start_matches('#').trim().to_lowercase();
        let kept = words.chars().filter(|it| it.is_alphanumeric() || " -_".contains(*it));
        let anchor: String = kept.map(|it| if it == ' ' { '-' } else { it }).collect();
        let before = times.entry(anchor.clone()).or_default();
        found.insert(if *before == 0 { anchor } else { format!("{anchor}-{before}") });
        *before += 1;
    }
    found
}

#[test]
fn every_link_leads_somewhere() {
    let pages = pages();
    let anchors: BTreeMap<&str, BTreeSet<String>> =
        pages.iter().map(|page| (page.path.as_str(), anchors(page))).collect();
    let mut offences = Vec::new();
    let mut count = 0;
    for page in &pages {
        for (number, line) in prose(&page.text) {
            for target in targets(line) {
                if target.starts_with("https://") || target.starts_with("http://") {
                    continue;
                }
                count += 1;
                let (path, anchor) = target.split_once('#').unwrap_or((&target, ""));
                let path = match path {
                    "" => Some(page.path.clone()),
                    _ => resolved(&page.path, path),
                };
                let there = path.as_ref().is_some_and(|path| {
                    let known = || anchors.get(path.as_str()).is_some_and(|it| it.contains(anchor));
                    root().join(path).exists() && (anchor.is_empty() || known())
                });
                if !there {
                    offences.push(format!("{}:{number}: {target}", page.path));
                }
            }
        }
    }
    assert!(count > 100, "the links were not found");
    none("a link leads to a file, and to a heading of it", &offences);
}

/// Comments and messages name pages, too. What a test writes on demand, to `docs/results/`, need not be there.
#[test]
fn every_page_that_is_named_is_there() {
    let mut offences = Vec::new();
    for file in files().iter().filter(|file| file.path != "CHANGELOG.md") {
        for (index, line) in file.text.lines().enumerate() {
            for rest in line.split("docs/").skip(1) {
                let is_of_path = |it: char| it.is_ascii_alphanumeric() || "/-_.".contains(it);
                let end = rest.find(|it| !is_of_path(it)).unwrap_or(rest.len());
                let path = rest[..end].trim_end_matches('.');
                let is_page = path.ends_with(".md") && !path.starts_with("results/");
                if is_page && !root().join("docs").join(path).exists() {
                    offences.push(format!("{}:{}: docs/{path}", file.path, index + 1));
                }
            }
        }
    }
    none("a page that is named is there", &offences);
}

/// Checks that the contents of the book list every page, since others are not found.
#[test]
fn the_contents_of_the_book_list_every_page() {
    let pages = pages();
    let book = |page: &&File| page.path.starts_with("docs/book/");
    let summary = pages.iter().find(|page| page.path == "docs/book/SUMMARY.md");
    let summary = summary.expect("docs/book/SUMMARY.md");
    let listed: BTreeSet<String> = (summary.text.lines().flat_map(targets))
        .filter_map(|target| resolved(&summary.path, &target))
        .collect();
    let missing = pages.iter().filter(book).filter(|page| page.path != summary.path);
    let missing = missing.filter(|page| !listed.contains(&page.path)).map(|page| page.path.clone());
    none("docs/book/SUMMARY.md lists each page of the book", &missing.collect::<Vec<_>>());
}
