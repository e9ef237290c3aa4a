//! Number of passes of a loop: from its ends, if they are known within limits, or from what its counter indexes.

use std::collections::BTreeMap;

use bessemer_ir::visit::Walk;
use bessemer_ir::{
    BinaryOp, Block, Expr, ExprKind, Function, Int, Intrinsic, LocalId, Module, Place, Step,
    StmtKind, Type,
};

/// Source of a number of passes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// Both ends are constants.
    Constants,
    /// The ends lie within limits: of counters of outer loops, of masks, of minima.
    Limits,
    /// The counter indexes an array, whose length ends the loop: beyond it a check fails.
    Length,
    /// The number of values of the counter's type.
    Type,
    /// Nothing limits the passes.
    Unknown,
}

impl Source {
    /// Returns the source in words.
    pub fn word(self) -> &'static str {
        match self {
            Source::Constants => "constants",
            Source::Limits => "limits of the ends",
            Source::Length => "length of an array that the counter indexes",
            Source::Type => "values of the counter's type",
            Source::Unknown => "no bound",
        }
    }
}

/// Least and greatest value.
type Limits = (i128, i128);

/// Limits of locals that are known.
#[derive(Clone)]
pub(super) struct Known<'a> {
    module: &'a Module,
    function: &'a Function,
    locals: BTreeMap<LocalId, Limits>,
    /// Locals that are assigned or borrowed after their declaration.
    changed: Vec<LocalId>,
}

impl<'a> Known<'a> {
    pub(super) fn new(module: &'a Module, function: &'a Function) -> Known<'a> {
        let mut changed = Vec::new();
        function.body.each_place(|place, access| {
            if access != bessemer_ir::visit::Access::Read {
                changed.push(place.root);
            }
        });
        Known { module, function, locals: BTreeMap::new(), changed }
    }

    /// Records the limits of a local that is never changed.
    pub(super) fn declare(&mut self, local: LocalId, value: Option<&Expr>) {
        if let Some(limits) = value.and_then(|it| self.limits(it))
            && !self.changed.contains(&local)
        {
            self.locals.insert(local, limits);
        }
    }

    /// Records the limits of a counter.
    pub(super) fn counts(&mut self, variable: LocalId, from: &Expr, to: &Expr, inclusive: bool) {
        if let (Some(from), Some(to)) = (self.limits(from), self.limits(to)) {
            self.locals.insert(variable, (from.0, to.1 - i128::from(!inclusive)));
        }
    }

    /// Returns the largest number of passes of a loop, and its source.
    pub(super) fn passes(
        &self,
        variable: LocalId,
        from: &Expr,
        to: &Expr,
        inclusive: bool,
        body: &Block,
    ) -> (Option<u64>, Source) {
        let ends = self.limits(from).zip(self.limits(to));
        let count = |(from, to): (Limits, Limits)| {
            u64::try_from((to.1 - from.0 + i128::from(inclusive)).max(0)).ok()
        };
        let by_ends = ends.and_then(|ends| Some((count(ends)?, ends)));
        let by_length = self.length(variable, body);
        match (by_ends, by_length) {
            (Some((passes, (from, to))), length) if length.is_none_or(|it| passes <= it) => {
                let constant = from.0 == from.1 && to.0 == to.1;
                let source = match constant {
                    true => Source::Constants,
                    false if self.is_type(&to) && passes > 1 << 16 => Source::Type,
                    false => Source::Limits,
                };
                match source {
                    // A counter of 32 bits could run for minutes: that is no bound.
                    Source::Type => (None, Source::Unknown),
                    source => (Some(passes), source),
                }
            }
            (_, Some(length)) => (Some(length), Source::Length),
            (_, None) => (None, Source::Unknown),
        }
    }

    fn is_type(&self, limits: &Limits) -> bool {
        limits.1 - limits.0 >= i128::from(u16::MAX)
    }

    /// Returns the length of the shortest array, row or column that the counter itself indexes in each pass.
    fn length(&self, variable: LocalId, body: &Block) -> Option<u64> {
        let mut least: Option<u64> = None;
        let mut see = |place: &Place| {
            let mut ty = self.function.local(place.root).ty.clone();
            for step in &place.steps {
                let indexed = match (step, &ty) {
                    (Step::Index(index), Type::Array { len, .. }) => vec![(index, *len)],
                    (Step::Index(index), Type::Matrix { rows, cols, .. }) => {
                        vec![(index, rows * cols)]
                    }
                    (Step::Element(row, column), Type::Matrix { rows, cols, .. }) => {
                        vec![(row, *rows), (column, *cols)]
                    }
                    _ => Vec::new(),
                };
                for (_, len) in indexed.into_iter().filter(|it| is_load_of(it.0, variable)) {
                    let len = u64::from(len);
                    least = Some(least.map_or(len, |it| it.min(len)));
                }
                match self.module.step_type(&ty, step) {
                    Some(next) => ty = next,
                    None => return,
                }
            }
        };
        // Only statements that each pass executes: not those of a branch.
        for stmt in &body.0 {
            match &stmt.kind {
                StmtKind::Let { .. } | StmtKind::Assign { .. } | StmtKind::Expr(_) => {
                    stmt.each_place(|place, _| see(place));
                }
                StmtKind::Check { condition, .. } => condition.each_place(|place, _| see(place)),
                _ => break,
            }
        }
        least
    }

    fn limits(&self, expr: &Expr) -> Option<Limits> {
        let int = expr.ty.as_int();
        let of_type = || int.map(of_int);
        let own = match &expr.kind {
            ExprKind::Literal(word) => int.map(|int| (int.from_word(*word), int.from_word(*word))),
            ExprKind::Const(id) => {
                let word = self.module.consts[id.index()].words.first()?;
                int.map(|int| (int.from_word(*word), int.from_word(*word)))
            }
            ExprKind::Load(place) if place.steps.is_empty() => {
                self.locals.get(&place.root).copied().or_else(of_type)
            }
            ExprKind::Cast(of) => {
                let (low, high) = self.limits(of)?;
                let (least, most) = of_type()?;
                if low >= least && high <= most { Some((low, high)) } else { of_type() }
            }
            ExprKind::Binary(op, left, right) => {
                let (left, right) = (self.limits(left)?, self.limits(right)?);
                self.binary(*op, left, right)
            }
            ExprKind::Intrinsic(intrinsic, operands) => {
                let limits: Option<Vec<Limits>> =
                    operands.iter().map(|it| self.limits(it)).collect();
                match (intrinsic, &limits?[..]) {
                    (Intrinsic::Min, [one, other]) => {
                        Some((one.0.min(other.0), one.1.min(other.1)))
                    }
                    (Intrinsic::Max, [one, other]) => {
                        Some((one.0.max(other.0), one.1.max(other.1)))
                    }
                    (Intrinsic::SaturatingSub, [one, other]) => {
                        Some((one.0 - other.1, one.1 - other.0))
                    }
                    _ => of_type(),
                }
            }
            _ => of_type(),
        };
        let ((low, high), (least, most)) = (own?, of_type()?);
        Some((low.clamp(least, most), high.clamp(least, most)))
    }

    fn binary(&self, op: BinaryOp, left: Limits, right: Limits) -> Option<Limits> {
        Some(match op {
            BinaryOp::Add => (left.0 + right.0, left.1 + right.1),
            BinaryOp::Sub => (left.0 - right.1, left.1 - right.0),
            BinaryOp::Mul if left.0 >= 0 && right.0 >= 0 => {
                (left.0.saturating_mul(right.0), left.1.saturating_mul(right.1))
            }
            BinaryOp::Div if left.0 >= 0 && right.0 > 0 => (left.0 / right.1, left.1 / right.0),
            BinaryOp::Rem if left.0 >= 0 && right.0 > 0 => (0, left.1.min(right.1 - 1)),
            BinaryOp::And if left.0 >= 0 && right.0 >= 0 => (0, left.1.min(right.1)),
            BinaryOp::Shr if left.0 >= 0 => (0, left.1),
            _ => (i128::MIN >> 1, i128::MAX >> 1),
        })
    }
}

fn of_int(int: Int) -> Limits {
    let bits = int.bits();
    match int.signed() {
        true => (-(1_i128 << (bits - 1)), (1_i128 << (bits - 1)) - 1),
        false => (0, (1_i128 << bits) - 1),
    }
}

/// Returns true if an index is the counter itself, possibly cast.
fn is_load_of(index: &Expr, variable: LocalId) -> bool {
    match &index.kind {
        ExprKind::Load(place) => place.steps.is_empty() && place.root == variable,
        ExprKind::Cast(of) => is_load_of(of, variable),
        _ => false,
    }
}
