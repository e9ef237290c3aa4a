//! Random texts of a bounded length.

use super::types::Ty;
use super::writer::Writer;

const WORDS: [&str; 3] = ["a", "ab", "b2"];

impl Writer<'_> {
    pub fn text(&mut self, len: usize, fuel: usize) -> String {
        if fuel > 0 && self.one_in(3) {
            let byte = self.value(&Ty::Int("u8"), fuel - 1);
            let word = self.random.of(&WORDS[..1]);
            return format!(
                "{{ let mut made: Text<{len}> = Text::of(b\"{word}\"); made.push({byte}); made }}"
            );
        }
        if self.one_in(4) {
            return format!("Text::<{len}>::new()");
        }
        format!("Text::<{len}>::of(b\"{}\")", self.random.of(&WORDS))
    }

    /// Returns a query on a text: a `bool` or an integer.
    pub fn of_text(&mut self, ty: &Ty, fuel: usize) -> Option<String> {
        let place = self.place(false, &|it| matches!(it, Ty::Text(_)))?;
        let text = &place.text;
        self.lend(place.root, false);
        let said = match ty {
            Ty::Bool => match self.below(4) {
                0 => Some(format!("{text}.is_empty()")),
                1 => Some(format!("({text} == {})", self.value(&place.ty, fuel))),
                _ => {
                    let is = self.random.of(&["is", "starts_with"]);
                    Some(format!("{text}.{is}(b\"{}\")", self.random.of(&WORDS)))
                }
            },
            Ty::Int("usize") => Some(format!("{text}.{}()", self.random.of(&["len", "capacity"]))),
            Ty::Int("u8") => {
                let index = self.value(&Ty::Int("usize"), fuel);
                Some(format!("{text}.get({index}).unwrap_or(7)"))
            }
            _ => None,
        };
        self.end(place.root, false);
        said
    }

    /// A statement that changes a text.
    pub fn text_edit(&mut self, fuel: usize) -> Option<String> {
        let place = self.place(true, &|it| matches!(it, Ty::Text(_)))?;
        let Ty::Text(len) = place.ty else { return None };
        let text = &place.text;
        self.lend(place.root, true);
        let edited = match self.below(5) {
            0 => format!("{text}.clear();"),
            1 => format!("{text}.truncate({});", self.below(len)),
            2 if self.risky() => format!("{text}.append(b\"{}\");", self.random.of(&WORDS)),
            3 if self.risky() => format!("{text}.push({});", self.value(&Ty::Int("u8"), fuel)),
            _ => {
                let byte = self.value(&Ty::Int("u8"), fuel);
                format!("if {text}.len() < {len} {{ {text}.push({byte}); }}")
            }
        };
        self.end(place.root, true);
        Some(edited)
    }
}
