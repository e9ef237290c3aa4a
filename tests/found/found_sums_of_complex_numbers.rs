// Sums of complex numbers, their parts by the names of `ComplexField`, and iterators through one value.
#[function]
pub fn found_sums_of_complex_numbers(x: [f64; 6], n: usize) -> [f64; 6] {
    let zs = [Complex::new(x[0], x[1]), Complex::new(x[2], x[3]), Complex::new(x[4], x[5])];
    let a: Complex<f64> = zs.iter().sum();
    let b: Complex<f64> = zs.iter().copied().take(n % 4).map(|z| z * Complex::new(0.0, 2.0)).sum();
    let c = zs.into_iter().filter(|z| z.re > 0.0).sum::<Complex<f64>>() * 2.0;
    [a.re, a.im, b.re, b.im, c.re, c.im]
}
#[function]
fn found_sums_of_complex_numbers_of<T: Real>(x: T, y: T) -> Complex<T> { [Complex::new(x, y), Complex::new(y, x)].iter().map(|z| z.conj()).sum() }
#[function]
pub fn found_sums_of_complex_numbers_g(x: f32, y: f32) -> (f32, f64) { (found_sums_of_complex_numbers_of(x, y).im, found_sums_of_complex_numbers_of(f64::from(x), 1.0).im + [1.0, f64::from(y)].iter().sum::<f64>()) }
#[function]
pub fn found_sums_of_complex_numbers_parts(a: f64, b: f64) -> [f64; 5] {
    let z = Complex::new(a, b);
    [z.modulus(), z.modulus_squared(), z.norm1(), z.argument(), z.conjugate().im]
}
#[function]
pub fn found_sums_of_complex_numbers_parts_f(a: f32, b: f32) -> f32 {
    let z = Complex::new(a, b);
    ComplexField::modulus(z) + z.abs() + (z * z).modulus_squared() + ComplexField::argument(z)
}
#[function]
pub fn found_sums_of_complex_numbers_once(a: i32, q: [f64; 3]) -> (f64, i32, usize) {
    let s = q.iter().copied().chain(core::iter::once(0.5)).fold(0.0, |s, x| s * 2.0 + x);
    let t = core::iter::once(a).chain([1, 2]).map(|x| x.wrapping_mul(3)).max().unwrap_or(0);
    let n = core::iter::once(a).filter(|x| *x > 0).count() + q.iter().zip(core::iter::once(1u8)).count();
    (s, t, n)
}
