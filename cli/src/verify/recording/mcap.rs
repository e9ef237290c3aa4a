//! Reader of MCAP's records, as far as recordings need them: channels and messages, within chunks or not.
//!
//! Source: the MCAP specification, version 0. Chunks are plain, or compressed by LZ4 or zstd; their checksums are compared. A file
//! that ends before its data does is refused.
//!
//! Invariant: no input panics. Must not know: what messages contain.

use std::io::Read;

use super::error::Wrong;

/// First and last bytes of a file.
pub(super) const MAGIC: &[u8] = b"\x89MCAP0\r\n";

/// Opcodes of the records that are read.
mod opcode {
    pub const CHANNEL: u8 = 0x04;
    pub const MESSAGE: u8 = 0x05;
    pub const CHUNK: u8 = 0x06;
    pub const DATA_END: u8 = 0x0f;
}

/// A record that matters.
pub(super) enum Record<'b> {
    Channel {
        id: u16,
        topic: &'b str,
        encoding: &'b str,
    },
    /// Times are in nanoseconds.
    Message {
        channel: u16,
        log_time: u64,
        data: &'b [u8],
    },
}

/// Hands every channel and message of a file to `see`, in the order of the file.
pub(super) fn read(file: &[u8], see: &mut dyn FnMut(Record<'_>)) -> Result<(), Wrong> {
    let mut bytes = Bytes(file.strip_prefix(MAGIC).unwrap_or(file));
    while let Some((code, content)) = bytes.record() {
        match code {
            opcode::DATA_END => return Ok(()),
            opcode::CHUNK => chunk(content, see)?,
            _ => see_plain(code, content, see)?,
        }
    }
    Err(Wrong::Mcap("it ends before its data does"))
}

fn chunk(content: &[u8], see: &mut dyn FnMut(Record<'_>)) -> Result<(), Wrong> {
    let (checksum, compression, packed) = chunk_parts(content).ok_or(SHORT)?;
    let failed = |said: String| Wrong::Chunk { compression: compression.to_owned(), said };
    let mut plain = Vec::new();
    match compression {
        "" => plain.extend(packed),
        "lz4" => {
            let mut decoder = lz4_flex::frame::FrameDecoder::new(packed);
            decoder.read_to_end(&mut plain).map_err(|error| failed(error.to_string()))?;
        }
        "zstd" => {
            let decoder = ruzstd::decoding::StreamingDecoder::new(packed);
            let mut decoder = decoder.map_err(|error| failed(error.to_string()))?;
            decoder.read_to_end(&mut plain).map_err(|error| failed(error.to_string()))?;
        }
        _ => return Err(failed("compression that is read here: lz4 or zstd".to_owned())),
    }
    // 0 represents no checksum.
    if checksum != 0 && crc32fast::hash(&plain) != checksum {
        return Err(Wrong::Mcap("the checksum of a chunk differs"));
    }
    let mut bytes = Bytes(&plain);
    while !bytes.0.is_empty() {
        let (code, content) = bytes.record().ok_or(SHORT)?;
        see_plain(code, content, see)?;
    }
    Ok(())
}

/// Checksum, compression and records of a chunk.
fn chunk_parts(content: &[u8]) -> Option<(u32, &str, &[u8])> {
    let mut bytes = Bytes(content);
    // First and last time, and the size of the plain records.
    bytes.take(24)?;
    let checksum = bytes.u32()?;
    let compression = bytes.text()?;
    let size = usize::try_from(bytes.u64()?).ok()?;
    Some((checksum, compression, bytes.take(size)?))
}

fn see_plain(code: u8, content: &[u8], see: &mut dyn FnMut(Record<'_>)) -> Result<(), Wrong> {
    let record = match code {
        opcode::CHANNEL => channel(content),
        opcode::MESSAGE => message(content),
        _ => return Ok(()),
    };
    see(record.ok_or(SHORT)?);
    Ok(())
}

fn channel(content: &[u8]) -> Option<Record<'_>> {
    let mut bytes = Bytes(content);
    let id = bytes.u16()?;
    let _schema = bytes.u16()?;
    Some(Record::Channel { id, topic: bytes.text()?, encoding: bytes.text()? })
}

fn message(content: &[u8]) -> Option<Record<'_>> {
    let mut bytes = Bytes(content);
    let channel = bytes.u16()?;
    let _sequence = bytes.u32()?;
    let log_time = bytes.u64()?;
    let _publish_time = bytes.u64()?;
    Some(Record::Message { channel, log_time, data: bytes.0 })
}

/// Error of a record that is shorter than its fields.
const SHORT: Wrong = Wrong::Mcap("a record of it is cut or is no text");

/// Bytes that are still to be read. Numbers are little-endian.
struct Bytes<'b>(&'b [u8]);

impl<'b> Bytes<'b> {
    fn take(&mut self, count: usize) -> Option<&'b [u8]> {
        self.0.split_off(..count)
    }

    fn array<const N: usize>(&mut self) -> Option<[u8; N]> {
        self.take(N)?.try_into().ok()
    }

    fn u16(&mut self) -> Option<u16> {
        self.array().map(u16::from_le_bytes)
    }

    fn u32(&mut self) -> Option<u32> {
        self.array().map(u32::from_le_bytes)
    }

    fn u64(&mut self) -> Option<u64> {
        self.array().map(u64::from_le_bytes)
    }

    fn text(&mut self) -> Option<&'b str> {
        let count = self.u32()?;
        std::str::from_utf8(self.take(usize::try_from(count).ok()?)?).ok()
    }

    /// The code and content of a record.
    fn record(&mut self) -> Option<(u8, &'b [u8])> {
        let [code] = self.array()?;
        let size = usize::try_from(self.u64()?).ok()?;
        Some((code, self.take(size)?))
    }
}
