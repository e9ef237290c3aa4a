//! Every signal of a flight by topic and name, with its unit. Recordings and figures are made from them.
//!
//! One table serves CSV, MCAP and the figures, so that a signal has the same name everywhere.

use crate::voyage::Moment;

/// A signal of a flight.
pub struct Signal {
    /// Name of the signal within its topic.
    pub name: &'static str,
    /// Unit of the signal, for people.
    pub unit: &'static str,
    /// Value of the signal in a period.
    pub value: fn(&Moment) -> f64,
}

/// A topic: signals that belong together.
pub struct Topic {
    /// Name of the topic.
    pub name: &'static str,
    /// Description of the channel.
    pub about: &'static str,
    /// Signals of the topic.
    pub signals: &'static [Signal],
}

macro_rules! signals {
    ($($name:ident [$unit:literal] = |$m:ident| $value:expr;)*) => {
        &[$(Signal { name: stringify!($name), unit: $unit, value: |$m| $value }),*]
    };
}

/// Every topic.
pub const TOPICS: &[Topic] = &[
    Topic {
        name: "truth",
        about: "the aircraft as it was",
        signals: signals! {
            x ["m"] = |m| m.state.position.x;
            y ["m"] = |m| m.state.position.y;
            z ["m"] = |m| m.state.position.z;
            roll ["rad"] = |m| m.state.angles.x;
            pitch ["rad"] = |m| m.state.angles.y;
            yaw ["rad"] = |m| m.state.angles.z;
            vx ["m/s"] = |m| m.state.velocity.x;
            vy ["m/s"] = |m| m.state.velocity.y;
            vz ["m/s"] = |m| m.state.velocity.z;
            p ["rad/s"] = |m| m.state.rates.x;
            q ["rad/s"] = |m| m.state.rates.y;
            r ["rad/s"] = |m| m.state.rates.z;
            impact ["m/s"] = |m| m.impact;
        },
    },
    Topic {
        name: "estimate",
        about: "what the software knew of it",
        signals: signals! {
            x ["m"] = |m| m.outputs.estimate.position.x;
            y ["m"] = |m| m.outputs.estimate.position.y;
            z ["m"] = |m| m.outputs.estimate.position.z;
            roll ["rad"] = |m| m.outputs.estimate.angles.x;
            pitch ["rad"] = |m| m.outputs.estimate.angles.y;
            yaw ["rad"] = |m| m.outputs.estimate.angles.z;
            vx ["m/s"] = |m| m.outputs.estimate.velocity.x;
            vy ["m/s"] = |m| m.outputs.estimate.velocity.y;
            vz ["m/s"] = |m| m.outputs.estimate.velocity.z;
            p ["rad/s"] = |m| m.outputs.estimate.rates.x;
            q ["rad/s"] = |m| m.outputs.estimate.rates.y;
            r ["rad/s"] = |m| m.outputs.estimate.rates.z;
            vicon_age ["s"] = |m| m.outputs.ages.vicon;
            height_age ["s"] = |m| m.outputs.ages.height;
            plane_age ["s"] = |m| m.outputs.ages.plane;
        },
    },
    Topic {
        name: "reference",
        about: "where the aircraft was wanted",
        signals: signals! {
            x ["m"] = |m| m.outputs.reference.target.position.x;
            y ["m"] = |m| m.outputs.reference.target.position.y;
            z ["m"] = |m| m.outputs.reference.target.position.z;
            yaw ["rad"] = |m| m.outputs.reference.target.yaw;
            phase [""] = |m| f64::from(m.outputs.reference.phase as u8);
            gain [""] = |m| m.outputs.gain;
            alarm [""] = |m| f64::from(m.outputs.alarm as u8);
        },
    },
    Topic {
        name: "motors",
        about: "commands to the motors, and the speeds that they are made of",
        signals: signals! {
            command1 [""] = |m| m.outputs.command.motors[0];
            command2 [""] = |m| m.outputs.command.motors[1];
            command3 [""] = |m| m.outputs.command.motors[2];
            command4 [""] = |m| m.outputs.command.motors[3];
            command5 [""] = |m| m.outputs.command.motors[4];
            command6 [""] = |m| m.outputs.command.motors[5];
            speed1 ["rad/s"] = |m| m.outputs.command.speeds[0];
            speed2 ["rad/s"] = |m| m.outputs.command.speeds[1];
            speed3 ["rad/s"] = |m| m.outputs.command.speeds[2];
            speed4 ["rad/s"] = |m| m.outputs.command.speeds[3];
            speed5 ["rad/s"] = |m| m.outputs.command.speeds[4];
            speed6 ["rad/s"] = |m| m.outputs.command.speeds[5];
            closed_loop1 ["rad/s"] = |m| m.outputs.command.closed_loop[0];
            closed_loop2 ["rad/s"] = |m| m.outputs.command.closed_loop[1];
            closed_loop3 ["rad/s"] = |m| m.outputs.command.closed_loop[2];
            closed_loop4 ["rad/s"] = |m| m.outputs.command.closed_loop[3];
            feed_forward1 ["rad/s"] = |m| m.outputs.command.feed_forward[0];
            feed_forward2 ["rad/s"] = |m| m.outputs.command.feed_forward[1];
            feed_forward3 ["rad/s"] = |m| m.outputs.command.feed_forward[2];
            feed_forward4 ["rad/s"] = |m| m.outputs.command.feed_forward[3];
            turning1 ["rad/s"] = |m| m.speeds[0];
            turning2 ["rad/s"] = |m| m.speeds[1];
            turning3 ["rad/s"] = |m| m.speeds[2];
            turning4 ["rad/s"] = |m| m.speeds[3];
        },
    },
    Topic {
        name: "sensors",
        about: "what the sensors said",
        signals: signals! {
            gyroscope_x ["counts"] = |m| f64::from(m.inputs.readings.inertial.gyroscope[0]);
            gyroscope_y ["counts"] = |m| f64::from(m.inputs.readings.inertial.gyroscope[1]);
            gyroscope_z ["counts"] = |m| f64::from(m.inputs.readings.inertial.gyroscope[2]);
            accelerometer_x ["counts"] = |m| f64::from(m.inputs.readings.inertial.accelerometer[0]);
            accelerometer_y ["counts"] = |m| f64::from(m.inputs.readings.inertial.accelerometer[1]);
            accelerometer_z ["counts"] = |m| f64::from(m.inputs.readings.inertial.accelerometer[2]);
            echo_fresh [""] = |m| f64::from(u8::from(m.inputs.readings.echo.fresh));
            echo ["µs"] = |m| f64::from(m.inputs.readings.echo.delay);
            vicon_fresh [""] = |m| f64::from(u8::from(m.inputs.readings.vicon.fresh));
            vicon_x ["m"] = |m| m.inputs.readings.vicon.position.x;
            vicon_y ["m"] = |m| m.inputs.readings.vicon.position.y;
            vicon_z ["m"] = |m| m.inputs.readings.vicon.position.z;
        },
    },
];

/// Returns the signal `topic.name`.
pub fn signal(topic: &str, name: &str) -> Option<&'static Signal> {
    let topic = TOPICS.iter().find(|known| known.name == topic)?;
    topic.signals.iter().find(|known| known.name == name)
}
