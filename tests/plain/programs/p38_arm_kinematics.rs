//! Kinematics of arms: closed-form inverse for two planar links, forward
//! kinematics and Jacobian by Denavit-Hartenberg matrices for any chain.

use nalgebra::{Isometry3, Matrix4, Point2, Point3, SMatrix, SVector, Vector3, Vector6};

/// Which way the elbow bends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Elbow {
    Up,
    Down,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum IkError {
    TooFar { by: f64 },
    TooNear { by: f64 },
    JointLimit { joint: usize },
}

/// Planar arm with two links.
#[derive(Clone, Copy, Debug)]
pub struct TwoLink {
    pub lengths: [f64; 2],
    /// Permitted angles of each joint.
    pub limits: [(f64, f64); 2],
}

impl TwoLink {
    pub const fn new(l1: f64, l2: f64) -> Self {
        use core::f64::consts::PI;
        Self { lengths: [l1, l2], limits: [(-PI, PI); 2] }
    }

    pub fn forward(&self, [q1, q2]: [f64; 2]) -> Point2<f64> {
        let [l1, l2] = self.lengths;
        Point2::new(l1 * q1.cos() + l2 * (q1 + q2).cos(), l1 * q1.sin() + l2 * (q1 + q2).sin())
    }

    /// Joint angles that bring the tip to `target`.
    pub fn inverse(&self, target: &Point2<f64>, elbow: Elbow) -> Result<[f64; 2], IkError> {
        let [l1, l2] = self.lengths;
        let distance = target.coords.norm();
        let (near, far) = ((l1 - l2).abs(), l1 + l2);
        match distance {
            d if d > far => return Err(IkError::TooFar { by: d - far }),
            d if d < near => return Err(IkError::TooNear { by: near - d }),
            _ => {}
        }
        let cos2 = (distance * distance - l1 * l1 - l2 * l2) / (2.0 * l1 * l2);
        let bend = cos2.clamp(-1.0, 1.0).acos();
        let q2 = match elbow {
            Elbow::Up => -bend,
            Elbow::Down => bend,
        };
        let q1 = target.y.atan2(target.x) - (l2 * q2.sin()).atan2(l1 + l2 * q2.cos());
        let angles = [q1, q2].map(wrap);
        match angles.iter().zip(&self.limits).position(|(q, (lo, hi))| !(lo..=hi).contains(&q)) {
            Some(joint) => Err(IkError::JointLimit { joint }),
            None => Ok(angles),
        }
    }

    /// The first elbow that works, tried in the order of preference.
    pub fn inverse_any(&self, target: &Point2<f64>, preferred: Elbow) -> Result<[f64; 2], IkError> {
        let other = if preferred == Elbow::Up { Elbow::Down } else { Elbow::Up };
        self.inverse(target, preferred).or_else(|e| self.inverse(target, other).map_err(|_| e))
    }
}

fn wrap(angle: f64) -> f64 {
    use core::f64::consts::{PI, TAU};
    (angle + PI).rem_euclid(TAU) - PI
}

/// One row of a Denavit-Hartenberg table (classic convention, revolute joint).
#[derive(Clone, Copy, Debug, Default)]
pub struct DhRow {
    pub a: f64,
    pub alpha: f64,
    pub d: f64,
    pub offset: f64,
}

impl DhRow {
    pub fn matrix(&self, q: f64) -> Matrix4<f64> {
        let (st, ct) = (q + self.offset).sin_cos();
        let (sa, ca) = self.alpha.sin_cos();
        #[rustfmt::skip]
        let m = Matrix4::new(
            ct, -st * ca,  st * sa, self.a * ct,
            st,  ct * ca, -ct * sa, self.a * st,
            0.0,      sa,       ca, self.d,
            0.0,     0.0,      0.0, 1.0,
        );
        m
    }
}

/// Serial arm with `N` revolute joints.
#[derive(Clone, Debug)]
pub struct Chain<const N: usize> {
    pub rows: [DhRow; N],
}

impl<const N: usize> Chain<N> {
    pub const fn new(rows: [DhRow; N]) -> Self {
        Self { rows }
    }

    /// Frames of all links, base excluded.
    pub fn frames<'a>(&'a self, q: &'a SVector<f64, N>) -> impl Iterator<Item = Matrix4<f64>> + 'a {
        self.rows.iter().zip(q.iter()).scan(Matrix4::identity(), |pose, (row, &angle)| {
            *pose *= row.matrix(angle);
            Some(*pose)
        })
    }

    pub fn forward(&self, q: &SVector<f64, N>) -> Matrix4<f64> {
        self.frames(q).last().unwrap_or_else(Matrix4::identity)
    }

    pub fn tip(&self, q: &SVector<f64, N>) -> Point3<f64> {
        self.forward(q).transform_point(&Point3::origin())
    }

    /// The tip's pose as an isometry.
    pub fn pose(&self, q: &SVector<f64, N>) -> Option<Isometry3<f64>> {
        nalgebra::try_convert(self.forward(q))
    }

    /// Geometric Jacobian: linear velocity in the upper rows, angular below.
    pub fn jacobian(&self, q: &SVector<f64, N>) -> SMatrix<f64, 6, N> {
        let tip = self.tip(q).coords;
        let mut j = SMatrix::<f64, 6, N>::zeros();
        let bases = core::iter::once(Matrix4::identity()).chain(self.frames(q));
        for (mut column, base) in j.column_iter_mut().zip(bases) {
            let axis: Vector3<f64> = base.fixed_view::<3, 1>(0, 2).into_owned();
            let origin = base.fixed_view::<3, 1>(0, 3);
            let linear = axis.cross(&(tip - origin));
            column.copy_from(&Vector6::from_iterator(linear.iter().chain(axis.iter()).copied()));
        }
        j
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use core::f64::consts::FRAC_PI_2;

    #[test]
    fn inverse_undoes_forward() {
        let arm = TwoLink::new(0.4, 0.3);
        for (x, y) in [(0.5, 0.2), (-0.3, 0.4), (0.1, -0.35), (0.0, 0.7)] {
            let target = Point2::new(x, y);
            for elbow in [Elbow::Up, Elbow::Down] {
                let q = arm.inverse(&target, elbow).unwrap();
                assert!((arm.forward(q) - target).norm() < 1e-9, "{q:?}");
            }
        }
    }

    #[test]
    fn unreachable_targets() {
        let arm = TwoLink { limits: [(-3.0, 3.0), (0.0, 2.5)], ..TwoLink::new(0.4, 0.3) };
        let far = arm.inverse(&Point2::new(0.8, 0.0), Elbow::Up);
        assert!(matches!(far, Err(IkError::TooFar { by }) if (by - 0.1).abs() < 1e-9));
        assert!(matches!(arm.inverse(&Point2::origin(), Elbow::Up), Err(IkError::TooNear { .. })));
        let p = Point2::new(0.5, 0.1);
        assert_eq!(arm.inverse(&p, Elbow::Up), Err(IkError::JointLimit { joint: 1 }));
        assert!(arm.inverse_any(&p, Elbow::Up).is_ok_and(|[_, q2]| q2 > 0.0));
    }

    #[test]
    fn dh_agrees_with_planar_and_jacobian_with_differences() {
        let link = |a| DhRow { a, ..DhRow::default() };
        let planar = Chain::new([link(0.4), link(0.3)]);
        let q = SVector::from([0.3, 0.9]);
        let expected = TwoLink::new(0.4, 0.3).forward(q.into());
        assert!((planar.tip(&q).xy() - expected).norm() < 1e-12);

        let shoulder = DhRow { alpha: FRAC_PI_2, d: 0.2, ..DhRow::default() };
        let arm = Chain::new([shoulder, link(0.4), link(0.3)]);
        let q = Vector3::new(0.2, -0.5, 1.1);
        let j = arm.jacobian(&q);
        for (i, column) in j.column_iter().enumerate() {
            let moved = q + Vector3::ith(i, 1e-6);
            let numeric = (arm.tip(&moved) - arm.tip(&q)) * 1e6;
            assert!((numeric - column.fixed_rows::<3>(0)).norm() < 1e-5);
        }
        let pose = arm.pose(&q).unwrap();
        assert!((pose.translation.vector - arm.tip(&q).coords).norm() < 1e-12);
    }
}
