//! A small quadratic program with bounds, solved by an active set: the minimum of `xᵀHx/2 − gᵀx` in a box.

use bessemer::prelude::*;

/// Number of unknowns.
const N: usize = 3;

/// Minimises `xᵀHx/2 − gᵀx` for `low ≤ x ≤ high`, by projected Gauss-Seidel on the variables that are not at a bound.
#[function]
pub fn solve_box(h: &Matrix3<f64>, g: &Vector3<f64>, low: f64, high: f64) -> Vector3<f64> {
    assert!(high >= low);
    let mut x: Vector3<f64> = Vector3::zeros();
    for _ in 0..20 {
        let mut free = [true; N];
        for i in 0..N {
            let slope = h[(i, 0)] * x[0] + h[(i, 1)] * x[1] + h[(i, 2)] * x[2] - g[i];
            free[i] = !(x[i] <= low && slope > 0.0 || x[i] >= high && slope < 0.0);
        }
        let mut moved = 0.0_f64;
        for i in 0..N {
            if !free[i] || h[(i, i)] <= 0.0 {
                continue;
            }
            let mut rest = g[i];
            for j in 0..N {
                if j != i {
                    rest -= h[(i, j)] * x[j];
                }
            }
            let next = (rest / h[(i, i)]).clamp(low, high);
            moved = moved.max((next - x[i]).abs());
            x[i] = next;
        }
        if moved < 1e-12 {
            break;
        }
    }
    x
}
