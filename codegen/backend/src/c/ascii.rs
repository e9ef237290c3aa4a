//! Text in ASCII: each other character as the letters that stand for it, such as `pi` for `π`.
//!
//! Only comments have such characters; identifiers are ASCII already. Invariants: the number of lines stays, and no
//! character is dropped. One without letters of its own is written by its number, `<U+4E2D>`.

/// Returns the text in ASCII.
pub fn written(text: &str) -> String {
    let mut ascii = String::with_capacity(text.len());
    let mut raised = false;
    for letter in text.chars() {
        let digit = power(letter);
        match (digit, letter.is_ascii()) {
            (_, true) => ascii.push(letter),
            // `²` follows what it raises; the digits after it belong to one number.
            (Some(digit), _) => {
                if !raised {
                    ascii.push('^');
                }
                ascii.push(digit);
            }
            _ => match word(letter) {
                Some(word) => ascii.push_str(word),
                None => ascii.push_str(&format!("<U+{:04X}>", letter as u32)),
            },
        }
        raised = digit.is_some();
    }
    ascii
}

/// Returns the character that a superscript raises.
fn power(letter: char) -> Option<char> {
    let digits = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let digit = digits.iter().position(|it| *it == letter);
    let signs = [('⁻', '-'), ('⁺', '+'), ('ᵀ', 'T'), ('ⁿ', 'n')];
    let sign = signs.iter().find(|(raised, _)| *raised == letter).map(|(_, plain)| *plain);
    digit.and_then(|it| char::from_digit(it as u32, 10)).or(sign)
}

/// Characters of comments and units, and the letters that stand for them.
const WORDS: &[(char, &str)] = &[
    ('·', "*"),
    ('×', "x"),
    ('÷', "/"),
    ('−', "-"),
    ('–', "-"),
    ('—', "--"),
    ('±', "+-"),
    ('≈', "~"),
    ('≤', "<="),
    ('≥', ">="),
    ('≠', "!="),
    ('√', "sqrt "),
    ('∞', "inf"),
    ('∈', "in"),
    ('∑', "sum "),
    ('∫', "integral "),
    ('∂', "d"),
    ('→', "->"),
    ('←', "<-"),
    ('↔', "<->"),
    ('⇒', "=>"),
    ('½', "1/2"),
    ('¼', "1/4"),
    ('¾', "3/4"),
    ('°', "deg"),
    ('µ', "u"),
    ('μ', "u"),
    ('Ω', "Ohm"),
    ('‰', "permille"),
    ('§', "section "),
    ('…', "..."),
    ('‘', "\'"),
    ('’', "\'"),
    ('“', "\""),
    ('”', "\""),
    ('«', "\""),
    ('»', "\""),
    ('\u{a0}', " "),
    ('\u{2011}', "-"),
    ('\u{307}', "_dot"),
    ('\u{302}', "_hat"),
    ('\u{304}', "_bar"),
    ('α', "alpha"),
    ('β', "beta"),
    ('γ', "gamma"),
    ('δ', "delta"),
    ('ε', "epsilon"),
    ('ζ', "zeta"),
    ('η', "eta"),
    ('θ', "theta"),
    ('κ', "kappa"),
    ('λ', "lambda"),
    ('ν', "nu"),
    ('ξ', "xi"),
    ('π', "pi"),
    ('ρ', "rho"),
    ('σ', "sigma"),
    ('τ', "tau"),
    ('φ', "phi"),
    ('χ', "chi"),
    ('ψ', "psi"),
    ('ω', "omega"),
    ('Γ', "Gamma"),
    ('Δ', "Delta"),
    ('Θ', "Theta"),
    ('Λ', "Lambda"),
    ('Π', "Pi"),
    ('Σ', "Sigma"),
    ('Φ', "Phi"),
    ('Ψ', "Psi"),
    ('ä', "ae"),
    ('ö', "oe"),
    ('ü', "ue"),
    ('Ä', "Ae"),
    ('Ö', "Oe"),
    ('Ü', "Ue"),
    ('ß', "ss"),
    ('é', "e"),
    ('è', "e"),
    ('ê', "e"),
    ('ë', "e"),
    ('à', "a"),
    ('á', "a"),
    ('â', "a"),
    ('å', "a"),
    ('ç', "c"),
    ('í', "i"),
    ('ï', "i"),
    ('î', "i"),
    ('ñ', "n"),
    ('ó', "o"),
    ('ò', "o"),
    ('ô', "o"),
    ('ø', "o"),
    ('ú', "u"),
    ('ù', "u"),
    ('û', "u"),
    ('ý', "y"),
    ('É', "E"),
    ('Å', "A"),
    ('Ø', "O"),
    ('æ', "ae"),
    ('œ', "oe"),
];

fn word(letter: char) -> Option<&'static str> {
    WORDS.iter().find(|(it, _)| *it == letter).map(|(_, word)| *word)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_character_has_letters_or_a_number() {
        for (text, expected) in [
            ("rad/s², kg·m⁻¹²", "rad/s^2, kg*m^-12"),
            ("π ± 1 µs … 5°", "pi +- 1 us ... 5deg"),
            ("Höhe ≤ 3 m", "Hoehe <= 3 m"),
            ("中 /* plain */", "<U+4E2D> /* plain */"),
            ("Rᵀ x²y³", "R^T x^2y^3"),
        ] {
            assert_eq!(written(text), expected);
            assert!(written(text).is_ascii());
        }
    }

    #[test]
    fn no_character_is_listed_twice() {
        for (at, (letter, word)) in WORDS.iter().enumerate() {
            assert!(!letter.is_ascii() && word.is_ascii(), "{letter}");
            assert!(WORDS[..at].iter().all(|(other, _)| other != letter), "{letter}");
        }
    }
}
