//! Lowers `==` and `<` of values with several words.
//!
//! `==` is taken part by part, of an array of more than a few in a loop. A struct of words alone is compared where `==` stands;
//! any other has a function for it, one for each type, so that what nests is written once: `motor_equal(&one, &other)`. A loop
//! over the elements of a part returns at the first that differ. Floats compare as IEEE 754 has it, so that a NaN in a part makes the whole unequal.
//!
//! `<` of tuples, arrays and structs that derive it: the first parts that differ decide. A NaN among these makes each comparison
//! false, as in Rust: it neither comes first nor is it equal. Of enums with payload, options and results the variants decide,
//! and behind these what they hold. A variant's word is its index; Rust compares and converts the numbers of an enum, which the
//! author may choose. A few words are compared where `<` stands. Any other type has a function for it, whose `return`s decide:
//! `report_less(&one, &other)`. So no expression grows with what nests in it.
//!
//! Invariant: the order of a payload is read only where both values have its variant, and this is tested of both.

use bessemer_ir::tree::Site;
use bessemer_ir::{
    Argument, Attributes, Block, CompareOp, EnumId, Expr, ExprKind, Form, Function, FunctionId,
    Int, LogicOp, Mode, Owner, Place, Role, Scalar, Span, Step, Stmt, StmtKind, StructId, Type,
};

use super::function::without_marks;
use super::lengths::size;
use super::lowering::Lowering;
use super::pair::{
    FEW, Pair, fields, free_name, has_loop, is_flat, is_short, is_variant, opposite,
    ordered_choice, parts, strict,
};
use super::value::step_to;
use super::words;
use super::{Needed, OUR_FAULT, Result, bounded, problem, refusals, refused};

/// Documentation of the generated functions.
const LESS_DOCS: &str = "Whether the first is less, by the first parts that differ.";
const LESS_OR_EQUAL_DOCS: &str =
    "Whether the first is less or equal, by the first parts that differ.";

impl Lowering<'_, '_> {
    /// Lowers `left == right` of two values of one type.
    pub(super) fn equality(&mut self, left: Expr, right: Expr, site: Site) -> Result<Expr> {
        if left.ty.is_word()
            && let Some(equal) = self.own_equality(&left, &right, site)?
        {
            return Ok(equal);
        }
        let own = self.cx.known(&left.ty).own_equality.is_some();
        match (is_variant(self, &left), is_variant(self, &right)) {
            (false, true) if !own => return self.equal_variant(left, right, site),
            (true, false) if !own => return self.equal_variant(right, left, site),
            _ => {}
        }
        let sides = [left, right].map(|side| self.hold(side));
        let pair = Pair { span: self.span(site), site, sides };
        match pair.sides[0].ty {
            Type::Struct(id) if !own && is_flat(self, id) => {
                self.check_equality(&pair.sides[0].ty, site)?;
                self.equal_fields(id, &pair)
            }
            _ => self.equal(&pair),
        }
    }

    /// Lowers `value == Some(part)`: compares the payload, and builds no variant.
    fn equal_variant(&mut self, value: Expr, variant: Expr, site: Site) -> Result<Expr> {
        let span = self.span(site);
        self.check_equality(&value.ty, site)?;
        let value = self.hold(value);
        let (ExprKind::Struct(parts), Type::Struct(id)) = (variant.kind, variant.ty) else {
            return problem(site, "this is no variant", OUR_FAULT);
        };
        let word = match parts.first().map(|tag| &tag.kind) {
            Some(ExprKind::Literal(word)) => *word,
            _ => 0,
        };
        let there = self.tag_is(&value, id, word);
        let definition = &self.cx.module.structs[id.index()];
        let mut parts = parts.into_iter().enumerate().skip(1);
        let Some((at, part)) = parts.find(|(at, _)| definition.holds(*at, word)) else {
            return Ok(there);
        };
        let own = self.part(&value, id, at);
        // It is evaluated whether the variant is there or not.
        let part = self.atom(words::OPERAND, part);
        let known = self.cx.known(&part.ty);
        let plain = part.ty.is_word() && known.own_equality.is_none() && !known.unequal;
        if plain {
            let same = Expr::compare(CompareOp::Eq, own.load(), part).at(span);
            return Ok(Expr::logic(LogicOp::And, there, same));
        }
        let pair = Pair { sides: [own, self.hold(part)], site, span };
        self.logic_and(there, &mut Vec::new(), |inner, _| inner.equal(&pair))
    }

    pub(super) fn equal(&mut self, pair: &Pair) -> Result<Expr> {
        let Pair { site, span, .. } = *pair;
        let [left, right] = &pair.sides;
        if let Some(equal) = self.own_equality(&left.load(), &right.load(), site)? {
            return Ok(equal);
        }
        self.check_equality(&left.ty, site)?;
        match &left.ty {
            Type::Unit | Type::Slice(_) => Ok(Expr::bool(true, span)),
            Type::Scalar(_) | Type::Enum(_) => {
                Ok(Expr::compare(CompareOp::Eq, left.load(), right.load()).at(span))
            }
            Type::Struct(id) => {
                let function = self.equality_of(*id, site)?;
                let lent = [left, right].map(|place| Argument::Ref(place.load()));
                let kind = ExprKind::Call(function, lent.into());
                Ok(Expr { kind, ty: Type::BOOL, span })
            }
            Type::Array { element, len } => self.equal_elements(pair, element, *len),
            Type::Matrix { element, rows, cols } => {
                let element = Type::Scalar(*element);
                if *rows == 1 || *cols == 1 {
                    return self.equal_elements(pair, &element, rows * cols);
                }
                self.all_equal(size(*cols, span), span, |inner, col| {
                    inner.all_equal(size(*rows, span), span, |inner, row| {
                        inner.equal(&pair.at(&Step::Element(row, col), &element))
                    })
                })
            }
        }
    }

    /// Returns the function that compares two values of a type, and generates it at the first call.
    fn equality_of(&mut self, id: StructId, site: Site) -> Result<FunctionId> {
        if let Some(known) = self.cx.known_of(id).compared.equal {
            return Ok(known);
        }
        let names = [words::EQUAL, words::SAME_PARTS];
        let docs = "Whether the two are equal, part by part.";
        let body = |inner: &mut Lowering<'_, '_>, pair: &Pair| equality_body(inner, id, pair);
        let function = function_of_two(self, id, site, (names, docs), body)?;
        self.cx.note(&Type::Struct(id)).compared.equal = Some(function);
        Ok(function)
    }

    /// Compares field by field, and returns the condition of the fields after the last one with a loop. Before it, returns
    /// of false are emitted; a struct of words has no such field.
    fn equal_fields(&mut self, id: StructId, pair: &Pair) -> Result<Expr> {
        let form = self.cx.module.structs[id.index()].form.clone();
        let mut all: Option<Expr> = None;
        for index in 0..self.cx.fields(id).len() {
            let part = pair.parts(|whole| self.part(whole, id, index));
            // A field that may hold nothing is looked at where it does.
            let there = match &form {
                Form::Choice(chosen) if index > 0 => {
                    let word = chosen.iter().position(|field| *field == Some(index as u32));
                    Some(self.tag_is(&pair.sides[0], id, word.unwrap_or_default() as u64))
                }
                _ => None,
            };
            if has_loop(self, &part.sides[0].ty) {
                if let Some(before) = all.take() {
                    return_unless(self, before, pair.span);
                }
                let ((), inner) = self.in_block(|inner| return_if_unequal(inner, &part))?;
                match there {
                    None => self.out.extend(inner),
                    Some(there) => self.emit_if(there, Block(inner), pair.span),
                }
                continue;
            }
            let compare = |inner: &mut Self| match there {
                None => inner.equal(&part),
                Some(there) => {
                    let absent = there.negated();
                    inner.short_circuit(LogicOp::Or, absent, part.span, |inner| inner.equal(&part))
                }
            };
            all = Some(match all {
                None => compare(self)?,
                Some(all) => self.logic_and(all, &mut Vec::new(), |inner, _| compare(inner))?,
            });
        }
        Ok(all.unwrap_or_else(|| Expr::bool(true, pair.span)))
    }

    /// Refuses `==` of a type without an equality that the DSL can see.
    fn check_equality(&self, ty: &Type, site: Site) -> Result<()> {
        if !self.cx.known(ty).unequal {
            return Ok(());
        }
        if self.cx.as_borrowed(ty).is_some() {
            return refused(site, refusals::SLICES_COMPARED);
        }
        let Some(name) = self.cx.name_of(ty) else { return Ok(()) };
        problem(
            site,
            format!("`{name}` has no `PartialEq` below `#[data]`"),
            "write `#[derive(PartialEq)]` below `#[data]`, mark the `impl` block of your own `#[data]`, or compare the parts",
        )
    }

    fn equal_elements(&mut self, pair: &Pair, element: &Type, len: u32) -> Result<Expr> {
        let pair = Pair { span: pair.sides[0].span, ..pair.clone() };
        let at = |index| pair.at(&step_to(&pair.sides[0].ty, index, pair.span), element);
        if len > FEW || !element.is_word() {
            let len = size(len, pair.span);
            return self.all_equal(len, pair.span, |inner, index| inner.equal(&at(index)));
        }
        let same = (0..len).map(|index| self.equal(&at(size(index, pair.span))));
        let same: Vec<Expr> = same.collect::<Result<_>>()?;
        let all = same.into_iter().reduce(|all, next| Expr::logic(LogicOp::And, all, next));
        Ok(all.unwrap_or_else(|| Expr::bool(true, pair.span)))
    }

    /// Emits a loop over the indices below `count` that ends at the first unequal pair.
    pub(super) fn all_equal(
        &mut self,
        count: Expr,
        span: Span,
        equal: impl FnOnce(&mut Self, Expr) -> Result<Expr>,
    ) -> Result<Expr> {
        let flag = self.assigned("equal", Expr::bool(true, span));
        let held = flag.load();
        self.below("i", count, span, |inner, index| {
            let same = equal(inner, index)?;
            let unequal = StmtKind::Assign { place: flag, value: Expr::bool(false, span) };
            let then = vec![Stmt::new(unequal, span), Stmt::new(StmtKind::Break, span)];
            inner.emit_if(opposite(same), Block(then), span);
            Ok(())
        })?;
        Ok(held)
    }

    /// Lowers `left < right` and the like of two values of several words.
    pub(super) fn lexical(
        &mut self,
        op: CompareOp,
        left: Expr,
        right: Expr,
        site: Site,
    ) -> Result<Expr> {
        let mut sides = [left, right].map(|operand| self.hold(operand));
        let is_reversed = self.cx.known(&sides[0].ty).reversed;
        if is_reversed {
            sides.reverse();
        }
        let pair = Pair { span: sides[0].span, site, sides };
        match pair.sides[0].ty.clone() {
            Type::Struct(id) if !is_reversed => {
                match (is_short(self, id), ordered_choice(self, id)) {
                    (true, true) => self.by_variants(op, id, &pair),
                    (true, false) => {
                        let parts = parts(self, &pair)?;
                        self.by_parts(op, parts, site)
                    }
                    _ => call_of_order(self, op, id, &pair),
                }
            }
            Type::Array { element, len } if len > FEW || !element.is_word() => {
                elements_in_order(self, op, &pair, (&element, len))
            }
            _ => {
                let parts = parts(self, &pair)?;
                self.by_parts(op, parts, site)
            }
        }
    }

    /// Compares part by part; the first unequal parts decide.
    fn by_parts(&mut self, op: CompareOp, parts: Vec<Pair>, site: Site) -> Result<Expr> {
        let mut decided: Option<Expr> = None;
        for part in parts.into_iter().rev() {
            let [one, other] = part.sides.map(|side| side.load());
            decided = Some(match decided {
                None => self.compare_node(op, one, other, site)?,
                Some(rest) => {
                    let first = self.compare_node(strict(op), one.clone(), other.clone(), site)?;
                    let same = self.compare_node(CompareOp::Eq, one, other, site)?;
                    Expr::logic(LogicOp::Or, first, Expr::logic(LogicOp::And, same, rest))
                }
            });
        }
        decided.or_refused(site, refusals::EMPTY_ORDER)
    }

    /// Compares the variants, then the word of equal variants.
    fn by_variants(&mut self, op: CompareOp, id: StructId, pair: &Pair) -> Result<Expr> {
        let tags = pair.parts(|whole| self.part(whole, id, 0)).sides.map(|tag| tag.load());
        let [one, other] = tags;
        let same = Expr::compare(CompareOp::Eq, one, other).at(pair.span);
        let first = order_of_tags(self, strict(op), id, pair);
        let held = word_of_variant(self, op, id, pair)?;
        Ok(Expr::logic(LogicOp::Or, first, Expr::logic(LogicOp::And, same, held)))
    }

    /// Returns the number of an enum's value that `<` compares.
    pub(super) fn rank(&self, id: EnumId, value: Expr, site: Site) -> Result<Expr> {
        let definition = &self.cx.module.enums[id.index()];
        if self.cx.is_name(&Type::Enum(id)) {
            return refused(site, refusals::ORDER_OF_NAMES);
        }
        if !self.cx.known(&Type::Enum(id)).ordered {
            return problem(
                site,
                format!("`{}` has no `PartialOrd` below `#[data]`", definition.name),
                "write `#[derive(PartialOrd)]` below `#[data]`, or `match`",
            );
        }
        Ok(self.number(id, value))
    }

    /// Returns the author's number of an enum's value, or its index if there is none.
    fn number(&self, id: EnumId, value: Expr) -> Expr {
        match self.cx.module.enums[id.index()].is_numbered() {
            true => value.cast(&Type::Scalar(Scalar::Int(Int::I32))),
            false => value,
        }
    }
}

/// Emits the body of a function that compares two values.
fn equality_body(lower: &mut Lowering<'_, '_>, id: StructId, pair: &Pair) -> Result<()> {
    lower.check_equality(&pair.sides[0].ty, pair.site)?;
    let same = if lower.cx.known_of(id).unit == Some(true) {
        lower.same_rotation(id, pair)
    } else if lower.cx.module.structs[id.index()].form == Form::Sequence {
        return_unless_equal_lists(lower, pair)?;
        Expr::bool(true, pair.span)
    } else {
        lower.equal_fields(id, pair)?
    };
    lower.emit(StmtKind::Return(Some(same)), pair.span);
    Ok(())
}

/// Emits a return of false if two values differ.
fn return_if_unequal(lower: &mut Lowering<'_, '_>, pair: &Pair) -> Result<()> {
    let (ty, span) = (pair.sides[0].ty.clone(), pair.sides[0].span);
    let by = |step: Step, element: &Type| Pair { span, ..pair.at(&step, element) };
    let (element, count) = match &ty {
        looped if !has_loop(lower, looped) => {
            let same = lower.equal(pair)?;
            return_unless(lower, same, pair.span);
            return Ok(());
        }
        Type::Matrix { element, rows, cols } if *rows > 1 && *cols > 1 => {
            let element = Type::Scalar(*element);
            return lower.each_cell(words::COLUMN, (*rows, *cols), span, |inner, row, column| {
                return_if_unequal(inner, &by(Step::Element(row, column), &element))
            });
        }
        Type::Matrix { element, rows, cols } => (Type::Scalar(*element), rows * cols),
        Type::Array { element, len } => ((**element).clone(), *len),
        _ => return problem(pair.site, "these have no elements", OUR_FAULT),
    };
    lower.below("i", size(count, span), span, |inner, index| {
        return_if_unequal(inner, &by(step_to(&ty, index, span), &element))
    })
}

/// Emits returns of false unless two lists have the same length and elements.
fn return_unless_equal_lists(lower: &mut Lowering<'_, '_>, pair: &Pair) -> Result<()> {
    let (same, count, at) = bounded::compared(lower, &pair.sides, pair.site)?;
    return_unless(lower, same, pair.span);
    lower.below("i", count, pair.span, |inner, index| {
        return_if_unequal(inner, &Pair { sides: at(index), ..*pair })
    })
}

/// Emits a return of false unless two values are the same.
fn return_unless(lower: &mut Lowering<'_, '_>, same: Expr, span: Span) {
    let unequal = StmtKind::Return(Some(Expr::bool(false, span)));
    lower.emit_if(opposite(same), Block(vec![Stmt::new(unequal, span)]), span);
}

/// Generates an inline function that compares two values of a type. It has the second name if the author has a function of
/// the first.
fn function_of_two(
    lower: &mut Lowering<'_, '_>,
    id: StructId,
    site: Site,
    (names, docs): ([&str; 2], &str),
    body: impl FnOnce(&mut Lowering<'_, '_>, &Pair) -> Result<()>,
) -> Result<FunctionId> {
    let (name, item) = (free_name(lower, id, names), &lower.cx.module.structs[id.index()]);
    let (module, span, ty) = (item.module.clone(), item.span, Type::Struct(id));
    let mut inner = Lowering::new(&mut *lower.cx, lower.source)?;
    inner.naming = words::ALL_PARTS.into();
    let sides = words::COMPARED.map(|name| {
        let local = inner.declare(name, ty.clone(), Mode::Ref, span);
        Place::local(local, ty.clone(), span)
    });
    body(&mut inner, &Pair { sides, site, span })?;
    let (locals, out) = (std::mem::take(&mut inner.locals), std::mem::take(&mut inner.out));
    lower.cx.module.functions.push(Function {
        name,
        module,
        owner: Some(Owner::Struct(id)),
        role: Role::Inline { public: true },
        attributes: Attributes::default(),
        docs: vec![docs.to_owned()],
        locals: locals.into_all().into_iter().map(without_marks).collect(),
        params: 2,
        result: Type::BOOL,
        result_name: String::new(),
        body: Block(out),
        kernel: None,
        span,
    });
    Ok(FunctionId(lower.cx.module.functions.len() as u32 - 1))
}

/// Returns the order of the variants of two values. An `Ok` comes before an `Err`, though its word is the larger.
fn order_of_tags(lower: &Lowering<'_, '_>, op: CompareOp, id: StructId, pair: &Pair) -> Expr {
    let mut tags = pair.parts(|whole| lower.part(whole, id, 0)).sides.map(|tag| {
        let tag = tag.load();
        match tag.ty {
            Type::Enum(of) => lower.number(of, tag),
            _ => tag,
        }
    });
    if lower.cx.known_of(id).error.is_some() {
        tags.reverse();
    }
    let [one, other] = tags;
    Expr::compare(op, one, other).at(pair.span)
}

/// Compares the word of two values that have the same variant, if that variant has the word.
fn word_of_variant(
    lower: &mut Lowering<'_, '_>,
    op: CompareOp,
    id: StructId,
    pair: &Pair,
) -> Result<Expr> {
    let mut cases = (0..).zip(&lower.cx.known_of(id).cases);
    let with_word = cases.find_map(|(word, case)| Some((word, case.field?)));
    let Some((word, field)) = with_word else {
        return Ok(Expr::bool(op != strict(op), pair.span));
    };
    let there = lower.tag_is(&pair.sides[0], id, word);
    let part = pair.parts(|whole| lower.part(whole, id, field as usize));
    let [one, other] = part.sides.map(|side| side.load());
    let ordered = lower.compare_node(op, one, other, part.site)?;
    Ok(match op == strict(op) {
        true => Expr::logic(LogicOp::And, there, ordered),
        false => Expr::logic(LogicOp::Or, there.negated(), ordered),
    })
}

/// Calls the function that compares two values of a type. `>` is `<` of the operands in turned order.
fn call_of_order(
    lower: &mut Lowering<'_, '_>,
    op: CompareOp,
    id: StructId,
    pair: &Pair,
) -> Result<Expr> {
    let mut sides = pair.sides.clone();
    let op = match op {
        CompareOp::Gt | CompareOp::Ge => {
            sides.reverse();
            if op == CompareOp::Gt { CompareOp::Lt } else { CompareOp::Le }
        }
        op => op,
    };
    let function = order_of(lower, op, id, pair.site)?;
    let kind = ExprKind::Call(function, sides.map(|side| Argument::Ref(side.load())).into());
    Ok(Expr { kind, ty: Type::BOOL, span: pair.span })
}

/// Returns the function for `<` or `<=` of a type, and generates it at the first call.
fn order_of(
    lower: &mut Lowering<'_, '_>,
    op: CompareOp,
    id: StructId,
    site: Site,
) -> Result<FunctionId> {
    let known = &lower.cx.known_of(id).compared;
    let (known, names, docs) = match op {
        CompareOp::Le => (known.less_or_equal, words::LESS_OR_EQUAL, LESS_OR_EQUAL_DOCS),
        _ => (known.less, words::LESS, LESS_DOCS),
    };
    if let Some(known) = known {
        return Ok(known);
    }
    let body = |inner: &mut Lowering<'_, '_>, pair: &Pair| match ordered_choice(inner, id) {
        true => return_order_of_variants(inner, op, id, pair),
        false => {
            let parts = parts(inner, pair)?;
            return_order(inner, op, parts, pair)
        }
    };
    let function = function_of_two(lower, id, site, (names, docs), body)?;
    let known = &mut lower.cx.note(&Type::Struct(id)).compared;
    match op {
        CompareOp::Le => known.less_or_equal = Some(function),
        _ => known.less = Some(function),
    }
    Ok(function)
}

/// Emits returns of the order of two payloads of one variant, and of the order of other variants.
fn return_order_of_variants(
    lower: &mut Lowering<'_, '_>,
    op: CompareOp,
    id: StructId,
    pair: &Pair,
) -> Result<()> {
    for (word, case) in (0..).zip(lower.cx.known_of(id).cases.clone()) {
        let Some(field) = case.field else { continue };
        let [one, other] = [0, 1].map(|side| lower.tag_is(&pair.sides[side], id, word));
        let part = pair.parts(|whole| lower.part(whole, id, field as usize));
        let parts = match (case.single, &part.sides[0].ty) {
            (false, Type::Struct(inner)) => fields(lower, *inner, &part),
            _ => vec![part.clone()],
        };
        let ((), then) = lower.in_block(|inner| return_order(inner, op, parts, &part))?;
        lower.emit_if(Expr::logic(LogicOp::And, one, other), Block(then), pair.span);
    }
    let tags = order_of_tags(lower, op, id, pair);
    lower.emit(StmtKind::Return(Some(tags)), pair.span);
    Ok(())
}

/// Emits the return of the order of some parts.
fn return_order(
    lower: &mut Lowering<'_, '_>,
    op: CompareOp,
    mut parts: Vec<Pair>,
    pair: &Pair,
) -> Result<()> {
    let last = parts.pop().or_refused(pair.site, refusals::EMPTY_ORDER)?;
    for part in &parts {
        return_order_if_unequal(lower, op, part)?;
    }
    let whole = match last.sides[0].ty {
        Type::Array { .. } => {
            return_order_if_unequal(lower, op, &last)?;
            Expr::bool(op != strict(op), pair.span)
        }
        _ => {
            let [one, other] = last.sides.map(|side| side.load());
            lower.compare_node(op, one, other, pair.site)?
        }
    };
    lower.emit(StmtKind::Return(Some(whole)), pair.span);
    Ok(())
}

/// Emits a return of the order of two parts if they differ.
fn return_order_if_unequal(lower: &mut Lowering<'_, '_>, op: CompareOp, part: &Pair) -> Result<()> {
    let span = part.span;
    if let Type::Array { element, len } = &part.sides[0].ty {
        return lower.below("i", size(*len, span), span, |inner, index| {
            let step = step_to(&part.sides[0].ty, index, span);
            return_order_if_unequal(inner, op, &part.at(&step, element))
        });
    }
    let [one, other] = part.sides.clone().map(|side| side.load());
    let first = |inner: &mut Lowering<'_, '_>| {
        let first = inner.compare_node(strict(op), one.clone(), other.clone(), part.site)?;
        inner.emit(StmtKind::Return(Some(first)), span);
        Ok(())
    };
    let ((), then) = lower.in_block(first)?;
    let same = lower.compare_node(CompareOp::Eq, one, other, part.site)?;
    lower.emit_if(opposite(same), Block(then), span);
    Ok(())
}

/// Emits a loop over the elements of two arrays that ends at the first unequal ones, which decide.
fn elements_in_order(
    lower: &mut Lowering<'_, '_>,
    op: CompareOp,
    pair: &Pair,
    (element, len): (&Type, u32),
) -> Result<Expr> {
    let span = pair.span;
    let flag = lower.assigned(words::IN_ORDER, Expr::bool(op != strict(op), span));
    let held = flag.load();
    lower.below("i", size(len, span), span, |inner, index| {
        let at = pair.at(&step_to(&pair.sides[0].ty, index, span), element);
        let [one, other] = at.sides.map(|side| side.load());
        let decide = |inner: &mut Lowering<'_, '_>| {
            let first = inner.compare_node(strict(op), one.clone(), other.clone(), pair.site)?;
            inner.emit(StmtKind::Assign { place: flag, value: first }, span);
            inner.emit(StmtKind::Break, span);
            Ok(())
        };
        let ((), then) = inner.in_block(decide)?;
        let same = inner.compare_node(CompareOp::Eq, one, other, pair.site)?;
        inner.emit_if(opposite(same), Block(then), span);
        Ok(())
    })?;
    Ok(held)
}
