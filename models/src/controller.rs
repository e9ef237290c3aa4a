//! One control period of the closed loop, from what is known to what the motors get (thesis, ch. 3).
//!
//! It is the slot for candidates: whatever makes a wrench of an estimate and a target fits in. Which one
//! flies is a parameter; the others rest.

use crate::airframe::{MOST_MOTORS, Wrench};
use crate::cascade::Cascade;
use crate::geometric::track;
use crate::parameters::{Candidate, Parameters};
use crate::printed::Printed;
use crate::signals::{Command, Estimate, Target};
use crate::touch_down::TouchDown;
use bessemer::prelude::*;

/// Flies the aircraft to its target.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Controller {
    /// The thesis' law, as it flies.
    pub cascade: Cascade,
    /// The thesis' law, as it is printed.
    pub printed: Printed,
    /// Whether the landing aircraft has touched down.
    pub touch_down: TouchDown,
}

#[component]
impl Controller {
    /// One control period: the command to each motor, on top of the speeds that the feed-forward asks
    /// of them, rad/s.
    #[entry(infallible)]
    pub fn step(
        &mut self,
        parameters: &Parameters,
        estimate: &Estimate,
        target: &Target,
        feed_forward: &SVector<f64, MOST_MOTORS>,
    ) -> Command {
        if self.touch_down.step(parameters.period, target, estimate) {
            return Command::still();
        }
        let wanted = self.candidate(parameters, estimate, target);
        parameters.mixer.mix(&wanted, feed_forward)
    }

    /// What the candidate that flies asks for.
    fn candidate(
        &mut self,
        parameters: &Parameters,
        estimate: &Estimate,
        target: &Target,
    ) -> Wrench {
        match parameters.candidate {
            Candidate::Cascade => self.cascade.step(parameters, estimate, target),
            Candidate::Printed => self.printed.step(parameters, estimate, target),
            Candidate::Geometric => track(parameters, estimate, target),
        }
    }
}
