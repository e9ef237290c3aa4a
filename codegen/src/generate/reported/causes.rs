//! Reports one error per cause: drops messages that follow from another.
//!
//! An item below an attribute is compiled up to three times: as its author wrote it, as the witness copy, and as
//! builders. And an item that an attribute refuses is missing wherever it is used.

use std::collections::btree_map::Entry;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::RangeInclusive;

use super::rustc::{Mark, Message};
use super::wording::{Once, UNMARKED, UNNAMED, Words};
use bessemer_frontend::source::Sources;

/// A message of rustc, with its rewording if there is one.
pub type Worded<'m, 'a> = (&'m Message<'a>, Option<Words>);

/// Returns the messages that report a cause, each once.
pub fn once<'m, 'a>(all: Vec<Worded<'m, 'a>>, sources: &Sources) -> Vec<Worded<'m, 'a>> {
    let of = Causes::of(&all, sources);
    let mut kept: Vec<bool> = all.iter().map(|one| !of.follows(one, sources)).collect();
    let is_error = |one: &Worded<'_, '_>| one.0.is_error;
    // Whatever follows from what: an error is reported.
    if !all.iter().zip(&kept).any(|(one, kept)| *kept && is_error(one)) {
        kept.fill(true);
    }
    for (index, one) in all.iter().enumerate() {
        let others =
            || all.iter().zip(&kept).enumerate().filter(|(at, (_, kept))| *at != index && **kept);
        let at_attribute = |mark: &&Mark<'_>| mark.is_attribute();
        let stands_for = one.0.mark().filter(at_attribute).map(|it| Item::below(it, sources));
        // What a builder trips over at the attribute, something in the item tells at the author's line.
        let within = stands_for.is_some_and(|item| {
            others().any(|(_, (other, _))| {
                other.0.is_error
                    && other.0.mark().is_some_and(|it| !it.is_attribute() && item.has(it))
            })
        });
        // The same at an attribute and elsewhere.
        let elsewhere = one.0.mark().is_some_and(Mark::is_attribute)
            && one.1.is_some()
            && others().any(|(_, (other, _))| {
                title(other) == title(one)
                    && other.0.mark().is_some_and(|it| {
                        !it.is_attribute() && Some(it.file) == one.0.mark().map(|it| it.file)
                    })
            });
        // Of what an attribute refuses in one line of a body, the first is the cause; of two reasons for one place, the
        // reason for its part.
        let refused_before = is_refusal(one)
            && others().any(|(_, (other, _))| is_refusal(other) && is_nearer(other.0, one.0));
        // What rustc says of the original in this line says more than what a builder misses there.
        let said_better = is_builders(one)
            && others().any(|(_, (other, _))| {
                other.1.is_none() && other.0.is_error && line(other.0) == line(one.0)
            });
        // The type of what a call is given that is not part of the DSL.
        let given = one.1.as_ref().is_some_and(|words| words.of_type.is_some())
            && others().any(|(_, ((other, words), _))| {
                other.code == "E0599"
                    && words.is_some()
                    && line(other) == line(one.0)
                    && other.mark().map(|it| it.start) < one.0.mark().map(|it| it.start)
            });
        // Of two at one place, the one that knows what is there.
        let known = one.1.as_ref().is_some_and(|words| words.title == UNNAMED)
            && others().any(|(_, (other, _))| {
                title(other) != UNNAMED
                    && line(other.0) == line(one.0)
                    && position(other) == position(one)
            });
        // A name that is not there is missing wherever the item uses it.
        let missing_before = one.0.code == "E0425"
            && others().any(|(_, (other, _))| {
                title(other) == title(one)
                    && position(other) < position(one)
                    && around(other, sources) == around(one, sources)
            });
        // A name that is not there is no function, either.
        let of_missing_value = is_refusal(one)
            && title(one).starts_with(STORED)
            && others().any(|(_, (other, _))| {
                other.0.code == "E0425"
                    && position(other) < position(one)
                    && around(other, sources) == around(one, sources)
            });
        // A call of a function whose body has the value that its head does not declare: that body is the cause.
        let is_void = |other: &Worded<'_, '_>| {
            other.0.code == "E0308"
                && line(other.0) == line(one.0)
                && other.0.mark().is_some_and(|mark| mark.label.ends_with("found `()`"))
        };
        let no_result = all.iter().any(is_void)
            && others().any(|(_, (other, _))| {
                other.0.code == "E0308"
                    && line(other.0) != line(one.0)
                    && other.0.below().any(|it| it.contains("adding a return type"))
            });
        // A missing item says less than another of our messages at the same place.
        let named_better =
            one.1.as_ref().is_some_and(|words| words.title.ends_with("is not part of the DSL"))
                && others().any(|(_, (other, _))| {
                    other.1.as_ref().is_some_and(|it| !it.title.ends_with("is not part of the DSL"))
                        && line(other.0) == line(one.0)
                        && position(other) == position(one)
                });
        let of_nothing = title(one).ends_with("cannot be indexed by `()`")
            && others().any(|(_, (other, _))| {
                other.0.code == "E0571" && around(other, sources) == around(one, sources)
            });
        kept[index] &= !(within
            || of_missing_value
            || of_nothing
            || no_result
            || named_better
            || elsewhere
            || refused_before
            || said_better
            || given
            || known
            || missing_before);
    }
    let mut seen = BTreeMap::new();
    let mut reported: Vec<Worded<'m, 'a>> = Vec::new();
    for (one, kept) in all.into_iter().zip(kept) {
        if !kept {
            continue;
        }
        match seen.entry(key(&one, sources)) {
            Entry::Vacant(first) => {
                first.insert(reported.len());
                reported.push(one);
            }
            Entry::Occupied(first) => {
                let first = &mut reported[*first.get()];
                if is_of_file(&one) && position(&one) < position(first) {
                    *first = one;
                }
            }
        }
    }
    reported
}

/// First words of the refusal of a name that is bound to a function or a closure, and used as a value.
const STORED: &str = "a closure can be called or passed to a function";

/// Returns true if an error is reported once for its file. rustc's order of these is unstable; the topmost is reported.
fn is_of_file((_, words): &Worded<'_, '_>) -> bool {
    words.as_ref().is_some_and(|words| matches!(words.once, Once::File))
}

/// Returns file and first line of the item around a message.
fn around<'a>((message, _): &Worded<'_, 'a>, sources: &Sources) -> Option<(&'a str, u32)> {
    message.mark().map(|mark| (mark.file, Item::around(mark, sources).first))
}

fn position((message, _): &Worded<'_, '_>) -> Option<(u32, u32)> {
    message.mark().map(|mark| mark.start)
}

/// Returns a key by which duplicates are dropped. It keeps one of rustc's errors per line, since the witness copy
/// repeats them in other words, and one of ours per item, since a missing type is missing in each line.
fn key(one: &Worded<'_, '_>, sources: &Sources) -> (String, u32, String) {
    let Some(mark) = one.0.mark() else { return (String::new(), 0, one.0.title.to_owned()) };
    let file = mark.file.to_owned();
    match &one.1 {
        None if one.0.is_error => (file, mark.start.0, String::new()),
        None => (file, mark.start.0, one.0.title.to_owned()),
        // Each is a line to change.
        Some(words) if words.is_refusal => (file, mark.start.0, words.title.clone()),
        Some(words) => match words.once {
            Once::Line => (file, mark.start.0, String::new()),
            Once::Item => (file, Item::around(mark, sources).first, words.title.clone()),
            Once::File => (file, 0, words.title.clone()),
        },
    }
}

fn title<'w>((message, words): &'w Worded<'_, '_>) -> &'w str {
    words.as_ref().map_or(message.title, |words| &words.title)
}

fn is_refusal((_, words): &Worded<'_, '_>) -> bool {
    words.as_ref().is_some_and(|words| words.is_refusal)
}

/// Returns true if `one` is the more specific of two refusals in one line.
fn is_nearer(one: &Message<'_>, other: &Message<'_>) -> bool {
    let (Some(one), Some(other)) = (one.mark(), other.mark()) else { return false };
    if (one.file, one.start.0) != (other.file, other.start.0) {
        return false;
    }
    let within = other.start <= one.start && one.end <= other.end;
    let around = one.start <= other.start && other.end <= one.end;
    let is_body = !["fn ", "struct ", "impl", "#["].iter().any(|it| one.line.contains(it))
        && one.line.contains(['=', '(', ';']);
    within && !around || is_body && !around && one.start < other.start
}

fn is_builders((_, words): &Worded<'_, '_>) -> bool {
    words.as_ref().is_some_and(|words| !words.is_refusal)
}

fn line<'a>(message: &Message<'a>) -> Option<(&'a str, u32)> {
    message.mark().map(|mark| (mark.file, mark.start.0))
}

/// Errors from which other messages follow.
struct Causes {
    /// Files that do not parse; messages about the rest of such a file are meaningless.
    unread: BTreeSet<String>,
    /// Places that an attribute refused.
    refused: BTreeSet<(String, u32, u32)>,
    /// Files of these places.
    files: BTreeSet<String>,
    /// Items with a refused place, which are missing in the expansion.
    items: BTreeSet<(String, String)>,
    /// Refused names.
    names: BTreeSet<(String, String)>,
    /// Types that were reported as unsupported.
    types: BTreeSet<(String, String)>,
    /// Traits that are not interfaces.
    traits: BTreeSet<String>,
}

impl Causes {
    fn of(all: &[Worded<'_, '_>], sources: &Sources) -> Causes {
        let mut causes = Causes {
            unread: BTreeSet::new(),
            refused: BTreeSet::new(),
            files: BTreeSet::new(),
            items: BTreeSet::new(),
            names: BTreeSet::new(),
            types: BTreeSet::new(),
            traits: BTreeSet::new(),
        };
        for (message, words) in all {
            let Some(mark) = message.mark() else { continue };
            let file = mark.file.to_owned();
            match words {
                Some(words) if words.is_refusal => {
                    let name = Item::around(mark, sources).name;
                    causes.refused.insert((file.clone(), mark.start.0, mark.start.1));
                    causes.files.insert(file.clone());
                    if !mark.line.trim_start().starts_with("impl") {
                        causes.items.insert((file.clone(), name));
                    }
                    let marked = mark.text();
                    let marked = marked.split(['<', '(', '!']).next().unwrap_or_default();
                    let marked = marked.trim_end_matches("::");
                    let marked = marked.rsplit("::").next().unwrap_or_default();
                    causes.names.insert((file, marked.to_owned()));
                }
                Some(words) if words.title.starts_with(UNMARKED) => {
                    causes.names.insert((file.clone(), Item::around(mark, sources).name));
                }
                Some(words) if words.title.starts_with("the trait `") => {
                    _ = causes.traits.insert(file)
                }
                Some(Words { of_type: Some(name), .. }) if !mark.is_attribute() => {
                    causes.types.insert((file, name.clone()));
                }
                None if is_syntax(message) => _ = causes.unread.insert(file),
                _ => {}
            }
        }
        causes
    }

    /// Returns true if a message is a consequence of another one.
    fn follows(&self, one: &Worded<'_, '_>, sources: &Sources) -> bool {
        let (message, words) = one;
        let Some(mark) = message.mark() else { return false };
        if !message.is_error {
            return false;
        }
        let file = mark.file.to_owned();
        if self.unread.contains(&file) {
            return !is_syntax(message);
        }
        let named = |set: &BTreeSet<(String, String)>| {
            let mut names = message.quoted().into_iter();
            names.any(|it| {
                let it = it.trim_start_matches("&mut ").trim_start_matches('&');
                let base = it.split(['<', '(']).next().unwrap_or_default();
                let base = base.split(": ").next().unwrap_or_default();
                let last = base.rsplit("::").next().unwrap_or_default();
                set.contains(&(file.clone(), last.trim_start_matches("__b_").to_owned()))
            })
        };
        match words {
            // A use of a refused item, or what it implements.
            Some(words) if words.is_refusal => {
                let marked = mark.text();
                let base = marked.split(['<', '(', '.']).next().unwrap_or_default().to_owned();
                let is_use = Item::around(mark, sources).name != base
                    && self.items.contains(&(file.clone(), base));
                let is_header = mark.line.trim_start().starts_with("impl");
                let mut words = mark.line.split(|it: char| !it.is_alphanumeric() && it != '_');
                let implements = is_header
                    && words.any(|it| {
                        !it.is_empty() && self.items.contains(&(file.clone(), it.to_owned()))
                    });
                is_use || implements
            }
            Some(words) => {
                let of_trait =
                    self.traits.contains(&file) && words.title.ends_with("is not part of the DSL");
                (of_trait && !words.title.starts_with("the trait `"))
                    || named(&self.items)
                    || named(&self.names)
                    || words.of_type.is_none() && named(&self.types)
            }
            None => {
                let place = (file.clone(), mark.start.0, mark.start.1);
                // A parameter of a refused item is not there for what is in its place; nor is what rustc has not found, either.
                let lost =
                    matches!(message.code, "E0261" | "E0425" | "E0433") && mark_of_macro(message);
                let unresolved = matches!(message.code, "E0432" | "E0433") && named(&self.names);
                let line = |it: &(String, u32, u32)| (it.0.clone(), it.1);
                let declared = message.marked_below().any(|it| {
                    self.refused.iter().any(|at| line(at) == (it.file.to_owned(), it.start.0))
                });
                // The argument of a function whose parameter is refused.
                let unsized_one = message.title.starts_with("the size for values of type");
                // The type of an argument that the refused parameter would decide.
                let undecided = matches!(message.code, "E0282" | "E0283" | "E0284");
                declared && message.code == "E0308"
                    || self.files.contains(&file) && undecided
                    || self.files.contains(&file) && unsized_one
                    || self.refused.contains(&place)
                    || (self.files.contains(&file)
                        && (lost || unresolved || named(&self.names) && message.code == "E0432"))
            }
        }
    }
}

fn mark_of_macro(message: &Message<'_>) -> bool {
    message.marks.iter().any(|it| it.label.contains("through this procedural macro"))
}

/// Returns true if rustc could not parse the file; such errors have no code.
fn is_syntax(message: &Message<'_>) -> bool {
    const OTHERS: [&str; 3] = ["cannot find ", "unexpected token", "unexpected end of input"];
    message.is_error
        && message.code.is_empty()
        && !message.title.contains("\nhelp: ")
        && !OTHERS.iter().any(|it| message.title.starts_with(it))
        && message.mark().is_some_and(|mark| !mark.is_attribute())
}

/// An item of the author's, as a range of lines.
pub struct Item {
    file: String,
    /// Name; empty if there is none.
    name: String,
    first: u32,
    last: u32,
}

impl Item {
    /// Returns the item below an attribute, up to the first line that closes it.
    pub fn below(mark: &Mark<'_>, sources: &Sources) -> Item {
        let (file, first) = (mark.file.to_owned(), mark.start.0);
        let indent = |line: &str| line.len() - line.trim_start().len();
        let at = indent(mark.line);
        let ends = |line: &str| {
            indent(line) == at && (line.trim_start().starts_with('}') || line.ends_with(';'))
        };
        let last = (first + 1..).map_while(|it| Some((it, sources.line(&file, it)?)));
        let last = last.skip_while(|(_, line)| !ends(line)).map(|(it, _)| it).next();
        Item { name: String::new(), first, last: last.unwrap_or(first), file }
    }

    /// Returns the function or type that contains a place: the nearest line above that begins one.
    pub fn around(mark: &Mark<'_>, sources: &Sources) -> Item {
        let file = mark.file.to_owned();
        let above = (1..=mark.start.0).rev();
        // An attribute precedes what it is about.
        let below = mark.start.0 + 1..mark.start.0 + 4;
        let lines: Vec<u32> =
            if mark.is_attribute() { below.chain(above).collect() } else { above.collect() };
        for line in lines {
            let text = sources.line(&file, line).unwrap_or_default();
            // A lifetime begins no item.
            let text = text.replace("'static", "");
            let mut words = text.split(|it: char| !it.is_alphanumeric() && it != '_');
            let begins = |word: &&str| {
                ["fn", "struct", "enum", "union", "trait", "type", "static", "const"].contains(word)
            };
            if text.trim_start().starts_with("//") {
                continue;
            }
            if words.by_ref().any(|word| begins(&word)) {
                let name = words.find(|it| !it.is_empty() && *it != "fn" && *it != "mut");
                let name = name.unwrap_or_default().to_owned();
                return Item { file, name, first: line, last: line };
            }
        }
        Item { file, name: String::new(), first: 0, last: 0 }
    }

    /// Returns its lines.
    pub fn lines(&self) -> RangeInclusive<u32> {
        self.first..=self.last
    }

    fn has(&self, mark: &Mark<'_>) -> bool {
        mark.file == self.file && (self.first..=self.last).contains(&mark.start.0)
    }
}
