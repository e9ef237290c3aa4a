//! Telemetry statistics: a bounded batch kept in order by insertion, exact
//! quantiles of it, and a five-number summary for the downlink.

use core::cmp::Ordering;

/// Sorts in place; stable, and quick on data that is nearly in order.
pub fn insertion_sort_by<T: Copy>(data: &mut [T], mut compare: impl FnMut(&T, &T) -> Ordering) {
    for i in 1..data.len() {
        let item = data[i];
        let mut j = i;
        while j > 0 && compare(&item, &data[j - 1]) == Ordering::Less {
            data[j] = data[j - 1];
            j -= 1;
        }
        data[j] = item;
    }
}

/// A probability, 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Probability(f64);

impl Probability {
    pub const MEDIAN: Self = Self(0.5);
    pub const QUARTILES: [Self; 3] = [Self(0.25), Self(0.5), Self(0.75)];

    pub fn new(p: f64) -> Option<Self> {
        (0.0..=1.0).contains(&p).then_some(Self(p))
    }

    pub fn percent(n: u8) -> Option<Self> {
        Self::new(f64::from(n) / 100.0)
    }
}

/// Smallest, quartiles, largest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Summary {
    pub min: f64,
    pub q1: f64,
    pub median: f64,
    pub q3: f64,
    pub max: f64,
    pub mean: f64,
}

impl Summary {
    pub fn iqr(&self) -> f64 {
        self.q3 - self.q1
    }

    /// Tukey's fences: outliers lie outside.
    pub fn fences(&self) -> core::ops::RangeInclusive<f64> {
        let reach = 1.5 * self.iqr();
        self.q1 - reach..=self.q3 + reach
    }
}

/// Up to `N` readings in ascending order.
#[derive(Clone, Debug)]
pub struct Batch<const N: usize> {
    sorted: [f64; N],
    len: usize,
}

impl<const N: usize> Batch<N> {
    pub const fn new() -> Self {
        Self { sorted: [0.0; N], len: 0 }
    }

    /// Inserts a reading; gives it back when it is NaN or the batch is full.
    pub fn push(&mut self, reading: f64) -> Result<(), f64> {
        if reading.is_nan() || self.len == N {
            return Err(reading);
        }
        self.sorted[self.len] = reading;
        self.len += 1;
        insertion_sort_by(&mut self.sorted[..self.len], f64::total_cmp);
        Ok(())
    }

    pub fn as_slice(&self) -> &[f64] {
        &self.sorted[..self.len]
    }

    /// Quantile with linear interpolation between order statistics.
    pub fn quantile(&self, Probability(p): Probability) -> Option<f64> {
        let data = self.as_slice();
        let last = data.len().checked_sub(1)?;
        let position = p * last as f64;
        let below = position.floor();
        let index = below as usize;
        let (low, high) = (data[index], data[(index + 1).min(last)]);
        Some(low + (position - below) * (high - low))
    }

    /// Share of the readings at or below `x`.
    pub fn rank(&self, x: f64) -> f64 {
        match self.len {
            0 => 0.0,
            n => self.as_slice().partition_point(|&v| v <= x) as f64 / n as f64,
        }
    }

    pub fn summary(&self) -> Option<Summary> {
        let [Some(q1), Some(median), Some(q3)] = Probability::QUARTILES.map(|p| self.quantile(p))
        else {
            return None;
        };
        let (&min, &max) = self.as_slice().first().zip(self.as_slice().last())?;
        let mean = self.as_slice().iter().sum::<f64>() / self.len as f64;
        Some(Summary { min, q1, median, q3, max, mean })
    }

    /// Readings outside Tukey's fences.
    pub fn outliers(&self) -> impl Iterator<Item = f64> {
        let fences = self.summary().map(|s| s.fences());
        self.as_slice()
            .iter()
            .copied()
            .filter(move |v| fences.as_ref().is_some_and(|f| !f.contains(v)))
    }

    pub fn clear(&mut self) {
        self.len = 0;
    }
}

impl<const N: usize> Default for Batch<N> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const N: usize> FromIterator<f64> for Batch<N> {
    /// Takes what is good and fits.
    fn from_iter<I: IntoIterator<Item = f64>>(iter: I) -> Self {
        let mut batch = Self::new();
        for reading in iter.into_iter().filter(|r| !r.is_nan()).take(N) {
            let _ = batch.push(reading);
        }
        batch
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sort_is_stable() {
        let mut pairs = [(3, 'a'), (1, 'b'), (3, 'c'), (2, 'd'), (1, 'e')];
        insertion_sort_by(&mut pairs, |x, y| x.0.cmp(&y.0));
        assert_eq!(pairs, [(1, 'b'), (1, 'e'), (2, 'd'), (3, 'a'), (3, 'c')]);
    }

    #[test]
    fn quantiles_and_summary() {
        let batch: Batch<16> = (1..=9).rev().map(f64::from).collect();
        assert_eq!(batch.quantile(Probability::MEDIAN), Some(5.0));
        assert_eq!(Probability::percent(90).and_then(|p| batch.quantile(p)), Some(8.2));
        let s = batch.summary().unwrap();
        assert_eq!((s.min, s.q1, s.q3, s.max, s.mean), (1.0, 3.0, 7.0, 9.0, 5.0));
        assert!((batch.rank(3.5) - 1.0 / 3.0).abs() < 1e-12);
        assert_eq!(Probability::percent(101), None);
    }

    #[test]
    fn outliers_and_limits() {
        let mut batch = Batch::<6>::default();
        assert_eq!(batch.summary(), None);
        assert!([10.0, 11.0, 10.5, 99.0, 10.2, 10.8].iter().all(|&v| batch.push(v).is_ok()));
        assert_eq!(batch.push(1.0), Err(1.0));
        assert!(batch.outliers().eq([99.0]));
        batch.clear();
        assert!(batch.push(f64::NAN).is_err());
        assert_eq!(batch.outliers().count(), 0);
    }
}
