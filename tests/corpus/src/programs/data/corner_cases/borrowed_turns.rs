//! Values that borrow, reassigned: borrowed variables that are shadowed, copied or selected by a changing index, and
//! slices that loops change.

#![allow(missing_docs)]

use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Debug)]
pub struct Strip<'a> {
    s: &'a [u8],
    at: usize,
}

#[data]
impl<'a> Strip<'a> {
    fn new(s: &'a [u8]) -> Self {
        Strip { s, at: 0 }
    }
    fn first(&self) -> u8 {
        if self.at < self.s.len() { self.s[self.at] } else { 0 }
    }
    fn rest(&self) -> &'a [u8] {
        &self.s[self.at..]
    }
    fn advance(&mut self, n: usize) {
        self.s = &self.s[n..];
        self.at = 0;
    }
}

#[function]
pub fn shadowed() -> u8 {
    let a = [1, 2, 3];
    let w = Strip::new(&a);
    let a = [4, 5, 6_u8];
    w.first() + a[0]
}

#[function]
pub fn index_moves(rows: &[[u8; 4]; 3]) -> u32 {
    let mut i = 0;
    let w = Strip::new(&rows[i]);
    i += 1;
    let v = Strip { s: &rows[i][1..], at: 1 };
    i += 1;
    u32::from(w.first()) * 100 + u32::from(v.first()) + i as u32
}

#[function]
pub fn rest_after(a: &[u8; 6]) -> u32 {
    let mut w = Strip::new(a);
    w.at = 2;
    let rest = w.rest();
    w.advance(3);
    w.at = 1;
    let again = w.rest();
    let mut sum = 0;
    for x in rest {
        sum = sum * 3 + u32::from(*x);
    }
    for x in again {
        sum = sum * 5 + u32::from(*x);
    }
    sum
}

#[function]
pub fn in_loop(rows: &[[u8; 4]; 3]) -> u32 {
    let mut sum = 0;
    for i in 0..3 {
        let mut w = Strip::new(&rows[i]);
        while let Some((first, rest)) = w.s.split_first() {
            sum = sum * 3 % 1009 + u32::from(*first);
            w.s = rest;
        }
    }
    sum
}

#[function]
pub fn chosen(a: &[u8; 6], c: bool) -> u8 {
    let w = if c { Strip { s: &a[..2], at: 1 } } else { Strip { s: &a[2..], at: 0 } };
    let x = match c {
        true => w,
        false => Strip { at: 3, ..w },
    };
    x.first() + w.first() / 2
}

#[function]
pub fn copied(a: &mut [u8; 4]) -> u8 {
    let b = *a;
    let w = Strip::new(&b);
    a[0] = 9;
    w.first()
}

#[function]
pub fn both(a: &[u8; 6], n: usize) -> u8 {
    let (l, r) = a.split_at(n);
    let p = (Strip::new(l), Strip::new(r));
    let q = (p.1, p.0);
    let w = q.0;
    w.first() + q.0.first() / 2
}

#[data]
#[derive(Debug)]
pub struct Filling<'a> {
    s: &'a mut [u8],
    n: usize,
}
#[data]
impl<'a> Filling<'a> {
    fn put(&mut self, x: u8) -> bool {
        if self.n >= self.s.len() {
            return false;
        }
        self.s[self.n] = x;
        self.n += 1;
        true
    }
}

#[function]
pub fn written(a: &mut [u8; 6], k: usize) -> usize {
    let mut o = Filling { s: &mut a[k..], n: 0 };
    let mut x = 1;
    #[bound(9)] while o.put(x) {
        x += 2;
        if x > 7 {
            break;
        }
    }
    let n = o.n;
    a[0] += n as u8;
    n
}

#[data]
#[derive(Clone, Copy, Debug)]
pub enum Lexeme<'a> {
    End,
    Word(&'a [u8]),
    Num(u32),
}

#[function]
fn token<'a>(text: &mut Strip<'a>) -> Lexeme<'a> {
    while text.at < text.s.len() && text.s[text.at] == b' ' {
        text.at += 1;
    }
    let from = text.at;
    if from == text.s.len() {
        return Lexeme::End;
    }
    if text.s[from].is_ascii_digit() {
        let mut n = 0_u32;
        while text.at < text.s.len() && text.s[text.at].is_ascii_digit() {
            n = n.wrapping_mul(10).wrapping_add(u32::from(text.s[text.at] - b'0'));
            text.at += 1;
        }
        return Lexeme::Num(n);
    }
    while text.at < text.s.len() && text.s[text.at] != b' ' {
        text.at += 1;
    }
    Lexeme::Word(&text.s[from..text.at])
}

#[function]
pub fn tokens(text: &[u8; 16], used: usize) -> u32 {
    let mut w = Strip::new(&text[..used.min(16)]);
    let mut last = Lexeme::End;
    let mut sum = 0_u32;
    for _ in 0..16 {
        let now = token(&mut w);
        match now {
            Lexeme::End => break,
            Lexeme::Word(word) => {
                for x in word {
                    sum = sum.wrapping_mul(31).wrapping_add(u32::from(*x));
                }
            }
            Lexeme::Num(n) => sum = sum.wrapping_add(n),
        }
        last = now;
    }
    sum
}
