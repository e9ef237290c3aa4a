//! Flights as files: CSV for everybody, MCAP for Foxglove and PlotJuggler.
//!
//! Both hold every signal of [`crate::channels`] at each control period. An MCAP topic is a JSON channel
//! with its schema; time 0 is take-off, and the second before it is there too.

use crate::channels::{TOPICS, Topic};
use crate::scenario::LEAD;
use crate::voyage::{Moment, Voyage};
use mcap::records::MessageHeader;
use serde_json::{Map, Number, Value, json};
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::io::{Cursor, Read};
use std::path::Path;

/// What went wrong with a file.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// It could not be read or written.
    #[error("`{path}`: {source}")]
    File {
        /// The file.
        path: String,
        /// What the system said.
        source: std::io::Error,
    },
    /// It is no MCAP file, or one that was cut off.
    #[error(
        "`{path}` is no whole MCAP file: {source}; record it again with `cargo xtask sim FLIGHT --out FOLDER`"
    )]
    Mcap {
        /// The file.
        path: String,
        /// What is wrong with it.
        source: mcap::McapError,
    },
    /// It does not hold what is looked for.
    #[error("`{path}` has no {what}; record it with `cargo xtask sim FLIGHT --out FOLDER`")]
    Lacks {
        /// The file.
        path: String,
        /// What is looked for.
        what: String,
    },
}

/// A flight as comma-separated values: a header `topic.signal [unit]`, and a line for each period.
pub fn csv(voyage: &Voyage) -> String {
    let mut text = String::from("time [s]");
    for topic in TOPICS {
        for signal in topic.signals {
            let _ = write!(text, ",{}.{} [{}]", topic.name, signal.name, signal.unit);
        }
    }
    text.push('\n');
    for moment in &voyage.moments {
        let _ = write!(text, "{:.3}", moment.time);
        for signal in TOPICS.iter().flat_map(|topic| topic.signals) {
            let _ = write!(text, ",{}", (signal.value)(moment));
        }
        text.push('\n');
    }
    text
}

/// A flight as an MCAP file; `about` says what flew.
///
/// # Errors
/// What the writer said.
pub fn mcap(voyage: &Voyage, about: &BTreeMap<String, String>) -> Result<Vec<u8>, mcap::McapError> {
    let mut bytes = Vec::new();
    let options = mcap::WriteOptions::new().compression(None).profile("").library("bessemer sim");
    let mut writer = options.create(Cursor::new(&mut bytes))?;
    let mut channels = Vec::new();
    for topic in TOPICS {
        let schema = writer.add_schema(topic.name, "jsonschema", schema(topic).as_bytes())?;
        let name = format!("/{}", topic.name);
        channels.push(writer.add_channel(schema, &name, "json", about)?);
    }
    for (sequence, moment) in voyage.moments.iter().enumerate() {
        let time = ((moment.time + LEAD) * 1e9).round() as u64;
        for (topic, channel_id) in TOPICS.iter().zip(&channels) {
            let header = MessageHeader {
                channel_id: *channel_id,
                sequence: sequence as u32,
                log_time: time,
                publish_time: time,
            };
            writer.write_to_known_channel(&header, message(topic, moment).as_bytes())?;
        }
    }
    writer.finish()?;
    drop(writer);
    Ok(bytes)
}

fn schema(topic: &Topic) -> String {
    let mut properties = Map::new();
    properties.insert("time".into(), json!({ "type": "number", "description": "s" }));
    for signal in topic.signals {
        let property = json!({ "type": "number", "description": signal.unit });
        properties.insert(signal.name.into(), property);
    }
    let title = topic.name;
    let about = topic.about;
    json!({ "title": title, "description": about, "type": "object", "properties": properties })
        .to_string()
}

fn message(topic: &Topic, moment: &Moment) -> String {
    let mut object = Map::new();
    object.insert("time".into(), number(moment.time));
    for signal in topic.signals {
        object.insert(signal.name.into(), number((signal.value)(moment)));
    }
    Value::Object(object).to_string()
}

/// JSON has no word for what is not a number.
fn number(value: f64) -> Value {
    Number::from_f64(value).map_or(Value::Null, Value::Number)
}

/// A flight as read back: a row of values for each period, by `topic.signal`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Log {
    /// What flew.
    pub about: BTreeMap<String, String>,
    columns: BTreeMap<String, Vec<f64>>,
    path: String,
}

impl Log {
    /// Reads an MCAP file that [`mcap`] wrote.
    ///
    /// # Errors
    /// The file cannot be read, or is none of ours.
    pub fn read(path: &Path) -> Result<Self, Error> {
        let name = path.display().to_string();
        let file = |source| Error::File { path: name.clone(), source };
        let mut bytes = Vec::new();
        std::fs::File::open(path)
            .and_then(|mut open| open.read_to_end(&mut bytes))
            .map_err(file)?;
        Self::of(&bytes, name)
    }

    /// Reads the bytes of an MCAP file; `path` is for messages.
    ///
    /// # Errors
    /// The bytes are no MCAP file, or none of ours.
    pub fn of(bytes: &[u8], path: String) -> Result<Self, Error> {
        let broken = |source| Error::Mcap { path: path.clone(), source };
        let mut log = Self { path: path.clone(), ..Self::default() };
        for message in mcap::MessageStream::new(bytes).map_err(broken)? {
            let message = message.map_err(|source| Error::Mcap { path: path.clone(), source })?;
            let topic = message.channel.topic.trim_start_matches('/');
            let lacks = |what: &str| Error::Lacks { path: path.clone(), what: what.to_owned() };
            let Ok(Value::Object(object)) = serde_json::from_slice(&message.data) else {
                return Err(lacks("JSON messages"));
            };
            for (name, value) in &object {
                let column = log.columns.entry(format!("{topic}.{name}")).or_default();
                column.push(value.as_f64().unwrap_or(f64::NAN));
            }
            if log.about.is_empty() {
                log.about.clone_from(&message.channel.metadata);
            }
        }
        Ok(log)
    }

    /// The error that something is not in it.
    pub fn lacks(&self, what: &str) -> Error {
        Error::Lacks { path: self.path.clone(), what: what.to_owned() }
    }

    /// The values of a signal, `topic.name`.
    ///
    /// # Errors
    /// There is no such signal.
    pub fn column(&self, name: &str) -> Result<&[f64], Error> {
        let lacks = || self.lacks(&format!("signal `{name}`"));
        self.columns.get(name).map(Vec::as_slice).ok_or_else(lacks)
    }
}
