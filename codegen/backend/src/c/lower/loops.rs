//! `for` over ranges, and `while`.
//!
//! An inclusive range may end at the largest value of its type, for which `i <= end` never fails. Unless the bound is
//! known to be smaller, a flag ends the loop.

use bessemer_ir::visit::{Access, Walk};
use bessemer_ir::{Block, CompareOp, Expr as Ir, ExprKind, Int, LocalId, Place, Scalar, Type};

use super::super::literal;
use super::super::spelling::scalar_type;
use super::super::tree::{Declarator, Expr, Init, Step, StmtKind};
use super::Lower;
use super::bits::masked;
use super::place::is_small;
use bessemer_ir::effects::mentions;

/// Type of C's counter if a range fits into 32 bits.
const U32: Type = Type::Scalar(Scalar::Int(Int::U32));

/// Parts of a loop's head that its form determines.
struct Head {
    first: Expr,
    condition: Expr,
    step: Option<Step>,
    /// First statement of the body.
    begin: Option<StmtKind>,
}

impl Lower<'_> {
    pub(super) fn for_(
        &mut self,
        variable: LocalId,
        (from, to): (&Ir, &Ir),
        inclusive: bool,
        reversed: bool,
        body: &Block,
    ) {
        let ty = self.function.local(variable).ty.clone();
        let int = ty.as_int().expect("the validator asks for an integer");
        let range = self.range(from).zip(self.range(to));
        let names = self.live.len();
        let outside = std::mem::take(&mut self.out);

        // The bound that is read again and again must hold still.
        let (from, to) = if reversed {
            (self.bound(from, "first", range.is_some(), body), self.start(to, range.is_some()))
        } else {
            (self.start(from, range.is_some()), self.bound(to, "end", range.is_some(), body))
        };
        let last = self.constant_value(&to.1, int).or(range.map(|range| range.1.1));
        let last = last.or(largest(&to.1, int));
        let flagged = inclusive && last.is_none_or(|last| last >= int.max());
        let flag = flagged.then(|| self.flag(&from, &to));

        let wanted = self.function.local(variable).name.clone();
        let is_unused = wanted.starts_with('_') && wanted.trim_matches('_').is_empty();
        let counter = self.counter_name(if is_unused { "i" } else { &wanted });
        self.bindings[variable.index()] = Some(super::Binding::new(counter.clone(), false));
        self.counters[variable.index()] = range.map(|(from, to)| {
            let last = if inclusive { to.1 } else { to.1 - 1 };
            (from.0, last.max(from.0))
        });
        let ty = if range.is_some() { "uint32_t" } else { scalar_type(Scalar::Int(int)) };
        let head = match flag {
            Some(flag) => flagged_head(&counter, (from.0, to.0), int, reversed, flag),
            None if reversed => self.head_down(&counter, (from, to), int, inclusive),
            // No value is below the smallest: the loop does not run, and C must not be asked.
            None if !inclusive && literal_value(&to.1, int) == Some(int.min()) => {
                let begin = StmtKind::Expr(Expr::cast("void", Expr::name(&counter)));
                let condition = Expr::name("false");
                Head { first: from.0, condition, step: None, begin: Some(begin) }
            }
            None => Head {
                first: from.0,
                condition: Expr::binary(
                    if inclusive { "<=" } else { "<" },
                    Expr::name(&counter),
                    to.0,
                ),
                step: Some(Step::Expr(Expr::Postfix(Box::new(Expr::name(&counter)), "++"))),
                begin: None,
            },
        };
        self.bytes += 8;
        self.finish(
            Declarator { ty: ty.to_owned(), name: counter, dimensions: String::new() },
            head,
            body,
        );
        self.leave(names);
        let mut stmts = std::mem::replace(&mut self.out, outside);
        if !stmts.iter().any(|stmt| matches!(stmt.kind, StmtKind::Declare(..))) {
            self.out.append(&mut stmts);
        } else {
            self.emit(StmtKind::Block(stmts));
        }
    }

    /// Emits a loop that its body ends; a test at its beginning becomes the condition of the `while`.
    pub(super) fn while_(&mut self, body: &Block) {
        let (condition, first) = match body.head().and_then(|end| self.condition(end)) {
            Some(condition) => (condition, 1),
            None => (Expr::name("true"), 0),
        };
        let origin = self.origin;
        let rest = Block(body.0[first..].to_vec());
        let body = self.scope(|lower| lower.block_into(&rest, false));
        self.origin = origin;
        self.emit(StmtKind::While { condition, body });
    }

    /// Returns the negation of a condition, unless it needs statements, which a loop would have to repeat.
    fn condition(&mut self, end: &Ir) -> Option<Expr> {
        let mut condition = None;
        let before = self.scope(|lower| condition = Some(lower.negated(end)));
        condition.filter(|_| before.is_empty())
    }

    fn finish(&mut self, counter: Declarator, head: Head, body: &Block) {
        let origin = self.origin;
        if let Some(count) = self.unroll.take() {
            self.uses.unroll = true;
            let hint = format!("{}({count})", self.context.names.status.unroll());
            self.emit(StmtKind::Verbatim(hint));
        }
        let body = self.scope(|lower| {
            if let Some(begin) = head.begin {
                lower.emit(begin);
            }
            lower.block_into(body, false);
        });
        self.origin = origin;
        self.emit(StmtKind::For {
            init: (counter, head.first),
            condition: head.condition,
            step: head.step,
            body,
        });
    }

    fn head_down(
        &mut self,
        counter: &str,
        (from, to): ((Expr, Ir), (Expr, Ir)),
        int: Int,
        inclusive: bool,
    ) -> Head {
        let i = || Expr::name(counter);
        let first = match literal_value(&to.1, int) {
            Some(value) if inclusive => literal_like(&to.0, int, value + 1),
            _ if inclusive => {
                Expr::binary("+", to.0, Expr::name(if int.signed() { "1" } else { "1U" }))
            }
            _ => to.0,
        };
        // Below the first value the counter must not fall where that would leave its type; nor from the end of an empty range.
        let least = self.constant_value(&to.1, int).or(self.type_range(&to.1).map(|it| it.0));
        let ends = inclusive || least.is_some_and(|least| least > int.min());
        let falls = !int.signed()
            || ends && literal_value(&from.1, int).is_some_and(|value| value > int.min());
        if falls {
            let condition = Expr::binary(">", Expr::Postfix(Box::new(i()), "--"), from.0);
            Head { first, condition, step: None, begin: None }
        } else {
            let down = StmtKind::Expr(Expr::Postfix(Box::new(i()), "--"));
            Head { first, condition: Expr::binary(">", i(), from.0), step: None, begin: Some(down) }
        }
    }

    /// Returns the value of a literal or a constant.
    fn constant_value(&self, expr: &Ir, int: Int) -> Option<i128> {
        match expr.kind {
            ExprKind::Const(id) => {
                Some(int.from_word(self.context.module.consts[id.index()].words[0]))
            }
            _ => literal_value(expr, int),
        }
    }

    /// Declares the flag `bool more = from <= to;`.
    fn flag(&mut self, from: &(Expr, Ir), to: &(Expr, Ir)) -> String {
        let name = self.fresh("more");
        let value = match self.decided(CompareOp::Le, &from.1, &to.1) {
            Some(always) => Expr::name(if always { "true" } else { "false" }),
            None => Expr::binary("<=", from.0.clone(), to.0.clone()),
        };
        self.declare(&Type::BOOL, &name, Some(Init::Value(value)), false);
        name
    }

    /// Returns a bound that is read once.
    fn start(&mut self, value: &Ir, narrow: bool) -> (Expr, Ir) {
        let lowered = self.bound_value(value, narrow);
        let wide = narrow && self.is_wide(value);
        (if wide { Expr::cast("uint32_t", lowered) } else { lowered }, value.clone())
    }

    /// Returns a bound that is read before every pass.
    fn bound(&mut self, value: &Ir, name: &str, narrow: bool, body: &Block) -> (Expr, Ir) {
        let lowered = self.bound_value(value, narrow);
        if !holds_still(value, body) || calls(&lowered) {
            let name = self.fresh(name);
            let (ty, lowered) = match narrow {
                true if self.is_wide(value) => (U32, Expr::cast("uint32_t", lowered)),
                true => (U32, lowered),
                false => (value.ty.clone(), lowered),
            };
            self.declare(&ty, &name, Some(Init::Value(lowered)), true);
            return (Expr::name(name), value.clone());
        }
        (self.comparable(masked(lowered, value)), value.clone())
    }

    fn bound_value(&mut self, value: &Ir, narrow: bool) -> Expr {
        if narrow { self.narrow(value, false) } else { self.word(value) }
    }
}

/// Returns the head of a loop that a flag ends. Its form is `for (T i = from; more; i = more ? i + 1 : i) { more = i <
/// to; … }`.
fn flagged_head(
    counter: &str,
    (from, to): (Expr, Expr),
    int: Int,
    reversed: bool,
    flag: String,
) -> Head {
    let i = || Expr::name(counter);
    let more = || Expr::name(&flag);
    let (op, compare) = if reversed { ("-", ">") } else { ("+", "<") };
    let (first, last) = if reversed { (to, from) } else { (from, to) };
    let one = Expr::name(if int.signed() { "1" } else { "1U" });
    let stepped = Expr::binary(op, i(), one);
    let next = Expr::Conditional(Box::new(more()), Box::new(stepped), Box::new(i()));
    let next = if is_small(int) { Expr::cast(scalar_type(Scalar::Int(int)), next) } else { next };
    let ahead = Expr::binary(compare, i(), last);
    Head {
        first,
        condition: more(),
        step: Some(Step::Assign(i(), next)),
        begin: Some(StmtKind::Assign(more(), "=", ahead)),
    }
}

fn literal_value(expr: &Ir, int: Int) -> Option<i128> {
    match expr.kind {
        ExprKind::Literal(word) => Some(int.from_word(word)),
        _ => None,
    }
}

/// Returns the largest value of an integer converted from a narrower type; none for a signed one in an unsigned type.
fn largest(expr: &Ir, int: Int) -> Option<i128> {
    let ExprKind::Cast(inner) = &expr.kind else { return None };
    inner.ty.as_int().filter(|from| !from.signed() || int.signed()).map(Int::max)
}

/// Returns a literal with the suffix of another: `4U` for `3U`.
fn literal_like(other: &Expr, int: Int, value: i128) -> Expr {
    match other {
        Expr::Name(text)
            if text.ends_with('U') && text.starts_with(|c: char| c.is_ascii_digit()) =>
        {
            Expr::name(format!("{value}U"))
        }
        _ => literal::integer(int, value),
    }
}

/// Returns true if a bound does not change while the body runs, and is cheap to read.
fn holds_still(value: &Ir, body: &Block) -> bool {
    let computes = |expr: &Ir| matches!(expr.kind, ExprKind::Call(..) | ExprKind::Routine(..));
    let written = |place: &Place, access| access != Access::Read && mentions(value, place.root);
    !value.any_expr(computes) && !body.any_place(written)
}

/// Returns true if an expression calls anything.
fn calls(expr: &Expr) -> bool {
    match expr {
        Expr::Call(..) => true,
        Expr::Name(_) => false,
        Expr::Unary(_, inner) | Expr::Cast(_, inner) | Expr::Postfix(inner, _) => calls(inner),
        Expr::Member(inner, _) | Expr::Arrow(inner, _) => calls(inner),
        Expr::Binary(_, a, b) | Expr::Index(a, b) => calls(a) || calls(b),
        Expr::Conditional(a, b, c) => calls(a) || calls(b) || calls(c),
    }
}
