//! Tests of assumed conditions: alone, in sequence, and on paths that join. Each derived proof or interval must be true
//! for all pairs of numbers that satisfy the conditions.

use bessemer_ir::{
    BinaryOp, CompareOp, Expr, ExprKind, Int, Intrinsic, LocalId, LogicOp, Module, Scalar, Span,
    Type, UnaryOp,
};

use crate::passes::analysis::{Interval, State};
use bessemer_ir::effects::whole;

const X: LocalId = LocalId(0);
const Y: LocalId = LocalId(1);

/// Number of values of each of the two numbers, at one end of their type.
const VALUES: i128 = 16;

/// Two numbers of a type, from `low` on.
#[derive(Clone, Copy)]
struct Numbers {
    int: Int,
    low: i128,
}

/// Numbers at the ends of types, where operations overflow, and around 0.
const NUMBERS: [Numbers; 5] = [
    Numbers { int: Int::U8, low: 0 },
    Numbers { int: Int::U8, low: 240 },
    Numbers { int: Int::I8, low: -128 },
    Numbers { int: Int::I8, low: -8 },
    Numbers { int: Int::I8, low: 112 },
];

/// Set of pairs that satisfy a condition, one bit each.
type Pairs = [u64; 4];

impl Numbers {
    fn ty(self) -> Type {
        Type::Scalar(Scalar::Int(self.int))
    }

    fn pairs(self) -> impl Iterator<Item = (i128, i128)> {
        let all = self.low..self.low + VALUES;
        all.clone().flat_map(move |x| all.clone().map(move |y| (x, y)))
    }

    fn literal(self, value: i128) -> Expr {
        node(ExprKind::Literal(value as i64 as u64), self.ty())
    }

    fn start<'m>(self, module: &'m Module) -> State<'m> {
        let mut state = State::new(module);
        let all = Interval::new(self.low, self.low + VALUES - 1);
        state.bound(&self.x(), all);
        state.bound(&self.y(), all);
        state
    }

    fn x(self) -> Expr {
        Expr::local(X, &self.ty(), Span::default())
    }

    fn y(self) -> Expr {
        Expr::local(Y, &self.ty(), Span::default())
    }

    /// The operands of conditions.
    fn terms(self) -> Vec<Expr> {
        let (x, y, one) = (self.x(), self.y(), self.literal(1));
        let three = self.literal(3);
        let most =
            node(ExprKind::Intrinsic(Intrinsic::Max, vec![y.clone(), three.clone()]), self.ty());
        let wide = Type::Scalar(Scalar::Int(Int::I16));
        vec![
            binary(BinaryOp::Add, &x, &one),
            binary(BinaryOp::Sub, &y, &one),
            binary(BinaryOp::Sub, &three, &x),
            binary(BinaryOp::Sub, &most, &three),
            node(ExprKind::Cast(Box::new(x.clone())), wide),
            self.literal(self.low + 5),
            self.literal(self.low),
            x,
            y,
        ]
    }

    /// Further values of `x`, by which it compares to `y`.
    fn definitions(self) -> Vec<Expr> {
        let (y, two, five) = (self.y(), self.literal(2), self.literal(5));
        let of = |which| node(ExprKind::Intrinsic(which, vec![y.clone(), five.clone()]), self.ty());
        vec![
            binary(BinaryOp::Add, &y, &two),
            binary(BinaryOp::Sub, &y, &five),
            binary(BinaryOp::Div, &y, &two),
            of(Intrinsic::Min),
            of(Intrinsic::Max),
        ]
    }

    /// Comparisons with the smaller and with the larger of the two.
    fn of_two(self) -> Vec<Expr> {
        let (x, y) = (self.x(), self.y());
        let of = |which| node(ExprKind::Intrinsic(which, vec![x.clone(), y.clone()]), self.ty());
        let two = [of(Intrinsic::Min), of(Intrinsic::Max)];
        let others =
            [x.clone(), self.literal(self.low + 5), binary(BinaryOp::Add, &y, &self.literal(1))];
        let pairs = two.iter().flat_map(|two| others.iter().map(move |other| (two, other)));
        pairs.flat_map(|(two, other)| [orders(two, other), orders(other, two)].concat()).collect()
    }

    fn conditions(self) -> Vec<Expr> {
        let terms = self.terms();
        let mut all = Vec::new();
        for a in &terms {
            for b in terms.iter().filter(|b| a.ty == b.ty && a != *b) {
                all.extend(orders(a, b));
            }
        }
        for number in [self.low, self.low + 4] {
            let cast = &terms[4];
            let number = node(ExprKind::Literal(number as i64 as u64), cast.ty.clone());
            all.push(compare(CompareOp::Le, cast, &number));
            all.push(compare(CompareOp::Gt, cast, &number));
        }
        all
    }

    /// Fewer, with those of two parts.
    fn some(self) -> Vec<Expr> {
        let all = self.conditions();
        let mut some: Vec<Expr> = all.iter().step_by(7).cloned().collect();
        for (a, b) in all.iter().step_by(23).zip(all.iter().rev().step_by(17)) {
            some.push(logic(LogicOp::Or, a, b));
            some.push(logic(LogicOp::And, a, b));
            some.push(node(
                ExprKind::Unary(UnaryOp::Not, Box::new(logic(LogicOp::Or, b, a))),
                Type::BOOL,
            ));
        }
        some
    }

    /// For which pairs a condition gives `truth`, without a fault.
    fn satisfy(self, condition: &Expr, truth: bool) -> Pairs {
        let mut bits = Pairs::default();
        for (at, pair) in self.pairs().enumerate() {
            let holds = value(condition, pair) == Some(truth.into());
            bits[at / 64] |= u64::from(holds) << (at % 64);
        }
        bits
    }

    /// A condition, and for which pairs it holds and fails.
    fn tables(self, conditions: Vec<Expr>) -> Vec<(Expr, Pairs, Pairs)> {
        let of = |it: Expr| {
            let (holds, fails) = (self.satisfy(&it, true), self.satisfy(&it, false));
            (it, holds, fails)
        };
        conditions.into_iter().map(of).collect()
    }

    /// All that the state says holds of the pairs.
    fn confirm(
        self,
        state: &State,
        reach: &Pairs,
        asked: &[(Expr, Pairs, Pairs)],
        message: &dyn Fn() -> String,
    ) {
        for (condition, _, fails) in asked {
            let wrong = reach.iter().zip(fails).any(|(reach, fails)| reach & fails != 0);
            if wrong {
                assert!(!state.proves(condition), "{}: proves {}", message(), shown(condition));
            }
        }
        for term in self.terms() {
            let range = state.range(&term);
            for (at, pair) in self.pairs().enumerate() {
                if reach[at / 64] >> (at % 64) & 1 == 1 {
                    let held = value(&term, pair).is_none_or(|value| range.contains(value));
                    assert!(held, "{}: {} is {range} at {pair:?}", message(), shown(&term));
                }
            }
        }
    }
}

fn node(kind: ExprKind, ty: Type) -> Expr {
    Expr { kind, ty, span: Span::default() }
}

fn binary(op: BinaryOp, a: &Expr, b: &Expr) -> Expr {
    node(ExprKind::Binary(op, Box::new(a.clone()), Box::new(b.clone())), a.ty.clone())
}

fn compare(op: CompareOp, a: &Expr, b: &Expr) -> Expr {
    node(ExprKind::Compare(op, Box::new(a.clone()), Box::new(b.clone())), Type::BOOL)
}

fn logic(op: LogicOp, a: &Expr, b: &Expr) -> Expr {
    node(ExprKind::Logic(op, Box::new(a.clone()), Box::new(b.clone())), Type::BOOL)
}

/// Rust's result of an expression; nothing if it panics.
fn value(expr: &Expr, (x, y): (i128, i128)) -> Option<i128> {
    let of = |expr: &Expr| value(expr, (x, y));
    match &expr.kind {
        ExprKind::Literal(word) => Some(expr.ty.as_int()?.from_word(*word)),
        ExprKind::Load(place) => Some(if place.root == X { x } else { y }),
        ExprKind::Cast(inner) => of(inner),
        ExprKind::Binary(op, a, b) => {
            let (a, b, int) = (of(a)?, of(b)?, expr.ty.as_int()?);
            let exact = match op {
                BinaryOp::Add => a + b,
                BinaryOp::Sub => a - b,
                _ => a / b,
            };
            (int.min() <= exact && exact <= int.max()).then_some(exact)
        }
        ExprKind::Intrinsic(which, parts) => {
            let (a, b) = (of(&parts[0])?, of(&parts[1])?);
            Some(if *which == Intrinsic::Min { a.min(b) } else { a.max(b) })
        }
        ExprKind::Compare(op, a, b) => {
            let (a, b) = (of(a)?, of(b)?);
            Some(i128::from(match op {
                CompareOp::Eq => a == b,
                CompareOp::Ne => a != b,
                CompareOp::Lt => a < b,
                CompareOp::Le => a <= b,
                CompareOp::Gt => a > b,
                CompareOp::Ge => a >= b,
            }))
        }
        ExprKind::Unary(_, inner) => Some(1 - of(inner)?),
        ExprKind::Logic(op, a, b) => match (op, of(a)?) {
            (LogicOp::And, 0) => Some(0),
            (LogicOp::Or, 1) => Some(1),
            _ => of(b),
        },
        kind => unreachable!("no such term: {kind:?}"),
    }
}

fn shown(expr: &Expr) -> String {
    match &expr.kind {
        ExprKind::Literal(word) => {
            expr.ty.as_int().map_or_else(String::new, |int| int.from_word(*word).to_string())
        }
        ExprKind::Load(place) => if place.root == X { "x" } else { "y" }.to_owned(),
        ExprKind::Binary(op, a, b) => format!("({} {op:?} {})", shown(a), shown(b)),
        ExprKind::Compare(op, a, b) => format!("({} {op:?} {})", shown(a), shown(b)),
        ExprKind::Logic(op, a, b) => format!("({} {op:?} {})", shown(a), shown(b)),
        ExprKind::Unary(op, a) => format!("{op:?} {}", shown(a)),
        ExprKind::Cast(a) => format!("{} as i16", shown(a)),
        ExprKind::Intrinsic(which, parts) => {
            format!("{which:?}({}, {})", shown(&parts[0]), shown(&parts[1]))
        }
        _ => String::new(),
    }
}

/// Each comparison of two terms.
fn orders(a: &Expr, b: &Expr) -> Vec<Expr> {
    use CompareOp::{Eq, Ge, Gt, Le, Lt, Ne};
    [Lt, Le, Eq, Ne, Gt, Ge].map(|op| compare(op, a, b)).into()
}

fn both(a: &Pairs, b: &Pairs) -> Pairs {
    [a[0] & b[0], a[1] & b[1], a[2] & b[2], a[3] & b[3]]
}

#[test]
fn what_one_condition_gives_holds() {
    let module = Module::default();
    for numbers in NUMBERS {
        let (of_two, others) = (numbers.of_two(), [numbers.conditions(), numbers.some()].concat());
        let all_of_two = of_two.len();
        let asked = numbers.tables([of_two, others].concat());
        let (of_two, others) = asked.split_at(all_of_two);
        for (condition, holds, fails) in of_two.iter().chain(others.iter().step_by(2)) {
            for (truth, reach) in [(true, holds), (false, fails)] {
                let state = numbers.start(&module).assuming(condition, truth);
                let message = || format!("{} is {truth}", shown(condition));
                numbers.confirm(&state, reach, &asked, &message);
            }
        }
    }
}

#[test]
fn what_two_conditions_give_holds() {
    let module = Module::default();
    for numbers in NUMBERS {
        let asked = numbers.tables(numbers.some());
        for (first, first_holds, _) in asked.iter().step_by(3) {
            let begun = numbers.start(&module).assuming(first, true);
            for (second, holds, fails) in asked.iter().step_by(4) {
                for (truth, reach) in [(true, holds), (false, fails)] {
                    let state = begun.assuming(second, truth);
                    let message = || format!("{} and {} is {truth}", shown(first), shown(second));
                    numbers.confirm(&state, &both(first_holds, reach), &asked, &message);
                }
            }
        }
    }
}

#[test]
fn what_holds_where_paths_meet_holds_on_both() {
    let module = Module::default();
    for numbers in NUMBERS {
        let asked = numbers.tables(numbers.some());
        for (first, one, _) in asked.iter().step_by(3) {
            for (second, other, _) in asked.iter().step_by(4) {
                let mut state = numbers.start(&module).assuming(first, true);
                state.join(&numbers.start(&module).assuming(second, true));
                let reach = [0, 1, 2, 3].map(|at| one[at] | other[at]);
                let message = || format!("{} or {}", shown(first), shown(second));
                numbers.confirm(&state, &reach, &asked, &message);
            }
        }
    }
}

/// `x = term;` behind a condition.
#[test]
fn what_is_known_behind_a_write_holds() {
    let module = Module::default();
    for numbers in NUMBERS {
        let asked = numbers.tables([numbers.conditions(), numbers.some()].concat());
        for (condition, holds, _) in asked.iter().step_by(9) {
            let terms = [numbers.terms(), numbers.definitions()].concat();
            for term in terms.into_iter().filter(|term| term.ty == numbers.ty()) {
                let mut state = numbers.start(&module).assuming(condition, true);
                let known = state.parts(&term);
                state.assign(&whole(X), known);
                state.define(X, &term);
                // What x is behind it, of pairs that stay in the table.
                let mut reach = Pairs::default();
                for (at, pair) in numbers.pairs().enumerate() {
                    let next = value(&term, pair).map(|value| value - numbers.low);
                    if holds[at / 64] >> (at % 64) & 1 == 1
                        && let Some(next) = next.filter(|next| (0..VALUES).contains(next))
                    {
                        let at = (next * VALUES + pair.1 - numbers.low) as usize;
                        reach[at / 64] |= 1 << (at % 64);
                    }
                }
                let message = || format!("{}, then x = {}", shown(condition), shown(&term));
                numbers.confirm(&state, &reach, &asked, &message);
            }
        }
    }
}

/// Consequences of a definition alone: `y <= y + 2`, `y / 2 <= y`, and the difference of `y + 2` and `y`.
#[test]
fn a_definition_compares_a_local_to_its_parts() {
    let module = Module::default();
    let numbers = Numbers { int: Int::U8, low: 0 };
    let (x, y, definitions) = (numbers.x(), numbers.y(), numbers.definitions());
    let shown = |of: usize, a: &Expr, b: &Expr| {
        let mut state = State::new(&module);
        state.assign(&whole(X), Vec::new());
        state.define(X, &definitions[of]);
        state.proves(&compare(CompareOp::Le, a, b))
    };
    let of_y = [(false, true), (true, false), (true, false), (true, false), (false, true)];
    for (at, (below, above)) in of_y.into_iter().enumerate() {
        assert_eq!((shown(at, &x, &y), shown(at, &y, &x)), (below, above), "{at}");
    }
    let difference = binary(BinaryOp::Sub, &x, &y);
    assert!(
        shown(0, &difference, &numbers.literal(2)) && shown(0, &numbers.literal(2), &difference)
    );
    assert!(!shown(4, &difference, &numbers.literal(5)));
}

/// `x + 2 < y` and `x - 2 < y`, where `x` is below `y`, or below what falls short of it.
#[test]
fn what_lies_further_below_a_length_holds() {
    let module = Module::default();
    for numbers in NUMBERS {
        let (x, y) = (numbers.x(), numbers.y());
        let by = |by: i128| node(ExprKind::Literal(by as u64), numbers.ty());
        let further = |op, more| compare(CompareOp::Lt, &binary(op, &x, &by(more)), &y);
        let ops = [BinaryOp::Add, BinaryOp::Sub];
        let asked = ops.into_iter().flat_map(|op| (0..6).map(move |more| (op, more)));
        let asked = numbers.tables(asked.map(|(op, more)| further(op, more)).collect());
        for short in 0..5 {
            let kind = ExprKind::Intrinsic(Intrinsic::Max, vec![y.clone(), by(short)]);
            let less = binary(BinaryOp::Sub, &node(kind, numbers.ty()), &by(short));
            for (op, end) in
                [CompareOp::Lt, CompareOp::Le].map(|op| [(op, &less), (op, &y)]).concat()
            {
                let condition = compare(op, &x, end);
                let state = numbers.start(&module).assuming(&condition, true);
                let reach = numbers.satisfy(&condition, true);
                numbers.confirm(&state, &reach, &asked, &|| shown(&condition));
            }
        }
    }
}
