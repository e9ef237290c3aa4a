//! UBX frame parser as a state machine, with typed messages decoded from the
//! payload.

/// Message class and id.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MsgId {
    pub class: u8,
    pub id: u8,
}

/// A complete, verified frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Frame<'a> {
    pub msg: MsgId,
    pub payload: &'a [u8],
}

/// A message that can be read from a payload.
pub trait Message: Sized {
    const ID: MsgId;

    fn parse(payload: &[u8]) -> Option<Self>;
}

impl Frame<'_> {
    /// Decodes the frame as an `M` if it is one.
    pub fn decode<M: Message>(&self) -> Option<M> {
        (self.msg == M::ID).then(|| M::parse(self.payload)).flatten()
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UbxError {
    Checksum,
    /// Payload larger than the buffer; carries its announced length.
    Oversize(u16),
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum State {
    #[default]
    Sync1,
    Sync2,
    Class,
    Id(u8),
    LenLow(MsgId),
    LenHigh(MsgId, u8),
    Payload { msg: MsgId, left: u16 },
    CkA(MsgId),
    CkB(MsgId, bool),
}

/// 8-bit Fletcher sum over everything but the sync bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Fletcher(u8, u8);

impl Fletcher {
    fn add(&mut self, b: u8) {
        self.0 = self.0.wrapping_add(b);
        self.1 = self.1.wrapping_add(self.0);
    }
}

/// Parser with room for `N` payload bytes.
#[derive(Clone, Debug)]
pub struct UbxParser<const N: usize> {
    state: State,
    payload: [u8; N],
    len: usize,
    sum: Fletcher,
    pub errors: u32,
}

impl<const N: usize> UbxParser<N> {
    const SYNC: [u8; 2] = [0xB5, 0x62];

    pub fn new() -> Self {
        Self {
            state: State::default(),
            payload: [0; N],
            len: 0,
            sum: Fletcher::default(),
            errors: 0,
        }
    }

    /// Advances by one byte.
    pub fn push(&mut self, byte: u8) -> Option<Result<Frame<'_>, UbxError>> {
        if !matches!(self.state, State::Sync1 | State::Sync2 | State::CkA(_) | State::CkB(..)) {
            self.sum.add(byte);
        }
        self.state = match self.state {
            State::Sync1 if byte == Self::SYNC[0] => State::Sync2,
            State::Sync2 if byte == Self::SYNC[1] => {
                self.sum = Fletcher::default();
                self.len = 0;
                State::Class
            }
            // A doubled first sync byte may still begin a frame.
            State::Sync2 if byte == Self::SYNC[0] => State::Sync2,
            State::Sync1 | State::Sync2 => State::Sync1,
            State::Class => State::Id(byte),
            State::Id(class) => State::LenLow(MsgId { class, id: byte }),
            State::LenLow(msg) => State::LenHigh(msg, byte),
            State::LenHigh(msg, low) => match u16::from_le_bytes([low, byte]) {
                0 => State::CkA(msg),
                left if usize::from(left) <= N => State::Payload { msg, left },
                left => return self.fail(UbxError::Oversize(left)),
            },
            State::Payload { msg, left } => {
                self.payload[self.len] = byte;
                self.len += 1;
                match left - 1 {
                    0 => State::CkA(msg),
                    left => State::Payload { msg, left },
                }
            }
            State::CkA(msg) => State::CkB(msg, byte == self.sum.0),
            State::CkB(msg, true) if byte == self.sum.1 => {
                self.state = State::Sync1;
                return Some(Ok(Frame { msg, payload: &self.payload[..self.len] }));
            }
            State::CkB(..) => return self.fail(UbxError::Checksum),
        };
        None
    }

    fn fail(&mut self, e: UbxError) -> Option<Result<Frame<'_>, UbxError>> {
        self.state = State::Sync1;
        self.errors = self.errors.saturating_add(1);
        Some(Err(e))
    }
}

impl<const N: usize> Default for UbxParser<N> {
    fn default() -> Self {
        Self::new()
    }
}

fn le_i32(payload: &[u8], at: usize) -> Option<i32> {
    payload.get(at..)?.first_chunk().copied().map(i32::from_le_bytes)
}

/// The part of NAV-PVT the autopilot uses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NavPvt {
    pub fix_3d: bool,
    pub lon: f64,
    pub lat: f64,
    /// North, east, down in m/s.
    pub velocity: [f32; 3],
}

impl Message for NavPvt {
    const ID: MsgId = MsgId { class: 0x01, id: 0x07 };

    fn parse(p: &[u8]) -> Option<Self> {
        let [mut vn, mut ve, mut vd] = [0.0; 3];
        for (v, at) in [&mut vn, &mut ve, &mut vd].into_iter().zip((48..).step_by(4)) {
            *v = le_i32(p, at)? as f32 * 1e-3;
        }
        Some(Self {
            fix_3d: *p.get(20)? == 3,
            lon: f64::from(le_i32(p, 24)?) * 1e-7,
            lat: f64::from(le_i32(p, 28)?) * 1e-7,
            velocity: [vn, ve, vd],
        })
    }
}

/// ACK-ACK: the message that was acknowledged.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ack(pub MsgId);

impl Message for Ack {
    const ID: MsgId = MsgId { class: 0x05, id: 0x01 };

    fn parse(payload: &[u8]) -> Option<Self> {
        let &[class, id] = payload else { return None };
        Some(Self(MsgId { class, id }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ack_after_noise() {
        let mut parser = UbxParser::<100>::new();
        let stream = [0x00, 0xB5, 0xB5, 0x62, 5, 1, 2, 0, 6, 1, 0x0F, 0x38];
        let acks = stream
            .iter()
            .filter_map(|&b| parser.push(b)?.ok()?.decode::<Ack>())
            .fold(0, |n, Ack(msg)| {
                assert_eq!(msg, MsgId { class: 6, id: 1 });
                n + 1
            });
        assert_eq!(acks, 1);
    }

    #[test]
    fn nav_pvt_round_trip() {
        let mut payload = [0_u8; 92];
        payload[20] = 3;
        payload[24..28].copy_from_slice(&(-1_234_567_i32).to_le_bytes());
        payload[28..32].copy_from_slice(&481_000_000_i32.to_le_bytes());
        payload[52..56].copy_from_slice(&(-2500_i32).to_le_bytes());
        let mut sum = Fletcher::default();
        let header = [1, 7, 92, 0];
        header.iter().chain(&payload).for_each(|&b| sum.add(b));

        let mut parser = UbxParser::<92>::default();
        let mut found = None;
        let bytes = [0xB5, 0x62].into_iter().chain(header).chain(payload).chain([sum.0, sum.1]);
        for b in bytes {
            if let Some(Ok(frame)) = parser.push(b) {
                assert!(frame.decode::<Ack>().is_none());
                found = frame.decode::<NavPvt>();
            }
        }
        let pvt = found.unwrap();
        assert!(pvt.fix_3d && (pvt.lat - 48.1).abs() < 1e-9 && pvt.lon < -0.12);
        assert_eq!(pvt.velocity, [0.0, -2.5, 0.0]);
    }

    #[test]
    fn bad_frames_are_counted() {
        let mut parser = UbxParser::<8>::new();
        let bad_sum = [0xB5, 0x62, 5, 1, 0, 0, 9, 9];
        let oversize = [0xB5, 0x62, 1, 7, 92, 0];
        let mut last = None;
        for b in bad_sum.into_iter().chain(oversize) {
            if let Some(Err(e)) = parser.push(b) {
                last = Some(e);
            }
        }
        assert_eq!(last, Some(UbxError::Oversize(92)));
        assert_eq!(parser.errors, 2);
    }
}
