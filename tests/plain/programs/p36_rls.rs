//! Recursive least squares with a forgetting factor, and on top of it the
//! identification of a first-order plant.

use nalgebra::{RealField, SMatrix, SVector, Vector2};

/// What one update did.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Innovation<T> {
    /// Prediction error before the update.
    pub a_priori: T,
    /// Prediction error after it.
    pub a_posteriori: T,
}

/// Estimates `theta` in `y = phiᵀ theta` with `N` parameters.
#[derive(Clone, Debug)]
pub struct Rls<T, const N: usize> {
    theta: SVector<T, N>,
    p: SMatrix<T, N, N>,
    forgetting: T,
    max_trace: T,
}

impl<T: RealField + Copy, const N: usize> Rls<T, N> {
    /// `None` unless the forgetting factor is in (0, 1].
    pub fn new(forgetting: T, initial_covariance: T) -> Option<Self> {
        let valid = forgetting > T::zero() && forgetting <= T::one();
        valid.then(|| Self {
            theta: SVector::zeros(),
            p: SMatrix::from_diagonal_element(initial_covariance),
            forgetting,
            max_trace: initial_covariance * nalgebra::convert(10.0 * N as f64),
        })
    }

    pub fn with_initial(self, theta: SVector<T, N>) -> Self {
        Self { theta, ..self }
    }

    pub fn predict(&self, phi: &SVector<T, N>) -> T {
        phi.dot(&self.theta)
    }

    pub fn step(&mut self, phi: &SVector<T, N>, y: T) -> Innovation<T> {
        let p_phi = self.p * phi;
        let gain = p_phi / (self.forgetting + phi.dot(&p_phi));
        let a_priori = y - self.predict(phi);
        self.theta += gain * a_priori;

        let updated = self.p - gain * p_phi.transpose();
        // Without excitation the covariance would blow up: stop forgetting then.
        let inflated = updated / self.forgetting;
        self.p = if inflated.trace() < self.max_trace { inflated } else { updated };
        self.p.fill_lower_triangle_with_upper_triangle();

        Innovation { a_priori, a_posteriori: y - self.predict(phi) }
    }

    pub fn parameters(&self) -> &SVector<T, N> {
        &self.theta
    }

    pub fn uncertainty(&self) -> T {
        self.p.trace()
    }
}

/// Continuous-time first-order plant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FirstOrder {
    pub gain: f32,
    pub time_constant: f32,
}

/// Identifies `y⁺ = a y + b u` from the running loop.
#[derive(Clone, Debug)]
pub struct PlantIdentifier {
    rls: Rls<f32, 2>,
    dt: f32,
    previous: Option<Vector2<f32>>,
    samples: u32,
}

impl PlantIdentifier {
    const FORGETTING: f32 = 0.995;
    const MIN_SAMPLES: u32 = 20;

    pub fn new(dt: f32) -> Option<Self> {
        let rls = Rls::new(Self::FORGETTING, 100.0)?.with_initial(Vector2::new(0.5, 0.0));
        (dt > 0.0).then_some(Self { rls, dt, previous: None, samples: 0 })
    }

    /// Feeds the output and the input applied from now on.
    pub fn push(&mut self, y: f32, u: f32) -> Option<FirstOrder> {
        if !(y.is_finite() && u.is_finite()) {
            self.previous = None;
            return None;
        }
        let phi = self.previous.replace(Vector2::new(y, u))?;
        self.rls.step(&phi, y);
        self.samples = self.samples.saturating_add(1);
        self.plant()
    }

    /// The plant if the estimate is a stable, non-oscillating one.
    pub fn plant(&self) -> Option<FirstOrder> {
        let [a, b]: [f32; 2] = (*self.rls.parameters()).into();
        match a {
            _ if self.samples < Self::MIN_SAMPLES => None,
            a if a > 0.0 && a < 1.0 => {
                Some(FirstOrder { gain: b / (1.0 - a), time_constant: -self.dt / a.ln() })
            }
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn recovers_a_cubic() {
        let mut rls = Rls::<f64, 4>::new(1.0, 1e6).unwrap();
        let truth = SVector::from([1.0, -2.0, 0.5, 0.25]);
        for n in 0..50 {
            let x = n as f64 * 0.1 - 2.5;
            let phi = SVector::from([1.0, x, x * x, x * x * x]);
            rls.step(&phi, truth.dot(&phi));
        }
        assert!((rls.parameters() - truth).norm() < 1e-4);
        assert!(rls.uncertainty() < 1.0);
        assert!(Rls::<f64, 4>::new(1.5, 1.0).is_none());
    }

    #[test]
    fn identifies_a_plant_that_changes() {
        let dt = 0.1_f32;
        let mut id = PlantIdentifier::new(dt).unwrap();
        let mut y = 0.0;
        let mut found = None;
        for n in 0..4000_u32 {
            let (gain, tau) = if n < 1000 { (2.0, 0.5) } else { (3.0, 0.8) };
            let u = if n / 7 % 2 == 0 { 1.0 } else { -0.5 };
            found = id.push(y, u);
            let a = (-dt / tau as f32).exp();
            y = a * y + (1.0 - a) * gain * u;
        }
        let FirstOrder { gain, time_constant } = found.unwrap();
        assert!((gain - 3.0).abs() < 0.05 && (time_constant - 0.8).abs() < 0.02, "{found:?}");
    }

    #[test]
    fn covariance_stays_bounded_without_excitation() {
        let mut rls = Rls::<f32, 2>::new(0.9, 10.0).unwrap();
        let phi = Vector2::new(1.0, 0.0);
        for _ in 0..5000 {
            let e = rls.step(&phi, 1.0);
            assert!(e.a_posteriori.abs() <= e.a_priori.abs() + 1e-6);
        }
        assert!(rls.uncertainty() <= 200.0);
        assert!((rls.predict(&phi) - 1.0).abs() < 1e-4);
    }
}
