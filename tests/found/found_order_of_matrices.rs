// Operands that write what stands beside them: of compound assignments, products and matrices written out; copies of what is written.
#[function]
fn found_order_of_matrices_wf(f: &mut f64) -> f64 { *f = *f * 0.5 + 1.0; *f }
#[function]
fn found_order_of_matrices_hf(h: &mut i64, x: f64) { *h = h.wrapping_mul(31).wrapping_add(if x.is_nan() { 77 } else { x.to_bits() as i64 }); }
#[function]
fn found_order_of_matrices_wk(k: &mut i16) -> i16 { *k = k.wrapping_mul(3).wrapping_add(1); *k }
#[function]
fn found_order_of_matrices_hk(h: &mut i64, x: i64) { *h = h.wrapping_mul(31).wrapping_add(x); }
#[function]
fn found_order_of_matrices_wv(v: &mut Vector3<f64>) -> f64 { v[1] = v[0] + 0.5; v[0] = -v[2]; v[1] }
#[function]
fn found_order_of_matrices_wm(m: &mut Matrix3<f64>) -> f64 { m[(0, 0)] = 4.0; m[(1, 2)] = m[(2, 2)]; m[(2, 1)] += 0.5; m[(0, 1)] - 1.5 }
#[function]
fn found_order_of_matrices_wmm(m: &mut Matrix3<f64>) -> Matrix3<f64> { m[(0, 2)] = 2.0; m[(1, 1)] += 0.25; m.transpose() }
#[function]
pub fn found_order_of_matrices_0(n0: usize, k0: i16, f0: f64, m0: Matrix3<f64>, v0: Vector3<f64>, t: &mut u64) -> i64 {
let mut g = 1_i64;
{
let mut f = f0;
let z: f64 = { f += found_order_of_matrices_wf(&mut f); f };
found_order_of_matrices_hf(&mut g, z);
found_order_of_matrices_hf(&mut g, f);
}
{
let mut k = k0;
let z: f64 = { k ^= 2 ^ found_order_of_matrices_wk(&mut k); k as f64 };
found_order_of_matrices_hf(&mut g, z);
found_order_of_matrices_hk(&mut g, k as i64);
}
{
let mut f = f0;
let mut v = v0;
let z: f64 = { for x in v.iter() { f += *x * found_order_of_matrices_wf(&mut f); } f };
found_order_of_matrices_hf(&mut g, z);
found_order_of_matrices_hf(&mut g, f);
for x in v.iter() { found_order_of_matrices_hf(&mut g, *x); }
}
{
let mut n = n0;
let mut v = v0;
let z: f64 = { v[n % 3] += found_order_of_matrices_wv(&mut v); 0.0 };
found_order_of_matrices_hf(&mut g, z);
found_order_of_matrices_hk(&mut g, n as i64);
for x in v.iter() { found_order_of_matrices_hf(&mut g, *x); }
}
{
let mut n = n0;
let mut m = m0;
let z: f64 = { m[(n % 3, 1)] -= found_order_of_matrices_wm(&mut m) + 1.0; 0.0 };
found_order_of_matrices_hf(&mut g, z);
found_order_of_matrices_hk(&mut g, n as i64);
for x in m.iter() { found_order_of_matrices_hf(&mut g, *x); }
}
{
let mut v = v0;
let z: f64 = { v = found_order_of_matrices_wv(&mut v) * v; 0.0 };
found_order_of_matrices_hf(&mut g, z);
for x in v.iter() { found_order_of_matrices_hf(&mut g, *x); }
}
g
}
#[function]
pub fn found_order_of_matrices_1(f0: f64, m0: Matrix3<f64>, v0: Vector3<f64>, t: &mut u64) -> i64 {
let mut g = 1_i64;
{
let mut m = m0;
let z: f64 = { m = found_order_of_matrices_wm(&mut m) * m; 0.0 };
found_order_of_matrices_hf(&mut g, z);
for x in m.iter() { found_order_of_matrices_hf(&mut g, *x); }
}
{
let mut f = f0;
let mut m = m0;
let z: f64 = { m = Matrix3::new(0.5, 1.0, f, found_order_of_matrices_wf(&mut f), 1.0, 2.0, 1.0, f, 1.0); 0.0 };
found_order_of_matrices_hf(&mut g, z);
found_order_of_matrices_hf(&mut g, f);
for x in m.iter() { found_order_of_matrices_hf(&mut g, *x); }
}
{
let mut m = m0;
let mut v = v0;
let z: f64 = { m = matrix![0.5, found_order_of_matrices_wv(&mut v), -2.0; v[2], found_order_of_matrices_wv(&mut v), v.x; m[(1, 1)], -2.0, found_order_of_matrices_wm(&mut m)]; 0.0 };
found_order_of_matrices_hf(&mut g, z);
for x in m.iter() { found_order_of_matrices_hf(&mut g, *x); }
for x in v.iter() { found_order_of_matrices_hf(&mut g, *x); }
}
{
let mut v = v0;
let z: f64 = { v.axpy(2.0, &v.clone(), 1.0); 0.0 };
found_order_of_matrices_hf(&mut g, z);
for x in v.iter() { found_order_of_matrices_hf(&mut g, *x); }
}
{
let mut f = f0;
let mut m = m0;
let z: f64 = { m.gemm(1.0, &m.clone(), &m.transpose(), f); 0.0 };
found_order_of_matrices_hf(&mut g, z);
found_order_of_matrices_hf(&mut g, f);
for x in m.iter() { found_order_of_matrices_hf(&mut g, *x); }
}
{
let mut m = m0;
let z: f64 = { found_order_of_matrices_wmm(&mut m).mul_to(&m.clone(), &mut m); 0.0 };
found_order_of_matrices_hf(&mut g, z);
for x in m.iter() { found_order_of_matrices_hf(&mut g, *x); }
}
g
}
