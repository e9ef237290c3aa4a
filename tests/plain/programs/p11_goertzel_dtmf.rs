//! Goertzel filter bank and a DTMF decoder on top of it.

use core::f32::consts::TAU;

/// Single-bin Goertzel detector over blocks.
#[derive(Clone, Copy, Debug)]
pub struct Goertzel {
    coeff: f32,
    s1: f32,
    s2: f32,
}

impl Goertzel {
    pub fn new(freq: f32, fs: f32) -> Self {
        Self { coeff: 2.0 * (TAU * freq / fs).cos(), s1: 0.0, s2: 0.0 }
    }

    pub fn push(&mut self, x: f32) {
        let s0 = x + self.coeff * self.s1 - self.s2;
        self.s2 = core::mem::replace(&mut self.s1, s0);
    }

    /// Power of the block so far; the detector starts afresh.
    pub fn take_power(&mut self) -> f32 {
        let Self { coeff, s1, s2 } = *self;
        (self.s1, self.s2) = (0.0, 0.0);
        s1 * s1 + s2 * s2 - coeff * s1 * s2
    }
}

const ROWS: [f32; 4] = [697.0, 770.0, 852.0, 941.0];
const COLUMNS: [f32; 4] = [1209.0, 1336.0, 1477.0, 1633.0];
const KEYS: [[char; 4]; 4] = [
    ['1', '2', '3', 'A'],
    ['4', '5', '6', 'B'],
    ['7', '8', '9', 'C'],
    ['*', '0', '#', 'D'],
];

/// DTMF decoder; reports every key once, when it has been there for two blocks.
#[derive(Clone, Debug)]
pub struct DtmfDecoder {
    rows: [Goertzel; 4],
    columns: [Goertzel; 4],
    energy: f32,
    filled: usize,
    last_block: Option<char>,
    reported: Option<char>,
}

impl DtmfDecoder {
    pub const SAMPLE_RATE: f32 = 8000.0;
    pub const BLOCK: usize = 205;
    /// Smallest share of the block's energy in the two tones together.
    const PURITY: f32 = 0.6;
    const MIN_ENERGY: f32 = 0.5;
    /// Largest ratio between the two tones.
    const TWIST: f32 = 8.0;

    pub fn new() -> Self {
        let bank = |freqs: [f32; 4]| freqs.map(|f| Goertzel::new(f, Self::SAMPLE_RATE));
        Self {
            rows: bank(ROWS),
            columns: bank(COLUMNS),
            energy: 0.0,
            filled: 0,
            last_block: None,
            reported: None,
        }
    }

    /// Feeds one sample; a key is returned at the moment it becomes valid.
    pub fn push(&mut self, x: f32) -> Option<char> {
        for g in self.rows.iter_mut().chain(self.columns.iter_mut()) {
            g.push(x);
        }
        self.energy += x * x;
        self.filled += 1;
        if self.filled < Self::BLOCK {
            return None;
        }
        self.filled = 0;
        let energy = core::mem::take(&mut self.energy);
        let found = self.evaluate(energy);

        let stable = found == self.last_block;
        self.last_block = found;
        if !stable || found == self.reported {
            return None;
        }
        self.reported = found;
        found
    }

    fn evaluate(&mut self, energy: f32) -> Option<char> {
        let (row, row_power) = strongest(&mut self.rows)?;
        let (column, column_power) = strongest(&mut self.columns)?;
        if energy < Self::MIN_ENERGY {
            return None;
        }
        let purity = 2.0 * (row_power + column_power) / (energy * Self::BLOCK as f32);
        let twist = row_power.max(column_power) / row_power.min(column_power).max(1e-9);
        (purity > Self::PURITY && twist < Self::TWIST).then(|| KEYS[row][column])
    }
}

impl Default for DtmfDecoder {
    fn default() -> Self {
        Self::new()
    }
}

fn strongest(bank: &mut [Goertzel]) -> Option<(usize, f32)> {
    bank.iter_mut()
        .map(Goertzel::take_power)
        .enumerate()
        .max_by(|(_, a), (_, b)| a.total_cmp(b))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tone(n: usize, f1: f32, f2: f32) -> f32 {
        let t = n as f32 / DtmfDecoder::SAMPLE_RATE;
        0.5 * (TAU * f1 * t).sin() + 0.4 * (TAU * f2 * t).sin()
    }

    #[test]
    fn every_key_is_decoded_once() {
        for (r, row) in KEYS.iter().enumerate() {
            for (c, &key) in row.iter().enumerate() {
                let mut dec = DtmfDecoder::new();
                let mut hits = (0..1600).filter_map(|n| dec.push(tone(n, ROWS[r], COLUMNS[c])));
                assert_eq!(hits.next(), Some(key));
                assert_eq!(hits.next(), None);
            }
        }
    }

    #[test]
    fn single_tone_and_silence_give_nothing() {
        let mut dec = DtmfDecoder::default();
        assert!((0..1000).all(|n| dec.push(tone(n, 697.0, 697.0)).is_none()));
        assert!((0..1000).all(|_| dec.push(0.0).is_none()));
    }

    #[test]
    fn key_repeats_after_a_pause() {
        let mut dec = DtmfDecoder::new();
        let pressed = (0..4100)
            .filter_map(|n| dec.push(if (1640..2870).contains(&n) { 0.0 } else { tone(n, 770.0, 1336.0) }))
            .filter(|&k| k == '5')
            .count();
        assert_eq!(pressed, 2);
    }
}
