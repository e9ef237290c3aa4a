// References to elements beyond the end, by an index that is a literal: Rust faults where the reference is made, whether
// anything reads it or not.
#[function]
pub fn found_places_beyond_their_end_0(a0: [i16; 3], n: i16) -> i16 {
    let a = a0;
    if n & 1 == 0 {
        let _unread = &a[3];
    }
    a[0]
}
#[function]
pub fn found_places_beyond_their_end_1(a0: [i16; 3], n: i16) -> i16 {
    let mut a = a0;
    if n & 1 == 0 {
        let unread = &mut a[7_usize];
        _ = unread;
    }
    a[0]
}
#[function]
pub fn found_places_beyond_their_end_2(a0: [[i16; 2]; 3], n: i16) -> i16 {
    let mut a = a0;
    if n & 1 == 0 {
        let inner = &mut a[5];
        if n > 100 {
            inner[0] = 1;
        }
    }
    a[0][0]
}
#[function]
pub fn found_places_beyond_their_end_3(m0: Matrix2<f64>, n: i16) -> f64 {
    let mut m = m0;
    match n & 3 {
        0 => {
            let unread = &mut m[(2, 0)];
            _ = unread;
        }
        1 => {
            let unread = &mut m[(0, 2)];
            _ = unread;
        }
        2 => {
            let unread = &mut m[4];
            _ = unread;
        }
        _ => {}
    }
    m[(0, 0)]
}
#[function]
pub fn found_places_beyond_their_end_4(mut item: [SMatrix<u8, 4, 1>; 2], n: i16) -> u8 {
    if n & 1 == 0 {
        let unread = &mut item[5_usize][(0)];
        _ = unread;
    }
    if n & 2 == 0 {
        let unread = &mut item[1][4];
        _ = unread;
    }
    item[0][0]
}
const BEYOND: usize = 3;
#[function]
pub fn found_places_beyond_their_end_5(a0: [i16; 3], n: i16) -> i16 {
    let a = a0;
    if n & 1 == 0 {
        let _unread = &a[BEYOND];
    }
    if n & 2 == 0 {
        let part = &a[1..];
        let _unread = &part[2];
    }
    a[0]
}
#[function]
fn found_places_beyond_their_end_6_slot(v: &mut [i16; 3]) -> &mut i16 {
    &mut v[4]
}
#[function]
pub fn found_places_beyond_their_end_6(a0: [i16; 3], n: i16) -> i16 {
    let mut a = a0;
    if n & 1 == 0 {
        let _unread = found_places_beyond_their_end_6_slot(&mut a);
    }
    a[0]
}
#[function]
pub fn found_places_beyond_their_end_7(a0: [(i16, i16); 2], n: i16) -> i16 {
    let mut a = a0;
    if n & 1 == 0 {
        let (one, _) = &a[2];
        _ = one;
    }
    if n & 2 == 0
        && let (_, ref mut other) = a[9]
    {
        _ = other;
    }
    a[0].0
}
#[function]
pub fn found_places_beyond_their_end_8(a0: [Option<i16>; 2], n: i16) -> i16 {
    let a = a0;
    if n & 1 == 0
        && let Some(_) = &a[2]
    {
        return 1;
    }
    if n & 2 == 0 {
        _ = a[3];
    }
    if n & 4 == 0 {
        _ = a[2].is_some();
    }
    a[0].unwrap_or(3)
}
