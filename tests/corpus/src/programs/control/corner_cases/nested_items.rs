//! Items of `flat_map` and `flatten`, taken one by one, in loops and beside a clone.

use bessemer::prelude::*;

#[function]
fn mixed(sum: u32, item: Option<u32>) -> u32 {
    match item {
        Some(x) => sum.wrapping_mul(31).wrapping_add(x),
        None => sum ^ 5,
    }
}

#[function]
pub fn rows(a: [[u32; 3]; 4]) -> u32 {
    let mut it = a.iter().flat_map(|row| row.iter());
    let mut sum = mixed(7, it.next().map(|x| *x));
    sum = mixed(sum, it.next().map(|x| *x));
    let copy = it.clone();
    sum = mixed(sum, it.next().map(|x| *x));
    for x in copy {
        sum = mixed(sum, Some(*x));
    }
    for x in it.by_ref() {
        sum = mixed(sum, Some(*x));
        if sum % 3 == 0 {
            break;
        }
    }
    for _ in 0..4 {
        sum = mixed(sum, it.next().map(|x| *x));
    }
    mixed(sum, it.next().map(|x| *x))
}

#[function]
pub fn flattened(a: [[u32; 3]; 4]) -> u32 {
    let mut it = a.iter().flatten();
    let mut sum = mixed(7, it.next().map(|x| *x));
    sum = mixed(sum, it.next().map(|x| *x));
    let copy = it.clone();
    sum = mixed(sum, it.next().map(|x| *x));
    for x in copy {
        sum = mixed(sum, Some(*x));
    }
    for x in it.by_ref() {
        sum = mixed(sum, Some(*x));
        if sum % 3 == 0 {
            break;
        }
    }
    for _ in 0..4 {
        sum = mixed(sum, it.next().map(|x| *x));
    }
    mixed(sum, it.next().map(|x| *x))
}

#[function]
pub fn values(a: [u32; 5]) -> u32 {
    let mut it = a.iter().flat_map(|x| [*x, *x ^ 1]);
    let mut sum = mixed(7, it.next().map(|x| x));
    sum = mixed(sum, it.next().map(|x| x));
    let copy = it.clone();
    sum = mixed(sum, it.next().map(|x| x));
    for x in copy {
        sum = mixed(sum, Some(x));
    }
    for x in it.by_ref() {
        sum = mixed(sum, Some(x));
        if sum % 3 == 0 {
            break;
        }
    }
    for _ in 0..4 {
        sum = mixed(sum, it.next().map(|x| x));
    }
    mixed(sum, it.next().map(|x| x))
}

#[function]
pub fn ranges(a: [u32; 5]) -> u32 {
    let mut it = a.iter().flat_map(|x| 0..(*x % 4));
    let mut sum = mixed(7, it.next().map(|x| x));
    sum = mixed(sum, it.next().map(|x| x));
    let copy = it.clone();
    sum = mixed(sum, it.next().map(|x| x));
    for x in copy {
        sum = mixed(sum, Some(x));
    }
    for x in it.by_ref() {
        sum = mixed(sum, Some(x));
        if sum % 3 == 0 {
            break;
        }
    }
    for _ in 0..4 {
        sum = mixed(sum, it.next().map(|x| x));
    }
    mixed(sum, it.next().map(|x| x))
}

#[function]
pub fn optional(a: [u32; 5]) -> u32 {
    let mut it = a.iter().flat_map(|x| x.checked_sub(100));
    let mut sum = mixed(7, it.next().map(|x| x));
    sum = mixed(sum, it.next().map(|x| x));
    let copy = it.clone();
    sum = mixed(sum, it.next().map(|x| x));
    for x in copy {
        sum = mixed(sum, Some(x));
    }
    for x in it.by_ref() {
        sum = mixed(sum, Some(x));
        if sum % 3 == 0 {
            break;
        }
    }
    for _ in 0..4 {
        sum = mixed(sum, it.next().map(|x| x));
    }
    mixed(sum, it.next().map(|x| x))
}

#[function]
pub fn present(a: [u32; 5], b: u32) -> u32 {
    let o = [Some(a[0]), None, a.get(b as usize % 8).copied(), Some(b)];
    let mut it = o.iter().flatten();
    let mut sum = mixed(7, it.next().map(|x| *x));
    sum = mixed(sum, it.next().map(|x| *x));
    let copy = it.clone();
    sum = mixed(sum, it.next().map(|x| *x));
    for x in copy {
        sum = mixed(sum, Some(*x));
    }
    for x in it.by_ref() {
        sum = mixed(sum, Some(*x));
        if sum % 3 == 0 {
            break;
        }
    }
    for _ in 0..4 {
        sum = mixed(sum, it.next().map(|x| *x));
    }
    mixed(sum, it.next().map(|x| *x))
}

#[function]
pub fn adapted(a: [[u32; 3]; 4], b: u32) -> u32 {
    let mut it = a.iter().flat_map(|row| row.iter().map(|x| *x ^ 3).filter(|x| *x > b));
    let mut sum = mixed(7, it.next().map(|x| x));
    sum = mixed(sum, it.next().map(|x| x));
    let copy = it.clone();
    sum = mixed(sum, it.next().map(|x| x));
    for x in copy {
        sum = mixed(sum, Some(x));
    }
    for x in it.by_ref() {
        sum = mixed(sum, Some(x));
        if sum % 3 == 0 {
            break;
        }
    }
    for _ in 0..4 {
        sum = mixed(sum, it.next().map(|x| x));
    }
    mixed(sum, it.next().map(|x| x))
}

#[function]
pub fn sifted(a: [[u32; 3]; 4], b: u32) -> u32 {
    let mut it = a.iter().filter(|row| row[0] > b).flat_map(|row| row.iter().rev());
    let mut sum = mixed(7, it.next().map(|x| *x));
    sum = mixed(sum, it.next().map(|x| *x));
    let copy = it.clone();
    sum = mixed(sum, it.next().map(|x| *x));
    for x in copy {
        sum = mixed(sum, Some(*x));
    }
    for x in it.by_ref() {
        sum = mixed(sum, Some(*x));
        if sum % 3 == 0 {
            break;
        }
    }
    for _ in 0..4 {
        sum = mixed(sum, it.next().map(|x| *x));
    }
    mixed(sum, it.next().map(|x| *x))
}

#[function]
pub fn reversed(a: [[u32; 3]; 4]) -> u32 {
    let mut it = a.iter().rev().flatten();
    let mut sum = mixed(7, it.next().map(|x| *x));
    sum = mixed(sum, it.next().map(|x| *x));
    let copy = it.clone();
    sum = mixed(sum, it.next().map(|x| *x));
    for x in copy {
        sum = mixed(sum, Some(*x));
    }
    for x in it.by_ref() {
        sum = mixed(sum, Some(*x));
        if sum % 3 == 0 {
            break;
        }
    }
    for _ in 0..4 {
        sum = mixed(sum, it.next().map(|x| *x));
    }
    mixed(sum, it.next().map(|x| *x))
}

#[function]
pub fn adapted_after(a: [[u32; 3]; 4]) -> u32 {
    let mut it = a.iter().flatten().map(|x| *x ^ 9).filter(|x| *x % 3 != 0);
    let mut sum = mixed(7, it.next().map(|x| x));
    sum = mixed(sum, it.next().map(|x| x));
    let copy = it.clone();
    sum = mixed(sum, it.next().map(|x| x));
    for x in copy {
        sum = mixed(sum, Some(x));
    }
    for x in it.by_ref() {
        sum = mixed(sum, Some(x));
        if sum % 3 == 0 {
            break;
        }
    }
    for _ in 0..4 {
        sum = mixed(sum, it.next().map(|x| x));
    }
    mixed(sum, it.next().map(|x| x))
}

#[function]
pub fn numbered(a: [[u32; 3]; 4]) -> u32 {
    let mut it = a.iter().flatten().enumerate().map(|(i, x)| *x ^ i as u32);
    let mut sum = mixed(7, it.next().map(|x| x));
    sum = mixed(sum, it.next().map(|x| x));
    let copy = it.clone();
    sum = mixed(sum, it.next().map(|x| x));
    for x in copy {
        sum = mixed(sum, Some(x));
    }
    for x in it.by_ref() {
        sum = mixed(sum, Some(x));
        if sum % 3 == 0 {
            break;
        }
    }
    for _ in 0..4 {
        sum = mixed(sum, it.next().map(|x| x));
    }
    mixed(sum, it.next().map(|x| x))
}

#[function]
pub fn limited(a: [[u32; 3]; 4]) -> u32 {
    let mut it = a.iter().flatten().take(7);
    let mut sum = mixed(7, it.next().map(|x| *x));
    sum = mixed(sum, it.next().map(|x| *x));
    let copy = it.clone();
    sum = mixed(sum, it.next().map(|x| *x));
    for x in copy {
        sum = mixed(sum, Some(*x));
    }
    for x in it.by_ref() {
        sum = mixed(sum, Some(*x));
        if sum % 3 == 0 {
            break;
        }
    }
    for _ in 0..4 {
        sum = mixed(sum, it.next().map(|x| *x));
    }
    mixed(sum, it.next().map(|x| *x))
}

#[function]
pub fn numbers(a: u32) -> u32 {
    let mut it = (0..a % 5).flat_map(|i| 0..i);
    let mut sum = mixed(7, it.next().map(|x| x));
    sum = mixed(sum, it.next().map(|x| x));
    let copy = it.clone();
    sum = mixed(sum, it.next().map(|x| x));
    for x in copy {
        sum = mixed(sum, Some(x));
    }
    for x in it.by_ref() {
        sum = mixed(sum, Some(x));
        if sum % 3 == 0 {
            break;
        }
    }
    for _ in 0..4 {
        sum = mixed(sum, it.next().map(|x| x));
    }
    mixed(sum, it.next().map(|x| x))
}

#[function]
pub fn skipped(a: [[u32; 3]; 4]) -> u32 {
    let mut it = a.iter().flatten().skip(2).step_by(3);
    let mut sum = mixed(7, it.next().map(|x| *x));
    sum = mixed(sum, it.next().map(|x| *x));
    let copy = it.clone();
    sum = mixed(sum, it.next().map(|x| *x));
    for x in copy {
        sum = mixed(sum, Some(*x));
    }
    for x in it.by_ref() {
        sum = mixed(sum, Some(*x));
        if sum % 3 == 0 {
            break;
        }
    }
    for _ in 0..4 {
        sum = mixed(sum, it.next().map(|x| *x));
    }
    mixed(sum, it.next().map(|x| *x))
}

#[function]
pub fn in_turn(a: [[u32; 3]; 2], b: [u32; 2]) -> u32 {
    let mut it = a.iter().flatten().chain(b.iter());
    let mut sum = mixed(7, it.next().map(|x| *x));
    sum = mixed(sum, it.next().map(|x| *x));
    let copy = it.clone();
    sum = mixed(sum, it.next().map(|x| *x));
    for x in copy {
        sum = mixed(sum, Some(*x));
    }
    for x in it.by_ref() {
        sum = mixed(sum, Some(*x));
        if sum % 3 == 0 {
            break;
        }
    }
    for _ in 0..4 {
        sum = mixed(sum, it.next().map(|x| *x));
    }
    mixed(sum, it.next().map(|x| *x))
}

#[function]
pub fn beside(a: [[u32; 3]; 4], b: [u32; 5]) -> u32 {
    let pairs = b.iter().zip(a.iter().flatten());
    pairs.fold(7, |sum, (x, y)| mixed(sum, Some(*x ^ y.wrapping_mul(3))))
}

#[function]
pub fn in_a_condition(a: [[u32; 3]; 4]) -> u32 {
    let mut it = a.iter().flatten();
    let mut sum = 7;
    while let Some(x) = it.next() {
        sum = mixed(sum, Some(*x));
    }
    mixed(sum, it.next().map(|x| *x))
}
