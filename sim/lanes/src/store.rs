//! Memory: values that consist of lanes, and elements whose index differs from lane to lane.

use crate::{LANES, Mask, Real, Single, Whole};

/// A value of each lane. Its words are those of the value in one lane, in the order of its declaration.
pub trait Lanes: Clone {
    /// Replaces the lanes of a mask by those of another value.
    fn assign(&mut self, mask: Mask, value: &Self);

    /// Replaces a lane by the same lane of another value.
    fn take(&mut self, lane: usize, value: &Self);

    /// Creates the value with the same words in each lane. Words that are missing are 0.
    fn splat(words: &mut impl Iterator<Item = u64>) -> Self;

    /// Replaces the words of a lane. Words that are missing are 0.
    fn put(&mut self, lane: usize, words: &mut impl Iterator<Item = u64>);

    /// Appends the words of a lane.
    fn words(&self, lane: usize, words: &mut Vec<u64>);

    /// Returns, in each lane, the value of a table's words from an index on. Words that are missing are 0.
    #[inline]
    fn gather(words: &[u64], at: [usize; LANES]) -> Self {
        let mut value = Self::zero();
        for (lane, at) in at.into_iter().enumerate() {
            value.put(lane, &mut words.get(at..).unwrap_or_default().iter().copied());
        }
        value
    }

    /// Returns the value whose words are 0.
    fn zero() -> Self {
        Self::splat(&mut std::iter::empty())
    }

    /// Returns the value of these words in each lane.
    fn of_words(words: &[u64]) -> Self {
        Self::splat(&mut words.iter().copied())
    }
}

macro_rules! word {
    ($ty:ident, $of:expr, $to:expr) => {
        impl Lanes for $ty {
            #[inline(always)]
            fn assign(&mut self, mask: Mask, value: &Self) {
                *self = value.or(mask, *self);
            }

            #[inline(always)]
            fn take(&mut self, lane: usize, value: &Self) {
                let mut all = self.to_array();
                all[lane % LANES] = value.to_array()[lane % LANES];
                *self = $ty::new(all);
            }

            #[inline(always)]
            fn splat(words: &mut impl Iterator<Item = u64>) -> Self {
                $ty::new([$of(words.next().unwrap_or_default()); LANES])
            }

            #[inline(always)]
            fn put(&mut self, lane: usize, words: &mut impl Iterator<Item = u64>) {
                let mut all = self.to_array();
                all[lane % LANES] = $of(words.next().unwrap_or_default());
                *self = $ty::new(all);
            }

            #[inline(always)]
            fn gather(words: &[u64], at: [usize; LANES]) -> Self {
                $ty::new(at.map(|at| $of(words.get(at).copied().unwrap_or_default())))
            }

            #[inline(always)]
            fn words(&self, lane: usize, words: &mut Vec<u64>) {
                words.push($to(self.to_array()[lane % LANES]));
            }
        }
    };
}

word!(Real, f64::from_bits, f64::to_bits);
word!(Single, |word| f32::from_bits(word as u32), |value: f32| u64::from(value.to_bits()));
word!(Whole, |word| word as i64, |value| value as u64);
word!(Mask, |word| word != 0, u64::from);

impl Single {
    /// Returns the numbers of the lanes.
    #[inline(always)]
    pub fn new(values: [f32; LANES]) -> Single {
        Single(values)
    }
}

impl Mask {
    /// Returns `self` in the lanes of a mask, and `other` elsewhere.
    #[inline(always)]
    pub fn or(self, mask: Mask, other: Mask) -> Mask {
        (self & mask) | (other & !mask)
    }
}

impl<T: Lanes, const N: usize> Lanes for [T; N] {
    #[inline]
    fn assign(&mut self, mask: Mask, value: &Self) {
        for (one, other) in self.iter_mut().zip(value) {
            one.assign(mask, other);
        }
    }

    #[inline]
    fn take(&mut self, lane: usize, value: &Self) {
        for (one, other) in self.iter_mut().zip(value) {
            one.take(lane, other);
        }
    }

    #[inline]
    fn splat(words: &mut impl Iterator<Item = u64>) -> Self {
        std::array::from_fn(|_| T::splat(words))
    }

    #[inline]
    fn put(&mut self, lane: usize, words: &mut impl Iterator<Item = u64>) {
        self.iter_mut().for_each(|one| one.put(lane, words));
    }

    #[inline]
    fn words(&self, lane: usize, words: &mut Vec<u64>) {
        self.iter().for_each(|one| one.words(lane, words));
    }
}

/// Returns a part of the element that each lane's index selects. An index beyond the end selects the last element: such a
/// lane does not use it.
#[inline]
pub fn pick<T, R: Lanes>(all: &[T], index: Whole, part: impl Fn(&T) -> &R) -> R {
    let index = index.to_array();
    let Some(last) = all.len().checked_sub(1) else { return R::zero() };
    let element = |lane: usize| part(&all[(index[lane] as usize).min(last)]);
    let mut result = element(0).clone();
    if index.iter().all(|it| *it == index[0]) {
        return result;
    }
    for lane in 1..LANES {
        result.take(lane, element(lane));
    }
    result
}

/// Calls `write` for the element that each lane's index selects, with the lanes of the mask that select it.
#[inline]
pub fn each<T>(all: &mut [T], index: Whole, mask: Mask, mut write: impl FnMut(&mut T, Mask)) {
    let index = index.to_array();
    let first = (0..LANES).find(|lane| mask.lane(*lane)).unwrap_or_default();
    if (0..LANES).all(|lane| !mask.lane(lane) || index[lane] == index[first]) {
        if let Some(element) = all.get_mut(index[first] as usize) {
            write(element, mask);
        }
        return;
    }
    for lane in 0..LANES {
        let seen = (0..lane).any(|it| mask.lane(it) && index[it] == index[lane]);
        if !mask.lane(lane) || seen {
            continue;
        }
        let same = Mask::new(std::array::from_fn(|it| index[it] == index[lane]));
        if let Some(element) = all.get_mut(index[lane] as usize) {
            write(element, mask & same);
        }
    }
}

/// Returns an index that is equal in all lanes, at most the last element's.
#[inline(always)]
pub fn index(index: i64, len: usize) -> usize {
    usize::try_from(index).unwrap_or_default().min(len.saturating_sub(1))
}

/// Returns the value of a table's words from an index on.
#[inline(always)]
pub fn table<T: Lanes>(words: &[u64], at: usize) -> T {
    T::splat(&mut words.get(at..).unwrap_or_default().iter().copied())
}

/// Returns the value of a table's words from an index on that differs from lane to lane.
#[inline(always)]
pub fn table_at<T: Lanes>(words: &[u64], at: usize, index: Whole) -> T {
    T::gather(words, index.to_array().map(|index| at.wrapping_add(index as usize)))
}

/// Returns `left && right`; the right side is computed for the lanes of the mask in which the left one is true.
#[inline(always)]
pub fn and(mask: Mask, left: Mask, right: impl FnOnce(Mask) -> Mask) -> Mask {
    let mask = mask & left;
    if mask.any() { left & right(mask) } else { Mask::NONE }
}

/// Returns `left || right`; the right side is computed for the lanes of the mask in which the left one is false.
#[inline(always)]
pub fn or(mask: Mask, left: Mask, right: impl FnOnce(Mask) -> Mask) -> Mask {
    let mask = mask & !left;
    if mask.any() { left | right(mask) } else { left }
}
