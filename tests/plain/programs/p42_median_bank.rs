//! A bank of sliding median filters that rejects spikes, with statistics.

/// Keeps the last `N` samples and gives their median.
#[derive(Clone, Debug)]
pub struct MedianFilter<const N: usize> {
    window: [f32; N],
    head: usize,
    filled: usize,
}

impl<const N: usize> Default for MedianFilter<N> {
    fn default() -> Self {
        Self { window: [0.0; N], head: 0, filled: 0 }
    }
}

impl<const N: usize> MedianFilter<N> {
    pub fn push(&mut self, sample: f32) -> Option<f32> {
        if !sample.is_finite() {
            return None;
        }
        self.window[self.head] = sample;
        self.head = (self.head + 1) % N;
        self.filled = (self.filled + 1).min(N);
        Some(self.median())
    }

    pub fn median(&self) -> f32 {
        if self.filled == 0 {
            return 0.0;
        }
        let mut sorted = self.window;
        let slice = &mut sorted[..self.filled];
        slice.sort_unstable_by(|a, b| a.partial_cmp(b).unwrap_or(core::cmp::Ordering::Equal));
        let mid = slice.len() / 2;
        if slice.len() % 2 == 1 { slice[mid] } else { 0.5 * (slice[mid - 1] + slice[mid]) }
    }

    pub fn spread(&self) -> f32 {
        let values = &self.window[..self.filled];
        let max = values.iter().copied().max_by(|a, b| a.total_cmp(b));
        let min = values.iter().copied().min_by(|a, b| a.total_cmp(b));
        match (max, min) {
            (Some(hi), Some(lo)) => hi - lo,
            _ => 0.0,
        }
    }

    /// The sample that is farthest from the median, and where it stands.
    pub fn outlier(&self) -> Option<(usize, f32)> {
        let median = self.median();
        self.window
            .iter()
            .take(self.filled)
            .enumerate()
            .map(|(i, &x)| (i, (x - median).abs()))
            .max_by(|(_, a), (_, b)| a.total_cmp(b))
    }
}

#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Stats {
    pub mean: f32,
    pub variance: f32,
    pub peak: f32,
}

impl Stats {
    pub fn of(samples: &[f32]) -> Self {
        if samples.is_empty() {
            return Self::default();
        }
        let n = samples.len() as f32;
        let mean = samples.iter().sum::<f32>() / n;
        let variance = samples.iter().map(|x| (x - mean).powi(2)).sum::<f32>() / n;
        let peak = samples.iter().map(|x| x.abs()).fold(0.0, f32::max);
        Self { mean, variance, peak }
    }
}

/// Four channels.
#[derive(Clone, Debug, Default)]
pub struct Bank {
    channels: [MedianFilter<5>; 4],
    rejected: u32,
}

impl Bank {
    pub fn update(&mut self, samples: [f32; 4]) -> [f32; 4] {
        let mut out = [0.0; 4];
        for ((channel, sample), slot) in self.channels.iter_mut().zip(samples).zip(out.iter_mut()) {
            match channel.push(sample) {
                Some(median) => *slot = median,
                None => {
                    self.rejected += 1;
                    *slot = channel.median();
                }
            }
        }
        out
    }

    pub fn stats(&self) -> Stats {
        let medians = core::array::from_fn::<f32, 4, _>(|i| self.channels[i].median());
        Stats::of(&medians)
    }

    pub fn noisiest(&self) -> usize {
        let mut best = 0;
        for (i, channel) in self.channels.iter().enumerate().skip(1) {
            if channel.spread() > self.channels[best].spread() {
                best = i;
            }
        }
        best
    }

    pub fn worst(&self) -> Option<(usize, f32)> {
        self.channels.iter().filter_map(|c| c.outlier()).min_by_key(|(i, _)| *i)
    }

    pub fn channel_mut(&mut self, full: bool) -> Option<&mut MedianFilter<5>> {
        self.channels.iter_mut().find(|c| (c.filled == 5) == full)
    }

    pub fn reset_first(&mut self, full: bool) -> bool {
        if let Some(channel) = self.channel_mut(full) {
            *channel = MedianFilter::default();
            true
        } else {
            false
        }
    }

    pub fn rejected(&self) -> u32 {
        self.rejected
    }
}
