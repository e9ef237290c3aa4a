//! Quintic polynomials through waypoints: the smoothest motion from one state to another, for each axis separately.

use bessemer::prelude::*;

/// Position, velocity and acceleration of all axes.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct State {
    pub position: Vector3<f64>,
    pub velocity: Vector3<f64>,
    pub acceleration: Vector3<f64>,
}

/// The motion between two waypoints: a polynomial of the fifth degree for each axis.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Leg {
    coefficients: SMatrix<f64, 3, 6>,
    #[unit("s")]
    duration: f64,
}

#[data]
impl Leg {
    /// The motion between two states in `duration` seconds; `None` if that is too short.
    pub fn between(from: &State, to: &State, duration: f64) -> Option<Leg> {
        if duration < 1e-3 {
            return None;
        }
        let t = duration;
        let powers = Matrix3::new(
            t.powi(3), t.powi(4), t.powi(5),
            3.0 * t.powi(2), 4.0 * t.powi(3), 5.0 * t.powi(4),
            6.0 * t, 12.0 * t.powi(2), 20.0 * t.powi(3),
        );
        let inverse = powers.try_inverse()?;
        let mut coefficients = SMatrix::<f64, 3, 6>::zeros();
        coefficients.set_column(0, &from.position);
        coefficients.set_column(1, &from.velocity);
        coefficients.set_column(2, &(from.acceleration / 2.0));
        let reached = from.position + from.velocity * t + from.acceleration * (t * t / 2.0);
        let missing = Matrix3::from_columns(&[
            to.position - reached,
            to.velocity - (from.velocity + from.acceleration * t),
            to.acceleration - from.acceleration,
        ]);
        let rest = inverse * missing.transpose();
        for axis in 0..3 {
            for power in 0..3 {
                coefficients[(axis, power + 3)] = rest[(power, axis)];
            }
        }
        Some(Leg { coefficients, duration })
    }

    /// State at a time on the motion; constant before its start and after its end.
    pub fn at(&self, time: f64) -> State {
        let t = time.clamp(0.0, self.duration.max(0.0));
        let mut state = State::default();
        // Horner, for the polynomial and its derivatives at once.
        for power in (0..6).rev() {
            let column = self.coefficients.column(power).into_owned();
            state.acceleration = state.acceleration * t + state.velocity * 2.0;
            state.velocity = state.velocity * t + state.position;
            state.position = state.position * t + column;
        }
        state
    }
}

/// State at a time on a path through three waypoints.
#[function]
pub fn along(stops: &[State; 3], durations: &[f64; 2], time: f64) -> Option<State> {
    let mut left = time;
    let mut last = None;
    for (pair, &duration) in stops.windows(2).zip(durations) {
        let leg = Leg::between(&pair[0], &pair[1], duration)?;
        if left < duration {
            return Some(leg.at(left));
        }
        left -= duration;
        last = Some(leg.at(duration));
    }
    last
}
