//! The style of docs/style.md in figures for each folder. They count bad openings and long first sentences of
//! documentation comments, and words of our own. The figures only fall.
//!
//! `UPDATE_WORDS=1` writes the figures of today to `figures.tsv`; it refuses to raise one.
//! `BESSEMER_SAMPLE=7 cargo test -p xtask --test words sample -- --nocapture` prints 100 comments, drawn by that seed.

#[path = "../shared/mod.rs"]
mod shared;

use shared::{File, files, none, root};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;

/// Openings that a documentation comment must not have: no verb, and no noun, follows the reader's eye.
const OPENINGS: [&str; 10] =
    ["What", "Whether", "How", "Where", "Of", "That of", "The same", "Which", "Who", "Those of"];

/// Longest first sentence of a documentation comment, in words.
const LONGEST: usize = 25;

/// Words of our own. Each has a plain one in docs/style.md.
const OWN: [&str; 16] = [
    "lent",
    "told",
    "asked",
    "given",
    "gone through",
    "by hand",
    "settled",
    "so many",
    "none of",
    "what is",
    "that of",
    "the same as",
    "stands",
    "apart",
    "turns",
    "dear",
];

/// Files that list the words.
const LISTS: [&str; 2] = ["docs/style.md", "xtask/tests/words/main.rs"];

/// Path of the committed figures.
const FIGURES: &str = "xtask/tests/words/figures.tsv";

/// Number of the worst files that a failure shows.
const WORST: usize = 12;

/// Number of comments in a sample.
const SAMPLE: usize = 100;

/// Offences of a file or a folder: openings, long first sentences, words of our own.
type Figures = [usize; 3];

/// A documentation comment: its place, its text, and the line of code below it.
struct Comment {
    path: String,
    line: usize,
    text: Vec<String>,
    item: String,
}

impl Comment {
    /// Returns the first sentence, its lines joined.
    fn first_sentence(&self) -> String {
        let paragraph: Vec<&str> =
            self.text.iter().map(|it| it.trim()).take_while(|it| !it.is_empty()).collect();
        let paragraph = paragraph.join(" ");
        match paragraph.split_once(". ") {
            Some((first, _)) => first.to_owned(),
            None => paragraph,
        }
    }

    fn opens_badly(&self) -> bool {
        let first = self.first_sentence();
        let begins = |opening: &&str| {
            let rest = first.strip_prefix(*opening);
            rest.is_some_and(|rest| !rest.starts_with(|next: char| next.is_alphanumeric()))
        };
        OPENINGS.iter().any(begins)
    }

    fn is_long(&self) -> bool {
        self.first_sentence().split_whitespace().count() > LONGEST
    }
}

/// Returns the documentation comments of a Rust file.
fn comments(file: &File) -> Vec<Comment> {
    let mut found: Vec<Comment> = Vec::new();
    let mut is_open = false;
    for (index, line) in file.text.lines().enumerate() {
        let line = line.trim();
        let text = line.strip_prefix("///").or_else(|| line.strip_prefix("//!"));
        match (text.filter(|text| !text.starts_with('/')), found.last_mut()) {
            (Some(text), Some(last)) if is_open => last.text.push(text.trim().to_owned()),
            (Some(text), _) => found.push(Comment {
                path: file.path.clone(),
                line: index + 1,
                text: vec![text.trim().to_owned()],
                item: String::new(),
            }),
            (None, Some(last)) if is_open || last.item.starts_with("#[") => {
                last.item = line.to_owned();
            }
            (None, _) => {}
        }
        is_open = text.is_some();
    }
    found
}

/// Returns how often words of our own occur in a text; `_` ends a word, so names count too.
fn own_words(text: &str) -> usize {
    let simple = |it: char| if it.is_alphanumeric() { it.to_ascii_lowercase() } else { ' ' };
    let text: String = text.chars().map(simple).collect();
    let words = text.split_whitespace().collect::<Vec<_>>().join(" ");
    let words = format!(" {} ", words.replace(' ', "  "));
    OWN.iter().map(|own| words.matches(&format!(" {} ", own.replace(' ', "  "))).count()).sum()
}

/// Returns the figures of a file; none if it is generated, recorded or no text of ours.
fn figures(file: &File) -> Figures {
    let ends = |ends: &[&str]| ends.iter().any(|end| file.path.ends_with(end));
    let generated = ["generated/", "tests/corpus/golden/", "ground/page/", "tests/plain/programs/"];
    if generated.iter().any(|folder| file.path.starts_with(folder))
        || LISTS.contains(&&*file.path)
        || !ends(&[".rs", ".md", ".ts", ".html", ".tera", ".c", ".h"])
    {
        return [0; 3];
    }
    let comments = if file.is_rust() { comments(file) } else { Vec::new() };
    let count = |offends: fn(&Comment) -> bool| comments.iter().filter(|it| offends(it)).count();
    let words = own_words(&file.text) + own_words(&file.path);
    [count(Comment::opens_badly), count(Comment::is_long), words]
}

/// Returns the folder under which a file is counted.
fn folder(path: &str) -> String {
    let parts: Vec<&str> = path.split('/').collect();
    let depth = match parts[0] {
        "codegen" | "tests" => 2,
        _ => 1,
    };
    match parts.len() > depth {
        true => parts[..depth].join("/"),
        false => ".".to_owned(),
    }
}

fn by_folder(files: &[File]) -> BTreeMap<String, Figures> {
    let mut sums = BTreeMap::<String, Figures>::new();
    for file in files {
        let sum = sums.entry(folder(&file.path)).or_default();
        figures(file).into_iter().zip(sum).for_each(|(figure, sum)| *sum += figure);
    }
    sums.retain(|_, sum| *sum != [0; 3]);
    sums
}

/// Returns the committed figures.
fn committed() -> BTreeMap<String, Figures> {
    let text = std::fs::read_to_string(root().join(FIGURES)).unwrap_or_default();
    let row = |line: &str| {
        let mut columns = line.split('\t');
        let folder = columns.next()?.to_owned();
        let figures: Vec<usize> = columns.filter_map(|it| it.parse().ok()).collect();
        Some((folder, Figures::try_from(figures).ok()?))
    };
    text.lines().skip(1).filter_map(row).collect()
}

#[test]
fn offences_against_the_style_only_fall() {
    let files = files();
    let (now, bounds) = (by_folder(&files), committed());
    let mut offences = Vec::new();
    for (folder, figures) in &now {
        let bound = bounds.get(folder).copied().unwrap_or_default();
        if figures.iter().zip(bound).any(|(figure, bound)| *figure > bound) {
            offences.push(format!("{folder}: {figures:?}, more than {bound:?}"));
            offences.extend(worst(&files, folder));
        }
    }
    if std::env::var_os("UPDATE_WORDS").is_some() && (offences.is_empty() || bounds.is_empty()) {
        let mut table = "folder\topenings\tlong first sentences\twords of our own\n".to_owned();
        for (folder, [openings, long, words]) in &now {
            writeln!(table, "{folder}\t{openings}\t{long}\t{words}").expect("a text grows");
        }
        std::fs::write(root().join(FIGURES), table).expect("the figures can be written");
        return;
    }
    none("docs/style.md: [openings, long first sentences, words of our own] only fall", &offences);
}

/// Returns the worst files of a folder, with their figures and the first lines of their offending comments.
fn worst(files: &[File], of: &str) -> Vec<String> {
    let mut worst: Vec<(Figures, &File)> = files
        .iter()
        .filter(|file| folder(&file.path) == of)
        .map(|file| (figures(file), file))
        .filter(|(figures, _)| *figures != [0; 3])
        .collect();
    worst.sort_by_key(|(figures, _)| std::cmp::Reverse(figures.iter().sum::<usize>()));
    let mut lines = Vec::new();
    for (figures, file) in worst.into_iter().take(WORST) {
        lines.push(format!("  {}: {figures:?}", file.path));
        let comments = if file.is_rust() { comments(file) } else { Vec::new() };
        let offending = comments.iter().filter(|it| it.opens_badly() || it.is_long());
        lines.extend(
            offending.take(3).map(|it| format!("    {}: {}", it.line, it.first_sentence())),
        );
    }
    lines
}

#[test]
fn sample_of_comments() {
    let comments: Vec<Comment> =
        files().iter().filter(|file| file.is_source()).flat_map(comments).collect();
    let seed = std::env::var("BESSEMER_SAMPLE").ok().and_then(|seed| seed.parse().ok());
    let drawn = draw(seed.unwrap_or(0), comments.len());
    assert_eq!(drawn.len(), SAMPLE);
    for comment in drawn.into_iter().map(|index| &comments[index]) {
        let text = comment.text.join("\n    ");
        println!("{}:{}\n    {text}\n    > {}\n", comment.path, comment.line, comment.item);
    }
}

/// Draws the indices of a sample, each once, by SplitMix64.
fn draw(mut seed: u64, length: usize) -> BTreeSet<usize> {
    let mut drawn = BTreeSet::new();
    while drawn.len() < SAMPLE.min(length) {
        seed = seed.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut mixed = (seed ^ (seed >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        drawn.insert(usize::try_from((mixed ^ (mixed >> 31)) % length as u64).unwrap_or_default());
    }
    drawn
}

#[test]
fn offences_are_found() {
    let text = "/// Whether it fits.\nfn fits() {}\n\n/// Returns a\n/// sum. What follows is free.\n#[inline]\nfn sum() {}\n";
    let file = File { path: "a/src/b.rs".to_owned(), text: text.to_owned() };
    let found = comments(&file);
    assert_eq!(found.iter().map(Comment::opens_badly).collect::<Vec<_>>(), [true, false]);
    assert_eq!(found[1].first_sentence(), "Returns a sum");
    assert_eq!(found[1].item, "fn sum() {}");
    let long = format!("/// Returns {}.\n", "word ".repeat(LONGEST));
    let file = File { path: "a/src/b.rs".to_owned(), text: long };
    assert_eq!(figures(&file), [0, 1, 0]);
    assert_eq!(own_words("What is lent to it: is_lent, told_by_hand, stands stands, talent"), 7);
    assert_eq!(folder("codegen/ir/src/ir.rs"), "codegen/ir");
    assert_eq!(folder("README.md"), ".");
}
