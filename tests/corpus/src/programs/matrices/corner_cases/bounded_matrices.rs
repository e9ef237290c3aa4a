//! Bounded matrices by value, in structs, compared, added and indexed.

use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Plan {
    pub weights: BoundedMatrix<f32, 2, 3>,
    pub bias: f32,
}

#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Planner {
    plan: Plan,
    before: BoundedMatrix<f32, 2, 3>,
}

#[component]
impl Planner {
    #[entry]
    pub fn set(&mut self, rows: usize, columns: usize, value: f32) -> bool {
        self.before = self.plan.weights;
        self.plan.weights = BoundedMatrix::new(rows % 4, columns % 4);
        self.plan.weights.fill(value);
        self.plan.weights == self.before
    }

    #[entry]
    pub fn grow(&mut self, rows: usize, columns: usize, value: f32) -> usize {
        self.plan.weights.resize(rows % 3, columns % 4, value);
        self.plan.weights.nrows() * 10 + self.plan.weights.ncols()
    }

    #[entry]
    pub fn change(&mut self, row: usize, column: usize, by: f32) -> f32 {
        self.plan.weights[(row % 3, column % 3)] += by;
        self.plan.weights[(0, 0)] + self.plan.bias
    }

    #[entry]
    pub fn added(&mut self) -> f32 {
        let sum = self.plan.weights + self.before - self.plan.weights * 0.5;
        let mut total = 0.0;
        for column in 0..sum.ncols() {
            for row in 0..sum.nrows() {
                total += sum[(row, column)];
            }
        }
        total
    }

    #[entry]
    pub fn parts(&mut self, at: usize) -> f32 {
        let row = self.plan.weights.row(at % 3);
        let mut total = row.iter().sum::<f32>();
        for value in &self.plan.weights.column(at % 4) {
            total += value;
        }
        total
    }

    #[entry]
    pub fn through(&mut self, x: &Vector3<f32>) -> Vector2<f32> {
        self.plan.weights * *x
    }
}

#[function]
pub fn of_matrix(m: &SMatrix<f64, 2, 3>) -> BoundedMatrix<f64, 3, 3> {
    BoundedMatrix::from_matrix(m)
}
