//! Texts that grow and shrink, in structs, and compared.

use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Line {
    pub text: Text<6>,
    pub level: u8,
}

#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Log {
    lines: [Line; 2],
    next: u8,
}

#[component]
impl Log {
    #[entry]
    pub fn say(&mut self, bytes: &[u8; 7], count: usize) -> usize {
        let at = usize::from(self.next % 2);
        self.lines[at].text = Text::of(&bytes[..count % 9]);
        self.next = self.next.wrapping_add(1);
        self.lines[at].text.len()
    }

    #[entry]
    pub fn more(&mut self, at: usize, count: usize) -> bool {
        let letters = *b"abcdef";
        self.lines[at % 2].text.append(&letters[..count % 7]);
        self.lines[at % 2].text.starts_with(b"ab")
    }

    #[entry]
    pub fn less(&mut self, at: usize, length: usize) -> Option<u8> {
        let last = self.lines[at % 2].text.pop();
        self.lines[at % 2].text.truncate(length % 8);
        last
    }

    #[entry]
    pub fn same(&mut self) -> bool {
        self.lines[0] == self.lines[1] || self.lines[0].text.is_empty()
    }

    #[entry]
    pub fn letter(&mut self, index: usize) -> u8 {
        self.lines[0].text.get(index % 8).unwrap_or(b'?')
    }
}
