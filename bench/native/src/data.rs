//! The numbers of the cases, the same as those of `bench/c/harness.c`: xorshift64*, the highest 53 or 24 bits.

/// A float type for which cases are generated.
pub trait Element: nalgebra::RealField + Copy {
    /// Name of the type: `f64`.
    const NAME: &'static str;
    /// Converts a number in [0, 1), truncated to the type's precision.
    fn cut(number: f64) -> Self;
    /// Converts a matrix size.
    fn whole(size: u16) -> Self;
    /// Returns the bits as a word.
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

/// The numbers of a case, in column order.
pub struct Numbers<T> {
    pub matrix: Vec<T>,
    pub second: Vec<T>,
    pub vector: Vec<T>,
}

impl<T: Element> Numbers<T> {
    /// Generates numbers for matrices of a size.
    pub fn new(size: u16) -> Numbers<T> {
        let n = usize::from(size);
        let of = |count, seed: u64| fill(count, seed.wrapping_add(u64::from(size)));
        Numbers {
            matrix: of(n * n, 0x9E37_79B9_7F4A_7C15),
            second: of(n * n, 0xD1B5_4A32_D192_ED03),
            vector: of(n, 0x8CB9_2BA7_2F3D_8DD7),
        }
    }

    /// Generates numbers with a symmetric, positive definite matrix: `a + aᵀ`, with the size added to the diagonal.
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
