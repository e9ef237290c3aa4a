// Sizes of matrices whose computation does something, or faults.
#[function]
fn found_sizes_of_matrices_0_m(k: &mut usize, x: f64) -> Matrix2x3<f64> { *k += 1; Matrix2x3::from_element(x) }
#[function]
pub fn found_sizes_of_matrices_0(n: usize, x: f64) -> usize {
    let mut k = n % 1000;
    let a = found_sizes_of_matrices_0_m(&mut k, x).nrows() + k * 10;
    let b = found_sizes_of_matrices_0_m(&mut k, x).len() * k + found_sizes_of_matrices_0_m(&mut k, x).transpose().nrows() * 100;
    let c = { k += 5; Vector3::new(x, x, x) }.len() + found_sizes_of_matrices_0_m(&mut k, x).column(k % 3).nrows();
    for _ in 0..found_sizes_of_matrices_0_m(&mut k, x).ncols() { k += 7; }
    let v = Vector3::new(1.0, 2.0, x); let mut w = v;
    for i in 0..v.len() { w[i] += w[(i + 1) % w.nrows()]; }
    a + b * 3 + c * 1000 + k * 7 + w.len()
}
#[function]
pub fn found_sizes_of_matrices_1(n: usize, ms: [Matrix2<f64>; 3]) -> usize { ms[n % 5].nrows() }
#[function]
pub fn found_sizes_of_matrices_2(n: usize, m: Matrix3<f64>) -> usize { m.column(n % 4).nrows() + m.fixed_view::<2, 2>(n % 3, 0).len() }
#[function]
pub fn found_sizes_of_matrices_3(n: usize, m: SMatrix<f64, 6, 6>) -> usize { m.fixed_view::<5, 5>(n % 3, 1).ncols() + m.row(1).len() }
#[function]
pub fn found_sizes_of_matrices_4(n: usize, a: [i8; 3]) -> usize { let m = Matrix2::new(a[0] as i32, 3, a[n % 4] as i32, 2); m.nrows() + Vector2::new(a[n % 3] as i32, 1 / (n % 2) as i32).len() }
