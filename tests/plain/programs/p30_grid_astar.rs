//! A* on an 8 × 8 occupancy grid held in one word, for the line-following robot.

use core::ops::Index;

/// A cell, both coordinates below eight.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cell {
    x: u8,
    y: u8,
}

impl Cell {
    pub const fn new(x: u8, y: u8) -> Option<Self> {
        if x < Grid::SIZE && y < Grid::SIZE { Some(Self { x, y }) } else { None }
    }

    fn index(self) -> usize {
        usize::from(self.y * Grid::SIZE + self.x)
    }

    fn manhattan(self, other: Self) -> u8 {
        self.x.abs_diff(other.x) + self.y.abs_diff(other.y)
    }

    fn neighbours(self) -> impl Iterator<Item = Self> {
        const STEPS: [(i8, i8); 4] = [(1, 0), (0, 1), (-1, 0), (0, -1)];
        STEPS.into_iter().filter_map(move |(dx, dy)| {
            Self::new(self.x.checked_add_signed(dx)?, self.y.checked_add_signed(dy)?)
        })
    }
}

/// Obstacles, one bit per cell.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Grid(u64);

impl Grid {
    pub const SIZE: u8 = 8;
    const CELLS: usize = 64;

    /// From a drawing, `#` being an obstacle.
    pub fn from_rows(rows: [&str; 8]) -> Self {
        rows.iter()
            .enumerate()
            .flat_map(|(y, row)| row.bytes().take(8).enumerate().map(move |(x, b)| (x, y, b)))
            .filter(|&(.., b)| b == b'#')
            .fold(Self::default(), |Self(bits), (x, y, _)| Self(bits | 1 << (8 * y + x)))
    }

    pub fn is_blocked(&self, cell: Cell) -> bool {
        self.0 >> cell.index() & 1 == 1
    }

    pub fn block(&mut self, cell: Cell) {
        self.0 |= 1 << cell.index();
    }
}

/// Cells from start to goal inclusive.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Path {
    cells: [Cell; Grid::CELLS],
    len: usize,
}

impl Path {
    pub fn as_slice(&self) -> &[Cell] {
        &self.cells[..self.len]
    }

    /// Number of moves.
    pub fn moves(&self) -> usize {
        self.len.saturating_sub(1)
    }

    /// Changes of direction on the way.
    pub fn turns(&self) -> usize {
        self.as_slice()
            .windows(3)
            .filter(|w| matches!(w, [a, _, c] if a.x != c.x && a.y != c.y))
            .count()
    }
}

impl Index<usize> for Path {
    type Output = Cell;
    fn index(&self, i: usize) -> &Cell {
        &self.as_slice()[i]
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PlanError {
    StartBlocked,
    GoalBlocked,
    NoWay { reachable: u32 },
}

#[derive(Clone, Copy, Debug)]
struct Node {
    cost: u8,
    parent: Option<Cell>,
}

/// Finds a shortest path with unit steps.
pub fn plan(grid: &Grid, start: Cell, goal: Cell) -> Result<Path, PlanError> {
    match (grid.is_blocked(start), grid.is_blocked(goal)) {
        (true, _) => return Err(PlanError::StartBlocked),
        (_, true) => return Err(PlanError::GoalBlocked),
        _ => {}
    }

    let mut nodes: [Option<Node>; Grid::CELLS] = [None; Grid::CELLS];
    nodes[start.index()] = Some(Node { cost: 0, parent: None });
    let mut open = Grid::default();
    open.block(start);
    let mut closed = 0_u64;

    while let Some(cell) = cheapest(&open, &nodes, goal) {
        if cell == goal {
            return Ok(trace_back(&nodes, goal));
        }
        open.0 &= !(1 << cell.index());
        closed |= 1 << cell.index();
        let Some(Node { cost, .. }) = nodes[cell.index()] else { continue };

        for next in cell.neighbours().filter(|&n| !grid.is_blocked(n)) {
            let better = nodes[next.index()].is_none_or(|known| cost + 1 < known.cost);
            if better {
                nodes[next.index()] = Some(Node { cost: cost + 1, parent: Some(cell) });
                open.block(next);
            }
        }
    }
    Err(PlanError::NoWay { reachable: closed.count_ones() })
}

/// Open cell with the least cost plus heuristic; nearer to the goal wins ties.
fn cheapest(open: &Grid, nodes: &[Option<Node>; Grid::CELLS], goal: Cell) -> Option<Cell> {
    (0..Grid::SIZE)
        .flat_map(|y| (0..Grid::SIZE).filter_map(move |x| Cell::new(x, y)))
        .filter(|&c| open.is_blocked(c))
        .filter_map(|c| nodes[c.index()].map(|n| (c, n.cost)))
        .min_by_key(|&(c, cost)| {
            let h = c.manhattan(goal);
            (cost + h, h)
        })
        .map(|(c, _)| c)
}

fn trace_back(nodes: &[Option<Node>; Grid::CELLS], goal: Cell) -> Path {
    let mut path = Path { cells: [Cell::default(); Grid::CELLS], len: 0 };
    let back = core::iter::successors(Some(goal), |c| nodes[c.index()].and_then(|n| n.parent));
    for (slot, cell) in path.cells.iter_mut().zip(back) {
        *slot = cell;
        path.len += 1;
    }
    path.cells[..path.len].reverse();
    path
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(x: u8, y: u8) -> Cell {
        Cell::new(x, y).unwrap()
    }

    #[test]
    fn straight_and_trivial() {
        let grid = Grid::default();
        let path = plan(&grid, at(0, 0), at(7, 7)).unwrap();
        assert_eq!(path.moves(), 14);
        assert_eq!((path[0], path[14]), (at(0, 0), at(7, 7)));
        assert!(path.as_slice().windows(2).all(|w| w[0].manhattan(w[1]) == 1));
        assert_eq!(plan(&grid, at(3, 3), at(3, 3)).unwrap().moves(), 0);
    }

    #[test]
    fn goes_round_a_wall() {
        let grid = Grid::from_rows([
            "........",
            ".######.",
            "......#.",
            "#####.#.",
            "......#.",
            ".######.",
            "........",
            "........",
        ]);
        let path = plan(&grid, at(0, 4), at(0, 2)).unwrap();
        assert_eq!((path.moves(), path.turns()), (12, 2));
        let wall = at(5, 3);
        assert!(path.as_slice().contains(&wall));
    }

    #[test]
    fn shut_in() {
        let mut grid = Grid::from_rows([".#......", "#.......", "", "", "", "", "", ""]);
        assert_eq!(plan(&grid, at(0, 0), at(5, 5)), Err(PlanError::NoWay { reachable: 1 }));
        grid.block(at(5, 5));
        assert_eq!(plan(&grid, at(7, 7), at(5, 5)), Err(PlanError::GoalBlocked));
        assert!(Cell::new(8, 0).is_none());
    }
}
