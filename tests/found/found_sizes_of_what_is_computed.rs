// Sizes of what is computed for nothing else: it is computed all the same, and leaves nothing behind.
#[data]
#[derive(Clone, Copy)]
pub struct FoundSizesOfWhatIsComputed0 { pub m: Vector3<f64> }
#[function]
fn found_sizes_of_what_is_computed_0_make(n: i32) -> FoundSizesOfWhatIsComputed0 { FoundSizesOfWhatIsComputed0 { m: Vector3::new(f64::from(n), 1.0, 2.0) } }
#[function]
pub fn found_sizes_of_what_is_computed_0(a: [i32; 4], n: i32) -> i32 {
    let rows = found_sizes_of_what_is_computed_0_make(n).m.nrows();
    let mut k = (n & 3) as usize;
    let s = &a[..k];
    k = 0;
    s.len() as i32 + k as i32 + rows as i32
}
#[function]
fn found_sizes_of_what_is_computed_1_make(n: i32) -> Vector3<f64> { assert!(n > 0); Vector3::new(f64::from(n), 1.0, 2.0) }
#[function]
pub fn found_sizes_of_what_is_computed_1(n: i32) -> i32 { found_sizes_of_what_is_computed_1_make(n).nrows() as i32 }
#[function]
fn found_sizes_of_what_is_computed_2_make(n: &mut i32) -> Vector3<f64> { *n = 7; Vector3::new(0.0, 1.0, 2.0) }
#[function]
pub fn found_sizes_of_what_is_computed_2(n: i32) -> i32 { let mut k = n; let rows = found_sizes_of_what_is_computed_2_make(&mut k).ncols(); rows as i32 + (k & 15) }
#[data]
#[derive(Clone, Copy)]
pub struct FoundSizesOfWhatIsComputed3 { pub m: [i32; 3], pub k: i32 }
#[function]
fn found_sizes_of_what_is_computed_3_make(n: i32) -> FoundSizesOfWhatIsComputed3 { FoundSizesOfWhatIsComputed3 { m: [n; 3], k: n } }
#[function]
pub fn found_sizes_of_what_is_computed_3(a: [i32; 4], n: i32) -> i32 {
    let b = 3 < found_sizes_of_what_is_computed_3_make(n).m[(n & 1) as usize];
    let mut k = (n & 3) as usize;
    let s = &a[..k];
    k = 0;
    s.len() as i32 + k as i32 + i32::from(b)
}
