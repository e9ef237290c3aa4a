//! `?` converts the callee's error to the caller's by an own `From`.

use bessemer::prelude::*;

/// Faults of a frame.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum FrameFault {
    #[default]
    Short,
    /// The byte that should have begun it.
    Start(u8),
}

/// Faults of a drive.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum DriveFault {
    #[default]
    Overload,
    /// It was told something that is no frame.
    Link(FrameFault),
}

/// A number for the display.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct FaultCode(pub u16);

#[data]
impl From<FrameFault> for DriveFault {
    /// A fault of the link.
    fn from(fault: FrameFault) -> DriveFault {
        DriveFault::Link(fault)
    }
}

#[data]
impl From<DriveFault> for FaultCode {
    /// The number.
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

/// The current that a frame asks for, A.
#[function]
pub fn current(frame: [u8; 3], limit: f32) -> Result<f32, DriveFault> {
    let current = f32::from(payload(frame)?) * 0.01;
    if current > limit {
        return Err(DriveFault::Overload);
    }
    Ok(current)
}

/// Sum of two frames, or a number for the fault.
#[function]
pub fn total(one: [u8; 3], other: [u8; 3], limit: f32) -> Result<f32, FaultCode> {
    Ok(current(one, limit)? + current(other, limit)?)
}
