//! Optional mutable references to elements: in the C the chosen element is an index.

use bessemer::prelude::*;

/// A pending transfer.
#[data]
#[derive(Clone, Copy, Debug, Default)]
pub struct Transfer {
    /// Identifies the transfer.
    pub id: u8,
    /// True if the transfer is in progress.
    pub busy: bool,
    /// Number of attempts.
    pub tries: u16,
}

/// All transfers.
#[data]
#[derive(Clone, Copy, Debug, Default)]
pub struct Transfers {
    /// The transfers, in no particular order.
    pub all: [Transfer; 6],
}

#[data]
impl Transfers {
    /// The transfer with an `id`.
    pub fn of(&mut self, id: u8) -> Option<&mut Transfer> {
        self.all.iter_mut().find(|it| it.busy && it.id == id)
    }

    /// The transfer at an index, or the number of transfers as an error.
    pub fn at(&mut self, index: usize) -> Result<&mut Transfer, u8> {
        self.all.get_mut(index).ok_or(3)
    }

    /// The transfer with most attempts; the first if none has many.
    pub fn worst(&mut self) -> &mut Transfer {
        let mut at = 0;
        for i in 1..self.all.len() {
            if self.all[i].tries > self.all[at].tries {
                at = i;
            }
        }
        if self.all[at].tries < 3 {
            return &mut self.all[0];
        }
        &mut self.all[at]
    }

    /// The first transfer in progress.
    pub fn busy(&self) -> &Transfer {
        for transfer in &self.all {
            if transfer.busy {
                return transfer;
            }
        }
        &self.all[0]
    }

    /// A free transfer, marked as in progress.
    pub fn begun(&mut self, id: u8) -> Option<&mut Transfer> {
        let free = self.all.iter_mut().find(|it| !it.busy)?;
        free.busy = true;
        free.id = id;
        Some(free)
    }
}

/// Repeats a transfer; returns false if there is none with this `id`.
#[function]
pub fn try_again(transfers: &mut Transfers, id: u8) -> bool {
    match transfers.of(id) {
        Some(transfer) => {
            transfer.tries = transfer.tries.saturating_add(1);
            true
        }
        None => false,
    }
}

/// Starts a transfer, or abandons the one with least attempts.
#[function]
pub fn begin(transfers: &mut Transfers, id: u8) -> u16 {
    if let Some(begun) = transfers.begun(id) {
        begun.tries = 1;
        return 0;
    }
    let least = transfers.all.iter_mut().min_by_key(|it| it.tries);
    least.map_or(9, |it| {
        it.id = id;
        it.tries
    })
}

/// Abandons the transfer with most attempts; returns their number.
#[function]
pub fn give_up(transfers: &mut Transfers) -> u16 {
    let worst = transfers.worst();
    worst.busy = false;
    let tries = worst.tries;
    transfers.worst().tries = 0;
    tries
}

/// Marks the transfer in progress with most attempts, the last of several; returns their number.
#[function]
pub fn mark(transfers: &mut Transfers, id: u8) -> u16 {
    let mut most: Option<&mut Transfer> = None;
    for transfer in transfers.all.iter_mut() {
        if transfer.busy && most.as_ref().is_none_or(|it| transfer.tries >= it.tries) {
            most = Some(transfer);
        }
    }
    most.map_or(0, |it| {
        it.id = id;
        it.tries
    })
}

/// The `id` and the attempts of the first transfer in progress.
#[function]
pub fn first(transfers: &Transfers) -> (u8, u16) {
    let first = transfers.busy();
    (first.id, transfers.busy().tries)
}

/// Ends the transfer at an index.
#[function]
pub fn end(transfers: &mut Transfers, index: usize) -> Result<u16, u8> {
    let ended = transfers.at(index)?;
    ended.busy = false;
    Ok(ended.tries)
}

/// Halves the last reading above a limit; returns its index.
#[function]
pub fn halve(readings: &mut [f32; 5], most: f32) -> usize {
    let mut high = readings.iter_mut().enumerate().filter(|it| *it.1 > most);
    if let Some((index, reading)) = high.next() {
        *reading *= 0.5;
        return index;
    }
    let mut last: Option<&mut f32> = None;
    for reading in readings.iter_mut() {
        if *reading < 0.0 {
            last = Some(reading);
        }
    }
    if let Some(reading) = last {
        *reading = 0.0;
    }
    5
}

/// The largest of some values, found by its index, without a check.
#[function]
pub fn largest(values: &[i32; 7]) -> i32 {
    let mut best = 0;
    for i in 1..7 {
        if values[i] > values[best] {
            best = i;
        }
    }
    values[best]
}

/// Sets a reading in place.
#[function]
pub fn set(readings: &mut [f32; 5], index: usize, to: f32) {
    *readings.get_mut(index).unwrap() = to;
    *readings.iter_mut().rev().find(|it| **it > to).unwrap() = to;
}

/// A transmitted frame, byte by byte.
#[data]
#[derive(Clone, Copy, Debug, Default)]
pub struct Frame {
    /// The bytes.
    pub bytes: [u8; 5],
    /// Number of bytes.
    pub length: u8,
}

#[data]
impl Frame {
    /// Appends a byte; returns the length as an error if the frame is full.
    pub fn put(&mut self, byte: u8) -> Result<&mut Self, u8> {
        match self.bytes.get_mut(usize::from(self.length)) {
            Some(free) => *free = byte,
            None => return Err(self.length),
        }
        self.length += 1;
        Ok(self)
    }

    /// Appends a word as two bytes.
    pub fn put_word(&mut self, word: u16) -> Result<&mut Self, u8> {
        let [high, low] = word.to_be_bytes();
        self.put(high)?.put(low)
    }
}

/// Appends a command, its argument and their checksum; returns the checksum.
#[function]
pub fn framed(frame: &mut Frame, command: u8, argument: u16) -> Result<u8, u8> {
    let filled = frame.put(command)?.put_word(argument)?;
    filled.bytes[0] |= 0x80;
    Ok(filled.length)
}
