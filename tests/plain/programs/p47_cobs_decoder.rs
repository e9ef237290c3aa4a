//! A decoder of COBS frames, a byte at a time, and its encoder.

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Fault {
    Overflow,
    Truncated,
    Empty,
}

#[derive(Debug, Clone)]
pub struct Decoder<const N: usize> {
    buffer: [u8; N],
    len: usize,
    left: u8,
    pending_zero: bool,
    state: State,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum State {
    Idle,
    Running,
    Skipping,
}

impl<const N: usize> Decoder<N> {
    pub const fn new() -> Self {
        Self { buffer: [0; N], len: 0, left: 0, pending_zero: false, state: State::Idle }
    }

    fn push(&mut self, byte: u8) -> Result<(), Fault> {
        let slot = self.buffer.get_mut(self.len).ok_or(Fault::Overflow)?;
        *slot = byte;
        self.len += 1;
        Ok(())
    }

    fn restart(&mut self) {
        (self.len, self.left, self.pending_zero) = (0, 0, false);
        self.state = State::Idle;
    }

    /// Gives the frame when its last byte has come.
    pub fn feed(&mut self, byte: u8) -> Result<Option<&[u8]>, Fault> {
        match (self.state, byte) {
            (State::Skipping, 0) => {
                self.restart();
                Ok(None)
            }
            (State::Skipping, _) => Ok(None),
            (State::Idle, 0) => Err(Fault::Empty),
            (State::Running, 0) => {
                let whole = self.left == 0;
                let len = self.len;
                self.restart();
                if whole { Ok(Some(&self.buffer[..len])) } else { Err(Fault::Truncated) }
            }
            (_, byte) => {
                if self.left == 0 {
                    if self.pending_zero {
                        self.push(0)?;
                    }
                    self.pending_zero = byte != 0xFF;
                    self.left = byte - 1;
                    self.state = State::Running;
                } else {
                    self.left -= 1;
                    if let Err(fault) = self.push(byte) {
                        self.state = State::Skipping;
                        return Err(fault);
                    }
                }
                Ok(None)
            }
        }
    }
}

pub fn encode<'a>(data: &[u8], out: &'a mut [u8]) -> Option<&'a [u8]> {
    let mut code_at = 0;
    let mut at = 1;
    let mut code = 1u8;
    for &byte in data {
        if byte == 0 {
            *out.get_mut(code_at)? = code;
            code_at = at;
            at += 1;
            code = 1;
        } else {
            *out.get_mut(at)? = byte;
            at += 1;
            code += 1;
            if code == 0xFF {
                *out.get_mut(code_at)? = code;
                code_at = at;
                at += 1;
                code = 1;
            }
        }
    }
    *out.get_mut(code_at)? = code;
    *out.get_mut(at)? = 0;
    Some(&out[..=at])
}

pub fn survives(data: [u8; 12]) -> bool {
    let mut wire = [0u8; 16];
    let Some(frame) = encode(&data, &mut wire) else { return false };
    let mut decoder = Decoder::<16>::new();
    let mut same = false;
    for &byte in frame {
        if let Ok(Some(payload)) = decoder.feed(byte) {
            same = payload.iter().eq(data.iter());
        }
    }
    same
}

pub fn count_frames(stream: &[u8; 24]) -> (u8, u8) {
    let mut decoder: Decoder<8> = Decoder::new();
    stream.iter().fold((0, 0), |(good, bad), &byte| match decoder.feed(byte) {
        Ok(Some(_)) => (good + 1, bad),
        Ok(None) => (good, bad),
        Err(Fault::Empty) => (good, bad),
        Err(_) => (good, bad + 1),
    })
}
