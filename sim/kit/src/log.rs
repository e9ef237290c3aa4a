//! Recordings as MCAP files, which Foxglove and PlotJuggler open.
//!
//! Each channel is a topic `/name` of JSON messages `{"value": 1.5}` with a schema. JSON has no NaN and no infinity: they are `null`.

use std::collections::BTreeMap;
use std::io::Cursor;

use mcap::records::MessageHeader;
use mcap::{Compression, McapError, WriteOptions};

use crate::error::Error;
use crate::recording::{Recorded, Recording};

impl Recording {
    /// Formats the recording as an MCAP file, compressed by LZ4, with messages in order of time.
    ///
    /// # Errors
    ///
    /// The writer fails.
    pub fn mcap(&self) -> Result<Vec<u8>, Error> {
        self.written().map_err(|error| Error::Write(error.to_string()))
    }

    fn written(&self) -> Result<Vec<u8>, McapError> {
        let mut bytes = Vec::new();
        let options = WriteOptions::new()
            .compression(Some(Compression::Lz4))
            .profile("")
            .library(concat!("bessemer-sim ", env!("CARGO_PKG_VERSION")));
        let mut writer = options.create(Cursor::new(&mut bytes))?;
        let mut topics = Vec::new();
        for channel in self.channels() {
            let schema =
                writer.add_schema(channel.name(), "jsonschema", schema(channel).as_bytes())?;
            let topic = format!("/{}", channel.name());
            topics.push(writer.add_channel(schema, &topic, "json", &BTreeMap::new())?);
        }
        for (sequence, (log_time, samples)) in (0_u32..).zip(self.rows()) {
            for (&channel_id, value) in topics.iter().zip(samples) {
                let Some(value) = value else { continue };
                let text = if value.is_finite() { value.to_string() } else { "null".to_owned() };
                let header =
                    MessageHeader { channel_id, sequence, log_time, publish_time: log_time };
                writer
                    .write_to_known_channel(&header, format!("{{\"value\":{text}}}").as_bytes())?;
            }
        }
        writer.finish()?;
        drop(writer);
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
