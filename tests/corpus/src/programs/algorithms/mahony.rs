//! Mahony's complementary filter on the rotation group (Mahony, Hamel and Pflimlin 2008), passive form.

use bessemer::prelude::*;

/// Estimated rotation from the sensor's frame to the earth's, and the gyroscope's bias.
#[component]
#[derive(Clone, Debug, PartialEq)]
pub struct Mahony {
    rotation: Matrix3<f64>,
    bias: Vector3<f64>,
}

impl Default for Mahony {
    fn default() -> Self {
        Mahony { rotation: Matrix3::identity(), bias: Vector3::zeros() }
    }
}

#[component]
impl Mahony {
    /// Takes one sample: rates in rad/s, acceleration in any unit, `time` in s; returns the estimated down direction.
    #[entry(infallible)]
    pub fn step(&mut self, rate: &Vector3<f64>, force: &Vector3<f64>, time: f64) -> Vector3<f64> {
        let down = self.rotation.transpose() * Vector3::new(0.0, 0.0, 1.0);
        let size = force.norm();
        let error = if size > 0.0 { (force / size).cross(&down) } else { Vector3::zeros() };
        self.bias -= error * (0.1 * time);
        let omega = rate - self.bias + error;
        let skew = Matrix3::new(
            0.0, -omega.z, omega.y,
            omega.z, 0.0, -omega.x,
            -omega.y, omega.x, 0.0,
        );
        self.rotation += self.rotation * skew * time;
        self.orthogonalise();
        down
    }

    /// Makes the rows orthogonal and of length 1 again (Premerlani and Bizard 2009).
    fn orthogonalise(&mut self) {
        let first = Vector3::new(self.rotation[(0, 0)], self.rotation[(0, 1)], self.rotation[(0, 2)]);
        let second = Vector3::new(self.rotation[(1, 0)], self.rotation[(1, 1)], self.rotation[(1, 2)]);
        let half = first.dot(&second) * 0.5;
        let x = first - second * half;
        let y = second - first * half;
        let z = x.cross(&y);
        let rows = [x / x.norm(), y / y.norm(), z / z.norm()];
        for (i, row) in rows.iter().enumerate() {
            for j in 0..3 {
                self.rotation[(i, j)] = row[j];
            }
        }
    }
}
