//! Recordings as MCAP files: messages of one topic in JSON, a row each, in the order of their log times.
//!
//! The first topic is taken whose first message has all columns; a note names others like it. Python writes `NaN` and `Infinity`
//! into JSON, which are read as the numbers that they name.
//!
//! Must not know: types of columns, and what the cells mean.

use std::borrow::Cow;
use std::collections::HashMap;

use serde_json::Value;

use super::error::Wrong;
use super::mcap::{self, Record};
use super::{Row, Table, Wanted, listed};

/// A message in JSON.
struct Message {
    time: u64,
    topic: String,
    text: Vec<u8>,
}

/// Reads the wanted columns.
pub(super) fn read(bytes: &[u8], wanted: &Wanted<'_>) -> Result<Table, Wrong> {
    let mut messages = messages(bytes)?;
    let sorted = messages.is_sorted_by_key(|it| it.time);
    messages.sort_by_key(|it| it.time);
    let mut topics: Vec<String> = Vec::new();
    let (mut complete, mut incomplete, mut broken) = (Vec::new(), None, None);
    for (first, message) in messages.iter().enumerate() {
        if topics.contains(&message.topic) {
            continue;
        }
        topics.push(message.topic.clone());
        let value = match parsed(&message.text) {
            Ok(value) => value,
            Err(source) => {
                let place = place(0, &message.topic);
                broken = broken.or(Some(Wrong::Json { place, source }));
                continue;
            }
        };
        let has = |name: &str| cell(&value, name).is_some();
        match wanted.present(has, Vec::new) {
            Ok(present) => complete.push((first, present, names(&value))),
            Err(wrong) if wanted.found(has) > 0 => incomplete = incomplete.or(Some(wrong)),
            Err(_) => {}
        }
    }
    let mut complete = complete.into_iter();
    let Some((first, present, names)) = complete.next() else {
        return Err(match (broken, incomplete, &topics[..]) {
            (Some(broken), ..) => broken,
            (None, Some(Wrong::Column { column, wanted, .. }), [only]) => {
                Wrong::Column { column, wanted, found: format!("other fields of `{only}`") }
            }
            _ => Wrong::Topic { wanted: wanted.listed(), found: listed(&topics) },
        });
    };
    let topic = &messages[first].topic;
    let mut table =
        rows(messages[first..].iter().filter(|it| it.topic == *topic), wanted, present)?;
    if !sorted {
        table.notes.push("messages sorted by log time; the file has another order".to_owned());
    }
    table.notes.extend(wanted.beside(&names));
    let others: Vec<String> = complete.map(|(at, ..)| messages[at].topic.clone()).collect();
    if !others.is_empty() {
        table.notes.push(format!("`{topic}` read; {} left out", listed(&others)));
    }
    Ok(table)
}

/// The place of a message among those of its topic.
fn place(index: usize, topic: &str) -> String {
    format!("message {} of `{topic}`", index + 1)
}

/// The rows of a topic.
fn rows<'t>(
    messages: impl Iterator<Item = &'t Message>,
    wanted: &Wanted<'_>,
    present: Vec<bool>,
) -> Result<Table, Wrong> {
    let mut rows = Vec::new();
    for (index, message) in messages.enumerate() {
        let place = place(index, &message.topic);
        let value = match parsed(&message.text) {
            Ok(value) => value,
            Err(source) => return Err(Wrong::Json { place, source }),
        };
        let columns = || wanted.columns(&present);
        let cells: Vec<String> =
            columns().filter_map(|column| cell(&value, &column.name)).collect();
        let wanted = columns().count();
        if cells.len() != wanted {
            return Err(Wrong::Row { place, found: cells.len(), wanted });
        }
        rows.push(Row { place, cells });
    }
    Ok(Table { rows, present, notes: Vec::new() })
}

/// All messages in JSON, in the order of the file.
fn messages(bytes: &[u8]) -> Result<Vec<Message>, Wrong> {
    // Topics of the channels whose messages are JSON.
    let mut topics = HashMap::new();
    let mut messages = Vec::new();
    mcap::read(bytes, &mut |record| match record {
        Record::Channel { id, topic, encoding: "json" } => {
            topics.insert(id, topic.to_owned());
        }
        Record::Channel { .. } => {}
        Record::Message { channel, log_time: time, data } => {
            if let Some(topic) = topics.get(&channel) {
                messages.push(Message { time, topic: topic.clone(), text: data.to_vec() });
            }
        }
    })?;
    Ok(messages)
}

/// A message as JSON, `NaN` and `Infinity` included.
fn parsed(text: &[u8]) -> serde_json::Result<Value> {
    serde_json::from_slice(text).or_else(|error| match named_numbers_quoted(text) {
        Cow::Borrowed(_) => Err(error),
        Cow::Owned(quoted) => serde_json::from_slice(&quoted),
    })
}

/// Puts quotes around `NaN` and `Infinity` that are not within a text.
fn named_numbers_quoted(text: &[u8]) -> Cow<'_, [u8]> {
    let (mut quoted, mut rest, mut within) = (Vec::new(), text, false);
    let mut any = false;
    while let Some((first, behind)) = rest.split_first() {
        let name = [&b"NaN"[..], b"-Infinity", b"Infinity"];
        let name = name.into_iter().find(|name| !within && rest.starts_with(name));
        let count = match (name, first, behind) {
            (Some(name), ..) => {
                any = true;
                quoted.push(b'"');
                quoted.extend(name);
                quoted.push(b'"');
                rest = &rest[name.len()..];
                continue;
            }
            (None, b'\\', [_, ..]) if within => 2,
            _ => 1,
        };
        within ^= *first == b'"';
        let (these, others) = rest.split_at(count);
        quoted.extend(these);
        rest = others;
    }
    if any { Cow::Owned(quoted) } else { Cow::Borrowed(text) }
}

/// The names of all numbers and texts in a message, as columns have them.
fn names(value: &Value) -> Vec<String> {
    match value {
        Value::Object(fields) => {
            let parts = |(name, part): (&String, &Value)| parts(part, name);
            fields.iter().flat_map(parts).collect()
        }
        _ => Vec::new(),
    }
}

fn parts(value: &Value, name: &str) -> Vec<String> {
    let within: Vec<(String, &Value)> = match value {
        Value::Object(fields) => {
            fields.iter().map(|(field, part)| (format!("{name}.{field}"), part)).collect()
        }
        Value::Array(all) => {
            all.iter().enumerate().map(|(at, part)| (format!("{name}[{at}]"), part)).collect()
        }
        _ => return vec![name.to_owned()],
    };
    within.iter().flat_map(|(name, part)| parts(part, name)).collect()
}

/// The text of a field: by the column's name, or by its parts, one within the other.
fn cell(value: &Value, name: &str) -> Option<String> {
    let found = value.get(name).or_else(|| {
        let parts = name.split(['.', '[']);
        parts.map(|part| part.trim_end_matches(']')).try_fold(value, |value, part| match value {
            Value::Array(all) => all.get(part.parse::<usize>().ok()?),
            other => other.get(part),
        })
    })?;
    match found {
        Value::String(text) => Some(text.clone()),
        Value::Object(_) | Value::Array(_) => None,
        other => Some(other.to_string()),
    }
}
