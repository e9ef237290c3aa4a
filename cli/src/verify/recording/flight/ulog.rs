//! Reader of ULog, the log of PX4: each subscription is a topic, whose fields are named as in its message.
//!
//! Source: PX4's description of the format. Appended data and dropouts are read; a message that the end of the file cuts is
//! left out with a note, as a loss of power makes one.
//!
//! Invariant: no input panics. Must not know: what topics mean.

use std::collections::HashMap;

use super::bytes::{Bytes, Kind};
use super::error::Wrong;
use super::log::{Field, Log, Sample, Topic};

/// First bytes of a file.
pub(super) const MAGIC: &[u8] = b"ULog\x01\x12\x35";

/// Version of the format and time of the start.
const HEAD: usize = 9;

/// Deepest nesting of messages: more is damage, or a message that holds itself.
const DEPTH: usize = 8;

/// Most fields of a topic.
const FIELDS: usize = 10_000;

/// Types of messages that are read.
mod kind {
    pub const FLAGS: u8 = b'B';
    pub const FORMAT: u8 = b'F';
    pub const SUBSCRIPTION: u8 = b'A';
    pub const DATA: u8 = b'D';
    pub const DROPOUT: u8 = b'O';
}

/// Parts of a message, as its format declares them.
struct Part<'b> {
    name: &'b str,
    ty: &'b str,
    /// Length of an array.
    count: Option<usize>,
}

/// Reader of one file.
#[derive(Default)]
struct Reader<'b> {
    formats: HashMap<&'b str, Vec<Part<'b>>>,
    /// Topics by the number that their data has.
    topics: HashMap<u16, usize>,
    log: Log,
    dropouts: u32,
    /// Milliseconds that dropouts last.
    lost: u64,
}

/// Reads the topics, and the samples of those that are wanted.
pub(super) fn read(file: &[u8], wanted: &dyn Fn(&str) -> bool) -> Result<Log, Wrong> {
    let mut bytes = Bytes::new(file);
    let mut reader = Reader::default();
    if bytes.take(MAGIC.len() + HEAD).is_none() {
        return Err(Wrong::damaged(0, "the file ends within its head"));
    }
    // Data may be appended behind a message that was cut, at offsets that the flags name.
    let mut appended: Vec<usize> = Vec::new();
    while !bytes.is_empty() {
        let (at, mut message) = (bytes.at, bytes);
        let content = message.u16().zip(message.u8()).and_then(|(size, code)| {
            let content = message.part(size.into())?;
            Some((code, content))
        });
        let next = appended.first().copied().filter(|next| *next > at && *next < message.at);
        match (content, next) {
            (_, Some(next)) => {
                bytes.take(next - at);
                appended.remove(0);
            }
            (Some((code, content)), None) => {
                bytes = message;
                reader.see(code, content, wanted, &mut appended)?;
            }
            (None, None) => {
                let count = bytes.rest().len();
                let note =
                    format!("the last {count} bytes left out: the file ends within a message");
                reader.log.notes.push(note);
                break;
            }
        }
    }
    if reader.dropouts > 0 {
        let Reader { dropouts, lost, .. } = reader;
        reader.log.notes.push(format!("{dropouts} dropouts of {lost} ms altogether"));
    }
    Ok(reader.log)
}

impl<'b> Reader<'b> {
    fn see(
        &mut self,
        code: u8,
        mut content: Bytes<'b>,
        wanted: &dyn Fn(&str) -> bool,
        appended: &mut Vec<usize>,
    ) -> Result<(), Wrong> {
        let at = content.at;
        let short = || Wrong::damaged(at, "a message is shorter than its fields");
        match code {
            kind::FLAGS => {
                let [_, incompatible]: [Option<[u8; 8]>; 2] = [content.array(), content.array()];
                let [appends, others @ ..] = incompatible.ok_or_else(short)?;
                if appends > 1 || others != [0; 7] {
                    return Err(Wrong::damaged(
                        at,
                        "it uses features of ULog that are not known here",
                    ));
                }
                let offsets = (0..3).filter_map(|_| content.u64()).filter(|it| *it != 0);
                appended.extend(offsets.filter_map(|it| usize::try_from(it).ok()));
            }
            kind::FORMAT => {
                let (name, parts) = format(content.rest())
                    .ok_or_else(|| Wrong::damaged(at, "a format is no list of fields"))?;
                self.formats.insert(name, parts);
            }
            kind::SUBSCRIPTION => {
                let (instance, number) = content.u8().zip(content.u16()).ok_or_else(short)?;
                let name = std::str::from_utf8(content.rest())
                    .map_err(|_| Wrong::damaged(at, "the name of a topic is no text"))?;
                let mut fields = Vec::new();
                self.fields(name, "", DEPTH, &mut fields)
                    .ok_or_else(|| Wrong::damaged(at, "a topic has no sound format"))?;
                while fields.last().is_some_and(|it: &Field| it.is_padding()) {
                    fields.pop();
                }
                let topic = Topic::new(name, instance.into(), fields, "timestamp");
                self.topics.insert(number, self.log.topics.len());
                self.log.topics.push(topic);
            }
            kind::DATA => {
                let number = content.u16().ok_or_else(short)?;
                let topic = self.topics.get(&number).and_then(|it| self.log.topics.get_mut(*it));
                let topic = topic.ok_or_else(|| Wrong::damaged(at, "data is of no topic"))?;
                topic.count += 1;
                if wanted(&topic.name) {
                    let mut numbers = Vec::with_capacity(topic.fields.len());
                    for field in &topic.fields {
                        numbers.push(field.kind.read(&mut content).ok_or_else(short)?);
                    }
                    topic.samples.push(Sample { numbers });
                }
            }
            kind::DROPOUT => {
                self.dropouts += 1;
                self.lost += u64::from(content.u16().ok_or_else(short)?);
            }
            // The rest is parameters, texts and what later versions add, which readers skip.
            _ => {}
        }
        Ok(())
    }

    /// The numbers of a message, in their order; none if its format is none.
    fn fields(
        &self,
        message: &str,
        prefix: &str,
        depth: usize,
        fields: &mut Vec<Field>,
    ) -> Option<()> {
        let depth = depth.checked_sub(1)?;
        // A message without parts would let arrays of it grow without bound.
        let parts = self.formats.get(message).filter(|it| !it.is_empty())?;
        for Part { name, ty, count } in parts {
            for at in 0..count.unwrap_or(1) {
                let index = count.map_or(String::new(), |_| format!("[{at}]"));
                let path = format!("{prefix}{name}{index}");
                match number(ty) {
                    Some(kind) => fields.push(Field { name: path, kind }),
                    None => self.fields(ty, &format!("{path}."), depth, fields)?,
                }
                if fields.len() > FIELDS {
                    return None;
                }
            }
        }
        Some(())
    }
}

/// Name and parts of a message: `name:type field;type[3] field;`.
fn format(text: &[u8]) -> Option<(&str, Vec<Part<'_>>)> {
    let (name, parts) = std::str::from_utf8(text).ok()?.split_once(':')?;
    let part = |text| {
        let (ty, name) = str::split_once(text, ' ')?;
        let (ty, count) = match ty.split_once('[') {
            Some((ty, count)) => {
                let count = count.strip_suffix(']')?.parse().ok()?;
                (ty, Some(Some(count).filter(|it| (1..=FIELDS).contains(it))?))
            }
            None => (ty, None),
        };
        Some(Part { name, ty, count })
    };
    let parts = parts.split(';').filter(|it| !it.is_empty()).map(part).collect::<Option<_>>()?;
    Some((name, parts))
}

/// The type of a number; none for a message.
fn number(ty: &str) -> Option<Kind> {
    Some(match ty {
        "int8_t" => Kind::I8,
        "uint8_t" | "bool" | "char" => Kind::U8,
        "int16_t" => Kind::I16,
        "uint16_t" => Kind::U16,
        "int32_t" => Kind::I32,
        "uint32_t" => Kind::U32,
        "int64_t" => Kind::I64,
        "uint64_t" => Kind::U64,
        "float" => Kind::F32,
        "double" => Kind::F64,
        _ => return None,
    })
}
