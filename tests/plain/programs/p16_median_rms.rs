//! Running median and moving RMS behind one small filter trait, with a chain of
//! two filters for the vibration channel.

/// Anything that turns one sample into one sample.
pub trait Filter {
    fn step(&mut self, x: f32) -> f32;

    fn reset(&mut self);

    /// Runs `self` first and `next` on its output.
    fn then<F: Filter>(self, next: F) -> Chain<Self, F>
    where
        Self: Sized,
    {
        Chain { first: self, second: next }
    }
}

/// Median of the last `N` samples; the window is kept sorted beside the ring.
#[derive(Clone, Debug)]
pub struct MedianFilter<const N: usize> {
    ring: [f32; N],
    sorted: [f32; N],
    len: usize,
    next: usize,
}

impl<const N: usize> MedianFilter<N> {
    pub const fn new() -> Self {
        const { assert!(N % 2 == 1, "the window must be odd") };
        Self { ring: [0.0; N], sorted: [0.0; N], len: 0, next: 0 }
    }

    fn remove(&mut self, x: f32) {
        let filled = &mut self.sorted[..self.len];
        if let Some(i) = filled.iter().position(|v| v.to_bits() == x.to_bits()) {
            filled.copy_within(i + 1.., i);
            self.len -= 1;
        }
    }

    fn insert(&mut self, x: f32) {
        let i = self.sorted[..self.len].partition_point(|v| v.total_cmp(&x).is_lt());
        self.sorted.copy_within(i..self.len, i + 1);
        self.sorted[i] = x;
        self.len += 1;
    }

    /// Median of what is in the window; lower middle while it fills up.
    pub fn median(&self) -> Option<f32> {
        self.sorted[..self.len].get(self.len.checked_sub(1)? / 2).copied()
    }
}

impl<const N: usize> Filter for MedianFilter<N> {
    fn step(&mut self, x: f32) -> f32 {
        if self.len == N {
            self.remove(self.ring[self.next]);
        }
        self.ring[self.next] = x;
        self.next = (self.next + 1) % N;
        self.insert(x);
        self.median().unwrap_or(x)
    }

    fn reset(&mut self) {
        *self = Self::new();
    }
}

impl<const N: usize> Default for MedianFilter<N> {
    fn default() -> Self {
        Self::new()
    }
}

/// Root mean square over the last `N` samples.
#[derive(Clone, Debug)]
pub struct MovingRms<const N: usize> {
    squares: [f32; N],
    next: usize,
    filled: usize,
    sum: f64,
}

impl<const N: usize> MovingRms<N> {
    pub const fn new() -> Self {
        Self { squares: [0.0; N], next: 0, filled: 0, sum: 0.0 }
    }
}

impl<const N: usize> Filter for MovingRms<N> {
    fn step(&mut self, x: f32) -> f32 {
        let old = core::mem::replace(&mut self.squares[self.next], x * x);
        self.sum += f64::from(x * x) - f64::from(old);
        self.next += 1;
        self.filled = self.filled.max(self.next);
        if self.next == N {
            self.next = 0;
            // Sum afresh once per turn so that rounding cannot pile up.
            self.sum = self.squares.iter().copied().map(f64::from).sum();
        }
        (self.sum.max(0.0) / self.filled as f64).sqrt() as f32
    }

    fn reset(&mut self) {
        *self = Self::new();
    }
}

impl<const N: usize> Default for MovingRms<N> {
    fn default() -> Self {
        Self::new()
    }
}

/// Two filters in series, made by [`Filter::then`].
#[derive(Clone, Debug, Default)]
pub struct Chain<A, B> {
    first: A,
    second: B,
}

impl<A: Filter, B: Filter> Filter for Chain<A, B> {
    fn step(&mut self, x: f32) -> f32 {
        self.second.step(self.first.step(x))
    }

    fn reset(&mut self) {
        self.first.reset();
        self.second.reset();
    }
}

/// Despiked vibration level.
pub type VibrationLevel = Chain<MedianFilter<3>, MovingRms<16>>;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn median_follows_and_ignores_spikes() {
        let mut f = MedianFilter::<5>::new();
        let out = [3.0, 1.0, 2.0, 100.0, 2.5, -50.0, 2.0].map(|x| f.step(x));
        assert_eq!(out, [3.0, 1.0, 2.0, 2.0, 2.5, 2.0, 2.0]);
        f.reset();
        assert_eq!(f.median(), None);
    }

    #[test]
    fn rms_of_a_square_wave_is_its_amplitude() {
        let mut f = MovingRms::<8>::new();
        let last = (0..50).map(|n| f.step(if n % 2 == 0 { 3.0 } else { -3.0 })).last();
        assert!(last.is_some_and(|v| (v - 3.0).abs() < 1e-6));
        let faded = (0..8).map(|_| f.step(0.0)).last();
        assert_eq!(faded, Some(0.0));
    }

    #[test]
    fn chain_despikes_before_averaging() {
        let mut level = VibrationLevel::default();
        let peak = (0..64)
            .map(|n| level.step(if n % 20 == 7 { 500.0 } else { 1.0 }))
            .fold(0.0, f32::max);
        assert!((peak - 1.0).abs() < 1e-6, "{peak}");
        let mut same = MedianFilter::<3>::new().then(MovingRms::<16>::new());
        assert_eq!(same.step(2.0), 2.0);
    }
}
