//! Ring buffer of log records, stored as zigzag varint deltas to their
//! predecessors; the oldest records make room for new ones.

/// One record: a time stamp and `C` channels.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Record<const C: usize> {
    pub time: u32,
    pub channels: [i32; C],
}

impl<const C: usize> Default for Record<C> {
    fn default() -> Self {
        Self { time: 0, channels: [0; C] }
    }
}

fn zigzag(value: i32) -> u32 {
    ((value << 1) ^ (value >> 31)) as u32
}

fn unzigzag(code: u32) -> i32 {
    (code >> 1) as i32 ^ -((code & 1) as i32)
}

/// Seven bits per byte, least significant first, high bit set on all but
/// the last byte.
fn varint(mut value: u32) -> impl Iterator<Item = u8> {
    let mut done = false;
    core::iter::from_fn(move || {
        if done {
            return None;
        }
        let low = (value & 0x7F) as u8;
        value >>= 7;
        done = value == 0;
        Some(if done { low } else { low | 0x80 })
    })
}

fn read_varint(bytes: &mut impl Iterator<Item = u8>) -> Option<u32> {
    let mut value = 0;
    for shift in (0..32).step_by(7) {
        let byte = bytes.next()?;
        value |= u32::from(byte & 0x7F) << shift;
        if byte & 0x80 == 0 {
            return Some(value);
        }
    }
    None
}

impl<const C: usize> Record<C> {
    /// The codes that lead from `base` to this record.
    fn deltas<'a>(&'a self, base: &'a Self) -> impl Iterator<Item = u32> + 'a {
        let channels = self.channels.iter().zip(&base.channels);
        core::iter::once(self.time.wrapping_sub(base.time))
            .chain(channels.map(|(new, old)| zigzag(new.wrapping_sub(*old))))
    }

    /// Inverse of `deltas`, straight from the encoded bytes.
    fn decode(base: &Self, bytes: &mut impl Iterator<Item = u8>) -> Option<Self> {
        let mut record = *base;
        record.time = record.time.wrapping_add(read_varint(bytes)?);
        for channel in &mut record.channels {
            *channel = channel.wrapping_add(unzigzag(read_varint(bytes)?));
        }
        Some(record)
    }
}

pub struct DeltaLog<const C: usize, const BYTES: usize> {
    storage: [u8; BYTES],
    start: usize,
    used: usize,
    /// Predecessor of the oldest record, where decoding begins.
    base: Record<C>,
    newest: Record<C>,
}

impl<const C: usize, const BYTES: usize> DeltaLog<C, BYTES> {
    pub fn new() -> Self {
        const { assert!(BYTES >= 5 * (C + 1), "the longest record must fit") };
        Self {
            storage: [0; BYTES],
            start: 0,
            used: 0,
            base: Record::default(),
            newest: Record::default(),
        }
    }

    pub fn bytes_used(&self) -> usize {
        self.used
    }

    pub fn push(&mut self, record: Record<C>) {
        let newest = self.newest;
        let encoded = || record.deltas(&newest).flat_map(varint);

        let size = encoded().count();
        while BYTES - self.used < size {
            self.drop_oldest();
        }
        for byte in encoded() {
            self.storage[(self.start + self.used) % BYTES] = byte;
            self.used += 1;
        }
        self.newest = record;
    }

    fn drop_oldest(&mut self) {
        let mut records = self.iter();
        let Some(oldest) = records.next() else {
            return;
        };
        let consumed = records.position;
        self.base = oldest;
        self.start = (self.start + consumed) % BYTES;
        self.used -= consumed;
    }

    /// Records from the oldest to the newest.
    pub fn iter(&self) -> Records<'_, C, BYTES> {
        Records { log: self, position: 0, previous: self.base }
    }
}

pub struct Records<'a, const C: usize, const BYTES: usize> {
    log: &'a DeltaLog<C, BYTES>,
    position: usize,
    previous: Record<C>,
}

impl<const C: usize, const BYTES: usize> Iterator for Records<'_, C, BYTES> {
    type Item = Record<C>;

    fn next(&mut self) -> Option<Record<C>> {
        let log = self.log;
        let mut position = self.position;
        let mut bytes = (self.position..log.used)
            .map(|i| log.storage[(log.start + i) % BYTES])
            .inspect(|_| position += 1);
        let record = Record::decode(&self.previous, &mut bytes)?;
        drop(bytes);
        self.position = position;
        self.previous = record;
        Some(record)
    }
}
