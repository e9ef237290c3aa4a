//! Derivatives of solutions, inverses and determinants: A x′ = b′ − A′ x, for all columns of x′ at once.

use bessemer::prelude::*;

/// Deflections of a chain of two springs under a load; zeros if it is loose.
#[function]
pub fn deflected(springs: &Vector2<f64>, load: &Vector2<f64>) -> Vector2<f64> {
    let stiffness = matrix![springs[0] + springs[1], -springs[1]; -springs[1], springs[1]];
    match stiffness.lu().solve(load) {
        Some(deflection) => deflection,
        None => Vector2::zeros(),
    }
}

/// Deflections with their Jacobians by the springs and by the load.
#[function(derivative(deflected, springs, load))]
pub fn deflected_jacobian(
    springs: &Vector2<f64>,
    load: &Vector2<f64>,
) -> (Vector2<f64>, Matrix2<f64>, Matrix2<f64>) {
    let stiffness_0 = springs[0] + springs[1];
    let stiffness_1 = -springs[1];
    let stiffness_2 = -springs[1];
    let matrix = matrix![stiffness_0, stiffness_2; stiffness_1, springs[1]];
    let mut solution = *load;
    let solved = bessemer::solve_into(&matrix, &mut solution);
    let mut solution_d = matrix![-solution[0], -solution[0] - -solution[1], 1.0, 0.0; 0.0, solution[0] - solution[1], 0.0, 1.0];
    bessemer::solve_into(&matrix, &mut solution_d);
    let result_0: f64;
    let result_0_d0: f64;
    let result_0_d1: f64;
    let result_0_d2: f64;
    let result_0_d3: f64;
    let result_1: f64;
    let result_1_d0: f64;
    let result_1_d1: f64;
    let result_1_d2: f64;
    let result_1_d3: f64;
    if solved {
        result_0 = solution[0];
        result_0_d0 = solution_d[(0, 0)];
        result_0_d1 = solution_d[(0, 1)];
        result_0_d2 = solution_d[(0, 2)];
        result_0_d3 = solution_d[(0, 3)];
        result_1 = solution[1];
        result_1_d0 = solution_d[(1, 0)];
        result_1_d1 = solution_d[(1, 1)];
        result_1_d2 = solution_d[(1, 2)];
        result_1_d3 = solution_d[(1, 3)];
    } else {
        result_0 = 0.0;
        result_0_d0 = 0.0;
        result_0_d1 = 0.0;
        result_0_d2 = 0.0;
        result_0_d3 = 0.0;
        result_1 = 0.0;
        result_1_d0 = 0.0;
        result_1_d1 = 0.0;
        result_1_d2 = 0.0;
        result_1_d3 = 0.0;
    }
    let mut jacobian: SMatrix<f64, 2, 2> = SMatrix::zeros();
    jacobian[(0, 0)] = result_0_d0;
    jacobian[(0, 1)] = result_0_d1;
    jacobian[(1, 0)] = result_1_d0;
    jacobian[(1, 1)] = result_1_d1;
    let mut jacobian_2: SMatrix<f64, 2, 2> = SMatrix::zeros();
    jacobian_2[(0, 0)] = result_0_d2;
    jacobian_2[(0, 1)] = result_0_d3;
    jacobian_2[(1, 0)] = result_1_d2;
    jacobian_2[(1, 1)] = result_1_d3;
    (vector![result_0, result_1], jacobian, jacobian_2)
}

/// Normalised innovation squared, νᵀ·S⁻¹·ν; negative if S is not positive definite.
#[function]
pub fn surprise(s: &Matrix2<f64>, difference: &Vector2<f64>) -> f64 {
    match s.cholesky() {
        Some(factor) => difference.dot(&factor.solve(difference)),
        None => -1.0,
    }
}

/// The surprise with its gradients by the covariance and by the innovation.
#[function(derivative(surprise, s, difference))]
pub fn surprise_gradient(
    s: &Matrix2<f64>,
    difference: &Vector2<f64>,
) -> (f64, SMatrix<f64, 1, 4>, SMatrix<f64, 1, 2>) {
    let lower = bessemer::linear::kernels::cholesky_lower(s);
    let factor_0 = lower[(0, 0)] > 0.0;
    let result: f64;
    let result_d0: f64;
    let result_d1: f64;
    let result_d3: f64;
    let result_d4: f64;
    let result_d5: f64;
    if factor_0 {
        let mut solution = *difference;
        bessemer::linear::kernels::cholesky_solve_mut(&lower, &mut solution);
        let mut solution_d = matrix![-solution[0], -solution[1], 0.0, 1.0, 0.0; 0.0, -solution[0], -solution[1], 0.0, 1.0];
        bessemer::linear::kernels::cholesky_solve_mut(&lower, &mut solution_d);
        let result_2 = difference[0] * solution[0] + difference[1] * solution[1];
        let result_d0_2 = difference[0] * solution_d[(0, 0)] + difference[1] * solution_d[(1, 0)];
        let result_d1_2 = difference[0] * solution_d[(0, 1)] + difference[1] * solution_d[(1, 1)];
        let result_d3_2 = difference[0] * solution_d[(0, 2)] + difference[1] * solution_d[(1, 2)];
        let result_d4_2 = solution[0] + difference[0] * solution_d[(0, 3)] + difference[1] * solution_d[(1, 3)];
        let result_d5_2 = difference[0] * solution_d[(0, 4)] + (solution[1] + difference[1] * solution_d[(1, 4)]);
        result = result_2;
        result_d0 = result_d0_2;
        result_d1 = result_d1_2;
        result_d3 = result_d3_2;
        result_d4 = result_d4_2;
        result_d5 = result_d5_2;
    } else {
        let result_2 = -1.0;
        result = result_2;
        result_d0 = 0.0;
        result_d1 = 0.0;
        result_d3 = 0.0;
        result_d4 = 0.0;
        result_d5 = 0.0;
    }
    let mut jacobian: SMatrix<f64, 1, 4> = SMatrix::zeros();
    jacobian[(0, 0)] = result_d0;
    jacobian[(0, 1)] = result_d1;
    jacobian[(0, 3)] = result_d3;
    let mut jacobian_2: SMatrix<f64, 1, 2> = SMatrix::zeros();
    jacobian_2[(0, 0)] = result_d4;
    jacobian_2[(0, 1)] = result_d5;
    (result, jacobian, jacobian_2)
}

/// The inverse of a matrix times a number; the matrix itself if there is none.
#[function]
pub fn inverted(a: &Matrix2<f64>, scale: f64) -> Matrix2<f64> {
    let scaled = a * scale;
    scaled.try_inverse().unwrap_or(scaled)
}

/// The inverse with its derivative by the number.
#[function(derivative(inverted, scale))]
pub fn inverted_slope(a: &Matrix2<f64>, scale: f64) -> (Matrix2<f64>, Vector4<f64>) {
    let scaled_0 = a[(0, 0)] * scale;
    let scaled_1 = a[(1, 0)] * scale;
    let scaled_2 = a[(0, 1)] * scale;
    let scaled_3 = a[(1, 1)] * scale;
    let mut inverse = matrix![scaled_0, scaled_2; scaled_1, scaled_3];
    let inverted = bessemer::inverse_mut(&mut inverse);
    let mut inverse_d = matrix![a[(0, 0)], a[(0, 1)]; a[(1, 0)], a[(1, 1)]];
    if inverted {
        inverse_d = inverse * matrix![-(inverse[(0, 0)] * a[(0, 0)]) - inverse[(1, 0)] * a[(0, 1)], -(inverse[(0, 1)] * a[(0, 0)]) - inverse[(1, 1)] * a[(0, 1)]; -(inverse[(0, 0)] * a[(1, 0)]) - inverse[(1, 0)] * a[(1, 1)], -(inverse[(0, 1)] * a[(1, 0)]) - inverse[(1, 1)] * a[(1, 1)]];
    }
    let result_0: f64;
    let result_0_d0: f64;
    let result_1: f64;
    let result_1_d0: f64;
    let result_2: f64;
    let result_2_d0: f64;
    let result_3: f64;
    let result_3_d0: f64;
    if inverted {
        result_0 = inverse[(0, 0)];
        result_0_d0 = inverse_d[(0, 0)];
        result_1 = inverse[(1, 0)];
        result_1_d0 = inverse_d[(1, 0)];
        result_2 = inverse[(0, 1)];
        result_2_d0 = inverse_d[(0, 1)];
        result_3 = inverse[(1, 1)];
        result_3_d0 = inverse_d[(1, 1)];
    } else {
        result_0 = scaled_0;
        result_0_d0 = a[(0, 0)];
        result_1 = scaled_1;
        result_1_d0 = a[(1, 0)];
        result_2 = scaled_2;
        result_2_d0 = a[(0, 1)];
        result_3 = scaled_3;
        result_3_d0 = a[(1, 1)];
    }
    let mut jacobian: SVector<f64, 4> = SVector::zeros();
    jacobian[0] = result_0_d0;
    jacobian[1] = result_1_d0;
    jacobian[2] = result_2_d0;
    jacobian[3] = result_3_d0;
    (matrix![result_0, result_2; result_1, result_3], jacobian)
}

/// Determinants of a matrix with a number on its diagonal, and of its first rows and columns.
#[function]
pub fn determinants(a: &Matrix4<f64>, shift: f64) -> Vector2<f64> {
    let mut shifted = *a;
    let mut part = Matrix3::zeros();
    for k in 0..4 {
        shifted[(k, k)] += shift;
    }
    for column in 0..3 {
        for row in 0..3 {
            part[(row, column)] = shifted[(row, column)];
        }
    }
    Vector2::new(shifted.determinant(), part.determinant())
}

/// The determinants with their slopes.
#[function(derivative(determinants, shift))]
pub fn determinant_slopes(a: &Matrix4<f64>, shift: f64) -> (Vector2<f64>, Vector2<f64>) {
    let shifted_0 = a[(0, 0)] + shift;
    let shifted_5 = a[(1, 1)] + shift;
    let shifted_10 = a[(2, 2)] + shift;
    let shifted_15 = a[(3, 3)] + shift;
    let matrix = matrix![shifted_0, a[(0, 1)], a[(0, 2)], a[(0, 3)]; a[(1, 0)], shifted_5, a[(1, 2)], a[(1, 3)]; a[(2, 0)], a[(2, 1)], shifted_10, a[(2, 3)]; a[(3, 0)], a[(3, 1)], a[(3, 2)], shifted_15];
    let determinant = bessemer::linear::kernels::determinant(&matrix);
    let mut inverse = matrix![1.0, 0.0, 0.0, 0.0; 0.0, 1.0, 0.0, 0.0; 0.0, 0.0, 1.0, 0.0; 0.0, 0.0, 0.0, 1.0];
    bessemer::solve_into(&matrix, &mut inverse);
    let minor = shifted_5 * shifted_10 - a[(2, 1)] * a[(1, 2)];
    let minor_d0 = shifted_10 + shifted_5;
    let minor_2 = a[(1, 0)] * shifted_10 - a[(2, 0)] * a[(1, 2)];
    let minor_3 = a[(1, 0)] * a[(2, 1)] - a[(2, 0)] * shifted_5;
    let minor_d0_2 = -a[(2, 0)];
    let result_0_d0 = determinant * (inverse[(0, 0)] + inverse[(1, 1)] + inverse[(2, 2)] + inverse[(3, 3)]);
    let result_1 = shifted_0 * minor - a[(0, 1)] * minor_2 + a[(0, 2)] * minor_3;
    let result_1_d0 = minor + shifted_0 * minor_d0 - a[(0, 1)] * a[(1, 0)] + a[(0, 2)] * minor_d0_2;
    let mut jacobian: SVector<f64, 2> = SVector::zeros();
    jacobian[0] = result_0_d0;
    jacobian[1] = result_1_d0;
    (vector![determinant, result_1], jacobian)
}

/// The solution of a system, refined once by its residual; zeros for a singular matrix.
#[function]
pub fn refined(a: &Matrix2<f64>, b: &Vector2<f64>) -> Vector2<f64> {
    let lu = a.lu();
    let x = lu.solve(b).unwrap_or(Vector2::zeros());
    let residual = b - a * x;
    x + lu.solve(&residual).unwrap_or(Vector2::zeros())
}

/// The solution with its Jacobian by the matrix.
#[function(derivative(refined, a))]
pub fn refined_jacobian(a: &Matrix2<f64>, b: &Vector2<f64>) -> (Vector2<f64>, SMatrix<f64, 2, 4>) {
    let mut solution = *b;
    let solved = bessemer::solve_into(a, &mut solution);
    let mut solution_d = matrix![-solution[0], 0.0, -solution[1], 0.0; 0.0, -solution[0], 0.0, -solution[1]];
    bessemer::solve_into(a, &mut solution_d);
    let x_0: f64;
    let x_0_d0: f64;
    let x_0_d1: f64;
    let x_0_d2: f64;
    let x_0_d3: f64;
    let x_1: f64;
    let x_1_d0: f64;
    let x_1_d1: f64;
    let x_1_d2: f64;
    let x_1_d3: f64;
    if solved {
        x_0 = solution[0];
        x_0_d0 = solution_d[(0, 0)];
        x_0_d1 = solution_d[(0, 1)];
        x_0_d2 = solution_d[(0, 2)];
        x_0_d3 = solution_d[(0, 3)];
        x_1 = solution[1];
        x_1_d0 = solution_d[(1, 0)];
        x_1_d1 = solution_d[(1, 1)];
        x_1_d2 = solution_d[(1, 2)];
        x_1_d3 = solution_d[(1, 3)];
    } else {
        x_0 = 0.0;
        x_0_d0 = 0.0;
        x_0_d1 = 0.0;
        x_0_d2 = 0.0;
        x_0_d3 = 0.0;
        x_1 = 0.0;
        x_1_d0 = 0.0;
        x_1_d1 = 0.0;
        x_1_d2 = 0.0;
        x_1_d3 = 0.0;
    }
    let residual_0 = a[(0, 1)] * x_1 + a[(0, 0)] * x_0;
    let residual_0_d0 = a[(0, 1)] * x_1_d0 + (x_0 + a[(0, 0)] * x_0_d0);
    let residual_0_d1 = a[(0, 1)] * x_1_d1 + a[(0, 0)] * x_0_d1;
    let residual_0_d2 = x_1 + a[(0, 1)] * x_1_d2 + a[(0, 0)] * x_0_d2;
    let residual_0_d3 = a[(0, 1)] * x_1_d3 + a[(0, 0)] * x_0_d3;
    let residual_1 = a[(1, 1)] * x_1 + a[(1, 0)] * x_0;
    let residual_1_d0 = a[(1, 1)] * x_1_d0 + a[(1, 0)] * x_0_d0;
    let residual_1_d1 = a[(1, 1)] * x_1_d1 + (x_0 + a[(1, 0)] * x_0_d1);
    let residual_1_d2 = a[(1, 1)] * x_1_d2 + a[(1, 0)] * x_0_d2;
    let residual_1_d3 = x_1 + a[(1, 1)] * x_1_d3 + a[(1, 0)] * x_0_d3;
    let residual_0_2 = b[0] - residual_0;
    let residual_0_d0_2 = -residual_0_d0;
    let residual_0_d1_2 = -residual_0_d1;
    let residual_0_d2_2 = -residual_0_d2;
    let residual_0_d3_2 = -residual_0_d3;
    let residual_1_2 = b[1] - residual_1;
    let residual_1_d0_2 = -residual_1_d0;
    let residual_1_d1_2 = -residual_1_d1;
    let residual_1_d2_2 = -residual_1_d2;
    let residual_1_d3_2 = -residual_1_d3;
    let mut solution_2 = vector![residual_0_2, residual_1_2];
    let solved_2 = bessemer::solve_into(a, &mut solution_2);
    let mut solution_d_2 = matrix![residual_0_d0_2 - solution_2[0], residual_0_d1_2, residual_0_d2_2 - solution_2[1], residual_0_d3_2; residual_1_d0_2, residual_1_d1_2 - solution_2[0], residual_1_d2_2, residual_1_d3_2 - solution_2[1]];
    bessemer::solve_into(a, &mut solution_d_2);
    let result_choice_0: f64;
    let result_choice_0_d0: f64;
    let result_choice_0_d1: f64;
    let result_choice_0_d2: f64;
    let result_choice_0_d3: f64;
    let result_choice_1: f64;
    let result_choice_1_d0: f64;
    let result_choice_1_d1: f64;
    let result_choice_1_d2: f64;
    let result_choice_1_d3: f64;
    if solved_2 {
        result_choice_0 = solution_2[0];
        result_choice_0_d0 = solution_d_2[(0, 0)];
        result_choice_0_d1 = solution_d_2[(0, 1)];
        result_choice_0_d2 = solution_d_2[(0, 2)];
        result_choice_0_d3 = solution_d_2[(0, 3)];
        result_choice_1 = solution_2[1];
        result_choice_1_d0 = solution_d_2[(1, 0)];
        result_choice_1_d1 = solution_d_2[(1, 1)];
        result_choice_1_d2 = solution_d_2[(1, 2)];
        result_choice_1_d3 = solution_d_2[(1, 3)];
    } else {
        result_choice_0 = 0.0;
        result_choice_0_d0 = 0.0;
        result_choice_0_d1 = 0.0;
        result_choice_0_d2 = 0.0;
        result_choice_0_d3 = 0.0;
        result_choice_1 = 0.0;
        result_choice_1_d0 = 0.0;
        result_choice_1_d1 = 0.0;
        result_choice_1_d2 = 0.0;
        result_choice_1_d3 = 0.0;
    }
    let result_0 = x_0 + result_choice_0;
    let result_0_d0 = x_0_d0 + result_choice_0_d0;
    let result_0_d1 = x_0_d1 + result_choice_0_d1;
    let result_0_d2 = x_0_d2 + result_choice_0_d2;
    let result_0_d3 = x_0_d3 + result_choice_0_d3;
    let result_1 = x_1 + result_choice_1;
    let result_1_d0 = x_1_d0 + result_choice_1_d0;
    let result_1_d1 = x_1_d1 + result_choice_1_d1;
    let result_1_d2 = x_1_d2 + result_choice_1_d2;
    let result_1_d3 = x_1_d3 + result_choice_1_d3;
    let mut jacobian: SMatrix<f64, 2, 4> = SMatrix::zeros();
    jacobian[(0, 0)] = result_0_d0;
    jacobian[(0, 1)] = result_0_d1;
    jacobian[(0, 2)] = result_0_d2;
    jacobian[(0, 3)] = result_0_d3;
    jacobian[(1, 0)] = result_1_d0;
    jacobian[(1, 1)] = result_1_d1;
    jacobian[(1, 2)] = result_1_d2;
    jacobian[(1, 3)] = result_1_d3;
    (vector![result_0, result_1], jacobian)
}

/// Solves in place, by a matrix that becomes its factors.
#[function]
pub fn solved_in_place(stiffness: f64, load: &Vector2<f32>) -> Vector2<f32> {
    let stiffness = stiffness as f32;
    let mut a = matrix![1.0 + stiffness, -stiffness; -stiffness, stiffness * 2.0];
    let mut x = *load;
    if bessemer::solve_mut(&mut a, &mut x) { x } else { *load }
}

/// The solution with its Jacobian by the load.
#[function(derivative(solved_in_place, load))]
pub fn solved_in_place_jacobian(
    stiffness: f64,
    load: &Vector2<f32>,
) -> (Vector2<f32>, Matrix2<f32>) {
    let stiffness_2 = stiffness as f32;
    let a_0 = 1.0 + stiffness_2;
    let a_1 = -stiffness_2;
    let a_2 = -stiffness_2;
    let a_3 = stiffness_2 * 2.0;
    let matrix = matrix![a_0, a_2; a_1, a_3];
    let mut factors = matrix;
    let mut solution = *load;
    let solved = bessemer::solve_mut(&mut factors, &mut solution);
    let mut solution_d = matrix![1.0, 0.0; 0.0, 1.0];
    bessemer::solve_into(&matrix, &mut solution_d);
    let result_0: f32;
    let result_0_d0: f32;
    let result_0_d1: f32;
    let result_1: f32;
    let result_1_d0: f32;
    let result_1_d1: f32;
    if solved {
        result_0 = solution[0];
        result_0_d0 = solution_d[(0, 0)];
        result_0_d1 = solution_d[(0, 1)];
        result_1 = solution[1];
        result_1_d0 = solution_d[(1, 0)];
        result_1_d1 = solution_d[(1, 1)];
    } else {
        result_0 = load[0];
        result_0_d0 = 1.0;
        result_0_d1 = 0.0;
        result_1 = load[1];
        result_1_d0 = 0.0;
        result_1_d1 = 1.0;
    }
    let mut jacobian: SMatrix<f32, 2, 2> = SMatrix::zeros();
    jacobian[(0, 0)] = result_0_d0;
    jacobian[(0, 1)] = result_0_d1;
    jacobian[(1, 0)] = result_1_d0;
    jacobian[(1, 1)] = result_1_d1;
    (vector![result_0, result_1], jacobian)
}
