//! Loops that change both sides of their condition: a relation that holds at first need not hold in later iterations.

use bessemer::prelude::*;

#[function]
pub fn by_four(table: &[i32; 6], n: usize) -> i32 {
    let n = n.min(5);
    let (mut sum, mut i) = (0i32, 0usize);
    loop {
        sum = sum.wrapping_add(table[i]);
        if i >= n {
            break;
        }
        i += 4;
    }
    sum
}

#[function]
pub fn by_three(table: &[u32; 6], n: u32) -> u32 {
    let n = n.min(5);
    let mut i = 0u32;
    while table[i as usize] < 1000 && i < n {
        i += 3;
    }
    i
}

#[function]
pub fn shifted(start: u32) -> u32 {
    let (mut bits, mut i) = (start, 0u32);
    loop {
        bits ^= 1 << i;
        if i >= 31 {
            break;
        }
        i += 9;
    }
    bits
}

#[function]
pub fn divided(d: u32, n: u32) -> u32 {
    let n = n % 40;
    let (mut bits, mut i) = (0u32, 0u32);
    loop {
        bits ^= d / n;
        if i >= n {
            break;
        }
        i += 1;
        bits = bits.wrapping_mul(3);
    }
    bits
}

/// Sums that need no check: an iteration that begins within the bounds also ends within them.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sums {
    pub last: i32,
}

#[component]
impl Sums {
    #[entry(infallible)]
    pub fn up(&mut self, table: &[i32; 6], n: usize) -> i32 {
        let n = n.min(5);
        let (mut sum, mut i) = (0i32, 0usize);
        loop {
            sum = sum.wrapping_add(table[i]);
            if i >= n {
                break;
            }
            i += 1;
        }
        self.last = sum;
        sum
    }

    #[entry(infallible)]
    pub fn down(&mut self, table: &[i32; 6], n: usize) -> i32 {
        let mut i = n.min(6);
        let mut sum = 0i32;
        while i > 0 {
            i -= 1;
            sum = sum.wrapping_add(table[i]);
        }
        self.last = sum;
        sum
    }
}
