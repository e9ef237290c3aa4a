//! Results and arguments of every size and kind.

use bessemer::prelude::*;

#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Deep {
    pub flags: [[bool; 2]; 3],
    pub small: f32,
    pub m: [Matrix2<f64>; 2],
    pub wide: i64,
}

#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Shapes {
    pub deep: Deep,
    pub deeps: [Deep; 2],
    pub one: SMatrix<f32, 1, 1>,
    pub row: SMatrix<f64, 1, 3>,
    pub n: isize,
}

const CHOICES: [Deep; 2] = [
    Deep {
        flags: [[true; 2]; 3],
        small: 0.1,
        m: [Matrix2::new(1.0, 2.0, 3.0, 4.0); 2],
        wide: i64::MIN,
    },
    Deep {
        flags: [[false; 2]; 3],
        small: -0.0,
        m: [Matrix2::new(5.0, 6.0, 7.0, 8.0); 2],
        wide: i64::MAX,
    },
];
const HUGE: f64 = f64::INFINITY;
const LOST: f64 = f64::NAN;
const TINY: f32 = f32::MIN_POSITIVE / 4.0;

#[function]
fn pick(b: bool, deep: &Deep) -> Deep {
    if b { *deep } else { CHOICES[1] }
}

#[function]
fn grid(of: [[u8; 3]; 2]) -> [[u8; 3]; 2] {
    let mut grid = of;
    grid[0] = of[1];
    grid[1] = of[0];
    grid
}

#[component]
impl Shapes {
    #[entry]
    pub fn deep(&mut self, i: usize, b: bool) -> Deep {
        self.deeps[i] = CHOICES[i];
        self.deep = pick(b, &self.deep);
        self.deeps[1 - i].flags[i + 1][i] = self.deep.wide > self.deeps[0].wide;
        self.deeps[i].m[i][(1, i)] += self.deep.m[1 - i][(i, 0)];
        pick(!b, &self.deeps[i])
    }

    #[entry]
    pub fn grids(&mut self, given: [[u8; 3]; 2], i: usize, j: usize) -> [[u8; 3]; 2] {
        let mut mine = grid(given);
        mine[i][j] += given[1 - i][2 - j];
        mine[i] = grid(mine)[j];
        mine
    }

    #[entry(infallible)]
    pub fn thin(&mut self, x: f32, v: &SMatrix<f64, 1, 3>) -> SMatrix<f32, 1, 1> {
        self.one = self.one * SMatrix::<f32, 1, 1>::from_element(x) + self.one;
        self.row = v.transpose().transpose() * 2.0 - self.row;
        self.row[1] = (v * v.transpose())[(0, 0)];
        self.row[(0, 2)] = -HUGE + LOST;
        self.row[0] += 1.0e-320;
        self.one[0] += TINY;
        self.one
    }

    #[entry]
    pub fn words(&mut self, a: i8, b: u16, c: i64, d: f32, e: f64) -> i64 {
        self.n = a as isize - 1;
        let x = (a as u8 as i16) << (b & 15) >> 3;
        let y = (c >> (b & 63)) as i32 as i64;
        let z = d as i8 as i64 + e as u64 as i64;
        let w = (e as f32 as f64 as i32 as u8 as f32) as i64;
        let v = !c & -5 ^ (b as i64) | 1 << (b & 7);
        let u = (-a).abs() as i64 % (b as i64 + 1) / -3;
        let t = (d.to_bits() as f32).min(d).max(-d) as i64;
        let s = ((a as i32 - b as i32) * 3 - (a as i32 - (b as i32 - 4))) as i64;
        x as i64 ^ y ^ z ^ w ^ v ^ u ^ t ^ s
    }

    #[entry(infallible)]
    pub fn floats(&mut self, a: f64, b: f64, c: f64) -> [f64; 8] {
        [
            a - (b - c),
            a / (b * c),
            -(-a),
            -(a - b) * (c + a) / (b + c),
            a - -b,
            (a < b) as u8 as f64,
            if a != a { -1.0 } else { b % c },
            a.max(b).min(c).copysign(b - c),
        ]
    }

    #[entry]
    pub fn shifted(&mut self, a: i8, b: i16, c: i32, n: u8) -> i32 {
        self.n = ((a >> n) as isize) - ((a << n) as isize);
        (b >> n) as i32 ^ (b << n) as i32 ^ (c >> n) ^ (c << n)
    }

    /// A matrix written by rows; nalgebra stores it by columns.
    #[entry(infallible)]
    pub fn built(&self, a: f64, b: f64) -> SMatrix<f64, 2, 3> {
        SMatrix::<f64, 2, 3>::new(a, b, 1.0, 2.0, a - b, 3.0)
    }

    #[entry]
    pub fn asserted(&self, a: f64, b: f64) -> f64 {
        assert!(a < b);
        assert!(a == a && self.n != 3, "must not be {}", 3);
        1.0f64.clamp(a, b)
    }
}

/// The Jacobian of a distance and a bearing.
#[function]
pub fn jacobian(x: f64, y: f64) -> bessemer::nalgebra::Matrix2x4<f64> {
    let range = (x * x + y * y).sqrt();
    bessemer::nalgebra::Matrix2x4::new(x / range, y / range, 0.0, 0.0, -y, x, 0.0, 1.0)
}
