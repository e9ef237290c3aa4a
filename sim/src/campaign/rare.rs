//! Flights without a failure that leave the envelope: too rare to be counted, so they are searched by their severity.
//!
//! The numbers are the dice of the scenario, and one that chooses noise and gusts.

use super::dice::{self, Dice};
use super::outcome;
use crate::scenario::Scenario;
use bessemer_campaign::rare::{Rare, uniform};

/// The most dice of a scenario: with three outages of Vicon.
const DICE: usize = 40;

/// Number of different noises and gusts.
const NOISES: u64 = 1 << 32;

/// Severity of flights without a failure: the distance to the limits of the envelope.
pub struct Envelope;

/// Dice that are normal numbers. Behind the last, each is in the middle.
struct Normals<'n> {
    all: std::slice::Iter<'n, f64>,
    drawn: usize,
}

impl Dice for Normals<'_> {
    fn between(&mut self, least: f64, most: f64) -> f64 {
        self.drawn += 1;
        least + (most - least) * uniform(self.all.next().copied().unwrap_or(0.0))
    }

    fn below(&mut self, count: u64) -> u64 {
        let number = self.between(0.0, count as f64) as u64;
        number.min(count.saturating_sub(1))
    }
}

impl Rare for Envelope {
    fn dimensions(&self) -> usize {
        DICE + 1
    }

    fn severity(&self, normals: &[f64]) -> f64 {
        outcome::severity(&scenario(normals).0)
    }
}

/// Returns the scenario of normal numbers, and how many of them it has.
pub fn scenario(normals: &[f64]) -> (Scenario, usize) {
    let mut dice = Normals { all: normals.iter(), drawn: 0 };
    let noise = dice.below(NOISES);
    let scenario = dice::drawn(&mut dice, noise);
    (scenario, dice.drawn)
}
