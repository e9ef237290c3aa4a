//! Figures in pages are those of their result files.
//!
//! Behind a figure stands, for no reader to see, where it comes from: `70 ms<!-- = FILE / KEY / … × 1000 -->`. The file
//! is named from the root. What a key means depends on the file:
//! - `.json`: a key of an object, an index of an array, `*` for each element, `key=value` for those that have it;
//! - `.csv`: a column; lines that begin with `#` are none;
//! - `.md`: the begin of a heading `## …` (if there are several tables), then the first cell of a row, then, unless it is
//!   the second, the head of a column;
//! - any other file: the number that follows these words;
//! - a `*` in the file's name: how many such files there are.
//!
//! Of several numbers a last key says which: `least`, `most`, `median`, `count`. The page may round, and use
//! another unit (`× 1000`); what it shows must then be the result to the last digit shown.
//!
//! Each line of the pages in [`HELD`] that shows a measurement has such a mark, or is in a paragraph that says why there is
//! none: `<!-- no result: … -->`.

use std::path::Path;

use serde_json::Value;

use super::shared::{none, root};
use super::{pages, prose};

const MARK: &str = "<!-- = ";
const NO_RESULT: &str = "<!-- no result: ";

/// The pages in which no line shows a measurement without its source.
const HELD: [&str; 3] = ["README.md", "docs/results.md", "docs/identification.md"];

/// Units that make a number a measurement.
const UNITS: [&str; 14] = [
    "%",
    "°",
    "ms",
    "s",
    "µs",
    "ns",
    "m/s",
    "rad/s",
    "mm",
    "cm",
    "m",
    "ulp",
    "bytes",
    "instructions",
];

/// A number as a page shows it: its value, and how many digits follow its point.
#[derive(Debug, PartialEq)]
struct Shown {
    value: f64,
    digits: i32,
}

/// The last number in `text`, with groups of three digits.
fn last_number(text: &str) -> Option<Shown> {
    let end = text.rfind(|it: char| it.is_ascii_digit())? + 1;
    let letters: Vec<char> = text[..end].chars().collect();
    let mut start = letters.len();
    while start > 0 {
        let group = letters[start..].iter().take_while(|it| it.is_ascii_digit()).count();
        let is_part = match letters[start - 1] {
            it if it.is_ascii_digit() => true,
            '.' => start > 1 && letters[start - 2].is_ascii_digit(),
            ' ' => group == 3 && start > 1 && letters[start - 2].is_ascii_digit(),
            _ => false,
        };
        if !is_part {
            break;
        }
        start -= 1;
    }
    let is_negative = start > 0 && "-−".contains(letters[start - 1]);
    let number: String = letters[start..].iter().filter(|it| **it != ' ').collect();
    let digits = number.split_once('.').map_or(0, |(_, behind)| behind.len());
    let value: f64 = number.parse().ok()?;
    Some(Shown { value: if is_negative { -value } else { value }, digits: digits as i32 })
}

/// The first number in `text`.
fn first_number(text: &str) -> Option<f64> {
    let start = text.find(|it: char| it.is_ascii_digit())?;
    let start = if text[..start].ends_with('-') { start - 1 } else { start };
    let of_number = |it: char| it.is_ascii_digit() || ".-_".contains(it);
    let end = text[start..].find(|it| !of_number(it)).map_or(text.len(), |end| start + end);
    text[start..end].replace('_', "").trim_end_matches('.').parse().ok()
}

/// Returns true if a page may show a result in this form.
fn is_rounded(shown: &Shown, result: f64) -> bool {
    (shown.value - result).abs() <= 0.5 * 10_f64.powi(-shown.digits) * (1.0 + 1e-9)
}

/// The results that a mark names.
fn results(mark: &str) -> Result<f64, String> {
    let (path, factor) = match mark.split_once(" × ") {
        Some((path, factor)) => (path, factor.trim().parse().map_err(|_| "no factor")?),
        None => (mark, 1.0),
    };
    let mut keys: Vec<&str> = path.split(" / ").map(str::trim).collect();
    let file = keys.remove(0);
    let chosen =
        keys.last().copied().filter(|it| ["least", "most", "median", "count"].contains(it));
    if chosen.is_some() {
        keys.pop();
    }
    let mut numbers = if file.contains('*') {
        vec![count(file) as f64]
    } else {
        let text = std::fs::read_to_string(root().join(file)).map_err(|error| error.to_string())?;
        match Path::new(file).extension().and_then(|it| it.to_str()) {
            Some("json") => of_json(&text, &keys)?,
            Some("csv") => of_csv(&text, &keys)?,
            Some("md") => of_table(&text, &keys).into_iter().collect(),
            _ => keys
                .first()
                .and_then(|key| text.split_once(key))
                .and_then(|(_, it)| first_number(it))
                .into_iter()
                .collect(),
        }
    };
    numbers.sort_by(f64::total_cmp);
    let middle = |all: &[f64]| (all[(all.len() - 1) / 2] + all[all.len() / 2]) / 2.0;
    let result = match (chosen, numbers.as_slice()) {
        (Some("count"), all) => all.len() as f64,
        (_, []) => return Err("nothing there".to_owned()),
        (Some("least"), all) => all[0],
        (Some("most"), all) => all[all.len() - 1],
        (Some(_), all) => middle(all),
        (None, [one]) => *one,
        (None, all) => return Err(format!("{} numbers", all.len())),
    };
    Ok(result * factor)
}

/// Files of a folder that a name with one `*` fits.
fn count(name: &str) -> usize {
    let (folder, name) = name.rsplit_once('/').unwrap_or(("", name));
    let (begin, end) = name.split_once('*').unwrap_or((name, ""));
    let entries = std::fs::read_dir(root().join(folder)).into_iter().flatten().flatten();
    let names = entries.map(|entry| entry.file_name().to_string_lossy().into_owned());
    names.filter(|it| it.starts_with(begin) && it.ends_with(end)).count()
}

fn of_json(text: &str, keys: &[&str]) -> Result<Vec<f64>, String> {
    let root: Value = serde_json::from_str(text).map_err(|error| error.to_string())?;
    let mut here = vec![&root];
    for key in keys {
        let steps = here.into_iter().flat_map(|value| match (value, key.split_once('=')) {
            (Value::Array(all), None) if *key == "*" => all.iter().collect(),
            (Value::Object(all), None) if *key == "*" => all.values().collect(),
            (Value::Array(all), Some((key, wanted))) => {
                all.iter().filter(|it| is(&it[key], wanted)).collect()
            }
            (Value::Object(all), Some((key, wanted))) => {
                all.get(key).filter(|it| is(it, wanted)).map(|_| value).into_iter().collect()
            }
            (Value::Array(all), None) => {
                key.parse().ok().and_then(|index: usize| all.get(index)).into_iter().collect()
            }
            (value, _) => value.get(key).into_iter().collect::<Vec<_>>(),
        });
        here = steps.collect();
    }
    Ok(here.into_iter().filter_map(Value::as_f64).collect())
}

/// Returns true if a value of JSON is the one that a mark names.
fn is(value: &Value, wanted: &str) -> bool {
    value == wanted || value.is_number() && value.as_f64() == wanted.parse().ok()
}

fn of_csv(text: &str, keys: &[&str]) -> Result<Vec<f64>, String> {
    // The first line of a campaign's file is a comment for programs.
    let mut lines = text.lines().filter(|line| !line.starts_with('#'));
    let head: Vec<&str> = lines.next().unwrap_or_default().split(',').collect();
    let wanted = keys.first().copied().unwrap_or_default();
    let column = head.iter().position(|it| *it == wanted).ok_or("no such column")?;
    Ok(lines.filter_map(|line| line.split(',').nth(column)?.parse().ok()).collect())
}

fn of_table(text: &str, keys: &[&str]) -> Option<f64> {
    let headings = keys.first().is_some_and(|key| text.contains(&format!("\n## {key}")))
        || keys.first().is_some_and(|key| text.starts_with(&format!("## {key}")));
    let (text, keys) = match headings {
        true => (text.split("## ").find(|part| part.starts_with(keys[0]))?, &keys[1..]),
        false => (text, keys),
    };
    let cells = |line: &str| -> Vec<String> {
        line.trim_matches('|').split('|').map(|cell| cell.trim().to_owned()).collect()
    };
    let mut rows = text.lines().filter(|line| line.starts_with('|')).map(cells);
    let head = rows.next()?;
    let row = rows.find(|row| row[0] == keys[0])?;
    let column = match keys.get(1) {
        Some(wanted) => head.iter().position(|it| it == wanted)?,
        None => 1,
    };
    first_number(row.get(column)?)
}

#[test]
fn every_figure_is_that_of_its_result_file() {
    let mut offences = Vec::new();
    let mut count = 0;
    for page in pages() {
        for (number, line) in prose(&page.text) {
            let mut before = String::new();
            for (index, part) in line.split(MARK).enumerate() {
                let Some((mark, behind)) = part.split_once(" -->").filter(|_| index > 0) else {
                    before = part.to_owned();
                    continue;
                };
                count += 1;
                let place = format!("{}:{number}: {mark}", page.path);
                match (last_number(&before), results(mark)) {
                    (Some(shown), Ok(result)) if is_rounded(&shown, result) => {}
                    (Some(shown), Ok(result)) => {
                        offences.push(format!(
                            "{place}: the page says {}, the file {result}",
                            shown.value
                        ));
                    }
                    (None, _) => offences.push(format!("{place}: no figure before it")),
                    (_, Err(error)) => offences.push(format!("{place}: {error}")),
                }
                before = behind.to_owned();
            }
        }
    }
    assert!(count > 20, "the figures were not found");
    none("a figure is that of its result file", &offences);
}

/// Returns true if a line shows a number with a unit, or with decimals.
fn is_measurement(line: &str) -> bool {
    let mut visible = String::new();
    for (index, part) in line.split("<!--").enumerate() {
        visible.push_str(if index == 0 {
            part
        } else {
            part.split_once("-->").map_or("", |(_, it)| it)
        });
    }
    let visible: String = visible.split('`').step_by(2).collect();
    let mut words = visible.split_whitespace().peekable();
    while let Some(word) = words.next() {
        let word = word.trim_matches(|it| "(),;:*|".contains(it));
        let number = word.trim_end_matches(['%', '°', '.']);
        if !number.starts_with(|it: char| it.is_ascii_digit()) || number.parse::<f64>().is_err() {
            continue;
        }
        let has_unit = words
            .peek()
            .is_some_and(|next| UNITS.contains(&next.trim_matches(|it| "(),;:.*|".contains(it))));
        if has_unit || number.contains('.') || word.ends_with(['%', '°']) {
            return true;
        }
    }
    false
}

#[test]
fn no_measurement_stands_without_its_source() {
    let mut offences = Vec::new();
    for page in pages().iter().filter(|page| HELD.contains(&page.path.as_str())) {
        let mut is_excused = false;
        for (number, line) in prose(&page.text) {
            is_excused = line.contains(NO_RESULT) || is_excused && !line.is_empty();
            if is_measurement(line) && !is_excused && !line.contains(MARK) {
                offences.push(format!("{}:{number}: {line}", page.path));
            }
        }
    }
    none("a measurement names its result file, or its paragraph says why there is none", &offences);
}

#[test]
fn numbers_are_read_as_people_write_them() {
    let shown = |value, digits| Some(Shown { value, digits });
    assert_eq!(last_number("in 20 flights 18 283"), shown(18283.0, 0));
    assert_eq!(last_number("at a tilt of **16.2°**"), shown(16.2, 1));
    assert_eq!(last_number("by 3 and −0.5 m"), shown(-0.5, 1));
    assert_eq!(last_number("none"), None);
    assert_eq!(first_number("-0.451 m/s"), Some(-0.451));
    assert!(is_rounded(&Shown { value: 16.2, digits: 1 }, 16.246));
    assert!(!is_rounded(&Shown { value: 12.0, digits: 0 }, 16.246));
    assert!(is_measurement("noticed within 70 ms") && is_measurement("(the hardest: 0.3)"));
    assert!(!is_measurement("| `0.5 ms` | in 6 steps <!-- 7 ms --> |"));
}

#[test]
fn results_are_found_in_each_kind_of_file() {
    let flights = "## a: b\n\n| figure | value |\n|:--|--:|\n| error | 0.5 m |\n\n## c: d\n\n| figure | value |\n|--|--|\n| error | 0.7 m |\n";
    assert_eq!(of_table(flights, &["c:", "error"]), Some(0.7));
    assert_eq!(of_table("| x | p | q |\n|--|--|--|\n| r | 1 | 2 |\n", &["r", "q"]), Some(2.0));
    let json = r#"{"all": [{"name": "x", "m": 1}, {"name": "y", "m": 4}]}"#;
    assert_eq!(of_json(json, &["all", "*", "m"]), Ok(vec![1.0, 4.0]));
    assert_eq!(of_json(json, &["all", "name=y", "m"]), Ok(vec![4.0]));
    assert_eq!(of_csv("a,b\n1,2\n3,inf\n", &["b"]).map(|it| it.len()), Ok(2));
}
