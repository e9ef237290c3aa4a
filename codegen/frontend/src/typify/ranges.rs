//! Checks each `#[range]` against the type and the default of its number.
//!
//! Invariant: no computation depends on a range. A default can be checked if the module contains its words.

use bessemer_ir::{Float, Form, Given, Module, Range, Scalar, Span, StructId, Type};

use crate::diagnostic::Diagnostic;

/// Returns errors about ranges of types that are not numeric, and about defaults outside their ranges.
pub(super) fn wrong(module: &Module) -> Vec<Diagnostic> {
    let mut walk = Walk { module, found: Vec::new() };
    for item in &module.structs {
        for field in &item.fields {
            walk.number(&field.name, &field.ty, &field.given, item.span);
        }
    }
    for function in &module.functions {
        for local in function.parameters() {
            if let Some(given) = function.attributes.parameter(&local.name) {
                walk.number(&local.name, &local.ty, given, function.span);
            }
        }
    }
    for (index, item) in module.structs.iter().enumerate() {
        if let Some(words) = item.initial.as_deref().or(item.defaults.as_deref()) {
            walk.fields(StructId(index as u32), words, &format!("{}::default()", item.name));
        }
    }
    walk.found
}

struct Walk<'m> {
    module: &'m Module,
    found: Vec<Diagnostic>,
}

impl Walk<'_> {
    /// Reports an error at the range, once: instances of a generic item share it, as do defaults that contain it.
    fn tell(&mut self, given: &Given, home: Span, message: String, help: &str) {
        let file = self.module.files.get(home.file as usize).cloned().unwrap_or_default();
        let (line, column) = (given.site.0, given.site.1);
        let at = |it: &Diagnostic| (&it.file, it.line, it.column) == (&file, line, column);
        if !self.found.iter().any(at) {
            let help = help.to_owned();
            let error = Diagnostic { file, line, column, message, help, ..Diagnostic::default() };
            self.found.push(error);
        }
    }

    /// Checks that the type of a field with a range is numeric.
    fn number(&mut self, name: &str, ty: &Type, given: &Given, home: Span) {
        if given.range.is_some() && !self.has_range(ty) {
            let message = format!("`{name}` is not a number, so it cannot have a `#[range]`");
            let help = "remove `#[range(…)]`, or move it to a number";
            self.tell(given, home, message, help);
        }
    }

    /// Returns true if a type has numbers that can have a range. The fields of a struct that represents a standard or
    /// library type cannot, since no attribute can be written on them.
    fn has_range(&self, ty: &Type) -> bool {
        match ty {
            Type::Scalar(scalar) | Type::Matrix { element: scalar, .. } => *scalar != Scalar::Bool,
            Type::Array { element, .. } | Type::Slice(element) => self.has_range(element),
            Type::Struct(id) => {
                let item = &self.module.structs[id.index()];
                item.form != Form::Record || item.module.starts_with("bessemer::")
            }
            Type::Unit | Type::Enum(_) => false,
        }
    }

    /// Checks the fields of a default, whose words are `words`, against their ranges.
    fn fields(&mut self, id: StructId, words: &[u64], path: &str) {
        let module = self.module;
        let item = &module.structs[id.index()];
        let (first, mut rest) = (words.first().copied().unwrap_or_default(), words);
        for (index, field) in item.fields.iter().enumerate() {
            let (mut own, later) = rest.split_at(module.width(&field.ty).min(rest.len()));
            rest = later;
            if !item.holds(index, first) {
                continue;
            }
            if let (Form::Sequence, Type::Array { element, .. }) = (&item.form, &field.ty) {
                // Nobody reads what follows the elements.
                let held = module.width(element).saturating_mul(first as usize);
                own = &own[..held.min(own.len())];
            }
            let path = format!("{path}.{}", field.name);
            if let Some(range) = field.given.range {
                self.within(range, &field.ty, own, (&path, &field.given, item.span));
            }
            self.value(&field.ty, own, &path);
        }
    }

    fn value(&mut self, ty: &Type, words: &[u64], path: &str) {
        match ty {
            Type::Struct(id) => self.fields(*id, words, path),
            Type::Array { element, .. } if !matches!(**element, Type::Scalar(_)) => {
                let each = self.module.width(element).max(1);
                words.chunks(each).for_each(|words| self.value(element, words, path));
            }
            _ => {}
        }
    }

    /// Checks the numbers of a field's default against its range.
    fn within(&mut self, range: Range, ty: &Type, words: &[u64], at: (&str, &Given, Span)) {
        let (mut element, mut many) = (ty, false);
        while let Type::Array { element: inner, .. } = element {
            (element, many) = (inner, true);
        }
        let scalar = match element {
            Type::Scalar(scalar) => *scalar,
            Type::Matrix { element, .. } => {
                many = true;
                *element
            }
            _ => return,
        };
        let (path, given, home) = at;
        let (low, high) = (range.low(), range.high());
        let single = scalar == Scalar::Float(Float::F32);
        // The ends are rounded as the number is. NaN is in no range.
        let [first, last] = [low, high].map(|end| if single { f64::from(end as f32) } else { end });
        let mut numbers = words.iter().map(|word| number(scalar, *word));
        let outside = numbers.find(|(it, _)| !(first <= *it && *it <= last));
        if let Some((_, shown)) = outside {
            let what = if many { format!("an element of `{path}`") } else { format!("`{path}`") };
            let message = format!("{what} is {shown}, outside of {low:?}..={high:?}");
            let help = "let the default lie within the range, or widen the range";
            self.tell(given, home, message, help);
        }
    }
}

/// Returns a number of a default as a value and as text.
fn number(scalar: Scalar, word: u64) -> (f64, String) {
    match scalar {
        Scalar::Float(Float::F32) => {
            let value = f32::from_bits(word as u32);
            (f64::from(value), format!("{value:?}"))
        }
        Scalar::Float(Float::F64) => {
            let value = f64::from_bits(word);
            (value, format!("{value:?}"))
        }
        Scalar::Int(int) => {
            let value = int.from_word(word);
            (value as f64, value.to_string())
        }
        Scalar::Bool => (word as f64, word.to_string()),
    }
}
