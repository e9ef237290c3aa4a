//! Closures that are called where they are written, and `move` closures whose variables change later.

use bessemer::prelude::*;

#[function]
pub fn at_once(a: u32, b: u32) -> u32 {
    let mut n = a;
    let x = (|| {
        n = n.wrapping_add(1);
        if n % 3 == 0 {
            return 5;
        }
        n ^ 3
    })();
    let y = (|z: u32, w: u32| z.wrapping_mul(3) ^ w)(n, b);
    x ^ y ^ n
}

#[function]
pub fn moved(a: u32, b: u32) -> u32 {
    let (mut n, mut m) = (a, [b; 3]);
    let mut next = move || {
        n = n.wrapping_add(m[1]);
        m[1] ^= n;
        m[1]
    };
    let mut sum = next();
    n = n.wrapping_mul(3);
    m[1] = 4;
    let above = move |x: u32| x > n;
    n ^= 1;
    sum = sum.wrapping_mul(31).wrapping_add(next());
    sum ^ n ^ m[1] ^ u32::from(above(b))
}
