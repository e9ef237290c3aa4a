//! Inputs of the flight software, from the readings of each aircraft.

use std::array::from_fn;

use bessemer_lanes::{LANES, Mask, Real, Whole};
use models::calibration::Readings;
use models::packet::Packet;

/// Inputs of a period, aircraft by aircraft.
#[derive(Default)]
pub(super) struct Received {
    /// Readings of each aircraft.
    pub readings: [Readings; LANES],
    /// Time of all processors, µs.
    pub clock: u64,
}

impl Received {
    /// Writes the inputs except the uplink.
    pub fn put(&self, inputs: &mut models_lanes::Inputs) {
        inputs.time = Whole::of(self.clock as i64);
        let models_lanes::Readings { inertial, echo, flow, vicon } = &mut inputs.readings;
        inertial.fresh = self.truth(|it| it.inertial.fresh);
        inertial.gyroscope = from_fn(|axis| self.whole(|it| it.inertial.gyroscope[axis].into()));
        inertial.accelerometer =
            from_fn(|axis| self.whole(|it| it.inertial.accelerometer[axis].into()));
        echo.fresh = self.truth(|it| it.echo.fresh);
        echo.delay = self.whole(|it| it.echo.delay.into());
        flow.fresh = self.truth(|it| it.flow.fresh);
        flow.velocity = from_fn(|axis| self.whole(|it| it.flow.velocity[axis].into()));
        vicon.fresh = self.truth(|it| it.vicon.fresh);
        vicon.position = from_fn(|axis| self.real(|it| it.vicon.position[axis]));
        vicon.angles = from_fn(|axis| self.real(|it| it.vicon.angles[axis]));
    }

    fn truth(&self, of: impl Fn(&Readings) -> bool) -> Mask {
        Mask::new(from_fn(|lane| of(&self.readings[lane])))
    }

    fn whole(&self, of: impl Fn(&Readings) -> i64) -> Whole {
        Whole::new(from_fn(|lane| of(&self.readings[lane])))
    }

    fn real(&self, of: impl Fn(&Readings) -> f64) -> Real {
        Real::new(from_fn(|lane| of(&self.readings[lane])))
    }
}

/// Writes the packet of one aircraft. Most periods have none, and none before.
pub(super) fn put_packet(link: &mut models_lanes::Packet, lane: usize, packet: &Packet) {
    if packet.length == 0 && link.length.lane(lane) == 0 {
        return;
    }
    link.length.set(lane, packet.length as i64);
    for (to, byte) in link.bytes.iter_mut().zip(packet.bytes) {
        to.set(lane, byte);
    }
}
