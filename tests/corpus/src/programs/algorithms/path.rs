//! The shortest path through a grid with walls (A* with the city-block distance; open cells in a flat array).

use bessemer::prelude::*;

/// Number of columns of the grid.
pub const COLUMNS: usize = 4;
/// Number of cells of the grid.
pub const CELLS: usize = 12;

/// Number of steps from the first cell to the last, if there is a path; a cell with `true` is a wall.
#[function]
pub fn steps(walls: &[bool; CELLS]) -> Option<u8> {
    const FAR: u8 = 255;
    let mut cost = [FAR; CELLS];
    let mut open = [false; CELLS];
    cost[0] = 0;
    open[0] = true;
    for _ in 0..CELLS {
        let mut best = CELLS;
        let mut least = FAR;
        for cell in 0..CELLS {
            let left = 3 - cell % COLUMNS + 2 - cell / COLUMNS;
            let whole = cost[cell].saturating_add(left as u8);
            if open[cell] && whole < least {
                best = cell;
                least = whole;
            }
        }
        if best >= CELLS {
            return None;
        }
        if best == CELLS - 1 {
            return Some(cost[best]);
        }
        open[best] = false;
        let next = cost[best].saturating_add(1);
        let (row, column) = (best / COLUMNS, best % COLUMNS);
        let ways = [
            (column > 0, best.wrapping_sub(1)),
            (column < COLUMNS - 1, best + 1),
            (row > 0, best.wrapping_sub(COLUMNS)),
            (row < 2, best + COLUMNS),
        ];
        for (possible, cell) in ways {
            if possible && cell < CELLS && !walls[cell] && next < cost[cell] {
                cost[cell] = next;
                open[cell] = true;
            }
        }
    }
    None
}
