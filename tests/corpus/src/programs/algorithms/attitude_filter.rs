//! Attitude and gyro bias by a quaternion EKF with asynchronous sensors.
use bessemer::prelude::*;

type Covariance = SMatrix<f64, 6, 6>;

#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Measurement {
    Gyro(Vector3<f64>),
    Accelerometer(Vector3<f64>),
    Magnetometer { field: Vector3<f64>, trusted: bool },
}

#[component]
#[derive(Clone, Debug, PartialEq)]
pub struct Estimator {
    attitude: UnitQuaternion<f64>,
    bias: Vector3<f64>,
    p: Covariance,
    last: Option<f64>,
}

impl Default for Estimator {
    fn default() -> Self {
        Estimator {
            attitude: UnitQuaternion::identity(),
            bias: Vector3::zeros(),
            p: Covariance::identity() * 0.1,
            last: None,
        }
    }
}

#[function]
fn skew(v: &Vector3<f64>) -> Matrix3<f64> {
    v.cross_matrix()
}

#[component]
impl Estimator {
    const GYRO_NOISE: f64 = 1e-4;
    const BIAS_NOISE: f64 = 1e-8;

    #[entry]
    pub fn take(&mut self, time: f64, measurement: &Measurement) -> Option<UnitQuaternion<f64>> {
        match *measurement {
            Measurement::Gyro(rate) => {
                let dt = self.last.map(|last| time - last).filter(|dt| *dt > 0.0 && *dt < 0.1);
                self.last = Some(time);
                self.predict(&rate, dt?);
            }
            Measurement::Accelerometer(force) => {
                if (force.norm() - 9.81).abs() > 2.0 {
                    return None;
                }
                self.correct(&force.normalize(), &Vector3::z(), 0.01);
            }
            Measurement::Magnetometer { field, trusted: true } if field.norm() > 0.1 => {
                self.correct(&field.normalize(), &Vector3::x(), 0.05);
            }
            Measurement::Magnetometer { .. } => return None,
        }
        Some(self.attitude)
    }

    fn predict(&mut self, rate: &Vector3<f64>, dt: f64) {
        let w = rate - self.bias;
        self.attitude *= bessemer::rotation::from_scaled_axis(w * dt);
        let mut f = Covariance::identity();
        f.fixed_view_mut::<3, 3>(0, 0).copy_from(&(Matrix3::identity() - skew(&w) * dt));
        f.fixed_view_mut::<3, 3>(0, 3).copy_from(&(-Matrix3::identity() * dt));
        let mut q = Covariance::zeros();
        q.fixed_view_mut::<3, 3>(0, 0).fill_diagonal(Self::GYRO_NOISE * dt);
        q.fixed_view_mut::<3, 3>(3, 3).fill_diagonal(Self::BIAS_NOISE * dt);
        self.p = f * self.p * f.transpose() + q;
    }

    fn correct(&mut self, measured: &Vector3<f64>, reference: &Vector3<f64>, noise: f64) {
        let expected = self.attitude.inverse() * reference;
        let mut h = SMatrix::<f64, 3, 6>::zeros();
        h.fixed_columns_mut::<3>(0).copy_from(&skew(&expected));
        let s = h * self.p * h.transpose() + Matrix3::identity() * noise;
        let Some(inverse) = s.try_inverse() else { return };
        let k = self.p * h.transpose() * inverse;
        let dx = k * (measured - expected);
        let theta = dx.fixed_rows::<3>(0).into_owned();
        self.attitude *= bessemer::rotation::from_scaled_axis(theta);
        self.bias += dx.fixed_rows::<3>(3);
        self.p = (Covariance::identity() - k * h) * self.p;
        self.p = (self.p + self.p.transpose()) * 0.5;
    }
}
