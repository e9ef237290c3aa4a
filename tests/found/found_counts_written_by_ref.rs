// What an iterator counts with is written through `ref mut` while it waits.
#[function]
pub fn found_counts_written_by_ref_0(x: [i32; 6], n: i32) -> i32 { let mut k = (n & 1) as usize; let it = x.iter().skip(k); { let ref mut r = k; *r += 1; } let mut s = 0i32; for y in it { s = s.wrapping_mul(3).wrapping_add(*y); } s.wrapping_add(k as i32) }
#[function]
pub fn found_counts_written_by_ref_1(x: [i32; 6], n: i32) -> i32 { let mut k = (n & 1) as usize; let it = x.iter().skip(k); match k { ref mut r => { *r += 1; } } let mut s = 0i32; for y in it { s = s.wrapping_mul(3).wrapping_add(*y); } s.wrapping_add(k as i32) }
#[function]
pub fn found_counts_written_by_ref_2(x: [[i32; 2]; 4], n: i32) -> i32 { let mut t = (&x[0], n); let r = &t.0[1]; let (ref mut q, _) = t; *q = &x[1]; let mut o = Some(&x[2]); let w = o.unwrap(); match o { Some(ref mut z) => { *z = &x[3]; } None => {} } r.wrapping_mul(3).wrapping_add(w[0]).wrapping_add(t.0[0]).wrapping_mul(3).wrapping_add(o.unwrap()[1]) }
