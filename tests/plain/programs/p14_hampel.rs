//! Hampel outlier filter: a sample further from the running median than a few
//! scaled MADs is replaced by the median.

/// The filter's opinion of one sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Verdict {
    Clean(f32),
    Replaced { raw: f32, median: f32 },
}

impl Verdict {
    pub fn value(self) -> f32 {
        match self {
            Self::Clean(v) | Self::Replaced { median: v, .. } => v,
        }
    }

    pub fn is_outlier(&self) -> bool {
        matches!(self, Self::Replaced { .. })
    }
}

/// Causal Hampel filter over the last `N` raw samples.
#[derive(Clone, Debug)]
pub struct Hampel<const N: usize> {
    window: [f32; N],
    len: usize,
    next: usize,
    k: f32,
    floor: f32,
    outliers: u32,
}

impl<const N: usize> Hampel<N> {
    /// Makes the MAD a consistent estimate of the standard deviation.
    const MAD_TO_SIGMA: f32 = 1.4826;

    pub fn new(k: f32) -> Self {
        Self { window: [0.0; N], len: 0, next: 0, k, floor: 0.0, outliers: 0 }
    }

    /// Smallest threshold, so that a constant signal does not flag its own noise.
    #[must_use]
    pub fn with_floor(mut self, floor: f32) -> Self {
        self.floor = floor;
        self
    }

    pub fn push(&mut self, x: f32) -> Verdict {
        if x.is_nan() {
            let median = self.median().unwrap_or(0.0);
            self.outliers += 1;
            return Verdict::Replaced { raw: x, median };
        }
        self.window[self.next] = x;
        self.next = (self.next + 1) % N;
        self.len = (self.len + 1).min(N);

        // With too few samples there is nothing to judge by.
        let Some((median, mad)) = self.median_and_mad().filter(|_| self.len >= 3) else {
            return Verdict::Clean(x);
        };
        let threshold = (self.k * Self::MAD_TO_SIGMA * mad).max(self.floor);
        if (x - median).abs() <= threshold {
            Verdict::Clean(x)
        } else {
            self.outliers += 1;
            Verdict::Replaced { raw: x, median }
        }
    }

    pub fn median(&self) -> Option<f32> {
        let mut sorted = self.window;
        median_of(&mut sorted[..self.len])
    }

    fn median_and_mad(&self) -> Option<(f32, f32)> {
        let median = self.median()?;
        let mut deviations = self.window.map(|v| (v - median).abs());
        let mad = median_of(&mut deviations[..self.len])?;
        Some((median, mad))
    }

    pub fn outliers(&self) -> u32 {
        self.outliers
    }
}

/// Median of a slice that may be reordered; `None` if it is empty.
pub fn median_of(values: &mut [f32]) -> Option<f32> {
    values.sort_unstable_by(f32::total_cmp);
    let mid = values.len() / 2;
    match values {
        [] => None,
        [only] => Some(*only),
        v if v.len() % 2 == 1 => Some(v[mid]),
        v => Some(0.5 * (v[mid - 1] + v[mid])),
    }
}

/// The pressure channel's setting.
pub type PressureFilter = Hampel<7>;

impl Default for PressureFilter {
    fn default() -> Self {
        Self::new(3.0).with_floor(0.05)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn medians() {
        assert_eq!(median_of(&mut []), None);
        assert_eq!(median_of(&mut [4.0]), Some(4.0));
        assert_eq!(median_of(&mut [3.0, 1.0, 2.0]), Some(2.0));
        assert_eq!(median_of(&mut [4.0, 1.0, 2.0, 3.0]), Some(2.5));
    }

    #[test]
    fn spike_is_replaced_and_ramp_passes() {
        let mut f = PressureFilter::default();
        for n in 0..20 {
            let v = f.push(n as f32);
            assert!(!v.is_outlier(), "{n}: {v:?}");
        }
        let v = f.push(900.0);
        assert!(v.is_outlier() && v.value() < 20.0);
        assert_eq!(f.outliers(), 1);
    }

    #[test]
    fn nan_never_gets_into_the_window() {
        let mut f = Hampel::<5>::new(3.0);
        assert_eq!(f.push(f32::NAN).value(), 0.0);
        f.push(2.0);
        assert_eq!(f.push(f32::NAN).value(), 2.0);
        assert_eq!(f.median(), Some(2.0));
    }
}
