//! The contribution of each motor to thrust and torques (thesis, eqs. (3.9), (3.10)), on top of what the
//! feed-forward has them do already.
//!
//! When the motors cannot do all that is wanted, roll and pitch are kept before yaw, and yaw before
//! height: an aircraft that keeps its attitude can be flown on. Knows the limits of the motors, and
//! nothing of why the thrust and the torques are wanted.

use crate::airframe::{Airframe, MOST_MOTORS, Wrench};
use crate::signals::Command;
use bessemer::prelude::*;

/// From thrust and torques to motors.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Mixer {
    /// Squares of the motor speeds (rows) per thrust and roll, pitch and yaw torque (columns),
    /// rad²/s² per N and per N·m, about the body's x, y and z.
    pub allocation: SMatrix<f64, MOST_MOTORS, 4>,
    /// Thrust and roll, pitch and yaw torque (rows) per square of the motor speeds (columns), N·s²/rad²
    /// and N·m·s²/rad²: what the motors do. A positive torque turns x towards y, y towards z, z towards x.
    pub effectiveness: SMatrix<f64, 4, MOST_MOTORS>,
    /// Direction in which each motor turns, 1 or −1; 0 where there is none.
    pub spins: SVector<f64, MOST_MOTORS>,
    /// Square of a motor's speed per unit of its command, rad²/s².
    pub square_per_command: f64,
    /// Largest command that a motor takes.
    pub largest_command: f64,
}

#[data]
impl Mixer {
    /// The mixer of an airframe whose motors take commands up to `largest_command`.
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

    /// Motor commands that add a wrench to what `feed_forward`, a speed for each motor, rad/s, does.
    ///
    /// The thrust becomes a speed that is added to the feed-forward's, as the thesis has it. The torques
    /// are added to the square of the sum: added as speeds they would act 1/(1 − gain) times as strongly
    /// under feed-forward, which at a gain of 0.8 no attitude loop survives.
    pub fn mix(&self, wanted: &Wrench, feed_forward: &SVector<f64, MOST_MOTORS>) -> Command {
        let torque = wanted.torque;
        let mut lift = SVector::zeros();
        let mut tilt = SVector::zeros();
        let mut twist = SVector::zeros();
        for n in 0..MOST_MOTORS {
            let own = (self.allocation[(n, 0)] * wanted.thrust).max(0.0).sqrt();
            let speed = own + feed_forward[n];
            lift[n] = speed * speed;
            tilt[n] = self.allocation[(n, 1)] * torque.x + self.allocation[(n, 2)] * torque.y;
            twist[n] = self.allocation[(n, 3)] * torque.z;
        }

        let largest = self.largest_command * self.square_per_command;
        let squares = self.fit(&lift, &tilt, &twist, largest);

        let mut command = Command::still();
        for n in 0..MOST_MOTORS {
            let square = squares[n].max(0.0).min(largest);
            let speed = square.sqrt();
            command.motors[n] = square / self.square_per_command;
            command.speeds[n] = self.spins[n] * speed;
            command.closed_loop[n] = self.spins[n] * (speed - feed_forward[n]);
            command.feed_forward[n] = self.spins[n] * feed_forward[n];
        }
        command
    }

    /// What commands come to once the motors follow them.
    pub fn wrench(&self, command: &Command) -> Wrench {
        let squares = command.speeds.component_mul(&command.speeds);
        let done = self.effectiveness * squares;
        Wrench { thrust: done[0], torque: Vector3::new(done[1], done[2], done[3]) }
    }

    /// Squares of the motor speeds within 0 and `largest`: as much of the tilt as the motors span, then
    /// of the twist, then of the lift.
    fn fit(
        &self,
        lift: &SVector<f64, MOST_MOTORS>,
        tilt: &SVector<f64, MOST_MOTORS>,
        twist: &SVector<f64, MOST_MOTORS>,
        largest: f64,
    ) -> SVector<f64, MOST_MOTORS> {
        let kept = tilt * share(&SVector::zeros(), tilt, largest);
        let turn = kept + twist * share(&kept, twist, largest);

        // How far the lift has to go up or down so that every motor stays within its limits.
        let wanted = lift + turn;
        let mut least = largest;
        let mut most = 0.0;
        for n in 0..MOST_MOTORS {
            if self.spins[n] != 0.0 {
                least = wanted[n].min(least);
                most = wanted[n].max(most);
            }
        }
        let shift = (-least).max(0.0) - (most - largest).max(0.0);

        let mut squares = SVector::zeros();
        for n in 0..MOST_MOTORS {
            if self.spins[n] != 0.0 {
                squares[n] = wanted[n] + shift;
            }
        }
        squares
    }
}

/// The largest share, 0 to 1, of `more` that can be added to `base` while no two motors are further
/// apart than `largest`.
#[function]
fn share(base: &SVector<f64, MOST_MOTORS>, more: &SVector<f64, MOST_MOTORS>, largest: f64) -> f64 {
    let mut share = 1.0;
    for i in 0..MOST_MOTORS {
        for j in 0..MOST_MOTORS {
            let apart = more[i] - more[j];
            let room = largest - (base[i] - base[j]);
            if apart * share > room {
                share = (room / apart).max(0.0);
            }
        }
    }
    share
}
