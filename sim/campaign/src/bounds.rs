//! Confidence bounds of a probability: those of C. Clopper and E. Pearson, "The use of confidence or fiducial limits
//! illustrated in the case of the binomial", Biometrika 26 (1934), pages 404 to 413.
//!
//! They are exact, and so never too narrow, even where nothing or everything happened.

use serde::Serialize;
use statrs::distribution::{Beta, ContinuousCDF as _};

/// Probability that the bounds contain the true one, at least.
pub const CONFIDENCE: f64 = 0.95;

/// Frequency of an event among runs, with the bounds of its probability.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Rate {
    /// Number of runs in which it happened.
    pub events: u64,
    /// Number of runs.
    pub runs: u64,
    /// Lower bound of the probability.
    pub low: f64,
    /// Upper bound of the probability.
    pub high: f64,
}

impl Rate {
    /// Creates the rate of `events` among `runs`; without runs, the bounds are 0 and 1.
    ///
    /// ```
    /// use bessemer_campaign::Rate;
    ///
    /// // Nothing happened in 1000 runs: the probability may still be 0.37 %.
    /// let rate = Rate::of(0, 1000);
    /// assert_eq!(rate.low, 0.0);
    /// assert!((rate.high - 0.003_682).abs() < 1e-6);
    /// ```
    pub fn of(events: u64, runs: u64) -> Self {
        let events = events.min(runs);
        let (k, n) = (events as f64, runs as f64);
        let tail = (1.0 - CONFIDENCE) / 2.0;
        let quantile =
            |share: f64, a: f64, b: f64| Beta::new(a, b).ok().map(|it| it.inverse_cdf(share));
        let closed = |tail: f64| -(tail.ln() / n).exp_m1();
        let low = match events {
            0 => 0.0,
            _ if events == runs => 1.0 - closed(tail),
            _ => quantile(tail, k, n - k + 1.0).unwrap_or(0.0),
        };
        let high = match events {
            _ if events == runs => 1.0,
            0 => closed(tail),
            _ => quantile(1.0 - tail, k + 1.0, n - k).unwrap_or(1.0),
        };
        Self { events, runs, low, high }
    }

    /// Returns the share of runs in which it happened; 0 without runs.
    pub fn share(&self) -> f64 {
        if self.runs == 0 { 0.0 } else { self.events as f64 / self.runs as f64 }
    }
}
