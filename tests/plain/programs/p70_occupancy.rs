//! Occupancy grid with log-odds cells, ray casting and obstacle inflation.

#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Cell {
    pub x: i32,
    pub y: i32,
}

impl Cell {
    pub const fn new(x: i32, y: i32) -> Self {
        Self { x, y }
    }

    fn indices(self) -> Option<(usize, usize)> {
        Some((self.x.try_into().ok()?, self.y.try_into().ok()?))
    }
}

/// Cells of a line, both ends included.
#[derive(Debug, Clone)]
pub struct Bresenham {
    current: Cell,
    end: Cell,
    dx: i32,
    dy: i32,
    step: Cell,
    error: i32,
    done: bool,
}

impl Bresenham {
    pub fn new(start: Cell, end: Cell) -> Self {
        let dx = (end.x - start.x).abs();
        let dy = -(end.y - start.y).abs();
        Self {
            current: start,
            end,
            dx,
            dy,
            step: Cell::new((end.x - start.x).signum(), (end.y - start.y).signum()),
            error: dx + dy,
            done: false,
        }
    }
}

impl Iterator for Bresenham {
    type Item = Cell;

    fn next(&mut self) -> Option<Cell> {
        if self.done {
            return None;
        }
        let cell = self.current;
        self.done = cell == self.end;

        let doubled = 2 * self.error;
        if doubled >= self.dy {
            self.error += self.dy;
            self.current.x += self.step.x;
        }
        if doubled <= self.dx {
            self.error += self.dx;
            self.current.y += self.step.y;
        }
        Some(cell)
    }
}

#[derive(Clone)]
pub struct Grid<const W: usize, const H: usize> {
    log_odds: [[i8; W]; H],
}

impl<const W: usize, const H: usize> Grid<W, H> {
    const HIT: i8 = 18;
    const MISS: i8 = -6;
    const LIMIT: i8 = 100;
    const DECISION: i8 = 12;

    pub const fn new() -> Self {
        Self { log_odds: [[0; W]; H] }
    }

    fn get(&self, cell: Cell) -> Option<i8> {
        let (x, y) = cell.indices()?;
        self.log_odds.get(y)?.get(x).copied()
    }

    pub fn is_occupied(&self, cell: Cell) -> bool {
        self.get(cell).is_some_and(|v| v >= Self::DECISION)
    }

    pub fn is_free(&self, cell: Cell) -> bool {
        self.get(cell).is_some_and(|v| v <= -Self::DECISION)
    }

    fn update(&mut self, cell: Cell, change: i8) {
        let Some((x, y)) = cell.indices() else { return };
        if let Some(value) = self.log_odds.get_mut(y).and_then(|row| row.get_mut(x)) {
            *value = value.saturating_add(change).clamp(-Self::LIMIT, Self::LIMIT);
        }
    }

    /// Enters a range measurement: free along the beam, occupied at its end
    /// unless the sensor just ran out of range.
    pub fn integrate(&mut self, sensor: Cell, end: Cell, hit: bool) {
        Bresenham::new(sensor, end)
            .take_while(|&cell| cell != end)
            .for_each(|cell| self.update(cell, Self::MISS));
        self.update(end, if hit { Self::HIT } else { Self::MISS });
    }

    /// First occupied cell on the way from `from` towards `to`.
    pub fn cast_ray(&self, from: Cell, to: Cell) -> Option<Cell> {
        Bresenham::new(from, to)
            .take_while(|&cell| self.get(cell).is_some())
            .find(|&cell| self.is_occupied(cell))
    }

    pub fn occupied(&self) -> impl Iterator<Item = Cell> + '_ {
        (0..H as i32)
            .flat_map(|y| (0..W as i32).map(move |x| Cell::new(x, y)))
            .filter(|&cell| self.is_occupied(cell))
    }

    /// Grid in which obstacles are grown by a disc of `radius` cells.
    pub fn inflated(&self, radius: i32) -> Self {
        let mut grown = self.clone();
        for centre in self.occupied() {
            for cell in disc(centre, radius) {
                grown.update(cell, i8::MAX);
            }
        }
        grown
    }
}

fn disc(centre: Cell, radius: i32) -> impl Iterator<Item = Cell> {
    let range = -radius..=radius;
    range
        .clone()
        .flat_map(move |dy| range.clone().map(move |dx| (dx, dy)))
        .filter(move |(dx, dy)| dx * dx + dy * dy <= radius * radius)
        .map(move |(dx, dy)| Cell::new(centre.x + dx, centre.y + dy))
}
