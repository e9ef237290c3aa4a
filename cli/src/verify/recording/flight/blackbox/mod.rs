//! Reader of the blackbox log of Betaflight and its relatives, version 2 of its data.
//!
//! The log has the topics `main`, `slow`, `gps` and `home`; if a file has several logs, those of the second are `main[1]` and so
//! on. Main samples are whole frames and differences from the last two, which `fields` decodes. A frame that another does not
//! follow at once is damaged: it and the differences up to the next whole frame are left out with a note.
//!
//! Source: Betaflight's `blackbox.c` and its description of the format. Invariant: no input panics. Must not know: what
//! fields mean.

mod fields;

use super::bytes::{Bytes, Kind, Number};
use super::error::Wrong;
use super::log::{Field, Log, Sample, Topic};
use fields::{Coding, History, Layout};

/// First bytes of each log of a file.
pub(super) const MAGIC: &[u8] = b"H Product:Blackbox";

/// Types of frames, in the order of their topics.
const FRAMES: [(u8, &str); 4] = [(b'I', "main"), (b'S', "slow"), (b'G', "gps"), (b'H', "home")];

/// Type of the frames with differences.
const DIFFERENCES: u8 = b'P';

/// Type of the frames with events.
const EVENT: u8 = b'E';

/// Name of the field with the time, in microseconds.
const TIME: &str = "time";

/// Reads the topics, and the samples of those that are wanted.
pub(super) fn read(file: &[u8], wanted: &dyn Fn(&str) -> bool) -> Result<Log, Wrong> {
    let mut log = Log::default();
    let mut starts: Vec<usize> = Vec::new();
    let mut at = 0;
    // A log begins where its first line does.
    while let Some(found) = find(file.get(at..).unwrap_or_default(), MAGIC) {
        starts.push(at + found);
        at += found + MAGIC.len();
    }
    let ends = starts.iter().skip(1).copied().chain([file.len()]);
    for (instance, (start, end)) in starts.iter().zip(ends).enumerate() {
        let mut bytes = Bytes::new(file.get(..end).unwrap_or_default());
        bytes.take(*start);
        one(bytes, instance, wanted, &mut log)?;
    }
    Ok(log)
}

fn find(text: &[u8], wanted: &[u8]) -> Option<usize> {
    text.windows(wanted.len()).position(|it| it == wanted)
}

/// Reads one of the logs of a file.
fn one(
    mut bytes: Bytes<'_>,
    instance: usize,
    wanted: &dyn Fn(&str) -> bool,
    log: &mut Log,
) -> Result<(), Wrong> {
    let layout = head(&mut bytes)?;
    let coding = |code: u8| layout.coding(code);
    let first = log.topics.len();
    for (code, name) in FRAMES {
        log.topics.push(topic(name, instance, layout.coding(code)));
    }
    let mut history = History::default();
    let mut damaged = Vec::new();
    while !bytes.is_empty() {
        let (at, mut frame) = (bytes.at, bytes);
        let code = frame.u8().unwrap_or_default();
        let values = match code {
            EVENT => match event(&mut frame) {
                Some(Event::End) => break,
                Some(Event::Resumed) => {
                    history.pause();
                    Some(Vec::new())
                }
                Some(Event::Other) => Some(Vec::new()),
                None => None,
            },
            DIFFERENCES if !history.has_main() => None,
            _ => coding(code)
                .and_then(|it| it.values(&mut frame, &layout, &history))
                .filter(|values| history.allows(code, values, coding(code))),
        };
        let follows = |next: &u8| {
            matches!(*next, EVENT | DIFFERENCES) || FRAMES.iter().any(|(code, _)| code == next)
        };
        // Behind the last frame of a file there is none.
        let Some(mut values) = values.filter(|_| frame.rest().first().is_none_or(follows)) else {
            damaged.push(at);
            history.lose();
            bytes.take(1);
            // A frame begins at the next byte that is the type of a whole one.
            while bytes.rest().first().is_some_and(|it| *it != b'I') {
                bytes.take(1);
            }
            continue;
        };
        bytes = frame;
        if code == EVENT {
            continue;
        }
        let time = history.add(code, &values, coding(code));
        let main = if code == DIFFERENCES { b'I' } else { code };
        let place = FRAMES.iter().position(|(code, _)| *code == main).unwrap_or_default();
        let Some(topic) = log.topics.get_mut(first + place) else { continue };
        topic.count += 1;
        if wanted(&topic.name) {
            match coding(code).and_then(|it| values.get_mut(it.time?)) {
                Some(field) => *field = time,
                None => values.push(time),
            }
            let numbers = values.into_iter().map(Number::Int).collect();
            topic.samples.push(Sample { numbers });
        }
    }
    if let Some(first) = damaged.first() {
        let count = damaged.len();
        log.notes.push(format!("{count} damaged frames left out, the first at byte {first}"));
    }
    Ok(())
}

/// Returns a topic. If its frames have no time, they get the time of the main frame before.
fn topic(name: &str, instance: usize, coding: Option<&Coding>) -> Topic {
    let field = |name: &str| Field { name: name.to_owned(), kind: Kind::I64 };
    let mut fields: Vec<Field> = coding
        .map_or(Vec::new(), |coding| coding.fields.iter().map(|it| field(&it.name)).collect());
    if coding.is_some_and(|it| it.time.is_none()) {
        fields.push(field(TIME));
    }
    Topic::new(name, instance, fields, TIME)
}

/// Reads the lines before the frames.
fn head(bytes: &mut Bytes<'_>) -> Result<Layout, Wrong> {
    let mut layout = Layout::default();
    while bytes.rest().starts_with(b"H ") {
        let at = bytes.at;
        let Some(end) = bytes.rest().iter().position(|it| *it == b'\n') else { break };
        let line = bytes.take(end + 1).unwrap_or_default();
        let text = String::from_utf8_lossy(line);
        let Some((name, value)) = text.trim_end().trim_start_matches("H ").split_once(':') else {
            continue;
        };
        layout.set(name, value).map_err(|said| Wrong::Damaged { at, said })?;
    }
    let at = bytes.at;
    layout.whole().map_err(|said| Wrong::Damaged { at, said })?;
    Ok(layout)
}

/// An event of the log.
enum Event {
    /// The log ends.
    End,
    /// Logging goes on after a pause.
    Resumed,
    /// Anything that changes no sample.
    Other,
}

/// Reads an event; none if it is not known, and with it the place of the next frame.
fn event(frame: &mut Bytes<'_>) -> Option<Event> {
    match frame.u8()? {
        // Beep, disarming.
        0 | 15 => _ = fields::unsigned(frame)?,
        // Adjustment in flight: of a whole number, or of a `float`.
        13 => {
            let function = frame.u8()?;
            if function < 128 {
                fields::unsigned(frame)?;
            } else {
                frame.take(4)?;
            }
        }
        // Logging is resumed: number and time of the next iteration.
        14 => {
            fields::unsigned(frame).zip(fields::unsigned(frame))?;
            return Some(Event::Resumed);
        }
        // Flight modes, before and after.
        30 => _ = fields::unsigned(frame).zip(fields::unsigned(frame))?,
        255 => {
            let text = b"End of log\0";
            return (frame.take(text.len())? == text).then_some(Event::End);
        }
        _ => return None,
    }
    Some(Event::Other)
}
