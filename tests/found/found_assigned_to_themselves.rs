#[function]
fn found_assigned(at: &mut [Option<isize>], t: &mut u64) -> usize {
    let mut passes = 0_u8;
    #[bound(9)]
    while passes < 5 {
        passes += 1;
        *t = t.wrapping_add((({ at[at.len() / 2] = at[at.len() / 2]; *t as usize }) % at.len()) as u64);
    }
    at.len()
}
#[function]
pub fn found_assigned_to_themselves(at: &mut [Option<isize>; 3], t: &mut u64) -> usize {
    found_assigned(at, t)
}
