//! Names, `&'static str`: their words, and texts for words.
//!
//! The word of a name is the CRC-32 of its text (IEEE 802.3, as in Ethernet and zip). It depends on the text alone, so
//! equal texts have equal words, and a further name changes no other. The front end refuses two texts with one word.

#[cfg(feature = "generate")]
use alloc::{string::String, vec::Vec};

use crate::function;

/// Returns true for the name without letters.
#[allow(clippy::comparison_to_empty)] // The DSL has `is_empty` from here.
#[function(expand)]
pub fn is_empty(name: &'static str) -> bool {
    name == ""
}

/// Remainders of CRC-32 for each half of a byte.
const HALVES: [u32; 16] = halves();

const fn halves() -> [u32; 16] {
    let mut all = [0; 16];
    let mut half = 0;
    while half < 16 {
        let mut rest = half as u32;
        let mut bit = 0;
        while bit < 4 {
            rest = (rest >> 1) ^ (0xEDB8_8320 * (rest & 1));
            bit += 1;
        }
        all[half] = rest;
        half += 1;
    }
    all
}

/// Returns the word of a text.
pub fn word(text: &[u8]) -> u32 {
    let half = |rest: u32| (rest >> 4) ^ HALVES[(rest & 15) as usize];
    !text.iter().fold(!0, |rest, byte| half(half(rest ^ u32::from(*byte))))
}

/// Returns a text that has this word: 32 letters, small or capital.
///
/// Changing the case of a letter changes the word by a fixed pattern of bits, and the patterns of 32 letters are linearly
/// independent, since the polynomial is primitive. So each word has exactly one such text.
#[cfg(any(test, feature = "names"))]
fn spelled(wanted: u32) -> [u8; 32] {
    let mut text = [b'a'; 32];
    let plain = word(&text);
    // By its highest bit, a pattern and the letters that cause it.
    let mut patterns = [(0_u32, 0_u32); 32];
    let reduce = |patterns: &[(u32, u32); 32], mut left: u32, mut letters: u32| {
        while left != 0 && patterns[left.ilog2() as usize].0 != 0 {
            let (pattern, by) = patterns[left.ilog2() as usize];
            (left, letters) = (left ^ pattern, letters ^ by);
        }
        (left, letters)
    };
    for letter in 0..32 {
        text[letter] = b'A';
        let (left, letters) = reduce(&patterns, plain ^ word(&text), 1 << letter);
        text[letter] = b'a';
        patterns[left.ilog2() as usize] = (left, letters);
    }
    let (_, letters) = reduce(&patterns, plain ^ wanted, 0);
    for (letter, byte) in text.iter_mut().enumerate() {
        *byte = if letters >> letter & 1 == 1 { b'A' } else { b'a' };
    }
    text
}

/// Returns the word of a name. The program that builds trees registers each name whose word it stores.
pub fn stored(name: &'static str) -> u32 {
    #[cfg(feature = "generate")]
    known::register(name);
    word(name.as_bytes())
}

/// Returns a name that has this word, in programs around a package: the registered one, or one of letters. Elsewhere
/// there is no memory for its text.
pub fn name(word: u32) -> &'static str {
    #[cfg(feature = "names")]
    return known::name(word);
    #[cfg(not(feature = "names"))]
    {
        let _ = word;
        ""
    }
}

#[cfg(feature = "names")]
pub use known::register;

/// Returns the registered names by word; two names may have one word.
#[cfg(feature = "generate")]
pub(crate) fn registered() -> Vec<(u64, String)> {
    let mut all: Vec<_> = known::all().map(|it| (it.word.into(), it.name.into())).collect();
    all.sort();
    all
}

/// The registered names of a program. This needs no `std`, which would add methods to floats.
#[cfg(feature = "names")]
mod known {
    use alloc::boxed::Box;

    use once_cell::race::OnceBox;

    /// A name in the list, and the next one.
    pub struct Known {
        pub word: u32,
        pub name: &'static str,
        next: OnceBox<Known>,
    }

    static FIRST: OnceBox<Known> = OnceBox::new();

    /// Returns the list.
    pub fn all() -> impl Iterator<Item = &'static Known> {
        core::iter::successors(FIRST.get(), |it| it.next.get())
    }

    /// Adds a name whose text is needed, once.
    pub fn register(name: &'static str) {
        let word = super::word(name.as_bytes());
        let mut end = &FIRST;
        loop {
            let known = end.get_or_init(|| Box::new(Known { word, name, next: OnceBox::new() }));
            if known.name == name {
                return;
            }
            end = &known.next;
        }
    }

    pub fn name(word: u32) -> &'static str {
        let letters = || {
            let text = Box::leak(Box::new(super::spelled(word)));
            core::str::from_utf8(text).unwrap_or_default()
        };
        let known = all().find(|it| it.word == word);
        if word == 0 { "" } else { known.map_or_else(letters, |it| it.name) }
    }
}

#[cfg(test)]
mod tests {
    use super::{spelled, word};

    #[test]
    fn the_word_of_a_name_is_its_crc_32() {
        assert_eq!(word(b""), 0);
        assert_eq!(word(b"123456789"), 0xCBF4_3926);
    }

    #[test]
    fn each_word_has_a_text() {
        for wanted in (0..32).map(|bit| 1 << bit).chain([0, !0, 0xCBF4_3926]) {
            assert_eq!(word(&spelled(wanted)), wanted, "{wanted:#x}");
        }
    }
}
