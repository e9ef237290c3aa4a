//! Matrices of square blocks, most of which are zero by their type.
//!
//! A type has a pattern: a bit for each block. The other blocks are neither stored nor computed. Tables of each pattern have the places of its blocks, so the
//! C has loops over the stored blocks alone.
//!
//! Invariant: a number is the sum of the same products in the same order as in the product of dense matrices, without those that are zero by type.

use bessemer::prelude::*;

use crate::{Correction, Symmetric};

/// Returns the pattern that a picture shows: a text for each row of blocks, `x` for a stored block and `.` for zeros.
///
/// A pattern has at most 64 blocks. Rows of different lengths, and other letters, do not compile.
pub const fn pattern(picture: &[&str]) -> u64 {
    let mut pattern = 0;
    let mut bit = 0;
    let mut row = 0;
    while row < picture.len() {
        let letters = picture[row].as_bytes();
        assert!(letters.len() == picture[0].len(), "the rows of a pattern have the same length");
        let mut col = 0;
        while col < letters.len() {
            assert!(bit < 64, "a pattern has at most 64 blocks");
            match letters[col] {
                b'x' => pattern |= 1 << bit,
                b'.' => {}
                _ => panic!("a pattern is written with `x` for a block and `.` for zeros"),
            }
            bit += 1;
            col += 1;
        }
        row += 1;
    }
    pattern
}

/// Returns the number of blocks in a pattern.
pub const fn stored(pattern: u64) -> usize {
    pattern.count_ones() as usize
}

/// Returns true if a pattern has the block of a bit.
const fn has(pattern: u64, bit: usize) -> bool {
    bit < 64 && pattern >> bit & 1 == 1
}

/// Returns the index of the block of a bit among the stored ones.
const fn index(pattern: u64, bit: usize) -> usize {
    stored(pattern & ((1 << bit) - 1))
}

/// Returns the first row, or the first column, of each stored block.
const fn places<const STORED: usize>(
    pattern: u64,
    (rows, cols, size): (usize, usize, usize),
    of_rows: bool,
) -> [u16; STORED] {
    assert!(
        size > 0 && rows % size == 0 && cols % size == 0,
        "rows and columns are multiples of the size of a block"
    );
    let (rows, cols) = (rows / size, cols / size);
    assert!(rows * cols <= 64, "a pattern has at most 64 blocks");
    assert!(
        rows * cols == 64 || pattern >> (rows * cols) == 0,
        "the pattern has more blocks than the matrix"
    );
    assert!(STORED > 0, "a pattern has at least one block");
    assert!(stored(pattern) == STORED, "the number of blocks is `stored(PATTERN)`");
    let mut places = [0; STORED];
    let (mut n, mut bit) = (0, 0);
    while bit < rows * cols {
        if has(pattern, bit) {
            let place = if of_rows { bit / cols * size } else { bit % cols * size };
            assert!(
                place <= u16::MAX as usize,
                "a matrix of blocks has at most 65,535 rows and columns"
            );
            places[n] = place as u16;
            n += 1;
        }
        bit += 1;
    }
    places
}

/// A place of a block.
struct Place<
    const PATTERN: u64,
    const SIZE: usize,
    const COLS: usize,
    const ROW: usize,
    const COL: usize,
>;

impl<const PATTERN: u64, const SIZE: usize, const COLS: usize, const ROW: usize, const COL: usize>
    Place<PATTERN, SIZE, COLS, ROW, COL>
{
    /// Index of its block among the stored ones.
    const INDEX: usize = {
        let bit = ROW * (COLS / SIZE) + COL;
        assert!(COL < COLS / SIZE && bit < 64, "the matrix has no such block");
        assert!(has(PATTERN, bit), "this block is zero by the pattern");
        index(PATTERN, bit)
    };
}

/// A pattern of `STORED` blocks in a pattern that has each of them.
struct Within<const PATTERN: u64, const STORED: usize, const WHOLE: u64>;

impl<const PATTERN: u64, const STORED: usize, const WHOLE: u64> Within<PATTERN, STORED, WHOLE> {
    /// Index of each block among those of the whole.
    const INDICES: [u8; STORED] = {
        assert!(PATTERN & !WHOLE == 0, "the pattern of the result lacks a block of a summand");
        let mut indices = [0; STORED];
        let (mut n, mut bit) = (0, 0);
        while n < STORED {
            if has(PATTERN, bit) {
                indices[n] = index(WHOLE, bit) as u8;
                n += 1;
            }
            bit += 1;
        }
        indices
    };
}

/// The product of two patterns, in a pattern that has each of its blocks. `INNER` and `COLS` count the blocks beside each other.
struct Multiplied<
    const LEFT: u64,
    const LEFTS: usize,
    const RIGHT: u64,
    const RIGHTS: usize,
    const INNER: usize,
    const COLS: usize,
    const SIZE: usize,
    const RESULT: u64,
>;

impl<
    const LEFT: u64,
    const LEFTS: usize,
    const RIGHT: u64,
    const RIGHTS: usize,
    const INNER: usize,
    const COLS: usize,
    const SIZE: usize,
    const RESULT: u64,
> Multiplied<LEFT, LEFTS, RIGHT, RIGHTS, INNER, COLS, SIZE, RESULT>
{
    /// Index of the block of the result to which two blocks contribute; 64 for blocks that do not meet.
    const INDICES: [[u8; RIGHTS]; LEFTS] = {
        let (inner, cols) = (INNER / SIZE, COLS / SIZE);
        let mut indices = [[64; RIGHTS]; LEFTS];
        let (mut n, mut left) = (0, 0);
        while n < LEFTS {
            let (mut m, mut right) = (0, 0);
            while m < RIGHTS && has(LEFT, left) {
                if has(RIGHT, right) {
                    if left % inner == right / cols {
                        let bit = left / inner * cols + right % cols;
                        assert!(
                            has(RESULT, bit),
                            "the pattern of the result lacks a block of the product"
                        );
                        indices[n][m] = index(RESULT, bit) as u8;
                    }
                    m += 1;
                }
                right += 1;
            }
            if has(LEFT, left) {
                n += 1;
            }
            left += 1;
        }
        indices
    };
}

/// A matrix of square blocks of `SIZE` rows, of which those of a pattern are stored; the others are zero.
///
/// `PATTERN` has bit r · `COLS` / `SIZE` + c for the block in row r and column c, both from 0. [`pattern`] reads it from
/// a picture, and [`stored`] counts its blocks. A pattern that does not fit the matrix, or the result of an operation,
/// does not compile.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BlockSparse<
    T: Real,
    const ROWS: usize,
    const COLS: usize,
    const SIZE: usize,
    const STORED: usize,
    const PATTERN: u64,
> {
    /// Stored blocks, row after row.
    pub blocks: [SMatrix<T, SIZE, SIZE>; STORED],
}

impl<
    T: Real,
    const ROWS: usize,
    const COLS: usize,
    const SIZE: usize,
    const STORED: usize,
    const PATTERN: u64,
> Default for BlockSparse<T, ROWS, COLS, SIZE, STORED, PATTERN>
{
    fn default() -> Self {
        BlockSparse { blocks: [SMatrix::zeros(); STORED] }
    }
}

#[data]
impl<
    T: Real,
    const ROWS: usize,
    const COLS: usize,
    const SIZE: usize,
    const STORED: usize,
    const PATTERN: u64,
> BlockSparse<T, ROWS, COLS, SIZE, STORED, PATTERN>
{
    /// First row of each stored block.
    const TOPS: [u16; STORED] = places(PATTERN, (ROWS, COLS, SIZE), true);

    /// First column of each stored block.
    const LEFTS: [u16; STORED] = places(PATTERN, (ROWS, COLS, SIZE), false);

    /// True; a pattern that does not fit the matrix does not compile.
    const VALID: bool = {
        let _: [u16; STORED] = places(PATTERN, (ROWS, COLS, SIZE), true);
        true
    };

    /// Returns the matrix whose stored blocks are zero, too.
    pub fn zeros() -> Self {
        const { assert!(Self::VALID) };
        BlockSparse { blocks: [SMatrix::zeros(); STORED] }
    }

    /// Returns the stored blocks of a matrix. Other elements of it are ignored.
    pub fn of_matrix(matrix: &SMatrix<T, ROWS, COLS>) -> Self {
        let mut sparse = Self::zeros();
        for n in 0..STORED {
            let top = (Self::TOPS[n] as usize).min(ROWS - SIZE);
            let left = (Self::LEFTS[n] as usize).min(COLS - SIZE);
            for col in 0..SIZE {
                for row in 0..SIZE {
                    sparse.blocks[n][(row, col)] = matrix[(top + row, left + col)];
                }
            }
        }
        sparse
    }

    /// Returns the matrix with its zeros.
    pub fn matrix(&self) -> SMatrix<T, ROWS, COLS> {
        let mut matrix = SMatrix::zeros();
        for n in 0..STORED {
            let top = (Self::TOPS[n] as usize).min(ROWS - SIZE);
            let left = (Self::LEFTS[n] as usize).min(COLS - SIZE);
            for col in 0..SIZE {
                for row in 0..SIZE {
                    matrix[(top + row, left + col)] = self.blocks[n][(row, col)];
                }
            }
        }
        matrix
    }

    /// Returns the block in row `ROW` and column `COL` of blocks; one that is zero by the pattern does not compile.
    pub fn block<const ROW: usize, const COL: usize>(&self) -> SMatrix<T, SIZE, SIZE> {
        self.blocks[Place::<PATTERN, SIZE, COLS, ROW, COL>::INDEX]
    }

    /// Sets the block in row `ROW` and column `COL` of blocks; one that is zero by the pattern does not compile.
    pub fn set<const ROW: usize, const COL: usize>(&mut self, block: &SMatrix<T, SIZE, SIZE>) {
        self.blocks[Place::<PATTERN, SIZE, COLS, ROW, COL>::INDEX] = *block;
    }

    /// Returns the product A B with a dense matrix or a vector.
    pub fn times<const K: usize>(&self, right: &SMatrix<T, COLS, K>) -> SMatrix<T, ROWS, K> {
        let mut product = SMatrix::zeros();
        for n in 0..STORED {
            let top = (Self::TOPS[n] as usize).min(ROWS - SIZE);
            let left = (Self::LEFTS[n] as usize).min(COLS - SIZE);
            for col in 0..K {
                for row in 0..SIZE {
                    let mut sum = product[(top + row, col)];
                    for k in 0..SIZE {
                        sum += self.blocks[n][(row, k)] * right[(left + k, col)];
                    }
                    product[(top + row, col)] = sum;
                }
            }
        }
        product
    }

    /// Returns the product Aᵀ B with a dense matrix or a vector.
    pub fn transposed_times<const K: usize>(
        &self,
        right: &SMatrix<T, ROWS, K>,
    ) -> SMatrix<T, COLS, K> {
        let mut product = SMatrix::zeros();
        for n in 0..STORED {
            let top = (Self::TOPS[n] as usize).min(ROWS - SIZE);
            let left = (Self::LEFTS[n] as usize).min(COLS - SIZE);
            for col in 0..K {
                for row in 0..SIZE {
                    let mut sum = product[(left + row, col)];
                    for k in 0..SIZE {
                        sum += self.blocks[n][(k, row)] * right[(top + k, col)];
                    }
                    product[(left + row, col)] = sum;
                }
            }
        }
        product
    }

    /// Returns the product A B with another matrix of blocks. The type of the result names its pattern, which has each
    /// block of the product.
    pub fn product<
        const K: usize,
        const OTHERS: usize,
        const OTHER: u64,
        const RESULTS: usize,
        const RESULT: u64,
    >(
        &self,
        right: &BlockSparse<T, COLS, K, SIZE, OTHERS, OTHER>,
    ) -> BlockSparse<T, ROWS, K, SIZE, RESULTS, RESULT> {
        let mut product = BlockSparse::<T, ROWS, K, SIZE, RESULTS, RESULT>::zeros();
        for n in 0..STORED {
            for m in 0..OTHERS {
                let at =
                    Multiplied::<PATTERN, STORED, OTHER, OTHERS, COLS, K, SIZE, RESULT>::INDICES[n]
                        [m] as usize;
                if at < RESULTS {
                    for col in 0..SIZE {
                        for row in 0..SIZE {
                            let mut sum = product.blocks[at][(row, col)];
                            for k in 0..SIZE {
                                sum += self.blocks[n][(row, k)] * right.blocks[m][(k, col)];
                            }
                            product.blocks[at][(row, col)] = sum;
                        }
                    }
                }
            }
        }
        product
    }

    /// Returns the sum A + B with another matrix of blocks. The type of the result names its pattern, which has each
    /// block of both.
    pub fn sum<const OTHERS: usize, const OTHER: u64, const RESULTS: usize, const RESULT: u64>(
        &self,
        other: &BlockSparse<T, ROWS, COLS, SIZE, OTHERS, OTHER>,
    ) -> BlockSparse<T, ROWS, COLS, SIZE, RESULTS, RESULT> {
        let mut sum = BlockSparse::<T, ROWS, COLS, SIZE, RESULTS, RESULT>::zeros();
        for n in 0..STORED {
            let at = (Within::<PATTERN, STORED, RESULT>::INDICES[n] as usize).min(RESULTS - 1);
            sum.blocks[at] = self.blocks[n];
        }
        for n in 0..OTHERS {
            let at = (Within::<OTHER, OTHERS, RESULT>::INDICES[n] as usize).min(RESULTS - 1);
            for col in 0..SIZE {
                for row in 0..SIZE {
                    sum.blocks[at][(row, col)] += other.blocks[n][(row, col)];
                }
            }
        }
        sum
    }

    /// Returns A P Aᵀ of a symmetric matrix P, such as the covariance after a step with the Jacobian A.
    pub fn congruence(&self, matrix: &Symmetric<T, COLS>) -> Symmetric<T, ROWS> {
        let product = self.spread(matrix);
        let mut result = Symmetric::diagonal(&SVector::zeros());
        for n in 0..STORED {
            let top = (Self::TOPS[n] as usize).min(ROWS - SIZE);
            let left = (Self::LEFTS[n] as usize).min(COLS - SIZE);
            for row in 0..SIZE {
                for col in 0..=top + row {
                    let mut sum = result.elements[(top + row, col)];
                    for k in 0..SIZE {
                        sum += self.blocks[n][(row, k)] * product[(left + k, col)];
                    }
                    result.elements[(top + row, col)] = sum;
                    result.elements[(col, top + row)] = sum;
                }
            }
        }
        result
    }

    /// Returns P Aᵀ of a symmetric matrix P: the covariance of the errors with what A makes of them.
    pub fn spread(&self, matrix: &Symmetric<T, COLS>) -> SMatrix<T, COLS, ROWS> {
        let mut product = SMatrix::<T, COLS, ROWS>::zeros();
        for n in 0..STORED {
            let top = (Self::TOPS[n] as usize).min(ROWS - SIZE);
            let left = (Self::LEFTS[n] as usize).min(COLS - SIZE);
            for col in 0..SIZE {
                for row in 0..COLS {
                    let mut sum = product[(row, top + col)];
                    for k in 0..SIZE {
                        sum += matrix.elements[(row, left + k)] * self.blocks[n][(col, k)];
                    }
                    product[(row, top + col)] = sum;
                }
            }
        }
        product
    }
}

#[data]
impl<T: Real, const N: usize> Symmetric<T, N> {
    /// Corrects as [`Symmetric::correct_jointly`] does, with the same bits, by numbers whose Jacobian has blocks that are
    /// zero by its type.
    pub fn correct_sparse<
        const M: usize,
        const SIZE: usize,
        const STORED: usize,
        const PATTERN: u64,
    >(
        &mut self,
        state: &mut SVector<T, N>,
        jacobian: &BlockSparse<T, M, N, SIZE, STORED, PATTERN>,
        innovation: &SVector<T, M>,
        noise: &Symmetric<T, M>,
        gate: T,
    ) -> Correction<T> {
        let rows = jacobian.spread(self);
        // S, in its lower triangle.
        let mut spread = noise.elements;
        for n in 0..STORED {
            let top =
                (BlockSparse::<T, M, N, SIZE, STORED, PATTERN>::TOPS[n] as usize).min(M - SIZE);
            let left =
                (BlockSparse::<T, M, N, SIZE, STORED, PATTERN>::LEFTS[n] as usize).min(N - SIZE);
            for row in 0..SIZE {
                for m in top + row..M {
                    let mut sum = spread[(m, top + row)];
                    for k in 0..SIZE {
                        sum += jacobian.blocks[n][(row, k)] * rows[(left + k, m)];
                    }
                    spread[(m, top + row)] = sum;
                }
            }
        }
        self.correct_by(state, &rows, &spread, innovation, gate)
    }
}
