//! Recordings of flights: CSV, and MCAP for Foxglove and PlotJuggler.
//!
//! Both contain every signal of [`crate::channels`] in each control period. An MCAP topic is a JSON channel with its
//! schema. Its times count from the first period, which is [`LEAD`] before take-off at time 0. The topics `/pose/…`
//! are for Foxglove's 3D panel. [`channels`] and [`messages`] provide the topics without a file.

use crate::channels::{TOPICS, Topic};
use crate::plant::rotation;
use crate::scenario::LEAD;
use crate::voyage::{Moment, Voyage};
use bessemer_sim::Recording;
use bessemer_sim::log::{self, McapError};
use nalgebra::{Rotation3, UnitQuaternion, Vector3};
use serde_json::{Map, Number, Value, json};
use std::collections::BTreeMap;
use std::io::{Cursor, Read, Seek, Write};
use std::path::Path;

/// Errors of a recording.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The file could not be read or written.
    #[error("`{path}`: {source}")]
    File {
        /// The file.
        path: String,
        /// An error of the system.
        source: std::io::Error,
    },
    /// The file is not an MCAP file, or it was cut off.
    #[error(
        "`{path}` is no whole MCAP file: {source}; record it again with `cargo xtask sim FLIGHT --out FOLDER`"
    )]
    Mcap {
        /// The file.
        path: String,
        /// Error of the file.
        source: McapError,
    },
    /// The file lacks a signal or a description.
    #[error("`{path}` has no {what}; record it with `cargo xtask sim FLIGHT --out FOLDER`")]
    Lacks {
        /// The file.
        path: String,
        /// The missing content.
        what: String,
    },
}

/// Returns every signal of a flight as a channel `topic.signal`. Times in s count from take-off.
///
/// # Errors
///
/// A name or a unit that some format cannot write: a defect of [`TOPICS`].
pub fn recording(voyage: &Voyage) -> Result<Recording, bessemer_sim::Error> {
    let mut recording = Recording::new(LEAD)?;
    let mut channels = Vec::new();
    for topic in TOPICS {
        for signal in topic.signals {
            let unit = if signal.unit.is_empty() { "1" } else { signal.unit };
            channels.push(recording.add(&format!("{}.{}", topic.name, signal.name), unit)?);
        }
    }
    for moment in &voyage.moments {
        let signals = TOPICS.iter().flat_map(|topic| topic.signals);
        for (channel, signal) in channels.iter().zip(signals) {
            recording.sample(*channel, log_time(moment.time), (signal.value)(moment))?;
        }
    }
    Ok(recording)
}

/// Formats a flight as comma-separated values: a header `topic.signal [unit]`, and a line for each period.
///
/// # Errors
///
/// As of [`recording`].
pub fn csv(voyage: &Voyage) -> Result<String, bessemer_sim::Error> {
    Ok(recording(voyage)?.csv())
}

/// Formats a flight as an MCAP file; `about` describes the flight.
///
/// # Errors
///
/// The message of the writer.
pub fn mcap(voyage: &Voyage, about: &BTreeMap<String, String>) -> Result<Vec<u8>, McapError> {
    let mut bytes = Vec::new();
    let mut writer = Writer::new(Cursor::new(&mut bytes), about)?;
    for moment in &voyage.moments {
        writer.moment(moment)?;
    }
    writer.finish()?;
    Ok(bytes)
}

/// Writes an MCAP file moment by moment.
pub struct Writer<W: Write + Seek> {
    log: log::Log<W>,
    channels: Vec<log::Topic>,
    raw: BTreeMap<String, log::Topic>,
    sequence: u32,
}

impl<W: Write + Seek> Writer<W> {
    /// Starts a file; `about` describes the flight.
    ///
    /// # Errors
    ///
    /// The message of the writer.
    pub fn new(sink: W, about: &BTreeMap<String, String>) -> Result<Self, McapError> {
        let mut log = log::Log::new(sink, about)?;
        let all = channels().map(|it| log.json(&it.topic, &it.schema, &it.text));
        let channels = all.collect::<Result<_, _>>()?;
        Ok(Self { log, channels, raw: BTreeMap::new(), sequence: 0 })
    }

    /// Adds a topic of bytes in a private format; `about` describes them.
    ///
    /// # Errors
    ///
    /// The message of the writer.
    pub fn raw(&mut self, topic: &str, encoding: &str, about: &str) -> Result<(), McapError> {
        self.raw.insert(topic.to_owned(), self.log.raw(topic, encoding, about)?);
        Ok(())
    }

    /// Adds a topic of JSON messages with this schema, written by [`bytes`](Writer::bytes).
    ///
    /// # Errors
    /// What the writer said.
    pub fn json(&mut self, topic: &str, name: &str, schema: &str) -> Result<(), McapError> {
        self.raw.insert(topic.to_owned(), self.log.json(topic, name, schema)?);
        Ok(())
    }

    /// Writes a moment to every topic.
    ///
    /// # Errors
    ///
    /// The message of the writer.
    pub fn moment(&mut self, moment: &Moment) -> Result<(), McapError> {
        let time = log_time(moment.time);
        for (topic, message) in self.channels.iter().zip(messages(moment)) {
            self.log.write(*topic, self.sequence, time, message.as_bytes())?;
        }
        self.sequence = self.sequence.wrapping_add(1);
        Ok(())
    }

    /// Writes bytes with a time, s, to a topic that [`raw`](Writer::raw) added; does nothing for another topic.
    ///
    /// # Errors
    ///
    /// The message of the writer.
    pub fn bytes(&mut self, topic: &str, time: f64, bytes: &[u8]) -> Result<(), McapError> {
        match self.raw.get(topic) {
            Some(topic) => self.log.write(*topic, self.sequence, log_time(time), bytes),
            None => Ok(()),
        }
    }

    /// Finishes the file.
    ///
    /// # Errors
    ///
    /// The message of the writer.
    pub fn finish(self) -> Result<(), McapError> {
        self.log.finish()
    }
}

/// A JSON channel.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Channel {
    /// Topic of the channel.
    pub topic: String,
    /// Name of the schema.
    pub schema: String,
    /// Text of the JSON schema.
    pub text: String,
}

/// Returns the channels of a flight.
pub fn channels() -> impl Iterator<Item = Channel> {
    let signals = TOPICS.iter().map(|topic| Channel {
        topic: format!("/{}", topic.name),
        schema: topic.name.to_owned(),
        text: schema(topic),
    });
    let poses = ["/pose/true", "/pose/estimated"].map(|topic| Channel {
        topic: topic.to_owned(),
        schema: "foxglove.PoseInFrame".to_owned(),
        text: POSE.to_owned(),
    });
    signals.chain(poses)
}

/// Formats a period as JSON: a message for each of the [`channels`], in their order.
pub fn messages(moment: &Moment) -> impl Iterator<Item = String> + '_ {
    let (state, estimate) = (&moment.state, &moment.outputs.estimate);
    let poses = [(&state.position, &state.angles), (&estimate.position, &estimate.angles)];
    let time = log_time(moment.time);
    let signals = TOPICS.iter().map(|topic| message(topic, moment));
    signals.chain(poses.into_iter().map(move |(place, angles)| pose(time, place, angles)))
}

/// Converts a time of a flight, s, to the time of recordings, ns.
pub fn log_time(time: f64) -> u64 {
    ((time + LEAD) * 1e9).round() as u64
}

/// The fields of Foxglove's schema of a pose that are used here.
const POSE: &str = r#"{"title":"foxglove.PoseInFrame","type":"object","properties":{
"timestamp":{"type":"object","title":"time","properties":{"sec":{"type":"integer"},"nsec":{"type":"integer"}}},
"frame_id":{"type":"string"},
"pose":{"title":"foxglove.Pose","type":"object","properties":{
"position":{"title":"foxglove.Vector3","type":"object","properties":{"x":{"type":"number"},"y":{"type":"number"},"z":{"type":"number"}}},
"orientation":{"title":"foxglove.Quaternion","type":"object","properties":{"x":{"type":"number"},"y":{"type":"number"},"z":{"type":"number"},"w":{"type":"number"}}}}}}}"#;

/// Returns the pose of the aircraft in the room, in Foxglove's format; `time` in ns.
fn pose(time: u64, position: &Vector3<f64>, angles: &Vector3<f64>) -> String {
    let turn = Rotation3::from_matrix_unchecked(rotation(angles));
    let turn = UnitQuaternion::from_rotation_matrix(&turn);
    json!({
        "timestamp": { "sec": time / 1_000_000_000, "nsec": time % 1_000_000_000 },
        "frame_id": "room",
        "pose": {
            "position": { "x": number(position.x), "y": number(position.y), "z": number(position.z) },
            "orientation": {
                "x": number(turn.i), "y": number(turn.j), "z": number(turn.k), "w": number(turn.w),
            },
        },
    })
    .to_string()
}

/// Returns the names of a signal's values, if they are numbers of named states.
fn words(name: &str) -> Option<Vec<String>> {
    let all = |count: u8, name: fn(u8) -> String| Some((0..count).map(name).collect());
    match name {
        "phase" => all(6, |n| {
            use models::Phase::{Flight, Hold, Landing, Over, Ready, TakeOff};
            format!("{:?}", [Ready, TakeOff, Flight, Landing, Over, Hold][usize::from(n)])
        }),
        "alarm" => all(11, |n| {
            use models::Alarm::{
                Clear, Clock, Commanded, Height, Impact, Position, Speed, Spin, Tilt, Undefined,
                Unmeasured,
            };
            let named = [
                Clear, Commanded, Undefined, Clock, Unmeasured, Tilt, Spin, Speed, Height,
                Position, Impact,
            ];
            format!("{:?}", named[usize::from(n)])
        }),
        _ => None,
    }
}

fn schema(topic: &Topic) -> String {
    let mut properties = Map::new();
    properties.insert("time".into(), json!({ "type": "number", "description": "s" }));
    for signal in topic.signals {
        let mut property = json!({ "type": "number", "description": signal.unit });
        if let Some(words) = words(signal.name) {
            let named = words.iter().enumerate().map(|(n, it)| json!({ "title": it, "const": n }));
            property["oneOf"] = named.collect();
        }
        properties.insert(signal.name.into(), property);
    }
    let title = topic.name;
    let about = topic.about;
    json!({ "title": title, "description": about, "type": "object", "properties": properties })
        .to_string()
}

fn message(topic: &Topic, moment: &Moment) -> String {
    let mut object = Map::new();
    object.insert("time".into(), number(moment.time + LEAD));
    for signal in topic.signals {
        object.insert(signal.name.into(), number((signal.value)(moment)));
    }
    Value::Object(object).to_string()
}

/// Converts a number to JSON, which cannot represent NaN and infinities.
fn number(value: f64) -> Value {
    Number::from_f64(value).map_or(Value::Null, Value::Number)
}

/// A flight read from a file: a row of values for each period, by `topic.signal`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Log {
    /// Description of the flight.
    pub about: BTreeMap<String, String>,
    columns: BTreeMap<String, Vec<f64>>,
    path: String,
}

impl Log {
    /// Reads an MCAP file that [`mcap`] wrote.
    ///
    /// # Errors
    ///
    /// The file cannot be read, or was not written by [`mcap`].
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
    ///
    /// The bytes are not an MCAP file written by [`mcap`].
    pub fn of(bytes: &[u8], path: String) -> Result<Self, Error> {
        let broken = |source| Error::Mcap { path: path.clone(), source };
        let mut log = Self { path: path.clone(), ..Self::default() };
        for message in mcap::MessageStream::new(bytes).map_err(broken)? {
            let message = message.map_err(|source| Error::Mcap { path: path.clone(), source })?;
            let ours =
                TOPICS.iter().any(|it| message.channel.topic.strip_prefix('/') == Some(it.name));
            if message.channel.message_encoding != "json" || !ours {
                continue;
            }
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

    /// Returns the error for missing content.
    pub fn lacks(&self, what: &str) -> Error {
        Error::Lacks { path: self.path.clone(), what: what.to_owned() }
    }

    /// Returns the values of the signal `topic.name`.
    ///
    /// # Errors
    ///
    /// There is no such signal.
    pub fn column(&self, name: &str) -> Result<&[f64], Error> {
        let lacks = || self.lacks(&format!("signal `{name}`"));
        self.columns.get(name).map(Vec::as_slice).ok_or_else(lacks)
    }
}
