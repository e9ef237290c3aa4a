//! Holds random programs to the reference. Each method, statement and attribute of the book's tables is written by some
//! program, or is an exception with a reason.
//!
//! A method is a word of the page, found where the program has it as one: behind a `.` or a `::`, or before a `(`. A row of
//! statements or attributes is found by a text that shows it (`beside/shown.txt`).
//!
//! What it must not know: how a program comes to be.

use std::collections::BTreeMap;

use bessemer_tests::root;

/// `row => text that shows it`, or `row => - reason`.
const SHOWN: &str = include_str!("beside/shown.txt");
/// `word: reason`.
const EXCEPTIONS: &str = include_str!("beside/exceptions.txt");

/// The pages of which each row is to be shown.
const PAGES: [&str; 2] = ["statements.md", "attributes.md"];

/// The words and rows of the reference, each with how often it was written.
pub struct Reference {
    methods: BTreeMap<String, Count>,
    rows: Vec<(String, String, Count)>,
}

/// Numbers of programs that have something, and of these that ran.
#[derive(Clone, Copy, Default)]
struct Count {
    written: usize,
    run: usize,
}

impl Count {
    fn add(&mut self, ran: bool) {
        self.written += 1;
        self.run += usize::from(ran);
    }
}

impl Reference {
    pub fn new() -> Reference {
        let mut methods: BTreeMap<String, Count> = BTreeMap::new();
        for (_, methods_of) in rows(&page("methods.md")) {
            methods.extend(words(&methods_of).into_iter().map(|word| (word, Count::default())));
        }
        for (word, _) in exceptions() {
            methods.remove(word);
        }
        let shown = |(row, text): (&str, &str)| (row.to_owned(), text.to_owned(), Count::default());
        let rows = shown_rows().into_iter().filter(|it| !it.1.starts_with("- "));
        Reference { methods, rows: rows.map(shown).collect() }
    }

    /// Counts what a program has.
    pub fn count(&mut self, text: &str, ran: bool) {
        for word in called(text) {
            if let Some(count) = self.methods.get_mut(word) {
                count.add(ran);
            }
        }
        for (_, shows, count) in &mut self.rows {
            if text.contains(shows.as_str()) {
                count.add(ran);
            }
        }
    }

    /// A line for each: how often it was written, and run.
    pub fn report(&self) -> String {
        let methods = self.methods.iter().map(|(word, count)| (word.as_str(), count));
        let rows = self.rows.iter().map(|(row, _, count)| (row.as_str(), count));
        let line = |(what, count): (&str, &Count)| {
            format!("{:>9} {:>9}  {what}\n", count.written, count.run)
        };
        methods.chain(rows).map(line).collect()
    }

    /// Returns methods and rows that no program has.
    fn missing(&self) -> Vec<&str> {
        let methods = self.methods.iter().filter(|it| it.1.written == 0).map(|it| it.0.as_str());
        let rows = self.rows.iter().filter(|it| it.2.written == 0).map(|it| it.0.as_str());
        methods.chain(rows).collect()
    }
}

fn page(name: &str) -> String {
    let path = root().join("docs/book/reference").join(name);
    std::fs::read_to_string(path).expect("a page of the book")
}

/// The first two cells of each row of a page's tables, without their heads.
fn rows(page: &str) -> Vec<(String, String)> {
    let lines: Vec<&str> = page.lines().collect();
    let of_table = |at: &usize| {
        let is_rule = |at: usize| lines.get(at).is_some_and(|it| it.starts_with("|---"));
        lines[*at].starts_with("| ") && !is_rule(at + 1)
    };
    let cells = |at: usize| {
        let line = lines[at].replace("\\|", "\u{1}");
        let mut cells = line.split('|').skip(1).map(|it| it.trim().replace('\u{1}', "|"));
        (cells.next().unwrap_or_default(), cells.next().unwrap_or_default())
    };
    (0..lines.len()).filter(of_table).map(cells).collect()
}

/// The methods that a cell lists: the words of its spans of code, and the calls in those that are code.
fn words(cell: &str) -> Vec<String> {
    let mut words = Vec::new();
    let (mut prefixes, mut joined) = (Vec::new(), String::new());
    for (at, span) in cell.split('`').enumerate() {
        if at % 2 == 0 {
            // `saturating_` with `add sub`: a part of a word goes before each of the next span.
            if !span.contains("with") && span != " and " {
                prefixes.clear();
            }
            joined = span.to_owned();
            continue;
        }
        let parts: Vec<&str> = span.split_whitespace().collect();
        let is_word = |part: &&str| {
            part.starts_with(|c: char| c.is_ascii_lowercase())
                && part.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
        };
        if parts.len() == 1 && span.ends_with('_') {
            prefixes.push(span);
        } else if parts.iter().all(is_word) {
            match prefixes.is_empty() || !joined.contains("with") {
                true => words.extend(parts.iter().map(|it| (*it).to_owned())),
                false => words.extend(
                    prefixes
                        .iter()
                        .flat_map(|it| parts.iter().map(move |word| format!("{it}{word}"))),
                ),
            }
        } else {
            words.extend(called(span).map(str::to_owned));
        }
    }
    words
}

/// The words of a text that are called or read as parts: behind a `.` or a `::`, or before a `(` or a `!`.
fn called(text: &str) -> impl Iterator<Item = &str> {
    let is_part = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let mut rest = 0;
    std::iter::from_fn(move || {
        loop {
            let from = rest + text[rest..].find(is_part)?;
            let end = text[from..].find(|c| !is_part(c)).map_or(text.len(), |it| from + it);
            rest = end;
            let (before, after) = (&text[..from], &text[end..]);
            let named = before.ends_with('.') || before.ends_with("::");
            if (named || after.starts_with('(') || after.starts_with("!["))
                && text[from..].starts_with(|c: char| c.is_ascii_lowercase())
            {
                return Some(&text[from..end]);
            }
        }
    })
}

fn exceptions() -> impl Iterator<Item = (&'static str, &'static str)> {
    EXCEPTIONS.lines().filter(|it| !it.starts_with('#')).filter_map(|it| it.split_once(": "))
}

fn shown_rows() -> Vec<(&'static str, &'static str)> {
    let lines = SHOWN.lines().filter(|it| !it.starts_with('#'));
    lines.filter_map(|it| it.split_once(" => ")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::{aimed, beside, writer};
    use bessemer_tests::random::Random;

    /// Programs of each kind that are written for this: text alone, and of every production of the grammar that is data.
    const PROGRAMS: u64 = 40;

    #[test]
    fn each_row_of_the_reference_is_written_by_some_program() {
        let mut reference = Reference::new();
        for seed in 0..PROGRAMS {
            reference.count(&writer::program(&mut Random(seed), "p").text, false);
            reference.count(&aimed::program(&mut Random(seed), "aimed0_0", 2).text, false);
            reference.count(&beside::program(&mut Random(seed), "beside0").text, false);
        }
        reference.count(beside::GIVEN, false);
        beside::productions().for_each(|text| reference.count(&text, false));
        let missing = reference.missing();
        assert!(missing.is_empty(), "no program has {}", missing.join(", "));
    }

    #[test]
    fn each_row_of_statements_and_attributes_has_a_text_that_shows_it() {
        let shown = shown_rows();
        let mut missing = Vec::new();
        for (row, _) in PAGES.into_iter().flat_map(|name| rows(&page(name))) {
            if !shown.iter().any(|it| row.starts_with(it.0)) {
                missing.push(row);
            }
        }
        assert!(missing.is_empty(), "nothing shows\n{}", missing.join("\n"));
        let all: Vec<String> = PAGES.into_iter().map(page).collect();
        let old = shown
            .iter()
            .filter(|it| !all.iter().any(|page| page.replace("\\|", "|").contains(it.0)));
        let old: Vec<_> = old.map(|it| it.0).collect();
        assert!(old.is_empty(), "no page has {}", old.join(", "));
    }

    #[test]
    fn exceptions_are_methods_of_the_page() {
        let all: Vec<String> =
            rows(&page("methods.md")).iter().flat_map(|it| words(&it.1)).collect();
        let old: Vec<_> = exceptions().filter(|it| !all.iter().any(|word| word == it.0)).collect();
        assert!(old.is_empty(), "the page does not list {old:?}");
    }

    #[test]
    fn prefixes_and_words_are_joined() {
        let cell = "`abs min`, `wrapping_` with `add sub`, `a.cmp(&b)` of all, `row_` and `column_` with `sum`";
        let all = ["abs", "min", "wrapping_add", "wrapping_sub", "cmp", "row_sum", "column_sum"];
        assert_eq!(words(cell), all);
    }
}
