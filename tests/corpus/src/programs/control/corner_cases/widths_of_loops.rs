//! Loops and `match` with every width of integer, up to the limits of the type.

use bessemer::prelude::*;

#[function]
pub fn loops_i8(n: i8) -> u32 {
    let from = n.clamp(0, 3);
    let mut passes = 0;
    for i in from..5 {
        passes += if i == 4 { 100 } else { 1 };
    }
    for i in (from..6).rev() {
        passes += if i == from { 1000 } else { 1 };
    }
    for i in i8::MAX - 2..=i8::MAX - from {
        passes += if i == i8::MAX { 10000 } else { 1 };
    }
    for i in (i8::MIN..=i8::MIN + from).rev() {
        passes += if i == i8::MIN { 100000 } else { 1 };
    }
    passes
}

#[function]
pub fn matched_i8(n: i8) -> u8 {
    match n {
        i8::MIN => 1,
        i8::MAX => 2,
        3 | 5 => 3,
        _ => 0,
    }
}

#[function]
pub fn loops_i16(n: i16) -> u32 {
    let from = n.clamp(0, 3);
    let mut passes = 0;
    for i in from..5 {
        passes += if i == 4 { 100 } else { 1 };
    }
    for i in (from..6).rev() {
        passes += if i == from { 1000 } else { 1 };
    }
    for i in i16::MAX - 2..=i16::MAX - from {
        passes += if i == i16::MAX { 10000 } else { 1 };
    }
    for i in (i16::MIN..=i16::MIN + from).rev() {
        passes += if i == i16::MIN { 100000 } else { 1 };
    }
    passes
}

#[function]
pub fn matched_i16(n: i16) -> u8 {
    match n {
        i16::MIN => 1,
        i16::MAX => 2,
        3 | 5 => 3,
        _ => 0,
    }
}

#[function]
pub fn loops_i32(n: i32) -> u32 {
    let from = n.clamp(0, 3);
    let mut passes = 0;
    for i in from..5 {
        passes += if i == 4 { 100 } else { 1 };
    }
    for i in (from..6).rev() {
        passes += if i == from { 1000 } else { 1 };
    }
    for i in i32::MAX - 2..=i32::MAX - from {
        passes += if i == i32::MAX { 10000 } else { 1 };
    }
    for i in (i32::MIN..=i32::MIN + from).rev() {
        passes += if i == i32::MIN { 100000 } else { 1 };
    }
    passes
}

#[function]
pub fn matched_i32(n: i32) -> u8 {
    match n {
        i32::MIN => 1,
        i32::MAX => 2,
        3 | 5 => 3,
        _ => 0,
    }
}

#[function]
pub fn loops_i64(n: i64) -> u32 {
    let from = n.clamp(0, 3);
    let mut passes = 0;
    for i in from..5 {
        passes += if i == 4 { 100 } else { 1 };
    }
    for i in (from..6).rev() {
        passes += if i == from { 1000 } else { 1 };
    }
    for i in i64::MAX - 2..=i64::MAX - from {
        passes += if i == i64::MAX { 10000 } else { 1 };
    }
    for i in (i64::MIN..=i64::MIN + from).rev() {
        passes += if i == i64::MIN { 100000 } else { 1 };
    }
    passes
}

#[function]
pub fn matched_i64(n: i64) -> u8 {
    match n {
        i64::MIN => 1,
        i64::MAX => 2,
        3 | 5 => 3,
        _ => 0,
    }
}

#[function]
pub fn loops_isize(n: isize) -> u32 {
    let from = n.clamp(0, 3);
    let mut passes = 0;
    for i in from..5 {
        passes += if i == 4 { 100 } else { 1 };
    }
    for i in (from..6).rev() {
        passes += if i == from { 1000 } else { 1 };
    }
    for i in isize::MAX - 2..=isize::MAX - from {
        passes += if i == isize::MAX { 10000 } else { 1 };
    }
    for i in (isize::MIN..=isize::MIN + from).rev() {
        passes += if i == isize::MIN { 100000 } else { 1 };
    }
    passes
}

#[function]
pub fn matched_isize(n: isize) -> u8 {
    match n {
        isize::MIN => 1,
        isize::MAX => 2,
        3 | 5 => 3,
        _ => 0,
    }
}

#[function]
pub fn loops_u8(n: u8) -> u32 {
    let from = n.clamp(0, 3);
    let mut passes = 0;
    for i in from..5 {
        passes += if i == 4 { 100 } else { 1 };
    }
    for i in (from..6).rev() {
        passes += if i == from { 1000 } else { 1 };
    }
    for i in u8::MAX - 2..=u8::MAX - from {
        passes += if i == u8::MAX { 10000 } else { 1 };
    }
    for i in (u8::MIN..=u8::MIN + from).rev() {
        passes += if i == u8::MIN { 100000 } else { 1 };
    }
    passes
}

#[function]
pub fn matched_u8(n: u8) -> u8 {
    match n {
        u8::MIN => 1,
        u8::MAX => 2,
        3 | 5 => 3,
        _ => 0,
    }
}

#[function]
pub fn loops_u16(n: u16) -> u32 {
    let from = n.clamp(0, 3);
    let mut passes = 0;
    for i in from..5 {
        passes += if i == 4 { 100 } else { 1 };
    }
    for i in (from..6).rev() {
        passes += if i == from { 1000 } else { 1 };
    }
    for i in u16::MAX - 2..=u16::MAX - from {
        passes += if i == u16::MAX { 10000 } else { 1 };
    }
    for i in (u16::MIN..=u16::MIN + from).rev() {
        passes += if i == u16::MIN { 100000 } else { 1 };
    }
    passes
}

#[function]
pub fn matched_u16(n: u16) -> u8 {
    match n {
        u16::MIN => 1,
        u16::MAX => 2,
        3 | 5 => 3,
        _ => 0,
    }
}

#[function]
pub fn loops_u32(n: u32) -> u32 {
    let from = n.clamp(0, 3);
    let mut passes = 0;
    for i in from..5 {
        passes += if i == 4 { 100 } else { 1 };
    }
    for i in (from..6).rev() {
        passes += if i == from { 1000 } else { 1 };
    }
    for i in u32::MAX - 2..=u32::MAX - from {
        passes += if i == u32::MAX { 10000 } else { 1 };
    }
    for i in (u32::MIN..=u32::MIN + from).rev() {
        passes += if i == u32::MIN { 100000 } else { 1 };
    }
    passes
}

#[function]
pub fn matched_u32(n: u32) -> u8 {
    match n {
        u32::MIN => 1,
        u32::MAX => 2,
        3 | 5 => 3,
        _ => 0,
    }
}

#[function]
pub fn loops_u64(n: u64) -> u32 {
    let from = n.clamp(0, 3);
    let mut passes = 0;
    for i in from..5 {
        passes += if i == 4 { 100 } else { 1 };
    }
    for i in (from..6).rev() {
        passes += if i == from { 1000 } else { 1 };
    }
    for i in u64::MAX - 2..=u64::MAX - from {
        passes += if i == u64::MAX { 10000 } else { 1 };
    }
    for i in (u64::MIN..=u64::MIN + from).rev() {
        passes += if i == u64::MIN { 100000 } else { 1 };
    }
    passes
}

#[function]
pub fn matched_u64(n: u64) -> u8 {
    match n {
        u64::MIN => 1,
        u64::MAX => 2,
        3 | 5 => 3,
        _ => 0,
    }
}

#[function]
pub fn loops_usize(n: usize) -> u32 {
    let from = n.clamp(0, 3);
    let mut passes = 0;
    for i in from..5 {
        passes += if i == 4 { 100 } else { 1 };
    }
    for i in (from..6).rev() {
        passes += if i == from { 1000 } else { 1 };
    }
    for i in usize::MAX - 2..=usize::MAX - from {
        passes += if i == usize::MAX { 10000 } else { 1 };
    }
    for i in (usize::MIN..=usize::MIN + from).rev() {
        passes += if i == usize::MIN { 100000 } else { 1 };
    }
    passes
}

#[function]
pub fn matched_usize(n: usize) -> u8 {
    match n {
        usize::MIN => 1,
        usize::MAX => 2,
        3 | 5 => 3,
        _ => 0,
    }
}

