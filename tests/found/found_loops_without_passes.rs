// An array that loops fill which make no pass: its first values are still there.
#[function]
pub fn found_loops_without_passes_0(x: u8) -> u8 {
    const N: usize = 0;
    let mut a = [7_u8; 2];
    for _ in 0..N {
        a[0] = x;
        a[1] = 3;
    }
    a[(x & 1) as usize]
}
// helper
#[function]
fn found_loops_without_passes_some<const N: usize>(x: u8) -> u8 {
    let mut a = [7_u8; 3];
    for i in 0..N {
        a[0] = x ^ i as u8;
        a[1] = 3;
        a[2] = x;
    }
    a[(x % 3) as usize]
}
#[function]
pub fn found_loops_without_passes_1(x: u8) -> u8 {
    found_loops_without_passes_some::<0>(x) ^ found_loops_without_passes_some::<2>(x).wrapping_mul(3)
}
#[function]
pub fn found_loops_without_passes_2(x: u8) -> u8 {
    let mut a = [7_u8; 40];
    for _ in 0..0 {
        a[39] = x;
        a[0] = x;
    }
    for i in 0..38 {
        a[i + 1] = i as u8;
    }
    a[(x % 40) as usize]
}
#[function]
pub fn found_loops_without_passes_3(x: u8) -> f64 {
    let mut a = Vector3::<f64>::from_element(7.0);
    for i in 0..0_usize {
        a[i] = 1.0;
        a[2] = x as f64;
        a[1] = 2.0;
        a[0] = 3.0;
    }
    a[(x % 3) as usize]
}
