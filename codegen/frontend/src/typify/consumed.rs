//! Numbers of items that Rust's `zip`, `eq` and `last` consume, where a closure may count them.
//!
//! They depend on the access of the standard library to both sides: by index; one by one, with a known length; or one by
//! one ([`standard`]). Both sides by index: as many items of each as the shorter has. Both
//! lengths known: as many if `fold` consumes them, and one more of the first side by `next`. Otherwise: one more. Where
//! this cannot be decided, and a closure writes or may fault, the call is refused.
//!
//! Must not know: how a loop over an iterator is lowered ([`generator`](super::generator)).

use bessemer_ir::tree::{
    self, BinaryOp, Builtin, Desugared, EACH, ExprKind as Tree, Site, Source, Stmt, Ty, visit::Walk,
};
use bessemer_ir::{CompareOp, Expr, ExprKind, Mode, Scalar, Type};

use super::by_hand::limited;
use super::callee::Called;
use super::closure_args::is_hidden;
use super::items::handing;
use super::lengths::{least, number};
use super::lowering::{Closure, Lowering};
use super::scopes::Scopes;
use super::syntax::{bare, generates};
use super::value::Value;
use super::{Result, refusals, refused};
use crate::standard::{self, Access, Consumer, Items, Number, Taking};

/// The sides of a call of `zip`: the first one as a closure, and the function's argument for each.
pub(super) struct Sides<'e> {
    pub one: usize,
    pub other: usize,
    pub arguments: [&'e tree::Expr; 2],
}

/// Returns the first side of a `zip`, limited to the length of the other side where Rust takes no more of it. `body` is
/// the pass of the consumer.
pub(super) fn zipped<'a>(
    lowering: &mut Lowering<'a, '_>,
    sides: &Sides,
    body: &tree::Block,
) -> Result<usize> {
    let site = sides.arguments[0].site;
    let [one, other] = [sides.one, sides.other];
    let [first, second] = [0, 1].map(|at| {
        let items = named_items(lowering, [one, other][at]);
        match is_borrowed(lowering, sides.arguments[at]) {
            true => items.at_most(Access::Counted),
            false => items,
        }
    });
    let access = first.access.and(second.access);
    let indexed = matches!(access, Access::Unknown | Access::Indexed);
    if indexed && (first.skips || second.skips) {
        return refused(site, refusals::SKIPPED_BY_ACCESS);
    }
    if access == Access::Serial || !first.acts || second.endless {
        return Ok(one);
    }
    let taking = match access {
        Access::Indexed => Taking::Fold,
        _ => taking(lowering.source, body, &lowering.scopes, lowering),
    };
    if !indexed && taking == Taking::Next {
        return Ok(one);
    }
    let lengths = [one, other].map(|side| length(lowering, side));
    if let [Some(one_length), Some(most)] = &lengths
        && let (Some(items), Some(most)) = (number(one_length), number(most))
        && items <= most
    {
        return Ok(one);
    }
    let [_, most] = lengths;
    match most {
        Some(most) if access > Access::Unknown && taking == Taking::Fold && !first.endless => {
            let most = match lowering.atom("count", most) {
                Expr { kind: ExprKind::Load(place), .. } => Value::Place(place),
                known => Value::Word(Box::new(known)),
            };
            limited(lowering, one, most, site)
        }
        _ => refused(site, refusals::ZIPPED_BY_ACCESS),
    }
}

/// Returns the condition under which Rust's `eq` compares items at all: the lengths are equal, if it knows both. None if it
/// always does, or if nothing shows the difference. `acts`: an item's own `==` may write or fault.
pub(super) fn same_length(
    lowering: &mut Lowering,
    arguments: &[tree::Expr],
    acts: bool,
    site: Site,
) -> Result<Option<Expr>> {
    let named: Vec<_> = arguments.iter().filter_map(|it| lowering.iterator_named(it)).collect();
    let [one, other] = named[..] else { return Ok(None) };
    let [first, second] = [one, other].map(|side| named_items(lowering, side));
    let both = first.beside(second);
    if both.access == Access::Serial || !(both.acts || acts) {
        return Ok(None);
    }
    let lengths = [one, other].map(|side| length(lowering, side));
    let [Some(items), Some(others)] = lengths else {
        return refused(site, refusals::COMPARED_BY_ACCESS);
    };
    match (number(&items), number(&others)) {
        (Some(items), Some(others)) if items == others => Ok(None),
        _ if both.access == Access::Unknown => refused(site, refusals::COMPARED_BY_ACCESS),
        _ => Ok(Some(Expr::compare(CompareOp::Eq, items, others))),
    }
}

/// Refuses `chunk_by(…).last()`, of which Rust calls the closure from the end on, if the closure writes or may fault.
pub(super) fn check_last(
    lowering: &mut Lowering,
    function: &tree::Function,
    items: usize,
    site: Site,
) -> Result<()> {
    match standard::is_last(function) && ends_in_chunks(lowering, items) {
        true => refused(site, refusals::LAST_CHUNK),
        false => Ok(()),
    }
}

/// Returns the number of items that `len` returns, without a call of a closure; none for another function.
pub(super) fn length_of_items(
    lowering: &mut Lowering,
    (function, arguments): Called,
    site: Site,
) -> Result<Option<Expr>> {
    let [items] = arguments else { return Ok(None) };
    if !standard::is_len(function) {
        return Ok(None);
    }
    let known = match lowering.iterator_named(items) {
        Some(named) => lowering.hands.get(&named).map_or(named, |hand| hand.again),
        None => match lowering.gone_through(items)? {
            Value::Closure(made) => made,
            _ => return refused(site, refusals::UNKNOWN_LENGTH),
        },
    };
    let through = (*lowering.closures[known]).clone();
    let is_counted = lowering.hands.values().any(|hand| hand.again == known && hand.stateful);
    let length = if is_counted { None } else { length_of(lowering, &through) };
    match length {
        Some(length) => Ok(Some(length)),
        None => refused(site, refusals::UNKNOWN_LENGTH),
    }
}

/// Returns true if an argument is `&mut iterator`.
pub(super) fn is_borrowed(lowering: &Lowering, argument: &tree::Expr) -> bool {
    let by_ref = |it: &Builtin| matches!(it, Builtin::Desugared(Desugared::ByRef));
    matches!(argument.kind, Tree::Ref(true, _))
        || lowering.builtin_call(argument).is_some_and(|(called, _)| by_ref(&called))
}

/// Lowers something in the scope of a closure.
fn within<'a, T>(
    lowering: &mut Lowering<'a, '_>,
    through: &Closure<'a>,
    lower: impl FnOnce(&mut Lowering<'a, '_>) -> T,
) -> Option<T> {
    let site = through.text.body.site;
    lowering.in_scope_of(through, None, site, |inner| Ok(lower(inner))).ok()
}

/// Returns the properties of the items of an iterator that is a closure.
fn named_items(lowering: &mut Lowering, known: usize) -> Items {
    let through = (*lowering.closures[known]).clone();
    let items = items_of(lowering, &through);
    let is_counted = lowering.hands.iter().any(|(it, hand)| *it == known || hand.again == known);
    match (is_counted, through.borrowed) {
        (_, true) => items.at_most(Access::Counted),
        // It may be borrowed.
        (true, _) => items.at_most(Access::Unknown),
        _ => items,
    }
}

fn items_of<'a>(lowering: &mut Lowering<'a, '_>, through: &Closure<'a>) -> Items {
    match &through.text.body.kind {
        Tree::Each { source, .. } => of_source(lowering, source, through),
        _ => Items::UNKNOWN,
    }
}

fn of_source<'a>(lowering: &mut Lowering<'a, '_>, source: &Source, through: &Closure<'a>) -> Items {
    let mut of = |source: &Source| of_source(lowering, source, through);
    match source {
        Source::Elements(array, owned) => of_elements(lowering, (array, *owned), through),
        Source::Numbers(range) => {
            let access = match range.to {
                Some(_) if !range.inclusive => Access::Indexed,
                _ => Access::Counted,
            };
            Items { endless: range.to.is_none(), ..Items::plain(access) }
        }
        Source::Groups(..) => Items::plain(Access::Indexed),
        Source::Zip(one, other, _) => of(one).beside(of(other)),
        Source::Chain(one, other) => of(one).beside(of(other)).at_most(Access::Counted),
        Source::Skip(inner, count) | Source::Take(inner, count) if is_own(count) => of(inner),
        Source::Enumerate(inner) => of(inner),
        Source::Rev(inner) => of(inner).at_most(Access::Counted),
        Source::Take(inner, _) => of(inner).taken(),
        Source::Cycle(inner) => Items { endless: true, ..of(inner).at_most(Access::Serial) },
        Source::Skip(inner, _) => of(inner).skipped(),
        Source::StepBy(inner, _) => of(inner).stepped(),
    }
}

/// Returns true for the count of a counted or limited iterator, which no author wrote.
fn is_own(count: &tree::Expr) -> bool {
    let begins = |name: &str| name.starts_with("taken%") || name.starts_with("limit%");
    matches!(&count.kind, Tree::Local(name) if begins(name))
}

fn of_elements<'a>(
    lowering: &mut Lowering<'a, '_>,
    (array, owned): (&tree::Expr, bool),
    through: &Closure<'a>,
) -> Items {
    let adapted = |inner: &mut Lowering<'a, '_>| inner.expansion(array);
    let adapted = within(lowering, through, adapted).flatten();
    if let Some((function, arguments)) = adapted.filter(|it| generates(it.0)) {
        return of_adapter(lowering, (function, arguments), through);
    }
    let (own, named) = within(lowering, through, |inner| {
        (inner.own_next(array).is_some(), inner.iterator_named(array))
    })
    .unwrap_or_default();
    match named {
        _ if own => Items::plain(Access::Serial).acting(true),
        Some(known) => named_items(lowering, known),
        None => {
            let plain = within(lowering, through, |inner| plain_access(inner, array, owned));
            Items::plain(plain.unwrap_or(Access::Unknown))
        }
    }
}

fn of_adapter<'a>(
    lowering: &mut Lowering<'a, '_>,
    (function, arguments): Called<'a, '_>,
    through: &Closure<'a>,
) -> Items {
    let (mut sides, mut acting) = (Vec::new(), false);
    for (param, argument) in function.tree.params.iter().zip(arguments) {
        if param.items {
            sides.push(of_argument(lowering, argument, through));
        } else if param.closure {
            acting |= acts(lowering, argument, through);
        }
    }
    standard::adapted(function, &sides, acting)
}

/// Returns the properties of the items of an adapter's argument.
fn of_argument<'a>(
    lowering: &mut Lowering<'a, '_>,
    argument: &tree::Expr,
    through: &Closure<'a>,
) -> Items {
    items_of(lowering, &Closure { text: handing(argument), ..through.clone() })
}

/// Returns the access to elements, or to the value of an `Option`.
fn plain_access(lowering: &mut Lowering, array: &tree::Expr, owned: bool) -> Access {
    let mut by_reference = !owned || matches!(array.kind, Tree::Ref(..));
    let ty = match lowering.meaning(array) {
        // It may be a slice of the matrix, or an iterator of nalgebra's.
        Some(Value::Slice(slice)) => match &slice.base.ty {
            Type::Matrix { .. } => return Access::Unknown,
            _ => return Access::Indexed,
        },
        Some(Value::Submatrix(_)) => return Access::Serial,
        Some(meaning) => {
            let span = lowering.span(array.site);
            let Some(place) = lowering.place_of(&meaning, span) else { return Access::Unknown };
            by_reference |= lowering.locals[place.root.index()].mode != Mode::Value;
            by_reference |= lowering.is_loan(&place);
            let copied = matches!(&array.kind, Tree::Local(name) if is_hidden(name));
            let own = matches!(meaning, Value::Local(_)) || copied;
            match (by_reference || !own, &place.ty) {
                (false, Type::Array { .. }) => return Access::Counted,
                _ => place.ty,
            }
        }
        None => match lowering.place_type(bare(array)) {
            Ok(ty) => ty,
            Err(_) => return Access::Unknown,
        },
    };
    match &ty {
        Type::Slice(_) => Access::Indexed,
        Type::Array { .. } if by_reference => Access::Indexed,
        Type::Matrix { .. } => Access::Serial,
        Type::Struct(id) if lowering.going_on(*id) == Some("Some") => Access::Counted,
        Type::Struct(_) if by_reference && lowering.contained(&ty).is_some() => {
            match lowering.cx.known(&ty).bounded {
                true => Access::Serial,
                false => Access::Indexed,
            }
        }
        _ => Access::Unknown,
    }
}

/// Returns true if a closure may write or fault.
fn acts(lowering: &Lowering, closure: &tree::Expr, through: &Closure) -> bool {
    let Tree::Closure(closure) = &closure.kind else { return true };
    let own_equality = lowering.cx.has_own_equality();
    closure.body.any_expr(|it| match &it.kind {
        Tree::Bool(_) | Tree::Int(..) | Tree::Float(..) | Tree::Path(..) => false,
        Tree::Local(_) | Tree::Field(..) | Tree::Deref(_) | Tree::Ref(..) => false,
        Tree::Tuple(_) | Tree::Array(_) | Tree::Constructor(..) | Tree::Cast(_) => false,
        // No slot says of which type a place is.
        Tree::Binary(BinaryOp::Eq | BinaryOp::Ne, left, right)
            if own_equality && ![left, right].into_iter().any(|it| is_scalar(it, through)) =>
        {
            true
        }
        Tree::Binary(op, _, right) => may_fault(*op, right) && !is_float(it, through),
        Tree::Unary(..) => !is_float(it, through),
        _ => true,
    })
}

/// Returns true if an operator of integers may fault.
fn may_fault(op: BinaryOp, right: &tree::Expr) -> bool {
    use BinaryOp::{Add, Div, Mul, Rem, Shl, Shr, Sub};
    match op {
        Add | Sub | Mul => true,
        Div | Rem => !matches!(&right.kind, Tree::Int(digits, _) if digits != "0"),
        Shl | Shr => !matches!(&right.kind, Tree::Int(..)),
        _ => false,
    }
}

/// Returns true if rustc sees an expression as a float.
fn is_float(expr: &tree::Expr, through: &Closure) -> bool {
    matches!(seen_as(expr, through), Some(Ty::Scalar(Scalar::Float(_))))
}

/// Returns true if an expression is known to be a number or a truth value.
fn is_scalar(expr: &tree::Expr, through: &Closure) -> bool {
    matches!(expr.kind, Tree::Bool(_) | Tree::Int(..) | Tree::Float(..) | Tree::Cast(_))
        || matches!(seen_as(expr, through), Some(Ty::Scalar(_)))
}

fn seen_as<'c>(expr: &tree::Expr, through: &'c Closure) -> Option<&'c Ty> {
    expr.slot.and_then(|slot| through.source.slots.get(slot as usize))
}

/// Returns the number of items of an iterator; none if it consists of other items than elements and numbers.
fn length(lowering: &mut Lowering, known: usize) -> Option<Expr> {
    let is_counted = lowering.hands.iter().any(|(it, hand)| *it == known || hand.again == known);
    let through = (*lowering.closures[known]).clone();
    if is_counted { None } else { length_of(lowering, &through) }
}

fn length_of<'a>(lowering: &mut Lowering<'a, '_>, through: &Closure<'a>) -> Option<Expr> {
    let Tree::Each { source, .. } = &through.text.body.kind else { return None };
    let Source::Elements(array, _) = &**source else {
        let site = through.text.body.site;
        return within(lowering, through, |inner| inner.seq(source, site).ok()?.length())?;
    };
    length_of_elements(lowering, source, array, through)
}

fn length_of_elements<'a>(
    lowering: &mut Lowering<'a, '_>,
    source: &Source,
    array: &tree::Expr,
    through: &Closure<'a>,
) -> Option<Expr> {
    let adapted = |inner: &mut Lowering<'a, '_>| inner.expansion(array);
    let Some((function, arguments)) =
        within(lowering, through, adapted)?.filter(|it| generates(it.0))
    else {
        let named = within(lowering, through, |inner| inner.iterator_named(array))?;
        let site = through.text.body.site;
        return match named {
            Some(known) => length(lowering, known),
            None => within(lowering, through, |inner| inner.seq(source, site).ok()?.length())?,
        };
    };
    let mut of = |argument: &tree::Expr| {
        length_of(lowering, &Closure { text: handing(argument), ..through.clone() })
    };
    match (standard::number(function)?, arguments) {
        (Number::Same, [items, ..]) => of(items),
        (Number::Least, [one, other]) => Some(least(of(one)?, of(other)?)),
        _ => None,
    }
}

/// Returns how the consumer takes items whose pass this body is.
fn taking(
    function: &tree::Function,
    body: &tree::Block,
    names: &Scopes,
    lowering: &Lowering,
) -> Taking {
    let beyond = || match names.meaning(EACH) {
        Some(Value::Closure(each)) => {
            let each = &lowering.closures[*each];
            match &each.text.body.kind {
                Tree::Block(body) => taking(each.source, body, &each.scope.names, lowering),
                _ => Taking::Mixed,
            }
        }
        _ => Taking::Mixed,
    };
    match standard::consumer(function) {
        Some(Consumer::Takes(taking)) => taking,
        Some(Consumer::PassesOn) => beyond(),
        Some(Consumer::PassesOnNext) if beyond() == Taking::Next => Taking::Next,
        Some(Consumer::PassesOnNext) => Taking::Mixed,
        None => match body.stmts.last() {
            Some(Stmt::Expr(last)) => match &last.kind {
                Tree::Apply(name, _) if name == EACH => beyond(),
                Tree::Assign(_, so_far, _) if is_gathered(so_far) => Taking::Fold,
                _ => Taking::Next,
            },
            _ => Taking::Next,
        },
    }
}

/// Returns true for the result of `sum` and `product`.
fn is_gathered(so_far: &tree::Expr) -> bool {
    matches!(&so_far.kind, Tree::Local(name) if standard::is_gathered(name))
}

/// Returns true if an iterator ends in the parts of `chunk_by` whose closure writes or may fault.
fn ends_in_chunks(lowering: &mut Lowering, known: usize) -> bool {
    let through = (*lowering.closures[known]).clone();
    chunks_in(lowering, &through)
}

fn chunks_in<'a>(lowering: &mut Lowering<'a, '_>, through: &Closure<'a>) -> bool {
    let Tree::Each { source, .. } = &through.text.body.kind else { return false };
    let Source::Elements(array, _) = &**source else { return false };
    let adapted =
        |inner: &mut Lowering<'a, '_>| (inner.expansion(array), inner.iterator_named(array));
    let (function, arguments) = match within(lowering, through, adapted) {
        Some((Some(called), _)) => called,
        Some((None, Some(known))) => return ends_in_chunks(lowering, known),
        _ => return false,
    };
    if standard::is_chunk_by(function) {
        return arguments
            .iter()
            .any(|it| matches!(it.kind, Tree::Closure(_)) && acts(lowering, it, through));
    }
    let params = function.tree.params.iter().zip(arguments).filter(|it| it.0.items);
    standard::ends_in_argument(function)
        && params.into_iter().any(|(_, argument)| {
            chunks_in(lowering, &Closure { text: handing(argument), ..through.clone() })
        })
}
