//! Pure-pursuit steering along a polyline of waypoints.

use nalgebra::{ComplexField, Isometry2, Point2};

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Command {
    /// Signed curvature of the arc to drive, positive to the left.
    pub curvature: f32,
    pub speed: f32,
}

#[derive(Debug, Clone, Copy)]
pub struct Tuning {
    pub lookahead: f32,
    pub goal_tolerance: f32,
    pub max_speed: f32,
    pub max_lateral_accel: f32,
}

#[derive(Debug, Clone, Copy)]
struct Segment {
    start: Point2<f32>,
    end: Point2<f32>,
}

impl Segment {
    fn at(&self, t: f32) -> Point2<f32> {
        self.start + (self.end - self.start) * t
    }

    /// Parameter of the point next to `p`, within 0..=1.
    fn project(&self, p: &Point2<f32>) -> f32 {
        let along = self.end - self.start;
        ((p - self.start).dot(&along) / along.norm_squared()).clamp(0.0, 1.0)
    }

    /// Where the segment leaves a circle, if it does.
    fn leaves_circle(&self, centre: &Point2<f32>, radius: f32) -> Option<f32> {
        let along = self.end - self.start;
        let from_centre = self.start - centre;
        let a = along.norm_squared();
        let half_b = from_centre.dot(&along);
        let c = from_centre.norm_squared() - radius * radius;

        let root = (half_b * half_b - a * c).try_sqrt()?;
        let t = (root - half_b) / a;
        (0.0..=1.0).contains(&t).then_some(t)
    }
}

/// Follows a borrowed path; remembers how far it has come so that crossing
/// paths do not confuse it.
#[derive(Debug, Clone)]
pub struct PathFollower<'p> {
    waypoints: &'p [Point2<f32>],
    tuning: Tuning,
    progress: usize,
}

impl<'p> PathFollower<'p> {
    /// Segments ahead that are considered when searching the nearest one.
    const SEARCH_AHEAD: usize = 3;

    /// Needs at least two waypoints, neighbours must not coincide.
    pub fn new(waypoints: &'p [Point2<f32>], tuning: Tuning) -> Option<Self> {
        let usable = waypoints.len() >= 2 && waypoints.windows(2).all(|w| w[0] != w[1]);
        usable.then_some(Self { waypoints, tuning, progress: 0 })
    }

    pub fn progress(&self) -> usize {
        self.progress
    }

    fn remaining_segments(&self) -> impl Iterator<Item = (usize, Segment)> + 'p {
        self.waypoints
            .windows(2)
            .map(|w| Segment { start: w[0], end: w[1] })
            .enumerate()
            .skip(self.progress)
    }

    fn goal(&self) -> Point2<f32> {
        self.waypoints[self.waypoints.len() - 1]
    }

    /// Returns `None` on arrival.
    pub fn update(&mut self, pose: &Isometry2<f32>) -> Option<Command> {
        let position = Point2::from(pose.translation.vector);
        self.advance(&position);

        let on_last = self.progress + 2 == self.waypoints.len();
        if on_last && nalgebra::distance(&position, &self.goal()) < self.tuning.goal_tolerance {
            return None;
        }
        let target = self.lookahead_point(&position);
        Some(self.steer_to(&pose.inverse_transform_point(&target)))
    }

    fn advance(&mut self, position: &Point2<f32>) {
        let nearest = self
            .remaining_segments()
            .take(Self::SEARCH_AHEAD)
            .map(|(i, s)| (i, nalgebra::distance_squared(position, &s.at(s.project(position)))))
            .min_by(|a, b| a.1.total_cmp(&b.1));
        if let Some((index, _)) = nearest {
            self.progress = index;
        }
    }

    fn lookahead_point(&self, position: &Point2<f32>) -> Point2<f32> {
        let radius = self.tuning.lookahead;
        let leaving = self
            .remaining_segments()
            .find_map(|(_, s)| s.leaves_circle(position, radius).map(|t| s.at(t)));

        leaving.unwrap_or_else(|| {
            if nalgebra::distance(position, &self.goal()) <= radius {
                return self.goal();
            }
            // Too far off the path: head for its nearest point.
            self.remaining_segments().next().map_or(self.goal(), |(_, s)| s.at(s.project(position)))
        })
    }

    /// `target` is given in the frame of the vehicle.
    fn steer_to(&self, target: &Point2<f32>) -> Command {
        let curvature = 2.0 * target.y / target.coords.norm_squared().max(1e-6);
        let cornering = (self.tuning.max_lateral_accel / curvature.abs().max(1e-6)).sqrt();
        Command { curvature, speed: cornering.min(self.tuning.max_speed) }
    }
}
