//! Debouncer for a bank of up to 32 inputs: one integrating counter per input,
//! edges as bit masks, and long presses on top.

use core::ops::{BitAnd, BitOr, Not};

/// A set of inputs, bit `n` for input `n`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Inputs(pub u32);

impl Inputs {
    pub const NONE: Self = Self(0);

    pub const fn single(n: u32) -> Self {
        Self(1 << (n % u32::BITS))
    }

    pub const fn contains(self, n: usize) -> bool {
        self.0 >> n & 1 == 1
    }

    pub const fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// Numbers of the inputs in the set, ascending.
    pub fn iter(self) -> impl Iterator<Item = usize> {
        (0..u32::BITS as usize).filter(move |&n| self.contains(n))
    }
}

impl BitAnd for Inputs {
    type Output = Self;
    fn bitand(self, rhs: Self) -> Self {
        Self(self.0 & rhs.0)
    }
}

impl BitOr for Inputs {
    type Output = Self;
    fn bitor(self, rhs: Self) -> Self {
        Self(self.0 | rhs.0)
    }
}

impl Not for Inputs {
    type Output = Self;
    fn not(self) -> Self {
        Self(!self.0)
    }
}

impl FromIterator<usize> for Inputs {
    fn from_iter<I: IntoIterator<Item = usize>>(iter: I) -> Self {
        iter.into_iter().fold(Self::NONE, |set, n| set | Self::single(n as u32))
    }
}

/// What one scan brought.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Scan {
    pub pressed: Inputs,
    pub released: Inputs,
    /// Inputs that have just been held for the long-press time.
    pub held: Inputs,
}

#[derive(Clone, Copy, Debug, Default)]
struct Channel {
    integrator: u8,
    on: bool,
    on_for: u16,
}

/// Bank of `N` inputs, scanned at a fixed rate.
#[derive(Clone, Debug)]
pub struct DebouncerBank<const N: usize> {
    channels: [Channel; N],
    threshold: u8,
    hold_scans: u16,
    inverted: Inputs,
}

impl<const N: usize> DebouncerBank<N> {
    /// `threshold` is the number of net scans an input must be in its new state.
    pub fn new(threshold: u8, hold_scans: u16) -> Self {
        const { assert!(N <= 32) };
        Self {
            channels: [Channel::default(); N],
            threshold: threshold.max(1),
            hold_scans,
            inverted: Inputs::NONE,
        }
    }

    /// Marks inputs that are active low.
    pub fn with_active_low(self, inverted: Inputs) -> Self {
        Self { inverted, ..self }
    }

    pub fn step(&mut self, raw: Inputs) -> Scan {
        let level = (raw & !self.inverted) | (!raw & self.inverted);
        let mut scan = Scan::default();
        for (n, ch) in self.channels.iter_mut().enumerate() {
            ch.integrator = if level.contains(n) {
                (ch.integrator + 1).min(self.threshold)
            } else {
                ch.integrator.saturating_sub(1)
            };
            let me = Inputs::single(n as u32);
            match ch.integrator {
                0 if ch.on => {
                    *ch = Channel::default();
                    scan.released = scan.released | me;
                }
                i if i == self.threshold && !ch.on => {
                    ch.on = true;
                    scan.pressed = scan.pressed | me;
                }
                _ if ch.on => {
                    ch.on_for = ch.on_for.saturating_add(1);
                    if ch.on_for == self.hold_scans {
                        scan.held = scan.held | me;
                    }
                }
                _ => {}
            }
        }
        scan
    }

    /// Debounced state of all inputs.
    pub fn state(&self) -> Inputs {
        self.channels.iter().enumerate().filter_map(|(n, ch)| ch.on.then_some(n)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bounce_gives_one_press() {
        let mut bank = DebouncerBank::<8>::new(4, 1000);
        let noisy = [1, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1, 1];
        let presses = noisy
            .iter()
            .map(|&b| bank.step(Inputs(b << 3)))
            .filter(|s| s.pressed == Inputs::single(3))
            .count();
        assert_eq!(presses, 1);
        assert_eq!(bank.state(), Inputs(0b1000));
    }

    #[test]
    fn long_press_comes_once_and_release_follows() {
        let mut bank = DebouncerBank::<2>::new(2, 10);
        let held = (0..50).filter(|_| !bank.step(Inputs(0b10)).held.is_empty()).count();
        assert_eq!(held, 1);
        let released = (0..3).map(|_| bank.step(Inputs::NONE)).find(|s| !s.released.is_empty());
        assert!(released.is_some_and(|s| s.released.iter().eq([1])));
    }

    #[test]
    fn active_low_inputs_rest_high() {
        let mut bank = DebouncerBank::<4>::new(3, 100).with_active_low(Inputs(0b0101));
        (0..10).for_each(|_| {
            bank.step(Inputs(0b0101));
        });
        assert!(bank.state().is_empty());
        (0..3).for_each(|_| {
            bank.step(Inputs(0b0001));
        });
        assert_eq!(bank.state().iter().next(), Some(2));
    }
}
