//! Reader of ArduPilot's DataFlash log (BIN): each kind of message is a topic, and each of its instances one of its own.
//!
//! Source: ArduPilot's `LogStructure.h`. The file describes its messages itself (`FMT`), and names the field that counts
//! instances (`FMTU`, the unit `#`). Hundredths are divided by 100 and degrees by 10⁷, each rounded once.
//!
//! Invariant: no input panics. Bytes that are no message are skipped with a note. Must not know: what topics mean.

use std::collections::HashMap;

use super::bytes::{Bytes, Kind, Number};
use super::error::Wrong;
use super::log::{Field, Log, Sample, Topic};

/// First bytes of each message.
const MARK: [u8; 2] = [0xa3, 0x95];

/// First bytes of a file: its first message describes the descriptions.
pub(super) const MAGIC: &[u8] = &[0xa3, 0x95, FORMAT];

/// Type of the messages that describe messages.
const FORMAT: u8 = 128;

/// Bytes of mark and type.
const HEAD: usize = 3;

/// A kind of messages.
struct Format {
    name: String,
    /// Bytes behind the head.
    size: usize,
    columns: Vec<Column>,
    /// The column that counts instances.
    instance: Option<usize>,
}

/// A field of a message.
struct Column {
    name: String,
    form: Form,
}

/// The form of a field.
#[derive(Clone, Copy)]
enum Form {
    Number(Kind),
    /// A whole number of these parts.
    Parts(Kind, f64),
    /// Text or an array, which no mapping uses, with its size in bytes.
    Other(usize),
}

/// Reads the topics, and the samples of those that are wanted.
pub(super) fn read(file: &[u8], wanted: &dyn Fn(&str) -> bool) -> Result<Log, Wrong> {
    let mut reader = Reader::default();
    let mut bytes = Bytes::new(file);
    // Bytes that are no message, and where the first of them is.
    let (mut skipped, mut first) = (0_usize, 0);
    while !bytes.is_empty() {
        let mut message = bytes;
        let content = message.take(HEAD).and_then(|head| match head {
            [a, b, code] if [*a, *b] == MARK => {
                let content = message.part(reader.size(*code)?)?;
                Some((*code, content))
            }
            _ => None,
        });
        match content {
            Some((code, content)) => {
                bytes = message;
                reader.see(code, content, wanted)?;
            }
            None => {
                first = if skipped == 0 { bytes.at } else { first };
                skipped += 1;
                bytes.take(1);
            }
        }
    }
    let Reader { formats, topics, log } = &mut reader;
    let is_empty = |code: &u8| !topics.keys().any(|(other, _)| other == code);
    let mut empty: Vec<_> = formats.iter().filter(|(code, _)| is_empty(code)).collect();
    empty.sort_by_key(|(code, _)| **code);
    log.topics.extend(empty.into_iter().map(|(_, format)| format.topic(0)));
    if skipped > 0 {
        let note =
            format!("{skipped} bytes left out, the first at byte {first}: they are no message");
        reader.log.notes.push(note);
    }
    Ok(reader.log)
}

/// Reader of one file.
#[derive(Default)]
struct Reader {
    formats: HashMap<u8, Format>,
    /// Topics by the type and the instance of their messages.
    topics: HashMap<(u8, usize), usize>,
    log: Log,
}

impl Reader {
    /// Bytes of a message behind its head; none if its type is not known.
    fn size(&self, code: u8) -> Option<usize> {
        match code {
            FORMAT => Some(86),
            _ => self.formats.get(&code).map(|it| it.size),
        }
    }

    fn see(
        &mut self,
        code: u8,
        content: Bytes<'_>,
        wanted: &dyn Fn(&str) -> bool,
    ) -> Result<(), Wrong> {
        if code == FORMAT {
            let (code, mut format) = described(content)?;
            if let Some(old) = self.formats.get(&code).filter(|old| old.name == format.name) {
                format.instance = old.instance;
            }
            self.formats.insert(code, format);
            return Ok(());
        }
        let Some(format) = self.formats.get(&code) else { return Ok(()) };
        let values = format.values(content)?;
        if format.name == "FMTU" {
            self.count_instances(content);
            return Ok(());
        }
        let instance = format.instance.and_then(|at| match values.get(at) {
            Some(Some(Number::Int(instance))) => usize::try_from(*instance).ok(),
            _ => None,
        });
        let instance = instance.unwrap_or(0);
        let (topics, log) = (&mut self.topics, &mut self.log);
        let place = *topics.entry((code, instance)).or_insert_with(|| {
            log.topics.push(format.topic(instance));
            log.topics.len() - 1
        });
        if let Some(topic) = log.topics.get_mut(place) {
            topic.count += 1;
            if wanted(&topic.name) {
                topic.samples.push(Sample { numbers: values.into_iter().flatten().collect() });
            }
        }
        Ok(())
    }

    /// Reads which field of a message counts instances: `FMTU` has the time, a type, and a letter for each unit.
    fn count_instances(&mut self, mut content: Bytes<'_>) {
        let Some((_, code)) = content.u64().zip(content.u8()) else { return };
        let units: &[u8] = content.take(16).unwrap_or_default();
        if let Some(format) = self.formats.get_mut(&code) {
            format.instance = units.iter().position(|unit| *unit == b'#');
        }
    }
}

impl Format {
    /// The value of each column; none for a text.
    fn values(&self, mut content: Bytes<'_>) -> Result<Vec<Option<Number>>, Wrong> {
        let at = content.at;
        let mut value = |column: &Column| match column.form {
            Form::Number(kind) => kind.read(&mut content).map(Some),
            Form::Parts(kind, parts) => {
                kind.read(&mut content).map(|it| Some(Number::Float(it.float() / parts)))
            }
            Form::Other(size) => content.take(size).map(|_| None),
        };
        let values = self.columns.iter().map(&mut value).collect::<Option<_>>();
        values.ok_or_else(|| Wrong::damaged(at, "a message is shorter than its fields"))
    }

    fn topic(&self, instance: usize) -> Topic {
        let field = |column: &Column| match column.form {
            Form::Number(kind) => Some(Field { name: column.name.clone(), kind }),
            Form::Parts(..) => Some(Field { name: column.name.clone(), kind: Kind::F64 }),
            Form::Other(_) => None,
        };
        let fields = self.columns.iter().filter_map(field).collect();
        Topic::new(&self.name, instance, fields, "TimeUS")
    }
}

/// Reads a description: type, size, name, forms and names of the fields.
fn described(mut content: Bytes<'_>) -> Result<(u8, Format), Wrong> {
    let at = content.at;
    let wrong = || Wrong::damaged(at, "the description of a message is unsound");
    let (code, size) = content.u8().zip(content.u8()).ok_or_else(wrong)?;
    let mut text = |count| {
        let bytes = content.take(count)?;
        std::str::from_utf8(bytes).ok()?.split('\0').next()
    };
    let (name, forms) = text(4).zip(text(16)).ok_or_else(wrong)?;
    let names = text(64).ok_or_else(wrong)?;
    let names = names.split(',').filter(|it| !it.is_empty());
    let columns = forms.chars().zip(names).map(|(letter, name)| {
        let name = name.to_owned();
        form(letter).map(|form| Column { name, form })
    });
    let columns: Vec<Column> = columns.collect::<Option<_>>().ok_or_else(wrong)?;
    let size = usize::from(size).checked_sub(HEAD).ok_or_else(wrong)?;
    Ok((code, Format { name: name.to_owned(), size, columns, instance: None }))
}

/// The form of a field, by its letter.
fn form(letter: char) -> Option<Form> {
    /// Parts of a degree.
    const DEGREE: f64 = 1.0e7;
    Some(match letter {
        'b' => Form::Number(Kind::I8),
        'B' | 'M' => Form::Number(Kind::U8),
        'h' => Form::Number(Kind::I16),
        'H' => Form::Number(Kind::U16),
        'i' => Form::Number(Kind::I32),
        'I' => Form::Number(Kind::U32),
        'q' => Form::Number(Kind::I64),
        'Q' => Form::Number(Kind::U64),
        'g' => Form::Number(Kind::F16),
        'f' => Form::Number(Kind::F32),
        'd' => Form::Number(Kind::F64),
        'c' => Form::Parts(Kind::I16, 100.0),
        'C' => Form::Parts(Kind::U16, 100.0),
        'e' => Form::Parts(Kind::I32, 100.0),
        'E' => Form::Parts(Kind::U32, 100.0),
        'L' => Form::Parts(Kind::I32, DEGREE),
        'n' => Form::Other(4),
        'N' => Form::Other(16),
        'Z' | 'a' => Form::Other(64),
        _ => return None,
    })
}
