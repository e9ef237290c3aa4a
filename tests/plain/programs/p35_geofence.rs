//! Geofence of keep-in and keep-out zones: point in polygon, distance to the
//! nearest edge, and a monitor with hysteresis.

use nalgebra::{Point2, Vector2};

/// Local east and north in metres.
pub type Local = Point2<f32>;

/// A closed area in the plane.
pub trait Zone {
    fn contains(&self, p: &Local) -> bool;

    /// Distance to the boundary, never negative.
    fn boundary_distance(&self, p: &Local) -> f32;

    /// Positive inside, negative outside.
    fn depth(&self, p: &Local) -> f32 {
        let d = self.boundary_distance(p);
        if self.contains(p) { d } else { -d }
    }
}

/// Simple polygon, closed implicitly; either orientation.
#[derive(Clone, Copy, Debug)]
pub struct Polygon<'a> {
    corners: &'a [Local],
}

impl<'a> Polygon<'a> {
    pub fn new(corners: &'a [Local]) -> Option<Self> {
        let polygon = Self { corners };
        (corners.len() >= 3 && polygon.area() > f32::EPSILON).then_some(polygon)
    }

    fn edges(&self) -> impl Iterator<Item = (&'a Local, &'a Local)> + use<'a> {
        let next = self.corners.iter().cycle().skip(1);
        self.corners.iter().zip(next)
    }

    /// Shoelace formula.
    pub fn area(&self) -> f32 {
        let twice: f32 = self.edges().map(|(a, b)| a.coords.perp(&b.coords)).sum();
        0.5 * twice.abs()
    }
}

impl Zone for Polygon<'_> {
    fn contains(&self, p: &Local) -> bool {
        self.edges()
            .filter(|(a, b)| (a.y > p.y) != (b.y > p.y))
            .filter(|(a, b)| p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x))
            .count()
            % 2
            == 1
    }

    fn boundary_distance(&self, p: &Local) -> f32 {
        self.edges()
            .map(|(a, b)| {
                let (along, to_p) = (b - a, p - a);
                let length_squared = along.norm_squared().max(f32::MIN_POSITIVE);
                let t = (to_p.dot(&along) / length_squared).clamp(0.0, 1.0);
                (to_p - along * t).norm()
            })
            .fold(f32::INFINITY, f32::min)
    }
}

#[derive(Clone, Copy, Debug)]
pub struct Disc {
    pub centre: Local,
    pub radius: f32,
}

impl Zone for Disc {
    fn contains(&self, p: &Local) -> bool {
        nalgebra::distance_squared(p, &self.centre) <= self.radius * self.radius
    }

    fn boundary_distance(&self, p: &Local) -> f32 {
        (nalgebra::distance(p, &self.centre) - self.radius).abs()
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    Clear,
    /// Within the warning margin or not yet out of the hysteresis.
    Warning,
    Breach,
}

/// Monitor over one keep-in zone and some keep-out zones.
#[derive(Clone, Debug)]
pub struct Geofence<'a> {
    keep_in: Polygon<'a>,
    keep_out: &'a [Disc],
    margin: f32,
    status: Status,
}

impl<'a> Geofence<'a> {
    const LOOKAHEAD_S: f32 = 2.0;
    /// Extra depth wanted before a warning is taken back.
    const HYSTERESIS: f32 = 1.5;

    pub fn new(keep_in: Polygon<'a>, keep_out: &'a [Disc], margin: f32) -> Self {
        Self { keep_in, keep_out, margin, status: Status::Clear }
    }

    /// Room to the nearest limit; negative when in breach.
    pub fn clearance(&self, p: &Local) -> f32 {
        self.keep_out
            .iter()
            .map(|disc| -disc.depth(p))
            .fold(self.keep_in.depth(p), f32::min)
    }

    pub fn step(&mut self, position: &Local, velocity: &Vector2<f32>) -> Status {
        let now = self.clearance(position);
        let soon = self.clearance(&(position + velocity * Self::LOOKAHEAD_S));
        self.status = match self.status {
            _ if now < 0.0 => Status::Breach,
            _ if now.min(soon) < self.margin => Status::Warning,
            Status::Clear => Status::Clear,
            Status::Warning | Status::Breach if now < self.margin + Self::HYSTERESIS => {
                Status::Warning
            }
            Status::Warning | Status::Breach => Status::Clear,
        };
        self.status
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An L: 100 × 100 without its upper right quarter.
    const L_SHAPE: [Local; 6] = [
        Point2::new(0.0, 0.0),
        Point2::new(100.0, 0.0),
        Point2::new(100.0, 50.0),
        Point2::new(50.0, 50.0),
        Point2::new(50.0, 100.0),
        Point2::new(0.0, 100.0),
    ];

    #[test]
    fn point_in_an_l() {
        let l = Polygon::new(&L_SHAPE).unwrap();
        assert_eq!(l.area(), 7500.0);
        assert!(l.contains(&Point2::new(20.0, 80.0)));
        assert!(!l.contains(&Point2::new(80.0, 80.0)));
        assert!((l.depth(&Point2::new(80.0, 80.0)) + 30.0).abs() < 1e-4);
        assert!((l.depth(&Point2::new(90.0, 25.0)) - 10.0).abs() < 1e-4);
        assert!(Polygon::new(&L_SHAPE[..2]).is_none());
    }

    #[test]
    fn monitor_warns_ahead_and_lets_go_late() {
        let l = Polygon::new(&L_SHAPE).unwrap();
        let towers = [Disc { centre: Point2::new(25.0, 25.0), radius: 5.0 }];
        let mut fence = Geofence::new(l, &towers, 3.0);
        let still = Vector2::zeros();
        assert_eq!(fence.step(&Point2::new(75.0, 25.0), &still), Status::Clear);
        assert_eq!(fence.step(&Point2::new(75.0, 25.0), &Vector2::new(12.0, 0.0)), Status::Warning);
        assert_eq!(fence.step(&Point2::new(25.0, 27.0), &still), Status::Breach);
        assert_eq!(fence.step(&Point2::new(25.0, 34.0), &still), Status::Warning);
        assert_eq!(fence.step(&Point2::new(25.0, 35.0), &still), Status::Clear);
    }
}
