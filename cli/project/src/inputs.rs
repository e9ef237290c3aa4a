//! Reads the tables of `bessemer.toml` that map a flight log to entry points: `[inputs.motor_step]`, `[periods]`.
//!
//! A source is a field of a topic, `"sensor_combined.gyro_rad"` or `"IMU.GyrX"`, with a factor if wanted: `"main.gyroADC * 0.0175"`;
//! a number or a flag that holds in each call; or a list with a source for each number of the parameter.
//!
//! Must not know: logs and entry points; names are compared when a log is read.

use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// Sources of the parameters of an entry point.
#[derive(Clone, Debug, PartialEq)]
pub struct Inputs {
    /// Name of the entry point or its component.
    pub name: String,
    /// Line in the file.
    pub line: u32,
    /// A source for each key.
    pub sources: Vec<Source>,
}

/// Source of a parameter or a part of one.
#[derive(Clone, Debug, PartialEq)]
pub struct Source {
    /// The parameter, or its part: `imu.rates`, `rates[0]`.
    pub target: String,
    /// Line in the file.
    pub line: u32,
    /// Parts of the source; one, unless it is a list.
    pub parts: Vec<Part>,
}

/// Part of a source.
#[derive(Clone, Debug, PartialEq)]
pub enum Part {
    /// A number or a flag, as text.
    Number(String),
    /// A field of a topic.
    Field {
        /// The topic, with its instance: `IMU[1]`.
        topic: String,
        /// The field.
        field: String,
        /// A factor of its numbers.
        factor: Option<f64>,
    },
}

/// Period of an entry point.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Period {
    /// Name of the entry point or its component.
    pub name: String,
    /// Line in the file.
    pub line: u32,
    /// The period.
    pub nanoseconds: u64,
}

/// A mistake in a table.
pub(crate) struct Wrong {
    /// Place in the text.
    pub at: usize,
    /// The mistake.
    pub message: String,
    /// The remedy.
    pub help: String,
}

impl Wrong {
    pub(crate) fn new(at: usize, message: String, help: &str) -> Wrong {
        Wrong { at, message, help: help.to_owned() }
    }
}

/// Form of a source, for an author who wrote something else.
const SOURCE: &str = "write a field of a topic, `\"topic.field\"` or `\"topic.field * 0.01\"`, a number, or a list of them";

/// Reads `[inputs.…]`; `line` returns the line of a place in the text.
pub(crate) fn inputs(
    found: &DeValue<'_>,
    at: usize,
    line: &dyn Fn(usize) -> u32,
) -> Result<Vec<Inputs>, Vec<Wrong>> {
    let read = tables("inputs", found, at, &Reader { line, part: &part, form: SOURCE })?;
    let inputs = read.into_iter().map(|it| {
        let row = |row: Row<Part>| Source { target: row.key, line: row.line, parts: row.parts };
        Inputs { name: it.name, line: it.line, sources: it.rows.into_iter().map(row).collect() }
    });
    Ok(inputs.collect())
}

/// Table of an entry point.
pub(crate) struct EntryTable<P> {
    /// Name of the entry point or its component.
    pub name: String,
    /// Line in the file.
    pub line: u32,
    /// The keys.
    pub rows: Vec<Row<P>>,
}

/// A key of such a table.
pub(crate) struct Row<P> {
    /// The key, with those of the tables around it.
    pub key: String,
    /// Line in the file.
    pub line: u32,
    /// Parts of the value; one, unless it is a list.
    pub parts: Vec<P>,
}

/// Reader of the keys of such a table.
pub(crate) struct Reader<'r, P> {
    /// Returns the line of a place in the text.
    pub line: &'r dyn Fn(usize) -> u32,
    /// Reads a part; the error is its place.
    pub part: &'r dyn Fn(&Spanned<DeValue<'_>>) -> Result<P, usize>,
    /// Form of a value, for an author who wrote something else.
    pub form: &'static str,
}

/// Reads the tables of a section, one for each entry point.
pub(crate) fn tables<P>(
    section: &str,
    found: &DeValue<'_>,
    at: usize,
    reader: &Reader<'_, P>,
) -> Result<Vec<EntryTable<P>>, Vec<Wrong>> {
    let wrong = |at: usize, name: &str| {
        let help = format!("begin it with `[{section}.motor_step]`, its keys below");
        Wrong::new(at, format!("`{name}` is a section"), &help)
    };
    let Some(tables) = found.as_table() else { return Err(vec![wrong(at, section)]) };
    let (mut all, mut mistakes) = (Vec::new(), Vec::new());
    for (name, value) in tables {
        let place = name.span().start;
        let name = name.get_ref().to_string();
        let Some(table) = value.get_ref().as_table() else {
            mistakes.push(wrong(place, &format!("{section}.{name}")));
            continue;
        };
        let mut rows = Vec::new();
        within(table, "", reader, &mut rows, &mut mistakes);
        // TOML's tables have no order; a file has one.
        rows.sort_by_key(|it| it.line);
        all.push(EntryTable { name, line: (reader.line)(place), rows });
    }
    if mistakes.is_empty() { Ok(all) } else { Err(mistakes) }
}

/// Reads the keys of a table; a table within it has the parts of a key.
fn within<P>(
    table: &DeTable<'_>,
    prefix: &str,
    reader: &Reader<'_, P>,
    rows: &mut Vec<Row<P>>,
    mistakes: &mut Vec<Wrong>,
) {
    for (key, value) in table {
        let name = format!("{prefix}{}", key.get_ref());
        let read = match value.get_ref() {
            DeValue::Table(inner) => {
                within(inner, &format!("{name}."), reader, rows, mistakes);
                continue;
            }
            DeValue::Array(list) => list.iter().map(reader.part).collect(),
            _ => (reader.part)(value).map(|it| vec![it]),
        };
        match read {
            Ok(parts) => {
                let line = (reader.line)(key.span().start);
                rows.push(Row { key: name, line, parts });
            }
            Err(at) => {
                let message = format!("`{name}` has no source that can be read");
                mistakes.push(Wrong::new(at, message, reader.form));
            }
        }
    }
}

/// Reads a source of one part; the error is its place.
fn part(value: &Spanned<DeValue<'_>>) -> Result<Part, usize> {
    let at = value.span().start;
    match value.get_ref() {
        DeValue::String(text) => field(text).ok_or(at),
        _ => number(value).map(Part::Number),
    }
}

/// Reads a number or a flag, as text; the error is its place.
pub(crate) fn number(value: &Spanned<DeValue<'_>>) -> Result<String, usize> {
    let at = value.span().start;
    match value.get_ref() {
        DeValue::Boolean(flag) => Ok(flag.to_string()),
        DeValue::Integer(it) => {
            let number = i128::from_str_radix(it.as_str(), it.radix()).map_err(|_| at)?;
            Ok(number.to_string())
        }
        DeValue::Float(it) => {
            let number = it.as_str().parse::<f64>().map_err(|_| at)?;
            Ok(format!("{number:?}"))
        }
        _ => Err(at),
    }
}

/// Splits a product of a path and a factor, which may be left out; none if the factor is no number.
pub(crate) fn scaled(text: &str) -> Option<(&str, Option<f64>)> {
    match text.split_once('*') {
        Some((path, factor)) => Some((path.trim(), Some(factor.trim().parse().ok()?))),
        None => Some((text.trim(), None)),
    }
}

/// Reads `topic.field` or `topic.field * factor`.
fn field(text: &str) -> Option<Part> {
    let (path, factor) = scaled(text)?;
    let (topic, field) = path.split_once('.')?;
    let is_name = |it: &str| !it.is_empty() && !it.contains(char::is_whitespace);
    let part = Part::Field { topic: topic.to_owned(), field: field.to_owned(), factor };
    (is_name(topic) && is_name(field)).then_some(part)
}

/// Reads `[periods]`.
pub(crate) fn periods(
    found: &DeValue<'_>,
    at: usize,
    line: &dyn Fn(usize) -> u32,
) -> Result<Vec<Period>, Vec<Wrong>> {
    /// Nanoseconds in a second.
    const SECOND: f64 = 1.0e9;
    /// The longest period, in nanoseconds: a day.
    const LONGEST: f64 = 86_400.0 * SECOND;
    let Some(table) = found.as_table() else {
        let help = "begin it with `[periods]`, its keys below";
        return Err(vec![Wrong::new(at, "`periods` is a section".to_owned(), help)]);
    };
    let (mut all, mut mistakes) = (Vec::new(), Vec::new());
    for (name, value) in table {
        let seconds: Option<f64> = match value.get_ref() {
            DeValue::Integer(it) => it.as_str().parse().ok(),
            DeValue::Float(it) => it.as_str().parse().ok(),
            _ => None,
        };
        let (at, name) = (name.span().start, name.get_ref().to_string());
        let nanoseconds = seconds.map(|it| (it * SECOND).round());
        match nanoseconds.filter(|it| (1.0..=LONGEST).contains(it)) {
            Some(nanoseconds) => {
                let nanoseconds = nanoseconds as u64;
                all.push(Period { name, line: line(at), nanoseconds });
            }
            None => mistakes.push(Wrong::new(
                value.span().start,
                format!("`periods.{name}` takes seconds"),
                "write the time between two calls, such as `0.004`",
            )),
        }
    }
    if mistakes.is_empty() { Ok(all) } else { Err(mistakes) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::file::{NAME, read};

    fn wrong(text: &str) -> String {
        let wrong = read(NAME, text).expect_err("it is wrong");
        let lines = wrong.iter().map(|it| format!("{}:{}: {}\n", it.line, it.column, it.message));
        lines.collect()
    }

    #[test]
    fn sources_are_read_in_each_form() {
        let text = "[inputs.estimator]\nrates = \"main.gyroADC * 0.5\"\nimu.temperature = \"IMU[1].T\"\n\
            \"place[1]\" = -2\non = true\ngains = [1.5, \"a.b[2].c\"]\n[periods]\nestimator = 0.004\n";
        let settings = read(NAME, text).expect("it is sound");
        let field = |topic: &str, field: &str, factor| Part::Field {
            topic: topic.to_owned(),
            field: field.to_owned(),
            factor,
        };
        let number = |text: &str| Part::Number(text.to_owned());
        let sources = settings.inputs[0].sources.clone();
        let sources: Vec<_> =
            sources.iter().map(|it| (it.target.as_str(), it.line, it.parts.clone())).collect();
        let expected = [
            ("rates", 2, vec![field("main", "gyroADC", Some(0.5))]),
            ("imu.temperature", 3, vec![field("IMU[1]", "T", None)]),
            ("place[1]", 4, vec![number("-2")]),
            ("on", 5, vec![number("true")]),
            ("gains", 6, vec![number("1.5"), field("a", "b[2].c", None)]),
        ];
        assert_eq!(sources, expected);
        let [period] = &settings.periods[..] else { panic!("{:?}", settings.periods) };
        assert_eq!(
            (period.name.as_str(), period.line, period.nanoseconds),
            ("estimator", 8, 4_000_000)
        );
    }

    #[test]
    fn a_malformed_source_is_reported_at_its_line() {
        let cases = [
            ("inputs = 1\n", "1:10: `inputs` is a section\n"),
            ("[inputs]\nmotor = 1\n", "2:1: `inputs.motor` is a section\n"),
            ("[inputs.m]\na = \"b\"\n", "2:5: `a` has no source that can be read\n"),
            ("[inputs.m]\na = \"b.c * x\"\n", "2:5: `a` has no source that can be read\n"),
            ("[inputs.m]\na = [\"b.c\", \"d\"]\n", "2:13: `a` has no source that can be read\n"),
            ("[inputs.m]\na = 1979-05-27\n", "2:5: `a` has no source that can be read\n"),
            ("[periods]\nm = 0\n", "2:5: `periods.m` takes seconds\n"),
            ("[periods]\nm = \"4 ms\"\n", "2:5: `periods.m` takes seconds\n"),
            ("periods = 1\n", "1:11: `periods` is a section\n"),
        ];
        for (text, expected) in cases {
            assert_eq!(wrong(text), expected, "{text}");
        }
    }
}
