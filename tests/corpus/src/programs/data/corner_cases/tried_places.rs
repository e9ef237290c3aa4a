//! `reference?` as a place: a field, an element or an option that `get_mut`, `as_mut` and similar methods return,
//! written and read.

use bessemer::prelude::*;

/// Record of a port.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Port {
    pub level: i16,
    pub last: [i16; 3],
    pub request: Option<i16>,
}

/// Ports by number, and one that may be missing.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Ports {
    pub all: [Port; 3],
    pub spare: Option<Port>,
    pub recent: List<Port, 4>,
    pub bytes: [u8; 4],
    pub calls: i16,
}

#[component]
impl Ports {
    fn called(&mut self) -> i16 {
        self.calls = self.calls.wrapping_mul(3).wrapping_add(1);
        self.all[1].level ^= 5;
        self.calls
    }

    #[entry]
    pub fn written(&mut self, i: u8, j: u8, x: i16) -> Option<i16> {
        self.all.get_mut(i as usize % 5)?.level ^= x;
        self.all.get_mut(j as usize % 4)?.last[i as usize % 3] = x;
        *self.all.get_mut(i as usize % 4)?.last.get_mut(j as usize % 4)? ^= 3;
        *self.bytes.get_mut(j as usize % 6)? ^= x as u8;
        Some(x)
    }

    #[entry]
    pub fn taken(&mut self, i: u8, x: i16) -> Option<i16> {
        if x > 2 {
            self.all.get_mut(i as usize % 5)?.request.replace(x);
        }
        self.all.get_mut(i as usize % 4)?.request.take()
    }

    #[entry]
    pub fn operand_that_moves_the_index(&mut self, i: u8) -> Option<i16> {
        let mut n = i as usize % 4;
        self.all.get_mut(n)?.level ^= {
            n += 1;
            self.calls = self.calls.wrapping_add(n as i16);
            self.calls
        };
        Some(n as i16)
    }

    #[entry]
    pub fn between_calls(&mut self, i: u8) -> Option<i16> {
        Some(self.called() ^ self.all.get(i as usize % 4)?.level ^ self.called())
    }

    #[entry]
    pub fn spare(&mut self, x: i16) -> Option<i16> {
        match x & 3 {
            0 => self.spare = Some(Port::default()),
            3 => self.spare = None,
            _ => {}
        }
        self.spare.as_mut()?.last[2] = x;
        self.spare.as_mut()?.level ^= self.spare.as_ref()?.last[2];
        Some(self.spare.as_ref()?.level)
    }

    #[entry]
    pub fn refused(&mut self, i: u8, x: i16) -> Result<i16, u8> {
        self.all.get_mut(i as usize % 5).ok_or(i)?.last[0] ^= x;
        Ok(self.all.get(i as usize % 4).ok_or(9)?.last[0])
    }

    #[entry]
    pub fn in_a_loop(&mut self, i: u8, x: i16) -> Option<i16> {
        for k in 0..4 {
            self.all.get_mut(k + i as usize % 3)?.level ^= x;
            self.calls ^= self.all.get(k)?.level;
        }
        Some(3)
    }

    #[entry]
    pub fn in_turn(&mut self, i: u8) -> Option<i16> {
        let mut n = i as usize % 4;
        let mut sum = 0i16;
        for _ in 0..3 {
            self.recent.last_mut()?.level ^= 1;
            sum ^= self
                .all
                .get({
                    n = (n + 1) % 4;
                    n
                })?
                .level;
        }
        self.calls = n as i16;
        Some(sum)
    }

    #[entry]
    pub fn newest(&mut self, x: i16) -> Option<i16> {
        self.recent.push(Port::default());
        self.recent.last_mut()?.level = x;
        self.recent.first_mut()?.last[1] ^= x;
        Some(core::mem::take(&mut self.recent.get_mut(1)?.level))
    }

    #[entry]
    pub fn within_a_part(&mut self, i: u8, x: u8) -> Option<u8> {
        self.bytes.get_mut(1..i as usize % 6)?.fill(x);
        self.bytes.get_mut(1..3)?[0] ^= x;
        Some(self.bytes.get(1..)?[1])
    }
}
