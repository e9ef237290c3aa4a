//! Canonical Huffman codec for a small alphabet: code lengths from symbol counts,
//! codes from the lengths, decoding without a tree.

pub type Symbol = u8;

/// One code, right-aligned.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Code {
    pub bits: u32,
    pub len: u8,
}

impl Code {
    /// Bits from the most significant one on.
    pub fn iter(self) -> impl DoubleEndedIterator<Item = bool> {
        (0..self.len).rev().map(move |i| self.bits >> i & 1 == 1)
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CodebookError {
    NoSymbols,
    /// The lengths do not make a prefix code.
    Oversubscribed,
}

const MAX_LEN: usize = 31;

/// Codebook for the symbols `0..N`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Codebook<const N: usize> {
    codes: [Code; N],
    /// Symbols in order of length, then value.
    order: [Symbol; N],
    per_length: [u16; MAX_LEN + 1],
}

#[derive(Clone, Copy, Debug, Default)]
struct Group {
    weight: u64,
    /// Bit set of the symbols below this node.
    members: u32,
}

impl<const N: usize> Codebook<N> {
    /// Builds the optimal code for the given counts.
    pub fn from_counts(counts: &[u32; N]) -> Result<Self, CodebookError> {
        const { assert!(N <= 32, "alphabet too large") };
        let mut groups = [Group::default(); N];
        let mut live = 0;
        for (s, &count) in counts.iter().enumerate().filter(|&(_, &c)| c > 0) {
            groups[live] = Group { weight: count.into(), members: 1 << s };
            live += 1;
        }

        let mut lengths = [0_u8; N];
        match &groups[..live] {
            [] => return Err(CodebookError::NoSymbols),
            [only] => lengths[only.members.trailing_zeros() as usize] = 1,
            _ => {}
        }
        // Join the two lightest until one is left; members sink one level.
        while live > 1 {
            let pool = &mut groups[..live];
            pool.sort_unstable_by(|a, b| b.weight.cmp(&a.weight).then(b.members.cmp(&a.members)));
            let [.., a, b] = pool else { break };
            a.weight += b.weight;
            a.members |= b.members;
            for (s, len) in lengths.iter_mut().enumerate() {
                *len += (a.members >> s & 1) as u8;
            }
            live -= 1;
        }
        Self::from_lengths(&lengths)
    }

    /// Rebuilds the codebook from transmitted lengths; zero means unused.
    pub fn from_lengths(lengths: &[u8; N]) -> Result<Self, CodebookError> {
        let mut per_length = [0; MAX_LEN + 1];
        for &len in lengths.iter().filter(|&&len| len > 0) {
            let count = per_length
                .get_mut(usize::from(len))
                .ok_or(CodebookError::Oversubscribed)?;
            *count += 1;
        }

        let mut codes = [Code::default(); N];
        let mut order = [0; N];
        let mut next = 0_u64;
        let mut placed = 0;
        for len in 1..=MAX_LEN as u8 {
            next <<= 1;
            for (s, code) in codes.iter_mut().enumerate().filter(|&(s, _)| lengths[s] == len) {
                if next >> len != 0 {
                    return Err(CodebookError::Oversubscribed);
                }
                *code = Code { bits: next as u32, len };
                order[placed] = s as Symbol;
                next += 1;
                placed += 1;
            }
        }
        if placed == 0 {
            return Err(CodebookError::NoSymbols);
        }
        Ok(Self { codes, order, per_length })
    }

    pub fn code(&self, symbol: Symbol) -> Option<Code> {
        self.codes.get(usize::from(symbol)).copied().filter(|c| c.len > 0)
    }

    /// Encodes lazily; a symbol without a code becomes `None` and ends nothing.
    pub fn encode<'a>(&'a self, symbols: &'a [Symbol]) -> impl Iterator<Item = Option<bool>> + 'a {
        symbols.iter().flat_map(move |&s| {
            let code = self.code(s);
            let bad = code.is_none().then_some(None);
            code.into_iter().flat_map(Code::iter).map(Some).chain(bad)
        })
    }

    pub fn decoder(&self) -> Decoder<'_, N> {
        Decoder { book: self, acc: 0, first: 0, base: 0, len: 0 }
    }
}

/// Decoder fed bit by bit.
#[derive(Clone, Debug)]
pub struct Decoder<'b, const N: usize> {
    book: &'b Codebook<N>,
    acc: u32,
    first: u32,
    base: usize,
    len: usize,
}

impl<const N: usize> Decoder<'_, N> {
    /// `Some(Ok(_))` when a symbol is complete, `Some(Err(()))` on a code that
    /// is not in the book.
    pub fn push(&mut self, bit: bool) -> Option<Result<Symbol, ()>> {
        self.len += 1;
        self.acc = self.acc << 1 | u32::from(bit);
        self.first <<= 1;
        let Some(&count) = self.book.per_length.get(self.len) else {
            self.reset();
            return Some(Err(()));
        };
        let offset = self.acc - self.first;
        if offset < u32::from(count) {
            let symbol = self.book.order[self.base + offset as usize];
            self.reset();
            return Some(Ok(symbol));
        }
        self.first += u32::from(count);
        self.base += usize::from(count);
        None
    }

    fn reset(&mut self) {
        *self = self.book.decoder();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const COUNTS: [u32; 6] = [45, 13, 12, 16, 9, 5];

    #[test]
    fn textbook_lengths() {
        let book = Codebook::from_counts(&COUNTS).unwrap();
        let lengths = [0, 1, 2, 3, 4, 5].map(|s| book.code(s).unwrap().len);
        assert_eq!(lengths, [1, 3, 3, 3, 4, 4]);
        assert_eq!(Codebook::from_lengths(&lengths), Ok(book));
    }

    #[test]
    fn round_trip() {
        let book = Codebook::from_counts(&COUNTS).unwrap();
        let message = [0, 5, 1, 0, 0, 4, 3, 2, 2, 5, 0];
        let mut decoder = book.decoder();
        let decoded = book
            .encode(&message)
            .flatten()
            .filter_map(|bit| decoder.push(bit))
            .map_while(Result::ok);
        assert!(decoded.eq(message));
        assert_eq!(book.encode(&[9]).next(), Some(None));
    }

    #[test]
    fn odd_alphabets() {
        assert_eq!(Codebook::from_counts(&[0; 4]), Err(CodebookError::NoSymbols));
        assert_eq!(Codebook::from_lengths(&[1, 1, 1]), Err(CodebookError::Oversubscribed));
        let single = Codebook::from_counts(&[0, 7]).unwrap();
        assert_eq!(single.code(1), Some(Code { bits: 0, len: 1 }));
        let mut decoder = single.decoder();
        assert_eq!(decoder.push(false), Some(Ok(1)));
        assert!((0..40).filter_map(|_| decoder.push(true)).all(|r| r.is_err()));
    }
}
