//! Modbus RTU slave: frame check, request parsing and response building.

use core::ops::Range;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct InvalidFrame;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub enum Exception {
    IllegalFunction = 1,
    IllegalAddress = 2,
    IllegalValue = 3,
}

pub enum Request<'a> {
    Read(Range<u16>),
    Write(Range<u16>, &'a [u8]),
}

pub fn crc16(bytes: &[u8]) -> u16 {
    bytes.iter().fold(0xFFFF, |crc, &byte| {
        (0..8).fold(crc ^ u16::from(byte), |crc, _| {
            if crc & 1 != 0 { (crc >> 1) ^ 0xA001 } else { crc >> 1 }
        })
    })
}

/// A frame whose checksum has been verified.
pub struct Frame<'a> {
    pub unit: u8,
    pub function: u8,
    pub data: &'a [u8],
}

impl<'a> TryFrom<&'a [u8]> for Frame<'a> {
    type Error = InvalidFrame;

    fn try_from(raw: &'a [u8]) -> Result<Self, InvalidFrame> {
        let (body, crc) = raw.split_last_chunk().ok_or(InvalidFrame)?;
        match body {
            [unit, function, data @ ..] if crc16(body) == u16::from_le_bytes(*crc) => {
                Ok(Self { unit: *unit, function: *function, data })
            }
            _ => Err(InvalidFrame),
        }
    }
}

impl<'a> Frame<'a> {
    pub fn request(&self) -> Result<Request<'a>, Exception> {
        let [a, b, c, d, rest @ ..] = self.data else {
            return Err(Exception::IllegalValue);
        };
        let (start, count) = (u16::from_be_bytes([*a, *b]), u16::from_be_bytes([*c, *d]));
        let addresses = start..start.checked_add(count).ok_or(Exception::IllegalAddress)?;

        match (self.function, rest) {
            (0x03, []) if (1..=125).contains(&count) => Ok(Request::Read(addresses)),
            (0x10, [size, values @ ..])
                if usize::from(*size) == values.len() && values.len() == 2 * addresses.len() =>
            {
                Ok(Request::Write(addresses, values))
            }
            (0x03 | 0x10, _) => Err(Exception::IllegalValue),
            _ => Err(Exception::IllegalFunction),
        }
    }
}

/// The application's register map.
pub trait Registers {
    fn read(&self, address: u16) -> Option<u16>;
    fn write(&mut self, address: u16, value: u16) -> Result<(), Exception>;
}

/// Response under construction; the longest possible one fits.
pub struct Response {
    bytes: [u8; 256],
    len: usize,
}

impl Response {
    fn new(unit: u8, function: u8) -> Self {
        let mut response = Self { bytes: [0; 256], len: 0 };
        response.put(&[unit, function]);
        response
    }

    fn put(&mut self, bytes: &[u8]) {
        self.bytes[self.len..][..bytes.len()].copy_from_slice(bytes);
        self.len += bytes.len();
    }

    pub fn as_bytes(&self) -> &[u8] {
        &self.bytes[..self.len]
    }
}

pub struct Slave<R> {
    pub unit: u8,
    pub registers: R,
}

impl<R: Registers> Slave<R> {
    /// Handles one frame; `None` when it was meant for another unit.
    pub fn handle(&mut self, raw: &[u8]) -> Result<Option<Response>, InvalidFrame> {
        let frame = Frame::try_from(raw)?;
        if frame.unit != self.unit {
            return Ok(None);
        }
        let mut response = self.answer(&frame).unwrap_or_else(|exception| {
            let mut response = Response::new(self.unit, frame.function | 0x80);
            response.put(&[exception as u8]);
            response
        });
        response.put(&crc16(response.as_bytes()).to_le_bytes());
        Ok(Some(response))
    }

    fn answer(&mut self, frame: &Frame) -> Result<Response, Exception> {
        let mut response = Response::new(self.unit, frame.function);
        match frame.request()? {
            Request::Read(addresses) => {
                response.put(&[addresses.len() as u8 * 2]);
                for address in addresses {
                    let value = self.registers.read(address).ok_or(Exception::IllegalAddress)?;
                    response.put(&value.to_be_bytes());
                }
            }
            Request::Write(addresses, values) => {
                for (address, pair) in addresses.zip(values.chunks_exact(2)) {
                    self.registers.write(address, u16::from_be_bytes([pair[0], pair[1]]))?;
                }
                response.put(&frame.data[..4]);
            }
        }
        Ok(response)
    }
}
