//! Constants of a model, as Rust: what a build script writes, and the model includes.
//!
//! ```no_run
//! // build.rs
//! use bessemer_design::constants::Constants;
//!
//! let folder = std::env::var("OUT_DIR").expect("cargo sets it");
//! let text = Constants::new().number("GAIN", "Gain of the loop, V/A", 2.5).text();
//! std::fs::write(format!("{folder}/design.rs"), text).expect("the folder is there");
//! ```
//!
//! The model has `include!(concat!(env!("OUT_DIR"), "/design.rs"));`.

use std::fmt::Write as _;

use bessemer_blocks::Section;
use nalgebra::SMatrix;

/// Text of constants.
#[derive(Clone, Debug, Default)]
pub struct Constants {
    text: String,
    is_single: bool,
}

impl Constants {
    /// Begins without constants, in double precision.
    pub fn new() -> Self {
        Constants::default()
    }

    /// Begins without constants, in single precision: each number is rounded to `f32`.
    pub fn single() -> Self {
        Constants { is_single: true, ..Constants::default() }
    }

    /// Adds a number, with its documentation: one sentence with the unit.
    pub fn number(self, name: &str, about: &str, value: f64) -> Self {
        let (ty, value) = (self.float().to_owned(), self.literal(value));
        self.constant(name, about, &ty, &value)
    }

    /// Adds a matrix of nalgebra.
    pub fn matrix<const R: usize, const C: usize>(
        self,
        name: &str,
        about: &str,
        value: &SMatrix<f64, R, C>,
    ) -> Self {
        let column = |column: usize| {
            let numbers = (0..R).map(|row| self.literal(value[(row, column)]));
            format!("[{}]", numbers.collect::<Vec<_>>().join(", "))
        };
        let columns: Vec<String> = (0..C).map(column).collect();
        let ty = format!("bessemer::nalgebra::SMatrix<{}, {R}, {C}>", self.float());
        let value = format!(
            "bessemer::nalgebra::SMatrix::from_array_storage(bessemer::nalgebra::ArrayStorage([{}]))",
            columns.join(", ")
        );
        self.constant(name, about, &ty, &value)
    }

    /// Adds the sections of a filter.
    pub fn sections(self, name: &str, about: &str, value: &[Section<f64>]) -> Self {
        let section = |it: &Section<f64>| {
            let [b0, b1, b2, a1, a2] =
                [it.b0, it.b1, it.b2, it.a1, it.a2].map(|it| self.literal(it));
            format!(
                "bessemer_blocks::Section {{ b0: {b0}, b1: {b1}, b2: {b2}, a1: {a1}, a2: {a2} }}"
            )
        };
        let sections: Vec<String> = value.iter().map(section).collect();
        let ty = format!("[bessemer_blocks::Section<{}>; {}]", self.float(), value.len());
        let value = format!("[{}]", sections.join(", "));
        self.constant(name, about, &ty, &value)
    }

    /// Returns the text of the constants.
    pub fn text(self) -> String {
        self.text
    }

    fn constant(mut self, name: &str, about: &str, ty: &str, value: &str) -> Self {
        let _ = writeln!(self.text, "/// {about}.\npub const {name}: {ty} = {value};");
        self
    }

    fn float(&self) -> &'static str {
        if self.is_single { "f32" } else { "f64" }
    }

    /// Returns the shortest literal that is read back as the same number.
    fn literal(&self, value: f64) -> String {
        if self.is_single { format!("{:?}", value as f32) } else { format!("{value:?}") }
    }
}
