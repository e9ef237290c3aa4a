//! Blocks of a product: bands of rows, each cut into blocks of columns.
//!
//! The best shape is found by counting instructions. For each term a block loads each vector of rows and broadcasts
//! each number once; a multiplication and an addition follow for each pair. With 16 registers, three vectors by three
//! columns or two by five are best. The last band may have fewer vectors, and the last block fewer columns. A single
//! row after whole vectors uses scalars, which need no broadcast.

use super::Sizes;
use super::target::Target;

/// Largest number of vectors one below another, and of columns side by side, in a block.
pub(super) const MOST: u32 = 8;

/// Largest number of terms for which a block's loop over them is written out.
pub(super) const WRITTEN_OUT: u32 = 20;

/// Numbers of terms per pass of the loop, if not all are written out.
const TURNS: [u32; 4] = [8, 4, 2, 1];

/// Instructions of a pass in addition to its terms, and of a block in addition to its passes.
const TURN: u32 = 3;
const BLOCK: u32 = 5;

/// Approximate size of a vector instruction of x86-64, bytes.
const INSTRUCTION: u32 = 6;

/// A band: number of vectors of rows, and number of columns in its blocks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Band {
    pub down: u32,
    pub across: u32,
}

/// Bands of a product.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Bands {
    pub first: Band,
    /// Last band, if it differs.
    pub last: Option<Band>,
    /// Columns at a time for a last row in scalars; none if there is no such row.
    pub alone: Option<u32>,
    /// Terms per pass of the loop.
    pub terms: u32,
}

/// Returns the bands with the fewest instructions for this number of lanes, and these instructions in quarters.
pub(super) fn best(
    target: &Target,
    lanes: u32,
    sizes: Sizes,
    code_bytes: u32,
) -> Option<(u32, Bands)> {
    let costs = Costs { target, lanes, sizes };
    let alone = (sizes.rows % lanes == 1 && target.alone).then(|| {
        let at_once = target.registers - 2;
        sizes.columns.div_ceil(sizes.columns.div_ceil(at_once))
    });
    let mut found: Option<(u32, Bands)> = None;
    for alone in [None, alone] {
        let rows = sizes.rows - u32::from(alone.is_some());
        let vectors = rows.div_ceil(lanes);
        for down in 1..=vectors.min(MOST) {
            // Without another last band, the last of the same height overlaps.
            let fits = |last: &u32| {
                *last == 0 || (vectors > *last && (vectors - last).is_multiple_of(down))
            };
            for last in (0..down).filter(fits) {
                let Some((one, first)) = costs.band(down) else { continue };
                let many = (vectors - last).div_ceil(down);
                let (other, last) = match costs.band(last) {
                    Some((other, last)) => (other, Some(last)),
                    None if last > 0 => continue,
                    None => (0, None),
                };
                let cost = many * one + other + alone.map_or(0, |_| costs.alone());
                if found.is_none_or(|(least, _)| cost < least) {
                    let terms = costs.terms(first, last, code_bytes);
                    found = Some((cost, Bands { first, last, alone, terms }));
                }
            }
        }
    }
    found
}

/// Costs of a product's blocks for a number of lanes.
struct Costs<'a> {
    target: &'a Target,
    lanes: u32,
    sizes: Sizes,
}

impl Costs<'_> {
    /// Returns the best band with this number of vectors, and its instructions in quarters; none if registers do not
    /// suffice.
    fn band(&self, down: u32) -> Option<(u32, Band)> {
        let columns = self.sizes.columns;
        // Beside the sums: the rows of a term, a number, a product.
        let fits = |across: &u32| down * across + down + 2 <= self.target.registers;
        let cost = |across: u32| {
            let left = match columns % across {
                0 => 0,
                left => self.block(down, left),
            };
            columns / across * self.block(down, across) + left
        };
        let bands = (1..=columns.min(MOST)).filter(fits);
        let bands = bands.map(|across| (cost(across), Band { down, across }));
        if down == 0 { None } else { bands.min_by_key(|(cost, _)| *cost) }
    }

    /// Returns the instructions of a block, in quarters.
    fn block(&self, down: u32, across: u32) -> u32 {
        let inner = self.sizes.inner;
        let turns = if inner <= WRITTEN_OUT { 0 } else { inner / TURNS[1] };
        inner * self.term(down, across) + 4 * (turns * TURN + BLOCK)
    }

    /// Returns the instructions of one term of a block, in quarters.
    fn term(&self, down: u32, across: u32) -> u32 {
        // A vector of numbers that lie apart: a load for each.
        let load = if self.sizes.left.0 == 1 { 4 } else { 4 * self.lanes };
        load * down + self.target.spread * across + 4 * self.target.step * down * across
    }

    /// Returns the instructions of the last row in scalars, in quarters.
    fn alone(&self) -> u32 {
        let Sizes { inner, columns, .. } = self.sizes;
        4 * (inner * (self.target.step * columns + columns.div_ceil(self.target.registers)) + BLOCK)
    }

    /// Returns the number of terms of the largest blocks that fit into the code size.
    fn terms(&self, first: Band, last: Option<Band>, code_bytes: u32) -> u32 {
        let of = |band: Band| {
            let left = self.sizes.columns % band.across;
            let rest = if left > 0 { self.term(band.down, left) } else { 0 };
            self.term(band.down, band.across) + rest
        };
        let bytes = INSTRUCTION * (of(first) + last.map_or(0, of)) / 4;
        let room = code_bytes.min(self.target.room);
        let all = self.sizes.inner.saturating_sub(1).max(1);
        // Those before the turns are written out, too.
        let fits = |terms: &u32| *terms <= all && (terms + all % terms) * bytes <= room;
        let mut turns =
            std::iter::once(all).filter(|_| self.sizes.inner <= WRITTEN_OUT).chain(TURNS);
        turns.find(fits).unwrap_or(1)
    }
}

#[cfg(test)]
mod tests {
    use bessemer_ir::KernelRoutine;

    use super::super::Sizes;
    use super::super::vectors::tests::avx;
    use super::{Band, Bands, best};

    /// The bands of a product of square matrices with vectors of AVX.
    fn bands(size: u32, lanes: u32, code_bytes: u32) -> Option<Bands> {
        let [_, avx] = avx();
        let sizes = Sizes::new(KernelRoutine::Product, size, size, size);
        best(&avx, lanes, sizes, code_bytes).map(|(_, bands)| bands)
    }

    #[test]
    fn what_is_left_goes_by_smaller_blocks() {
        let first = Band { down: 3, across: 3 };
        let alone = Bands { first, last: None, alone: Some(13), terms: 12 };
        assert_eq!(bands(13, 4, 8192), Some(alone));
        let last = Some(Band { down: 2, across: 5 });
        assert_eq!(bands(20, 4, 8192), Some(Bands { first, last, alone: None, terms: 19 }));
    }

    #[test]
    fn with_registers_to_spare_a_last_row_is_one_more_vector() {
        let [wide, _] = avx();
        let sizes = Sizes::new(KernelRoutine::Product, 17, 17, 17);
        let first = Band { down: 3, across: 6 };
        let bands = best(&wide, 8, sizes, 8192).map(|(_, bands)| bands);
        assert_eq!(bands, Some(Bands { first, last: None, alone: None, terms: 8 }));
    }

    #[test]
    fn the_loop_has_as_many_terms_as_have_room() {
        let terms = |code_bytes| bands(16, 4, code_bytes).map(|bands| bands.terms);
        assert_eq!([8192, 2048, 512, 1].map(terms), [Some(15), Some(2), Some(1), Some(1)]);
    }
}
