//! Fields of blackbox frames: how each is encoded, and predicted from the frames before.
//!
//! Invariants: arithmetic wraps at 32 bits, as the firmware's does; the sign of a field decides what its bits mean. No input
//! panics.

use super::super::bytes::Bytes;

/// A field of a type of frames.
#[derive(Clone, Default)]
pub struct Field {
    pub name: String,
    signed: bool,
    predictor: u8,
    encoding: u8,
}

/// Fields of a type of frames.
#[derive(Default)]
pub struct Coding {
    pub fields: Vec<Field>,
    /// Place of the field with the time.
    pub time: Option<usize>,
    /// Place of the field that counts iterations.
    iteration: Option<usize>,
    /// Place of the first motor.
    motor: Option<usize>,
}

/// Settings of a log, from the lines before its frames.
#[derive(Default)]
pub struct Layout {
    /// Whole frames, differences, and the rarer frames.
    codings: [Coding; 5],
    version: Option<String>,
    /// Iterations between two whole frames.
    interval: Option<u32>,
    /// Iterations with a frame (the first), among a number of iterations (the second).
    share: Option<(u32, u32)>,
    min_throttle: i64,
    min_motor: i64,
    battery: i64,
}

/// Types of frames, in the order of [`Layout::codings`].
const CODES: [u8; 5] = [b'I', b'P', b'S', b'G', b'H'];

/// Ways to encode numbers.
mod encoding {
    pub const SIGNED: u8 = 0;
    pub const UNSIGNED: u8 = 1;
    pub const NEGATIVE_14_BITS: u8 = 3;
    pub const GROUP_OF_8: u8 = 6;
    pub const GROUP_OF_3: u8 = 7;
    pub const GROUP_OF_4: u8 = 8;
    pub const NOTHING: u8 = 9;
}

/// Ways to predict a number.
mod predictor {
    pub const PREVIOUS: u8 = 1;
    pub const LINE: u8 = 2;
    pub const AVERAGE: u8 = 3;
    pub const MIN_THROTTLE: u8 = 4;
    pub const FIRST_MOTOR: u8 = 5;
    pub const INCREMENT: u8 = 6;
    pub const HOME: u8 = 7;
    pub const MIDDLE: u8 = 8;
    pub const BATTERY: u8 = 9;
    pub const MAIN_TIME: u8 = 10;
    pub const MIN_MOTOR: u8 = 11;
}

impl Layout {
    pub fn coding(&self, code: u8) -> Option<&Coding> {
        let place = CODES.iter().position(|it| *it == code)?;
        self.codings.get(place).filter(|it| !it.fields.is_empty())
    }

    /// Takes a line before the frames; those that no frame depends on are not kept.
    ///
    /// # Errors
    /// A value that is none.
    pub fn set(&mut self, name: &str, value: &str) -> Result<(), String> {
        let wrong = || format!("`{name}` is `{value}`");
        let whole = |text: &str| text.trim().parse::<i64>().map_err(|_| wrong());
        let some = |text: &str| {
            let number = text.trim().parse::<u32>().map_err(|_| wrong())?;
            Ok::<u32, String>(number.max(1))
        };
        match name {
            "Data version" => self.version = Some(value.to_owned()),
            "I interval" => self.interval = Some(some(value)?),
            "P interval" => {
                self.share = Some(match value.split_once('/') {
                    Some((some_of, all)) => (some(some_of)?, some(all)?),
                    None => (1, some(value)?),
                });
            }
            "minthrottle" => self.min_throttle = whole(value)?,
            "motorOutput" => self.min_motor = whole(value.split(',').next().unwrap_or(value))?,
            "vbatref" => self.battery = whole(value)?,
            _ => {
                let Some((code, property)) =
                    name.strip_prefix("Field ").and_then(|it| it.split_once(' '))
                else {
                    return Ok(());
                };
                let place = CODES.iter().position(|it| code.as_bytes() == [*it]);
                let Some(coding) = place.and_then(|it| self.codings.get_mut(it)) else {
                    return Ok(());
                };
                coding.set(property, value).ok_or_else(wrong)?;
            }
        }
        Ok(())
    }

    /// Completes what the lines said.
    ///
    /// # Errors
    /// A missing line, or a value that is not read here.
    pub fn whole(&mut self) -> Result<(), String> {
        if self.version.as_deref() != Some("2") {
            let version = self.version.as_deref().unwrap_or("none");
            return Err(format!("the version of the data is {version}, and 2 is read"));
        }
        let [whole, differences, others @ ..] = &mut self.codings;
        if whole.fields.is_empty() {
            return Err("it names no fields of whole frames".to_owned());
        }
        // Differences have the names and signs of the whole frames.
        if !differences.fields.is_empty() {
            if differences.fields.len() != whole.fields.len() {
                return Err("its differences have other fields than its whole frames".to_owned());
            }
            for (field, of) in differences.fields.iter_mut().zip(&whole.fields) {
                (field.name, field.signed) = (of.name.clone(), of.signed);
            }
        }
        for coding in [whole, differences].into_iter().chain(others) {
            let place = |name: &str| coding.fields.iter().position(|it| it.name == name);
            let (time, iteration) = (place("time"), place("loopIteration"));
            let motor = place("motor[0]");
            (coding.time, coding.iteration, coding.motor) = (time, iteration, motor);
            let unread = coding.fields.iter().find(|it| !it.is_read());
            if let Some(Field { name, predictor, encoding, .. }) = unread {
                return Err(format!(
                    "`{name}` has the encoding {encoding} and the predictor {predictor}, which are not read here"
                ));
            }
        }
        Ok(())
    }

    /// Iterations without a frame behind this one.
    fn skipped(&self, iteration: i64) -> i64 {
        let (Some(interval), Some((some, all))) = (self.interval, self.share) else { return 0 };
        let (interval, some, all) = (i64::from(interval), i64::from(some), i64::from(all));
        let has_frame = |at: i64| (at.rem_euclid(interval) + some - 1) % all < some;
        (1..=interval).take_while(|ahead| !has_frame(iteration + ahead)).count() as i64
    }
}

impl Field {
    fn is_read(&self) -> bool {
        use encoding::{
            GROUP_OF_3, GROUP_OF_4, GROUP_OF_8, NEGATIVE_14_BITS, NOTHING, SIGNED, UNSIGNED,
        };
        let known =
            [SIGNED, UNSIGNED, NEGATIVE_14_BITS, GROUP_OF_8, GROUP_OF_3, GROUP_OF_4, NOTHING];
        known.contains(&self.encoding) && self.predictor <= predictor::MIN_MOTOR
    }

    /// The number that 32 bits mean.
    fn meant(&self, bits: u32) -> i64 {
        if self.signed { i64::from(bits as i32) } else { i64::from(bits) }
    }
}

impl Coding {
    /// Takes a line with a property of each field; none if it is none.
    fn set(&mut self, property: &str, value: &str) -> Option<()> {
        let values: Vec<&str> = value.split(',').map(str::trim).collect();
        if self.fields.is_empty() {
            self.fields.resize_with(values.len(), Field::default);
        }
        if values.len() != self.fields.len() {
            return None;
        }
        for (field, value) in self.fields.iter_mut().zip(values) {
            match property {
                "name" => field.name = value.to_owned(),
                "signed" => field.signed = value.parse::<u8>().ok()? != 0,
                "predictor" => field.predictor = value.parse().ok()?,
                "encoding" => field.encoding = value.parse().ok()?,
                _ => {}
            }
        }
        Some(())
    }

    /// Reads the values of a frame; none if it is cut.
    pub fn values(
        &self,
        bytes: &mut Bytes<'_>,
        layout: &Layout,
        history: &History,
    ) -> Option<Vec<i64>> {
        let mut values: Vec<i64> = Vec::with_capacity(self.fields.len());
        while let Some(field) = self.fields.get(values.len()) {
            let same = self.fields.iter().skip(values.len());
            let same = same.take_while(|it| it.encoding == field.encoding).count();
            for coded in group(field.encoding, same, bytes)? {
                // A group may be longer than the rest of the fields.
                let Some(field) = self.fields.get(values.len()) else { break };
                let predicted = self.predicted(field, &values, layout, history) as u32;
                values.push(field.meant(predicted.wrapping_add(coded)));
            }
        }
        Some(values)
    }

    /// The value from which the coded one is a difference; its low 32 bits count.
    fn predicted(&self, field: &Field, values: &[i64], layout: &Layout, history: &History) -> i64 {
        let at = values.len();
        let [last, before] = [&history.last, &history.before].map(|it| it.get(at).copied());
        let (last, before) = (last.unwrap_or(0), before.unwrap_or(0));
        match field.predictor {
            predictor::PREVIOUS => last,
            predictor::LINE => 2 * last - before,
            predictor::AVERAGE => (last + before) / 2,
            predictor::MIN_THROTTLE => layout.min_throttle,
            predictor::FIRST_MOTOR => {
                self.motor.and_then(|it| values.get(it)).copied().unwrap_or(0)
            }
            predictor::INCREMENT => last + 1 + layout.skipped(last),
            predictor::HOME => {
                // The first coordinate and the second are those of home.
                let second = field.name.ends_with("[1]");
                history.home.get(usize::from(second)).copied().unwrap_or(0)
            }
            predictor::MIDDLE => 1500,
            predictor::BATTERY => layout.battery,
            predictor::MAIN_TIME => history.time,
            predictor::MIN_MOTOR => layout.min_motor,
            // 0 predicts 0; an unknown predictor is refused with the head.
            _ => 0,
        }
    }
}

/// Values before a frame.
#[derive(Default)]
pub struct History {
    /// Values of the last main frame, and of the one before; none before a whole frame.
    last: Vec<i64>,
    before: Vec<i64>,
    home: Vec<i64>,
    /// Iteration and time of the last main frame, if the next has to follow it.
    latest: Option<(i64, i64)>,
    /// Time of the last main frame, which goes on where its 32 bits wrap.
    time: i64,
}

impl History {
    /// Most iterations between two main frames without a pause.
    const ITERATIONS: i64 = 5000;
    /// Longest time between them, µs.
    const JUMP: i64 = 10_000_000;

    /// Returns true if differences have values to differ from.
    pub fn has_main(&self) -> bool {
        !self.last.is_empty()
    }

    /// Forgets the last main frames.
    pub fn lose(&mut self) {
        (self.last, self.before) = (Vec::new(), Vec::new());
    }

    /// Lets iteration and time of the next main frame be any.
    pub fn pause(&mut self) {
        self.latest = None;
    }

    /// Returns false for a main frame that cannot follow the last one: a damaged file can look like a frame.
    pub fn allows(&self, code: u8, values: &[i64], coding: Option<&Coding>) -> bool {
        let (b'I' | b'P', Some((iteration, time)), Some(coding)) = (code, self.latest, coding)
        else {
            return true;
        };
        let value = |at: Option<usize>| at.and_then(|at| values.get(at)).copied();
        let (now, at) = (value(coding.iteration), value(coding.time).map(|it| self.near(it)));
        now.is_none_or(|it| (1..=Self::ITERATIONS).contains(&(it - iteration)))
            && at.is_none_or(|it| (0..=Self::JUMP).contains(&(it - time)))
    }

    /// The time near to the last main frame's whose low 32 bits these are.
    fn near(&self, time: i64) -> i64 {
        let ahead = (time as u32).wrapping_sub(self.time as u32) as i32;
        self.time + i64::from(ahead)
    }

    /// Takes the values of a frame. Returns its time, or the time of the main frame before it.
    pub fn add(&mut self, code: u8, values: &[i64], coding: Option<&Coding>) -> i64 {
        let value = |at: Option<usize>| at.and_then(|at| values.get(at)).copied();
        let own = value(coding.and_then(|it| it.time));
        let is_first = !self.has_main() && self.latest.is_none() && self.time == 0;
        let time = own.map_or(self.time, |it| if is_first { it } else { self.near(it) });
        match code {
            b'I' => (self.last, self.before) = (values.to_vec(), values.to_vec()),
            b'P' => self.before = std::mem::replace(&mut self.last, values.to_vec()),
            b'H' => self.home = values.to_vec(),
            _ => {}
        }
        if matches!(code, b'I' | b'P') {
            self.time = time;
            self.latest = value(coding.and_then(|it| it.iteration)).map(|it| (it, time));
        }
        time
    }
}

/// Reads an unsigned number of up to 32 bits, 7 in a byte, the low ones first.
pub fn unsigned(bytes: &mut Bytes<'_>) -> Option<u32> {
    let mut number = 0;
    for shift in (0..35).step_by(7) {
        let byte = bytes.u8()?;
        number |= u32::from(byte & 0x7f) << shift;
        if byte < 0x80 {
            return Some(number);
        }
    }
    None
}

/// Reads a signed number whose sign is its lowest bit.
fn signed(bytes: &mut Bytes<'_>) -> Option<u32> {
    let number = unsigned(bytes)?;
    Some((number >> 1) ^ (number & 1).wrapping_neg())
}

/// Returns the number whose two's complement has this number of bits.
fn extended(number: u32, bits: u32) -> u32 {
    let shift = 32 - bits;
    ((number << shift) as i32 >> shift) as u32
}

/// Reads the numbers of a field, or of it and those behind it that are encoded together; `same` fields from it on have
/// its encoding.
fn group(encoding: u8, same: usize, bytes: &mut Bytes<'_>) -> Option<Vec<u32>> {
    Some(match encoding {
        encoding::SIGNED => vec![signed(bytes)?],
        encoding::UNSIGNED => vec![unsigned(bytes)?],
        encoding::NEGATIVE_14_BITS => {
            vec![extended(unsigned(bytes)? & 0x3fff, 14).wrapping_neg()]
        }
        encoding::GROUP_OF_8 if same == 1 => vec![signed(bytes)?],
        encoding::GROUP_OF_8 => {
            let present = bytes.u8()?;
            let number = |at: usize| match present >> at & 1 {
                0 => Some(0),
                _ => signed(bytes),
            };
            (0..same.min(8)).map(number).collect::<Option<_>>()?
        }
        encoding::GROUP_OF_3 => group_of_3(bytes)?,
        encoding::GROUP_OF_4 => group_of_4(bytes)?,
        _ => vec![0],
    })
}

/// Reads three numbers, whose size the first two bits tell.
fn group_of_3(bytes: &mut Bytes<'_>) -> Option<Vec<u32>> {
    let lead = u32::from(bytes.u8()?);
    let mut next = || bytes.u8().map(u32::from);
    Some(match lead >> 6 {
        0 => vec![extended(lead >> 4 & 3, 2), extended(lead >> 2 & 3, 2), extended(lead & 3, 2)],
        1 => {
            let both = next()?;
            vec![extended(lead & 0xf, 4), extended(both >> 4, 4), extended(both & 0xf, 4)]
        }
        2 => {
            vec![extended(lead & 0x3f, 6), extended(next()? & 0x3f, 6), extended(next()? & 0x3f, 6)]
        }
        _ => {
            let mut number = |at: u32| {
                let size = (lead >> (2 * at) & 3) + 1;
                let mut number = 0;
                for byte in 0..size {
                    number |= next()? << (8 * byte);
                }
                Some(extended(number, 8 * size))
            };
            (0..3).map(&mut number).collect::<Option<_>>()?
        }
    })
}

/// Reads four numbers of 0, 4, 8 or 16 bits, the high bits first, as one row of half bytes.
fn group_of_4(bytes: &mut Bytes<'_>) -> Option<Vec<u32>> {
    let sizes = bytes.u8()?;
    let mut low = None;
    let mut half = || match low.take() {
        Some(half) => Some(half),
        None => {
            let byte = u32::from(bytes.u8()?);
            low = Some(byte & 0xf);
            Some(byte >> 4)
        }
    };
    let number = |at: u32| {
        let halves = [0, 1, 2, 4][usize::from(sizes >> (2 * at) & 3)];
        let mut number = 0;
        for _ in 0..halves {
            number = number << 4 | half()?;
        }
        Some(if halves == 0 { 0 } else { extended(number, 4 * halves) })
    };
    (0..4).map(number).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Bytes that Betaflight 4.6 writes for these numbers: `blackboxWriteTag2_3S32` and its neighbours, called in C.
    const WRITTEN: &[(u8, usize, &[i32], &[u8])] = &[
        (7, 3, &[1, -2, 0], &[0x18]),
        (7, 3, &[7, -8, 3], &[0x47, 0x83]),
        (7, 3, &[31, -32, 5], &[0x9f, 0xe0, 0x05]),
        (7, 3, &[200, -5, 1], &[0xc1, 0xc8, 0x00, 0xfb, 0x01]),
        (7, 3, &[-30000, 100, 40000], &[0xe1, 0xd0, 0x8a, 0x64, 0x40, 0x9c, 0x00]),
        (
            7,
            3,
            &[i32::MAX, i32::MIN, -1],
            &[0xcf, 0xff, 0xff, 0xff, 0x7f, 0x00, 0x00, 0x00, 0x80, 0xff],
        ),
        (7, 3, &[70000, -129, 8388607], &[0xe6, 0x70, 0x11, 0x01, 0x7f, 0xff, 0xff, 0xff, 0x7f]),
        (8, 4, &[0, 0, 0, 0], &[0x00]),
        (8, 4, &[1, -1, 7, -8], &[0x55, 0x1f, 0x78]),
        (8, 4, &[0, 5, 100, -2], &[0x64, 0x56, 0x4e]),
        (8, 4, &[3, 1000, -4, -32768], &[0xdd, 0x30, 0x3e, 0x8c, 0x80, 0x00]),
        (8, 4, &[-100, 3, 127, -128], &[0xa6, 0x9c, 0x37, 0xf8, 0x00]),
        (8, 4, &[32767, 0, 1, -1000], &[0xd3, 0x7f, 0xff, 0x1f, 0xc1, 0x80]),
        (8, 4, &[6, 200, -7, 90], &[0x9d, 0x60, 0x0c, 0x89, 0x5a]),
        (6, 8, &[0; 8], &[0x00]),
        (6, 9, &[1, 0, -300, 0, 5, 0, 0, 70000], &[0x95, 0x02, 0xd7, 0x04, 0x0a, 0xe0, 0xc5, 0x08]),
        (
            6,
            8,
            &[-1, 2, -3, 4, -5, 6, -7, 8],
            &[0xff, 0x01, 0x04, 0x05, 0x08, 0x09, 0x0c, 0x0d, 0x10],
        ),
        (6, 3, &[1, 0, -300], &[0x05, 0x02, 0xd7, 0x04]),
        (6, 1, &[-300], &[0xd7, 0x04]),
        (0, 1, &[-64], &[0x7f]),
        (0, 2, &[64], &[0x80, 0x01]),
        (0, 1, &[i32::MAX], &[0xfe, 0xff, 0xff, 0xff, 0x0f]),
        (0, 1, &[i32::MIN], &[0xff, 0xff, 0xff, 0xff, 0x0f]),
        (1, 1, &[-1], &[0xff, 0xff, 0xff, 0xff, 0x0f]),
        // The voltage below the reference, in 14 bits.
        (3, 1, &[-800], &[0xa0, 0x06]),
        (3, 1, &[50], &[0xce, 0x7f]),
        (9, 1, &[0], &[]),
    ];

    #[test]
    fn numbers_are_read_as_betaflight_writes_them() {
        for (encoding, same, numbers, written) in WRITTEN {
            let mut bytes = Bytes::new(written);
            let read = group(*encoding, *same, &mut bytes).expect("whole");
            let read: Vec<i32> = read.into_iter().map(|it| it as i32).collect();
            assert_eq!(&read, numbers, "encoding {encoding}: {written:x?}");
            assert!(bytes.is_empty(), "encoding {encoding}: {written:x?}");
            for end in 0..written.len() {
                let cut = &written[..end];
                assert!(group(*encoding, *same, &mut Bytes::new(cut)).is_none(), "{cut:x?}");
            }
        }
    }

    #[test]
    fn the_time_goes_on_where_32_bits_wrap() {
        let coding = Coding { time: Some(1), iteration: Some(0), ..Coding::default() };
        let mut history = History::default();
        let mut times = Vec::new();
        for (n, time) in [4_294_000_000, 4_294_967_295, 100, 900_000].into_iter().enumerate() {
            let values = [n as i64, time];
            assert!(history.allows(b'P', &values, Some(&coding)), "{values:?}");
            times.push(history.add(b'P', &values, Some(&coding)));
        }
        assert_eq!(times, [4_294_000_000, 4_294_967_295, 4_294_967_396, 4_295_867_296]);
        let follows = |values: &[i64]| history.allows(b'I', values, Some(&coding));
        assert!(follows(&[4, 900_001]) && !follows(&[3, 900_001]) && !follows(&[4, 899_999]));
        assert!(!follows(&[4, 20_000_000]) && !follows(&[6000, 900_001]));
    }

    #[test]
    fn iterations_without_a_frame_are_counted() {
        let layout = |interval, share| Layout {
            interval: Some(interval),
            share: Some(share),
            ..Layout::default()
        };
        let cases = [
            (layout(32, (1, 1)), 5, 0),
            (layout(32, (1, 4)), 0, 3),
            (layout(32, (1, 4)), 28, 3),
            (layout(6, (1, 4)), 4, 1),
            (layout(32, (1, 2)), 7, 0),
            (Layout::default(), 7, 0),
        ];
        for (layout, iteration, expected) in cases {
            assert_eq!(layout.skipped(iteration), expected, "{:?}", layout.share);
        }
    }
}
