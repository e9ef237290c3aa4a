// What a method of Option or Result is asked of is read before its argument is computed, which may write there.
#[function]
pub fn found_order_of_receivers(a0: [i16; 3], n0: usize, k0: i16, t: &mut u64) -> i64 {
let mut o = if n0 % 2 == 0 { Some(k0) } else { None };
let one = o.map_or({ if let Some(x) = o.as_mut() { *x ^= 5; } a0[0] }, |x| x ^ 1);
let mut p = if n0 % 3 == 0 { None } else { Some(a0[1]) };
let two = p.unwrap_or({ p = Some(7); 3 });
let mut r: Result<i16, u8> = if n0 % 5 == 0 { Err(k0 as u8) } else { Ok(k0) };
let three = r.map_or({ r = if n0 % 2 == 0 { Ok(4) } else { Err(3) }; 4 }, |x| x ^ 2);
let mut q = if n0 % 3 == 1 { None } else { Some(a0[2]) };
let four = q.or({ q = if q.is_some() { None } else { Some(9) }; Some(2) }).map_or(11, |x| x ^ 4);
let five = q.and({ q = if q.is_some() { None } else { Some(6) }; Some(1i16) }).is_some();
let mut w = [o, p, q];
let six = w[n0 % 3].map_or({ w[n0 % 3] = Some(k0 ^ 9); 3 }, |x| x ^ 8);
*t = t.wrapping_mul(31).wrapping_add(five as u64);
let mut sum = one as i64;
for x in [two, three, four, six, o.unwrap_or(8), p.unwrap_or(8), q.unwrap_or(8), r.unwrap_or(8)] { sum = sum.wrapping_mul(31).wrapping_add(x as i64); }
sum
}
