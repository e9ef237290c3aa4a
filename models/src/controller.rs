//! One control period of the closed loop, from estimate to motor commands (thesis, ch. 3).
//!
//! Any law that computes a wrench from estimate and target can be added here. A parameter selects the law that runs.

use crate::airframe::{MAX_MOTORS, Wrench};
use crate::cascade::Cascade;
use crate::geometric::track;
use crate::parameters::{Candidate, Parameters};
use crate::printed::Printed;
use crate::signals::{Command, Estimate, Target};
use crate::touch_down::TouchDown;
use bessemer::prelude::*;

/// Controller that flies the aircraft to its target.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Controller {
    /// Control law of the thesis with a correction: see [`crate::cascade`].
    pub cascade: Cascade,
    /// Control law as printed in the thesis: see [`crate::printed`].
    pub printed: Printed,
    /// Touch-down detection during landing.
    pub touch_down: TouchDown,
}

#[component]
impl Controller {
    /// Advances one control period and returns the command to each motor, added to the feed-forward speeds, rad/s.
    #[requirement("HLR-06", "HLR-07", "HLR-15")]
    #[entry(infallible)]
    pub fn step(
        &mut self,
        parameters: &Parameters,
        estimate: &Estimate,
        target: &Target,
        feed_forward: &SVector<f64, MAX_MOTORS>,
    ) -> Command {
        if self.touch_down.step(parameters.period, target, estimate) {
            return Command::still();
        }
        let wanted = self.candidate(parameters, estimate, target);
        parameters.mixer.mix(&wanted, feed_forward)
    }

    /// Returns the wrench requested by the selected control law.
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
