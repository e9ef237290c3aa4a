// Bounds of loops that stand in large arrays, beside large arrays of the body.
#[function]
pub fn found_bounds_in_large_arrays_0(a0: [i32; 3], n: i32) -> i32 {
    let mut a = [3_usize; 40];
    for i in 0..40 { a[i] = (a0[i % 3] as usize + i) % 5; }
    a[1] = n as usize & 3;
    let mut s = 0i32;
    for i in 0..a[(n as usize & 1)] {
        let mut b = [9_usize; 40];
        for j in 0..40 { b[j] = j * 3 + (n as usize & 1); }
        b[i] = i;
        s = s.wrapping_mul(3).wrapping_add(b[(n as usize) % 40] as i32).wrapping_add(b[i] as i32);
    }
    s
}
#[function]
pub fn found_bounds_in_large_arrays_1(a0: [i32; 3], n: i32) -> i32 {
    let mut a = [3_i32; 80];
    for i in 0..80 { a[i] = a0[i % 3].wrapping_add(i as i32) % 5; }
    let mut s = 0i32;
    let mut k = 0_i32;
    #[bound(20)]
    while k < a[(n as usize & 7)] {
        let mut b = [9_i32; 80];
        for j in 0..80 { b[j] = j as i32 * 3 + (n & 1); }
        s = s.wrapping_mul(3).wrapping_add(b[(n as usize) % 40]).wrapping_add(b[k as usize]);
        k += 1;
    }
    s
}
#[function]
pub fn found_bounds_in_large_arrays_2(a0: [i32; 3], n: i32) -> i32 {
    let mut a = [3_usize; 40];
    for i in 0..40 { a[i] = (a0[i % 3] as usize + i) % 5; }
    a[1] = n as usize & 3;
    let mut s = 0i32;
    for i in (a[(n as usize & 1)]..7).rev() {
        let mut b = [9_usize; 40];
        for j in 0..40 { b[j] = j * 3 + (n as usize & 1); }
        b[i] = i;
        s = s.wrapping_mul(3).wrapping_add(b[(n as usize) % 40] as i32).wrapping_add(b[i] as i32);
    }
    s
}
#[function]
pub fn found_bounds_in_large_arrays_3(a0: [i32; 3], n: i32) -> i32 {
    let mut a = [3_i32; 80];
    for i in 0..80 { a[i] = a0[i % 3].wrapping_add(i as i32) % 5; }
    let mut s = 0i32;
    match a[(n as usize & 7)] {
       0 | 1 => { let mut b = [9_i32; 80]; for j in 0..80 { b[j] = j as i32 * 3 + (n & 1); } for j in 0..80 { s = s.wrapping_mul(3).wrapping_add(b[j]); } }
       2 => { let mut b = [1_i32; 80]; b[(n as usize) % 80] = 4; for j in 0..80 { s = s.wrapping_mul(3).wrapping_add(b[j]); } }
       x => { s = x; }
    }
    s
}
