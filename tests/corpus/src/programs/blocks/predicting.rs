//! A predictive control within the limits of force and speed, and a filter of commands within a cone.

pub use bessemer_blocks::{ActiveSet, ActiveSetProgram, Admm, AdmmProgram, Minimum, Outcome};
use bessemer::prelude::*;

include!("predicted.in");

/// The constant part of the program: eight forces, and eight speeds that they cause.
const PROGRAM: ActiveSetProgram<f64, 8, 16> =
    ActiveSetProgram { inverse: INVERSE, rows: ROWS, tolerance: 1e-6 };

/// Drives a cart to a position, with at most 3 N and 0.5 m/s.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Carriage {
    solver: ActiveSet<f64, 8, 16, 12>,
}

#[component]
impl Carriage {
    /// Advances one period of 100 ms; returns the force, N, and 0 if no force keeps the limits.
    #[entry(infallible)]
    pub fn step(&mut self, #[unit("m")] distance: f64, #[unit("m/s")] speed: f64) -> f64 {
        let state = Vector2::new(distance, speed);
        let mut most = SVector::<f64, 16>::repeat(0.5);
        for k in 0..8 {
            most[k] = 3.0;
        }
        let caused = OFFSET * state;
        let found = self.solver.step(&PROGRAM, &(GRADIENT * state), &(-most - caused), &(most - caused));
        match found.outcome {
            Outcome::Infeasible => 0.0,
            _ => found.point[0],
        }
    }
}

/// Replaces wanted forces by the nearest ones that a vehicle's contact can bear.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Footing {
    solver: Admm<f32, 3, 4, 1, 3, 25>,
    /// Number of commands without a solution.
    lost: u32,
}

#[component]
impl Footing {
    /// Returns forces at most 0.6 times as far sideways as down, N.
    #[entry(infallible)]
    pub fn filter(&mut self, #[unit("N")] wanted: &Vector3<f32>, #[unit("N")] most: f32) -> Vector3<f32> {
        // The force down; then a cone of 0.6 times that, and of the forces sideways.
        let rows = Matrix4x3::new(0.0, 0.0, 1.0, 0.0, 0.0, 0.6, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0);
        let program = AdmmProgram::new(&Matrix3::identity(), &rows, &Vector4::repeat(2.0), 1e-4);
        let Some(program) = program else {
            return Vector3::zeros();
        };
        let high = Vector4::repeat(most);
        let found = self.solver.step(&program, &-wanted, &Vector4::zeros(), &high);
        if found.outcome == Outcome::Infeasible {
            self.lost = self.lost.saturating_add(1);
        }
        found.point
    }
}
