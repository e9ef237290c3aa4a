//! Calls of `dshot-frame` over plain numbers.

use crate::*;

pub fn normal(speed: u16, telemetry: bool, cycle: u16) -> Option<([u16; 17], u16, u16, bool)> {
    let frame = NormalFrame::new(speed, telemetry)?;
    Some((frame.duty_cycles(cycle), frame.speed(), frame.crc(), frame.telemetry_enabled()))
}

pub fn inverted(speed: u16, telemetry: bool, cycle: u16) -> Option<([u16; 17], u16)> {
    let frame = BidirectionalFrame::new(speed, telemetry)?;
    Some((frame.duty_cycles(cycle), frame.inner()))
}

pub fn command(which: u8, telemetry: bool) -> u16 {
    let command = match which {
        0 => Command::MotorStop,
        1 => Command::SpinDirectionNormal,
        2 => Command::SignalLineERPMPeriodTelemetry,
        _ => Command::Beep3,
    };
    Frame::<NormalDshot>::command(command, telemetry).inner()
}

pub fn telemetry(raw: u16) -> Option<(u32, Option<u32>, u16)> {
    let read = ErpmTelemetry::try_from_raw(raw)?;
    Some((read.erpm(), read.period_us(), read.to_raw()))
}
