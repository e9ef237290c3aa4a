//! Magnetometer calibration: fits an axis-aligned ellipsoid to raw readings
//! with recursively accumulated normal equations, so no samples are stored.

use nalgebra::{ComplexField, Matrix6, Vector3, Vector6};

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FitError {
    TooFewSamples,
    /// The readings do not cover enough directions.
    Singular,
    /// The best quadric is no ellipsoid.
    NotAnEllipsoid,
}

/// Hard-iron offset and diagonal soft-iron scale.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Calibration {
    pub offset: Vector3<f32>,
    pub scale: Vector3<f32>,
}

impl Calibration {
    /// Maps a raw reading onto the unit sphere.
    pub fn apply(&self, raw: &Vector3<f32>) -> Vector3<f32> {
        (raw - self.offset).component_mul(&self.scale)
    }

    /// Root mean square deviation from unit length.
    pub fn residual<'a>(&self, samples: impl IntoIterator<Item = &'a Vector3<f32>>) -> f32 {
        let (sum, count) = samples
            .into_iter()
            .map(|raw| self.apply(raw).norm() - 1.0)
            .fold((0.0, 0u32), |(sum, count), e| (sum + e * e, count + 1));
        if count == 0 { 0.0 } else { (sum / count as f32).sqrt() }
    }
}

impl Default for Calibration {
    fn default() -> Self {
        Self { offset: Vector3::zeros(), scale: Vector3::repeat(1.0) }
    }
}

/// Accumulates a x² + b y² + c z² + d x + e y + f z = 1.
#[derive(Debug, Clone)]
pub struct EllipsoidFit {
    information: Matrix6<f64>,
    moment: Vector6<f64>,
    count: u32,
    /// Typical field strength in raw units, conditions the problem.
    unit: f64,
}

impl EllipsoidFit {
    pub const MIN_SAMPLES: u32 = 12;

    pub fn new(typical_field: f32) -> Self {
        Self {
            information: Matrix6::zeros(),
            moment: Vector6::zeros(),
            count: 0,
            unit: f64::from(typical_field),
        }
    }

    pub fn count(&self) -> u32 {
        self.count
    }

    pub fn add(&mut self, raw: &Vector3<f32>) {
        let p = raw.cast::<f64>() / self.unit;
        let regressor = Vector6::new(p.x * p.x, p.y * p.y, p.z * p.z, p.x, p.y, p.z);
        self.information.syger(1.0, &regressor, &regressor, 1.0);
        self.moment += regressor;
        self.count += 1;
    }

    pub fn solve(&self) -> Result<Calibration, FitError> {
        if self.count < Self::MIN_SAMPLES {
            return Err(FitError::TooFewSamples);
        }
        let solution = self.information.cholesky().ok_or(FitError::Singular)?.solve(&self.moment);
        let quadratic: Vector3<f64> = solution.fixed_rows::<3>(0).into_owned();
        let linear: Vector3<f64> = solution.fixed_rows::<3>(3).into_owned();

        if quadratic.min() <= 0.0 {
            return Err(FitError::NotAnEllipsoid);
        }
        // Completing the squares yields Σ q (x - x0)² = 1 + Σ q x0².
        let centre = -0.5 * linear.component_div(&quadratic);
        let level = 1.0 + quadratic.dot(&centre.component_mul(&centre));
        let scale = quadratic.map(|q| (q / level).sqrt());

        Ok(Calibration { offset: (centre * self.unit).cast(), scale: (scale / self.unit).cast() })
    }
}

impl<'a> Extend<&'a Vector3<f32>> for EllipsoidFit {
    fn extend<I: IntoIterator<Item = &'a Vector3<f32>>>(&mut self, samples: I) {
        samples.into_iter().for_each(|sample| self.add(sample));
    }
}
