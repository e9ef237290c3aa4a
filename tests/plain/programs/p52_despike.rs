//! Moving-median despike filter for slow analogue channels.

/// Fixed-capacity ring buffer that overwrites its oldest element when full.
#[derive(Debug, Clone)]
pub struct RingBuffer<T, const N: usize> {
    items: [T; N],
    head: usize,
    len: usize,
}

impl<T: Copy + Default, const N: usize> RingBuffer<T, N> {
    pub fn new() -> Self {
        Self { items: [T::default(); N], head: 0, len: 0 }
    }

    pub fn push(&mut self, item: T) {
        self.items[self.head] = item;
        self.head = (self.head + 1) % N;
        self.len = (self.len + 1).min(N);
    }

    pub fn len(&self) -> usize {
        self.len
    }

    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// Iterates from the oldest to the newest element.
    pub fn iter(&self) -> impl Iterator<Item = T> + '_ {
        let start = self.head + N - self.len;
        (0..self.len).map(move |i| self.items[(start + i) % N])
    }
}

impl<T: Copy + Default, const N: usize> Default for RingBuffer<T, N> {
    fn default() -> Self {
        Self::new()
    }
}

/// Median of up to `N` values; `None` when the iterator is empty.
fn median<const N: usize>(values: impl Iterator<Item = f32>) -> Option<f32> {
    let mut sorted = [0.0; N];
    let mut len = 0;
    for (slot, value) in sorted.iter_mut().zip(values) {
        *slot = value;
        len += 1;
    }
    let sorted = &mut sorted[..len];
    sorted.sort_unstable_by(f32::total_cmp);

    let upper = *sorted.get(len / 2)?;
    if len % 2 == 1 { Some(upper) } else { Some(0.5 * (sorted[len / 2 - 1] + upper)) }
}

/// A sample-by-sample filter.
pub trait Filter {
    fn step(&mut self, sample: f32) -> f32;

    /// Filters a whole block in place.
    fn process(&mut self, block: &mut [f32]) {
        for sample in block {
            *sample = self.step(*sample);
        }
    }
}

/// Replaces samples that lie more than `threshold` scaled median absolute
/// deviations off the running median (a causal Hampel filter).
#[derive(Debug, Clone)]
pub struct Despike<const N: usize> {
    window: RingBuffer<f32, N>,
    threshold: f32,
    /// Smallest deviation regarded as a spike, so that a constant signal
    /// does not reject ordinary quantisation noise.
    floor: f32,
    rejected: u32,
}

impl<const N: usize> Despike<N> {
    /// Relates the MAD to the standard deviation of Gaussian noise.
    const MAD_TO_SIGMA: f32 = 1.4826;

    pub fn new(threshold: f32, floor: f32) -> Self {
        Self { window: RingBuffer::new(), threshold, floor, rejected: 0 }
    }

    pub fn rejected(&self) -> u32 {
        self.rejected
    }

    fn limits(&self) -> Option<(f32, f32)> {
        let centre = median::<N>(self.window.iter())?;
        let mad = median::<N>(self.window.iter().map(|x| (x - centre).abs()))?;
        let limit = (self.threshold * Self::MAD_TO_SIGMA * mad).max(self.floor);
        Some((centre, limit))
    }
}

impl<const N: usize> Filter for Despike<N> {
    fn step(&mut self, sample: f32) -> f32 {
        self.window.push(sample);
        match self.limits() {
            Some((centre, limit)) if (sample - centre).abs() > limit => {
                self.rejected += 1;
                centre
            }
            _ => sample,
        }
    }
}
