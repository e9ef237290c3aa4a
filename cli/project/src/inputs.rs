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
    fn new(at: usize, message: String, help: &str) -> Wrong {
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
    let wrong = |at: usize, name: &str| {
        let message = format!("`{name}` is a section");
        Wrong::new(at, message, "begin it with `[inputs.motor_step]`, its keys below")
    };
    let Some(tables) = found.as_table() else { return Err(vec![wrong(at, "inputs")]) };
    let (mut all, mut mistakes) = (Vec::new(), Vec::new());
    for (name, value) in tables {
        let place = name.span().start;
        let name = name.get_ref().to_string();
        let Some(table) = value.get_ref().as_table() else {
            mistakes.push(wrong(place, &format!("inputs.{name}")));
            continue;
        };
        let mut sources = Vec::new();
        within(table, "", line, &mut sources, &mut mistakes);
        all.push(Inputs { name, line: line(place), sources });
    }
    if mistakes.is_empty() { Ok(all) } else { Err(mistakes) }
}

/// Reads the keys of a table; a table within it has the parts of a parameter.
fn within(
    table: &DeTable<'_>,
    prefix: &str,
    line: &dyn Fn(usize) -> u32,
    sources: &mut Vec<Source>,
    mistakes: &mut Vec<Wrong>,
) {
    for (key, value) in table {
        let target = format!("{prefix}{}", key.get_ref());
        let read = match value.get_ref() {
            DeValue::Table(inner) => {
                within(inner, &format!("{target}."), line, sources, mistakes);
                continue;
            }
            DeValue::Array(list) => list.iter().map(part).collect(),
            _ => part(value).map(|it| vec![it]),
        };
        match read {
            Ok(parts) => {
                sources.push(Source { target, line: line(key.span().start), parts });
            }
            Err(at) => {
                let message = format!("`{target}` has no source that can be read");
                mistakes.push(Wrong::new(at, message, SOURCE));
            }
        }
    }
}

/// Reads a source of one part; the error is its place.
fn part(value: &Spanned<DeValue<'_>>) -> Result<Part, usize> {
    let at = value.span().start;
    match value.get_ref() {
        DeValue::Boolean(flag) => Ok(Part::Number(flag.to_string())),
        DeValue::Integer(it) => {
            let number = i128::from_str_radix(it.as_str(), it.radix()).map_err(|_| at)?;
            Ok(Part::Number(number.to_string()))
        }
        DeValue::Float(it) => {
            let number = it.as_str().parse::<f64>().map_err(|_| at)?;
            Ok(Part::Number(format!("{number:?}")))
        }
        DeValue::String(text) => field(text).ok_or(at),
        _ => Err(at),
    }
}

/// Reads `topic.field` or `topic.field * factor`.
fn field(text: &str) -> Option<Part> {
    let (path, factor) = match text.split_once('*') {
        Some((path, factor)) => (path, Some(factor.trim().parse().ok()?)),
        None => (text, None),
    };
    let (topic, field) = path.trim().split_once('.')?;
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
        let mut sources = settings.inputs[0].sources.clone();
        sources.sort_by_key(|it| it.line);
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
