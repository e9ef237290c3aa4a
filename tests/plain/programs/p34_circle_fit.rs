//! Circle fit by Gauss-Newton, started from the algebraic (Kåsa) solution; used
//! for finding posts in the laser scan.

use nalgebra::{Matrix3, Point2, Vector3};

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Circle {
    pub centre: Point2<f64>,
    pub radius: f64,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FitError {
    TooFewPoints(usize),
    /// Points on a line or all at one place.
    Degenerate,
    NotConverged { last_step: f64 },
}

/// Result with its quality.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fit {
    pub circle: Circle,
    pub rms: f64,
    pub iterations: usize,
    /// Covariance of centre and radius for the residual variance found.
    pub covariance: Matrix3<f64>,
}

impl Circle {
    /// Signed distance of a point from the circle, positive outside.
    pub fn distance(&self, p: &Point2<f64>) -> f64 {
        (p - self.centre).norm() - self.radius
    }

    /// Algebraic least squares: linear, biased to small circles on short arcs.
    pub fn kasa(points: &[Point2<f64>]) -> Result<Self, FitError> {
        if points.len() < 3 {
            return Err(FitError::TooFewPoints(points.len()));
        }
        let sum = points.iter().map(|p| p.coords).sum::<nalgebra::Vector2<f64>>();
        let mean = Point2::from(sum / points.len() as f64);
        let (mut m, mut v) = (Matrix3::zeros(), Vector3::zeros());
        for d in points.iter().map(|p| p - mean) {
            let row = Vector3::new(d.x, d.y, 1.0);
            m += row * row.transpose();
            v += row * d.norm_squared();
        }
        let spread = m[(0, 0)] + m[(1, 1)];
        let det = m.fixed_view::<2, 2>(0, 0).determinant();
        if det <= 1e-12 * spread * spread {
            return Err(FitError::Degenerate);
        }
        let s = m.lu().solve(&v).ok_or(FitError::Degenerate)?;
        let offset = s.xy() * 0.5;
        let radius_squared = s.z + offset.norm_squared();
        (radius_squared > 0.0)
            .then(|| Self { centre: mean + offset, radius: radius_squared.sqrt() })
            .ok_or(FitError::Degenerate)
    }
}

/// The fitter's settings.
#[derive(Clone, Copy, Debug)]
pub struct CircleFitter {
    pub max_iterations: usize,
    pub tolerance: f64,
    /// Distance at which a point's weight falls to half (Cauchy), if robust.
    pub robust_scale: Option<f64>,
}

impl Default for CircleFitter {
    fn default() -> Self {
        Self { max_iterations: 30, tolerance: 1e-10, robust_scale: None }
    }
}

impl CircleFitter {
    pub fn fit(&self, points: &[Point2<f64>]) -> Result<Fit, FitError> {
        let mut circle = Circle::kasa(points)?;
        let mut last_step = f64::INFINITY;
        for iterations in 1..=self.max_iterations {
            let (h, g) = self.normal_equations(&circle, points);
            let chol = h.cholesky().ok_or(FitError::Degenerate)?;
            let delta = -chol.solve(&g);
            circle.centre += delta.xy();
            circle.radius += delta.z;
            if !(circle.radius > 0.0) {
                return Err(FitError::Degenerate);
            }
            last_step = delta.norm();
            if last_step < self.tolerance * circle.radius {
                let squares: f64 = points.iter().map(|p| circle.distance(p).powi(2)).sum();
                let freedom = points.len().saturating_sub(3).max(1) as f64;
                return Ok(Fit {
                    circle,
                    rms: (squares / points.len() as f64).sqrt(),
                    iterations,
                    covariance: chol.inverse() * (squares / freedom),
                });
            }
        }
        Err(FitError::NotConverged { last_step })
    }

    fn normal_equations(&self, c: &Circle, points: &[Point2<f64>]) -> (Matrix3<f64>, Vector3<f64>) {
        points
            .iter()
            .filter_map(|p| {
                // A point in the very centre has no direction.
                let direction = (p - c.centre).try_normalize(1e-12)?;
                Some((Vector3::new(-direction.x, -direction.y, -1.0), c.distance(p)))
            })
            .fold((Matrix3::zeros(), Vector3::zeros()), |(h, g), (j, r)| {
                let w = self.robust_scale.map_or(1.0, |s| 1.0 / (1.0 + (r / s).powi(2)));
                (h + j * j.transpose() * w, g + j * (r * w))
            })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn arc<const N: usize>(span: f64, noise: f64) -> [Point2<f64>; N] {
        core::array::from_fn(|i| {
            let angle = 0.4 + span * i as f64 / N as f64;
            let r = 2.0 + noise * if i % 2 == 0 { 1.0 } else { -1.0 };
            Point2::new(3.0 + r * angle.cos(), -1.0 + r * angle.sin())
        })
    }

    #[test]
    fn exact_arc() {
        let fit = CircleFitter::default().fit(&arc::<12>(1.5, 0.0)).unwrap();
        assert!((fit.circle.centre - Point2::new(3.0, -1.0)).norm() < 1e-8);
        assert!((fit.circle.radius - 2.0).abs() < 1e-8 && fit.rms < 1e-8);
    }

    #[test]
    fn noise_and_an_outlier() {
        let mut points = arc::<40>(6.0, 0.01);
        let plain = CircleFitter::default().fit(&points).unwrap();
        assert!((plain.rms - 0.01).abs() < 1e-3);
        assert!(plain.covariance.diagonal().iter().all(|&v| v > 0.0 && v < 1e-4));
        points[7] = Point2::new(9.0, 9.0);
        let robust = CircleFitter { robust_scale: Some(0.05), max_iterations: 100, tolerance: 1e-8 };
        let fit = robust.fit(&points).unwrap();
        assert!((fit.circle.radius - 2.0).abs() < 0.02, "{:?}", fit.circle);
    }

    #[test]
    fn degenerate_input() {
        let line: [_; 5] = core::array::from_fn(|i| Point2::new(i as f64, 2.0 * i as f64));
        assert_eq!(CircleFitter::default().fit(&line), Err(FitError::Degenerate));
        assert_eq!(Circle::kasa(&line[..2]), Err(FitError::TooFewPoints(2)));
    }
}
