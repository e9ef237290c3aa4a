//! Reads the file of a recording; if it is truncated, its complete chunks.
//!
//! If the program was killed or the disk was full, a file has no end, and its last chunk may be incomplete. The
//! chunks before it are intact. Must not know the contents of the messages.

use crate::recorder::AIRCRAFT;
use crate::replay::Error;
use mcap::read::ChunkReader;
use mcap::records::{Record, op};
use mcap::{MAGIC, MessageStream};
use sim::Aircraft;
use std::path::Path;

/// Data-end record without a checksum: operation, length, content.
const DATA_END: [u8; 13] = [op::DATA_END, 4, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0];

/// A recording in memory.
#[derive(Debug)]
pub struct Recorded {
    bytes: Vec<u8>,
    /// Bytes without a whole chunk at the end of a truncated file.
    pub missing: Option<usize>,
}

impl Recorded {
    /// Reads a file; if it is truncated, up to its last complete chunk.
    ///
    /// # Errors
    /// It cannot be read, or is no recording.
    pub fn read(path: &Path) -> Result<Self, Error> {
        let bytes = std::fs::read(path);
        let bytes = bytes.map_err(|source| Error::File { path: path.to_owned(), source })?;
        if !bytes.starts_with(MAGIC) {
            let source = mcap::McapError::BadMagic;
            return Err(Error::Mcap { path: path.to_owned(), source });
        }
        Ok(Self::of(bytes))
    }

    /// Returns the recording in bytes that begin with the magic.
    fn of(mut bytes: Vec<u8>) -> Self {
        let Some(whole) = truncated(&bytes) else { return Self { bytes, missing: None } };
        let missing = Some(bytes.len() - whole);
        bytes.truncate(whole);
        bytes.extend(DATA_END);
        Self { bytes, missing }
    }

    /// Returns the aircraft of the flight. Recordings of earlier versions, which do not name it, are of the Mambo.
    ///
    /// # Errors
    ///
    /// The file at `path` is damaged, or is a flight of an unknown aircraft.
    pub fn aircraft(&self, path: &Path) -> Result<Aircraft, Error> {
        let broken = |source| Error::Mcap { path: path.to_owned(), source };
        let first = self.messages().and_then(|mut all| all.next().transpose()).map_err(broken)?;
        let Some(name) = first.as_ref().and_then(|it| it.channel.metadata.get(AIRCRAFT)) else {
            return Ok(Aircraft::Mambo);
        };
        let unknown = || Error::Aircraft { path: path.to_owned(), name: name.clone() };
        Aircraft::named(name).ok_or_else(unknown)
    }

    /// Iterates over the messages in file order.
    ///
    /// # Errors
    ///
    /// The file is damaged.
    pub fn messages(&self) -> mcap::McapResult<MessageStream<'_>> {
        let options = self.missing.map(|_| mcap::read::Options::IgnoreEndMagic);
        MessageStream::new_with_options(&self.bytes, options.into_iter().collect())
    }
}

/// Returns the length of the intact records of a truncated recording; `None` for a complete one.
fn truncated(bytes: &[u8]) -> Option<usize> {
    let (mut at, mut records) = (MAGIC.len(), Vec::new());
    while let Some((&[operation, ref length @ ..], rest)) =
        bytes.get(at..).and_then(|rest| rest.split_first_chunk::<9>())
    {
        let length = usize::try_from(u64::from_le_bytes(*length)).unwrap_or(usize::MAX);
        // An unfinished chunk has no length yet.
        let Some((body, rest)) = rest.split_at_checked(length) else { break };
        if operation == op::FOOTER && rest == MAGIC {
            return None;
        }
        at += 9 + length;
        records.push((operation, body, at));
    }
    // The index behind the data needs the end of the file. A disk may leave zeros in unwritten blocks.
    let data = records.into_iter().take_while(|(operation, ..)| *operation != op::DATA_END);
    let sound = data.take_while(|(operation, body, _)| is_sound(*operation, body));
    Some(sound.last().map_or(MAGIC.len(), |(_, _, end)| end))
}

/// Returns true if a record can be read; for a chunk, every record in it.
fn is_sound(operation: u8, body: &[u8]) -> bool {
    match mcap::parse_record(operation, body) {
        Ok(Record::Chunk { header, data }) => ChunkReader::new(header, &data)
            .is_ok_and(|mut records| records.all(|record| record.is_ok())),
        Ok(Record::Unknown { opcode, .. }) => opcode != 0,
        Ok(_) => true,
        Err(_) => false,
    }
}
