//! Canonical words of a value: words without a meaning are zero.

use crate::ir::{Form, Module, Struct, Type};

impl Module {
    /// Sets the meaningless words of a value of type `ty` to zero, and returns the words after the value. Meaningless
    /// are the fields that a [`Choice`](Form::Choice) does not select, and the elements after the end of a
    /// [`Sequence`](Form::Sequence).
    pub fn canonical<'w>(&self, ty: &Type, words: &'w mut [u64]) -> &'w mut [u64] {
        match ty {
            Type::Array { element, len } => {
                (0..*len).fold(words, |words, _| self.canonical(element, words))
            }
            Type::Struct(id) => self.canonical_struct(&self.structs[id.index()], words),
            other => {
                let count = self.width(other).min(words.len());
                &mut words[count..]
            }
        }
    }

    fn canonical_struct<'w>(&self, definition: &Struct, mut words: &'w mut [u64]) -> &'w mut [u64] {
        let first = words.first().copied().unwrap_or_default();
        for (index, field) in definition.fields.iter().enumerate() {
            let count = self.width(&field.ty).min(words.len());
            let (own, rest) = core::mem::take(&mut words).split_at_mut(count);
            let held = match &definition.form {
                Form::Record | Form::Lent | Form::Shared => count,
                _ if index == 0 => count,
                Form::Choice(chosen) => {
                    let chosen = chosen.get(first as usize).copied().flatten();
                    if chosen == Some(index as u32) { count } else { 0 }
                }
                Form::Sequence => match field.ty {
                    Type::Array { len, .. } => {
                        count / (len as usize).max(1) * first.min(u64::from(len)) as usize
                    }
                    _ => count,
                },
            };
            own[held..].fill(0);
            self.canonical(&field.ty, own);
            words = rest;
        }
        words
    }
}
