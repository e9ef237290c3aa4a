//! User's functions that replace kernels: a vendor's library, or assembly.
//!
//! A table selects kernels by routine, type and size, and has the code to call instead. The first matching entry is
//! used; a kernel without a match is unchanged. The C keeps the kernel as well; the macro `BESSEMER_OWN_KERNELS`
//! selects it.
//!
//! The library decides the bits of the result: they equal Rust's only if it computes in the kernel's order.

use bessemer_ir::{Float, Kernel, KernelRoutine};
use serde_json::Value;

use super::Source;

/// Replacement of some kernels.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Replacement {
    /// The routine.
    pub routine: KernelRoutine,
    /// Element type; any if there is none.
    pub element: Option<Float>,
    /// Smallest allowed value of every dimension.
    pub at_least: u32,
    /// Largest allowed value of every dimension.
    pub at_most: u32,
    /// Name of the library, for the report.
    pub library: String,
    /// Header to include: `<cblas.h>`, `"fast.h"`.
    pub include: String,
    /// Lines of C: the body of the kernel's function. `{0}` to `{2}` represent its dimensions.
    pub body: Vec<String>,
}

/// Errors of a replacement table.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Error {
    /// The text is not JSON.
    #[error("line {line}, column {column}: {message}")]
    Text {
        /// Line of the error.
        line: usize,
        /// Column of the error.
        column: usize,
        /// Message of the parser.
        message: String,
    },
    /// The JSON is not a list of objects.
    #[error("a table of replacements is a list: `[{{\"routine\": \"product\", …}}]`")]
    Shape,
    /// An entry lacks a field, or a field has an invalid value.
    #[error("entry {entry}, `{field}`: {expected}")]
    Field {
        /// Index of the entry, from 1.
        entry: usize,
        /// Name of the field.
        field: String,
        /// Expected value.
        expected: String,
    },
}

/// Reads a table.
///
/// # Errors
/// See [`Error`].
pub fn parse(text: &str) -> Result<Vec<Replacement>, Error> {
    let table: Value = serde_json::from_str(text).map_err(|error| Error::Text {
        line: error.line(),
        column: error.column(),
        message: error.to_string(),
    })?;
    let entries = table.as_array().ok_or(Error::Shape)?;
    entries
        .iter()
        .enumerate()
        .map(|(index, entry)| Entry { number: index + 1, entry }.read())
        .collect()
}

struct Entry<'a> {
    number: usize,
    entry: &'a Value,
}

const FIELDS: [&str; 7] =
    ["routine", "element", "at_least", "at_most", "library", "include", "body"];

impl Entry<'_> {
    fn read(&self) -> Result<Replacement, Error> {
        let object = self.entry.as_object().ok_or(Error::Shape)?;
        if let Some(field) = object.keys().find(|field| !FIELDS.contains(&field.as_str())) {
            return Err(self.error(field, &format!("one of {}", FIELDS.join(", "))));
        }
        let names = KernelRoutine::ALL.map(KernelRoutine::name).join(", ");
        let routine = KernelRoutine::from_name(self.text("routine")?)
            .ok_or_else(|| self.error("routine", &format!("one of {names}")))?;
        let element = match self.entry.get("element").map(Value::as_str) {
            None => None,
            Some(Some("f64")) => Some(Float::F64),
            Some(Some("f32")) => Some(Float::F32),
            Some(_) => return Err(self.error("element", "\"f64\" or \"f32\"")),
        };
        let lines = self.entry.get("body").and_then(Value::as_array);
        let lines = lines.ok_or_else(|| self.error("body", "a list of lines of C"))?;
        let body: Option<Vec<String>> =
            lines.iter().map(|line| line.as_str().map(str::to_owned)).collect();
        let body = body.ok_or_else(|| self.error("body", "a list of lines of C"))?;
        Ok(Replacement {
            routine,
            element,
            at_least: self.number("at_least", 1)?,
            at_most: self.number("at_most", u32::MAX)?,
            library: self.text("library")?.to_owned(),
            include: self.text("include")?.to_owned(),
            body,
        })
    }

    fn text(&self, field: &str) -> Result<&str, Error> {
        let text = self.entry.get(field).and_then(Value::as_str);
        text.ok_or_else(|| self.error(field, "a text"))
    }

    fn number(&self, field: &str, otherwise: u32) -> Result<u32, Error> {
        let Some(value) = self.entry.get(field) else { return Ok(otherwise) };
        let number = value.as_u64().and_then(|number| u32::try_from(number).ok());
        number.ok_or_else(|| self.error(field, "a whole number"))
    }

    fn error(&self, field: &str, expected: &str) -> Error {
        Error::Field { entry: self.number, field: field.into(), expected: expected.into() }
    }
}

impl Replacement {
    /// Returns the first entry of a table that matches a kernel.
    pub fn of<'a>(table: &'a [Replacement], kernel: &Kernel) -> Option<&'a Replacement> {
        table.iter().find(|it| {
            it.routine == kernel.routine
                && it.element.is_none_or(|element| element == kernel.element)
                && kernel.dims.iter().all(|dim| (it.at_least..=it.at_most).contains(dim))
        })
    }

    /// Returns the kernel's C with the replacement before it; `lends` is true if a caller passes memory to it.
    pub fn replace(&self, kernel: &Kernel, own: Source, lends: bool) -> Source {
        let mut lines = self.body.join("\n");
        for (index, dim) in kernel.dims.iter().enumerate() {
            lines = lines.replace(&format!("{{{index}}}"), &dim.to_string());
        }
        if lends {
            lines = format!("(void)work;\n{lines}");
        }
        let switch = "#if !defined(BESSEMER_OWN_KERNELS)\n";
        let note = format!("/* {}: its order of operations, and its bits. */", self.library);
        let before = format!("{switch}#include {}\n#else\n{}\n#endif", self.include, own.before);
        let body = format!("{switch}{note}\n{}\n#else\n{}#endif\n", lines.trim_end(), own.body);
        Source { before, body, ..own }
    }
}

#[cfg(test)]
mod tests {
    use bessemer_ir::{Float, Kernel, KernelRoutine};

    use super::{Error, Replacement, parse};

    const TABLE: &str = r#"[
        {"routine": "product", "element": "f64", "at_least": 16, "library": "CBLAS",
         "include": "<cblas.h>", "body": ["f({0}, {1}, {2});"]}
    ]"#;

    #[test]
    fn an_entry_fits_by_routine_type_and_size() {
        let table = parse(TABLE).expect("sound");
        let fits = |routine, element, dims: &[u32]| {
            let kernel = Kernel::new(routine, element, dims).expect("sound");
            Replacement::of(&table, &kernel).is_some()
        };
        assert!(fits(KernelRoutine::Product, Float::F64, &[16, 20, 30]));
        assert!(!fits(KernelRoutine::Product, Float::F64, &[16, 15, 30]));
        assert!(!fits(KernelRoutine::Product, Float::F32, &[16, 20, 30]));
        assert!(!fits(KernelRoutine::TrMul, Float::F64, &[16, 20, 30]));
    }

    #[test]
    fn mistakes_are_told() {
        assert!(matches!(parse("["), Err(Error::Text { line: 1, .. })));
        assert_eq!(parse("{}"), Err(Error::Shape));
        let error = parse(&TABLE.replace("product", "matmul")).expect_err("no such routine");
        assert!(
            error
                .to_string()
                .starts_with("entry 1, `routine`: one of product, product_tr, tr_product, tr_mul")
        );
        let error = parse(&TABLE.replace("at_least", "atleast")).expect_err("no such field");
        assert!(error.to_string().starts_with("entry 1, `atleast`: one of routine"));
    }
}
