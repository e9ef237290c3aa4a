//! `?` converts the callee's error to the caller's by an implementation of `From`.

use bessemer::prelude::*;

/// Faults of a frame.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum FrameFault {
    #[default]
    Short,
    /// The first byte is wrong: its value.
    Start(u8),
}

/// Faults of a drive.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum DriveFault {
    #[default]
    Overload,
    /// The received frame is invalid.
    Link(FrameFault),
}

/// The number of a fault for the display.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct FaultCode(pub u16);

#[data]
impl From<FrameFault> for DriveFault {
    /// Converts a fault of the frame.
    fn from(fault: FrameFault) -> DriveFault {
        DriveFault::Link(fault)
    }
}

#[data]
impl From<DriveFault> for FaultCode {
    /// The number of a fault.
    fn from(fault: DriveFault) -> FaultCode {
        match fault {
            DriveFault::Overload => FaultCode(1),
            DriveFault::Link(FrameFault::Short) => FaultCode(2),
            DriveFault::Link(FrameFault::Start(byte)) => FaultCode(0x100 + byte as u16),
        }
    }
}

/// The payload of a frame.
#[function]
pub fn payload(frame: [u8; 3]) -> Result<u16, FrameFault> {
    match frame {
        [0x55, low, high] => Ok(u16::from_le_bytes([low, high])),
        [0, 0, 0] => Err(FrameFault::Short),
        [start, ..] => Err(FrameFault::Start(start)),
    }
}

/// The current that a frame requests, A.
#[function]
pub fn current(frame: [u8; 3], limit: f32) -> Result<f32, DriveFault> {
    let current = f32::from(payload(frame)?) * 0.01;
    if current > limit {
        return Err(DriveFault::Overload);
    }
    Ok(current)
}

/// Sum of the currents of two frames, or the number of the fault.
#[function]
pub fn total(one: [u8; 3], other: [u8; 3], limit: f32) -> Result<f32, FaultCode> {
    Ok(current(one, limit)? + current(other, limit)?)
}
