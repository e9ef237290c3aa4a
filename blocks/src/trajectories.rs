//! Trajectories of one axis: three segments, S-curve, minimum jerk and minimum snap.
//!
//! A trajectory is planned once and evaluated at a time in s from its start. Before the start and after the end it is
//! at rest at its ends. Units are those of the position (U) and s. Results are defined for limits above 0.
//!
//! Source: Biagiotti and Melchiorri, *Trajectory Planning for Automatic Machines and Robots*, 2008, sections 2.1,
//! 3.2 and 3.4; Flash and Hogan, *The Coordination of Arm Movements*, 1985, for minimum jerk; Mellinger and
//! Kumar, *Minimum Snap Trajectory Generation*, ICRA 2011.

use bessemer::prelude::*;

/// State on a trajectory.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Point<T> {
    /// Position, U.
    pub position: T,
    /// Speed, U/s.
    pub speed: T,
    /// Acceleration, U/s².
    pub acceleration: T,
    /// Jerk, U/s³.
    pub jerk: T,
}

/// Trajectory of three segments from rest to rest: constant acceleration, constant speed, constant deceleration.
///
/// Saturation: a short distance does not reach the speed limit and has no middle segment.
///
/// ```
/// use bessemer_blocks::Trapezoid;
///
/// let trapezoid = Trapezoid::plan(6.0, 2.0, 1.0);
/// assert_eq!(trapezoid.duration(), 5.0);
/// assert_eq!((trapezoid.at(1.0).position, trapezoid.at(2.5).speed, trapezoid.at(9.0).position), (0.5, 2.0, 6.0));
/// ```
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Trapezoid<T> {
    /// Distance, with its sign, U.
    distance: T,
    /// Acceleration of the first segment, with its sign, U/s².
    acceleration: T,
    /// Duration of the first and of the last segment.
    #[unit("s")]
    ramp: T,
    /// Duration of the middle segment.
    #[unit("s")]
    cruise: T,
}

#[data]
impl<T: Real> Trapezoid<T> {
    /// Plans the fastest motion over a distance within the largest `speed` and `acceleration`.
    pub fn plan(distance: T, speed: T, acceleration: T) -> Self {
        let length = distance.abs();
        let highest = speed.min((length * acceleration).sqrt());
        let ramp = highest / acceleration;
        let cruise =
            if highest > T::ZERO { (length / highest - ramp).max(T::ZERO) } else { T::ZERO };
        Trapezoid { distance, acceleration: acceleration.copysign(distance), ramp, cruise }
    }

    /// Returns the duration, s.
    pub fn duration(&self) -> T {
        real::<T>(2.0) * self.ramp + self.cruise
    }

    /// Returns the state at a time.
    pub fn at(&self, #[unit("s")] time: T) -> Point<T> {
        let half = real::<T>(0.5);
        let left = self.duration() - time;
        let first = time < half * self.duration();
        // The second half is the first one from the end.
        let from = if first { time } else { left };
        if from <= T::ZERO || from.is_nan() {
            let position = if first { T::ZERO } else { self.distance };
            return Point { position, ..Point::default() };
        }
        let rising = from < self.ramp;
        let acceleration = if rising { self.acceleration } else { T::ZERO };
        let speed = self.acceleration * from.min(self.ramp);
        let beyond = (from - self.ramp).max(T::ZERO);
        let way = half * speed * from.min(self.ramp) + speed * beyond;
        Point {
            position: if first { way } else { self.distance - way },
            speed,
            acceleration: if first { acceleration } else { -acceleration },
            jerk: T::ZERO,
        }
    }
}

/// S-curve: seven segments from rest to rest with a limited jerk.
///
/// Saturation: a short distance reaches neither the speed limit nor, if it is shorter still, the acceleration's.
///
/// ```
/// use bessemer_blocks::SCurve;
///
/// let curve = SCurve::plan(10.0, 5.0, 10.0, 40.0);
/// assert_eq!((curve.duration(), curve.at(1.375).speed, curve.at(9.0).position), (2.75, 5.0, 10.0));
/// ```
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SCurve<T> {
    /// Distance, with its sign, U.
    distance: T,
    /// Jerk of the first segment, with its sign, U/s³.
    jerk: T,
    /// Duration of a segment with jerk.
    #[unit("s")]
    bend: T,
    /// Duration of the acceleration, its two bends included.
    #[unit("s")]
    ramp: T,
    /// Duration of the segment with constant speed.
    #[unit("s")]
    cruise: T,
}

#[data]
impl<T: Real> SCurve<T> {
    /// Plans the fastest motion over a distance within the largest `speed`, `acceleration` and `jerk`.
    pub fn plan(distance: T, speed: T, acceleration: T, jerk: T) -> Self {
        let (half, two) = (real::<T>(0.5), real::<T>(2.0));
        let length = distance.abs();
        let full = speed * jerk >= acceleration * acceleration;
        let mut bend = if full { acceleration / jerk } else { (speed / jerk).sqrt() };
        let mut ramp = if full { bend + speed / acceleration } else { two * bend };
        let mut cruise = length / speed - ramp;
        if cruise < T::ZERO {
            // The speed limit is not reached.
            cruise = T::ZERO;
            let short = two * acceleration * acceleration * acceleration / (jerk * jerk);
            if length >= short {
                bend = acceleration / jerk;
                ramp = half * bend + (half * half * bend * bend + length / acceleration).sqrt();
            } else {
                bend = (length / (two * jerk)).cbrt();
                ramp = two * bend;
            }
        }
        SCurve { distance, jerk: jerk.copysign(distance), bend, ramp, cruise }
    }

    /// Returns the duration, s.
    pub fn duration(&self) -> T {
        real::<T>(2.0) * self.ramp + self.cruise
    }

    /// Returns the state at a time.
    pub fn at(&self, #[unit("s")] time: T) -> Point<T> {
        let half = real::<T>(0.5);
        let left = self.duration() - time;
        let first = time < half * self.duration();
        // The second half is the first one from the end: position and acceleration with the other sign.
        let from = if first { time } else { left };
        if from <= T::ZERO || from.is_nan() {
            let position = if first { T::ZERO } else { self.distance };
            return Point { position, ..Point::default() };
        }
        let highest = self.jerk * self.bend * (self.ramp - self.bend);
        let sixth = self.jerk / real(6.0);
        let mut point = if from < self.bend {
            Point {
                position: sixth * from * from * from,
                speed: half * self.jerk * from * from,
                acceleration: self.jerk * from,
                jerk: self.jerk,
            }
        } else if from < self.ramp - self.bend {
            let acceleration = self.jerk * self.bend;
            let three = real::<T>(3.0);
            let way = three * from * from - three * self.bend * from + self.bend * self.bend;
            Point {
                position: acceleration / real(6.0) * way,
                speed: acceleration * (from - half * self.bend),
                acceleration,
                jerk: T::ZERO,
            }
        } else if from < self.ramp {
            let rest = self.ramp - from;
            Point {
                position: half * highest * self.ramp - highest * rest + sixth * rest * rest * rest,
                speed: highest - half * self.jerk * rest * rest,
                acceleration: self.jerk * rest,
                jerk: -self.jerk,
            }
        } else {
            let position = half * highest * self.ramp + highest * (from - self.ramp);
            Point { position, speed: highest, ..Point::default() }
        };
        if !first {
            point.position = self.distance - point.position;
            point.acceleration = -point.acceleration;
        }
        point
    }
}

/// Motion with minimum jerk between two states: the polynomial of fifth degree.
///
/// It has the smallest integral of the squared jerk of all motions between the two positions, speeds and accelerations.
/// The jerk of the ends is not used. Range: a duration above 0.
///
/// ```
/// use bessemer_blocks::{MinimumJerk, Point};
///
/// let end = Point { position: 2.0, ..Point::default() };
/// let motion = MinimumJerk::between(&Point::default(), &end, 4.0);
/// assert_eq!((motion.at(2.0).position, motion.at(2.0).speed, motion.at(5.0).position), (1.0, 0.9375, 2.0));
/// ```
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MinimumJerk<T> {
    /// Coefficients of the powers 0 to 5 of the time divided by the duration.
    coefficients: [T; 6],
    /// Duration.
    #[unit("s")]
    duration: T,
}

#[data]
impl<T: Real> MinimumJerk<T> {
    /// Plans the motion between two states in a duration.
    pub fn between(from: &Point<T>, to: &Point<T>, #[unit("s")] duration: T) -> Self {
        let (half, square) = (real::<T>(0.5), duration * duration);
        let (c0, c1, c2) =
            (from.position, from.speed * duration, half * from.acceleration * square);
        let position = to.position - c0 - c1 - c2;
        let speed = to.speed * duration - c1 - real::<T>(2.0) * c2;
        let bend = half * (to.acceleration * square - real::<T>(2.0) * c2);
        MinimumJerk {
            coefficients: [
                c0,
                c1,
                c2,
                real::<T>(10.0) * position - real::<T>(4.0) * speed + bend,
                real::<T>(-15.0) * position + real::<T>(7.0) * speed - real::<T>(2.0) * bend,
                real::<T>(6.0) * position - real::<T>(3.0) * speed + bend,
            ],
            duration,
        }
    }

    /// Returns the state at a time.
    pub fn at(&self, #[unit("s")] time: T) -> Point<T> {
        evaluated(&self.coefficients, self.duration, time)
    }
}

/// Motion with minimum snap between two states: the polynomial of seventh degree.
///
/// It has the smallest integral of the squared snap, the fourth derivative, of all motions between the two positions,
/// speeds, accelerations and jerks. Range: a duration above 0.
///
/// ```
/// use bessemer_blocks::{MinimumSnap, Point};
///
/// let end = Point { position: 2.0, ..Point::default() };
/// let motion = MinimumSnap::between(&Point::default(), &end, 4.0);
/// assert_eq!((motion.at(2.0).position, motion.at(2.0).speed, motion.at(5.0).position), (1.0, 1.09375, 2.0));
/// ```
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MinimumSnap<T> {
    /// Coefficients of the powers 0 to 7 of the time divided by the duration.
    coefficients: [T; 8],
    /// Duration.
    #[unit("s")]
    duration: T,
}

#[data]
impl<T: Real> MinimumSnap<T> {
    /// Plans the motion between two states in a duration.
    pub fn between(from: &Point<T>, to: &Point<T>, #[unit("s")] duration: T) -> Self {
        let (half, two, six) = (real::<T>(0.5), real::<T>(2.0), real::<T>(6.0));
        let square = duration * duration;
        let cube = square * duration;
        let c0 = from.position;
        let c1 = from.speed * duration;
        let c2 = half * from.acceleration * square;
        let c3 = from.jerk * cube / six;
        let position = to.position - c0 - c1 - c2 - c3;
        let speed = to.speed * duration - c1 - two * c2 - real::<T>(3.0) * c3;
        let bend = half * (to.acceleration * square - two * c2 - six * c3);
        let jerk = (to.jerk * cube - six * c3) / six;
        MinimumSnap {
            coefficients: [
                c0,
                c1,
                c2,
                c3,
                real::<T>(35.0) * position - real::<T>(15.0) * speed + real::<T>(5.0) * bend - jerk,
                real::<T>(-84.0) * position + real::<T>(39.0) * speed - real::<T>(14.0) * bend
                    + real::<T>(3.0) * jerk,
                real::<T>(70.0) * position - real::<T>(34.0) * speed + real::<T>(13.0) * bend
                    - real::<T>(3.0) * jerk,
                real::<T>(-20.0) * position + real::<T>(10.0) * speed - real::<T>(4.0) * bend
                    + jerk,
            ],
            duration,
        }
    }

    /// Returns the state at a time.
    pub fn at(&self, #[unit("s")] time: T) -> Point<T> {
        evaluated(&self.coefficients, self.duration, time)
    }
}

/// Returns the state on a polynomial of the time divided by the duration, by Horner's rule.
#[function]
fn evaluated<T: Real, const N: usize>(coefficients: &[T; N], duration: T, time: T) -> Point<T> {
    let at = (time / duration).max(T::ZERO).min(T::ONE);
    let (mut value, mut first, mut second, mut third) = (T::ZERO, T::ZERO, T::ZERO, T::ZERO);
    for coefficient in coefficients.iter().rev() {
        third = third * at + real::<T>(3.0) * second;
        second = second * at + real::<T>(2.0) * first;
        first = first * at + value;
        value = value * at + *coefficient;
    }
    let rate = T::ONE / duration;
    Point {
        position: value,
        speed: first * rate,
        acceleration: second * rate * rate,
        jerk: third * rate * rate * rate,
    }
}
