//! Quotations: the code block behind `<!-- from: FILE -->` is in that file, word for word.

use super::pages;
use super::shared::{none, root};

/// Before the name of the file that is quoted.
const FROM: &str = "<!-- from: ";

/// In a template stand these for the package that the pages begin.
const NAMES: [(&str, &str); 3] = [("@PACKAGE@", "motor"), ("@NAME@", "motor"), ("@Name@", "Motor")];

/// The files that a page quotes, each with what it quotes.
fn quotations(page: &str) -> Vec<(&str, Option<&str>)> {
    let marks = page.split(FROM).skip(1);
    let quoted = marks.filter_map(|rest| {
        let (file, rest) = rest.split_once(" -->\n")?;
        let block = rest.trim_start().strip_prefix("```");
        let block = block.and_then(|it| it.split_once('\n')).map(|(_, block)| block);
        Some((file, block.and_then(|it| it.split("\n```").next())))
    });
    quoted.collect()
}

#[test]
fn what_is_quoted_stands_in_its_file() {
    let mut offences = Vec::new();
    let mut count = 0;
    for page in pages() {
        for (file, block) in quotations(&page.text) {
            count += 1;
            let mut text = std::fs::read_to_string(root().join(file)).unwrap_or_default();
            for (hole, name) in NAMES.iter().filter(|_| file.starts_with("cli/templates/")) {
                text = text.replace(hole, name);
            }
            if !block.is_some_and(|block| text.contains(block)) {
                offences.push(format!("{}: {file}\n{}", page.path, block.unwrap_or("no code")));
            }
        }
    }
    assert!(count > 5, "the quotations were not found");
    none("a quotation stands in its file, word for word", &offences);
}

#[test]
fn a_quotation_is_the_block_behind_its_mark() {
    let page = "<!-- from: a.rs -->\n```rust\nlet x;\nlet y;\n```\n<!-- from: b.rs -->\nNo code.\n";
    assert_eq!(quotations(page), [("a.rs", Some("let x;\nlet y;")), ("b.rs", None)]);
}
