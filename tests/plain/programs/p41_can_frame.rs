//! Packs and unpacks CAN frames of a motor controller.

/// A classic CAN frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Frame {
    pub id: u16,
    pub dlc: u8,
    pub data: [u8; 8],
}

/// What goes wrong when a frame is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CodecError {
    UnknownId(u16),
    BadLength { expected: u8, got: u8 },
    BadChecksum,
    OutOfRange,
}

/// Messages of the drive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Message {
    Heartbeat { node: u8, uptime_ms: u32 },
    Status { rpm: i16, current_ma: i16, temperature: i8, flags: Flags },
    Command(Command),
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Command {
    Stop,
    Speed(i16),
    Torque(f32),
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Flags(u8);

impl Flags {
    pub const OVERTEMP: Flags = Flags(1 << 0);
    pub const STALLED: Flags = Flags(1 << 1);
    pub const BRAKED: Flags = Flags(1 << 4);

    pub fn contains(self, other: Flags) -> bool {
        self.0 & other.0 == other.0
    }

    pub fn bits(self) -> u8 {
        self.0
    }
}

impl core::ops::BitOr for Flags {
    type Output = Flags;
    fn bitor(self, rhs: Flags) -> Flags {
        Flags(self.0 | rhs.0)
    }
}

const ID_HEARTBEAT: u16 = 0x700;
const ID_STATUS: u16 = 0x180;
const ID_COMMAND: u16 = 0x200;

fn checksum(bytes: &[u8]) -> u8 {
    bytes.iter().fold(0xFFu8, |acc, &b| acc.rotate_left(1) ^ b)
}

impl Frame {
    pub const EMPTY: Frame = Frame { id: 0, dlc: 0, data: [0; 8] };

    fn with(id: u16, payload: &[u8]) -> Frame {
        let mut frame = Frame { id, dlc: payload.len() as u8, ..Frame::EMPTY };
        frame.data[..payload.len()].copy_from_slice(payload);
        frame
    }

    fn payload(&self) -> &[u8] {
        &self.data[..usize::from(self.dlc.min(8))]
    }

    fn expect_len(&self, expected: u8) -> Result<(), CodecError> {
        if self.dlc == expected {
            Ok(())
        } else {
            Err(CodecError::BadLength { expected, got: self.dlc })
        }
    }
}

impl From<Message> for Frame {
    fn from(message: Message) -> Frame {
        match message {
            Message::Heartbeat { node, uptime_ms } => {
                let [a, b, c, d] = uptime_ms.to_le_bytes();
                Frame::with(ID_HEARTBEAT | u16::from(node & 0x7F), &[a, b, c, d])
            }
            Message::Status { rpm, current_ma, temperature, flags } => {
                let mut data = [0u8; 7];
                data[0..2].copy_from_slice(&rpm.to_be_bytes());
                data[2..4].copy_from_slice(&current_ma.to_be_bytes());
                data[4] = temperature as u8;
                data[5] = flags.bits();
                data[6] = checksum(&data[..6]);
                Frame::with(ID_STATUS, &data)
            }
            Message::Command(command) => match command {
                Command::Stop => Frame::with(ID_COMMAND, &[0]),
                Command::Speed(rpm) => {
                    let [hi, lo] = rpm.to_be_bytes();
                    Frame::with(ID_COMMAND, &[1, hi, lo])
                }
                Command::Torque(nm) => {
                    let bits = nm.to_bits().to_be_bytes();
                    let mut data = [2u8; 5];
                    data[1..].copy_from_slice(&bits);
                    Frame::with(ID_COMMAND, &data)
                }
            },
        }
    }
}

impl TryFrom<Frame> for Message {
    type Error = CodecError;

    fn try_from(frame: Frame) -> Result<Message, CodecError> {
        match frame.id {
            id @ 0x700..=0x77F => {
                frame.expect_len(4)?;
                let uptime_ms =
                    u32::from_le_bytes(frame.data[..4].try_into().map_err(|_| CodecError::OutOfRange)?);
                Ok(Message::Heartbeat { node: (id & 0x7F) as u8, uptime_ms })
            }
            ID_STATUS => {
                frame.expect_len(7)?;
                let (sum, body) = frame.payload().split_last().ok_or(CodecError::OutOfRange)?;
                if checksum(body) != *sum {
                    return Err(CodecError::BadChecksum);
                }
                Ok(Message::Status {
                    rpm: i16::from_be_bytes([body[0], body[1]]),
                    current_ma: i16::from_be_bytes([body[2], body[3]]),
                    temperature: body[4] as i8,
                    flags: Flags(body[5]),
                })
            }
            ID_COMMAND => match frame.payload() {
                [0] => Ok(Message::Command(Command::Stop)),
                &[1, hi, lo] => Ok(Message::Command(Command::Speed(i16::from_be_bytes([hi, lo])))),
                [2, rest @ ..] if rest.len() == 4 => {
                    let raw = u32::from_be_bytes([rest[0], rest[1], rest[2], rest[3]]);
                    let nm = f32::from_bits(raw);
                    if nm.is_finite() && nm.abs() <= 50.0 {
                        Ok(Message::Command(Command::Torque(nm)))
                    } else {
                        Err(CodecError::OutOfRange)
                    }
                }
                other => Err(CodecError::BadLength { expected: 1, got: other.len() as u8 }),
            },
            id => Err(CodecError::UnknownId(id)),
        }
    }
}

pub fn status_round_trip(rpm: i16, current_ma: i16, temperature: i8, hot: bool) -> bool {
    let flags = if hot { Flags::OVERTEMP | Flags::STALLED } else { Flags::default() };
    let message = Message::Status { rpm, current_ma, temperature, flags };
    let frame: Frame = message.into();
    matches!(Message::try_from(frame), Ok(m) if m == message)
}

pub fn decode(id: u16, dlc: u8, data: [u8; 8]) -> Result<Message, CodecError> {
    Frame { id, dlc, data }.try_into()
}

pub fn set_speed(rpm: i16) -> Frame {
    Message::Command(Command::Speed(rpm)).into()
}

/// Signals in a DBC sense: start bit and length, little-endian.
pub fn extract(frame: &Frame, start: u32, len: u32) -> u32 {
    let raw = u64::from_le_bytes(frame.data);
    let mask = if len >= 32 { u32::MAX } else { (1 << len) - 1 };
    (raw.checked_shr(start).unwrap_or(0) as u32) & mask
}

pub fn insert(frame: &mut Frame, start: u32, len: u32, value: u32) -> Result<(), CodecError> {
    if start + len > 64 || len == 0 || len > 32 {
        return Err(CodecError::OutOfRange);
    }
    let mask = (u64::MAX >> (64 - len)) << start;
    let raw = u64::from_le_bytes(frame.data) & !mask | (u64::from(value) << start) & mask;
    frame.data = raw.to_le_bytes();
    Ok(())
}
