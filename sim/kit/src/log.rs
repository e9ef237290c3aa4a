//! MCAP files, which Foxglove and PlotJuggler open: of a recording, or of any topics message by message.
//!
//! Knows no simulation; times are in ns.

use std::collections::BTreeMap;
use std::io::{Cursor, Seek, Write};

pub use mcap::McapError;
use mcap::records::MessageHeader;
use mcap::{Compression, WriteOptions};

use crate::error::Error;
use crate::recording::{Recorded, Recording};

/// Topic of a [`Log`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Topic(u16);

/// Writer of an MCAP file, compressed by LZ4. A program that is killed loses the chunk that it was writing.
pub struct Log<W: Write + Seek> {
    writer: mcap::Writer<W>,
    metadata: BTreeMap<String, String>,
}

impl<W: Write + Seek> Log<W> {
    /// Begins a file; each of its topics has the metadata.
    ///
    /// # Errors
    ///
    /// The sink fails.
    pub fn new(sink: W, metadata: &BTreeMap<String, String>) -> Result<Self, McapError> {
        let options = WriteOptions::new()
            .compression(Some(Compression::Lz4))
            .profile("")
            .library(concat!("bessemer-sim ", env!("CARGO_PKG_VERSION")));
        Ok(Self { writer: options.create(sink)?, metadata: metadata.clone() })
    }

    /// Adds a topic of JSON messages with a JSON schema of a name.
    ///
    /// # Errors
    ///
    /// The sink fails.
    pub fn json(&mut self, topic: &str, name: &str, schema: &str) -> Result<Topic, McapError> {
        let schema = self.writer.add_schema(name, "jsonschema", schema.as_bytes())?;
        Ok(Topic(self.writer.add_channel(schema, topic, "json", &self.metadata)?))
    }

    /// Adds a topic of bytes in a format of your own; `about` describes it.
    ///
    /// # Errors
    ///
    /// The sink fails.
    pub fn raw(&mut self, topic: &str, format: &str, about: &str) -> Result<Topic, McapError> {
        let schema = self.writer.add_schema(format, format, about.as_bytes())?;
        Ok(Topic(self.writer.add_channel(schema, topic, format, &self.metadata)?))
    }

    /// Writes a message with its number and its time, ns.
    ///
    /// # Errors
    ///
    /// The sink fails.
    pub fn write(
        &mut self,
        topic: Topic,
        sequence: u32,
        time: u64,
        message: &[u8],
    ) -> Result<(), McapError> {
        let (channel_id, log_time, publish_time) = (topic.0, time, time);
        let header = MessageHeader { channel_id, sequence, log_time, publish_time };
        self.writer.write_to_known_channel(&header, message)
    }

    /// Finishes the file: a reader needs its end.
    ///
    /// # Errors
    ///
    /// The sink fails.
    pub fn finish(mut self) -> Result<(), McapError> {
        self.writer.finish().map(drop)
    }
}

impl Recording {
    /// Formats the recording as an MCAP file, compressed by LZ4, with messages in order of time.
    ///
    /// Each channel is a topic `/name` of JSON messages `{"value": 1.5}` with a schema. JSON has no NaN and no infinity: they are `null`.
    ///
    /// # Errors
    ///
    /// The writer fails.
    pub fn mcap(&self) -> Result<Vec<u8>, Error> {
        self.written().map_err(|error| Error::Write(error.to_string()))
    }

    fn written(&self) -> Result<Vec<u8>, McapError> {
        let mut bytes = Vec::new();
        let mut log = Log::new(Cursor::new(&mut bytes), &BTreeMap::new())?;
        let mut topics = Vec::new();
        for channel in self.channels() {
            topics.push(log.json(
                &format!("/{}", channel.name()),
                channel.name(),
                &schema(channel),
            )?);
        }
        for (sequence, (time, samples)) in (0_u32..).zip(self.rows()) {
            for (topic, value) in topics.iter().zip(samples) {
                let Some(value) = value else { continue };
                let text = if value.is_finite() { value.to_string() } else { "null".to_owned() };
                log.write(*topic, sequence, time, format!("{{\"value\":{text}}}").as_bytes())?;
            }
        }
        log.finish()?;
        Ok(bytes)
    }
}

/// Returns the JSON schema of a channel. Names and units have no character that JSON escapes.
fn schema(channel: &Recorded) -> String {
    format!(
        r#"{{"type":"object","title":"{}","properties":{{"value":{{"type":["number","null"],"description":"{}"}}}}}}"#,
        channel.name(),
        channel.unit()
    )
}
