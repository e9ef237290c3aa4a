//! Figures of a flight and their limits, which determine its verdict.

use std::fmt;

/// Limit of a figure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Limit {
    /// An upper limit.
    AtMost(f64),
    /// A lower limit.
    AtLeast(f64),
    /// A lower and an upper limit.
    Between(f64, f64),
    /// No limit: the value is only reported.
    Reported,
    /// The value must be 1, which means that a statement holds.
    Holds,
}

/// A figure of a flight.
#[derive(Clone, Debug, PartialEq)]
pub struct Check {
    /// Name of the figure.
    pub what: String,
    /// Value of the figure.
    pub value: f64,
    /// Limit of the figure.
    pub limit: Limit,
    /// Unit of the figure.
    pub unit: &'static str,
}

impl Check {
    /// Creates a figure with an upper limit.
    pub fn at_most(what: &str, value: f64, limit: f64, unit: &'static str) -> Self {
        Self { what: what.to_owned(), value, limit: Limit::AtMost(limit), unit }
    }

    /// Creates a figure with a lower limit.
    pub fn at_least(what: &str, value: f64, limit: f64, unit: &'static str) -> Self {
        Self { what: what.to_owned(), value, limit: Limit::AtLeast(limit), unit }
    }

    /// Creates a figure with a lower and an upper limit.
    pub fn between(what: &str, value: f64, least: f64, most: f64, unit: &'static str) -> Self {
        Self { what: what.to_owned(), value, limit: Limit::Between(least, most), unit }
    }

    /// Creates a figure without a limit.
    pub fn reported(what: &str, value: f64, unit: &'static str) -> Self {
        Self { what: what.to_owned(), value, limit: Limit::Reported, unit }
    }

    /// Creates a statement that must hold.
    pub fn holds(what: &str, holds: bool) -> Self {
        let value = if holds { 1.0 } else { 0.0 };
        Self { what: what.to_owned(), value, limit: Limit::Holds, unit: "" }
    }

    /// Returns true if the value is within its limit; NaN never is.
    pub fn passes(&self) -> bool {
        match self.limit {
            Limit::AtMost(most) => self.value <= most,
            Limit::AtLeast(least) => self.value >= least,
            Limit::Between(least, most) => least <= self.value && self.value <= most,
            Limit::Reported => true,
            Limit::Holds => self.value == 1.0,
        }
    }

    /// Formats the limit for people.
    pub fn limit_text(&self) -> String {
        match self.limit {
            Limit::AtMost(most) => format!("≤ {}", with_unit(most, self.unit)),
            Limit::AtLeast(least) => format!("≥ {}", with_unit(least, self.unit)),
            Limit::Between(least, most) => {
                format!("{} … {}", number(least), with_unit(most, self.unit))
            }
            Limit::Reported | Limit::Holds => String::new(),
        }
    }

    /// Formats the value for people.
    pub fn value_text(&self) -> String {
        match self.limit {
            Limit::Holds if self.passes() => "yes".to_owned(),
            Limit::Holds => "no".to_owned(),
            _ => with_unit(self.value, self.unit),
        }
    }
}

impl fmt::Display for Check {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {} {}", self.what, self.value_text(), self.limit_text())
    }
}

/// Formats a fraction as a percentage, and other values with their unit.
fn with_unit(value: f64, unit: &str) -> String {
    match unit {
        "" => format!("{:.2} %", 100.0 * value),
        "°" => format!("{}°", number(value)),
        unit => format!("{} {unit}", number(value)),
    }
}

fn number(value: f64) -> String {
    if value.abs() >= 100.0 { format!("{value:.1}") } else { format!("{value:.3}") }
}
