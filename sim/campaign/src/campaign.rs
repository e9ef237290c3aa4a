//! A scenario by seed: its name, its columns, and one run.
//!
//! Invariant: a run depends on the seed and on the campaign's version, options and models, and on nothing else. So runs can
//! be made in any order, on any machine, and again.

use crate::fingerprint::fingerprint;
use crate::rare::Rare;

/// Value of a cell.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// A number, in the column's unit.
    Number(f64),
    /// A text. In a file, commas become semicolons, double quotes become single ones, and control characters become blanks.
    Text(String),
    /// True or false.
    Truth(bool),
}

impl From<f64> for Value {
    fn from(number: f64) -> Self {
        Self::Number(number)
    }
}

impl From<bool> for Value {
    fn from(truth: bool) -> Self {
        Self::Truth(truth)
    }
}

impl From<String> for Value {
    fn from(text: String) -> Self {
        Self::Text(text)
    }
}

impl From<&str> for Value {
    fn from(text: &str) -> Self {
        Self::Text(text.to_owned())
    }
}

/// Type of a column's values.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Type {
    /// Numbers.
    Number,
    /// Texts.
    Text,
    /// True or false.
    Truth,
}

/// End of a column's range that is the worst.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Worst {
    /// The largest.
    Largest,
    /// The smallest.
    Smallest,
}

/// Column of a campaign's results.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Column {
    pub(crate) name: String,
    pub(crate) unit: String,
    pub(crate) about: String,
    pub(crate) values: Type,
    pub(crate) decimals: Option<usize>,
    pub(crate) may_be_infinite: bool,
    pub(crate) worst: Option<Worst>,
}

impl Column {
    fn new(name: &str, values: Type) -> Self {
        let (unit, about) = (String::new(), String::new());
        let name = name.to_owned();
        Self { name, unit, about, values, decimals: None, may_be_infinite: false, worst: None }
    }

    /// Creates a column of numbers in a unit, such as `m/s`; the unit may be empty.
    pub fn number(name: &str, unit: &str) -> Self {
        Self { unit: unit.to_owned(), ..Self::new(name, Type::Number) }
    }

    /// Creates a column of texts.
    pub fn text(name: &str) -> Self {
        Self::new(name, Type::Text)
    }

    /// Creates a column of truths.
    pub fn truth(name: &str) -> Self {
        Self::new(name, Type::Truth)
    }

    /// Describes the column on the summary page.
    #[must_use]
    pub fn about(self, about: &str) -> Self {
        Self { about: about.to_owned(), ..self }
    }

    /// Rounds the numbers in the file to this many decimals; without it, a file has every bit of them.
    #[must_use]
    pub fn decimals(self, decimals: usize) -> Self {
        Self { decimals: Some(decimals), ..self }
    }

    /// Allows infinite numbers, such as the time of something that never happened. Without it, a run with one has failed.
    #[must_use]
    pub fn or_infinite(self) -> Self {
        Self { may_be_infinite: true, ..self }
    }

    /// Lists the seeds with the worst values on the summary page.
    #[must_use]
    pub fn worst(self, worst: Worst) -> Self {
        Self { worst: Some(worst), ..self }
    }
}

/// Repetition of one run, for a person who looks into it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Replay {
    /// Command that runs the seed and shows the run; it may be empty.
    pub command: String,
    /// Address of a page that shows the run; it may be empty.
    pub link: String,
}

/// A scenario by seed.
pub trait Campaign: Sync {
    /// Returns the name of the campaign: lower-case letters, digits, `-` and `_`.
    fn kind(&self) -> &str;

    /// Returns the version of the scenario. Raise it when runs of the same seed change for a reason that [`Self::models`] does
    /// not cover, such as another plant.
    fn version(&self) -> u32;

    /// Returns the options of the scenario as text, such as `hill=0.05`; empty if it has none.
    fn options(&self) -> String {
        String::new()
    }

    /// Returns a hash of the models under test: usually [`fingerprint`] of their sources.
    fn models(&self) -> String;

    /// Returns the columns of a row, without the seed.
    fn columns(&self) -> Vec<Column>;

    /// Runs a seed, and returns a value for each column.
    ///
    /// # Errors
    ///
    /// The reason why there is no result. A panic, a NaN, and an infinite number in a column without
    /// [`Column::or_infinite`] count as such a reason, too.
    fn run(&self, seed: u64) -> Result<Vec<Value>, String>;

    /// Returns how many seeds [`Self::run_together`] runs at once, such as the lanes of vectors; 1 if each is run alone.
    fn together(&self) -> usize {
        1
    }

    /// Runs several seeds at once, and returns what [`Self::run`] returns for each, to the bit.
    ///
    /// If it panics or returns another number of results, each seed is run alone.
    fn run_together(&self, seeds: &[u64]) -> Vec<Result<Vec<Value>, String>> {
        seeds.iter().map(|seed| self.run(*seed)).collect()
    }

    /// Returns the fault of a completed run, such as "left the lane"; `None` if it is as it must be.
    fn fault(&self, row: &[Value]) -> Option<String> {
        let _ = row;
        None
    }

    /// Returns how the run of a seed is repeated and shown.
    fn replay(&self, seed: u64) -> Replay {
        let _ = seed;
        Replay::default()
    }

    /// Returns the scenario as a function of random numbers, for the search for rare failures; `None` if it has no such form.
    fn rare(&self) -> Option<&dyn Rare> {
        None
    }
}

/// A campaign of a closure: for small programs and tests.
pub struct Simple<F> {
    /// Name.
    pub kind: &'static str,
    /// Version of the scenario.
    pub version: u32,
    /// Sources of the models.
    pub sources: &'static [&'static str],
    /// Columns of a row.
    pub columns: Vec<Column>,
    /// A run.
    pub run: F,
}

impl<F: Fn(u64) -> Result<Vec<Value>, String> + Sync> Campaign for Simple<F> {
    fn kind(&self) -> &str {
        self.kind
    }

    fn version(&self) -> u32 {
        self.version
    }

    fn models(&self) -> String {
        fingerprint(self.sources)
    }

    fn columns(&self) -> Vec<Column> {
        self.columns.clone()
    }

    fn run(&self, seed: u64) -> Result<Vec<Value>, String> {
        (self.run)(seed)
    }
}
