//! Views that are written through a name, or by a method: `let mut part = m.column_mut(j); part += &v;`.

use bessemer::prelude::*;

/// Integrates an acceleration to the velocity of a state, and the velocity to its position.
#[function]
pub fn advance(state: &mut SVector<f64, 6>, acceleration: &Vector3<f64>, period: f64) {
    let way = state.fixed_rows::<3>(3) * period + acceleration * (0.5 * period * period);
    let mut position = state.fixed_rows_mut::<3>(0);
    position += way;
    let mut velocity = state.fixed_rows_mut::<3>(3);
    velocity += acceleration * period;
}

/// Changes a block and then reads it.
#[function]
pub fn changed(covariance: &mut Matrix4<f64>, noise: &Matrix2<f64>, least: f64) -> f64 {
    let mut block = covariance.fixed_view_mut::<2, 2>(0, 2);
    block += noise;
    block *= 2.0;
    if block[(0, 0)] < least {
        block[(0, 0)] = least;
    }
    block.trace()
}

/// The position of a view is checked at its `let`; the function may return while the view is in scope.
#[function]
pub fn up_to(m: &mut Matrix4<f64>, column: usize, by: &Vector4<f64>, most: f64) -> Option<f64> {
    let mut part = m.column_mut(column);
    part += by;
    let first = Some(part[0]).filter(|first| *first <= most)?;
    part *= first;
    for i in 0..4 {
        if i == 2 {
            continue;
        }
        part[i] -= by[i];
    }
    Some(part.sum())
}

/// Names every column and then every row.
#[function]
pub fn scaled(m: &mut SMatrix<f64, 2, 3>, by: &Vector2<f64>) {
    for mut column in m.column_iter_mut() {
        column += by;
        column[1] = 0.5;
    }
    for (i, mut row) in m.row_iter_mut().enumerate() {
        row *= by[i];
    }
}

/// Methods that change a view, and elements of a view.
#[function]
pub fn by_methods(m: &mut Matrix3<f64>, v: &Vector3<f64>, a: &Matrix2<f64>) -> f64 {
    let length = m.column_mut(0).normalize_mut();
    m.column_mut(1).zip_apply(v, |x, y| *x += y);
    m.fixed_view_mut::<2, 2>(1, 1).gemm(2.0, a, a, 0.5);
    m.row_mut(2)[0] = length;
    m.column_mut(2)[1] += v.x;
    for x in m.row_mut(0).iter_mut() {
        *x *= 0.5;
    }
    length
}

/// Chains over columns and rows.
#[function]
pub fn lengths(m: &Matrix3<f32>) -> (f32, f32) {
    let columns = m.column_iter().map(|column| column.norm()).sum();
    (columns, m.row_iter().map(|row| row.amax()).fold(0.0, f32::max))
}

/// A view next to another field of the same struct.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Filter {
    covariance: SMatrix<f64, 4, 4>,
    noise: SVector<f64, 2>,
}

#[component]
impl Filter {
    /// Adds noise to a diagonal; returns the number of variances beyond a limit.
    #[entry]
    pub fn grow(&mut self, from: usize, limit: f64) -> u32 {
        let mut count = 0;
        let mut block = self.covariance.fixed_view_mut::<2, 2>(from, from);
        for i in 0..2 {
            block[(i, i)] += self.noise[i];
            if block[(i, i)] > limit {
                count += 1;
            }
        }
        self.noise.x += 0.125;
        self.covariance[(0, 3)] = f64::from(count);
        count
    }
}
