// Outer loops and blocks that the first `if` of a `loop` leaves, behind other statements.
#[function]
pub fn found_left_from_the_first_if(a: [u8; 4], k: i32) -> i32 {
    let mut s = k;
    'outer: for x in a {
        let mut i = 0_u8;
        loop {
            if i >= x & 7 { s = s.wrapping_add(1); break 'outer; }
            i += 1;
            s = s.wrapping_mul(3).wrapping_add(i as i32);
        }
    }
    s
}
#[function]
pub fn found_left_from_the_first_if_cont(a: [u8; 4], k: i32) -> i32 {
    let mut s = k;
    'outer: for x in a {
        for y in a {
            let mut i = y & 3;
            loop {
                if i >= x & 7 { s = s.wrapping_add(1); continue 'outer; }
                i += 1;
                s = s.wrapping_mul(3).wrapping_add(i as i32);
            }
        }
        s ^= 64;
    }
    s
}
#[function]
pub fn found_left_from_the_first_if_blk(a: [u8; 4], k: i32) -> i32 {
    let mut s = k;
    let v = 'b: {
        for x in a {
            let mut i = 0_u8;
            if x & 1 == 0 { continue; }
            loop {
                if i >= x & 7 { s = s.wrapping_add(1); break 'b s; }
                i += 1;
                s = s.wrapping_mul(3).wrapping_add(i as i32);
            }
        }
        5
    };
    s.wrapping_add(v)
}
#[function]
pub fn found_left_from_the_first_if_val(a: [u8; 4], k: i32) -> i32 {
    let mut s = k; let mut c = 0;
    let v = 'o: loop {
        let mut i = 0_u8;
        c += 1;
        if c > 5 { break -7; }
        loop {
            if i >= a[0] & 7 { s = s.wrapping_add(1); break 'o s.wrapping_mul(2); }
            i += 1;
            s = s.wrapping_mul(3).wrapping_add(i as i32);
        }
    };
    s.wrapping_add(v)
}
