//! A logger that keeps the last events in a ring of bytes.

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Level {
    Debug,
    Info,
    Warn,
    Error,
}

impl Level {
    fn from_u8(raw: u8) -> Option<Level> {
        Some(match raw {
            0 => Level::Debug,
            1 => Level::Info,
            2 => Level::Warn,
            3 => Level::Error,
            _ => return None,
        })
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Record {
    pub stamp: u32,
    pub level: Level,
    pub code: u16,
    pub value: Option<i32>,
}

#[derive(Clone, Debug)]
pub struct Log<const N: usize> {
    bytes: [u8; N],
    read: usize,
    len: usize,
    dropped: u32,
    threshold: Level,
}

impl<const N: usize> Log<N> {
    pub const fn new(threshold: Level) -> Self {
        Log { bytes: [0; N], read: 0, len: 0, dropped: 0, threshold }
    }

    fn put(&mut self, byte: u8) {
        let at = (self.read + self.len) % N;
        self.bytes[at] = byte;
        self.len += 1;
    }

    fn get(&mut self) -> Option<u8> {
        if self.len == 0 {
            return None;
        }
        let byte = self.bytes[self.read];
        self.read = (self.read + 1) % N;
        self.len -= 1;
        Some(byte)
    }

    fn take<const M: usize>(&mut self) -> Option<[u8; M]> {
        let mut out = [0; M];
        for slot in &mut out {
            *slot = self.get()?;
        }
        Some(out)
    }

    fn free(&self) -> usize {
        N - self.len
    }

    pub fn log(&mut self, record: &Record) -> bool {
        if record.level < self.threshold {
            return false;
        }
        let needed = 7 + if record.value.is_some() { 4 } else { 0 };
        if needed > N {
            self.dropped = self.dropped.saturating_add(1);
            return false;
        }
        while self.free() < needed {
            if self.pop().is_none() {
                break;
            }
            self.dropped = self.dropped.saturating_add(1);
        }
        let head = (record.level as u8) | if record.value.is_some() { 0x80 } else { 0 };
        self.put(head);
        record.stamp.to_le_bytes().iter().for_each(|&b| self.put(b));
        for b in record.code.to_le_bytes() {
            self.put(b);
        }
        if let Some(value) = record.value {
            value.to_le_bytes().into_iter().for_each(|b| self.put(b));
        }
        true
    }

    pub fn pop(&mut self) -> Option<Record> {
        let head = self.get()?;
        let level = Level::from_u8(head & 0x7F)?;
        let stamp = u32::from_le_bytes(self.take()?);
        let code = u16::from_le_bytes(self.take()?);
        let value = if head & 0x80 != 0 { Some(i32::from_le_bytes(self.take()?)) } else { None };
        Some(Record { stamp, level, code, value })
    }

    pub fn drain_worst(&mut self) -> Option<Record> {
        let mut worst: Option<Record> = None;
        while let Some(record) = self.pop() {
            worst = match worst {
                Some(w) if w.level >= record.level => Some(w),
                _ => Some(record),
            };
        }
        worst
    }

    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    pub fn dropped(&self) -> u32 {
        self.dropped
    }
}

pub fn exercise(codes: [u16; 6], level: u8, value: i32) -> (u32, u16) {
    let mut log = Log::<32>::new(Level::Info);
    let level = Level::from_u8(level % 4).unwrap_or(Level::Debug);
    for (stamp, &code) in (0u32..).zip(codes.iter()) {
        let value = (code % 2 == 0).then_some(value);
        log.log(&Record { stamp, level, code, value });
    }
    let _ = log.pop();
    let code = log.drain_worst().map(|r| r.code).unwrap_or_default();
    (log.dropped(), code)
}
