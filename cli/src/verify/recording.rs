//! Recorded inputs of an entry point: a table with a column for each number that goes in, a row for each call. It comes from
//! CSV, or from an MCAP file, whose messages in JSON are rows.
//!
//! Columns are called as the parameters and their parts are in the Rust: `target`, `gains.p`, `position[2]`. Elements of a
//! matrix count by columns. Columns of other names are let be, so that a log can be taken as it is. Of an MCAP file the first topic is
//! taken that has them all. The component begins in its initial state, and lives from row to row.

use bessemer_ir::{Float, Form, Function, Int, Module, Scalar, Type};
use serde_json::Value;

/// First bytes of an MCAP file.
const MCAP: &[u8] = b"\x89MCAP0\r\n";

/// Errors of a recording with their place; lines and messages count from 1.
#[derive(Debug, thiserror::Error)]
pub enum Wrong {
    /// A number has no column.
    #[error("it has no column `{column}`; wanted are {wanted}")]
    Column {
        /// The missing column.
        column: String,
        /// All that are wanted.
        wanted: String,
    },
    /// No topic has all columns.
    #[error("none of its topics has the columns {wanted}; in JSON are {found}")]
    Topic {
        /// All that are wanted.
        wanted: String,
        /// The topics.
        found: String,
    },
    /// A row has another length than the head.
    #[error("{place} has {found} columns, and the first {wanted}")]
    Row {
        /// The ambiguous place.
        place: String,
        /// Number of cells found.
        found: usize,
        /// Number of cells expected.
        wanted: usize,
    },
    /// A cell is no value of its type.
    #[error("{place}: `{text}` is no {kind}, as `{column}` has to be")]
    Cell {
        /// Place of the cell.
        place: String,
        /// In which column.
        column: String,
        /// Text of the cell.
        text: String,
        /// Expected kind of the cell.
        kind: String,
    },
    /// There is no row.
    #[error("it has no rows")]
    Empty,
    /// It is no text of the kind.
    #[error("it is no CSV: {0}")]
    Csv(#[from] csv::Error),
    /// It is an MCAP file that cannot be read.
    #[error("it is no whole MCAP file: {0}")]
    Mcap(#[from] mcap::McapError),
}

/// The words of the arguments of each call, without those of the component.
///
/// # Errors
/// What is wrong, and where.
pub fn calls(
    module: &Module,
    function: &Function,
    bytes: &[u8],
) -> Result<Vec<Vec<Vec<u64>>>, Wrong> {
    let parameters = function.parameters();
    let parameters = &parameters[1.min(parameters.len())..];
    let columns: Vec<Vec<Column>> = parameters
        .iter()
        .map(|parameter| {
            let mut columns = Vec::new();
            columns_of(module, &parameter.ty, &parameter.name, &mut columns);
            columns
        })
        .collect();
    let names: Vec<&str> = columns.iter().flatten().map(|it| it.name.as_str()).collect();
    let rows =
        if bytes.starts_with(MCAP) { of_mcap(bytes, &names)? } else { of_csv(bytes, &names)? };
    if rows.is_empty() {
        return Err(Wrong::Empty);
    }
    let call = |Row { place, cells }: Row| {
        let mut cells = cells.into_iter();
        let argument = |(columns, parameter): (&Vec<Column>, &bessemer_ir::Local)| {
            let word = |(column, text): (&Column, String)| {
                column.word(module, &text).ok_or_else(|| Wrong::Cell {
                    place: place.clone(),
                    column: column.name.clone(),
                    text,
                    kind: column.kind(module),
                })
            };
            let words = columns.iter().zip(cells.by_ref()).map(word);
            let mut words = words.collect::<Result<Vec<u64>, _>>()?;
            module.canonical(&parameter.ty, &mut words);
            Ok(words)
        };
        columns.iter().zip(parameters).map(argument).collect()
    };
    rows.into_iter().map(call).collect()
}

/// Inputs of one call: the needed cells in order.
struct Row {
    place: String,
    cells: Vec<String>,
}

fn of_csv(bytes: &[u8], wanted: &[&str]) -> Result<Vec<Row>, Wrong> {
    let mut reader = csv::ReaderBuilder::new();
    let reader = reader.has_headers(false).flexible(true).trim(csv::Trim::All);
    let blank = |it: &csv::StringRecord| it.iter().all(str::is_empty);
    let mut lines = reader.from_reader(bytes).into_records();
    let mut next = || lines.by_ref().find(|line| !line.as_ref().is_ok_and(blank)).transpose();
    let head = next()?.ok_or(Wrong::Empty)?;
    let place = |name: &&str| {
        head.iter()
            .position(|it| it == *name)
            .ok_or_else(|| Wrong::Column { column: (*name).to_owned(), wanted: listed(wanted) })
    };
    let places: Vec<usize> = wanted.iter().map(place).collect::<Result<_, _>>()?;
    let mut rows = Vec::new();
    while let Some(line) = next()? {
        let place = format!("line {}", line.position().map_or(0, csv::Position::line));
        if line.len() != head.len() {
            return Err(Wrong::Row { place, found: line.len(), wanted: head.len() });
        }
        let cells = places.iter().map(|place| line[*place].to_owned()).collect();
        rows.push(Row { place, cells });
    }
    Ok(rows)
}

fn of_mcap(bytes: &[u8], wanted: &[&str]) -> Result<Vec<Row>, Wrong> {
    let (mut rows, mut chosen, mut topics) = (Vec::new(), None, Vec::new());
    for message in mcap::MessageStream::new(bytes)? {
        let message = message?;
        let topic = &message.channel.topic;
        if message.channel.message_encoding != "json"
            || chosen.as_ref().is_some_and(|it| it != topic)
        {
            continue;
        }
        let Ok(value) = serde_json::from_slice::<Value>(&message.data) else { continue };
        let cells: Option<Vec<String>> = wanted.iter().map(|name| cell(&value, name)).collect();
        let place = format!("message {} of `{topic}`", rows.len() + 1);
        match cells {
            Some(cells) => {
                chosen.get_or_insert_with(|| topic.clone());
                rows.push(Row { place, cells });
            }
            None if chosen.is_some() => {
                let found = wanted.iter().filter(|name| cell(&value, name).is_some()).count();
                return Err(Wrong::Row { place, found, wanted: wanted.len() });
            }
            None if topics.contains(topic) => {}
            None => topics.push(topic.clone()),
        }
    }
    if chosen.is_none() {
        let topics: Vec<&str> = topics.iter().map(String::as_str).collect();
        return Err(Wrong::Topic { wanted: listed(wanted), found: listed(&topics) });
    }
    Ok(rows)
}

/// Returns the value of a message under a column's name, as one key or as nested keys.
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

/// Names, as a message lists them.
fn listed(names: &[&str]) -> String {
    if names.is_empty() {
        return "none".to_owned();
    }
    names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ")
}

/// A number that goes in.
struct Column {
    name: String,
    ty: Type,
    /// Largest length of a list.
    most: Option<u32>,
}

/// The numbers in a value, in the order of their words.
fn columns_of(module: &Module, ty: &Type, name: &str, columns: &mut Vec<Column>) {
    let column = |name: String, ty: Type| Column { name, ty, most: None };
    match ty {
        Type::Unit | Type::Slice(_) => {}
        Type::Scalar(_) | Type::Enum(_) => columns.push(column(name.to_owned(), ty.clone())),
        Type::Array { element, len } => {
            (0..*len).for_each(|n| columns_of(module, element, &format!("{name}[{n}]"), columns));
        }
        Type::Matrix { element, rows, cols } => {
            let element = Type::Scalar(*element);
            let one = |n| column(format!("{name}[{n}]"), element.clone());
            columns.extend((0..rows * cols).map(one));
        }
        Type::Struct(id) => {
            let item = &module.structs[id.index()];
            let first = columns.len();
            for field in &item.fields {
                columns_of(module, &field.ty, &format!("{name}.{}", field.name), columns);
            }
            if item.form == Form::Sequence
                && let Type::Array { len, .. } = item.fields[1].ty
            {
                columns[first].most = Some(len);
            }
        }
    }
}

impl Column {
    /// The word that a cell says; none if it is no value of the type.
    fn word(&self, module: &Module, text: &str) -> Option<u64> {
        match &self.ty {
            Type::Scalar(Scalar::Float(Float::F64)) => text.parse().ok().map(f64::to_bits),
            Type::Scalar(Scalar::Float(Float::F32)) => {
                text.parse().ok().map(|number: f32| u64::from(number.to_bits()))
            }
            Type::Scalar(Scalar::Int(int)) => {
                let number: i128 = text.parse().ok()?;
                (Int::min(*int)..=self.largest(*int)).contains(&number).then_some(number as u64)
            }
            Type::Scalar(Scalar::Bool) => match text {
                "true" | "1" => Some(1),
                "false" | "0" => Some(0),
                _ => None,
            },
            Type::Enum(id) => {
                let variants = &module.enums[id.index()].variants;
                let found = variants.iter().position(|it| it.name == text);
                found.map(|index| index as u64)
            }
            _ => None,
        }
    }

    fn largest(&self, int: Int) -> i128 {
        self.most.map_or(Int::max(int), i128::from)
    }

    /// Describes the expected content of a cell.
    fn kind(&self, module: &Module) -> String {
        match &self.ty {
            Type::Scalar(Scalar::Float(_)) => "number".to_owned(),
            Type::Scalar(Scalar::Int(int)) => {
                format!("whole number from {} to {}", Int::min(*int), self.largest(*int))
            }
            Type::Scalar(Scalar::Bool) => "`true` or `false`".to_owned(),
            Type::Enum(id) => format!("variant of `{}`", module.enums[id.index()].name),
            _ => "value".to_owned(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_become_calls_and_mistakes_are_placed() {
        let text = include_str!("../../../codegen/backend/tests/c/height.ir");
        let module = bessemer_ir::text::parse(text).expect("it is a module");
        let entry = |it: &&Function| matches!(it.role, bessemer_ir::Role::Entry { .. });
        let function = module.functions.iter().find(entry).expect("an entry point");
        let mut columns = Vec::new();
        for parameter in &function.parameters()[1..] {
            columns_of(&module, &parameter.ty, &parameter.name, &mut columns);
        }
        let names: Vec<&str> = columns.iter().map(|column| column.name.as_str()).collect();
        let cell = |column: &Column| match column.ty {
            Type::Scalar(Scalar::Bool) => "true",
            _ => "-2.5",
        };
        let cells: Vec<&str> = columns.iter().map(cell).collect();
        let (head, row) = (names.join(","), cells.join(" , "));
        let text = format!("time,{head}\n\n0.5,{row}\n1,{row}\n");
        let read = calls(&module, function, text.as_bytes());
        let read = read.expect("a recording");
        assert_eq!(read.len(), 2);
        let words: Vec<u64> = read[0].concat();
        assert_eq!(words.len(), columns.len());
        assert!(words.contains(&(-2.5_f64).to_bits()), "{words:x?}");

        let said =
            |text: &str| calls(&module, function, text.as_bytes()).expect_err(text).to_string();
        assert!(said(&format!("{head}\n")).contains("no rows"));
        assert!(said("time\n1\n").starts_with("it has no column `"));
        assert!(said(&format!("{head}\n1,{row}\n")).starts_with("line 2 has "));
        let wrong = row.replacen("-2.5", "high", 1);
        let expected = "line 2: `high` is no number, as `";
        assert!(said(&format!("{head}\n{wrong}\n")).starts_with(expected));
    }
    /// An MCAP file with messages of two topics.
    fn recorded(messages: &[(&str, &str)]) -> Vec<u8> {
        let mut file = std::io::Cursor::new(Vec::new());
        let mut writer = mcap::Writer::new(&mut file).expect("a file");
        for (topic, text) in messages {
            let channel = writer.add_channel(0, topic, "json", &Default::default());
            let channel_id = channel.expect("a channel");
            let header = mcap::records::MessageHeader {
                channel_id,
                sequence: 0,
                log_time: 0,
                publish_time: 0,
            };
            writer.write_to_known_channel(&header, text.as_bytes()).expect("a file");
        }
        writer.finish().expect("a file");
        drop(writer);
        file.into_inner()
    }

    #[test]
    fn messages_become_rows() {
        let other = ("/other", r#"{"a": 1}"#);
        let good = ("/log", r#"{"a": 0.1, "b.c": true, "d": [1, -2], "more": {}}"#);
        let nested = ("/log", r#"{"a": 1e300, "b": {"c": false}, "d": [1, 7]}"#);
        let wanted = ["a", "b.c", "d[1]"];
        let rows = of_mcap(&recorded(&[other, good, other, nested]), &wanted).expect("rows");
        let cells: Vec<_> = rows.iter().map(|row| row.cells.join(" ")).collect();
        assert_eq!(cells, ["0.1 true -2", "1e+300 false 7"]);
        assert_eq!(rows[1].place, "message 2 of `/log`");

        let said =
            |bytes: &[u8]| of_mcap(bytes, &wanted).map(|_| ()).expect_err("wrong").to_string();
        let none = "none of its topics has the columns `a`, `b.c`, `d[1]`; in JSON are `/other`";
        assert_eq!(said(&recorded(&[other, other])), none);
        let short = ("/log", r#"{"a": 1, "d": [1, 7]}"#);
        assert_eq!(
            said(&recorded(&[good, short])),
            "message 2 of `/log` has 2 columns, and the first 3"
        );
        let whole = recorded(&[good]);
        assert!(said(&whole[..whole.len() / 2]).starts_with("it is no whole MCAP file"));
    }
}
