//! Points at which the functions are measured: typical points, every magnitude, and difficult cases.
//!
//! Uses only the standard library, since `bench` compares the bits of every leg on the same points.

/// A function and the range of its arguments.
pub struct Domain {
    /// Name of the function in Rust, in double precision.
    pub name: &'static str,
    /// Range of most points, for each argument.
    pub range: [(f64, f64); 2],
}

const fn one(name: &'static str, range: (f64, f64)) -> Domain {
    Domain { name, range: [range, (0.0, 1.0)] }
}

const fn two(name: &'static str, range: [(f64, f64); 2]) -> Domain {
    Domain { name, range }
}

const TURNS: f64 = 12.5;

/// All functions.
pub const DOMAINS: &[Domain] = &[
    one("sin", (-TURNS, TURNS)),
    one("cos", (-TURNS, TURNS)),
    one("tan", (-TURNS, TURNS)),
    one("asin", (-1.0, 1.0)),
    one("acos", (-1.0, 1.0)),
    one("atan", (-8.0, 8.0)),
    two("atan2", [(-2.0, 2.0); 2]),
    one("exp", (-745.2, 710.0)),
    one("exp2", (-1075.0, 1024.0)),
    one("exp_m1", (-3.0, 3.0)),
    one("ln", (0.0, 4.0)),
    one("log2", (0.0, 4.0)),
    one("log10", (0.0, 4.0)),
    one("ln_1p", (-1.0, 3.0)),
    one("sinh", (-25.0, 25.0)),
    one("cosh", (-25.0, 25.0)),
    one("tanh", (-3.0, 3.0)),
    two("powf", [(0.0, 10.0), (-100.0, 100.0)]),
    one("cbrt", (-10.0, 10.0)),
    two("hypot", [(-2.0, 2.0); 2]),
];

impl Domain {
    /// Returns true if multiples of π/2 are hard.
    fn is_periodic(&self) -> bool {
        self.range[0].1 == TURNS
    }
}

/// Number of sequences, seeded from 0 on, that form the points of one function.
pub const SEQUENCES: u64 = 2;

/// A repeatable sequence of points.
pub struct Points {
    state: u64,
}

/// π/2 in fixed point: 64 integer bits, 256 fractional bits.
const HALF_PI: [u64; 5] =
    [1, 0x921f_b544_42d1_8469, 0x898c_c517_01b8_39a2, 0x5204_9c11_14cf_98e8, 0x0417_7d4c_7627_3644];

/// The double nearest to a multiple of π/2.
fn quarter_turns(turns: u64) -> f64 {
    if turns == 0 {
        return 0.0;
    }
    let mut product = [0u64; 6];
    let mut carry = 0u128;
    for n in (0..5).rev() {
        let wide = u128::from(HALF_PI[n]) * u128::from(turns) + carry;
        product[n + 1] = wide as u64;
        carry = wide >> 64;
    }
    product[0] = carry as u64;
    let first = if product[0] == 0 { 1 } else { 0 };
    let shift = product[first].leading_zeros();
    let upper = u128::from(product[first]) << 64 | u128::from(product[first + 1]);
    // What is behind these 64 bits is never 0, and rounds like a last bit of 1.
    let top = ((upper << shift) >> 64) as u64 | 1;
    let places = 64 * (5 - first as i32) - 256 - shift as i32;
    top as f64 * 2f64.powi(places)
}

/// Special points for every function.
const SPECIAL: &[f64] = &[
    0.0,
    -0.0,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::NAN,
    1.0,
    -1.0,
    0.5,
    2.0,
    10.0,
    f64::MIN_POSITIVE,
    -f64::MIN_POSITIVE,
    f64::MAX,
    f64::MIN,
    5e-324,
    -5e-324,
    2.225073858507201e-308,
    1e22,
    1e300,
    0.125,
    0.25,
    22.0,
    750.0,
    // The doubles nearest to multiples of π/2 (Muller, Elementary Functions, chapter 11).
    5.319372648326541e255,
    6.134899525417045e17,
    7.12e18,
    709.782712893384,
    710.4758600739439,
    -745.1332191019411,
    -708.3964185322641,
    1_600_000.0,
];

impl Points {
    pub fn new(seed: u64) -> Points {
        Points { state: seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ 0x1234_5678 }
    }

    /// The next 64 random bits (SplitMix64).
    fn word(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.state;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn unit(&mut self) -> f64 {
        (self.word() >> 11) as f64 / 9_007_199_254_740_992.0
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// A double with random bits; half of them in the range of `f32`.
    fn anywhere(&mut self) -> f64 {
        if self.word() & 1 == 0 {
            f64::from_bits(self.word())
        } else {
            f64::from(f32::from_bits(self.word() as u32))
        }
    }

    fn small(&mut self) -> f64 {
        let exponent = self.between(-40.0, 4.0).floor() as i32;
        let sign = if self.word() & 1 == 0 { 1.0 } else { -1.0 };
        sign * self.between(1.0, 2.0) * 2f64.powi(exponent)
    }

    /// A double near a multiple of π/2.
    fn near_quarter_turn(&mut self) -> f64 {
        let bits = 1 + (self.word() % 62) as u32;
        let turns = self.word() >> (64 - bits);
        let angle = quarter_turns(turns);
        let off = (self.word() % 5) as i64 - 2;
        f64::from_bits(angle.to_bits().wrapping_add_signed(off))
    }

    fn argument(&mut self, domain: &Domain, which: usize, index: u64) -> f64 {
        let (low, high) = domain.range[which];
        match index % 16 {
            0 | 1 => self.anywhere(),
            2 | 3 => self.small(),
            // Around the ends of the tables' cells, and around 1.
            4 => self.between(-130.0, 130.0).round() / 128.0 + self.small() * 1e-7,
            5 => 1.0 + self.small() * 0.01,
            6 if domain.is_periodic() => self.near_quarter_turn(),
            6 => 1.0 - self.small().abs() * 1e-3,
            _ => self.between(low, high),
        }
    }

    /// Returns the point with this index.
    pub fn next(&mut self, domain: &Domain, index: u64) -> (f64, f64) {
        let specials = SPECIAL.len() as u64;
        if index < specials * specials {
            return (SPECIAL[(index % specials) as usize], SPECIAL[(index / specials) as usize]);
        }
        let x = self.argument(domain, 0, index);
        let other = self.word() >> 7;
        let y = self.argument(domain, 1, other);
        // Coordinates of like size, and powers that stay in range.
        match other % 11 {
            0 | 1 if domain.name == "powf" => {
                let logarithm = x.abs().ln();
                let size = self.between(-750.0, 750.0);
                (x.abs(), if logarithm == 0.0 { y } else { size / logarithm })
            }
            0 | 1 => (x, x * self.between(0.2, 5.0)),
            2 => (x, (x * self.between(-8.0, 8.0)).round()),
            _ => (x, y),
        }
    }
}
