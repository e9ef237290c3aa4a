//! Probabilities of failures that plain sampling would need millions of runs for: subset simulation (S.-K. Au and J. Beck,
//! "Estimation of small failure probabilities in high dimensions by subset simulation", Probabilistic Engineering Mechanics 16
//! (2001)), with the conditional sampling of I. Papaioannou and others, "MCMC algorithms for subset simulation" (2015).
//!
//! The runs split at levels of severity: the worst tenth of each level begins chains of runs that are at least as severe. So a
//! failure of probability 10⁻⁶ needs some six levels, not millions of runs.
//!
//! Knows a run only as a function from normal numbers to a severity. A seed cannot stand in for the numbers: neighbours of
//! a severe seed are not severe.

use crate::campaign::Campaign;
use crate::error::Error;
use rand::{RngExt as _, SeedableRng as _};
use rand_chacha::ChaCha8Rng;
use rand_distr::StandardNormal;
use rayon::prelude::*;
use serde::Serialize;

/// A scenario whose chance is a list of numbers.
pub trait Rare: Sync {
    /// Returns the number of random numbers of a run.
    fn dimensions(&self) -> usize;

    /// Runs with independent normal numbers of mean 0 and variance 1, and returns how severe it was: 0 or more is a failure.
    ///
    /// The severity should rise gradually towards a failure, such as the largest error minus the largest permitted one. NaN
    /// counts as a failure.
    fn severity(&self, normals: &[f64]) -> f64;
}

/// Returns the uniform number, from 0 to 1, with the same rank as a normal one: for conditions between two limits.
///
/// It is Φ, the distribution function of the normal distribution with mean 0 and variance 1, by the complementary error function of
/// `libm`.
///
/// ```
/// use bessemer_campaign::rare::uniform;
/// let mass = |normal: f64| 1400.0 + 200.0 * uniform(normal);
/// assert_eq!(mass(0.0), 1500.0);
/// assert!(mass(-3.0) < 1401.0 && mass(3.0) > 1599.0);
/// ```
pub fn uniform(normal: f64) -> f64 {
    0.5 * libm::erfc(-normal * std::f64::consts::FRAC_1_SQRT_2)
}

/// Estimate of a small probability.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Estimate {
    /// Name of the campaign.
    pub kind: String,
    /// Estimated probability of a failure: the mean of the repetitions.
    pub probability: f64,
    /// Standard error of the estimate, from the spread of the repetitions.
    pub error: f64,
    /// Estimate of each repetition.
    pub repetitions: Vec<f64>,
    /// Number of runs in all.
    pub runs: u64,
    /// Normal numbers of the most severe run.
    pub worst: Vec<f64>,
    /// Its severity.
    pub severity: f64,
}

/// Effort of an estimate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Effort {
    /// Runs of each level, a multiple of 10.
    pub level: usize,
    /// Largest number of levels: a probability below 10 to the power of minus this is reported as 0.
    pub levels: usize,
    /// Independent repetitions, from which the error is estimated.
    pub repetitions: usize,
    /// Seed of all numbers.
    pub seed: u64,
}

impl Default for Effort {
    fn default() -> Self {
        Self { level: 1000, levels: 9, repetitions: 10, seed: 1 }
    }
}

/// Number of runs of a chain; its inverse is the share of a level that begins chains.
const CHAIN: usize = 10;
/// Correlation of a run with the one before it in its chain.
const CORRELATION: f64 = 0.8;

/// Estimates the probability of a failure.
///
/// # Errors
///
/// The campaign has no severity, or a number of the effort is out of range.
pub fn estimate(campaign: &dyn Campaign, effort: Effort) -> Result<Estimate, Error> {
    let kind = campaign.kind().to_owned();
    let wrong = |wrong: &str| Error::Campaign { kind: kind.clone(), wrong: wrong.to_owned() };
    let rare = campaign.rare().ok_or_else(|| {
        wrong("it has no severity\nhelp: implement `Rare`, and return it in `Campaign::rare`")
    })?;
    if effort.level < 2 * CHAIN || !effort.level.is_multiple_of(CHAIN) {
        return Err(wrong("write a multiple of 10, at least 20, as the runs of a level"));
    }
    if effort.repetitions < 2 || effort.levels == 0 {
        return Err(wrong("write at least 2 repetitions and 1 level"));
    }
    let all: Vec<Repetition> =
        (0..effort.repetitions).map(|n| repetition(rare, effort, n as u64)).collect();
    let repetitions: Vec<f64> = all.iter().map(|it| it.probability).collect();
    let count = repetitions.len() as f64;
    let mean = repetitions.iter().sum::<f64>() / count;
    let squares: f64 = repetitions.iter().map(|it| (it - mean) * (it - mean)).sum();
    let runs = all.iter().map(|it| it.runs).sum();
    let worst =
        all.into_iter().max_by(|one, other| one.worst.severity.total_cmp(&other.worst.severity));
    let (worst, severity) =
        worst.map(|it| (it.worst.normals, it.worst.severity)).unwrap_or_default();
    let error = (squares / (count - 1.0) / count).sqrt();
    Ok(Estimate { kind, probability: mean, error, repetitions, runs, worst, severity })
}

#[derive(Clone)]
struct Sample {
    normals: Vec<f64>,
    severity: f64,
}

struct Repetition {
    probability: f64,
    runs: u64,
    worst: Sample,
}

impl Sample {
    fn of(rare: &dyn Rare, normals: Vec<f64>) -> Self {
        let severity = rare.severity(&normals);
        Self { normals, severity: if severity.is_nan() { f64::INFINITY } else { severity } }
    }
}

/// Returns independent normal numbers; they depend on all arguments.
fn normals(seed: u64, (repetition, level): (u64, usize), run: usize, count: usize) -> Vec<f64> {
    let mut chance = ChaCha8Rng::seed_from_u64(seed);
    chance.set_stream(repetition << 48 | (level as u64) << 40 | run as u64);
    (0..count).map(|_| chance.sample(StandardNormal)).collect()
}

fn repetition(rare: &dyn Rare, effort: Effort, number: u64) -> Repetition {
    let count = rare.dimensions();
    let mut samples: Vec<Sample> = (0..effort.level)
        .into_par_iter()
        .map(|n| Sample::of(rare, normals(effort.seed, (number, 0), n, count)))
        .collect();
    let mut runs = effort.level as u64;
    let mut probability = 1.0;
    for level in 1..=effort.levels {
        samples.sort_by(|one, other| other.severity.total_cmp(&one.severity));
        let begin = effort.level / CHAIN;
        let failed = samples.iter().take_while(|it| it.severity >= 0.0).count();
        if failed >= begin || level == effort.levels {
            probability *= failed as f64 / effort.level as f64;
            break;
        }
        probability /= CHAIN as f64;
        samples.truncate(begin);
        let bound = samples.last().map_or(0.0, |it| it.severity);
        let chain = |(index, start): (usize, &Sample)| {
            let mut chain = vec![start.clone()];
            for step in 1..CHAIN {
                let run = index * CHAIN + step;
                let fresh = normals(effort.seed, (number, level), run, count);
                let here = &chain[step - 1];
                let spread = (1.0 - CORRELATION * CORRELATION).sqrt();
                let moved = here.normals.iter().zip(&fresh);
                let moved = moved.map(|(old, new)| CORRELATION * old + spread * new).collect();
                let next = Sample::of(rare, moved);
                chain.push(if next.severity >= bound { next } else { here.clone() });
            }
            chain
        };
        samples = samples.par_iter().enumerate().flat_map_iter(chain).collect();
        runs += (begin * (CHAIN - 1)) as u64;
    }
    let worst = samples.iter().max_by(|one, other| one.severity.total_cmp(&other.severity));
    let worst =
        worst.cloned().unwrap_or(Sample { normals: Vec::new(), severity: f64::NEG_INFINITY });
    Repetition { probability, runs, worst }
}
