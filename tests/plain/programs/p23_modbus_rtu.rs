//! Modbus RTU slave: parses a request frame, acts on a register map and builds
//! the response in the caller's buffer.

/// Exception codes of the standard.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Exception {
    IllegalFunction = 1,
    IllegalAddress = 2,
    IllegalValue = 3,
    DeviceFailure = 4,
}

/// What the slave's application offers.
pub trait RegisterMap {
    fn read(&self, address: u16) -> Option<u16>;
    fn write(&mut self, address: u16, value: u16) -> Result<(), Exception>;
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Request<'a> {
    ReadHolding { start: u16, count: u16 },
    WriteSingle { address: u16, value: u16 },
    WriteMultiple { start: u16, data: &'a [u8] },
}

impl<'a> Request<'a> {
    const MAX_READ: u16 = 125;

    /// Parses function code and data, the CRC and address already removed.
    pub fn parse(pdu: &'a [u8]) -> Result<Self, Exception> {
        let word = |h: u8, l: u8| u16::from_be_bytes([h, l]);
        match *pdu {
            [0x03, sh, sl, ch, cl] => match word(ch, cl) {
                count @ 1..=Self::MAX_READ => Ok(Self::ReadHolding { start: word(sh, sl), count }),
                _ => Err(Exception::IllegalValue),
            },
            [0x06, ah, al, vh, vl] => {
                Ok(Self::WriteSingle { address: word(ah, al), value: word(vh, vl) })
            }
            [0x10, sh, sl, ch, cl, bytes, ref data @ ..] => {
                let consistent = data.len() == usize::from(bytes)
                    && word(ch, cl) > 0
                    && data.len() == 2 * usize::from(word(ch, cl));
                consistent
                    .then_some(Self::WriteMultiple { start: word(sh, sl), data })
                    .ok_or(Exception::IllegalValue)
            }
            [0x03 | 0x06 | 0x10, ..] => Err(Exception::IllegalValue),
            _ => Err(Exception::IllegalFunction),
        }
    }
}

/// CRC-16/MODBUS, bit by bit.
pub fn crc16(bytes: &[u8]) -> u16 {
    bytes.iter().fold(0xFFFF, |crc, &b| {
        (0..8).fold(crc ^ u16::from(b), |c, _| if c & 1 == 1 { c >> 1 ^ 0xA001 } else { c >> 1 })
    })
}

/// Appends to a caller's buffer; `None` as soon as it is full.
#[derive(Debug)]
struct Writer<'b> {
    buf: &'b mut [u8],
    len: usize,
}

impl Writer<'_> {
    fn put(&mut self, bytes: &[u8]) -> Option<&mut Self> {
        let slot = self.buf.get_mut(self.len..)?.get_mut(..bytes.len())?;
        slot.copy_from_slice(bytes);
        self.len += bytes.len();
        Some(self)
    }
}

/// A slave with its own bus address.
#[derive(Clone, Debug)]
pub struct Slave<M> {
    address: u8,
    pub map: M,
    crc_errors: u16,
}

impl<M: RegisterMap> Slave<M> {
    pub const BROADCAST: u8 = 0;

    pub fn new(address: u8, map: M) -> Self {
        Self { address, map, crc_errors: 0 }
    }

    pub fn crc_errors(&self) -> u16 {
        self.crc_errors
    }

    /// Handles one frame (delimited by line silence). Gives the part of `out`
    /// to be sent, or nothing when the frame was not for us.
    pub fn step<'o>(&mut self, frame: &[u8], out: &'o mut [u8]) -> Option<&'o [u8]> {
        let (body, crc) = frame.split_last_chunk::<2>()?;
        let (&address, pdu) = body.split_first()?;
        if crc16(body) != u16::from_le_bytes(*crc) {
            self.crc_errors = self.crc_errors.saturating_add(1);
            return None;
        }
        if address != self.address && address != Self::BROADCAST {
            return None;
        }

        let mut w = Writer { buf: out, len: 0 };
        w.put(&[self.address])?;
        let outcome = Request::parse(pdu).and_then(|request| self.execute(request, &mut w));
        if let Err(e) = outcome {
            w.len = 1;
            w.put(&[pdu.first()? | 0x80, e as u8])?;
        }
        if address == Self::BROADCAST {
            return None;
        }
        let crc = crc16(&w.buf[..w.len]).to_le_bytes();
        w.put(&crc)?;
        let Writer { buf, len } = w;
        Some(&buf[..len])
    }

    fn execute(&mut self, request: Request<'_>, w: &mut Writer<'_>) -> Result<(), Exception> {
        let full = Exception::DeviceFailure;
        match request {
            Request::ReadHolding { start, count } => {
                w.put(&[0x03, 2 * count as u8]).ok_or(full)?;
                for offset in 0..count {
                    let value = start
                        .checked_add(offset)
                        .and_then(|a| self.map.read(a))
                        .ok_or(Exception::IllegalAddress)?;
                    w.put(&value.to_be_bytes()).ok_or(full)?;
                }
            }
            Request::WriteSingle { address, value } => {
                self.map.write(address, value)?;
                w.put(&[0x06])
                    .and_then(|w| w.put(&address.to_be_bytes()))
                    .and_then(|w| w.put(&value.to_be_bytes()))
                    .ok_or(full)?;
            }
            Request::WriteMultiple { start, data } => {
                let (mut address, mut count) = (start, 0_u16);
                for pair in data.chunks_exact(2) {
                    self.map.write(address, u16::from_be_bytes([pair[0], pair[1]]))?;
                    address = address.checked_add(1).ok_or(Exception::IllegalAddress)?;
                    count += 1;
                }
                w.put(&[0x10])
                    .and_then(|w| w.put(&start.to_be_bytes()))
                    .and_then(|w| w.put(&count.to_be_bytes()))
                    .ok_or(full)?;
            }
        }
        Ok(())
    }
}

/// Plain registers from `base` on.
#[derive(Clone, Debug)]
pub struct Bank<const N: usize> {
    pub base: u16,
    pub words: [u16; N],
}

impl<const N: usize> RegisterMap for Bank<N> {
    fn read(&self, address: u16) -> Option<u16> {
        self.words.get(usize::from(address.checked_sub(self.base)?)).copied()
    }

    fn write(&mut self, address: u16, value: u16) -> Result<(), Exception> {
        let index = address.checked_sub(self.base).ok_or(Exception::IllegalAddress)?;
        let word = self.words.get_mut(usize::from(index)).ok_or(Exception::IllegalAddress)?;
        *word = value;
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn slave() -> Slave<Bank<4>> {
        Slave::new(0x11, Bank { base: 0x6B, words: [0x022B, 0, 0x0064, 7] })
    }

    /// Puts a CRC on `body` and runs it; the response comes back without CRC.
    fn exchange<'o>(s: &mut Slave<Bank<4>>, body: &[u8], out: &'o mut [u8]) -> Option<&'o [u8]> {
        let mut frame = [0; 64];
        frame[..body.len()].copy_from_slice(body);
        frame[body.len()..][..2].copy_from_slice(&crc16(body).to_le_bytes());
        let (answer, crc) = s.step(&frame[..body.len() + 2], out)?.split_last_chunk()?;
        assert_eq!(*crc, crc16(answer).to_le_bytes());
        Some(answer)
    }

    #[test]
    fn reads_registers() {
        let mut out = [0; 32];
        let frame = [0x11, 0x03, 0x00, 0x6B, 0x00, 0x03, 0x76, 0x87];
        let answer = slave().step(&frame, &mut out).unwrap();
        assert_eq!(answer, [0x11, 3, 6, 2, 0x2B, 0, 0, 0, 0x64, 0xC8, 0xBA]);
    }

    #[test]
    fn writes_and_broadcast() {
        let (mut s, mut out) = (slave(), [0; 32]);
        let answer = exchange(&mut s, &[0x11, 6, 0, 0x6C, 0xAB, 0xCD], &mut out);
        assert_eq!(answer, Some(&[0x11, 6, 0, 0x6C, 0xAB, 0xCD][..]));
        let many = [0, 0x10, 0, 0x6D, 0, 2, 4, 0, 1, 0, 2];
        assert_eq!(exchange(&mut s, &many, &mut out), None);
        assert_eq!(s.map.words, [0x022B, 0xABCD, 1, 2]);
    }

    #[test]
    fn exceptions_and_line_errors() {
        let (mut s, mut out) = (slave(), [0; 32]);
        let cases: [(&[u8], [u8; 2]); 3] = [
            (&[0x11, 0x2B, 0], [0xAB, 1]),
            (&[0x11, 3, 0, 0x6E, 0, 2], [0x83, 2]),
            (&[0x11, 3, 0, 0x6B, 0, 0], [0x83, 3]),
        ];
        for (body, [code, exception]) in cases {
            assert_eq!(exchange(&mut s, body, &mut out), Some(&[0x11, code, exception][..]));
        }
        assert_eq!(s.step(&[0x11, 3, 0, 0, 0, 1, 0, 0], &mut out), None);
        assert_eq!(s.crc_errors(), 1);
    }
}
