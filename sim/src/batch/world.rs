//! The world of eight aircraft: the plant of [`crate::world`], with the formulas of [`crate::plant`], [`crate::motors`] and
//! [`crate::vehicle`], and the steps of the integrator.

use std::array::from_fn;

use bessemer_lanes::{LANES, Mask, Real};
use nalgebra::Vector3;

use crate::motors::{kept, turned};
use crate::plant::{Rigid, State};
use crate::scenario::Scenario;
use crate::vehicle::{Motor, Vehicle, loads};
use crate::world::{SUBSTEPS, tick};

/// The twelve states of each aircraft.
type States = [Real; 12];

/// Eight aircraft with their motors.
pub(super) struct World {
    states: States,
    speeds: [Real; 8],
    /// Share of a motor's difference from its command that is left after a step.
    kept: Real,
    body: Rigid<Real>,
    motors: Vec<[Real; 4]>,
    /// Length of a step, s.
    length: f64,
}

impl World {
    /// Creates the world of scenarios with these vehicles. Lanes without a scenario have the first one.
    pub fn new(scenarios: &[Scenario], vehicles: &[Vehicle], period: f64) -> Self {
        let length = tick(period / f64::from(SUBSTEPS)).seconds(1);
        let scenario = |lane: usize| scenarios.get(lane).unwrap_or(&scenarios[0]);
        let vehicle = |lane: usize| vehicles.get(lane).unwrap_or(&vehicles[0]);
        let real = |of: &dyn Fn(usize) -> f64| Real::new(from_fn(of));
        let starts: [[f64; 12]; LANES] = from_fn(|lane| scenario(lane).start.vector().data.0[0]);
        let numbers: [Vec<[f64; 4]>; LANES] =
            from_fn(|lane| vehicle(lane).motors.iter().map(Motor::numbers).collect());
        let inertia = from_fn(|axis| real(&|lane| vehicle(lane).inertia[axis]));
        let motor = |n: usize| from_fn(|number| real(&|lane| numbers[lane][n][number]));
        Self {
            states: from_fn(|n| real(&|lane| starts[lane][n])),
            speeds: [Real::of(0.0); 8],
            kept: real(&|lane| kept(length, scenario(lane).lag)),
            body: Rigid::new(real(&|lane| vehicle(lane).mass), inertia),
            motors: (0..numbers[0].len()).map(motor).collect(),
            length,
        }
    }

    /// Returns the state of each aircraft.
    pub fn states(&self) -> [State; LANES] {
        let numbers = self.states.map(Real::to_array);
        from_fn(|lane| {
            let part = |first: usize| Vector3::from_fn(|axis, _| numbers[first + axis][lane]);
            State { position: part(0), angles: part(3), velocity: part(6), rates: part(9) }
        })
    }

    /// Advances the aircraft by a period. Returns the speed at which each hit the ground, m/s; 0 if it did not.
    pub fn advance(&mut self, wanted: &[Real; 8], stopped: &[Mask; 8], wind: [Real; 3]) -> Real {
        let zero = Real::of(0.0);
        let goals: [Real; 8] = from_fn(|n| zero.or(stopped[n], wanted[n].abs()));
        let mut impact = zero;
        for _ in 0..SUBSTEPS {
            let squares: [Real; 8] = from_fn(|n| {
                let (speed, square) = turned(self.speeds[n], goals[n], self.kept);
                self.speeds[n] = speed;
                square
            });
            let (thrust, torque) = loads(self.motors.iter().copied().zip(squares));
            let [height, climb] = [self.states[2], self.states[8]];
            let aloft = height.gt(zero);
            let wind = wind.map(|force| force.or(aloft, zero));
            let next = self.stepped(thrust, torque, wind);
            let sound = next.iter().fold(Mask::ALL, |sound, it| sound & it.is_finite());
            let landed = aloft & sound & next[2].le(zero);
            impact = (-climb).or(landed, impact);
            self.states = floored(&next).map(|it| it.or(sound, Real::of(f64::NAN)));
        }
        impact
    }

    /// Returns the states after one step of the classical Runge–Kutta method, in the order of the kit's integrator.
    fn stepped(&self, thrust: Real, torque: [Real; 3], wind: [Real; 3]) -> States {
        let slope = |states: &States| self.body.slope(states, thrust, torque, wind);
        let ahead = |slope: &States, time: Real| -> States {
            from_fn(|n| self.states[n] + slope[n] * time)
        };
        let (half, whole) = (Real::of(0.5 * self.length), Real::of(self.length));
        let first = slope(&self.states);
        let second = slope(&ahead(&first, half));
        let third = slope(&ahead(&second, half));
        let fourth = slope(&ahead(&third, whole));
        let two = Real::of(2.0);
        let sum = from_fn(|n| first[n] + second[n] * two + third[n] * two + fourth[n]);
        ahead(&sum, Real::of(self.length / 6.0))
    }
}

/// Applies the floor, as [`State::above_floor`] does.
fn floored(states: &States) -> States {
    let zero = Real::of(0.0);
    let above = states[2].gt(zero) | states[8].gt(zero);
    from_fn(|n| match n {
        0 | 1 | 3 | 4 | 5 => states[n],
        _ => states[n].or(above, zero),
    })
}
