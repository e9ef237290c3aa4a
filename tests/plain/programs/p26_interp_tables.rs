//! Interpolation tables: one- and two-dimensional, on ascending breakpoints,
//! with a choice of what to do outside and an inverse for monotonic curves.

/// Behaviour outside the table.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Outside {
    #[default]
    Hold,
    Extrapolate,
    Refuse,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axis<const N: usize> {
    points: [f32; N],
    outside: Outside,
}

/// Segment number and the fraction within it.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Place {
    index: usize,
    fraction: f32,
}

impl<const N: usize> Axis<N> {
    /// `None` unless the points are finite and strictly ascending.
    pub fn new(points: [f32; N], outside: Outside) -> Option<Self> {
        const { assert!(N >= 2, "an axis needs at least two points") };
        let ascending = points.windows(2).all(|w| w[0] < w[1]);
        (ascending && points.iter().all(|p| p.is_finite())).then_some(Self { points, outside })
    }

    fn locate(&self, x: f32) -> Option<Place> {
        if x.is_nan() {
            return None;
        }
        let index = self.points.partition_point(|&p| p <= x).clamp(1, N - 1) - 1;
        let [left, right] = [self.points[index], self.points[index + 1]];
        let fraction = (x - left) / (right - left);
        let inside = (0.0..=1.0).contains(&fraction);
        let fraction = match self.outside {
            _ if inside => fraction,
            Outside::Hold => fraction.clamp(0.0, 1.0),
            Outside::Extrapolate => fraction,
            Outside::Refuse => return None,
        };
        Some(Place { index, fraction })
    }
}

fn lerp(a: f32, b: f32, t: f32) -> f32 {
    a + t * (b - a)
}

/// `y = f(x)` on `N` points.
#[derive(Clone, Debug)]
pub struct Table1<const N: usize> {
    x: Axis<N>,
    y: [f32; N],
}

impl<const N: usize> Table1<N> {
    pub const fn new(x: Axis<N>, y: [f32; N]) -> Self {
        Self { x, y }
    }

    pub fn get(&self, x: f32) -> Option<f32> {
        let Place { index, fraction } = self.x.locate(x)?;
        Some(lerp(self.y[index], self.y[index + 1], fraction))
    }

    /// Slope of the segment that holds `x`.
    pub fn slope(&self, x: f32) -> Option<f32> {
        let Place { index, .. } = self.x.locate(x)?;
        let dx = self.x.points[index + 1] - self.x.points[index];
        Some((self.y[index + 1] - self.y[index]) / dx)
    }

    /// Swaps the axes; works for rising and falling curves.
    pub fn inverse(&self) -> Option<Self> {
        let (mut x, mut y) = (self.y, self.x.points);
        if x.first() > x.last() {
            x.reverse();
            y.reverse();
        }
        Some(Self { x: Axis::new(x, self.x.outside)?, y })
    }

    /// Area under the curve between its ends.
    pub fn integral(&self) -> f32 {
        self.x
            .points
            .windows(2)
            .zip(self.y.windows(2))
            .map(|(x, y)| 0.5 * (y[0] + y[1]) * (x[1] - x[0]))
            .sum()
    }
}

/// `z = f(row, column)` on an `R` × `C` grid, bilinear.
#[derive(Clone, Debug)]
pub struct Table2<const R: usize, const C: usize> {
    rows: Axis<R>,
    columns: Axis<C>,
    z: [[f32; C]; R],
}

impl<const R: usize, const C: usize> Table2<R, C> {
    pub const fn new(rows: Axis<R>, columns: Axis<C>, z: [[f32; C]; R]) -> Self {
        Self { rows, columns, z }
    }

    /// Fills the grid from a function of the breakpoints.
    pub fn from_fn(rows: Axis<R>, columns: Axis<C>, f: impl Fn(f32, f32) -> f32) -> Self {
        let z = rows.points.map(|r| columns.points.map(|c| f(r, c)));
        Self { rows, columns, z }
    }

    pub fn get(&self, row: f32, column: f32) -> Option<f32> {
        let (r, c) = self.rows.locate(row).zip(self.columns.locate(column))?;
        let along = |row: &[f32; C]| lerp(row[c.index], row[c.index + 1], c.fraction);
        let [low, high] = [r.index, r.index + 1].map(|i| along(&self.z[i]));
        Some(lerp(low, high, r.fraction))
    }
}

/// NTC divider reading (counts) to temperature.
pub fn ntc_table() -> Option<Table1<6>> {
    const COUNTS: [f32; 6] = [310.0, 720.0, 1400.0, 2200.0, 2900.0, 3500.0];
    const CELSIUS: [f32; 6] = [110.0, 80.0, 50.0, 25.0, 5.0, -20.0];
    Axis::new(COUNTS, Outside::Hold).map(|x| Table1::new(x, CELSIUS))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ntc_and_its_inverse() {
        let ntc = ntc_table().unwrap();
        assert_eq!(ntc.get(1800.0), Some(37.5));
        assert_eq!(ntc.get(0.0), Some(110.0));
        assert_eq!(ntc.get(f32::NAN), None);
        let back = ntc.inverse().unwrap();
        assert!((back.get(37.5).unwrap() - 1800.0).abs() < 1e-2);
        assert!(ntc.slope(1800.0).is_some_and(|s| (s + 25.0 / 800.0).abs() < 1e-6));
    }

    #[test]
    fn outside_policies() {
        let square = |outside| {
            Table1::new(Axis::new([0.0, 1.0, 2.0], outside).unwrap(), [0.0, 1.0, 4.0])
        };
        assert_eq!(square(Outside::Hold).get(3.0), Some(4.0));
        assert_eq!(square(Outside::Extrapolate).get(3.0), Some(7.0));
        assert_eq!(square(Outside::Refuse).get(-0.1), None);
        assert_eq!(square(Outside::Refuse).get(2.0), Some(4.0));
        assert_eq!(square(Outside::default()).integral(), 3.0);
        assert_eq!(Axis::new([0.0, 0.0], Outside::Hold), None);
    }

    #[test]
    fn bilinear_reproduces_a_bilinear_function() {
        let rows = Axis::new([0.0, 1.0, 3.0], Outside::Extrapolate).unwrap();
        let columns = Axis::new([-1.0, 2.0], Outside::Hold).unwrap();
        let f = |r: f32, c: f32| 2.0 + r - 0.5 * c + 0.25 * r * c;
        let table = Table2::from_fn(rows, columns, f);
        for (r, c) in [(0.5, 0.0), (2.9, 1.5), (4.0, -0.5)] {
            assert!((table.get(r, c).unwrap() - f(r, c)).abs() < 1e-5);
        }
        assert_eq!(table.get(1.0, 99.0), table.get(1.0, 2.0));
    }
}
