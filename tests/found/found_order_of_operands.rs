// A value is read before the call behind it writes there, also where statements behind both need that call to be computed early.
#[data]
#[derive(Clone, Copy)]
pub struct FoundOperands { a: f64, b: f64, c: f64, d: f64 }
#[function]
fn found_operands_write(f: &mut f64) -> f64 { *f = *f * 0.5 + 1.0; *f }
#[function]
fn found_operands_three(a: f64, b: f64, c: f64) -> f64 { a * 3.0 + b + c }
#[function]
pub fn found_order_of_operands(a0: [f64; 3], n0: usize, k0: f64, t: &mut u64) -> f64 {
let mut f = k0; let n = n0 % 3;
let mut m = Matrix3::new(1.0, k0, 0.5, -3.0, 0.75, 2.0, a0[0], -1.5, 4.0);
m = Matrix3::new(1.0, f, found_operands_write(&mut f), 0.5 + { m[(n, n)] += f; f }, found_operands_write(&mut f), 2.0, 3.0, 0.5, 0.5);
let g = FoundOperands { a: f, b: found_operands_write(&mut f), c: { m[(n, n)] += 1.0; f }, d: 0.0 };
m[(0, 1)] = found_operands_three(f, found_operands_write(&mut f), { m[(n, n)] += 1.0; 0.5 });
let h = [f, found_operands_write(&mut f), { m[(n, n)] += 1.0; 0.5 }];
let p = (f, found_operands_write(&mut f), { m[(n, n)] += 1.0; 0.5 });
let q = FoundOperands { b: f, a: found_operands_write(&mut f), ..{ m[(n, n)] += 1.0; g } };
*t = t.wrapping_mul(31).wrapping_add(q.c.to_bits());
let mut sum = f;
for x in [g.a, g.b, g.c, h[0], h[1], h[2], p.0, p.1, p.2, q.a, q.b, q.c] { sum = sum * 0.75 + x; }
for x in m.iter() { sum = sum * 0.75 + *x; }
sum
}
