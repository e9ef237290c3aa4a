//! The thesis' particle swarm (eqs. (5.9)–(5.12)) for any cost.
//!
//! Random numbers are drawn before the costs are computed, so that the result does not depend on threads.

use crate::noise::{Purpose, Stream};
use rayon::prelude::*;

/// Parameters of a particle swarm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Swarm {
    /// Number of coefficients to find.
    pub dimensions: usize,
    /// Number of particles.
    pub particles: usize,
    /// Number of iterations.
    pub iterations: usize,
    /// Range of the initial positions.
    pub range: (f64, f64),
    /// Seed of all randomness.
    pub seed: u64,
}

impl Swarm {
    /// Returns the parameters of the thesis.
    pub fn thesis(dimensions: usize, seed: u64) -> Self {
        Self { dimensions, particles: 100, iterations: 40, range: (0.001, 0.1), seed }
    }

    /// Returns the number of evaluations of the cost.
    pub fn evaluations(&self) -> usize {
        self.particles * (self.iterations + 1)
    }
}

/// Result of a swarm.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// The best coefficients.
    pub best: Vec<f64>,
    /// Cost of the best coefficients.
    pub cost: f64,
    /// The best cost after each iteration, the first population included.
    pub history: Vec<f64>,
}

struct Particle {
    place: Vec<f64>,
    velocity: Vec<f64>,
    best: Vec<f64>,
    cost: f64,
}

/// Searches for the least cost; calls `told` after each iteration.
pub fn search(
    swarm: &Swarm,
    cost: impl Fn(&[f64]) -> f64 + Sync,
    mut told: impl FnMut(usize, f64),
) -> Found {
    let mut stream = Stream::new(swarm.seed, Purpose::Swarm);
    let mut particles: Vec<Particle> = (0..swarm.particles)
        .map(|_| {
            let (least, most) = swarm.range;
            let place: Vec<f64> =
                (0..swarm.dimensions).map(|_| stream.between(least, most)).collect();
            let velocity = vec![0.0; swarm.dimensions];
            Particle { best: place.clone(), place, velocity, cost: f64::INFINITY }
        })
        .collect();
    let mut found =
        Found { best: particles[0].place.clone(), cost: f64::INFINITY, history: vec![] };
    let mut inertia = 1.0;
    for iteration in 0..=swarm.iterations {
        let costs: Vec<f64> = particles.par_iter().map(|particle| cost(&particle.place)).collect();
        for (particle, cost) in particles.iter_mut().zip(costs) {
            if cost < particle.cost {
                particle.cost = cost;
                particle.best.clone_from(&particle.place);
            }
            if cost < found.cost {
                found.cost = cost;
                found.best.clone_from(&particle.place);
            }
        }
        found.history.push(found.cost);
        told(iteration, found.cost);
        for particle in &mut particles {
            let (own, other) = (stream.between(0.0, 1.0), stream.between(0.0, 1.0));
            for n in 0..swarm.dimensions {
                particle.velocity[n] = inertia * particle.velocity[n]
                    + own * (particle.best[n] - particle.place[n])
                    + other * (found.best[n] - particle.place[n]);
                // A propeller without thrust is none.
                particle.place[n] = (particle.place[n] + particle.velocity[n]).max(1e-6);
            }
        }
        inertia *= 0.98;
    }
    found
}
