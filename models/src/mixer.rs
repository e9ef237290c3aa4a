//! The contribution of each motor to thrust and torques (thesis, eqs. (3.9), (3.10)), on top of what the
//! feed-forward has them do already.
//!
//! If the motors cannot produce everything requested, roll and pitch have priority over yaw, and yaw over height: an
//! aircraft that keeps its attitude remains controllable.

use crate::airframe::{Airframe, MAX_MOTORS, Wrench};
use crate::signals::Command;
use bessemer::prelude::*;

/// Conversion of thrust and torques to motor commands.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Mixer {
    /// Squares of the motor speeds (rows) per thrust and torque about the body's x, y and z (columns), rad²/s² per N
    /// and per N·m.
    pub allocation: SMatrix<f64, MAX_MOTORS, 4>,
    /// Thrust and torque about the body's x, y and z (rows) per square of the motor speeds (columns), N·s²/rad² and
    /// N·m·s²/rad². A positive torque turns x towards y, y towards z, z towards x.
    pub effectiveness: SMatrix<f64, 4, MAX_MOTORS>,
    /// Direction of rotation of each motor, 1 or −1; 0 for a missing motor.
    pub spins: SVector<f64, MAX_MOTORS>,
    /// Square of a motor's speed per unit of its command, rad²/s².
    pub square_per_command: f64,
    /// Largest command that a motor takes.
    pub largest_command: f64,
}

#[data]
impl Mixer {
    /// Returns the mixer of an airframe whose motors accept commands up to `largest_command`.
    pub fn new(airframe: &Airframe, square_per_command: f64, largest_command: f64) -> Mixer {
        let allocation = airframe.allocation();
        let effectiveness = airframe.effectiveness();
        Mixer {
            allocation,
            effectiveness,
            spins: airframe.spins(),
            square_per_command,
            largest_command,
        }
    }

    /// Returns the motor commands that add a wrench to `feed_forward`, a speed for each motor, rad/s.
    ///
    /// The thrust becomes a speed that is added to the feed-forward's, as the thesis has it. The torques
    /// are added to the square of the sum: added as speeds they would act 1/(1 − gain) times as strongly
    /// under feed-forward, which at a gain of 0.8 no attitude loop survives.
    #[requirement("HLR-11", "HLR-12", "HLR-13")]
    pub fn mix(&self, wanted: &Wrench, feed_forward: &SVector<f64, MAX_MOTORS>) -> Command {
        let torque = wanted.torque;
        let mut lift = SVector::zeros();
        let mut tilt = SVector::zeros();
        let mut twist = SVector::zeros();
        for n in 0..MAX_MOTORS {
            let own = (self.allocation[(n, 0)] * wanted.thrust).max(0.0).sqrt();
            let speed = own + feed_forward[n];
            lift[n] = speed * speed;
            tilt[n] = self.allocation[(n, 1)] * torque.x + self.allocation[(n, 2)] * torque.y;
            twist[n] = self.allocation[(n, 3)] * torque.z;
        }

        let largest = self.largest_command * self.square_per_command;
        let squares = self.fit(&lift, &tilt, &twist, largest);

        let mut command = Command::still();
        for n in 0..MAX_MOTORS {
            let square = squares[n].max(0.0).min(largest);
            let speed = square.sqrt();
            command.motors[n] = square / self.square_per_command;
            command.speeds[n] = self.spins[n] * speed;
            command.closed_loop[n] = self.spins[n] * (speed - feed_forward[n]);
            command.feed_forward[n] = self.spins[n] * feed_forward[n];
        }
        command
    }

    /// Returns the wrench at the commanded motor speeds.
    pub fn wrench(&self, command: &Command) -> Wrench {
        let squares = command.speeds.component_mul(&command.speeds);
        let done = self.effectiveness * squares;
        Wrench { thrust: done[0], torque: Vector3::new(done[1], done[2], done[3]) }
    }

    /// Returns the squares of the motor speeds, limited to 0 … `largest`. The tilt has priority over the twist, and the
    /// twist over the lift.
    #[requirement("HLR-12", "HLR-13")]
    fn fit(
        &self,
        lift: &SVector<f64, MAX_MOTORS>,
        tilt: &SVector<f64, MAX_MOTORS>,
        twist: &SVector<f64, MAX_MOTORS>,
        largest: f64,
    ) -> SVector<f64, MAX_MOTORS> {
        let kept = tilt * share(&SVector::zeros(), tilt, largest);
        let turn = kept + twist * share(&kept, twist, largest);

        // Change of the lift that keeps every motor within its limits.
        let wanted = lift + turn;
        let mut least = largest;
        let mut most = 0.0;
        for n in 0..MAX_MOTORS {
            if self.spins[n] != 0.0 {
                least = wanted[n].min(least);
                most = wanted[n].max(most);
            }
        }
        let shift = (-least).max(0.0) - (most - largest).max(0.0);

        let mut squares = SVector::zeros();
        for n in 0..MAX_MOTORS {
            if self.spins[n] != 0.0 {
                squares[n] = wanted[n] + shift;
            }
        }
        squares
    }
}

/// Returns the largest fraction, 0 to 1, of `more` that can be added to `base` while any two motors differ by at most
/// `largest`.
#[requirement("HLR-13")]
#[function]
fn share(base: &SVector<f64, MAX_MOTORS>, more: &SVector<f64, MAX_MOTORS>, largest: f64) -> f64 {
    let mut share = 1.0;
    for i in 0..MAX_MOTORS {
        for j in 0..i {
            // The order of the two motors is the one with a positive difference.
            let mut difference = more[i] - more[j];
            let mut distance = base[i] - base[j];
            if difference < 0.0 {
                difference = -difference;
                distance = -distance;
            }
            // Rounding alone may bring two motors beyond the limit.
            let room = (largest - distance).max(0.0);
            if difference * share > room {
                share = room / difference;
            }
        }
    }
    share
}
