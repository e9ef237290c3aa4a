//! Facts about symbols at a point, their consequences, and formulas.

use std::cell::Cell;
use std::rc::Rc;

use super::facts::{About, Facts};
use super::linear::{Linear, Symbol};
use super::persistent::Map;
use bessemer_ir::used::Rule;

/// Least and greatest value.
pub(super) type Bounds = (i128, i128);

/// A statement about symbols; only its leaves are negated.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) enum Formula {
    /// The form is at least 0.
    Natural(Linear),
    /// The symbol, which is 0 or 1, is 1; or with `false`, is 0.
    Is(Symbol, bool),
    All(Vec<Formula>),
    Any(Vec<Formula>),
}

impl Formula {
    pub(super) fn constant(truth: bool) -> Formula {
        if truth { Formula::All(Vec::new()) } else { Formula::Any(Vec::new()) }
    }

    pub(super) fn not(&self) -> Formula {
        match self {
            Formula::Natural(form) => Formula::Natural(form.below()),
            Formula::Is(symbol, truth) => Formula::Is(*symbol, !truth),
            Formula::All(all) => Formula::Any(all.iter().map(Formula::not).collect()),
            Formula::Any(any) => Formula::All(any.iter().map(Formula::not).collect()),
        }
    }
}

/// Largest number of forms subtracted from a goal, one after another.
const STEPS: u32 = 3;
/// Largest number where paths meet.
const MEETING: u32 = 2;
/// Largest nesting of case distinctions.
const CASES: u32 = 2;
/// Largest number of attempts for a goal.
const ATTEMPTS: u32 = 3000;

/// Facts at a point.
#[derive(Clone, Default)]
pub(super) struct Knowledge {
    bounds: Map<Bounds>,
    /// Forms that are 0 or more.
    forms: Facts<Linear>,
    /// Clauses: of each, at least one alternative is true.
    clauses: Facts<Vec<Formula>>,
    /// True if the point is unreachable: the facts contradict each other.
    pub(super) dead: bool,
}

impl Knowledge {
    /// Returns the bounds of a symbol, at least as narrow as those of its type.
    pub(super) fn of(&self, symbol: Symbol, all: &[Bounds]) -> Bounds {
        self.bounds.get(symbol.0).copied().unwrap_or(all[symbol.0 as usize])
    }

    /// Returns the least value of a form by the bounds of its symbols.
    fn plain(&self, form: &Linear, all: &[Bounds]) -> i128 {
        form.parts.iter().fold(form.constant, |sum, (symbol, factor)| {
            let (low, high) = self.of(*symbol, all);
            sum + factor * if *factor > 0 { low } else { high }
        })
    }

    /// Returns the least and the greatest value of a form by the bounds of its symbols.
    pub(super) fn range(&self, form: &Linear, all: &[Bounds]) -> Bounds {
        (self.plain(form, all), -self.plain(&form.below(), all) - 1)
    }

    pub(super) fn refine(&mut self, symbol: Symbol, (low, high): Bounds, all: &[Bounds]) {
        let (from, to) = self.of(symbol, all);
        let narrowed = (from.max(low), to.min(high));
        self.dead |= narrowed.0 > narrowed.1;
        if narrowed != (from, to) && !self.dead {
            self.bounds.insert(symbol.0, narrowed);
        }
    }

    /// Adds the fact that the form is at least 0.
    fn natural(&mut self, form: &Linear, all: &[Bounds]) {
        if let Some(number) = form.as_number() {
            self.dead |= number < 0;
            return;
        }
        // Each symbol by the bounds of the others: factor · symbol >= -(the most of the rest).
        for (symbol, factor) in &form.parts {
            let rest = form.plus(-factor, &Linear::symbol(*symbol));
            let Some(rest) = rest.map(|rest| self.range(&rest, all).1) else { continue };
            let bound = if *factor > 0 {
                (-rest.div_euclid(*factor), i128::MAX)
            } else {
                (i128::MIN, rest.div_euclid(-factor))
            };
            self.refine(*symbol, bound, all);
        }
        if form.parts.len() > 1 && !self.forms.contains(form) {
            self.dead |= self.reaches(&form.below(), 1, all, &Cell::new(ATTEMPTS));
            self.forms.push(form.clone());
        }
    }

    /// Adds the fact that a formula is true.
    pub(super) fn assume(&mut self, formula: &Formula, all: &[Bounds]) {
        match formula {
            Formula::Natural(form) => self.natural(form, all),
            Formula::Is(symbol, truth) => {
                let is = i128::from(*truth);
                self.refine(*symbol, (is, is), all);
            }
            Formula::All(parts) => parts.iter().for_each(|part| self.assume(part, all)),
            Formula::Any(parts) => {
                let may = |part: &&Formula| !self.follows(&part.not(), all, 0);
                let left: Vec<Formula> = parts.iter().filter(may).cloned().collect();
                match left.as_slice() {
                    [] => self.dead = true,
                    [one] => self.assume(one, all),
                    _ if self.clauses.contains(&left) => {}
                    _ => self.clauses.push(left),
                }
            }
        }
    }

    pub(super) fn assuming(&self, formula: &Formula, all: &[Bounds]) -> Knowledge {
        let mut knowledge = self.clone();
        knowledge.assume(formula, all);
        knowledge
    }

    /// Returns true if the facts prove a formula.
    pub(super) fn shows(&self, formula: &Formula, all: &[Bounds]) -> bool {
        self.follows(formula, all, CASES)
    }

    fn follows(&self, formula: &Formula, all: &[Bounds], cases: u32) -> bool {
        if self.dead {
            return true;
        }
        match formula {
            Formula::Natural(form) => {
                self.reaches(form, STEPS, all, &Cell::new(ATTEMPTS))
                    || self.by_cases(formula, all, cases)
            }
            Formula::Is(symbol, truth) => {
                let is = i128::from(*truth);
                self.of(*symbol, all) == (is, is) || self.by_cases(formula, all, cases)
            }
            Formula::All(parts) => parts.iter().all(|part| self.follows(part, all, cases)),
            Formula::Any(parts) => match parts.split_first() {
                None => false,
                Some((first, rest)) => {
                    self.clauses.contains(parts) || self.follows(first, all, cases) || {
                        let rest = Formula::Any(rest.to_vec());
                        self.assuming(&first.not(), all).follows(&rest, all, cases)
                    }
                }
            },
        }
    }

    /// Returns true if a form is at least 0, proved by subtracting known forms.
    fn reaches(&self, goal: &Linear, steps: u32, all: &[Bounds], left: &Cell<u32>) -> bool {
        self.plain(goal, all) >= 0
            || Rule::Forms.told(self.least(goal, steps, Some(0), all, left) >= 0)
    }

    /// Returns the forms that have a symbol with another, the latest first.
    pub(super) fn about(&self, form: &Linear) -> impl Iterator<Item = &Linear> {
        self.forms.about(form).map(|(_, form)| form)
    }

    /// Returns true if a form is at least 0 on a path, proved by the few steps that are taken where paths meet.
    pub(super) fn meets(&self, form: &Linear, all: &[Bounds]) -> bool {
        self.dead || self.reaches(form, MEETING, all, &Cell::new(ATTEMPTS))
    }

    /// Returns a lower bound of a form, found by subtracting known forms; the search stops at `enough`.
    fn least(
        &self,
        goal: &Linear,
        steps: u32,
        enough: Option<i128>,
        all: &[Bounds],
        left: &Cell<u32>,
    ) -> i128 {
        let mut best = self.plain(goal, all);
        if steps == 0 || goal.parts.is_empty() {
            return best;
        }
        for (_, form) in self.forms.about(goal) {
            for (symbol, factor) in &form.parts {
                if enough.is_some_and(|enough| best >= enough) {
                    return best;
                }
                let wanted = goal.factor(*symbol);
                if wanted == 0 || wanted % factor != 0 || wanted / factor < 0 {
                    continue;
                }
                let Some(attempts) = left.get().checked_sub(1) else { return best };
                left.set(attempts);
                if let Some(rest) = goal.plus(-(wanted / factor), form) {
                    best = best.max(self.least(&rest, steps - 1, enough, all, left));
                }
            }
        }
        best
    }

    /// Returns the closest provable bounds of a form.
    pub(super) fn closest(&self, form: &Linear, all: &[Bounds]) -> Bounds {
        let least = |form: &Linear| self.least(form, STEPS, None, all, &Cell::new(ATTEMPTS));
        (least(form), -least(&form.below()) - 1)
    }

    /// Returns true if a formula follows from each alternative of a clause.
    fn by_cases(&self, goal: &Formula, all: &[Bounds], cases: u32) -> bool {
        let Some(cases) = cases.checked_sub(1) else { return false };
        self.clauses.about(goal).any(|(number, clause)| {
            Rule::Cases.told({
                let mut without = self.clone();
                without.clauses.remove(number);
                clause.iter().all(|part| without.assuming(part, all).follows(goal, all, cases))
            })
        })
    }

    /// Keeps the facts that hold on both paths: also `forms` and `clauses` of one that follow from the other.
    pub(super) fn join(&mut self, other: &Knowledge, all: &[Bounds]) {
        if other.dead {
            return;
        }
        if self.dead {
            *self = other.clone();
            return;
        }
        let mine = self.clone();
        let follows = |form: &Linear, there: bool| {
            let knowledge = if there { other } else { &mine };
            knowledge.meets(form, all)
        };
        self.forms.join(&other.forms, follows);
        self.clauses.join(&other.clauses, |_, _| false);
        for (symbol, one, two) in self.bounds.differences(&other.bounds) {
            let hull = one.zip(two).map(|(one, two)| (one.0.min(two.0), one.1.max(two.1)));
            let narrow = hull.filter(|hull| *hull != all[symbol as usize]);
            self.bounds.set(symbol, narrow.map(Rc::new));
        }
    }
}

impl About for Formula {
    fn symbols(&self, each: &mut dyn FnMut(Symbol)) {
        match self {
            Formula::Natural(form) => form.symbols(each),
            Formula::Is(symbol, _) => each(*symbol),
            Formula::All(parts) | Formula::Any(parts) => parts.symbols(each),
        }
    }
}

impl About for Vec<Formula> {
    fn symbols(&self, each: &mut dyn FnMut(Symbol)) {
        self.iter().for_each(|part| part.symbols(each));
    }
}
