//! Maps numbers of a flight log to those that an entry point takes, as a table of `bessemer.toml` says.
//!
//! Invariant: each number of a parameter has exactly one source, or the whole parameter its defaults. Must not know: formats
//! of logs.

use bessemer_project::inputs::{Inputs, Part};

use super::super::{Table, Wanted, listed};
use super::error::Wrong;
use super::log::{Log, Topic};
use super::resampled::{self, Origin};
use super::{Mapping, bytes::Number};

/// Reads the wanted columns; `read` reads the log, with the samples of those topics for which its argument is true.
pub(super) fn read(
    read: impl Fn(&dyn Fn(&str) -> bool) -> Result<Log, Wrong>,
    wanted: &Wanted<'_>,
    mapping: &Mapping<'_>,
) -> Result<Table, Wrong> {
    let Some(table) = mapping.table() else {
        let log = read(&|_| false)?;
        let entry = mapping.entry();
        return Err(Wrong::NoTable { entry, topics: topics(&log), wanted: wanted.names() });
    };
    mapping.checked()?;
    let period = mapping.period()?;
    let mut log = read(&|topic| {
        let mut parts = table.sources.iter().flat_map(|it| &it.parts);
        parts.any(|part| matches!(part, Part::Field { topic: of, .. } if of == topic))
    })?;
    let origins = origins(table, &log, wanted)?;
    let present = present(table, &origins, wanted)?;
    let used: Vec<Origin> = origins.into_iter().flatten().collect();
    if !used.iter().any(|it| matches!(it, Origin::Sampled { .. })) {
        return Err(Wrong::Nothing { entry: table.name.clone(), known: topics(&log) });
    }
    let rows = resampled::rows(&log, &used, period)?;
    Ok(Table { rows, present, notes: std::mem::take(&mut log.notes) })
}

impl Mapping<'_> {
    /// Name of the entry point in the C.
    fn entry(&self) -> String {
        self.names.first().cloned().unwrap_or_default()
    }

    /// The table of the entry point, by the first of its names that has one.
    fn table(&self) -> Option<&Inputs> {
        self.names.iter().find_map(|name| self.inputs.iter().find(|it| it.name == *name))
    }

    /// Refuses tables of no entry point.
    fn checked(&self) -> Result<(), Wrong> {
        let tables = self.inputs.iter().map(|it| (&it.name, it.line));
        let periods = self.periods.iter().map(|it| (&it.name, it.line));
        match tables.chain(periods).find(|(name, _)| !self.known.contains(name)) {
            None => Ok(()),
            Some((name, line)) => Err(Wrong::NoEntry {
                place: place(line),
                name: name.clone(),
                known: listed(&self.known),
            }),
        }
    }

    /// The period of the entry point, in nanoseconds.
    fn period(&self) -> Result<u64, Wrong> {
        let of = |name: &String| self.periods.iter().find(|it| it.name == *name);
        let period = self.names.iter().find_map(of).map(|it| it.nanoseconds);
        period.ok_or_else(|| Wrong::NoPeriod { entry: self.entry() })
    }
}

fn place(line: u32) -> String {
    format!("bessemer.toml:{line}")
}

/// The topics that have samples, as a message lists them.
fn topics(log: &Log) -> String {
    let with_samples = log.topics.iter().filter(|it| it.count > 0);
    listed(&with_samples.map(|it| it.name.clone()).collect::<Vec<_>>())
}

/// The fields of a topic, arrays as one, as a message lists them.
fn fields(topic: &Topic) -> String {
    let mut names: Vec<String> = Vec::new();
    for field in topic.fields.iter().filter(|it| !it.is_padding()) {
        let name = match field.name.strip_suffix(']').and_then(|it| it.rsplit_once('[')) {
            Some((name, _)) => name,
            None => &field.name,
        };
        if names.last().is_none_or(|last| last != name) {
            names.push(name.to_owned());
        }
    }
    listed(&names)
}

/// The origin of each column.
fn origins(table: &Inputs, log: &Log, wanted: &Wanted<'_>) -> Result<Vec<Option<Origin>>, Wrong> {
    let columns: Vec<&str> =
        wanted.parameters.iter().flat_map(|it| &it.columns).map(|it| it.name.as_str()).collect();
    let mut origins: Vec<Option<Origin>> = vec![None; columns.len()];
    for source in &table.sources {
        let (target, place) = (&source.target, place(source.line));
        let is_part = |name: &str| {
            let rest = name.strip_prefix(target.as_str());
            rest.is_some_and(|it| it.is_empty() || it.starts_with(['.', '[']))
        };
        let targets: Vec<usize> = (0..columns.len()).filter(|at| is_part(columns[*at])).collect();
        if targets.is_empty() {
            let (target, known) = (target.clone(), wanted.names());
            return Err(Wrong::Parameter { place, target, known });
        }
        let mut found = Vec::new();
        for part in &source.parts {
            match part {
                Part::Number(text) => found.push(Origin::Number(text.clone())),
                Part::Field { topic, field, factor } => {
                    sampled(log, (topic, field), *factor, &place, &mut found)?;
                }
            }
        }
        if found.len() != targets.len() {
            let origin = match &source.parts[..] {
                [Part::Field { topic, field, .. }] => format!("`{topic}.{field}`"),
                _ => "the list".to_owned(),
            };
            let (wanted, found) = (targets.len(), found.len());
            return Err(Wrong::Length { place, target: target.clone(), wanted, origin, found });
        }
        for (at, origin) in targets.into_iter().zip(found) {
            if origins[at].replace(origin).is_some() {
                return Err(Wrong::Twice { place, column: columns[at].to_owned() });
            }
        }
    }
    Ok(origins)
}

/// The numbers of a field, or of an array of fields.
fn sampled(
    log: &Log,
    (topic, field): (&str, &str),
    factor: Option<f64>,
    place: &str,
    found: &mut Vec<Origin>,
) -> Result<(), Wrong> {
    let place = || place.to_owned();
    let Some(at) = log.topics.iter().position(|it| it.name == topic) else {
        let (topic, known) = (topic.to_owned(), topics(log));
        return Err(Wrong::Topic { place: place(), topic, known });
    };
    let of = &log.topics[at];
    let exact = of.fields.iter().position(|it| it.name == field);
    let elements = || {
        let element = |at: &usize| {
            let index = of.fields[*at].name.strip_prefix(field);
            let index = index.and_then(|it| it.strip_prefix('[')?.strip_suffix(']'));
            index.is_some_and(|it| it.parse::<usize>().is_ok())
        };
        (0..of.fields.len()).filter(element).collect::<Vec<_>>()
    };
    let fields_of_it = exact.map_or_else(elements, |it| vec![it]);
    let topic = topic.to_owned();
    if fields_of_it.is_empty() {
        let (field, known) = (field.to_owned(), fields(of));
        return Err(Wrong::Field { place: place(), topic, field, known });
    }
    if of.count == 0 {
        return Err(Wrong::NoSamples { place: place(), topic });
    }
    if of.time.is_none() {
        return Err(Wrong::NoTime { place: place(), topic, known: fields(of) });
    }
    found.extend(fields_of_it.into_iter().map(|field| Origin::Sampled {
        topic: at,
        field,
        factor,
    }));
    Ok(())
}

/// The parameters that the table maps; one of which it maps nothing may have its defaults.
fn present(
    table: &Inputs,
    origins: &[Option<Origin>],
    wanted: &Wanted<'_>,
) -> Result<Vec<bool>, Wrong> {
    let mut rest = origins.iter();
    let of_one = |parameter: &super::super::Parameter<'_>| {
        let own: Vec<_> = rest.by_ref().take(parameter.columns.len()).collect();
        match own.iter().position(|it| it.is_none()) {
            None => Ok(true),
            Some(_) if own.iter().all(|it| it.is_none()) && parameter.default.is_some() => {
                Ok(false)
            }
            Some(first) => {
                let column = parameter.columns.get(first);
                let column = column.map_or(String::new(), |it| it.name.clone());
                Err(Wrong::Unmapped { entry: table.name.clone(), column })
            }
        }
    };
    wanted.parameters.iter().map(of_one).collect()
}

impl Origin {
    /// The text of a number of the log.
    pub(super) fn text(number: Number, factor: Option<f64>) -> String {
        factor.map_or(number, |it| Number::Float(number.float() * it)).text()
    }
}
