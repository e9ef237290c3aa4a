//! Modbus RTU slave: reads and writes of holding registers.
use bessemer::prelude::*;

const REGISTERS: usize = 16;

#[data]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Exception {
    IllegalFunction = 1,
    IllegalAddress = 2,
    IllegalValue = 3,
}

#[data]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Request {
    Read { address: u16, count: u16 },
    Write { address: u16, value: u16 },
}

#[function]
pub fn crc16(bytes: &[u8]) -> u16 {
    let mut crc = 0xFFFF;
    for &byte in bytes {
        crc ^= u16::from(byte);
        for _ in 0..8 {
            crc = if crc & 1 != 0 { (crc >> 1) ^ 0xA001 } else { crc >> 1 };
        }
    }
    crc
}

#[function]
fn parse(body: &[u8]) -> Result<Request, Exception> {
    if body.len() != 5 {
        return Err(Exception::IllegalFunction);
    }
    let [function, a, b, c, d] = [body[0], body[1], body[2], body[3], body[4]];
    match function {
        3 => {
            let address = u16::from_be_bytes([a, b]);
            let count = u16::from_be_bytes([c, d]);
            if !(1..=8).contains(&count) {
                return Err(Exception::IllegalValue);
            }
            Ok(Request::Read { address, count })
        }
        6 => Ok(Request::Write {
            address: u16::from_be_bytes([a, b]),
            value: u16::from_be_bytes([c, d]),
        }),
        _ => Err(Exception::IllegalFunction),
    }
}

#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Slave {
    unit: u8,
    registers: [u16; REGISTERS],
    received: List<u8, 32>,
    errors: u32,
}

#[component]
impl Slave {
    #[entry]
    pub fn byte(&mut self, byte: u8) {
        if self.received.len() < self.received.capacity() {
            self.received.push(byte);
        }
    }

    /// Handles the silence after a frame: processes the received bytes and returns the answer.
    #[entry]
    pub fn silence(&mut self) -> List<u8, 32> {
        let mut reply = List::new();
        let n = self.received.len();
        if n >= 4 && self.received[0] == self.unit {
            let body = &self.received[..n - 2];
            if crc16(body) == u16::from_le_bytes([self.received[n - 2], self.received[n - 1]]) {
                let (request, function) = (parse(&body[1..]), body[1]);
                reply.push(self.unit);
                match request.and_then(|request| self.serve(request, &mut reply)) {
                    Ok(()) => {}
                    Err(exception) => {
                        reply.push(0x80 | function);
                        reply.push(exception as u8);
                    }
                }
                let crc = crc16(&reply);
                reply.extend(crc.to_le_bytes());
            } else {
                self.errors += 1;
            }
        }
        self.received.clear();
        reply
    }

    fn serve(&mut self, request: Request, reply: &mut List<u8, 32>) -> Result<(), Exception> {
        match request {
            Request::Read { address, count } => {
                let from = address as usize;
                let to = from + count as usize;
                if to > REGISTERS {
                    return Err(Exception::IllegalAddress);
                }
                reply.push(3);
                reply.push(2 * count as u8);
                for register in &self.registers[from..to] {
                    reply.extend(register.to_be_bytes());
                }
                Ok(())
            }
            Request::Write { address, value } => {
                let register = usize::from(address);
                if register >= REGISTERS {
                    return Err(Exception::IllegalAddress);
                }
                self.registers[register] = value;
                reply.push(6);
                reply.extend(address.to_be_bytes());
                reply.extend(value.to_be_bytes());
                Ok(())
            }
        }
    }
}
