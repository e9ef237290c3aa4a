//! Bounded matrices of integers and of `bool`, and operations on their rows and columns.

use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Map {
    pub free: BoundedMatrix<bool, 3, 2>,
    pub cost: BoundedMatrix<i16, 2, 3>,
}

#[data]
pub type Costs = BoundedMatrix<i16, 2, 3>;

#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mapper {
    map: Map,
}

#[component]
impl Mapper {
    #[entry]
    pub fn resize(&mut self, rows: usize, columns: usize, free: bool) -> usize {
        self.map.free.resize(rows % 5, columns % 3, free);
        self.map.cost.resize(columns % 3, rows % 4, 7);
        self.map.free.len() * 10 + self.map.cost.len()
    }

    #[entry]
    pub fn block(&mut self, row: usize, column: usize) -> bool {
        let before = self.map.free[(row % 4, column % 3)];
        self.map.free[(row % 4, column % 3)] = !before;
        before
    }

    #[entry]
    pub fn longer(&mut self, row: &[i16; 3], by: usize) -> bool {
        self.map.cost.push_row(&row[..by % 4]);
        self.map.cost.is_empty()
    }

    #[entry]
    pub fn wider(&mut self, column: &[i16; 2]) -> i16 {
        self.map.cost.push_column(column);
        self.map.cost[(1, 0)]
    }

    #[entry]
    pub fn shorter(&mut self) -> i16 {
        match self.map.cost.pop_row() {
            Some(row) if row.len() > 1 => row[1],
            Some(_) => 1,
            None => 0,
        }
    }

    #[entry]
    pub fn narrower(&mut self) -> Option<List<i16, 2>> {
        self.map.cost.pop_column()
    }

    #[entry]
    pub fn doubled(&mut self) -> i16 {
        let cost = self.map.cost;
        self.map.cost = cost + cost - cost * 3;
        let mut most = 0;
        for column in 0..self.map.cost.ncols() {
            for x in &self.map.cost.column(column) {
                most = most.max(*x);
            }
        }
        most.wrapping_add(self.map.cost.sum())
    }

    #[entry]
    pub fn around(&mut self, row: usize, column: usize) -> i16 {
        let part = self.map.cost.view(row % 3, column % 4, 1, 2);
        part[(0, 1)]
    }

    #[entry]
    pub fn cleared(&mut self, really: bool) -> bool {
        let before = self.map;
        if really {
            self.map.cost.clear();
        }
        self.map == before
    }

    #[entry]
    pub fn whole(&mut self, other: &SMatrix<i16, 2, 2>) -> Option<SMatrix<i16, 2, 2>> {
        let sum = self.map.cost + Costs::from_matrix(other);
        sum.to_matrix::<2, 2>()
    }
}
