//! Random matrices of bounded size.

use super::types::{Ty, path};
use super::writer::{Place, Writer};

type Shape = (&'static str, usize, usize);

impl Writer<'_> {
    pub fn bounded(&mut self, (element, rows, cols): Shape, fuel: usize) -> String {
        let ty = Ty::Bounded(element, rows, cols);
        let path = path(&self.items.name(&ty));
        let (least_rows, least_cols) = (self.below(rows + 1), self.below(cols + 1));
        let Some(less) = fuel.checked_sub(1) else {
            return format!("{path}::new({least_rows}, {least_cols})");
        };
        match self.below(8) {
            0 | 1 => {
                let from = Ty::Matrix(element, 1 + self.below(rows), 1 + self.below(cols));
                format!("{path}::from_matrix(&{})", self.value(&from, less))
            }
            2 => {
                let from = self.value(&Ty::Bounded(element, cols, rows), less);
                format!("{from}.transpose()")
            }
            3 if element.starts_with('f') && self.risky() => {
                let (one, other) = (self.value(&ty, less), self.value(&ty, less));
                format!("({one} {} {other})", self.random.of(&["+", "-"]))
            }
            4 if element.starts_with('f') => {
                let (one, by) = (self.value(&ty, less), self.value(&ty.element(), less));
                format!("({one} * {by})")
            }
            5 if element.starts_with('f') && self.risky() => {
                let inner = 1 + self.below(3);
                let one = self.value(&Ty::Bounded(element, rows, inner), less);
                let other = self.value(&Ty::Bounded(element, inner, cols), less);
                format!("({one} * {other})")
            }
            _ => {
                let value = self.value(&ty.element(), less);
                format!(
                    "{{ let mut made = {path}::new(0, 0); made.resize({least_rows}, {least_cols}, {value}); made }}"
                )
            }
        }
    }

    /// A number out of a bounded matrix.
    pub fn of_bounded(&mut self, ty: &Ty, fuel: usize) -> Option<String> {
        let sized = *ty == Ty::Int("usize");
        let place = self.place(false, &|it| match it {
            Ty::Bounded(..) => sized || it.element() == *ty,
            _ => false,
        })?;
        self.lend(place.root, false);
        let text = &place.text;
        let said = if sized {
            format!("{text}.{}()", self.random.of(&["nrows", "ncols", "len"]))
        } else {
            let kept = self.freeze_all(true);
            let otherwise = self.value(ty, fuel);
            self.thaw(kept);
            format!(
                "(if {text}.is_empty() {{ {otherwise} }} else {{ {text}[(0, {text}.ncols() - 1)] }})"
            )
        };
        self.end(place.root, false);
        Some(said)
    }

    /// A statement that changes a bounded matrix.
    pub fn bounded_edit(&mut self, fuel: usize) -> Option<String> {
        let place = self.place(true, &|ty| matches!(ty, Ty::Bounded(..)))?;
        self.lend(place.root, true);
        let text = self.resized(&place, fuel);
        self.end(place.root, true);
        text
    }

    fn resized(&mut self, place: &Place, fuel: usize) -> Option<String> {
        let Ty::Bounded(_, rows, cols) = place.ty else { return None };
        let (text, of) = (&place.text, place.ty.element());
        let (row, col) = (self.below(rows), self.below(cols));
        Some(match self.below(8) {
            7 => {
                let value = self.value(&of, fuel);
                let leaving = self.random.of(&["break", "continue"]);
                format!(
                    "for each in {text}.iter_mut() {{ if *each == {value} {{ {leaving}; }} *each = {value}; }}",
                )
            }
            0 => format!("{text}.fill({});", self.value(&of, fuel)),
            1 => format!("{text}.clear();"),
            2 => format!("{text}.resize({}, {}, {});", row + 1, col + 1, self.value(&of, fuel)),
            3 => format!("let _ = {text}.{}();", self.random.of(&["pop_row", "pop_column"])),
            4 if self.risky() => {
                let row = self.value(&Ty::Array(Box::new(of), cols), fuel);
                format!("{text}.push_row(&{row});")
            }
            _ if self.risky() => format!("{text}[({row}, {col})] = {};", self.value(&of, fuel)),
            _ => format!(
                "if {text}.nrows() > {row} && {text}.ncols() > {col} {{ {text}[({row}, {col})] = {}; }}",
                self.value(&of, fuel)
            ),
        })
    }
}
