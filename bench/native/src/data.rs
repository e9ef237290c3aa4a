//! The numbers, equal to in `bench/c/harness.c`: xorshift64*, the highest 53 or 24 bits.

/// A float that cases are made for.
pub trait Element: nalgebra::RealField + Copy {
    /// `f64`.
    const NAME: &'static str;
    /// A number in [0, 1), cut to the type's own bits.
    fn cut(number: f64) -> Self;
    /// A size.
    fn whole(size: u16) -> Self;
    /// Its bits.
    fn word(self) -> u64;
}

impl Element for f64 {
    const NAME: &'static str = "f64";
    fn cut(number: f64) -> Self {
        number
    }
    fn whole(size: u16) -> Self {
        size.into()
    }
    fn word(self) -> u64 {
        self.to_bits()
    }
}

impl Element for f32 {
    const NAME: &'static str = "f32";
    fn cut(number: f64) -> Self {
        ((number * 16_777_216.0).floor() / 16_777_216.0) as f32
    }
    fn whole(size: u16) -> Self {
        size.into()
    }
    fn word(self) -> u64 {
        self.to_bits().into()
    }
}

/// The numbers of one case, by columns.
pub struct Numbers<T> {
    pub matrix: Vec<T>,
    pub second: Vec<T>,
    pub vector: Vec<T>,
}

impl<T: Element> Numbers<T> {
    /// For matrices of this size.
    pub fn new(size: u16) -> Numbers<T> {
        let n = usize::from(size);
        let of = |count, seed: u64| fill(count, seed.wrapping_add(u64::from(size)));
        Numbers {
            matrix: of(n * n, 0x9E37_79B9_7F4A_7C15),
            second: of(n * n, 0xD1B5_4A32_D192_ED03),
            vector: of(n, 0x8CB9_2BA7_2F3D_8DD7),
        }
    }

    /// The matrix made symmetric and positive definite: `a + aᵀ`, and on the diagonal the size more.
    pub fn definite(size: u16) -> Numbers<T> {
        let mut numbers = Numbers::new(size);
        let n = usize::from(size);
        for column in 0..n {
            for row in 0..=column {
                let sum = numbers.matrix[row + n * column] + numbers.matrix[column + n * row];
                numbers.matrix[row + n * column] = sum;
                numbers.matrix[column + n * row] = sum;
            }
        }
        for i in 0..n {
            numbers.matrix[i + n * i] += T::whole(size);
        }
        numbers
    }
}

fn fill<T: Element>(count: usize, seed: u64) -> Vec<T> {
    let mut state = seed;
    let mut next = || {
        state ^= state >> 12;
        state ^= state << 25;
        state ^= state >> 27;
        (state.wrapping_mul(2_685_821_657_736_338_717) >> 11) as f64 / 9_007_199_254_740_992.0
    };
    (0..count).map(|_| T::cut(next())).collect()
}
