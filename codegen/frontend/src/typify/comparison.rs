//! Lowers `==` and `<` of values with several words.
//!
//! `==` is taken part by part, of an array of more than a few in a loop. A struct of words alone is compared where `==` stands;
//! any other has a function for it, one for each type, so that what nests is written once: `motor_equal(&one, &other)`. A loop
//! over the elements of a part returns at the first that differ. Floats compare as IEEE 754 has it, so that a NaN in a part makes the whole unequal.
//!
//! `<` of tuples, arrays and structs that derive it: the first parts that differ decide. A NaN among these makes each comparison
//! false, as in Rust: it neither comes first nor is it equal. Of enums with payload, options and results the variants decide, and
//! behind these what they hold. A variant's word is its index; Rust compares and converts the numbers of an enum, which the
//! author may choose.

use bessemer_ir::tree::Site;
use bessemer_ir::{
    Argument, Attributes, Block, CompareOp, EnumId, Expr, ExprKind, Form, Function, FunctionId,
    Int, LogicOp, Mode, Owner, Place, Role, Scalar, Span, Step, Stmt, StmtKind, StructId, Type,
};

use super::function::without_marks;
use super::lengths::size;
use super::lowering::Lowering;
use super::value::step_to;
use super::words;
use super::{Needed, OUR_FAULT, Result, bounded, problem, refusals, refused};

/// Largest number of elements that are compared one by one, without a loop.
const FEW: u32 = 4;

/// Largest length of an array that `<` compares; its comparison has no loop.
const MOST: u32 = 8;

/// Two places of one type that are compared, with the site.
#[derive(Clone)]
pub(super) struct Pair {
    pub sides: [Place; 2],
    pub site: Site,
    pub span: Span,
}

impl Pair {
    /// Returns the pair of the same part of both places.
    pub(super) fn parts(&self, part: impl Fn(&Place) -> Place) -> Pair {
        let [left, right] = &self.sides;
        Pair { sides: [part(left), part(right)], ..*self }
    }

    /// Returns the pair of the parts that a step leads to.
    fn at(&self, step: &Step, ty: &Type) -> Pair {
        self.parts(|whole| whole.inside(step.clone(), ty.clone()))
    }
}

impl Lowering<'_, '_> {
    /// Lowers `left == right` of two values of one type.
    pub(super) fn equality(&mut self, left: Expr, right: Expr, site: Site) -> Result<Expr> {
        if left.ty.is_word()
            && let Some(equal) = self.own_equality(&left, &right, site)?
        {
            return Ok(equal);
        }
        let own = self.cx.known(&left.ty).own_equality.is_some();
        match (self.is_variant(&left), self.is_variant(&right)) {
            (false, true) if !own => return self.equal_variant(left, right, site),
            (true, false) if !own => return self.equal_variant(right, left, site),
            _ => {}
        }
        let sides = [left, right].map(|side| self.hold(side));
        let pair = Pair { span: self.span(site), site, sides };
        match pair.sides[0].ty {
            Type::Struct(id) if !own && self.is_flat(id) => {
                self.check_equality(&pair.sides[0].ty, site)?;
                self.equal_fields(id, &pair)
            }
            _ => self.equal(&pair),
        }
    }

    /// Returns true for a variant constructed in place, such as `Some(3)`.
    fn is_variant(&self, value: &Expr) -> bool {
        let (ExprKind::Struct(parts), Type::Struct(id)) = (&value.kind, &value.ty) else {
            return false;
        };
        let of_literal = parts.first().is_some_and(|tag| matches!(tag.kind, ExprKind::Literal(_)));
        of_literal && matches!(self.cx.module.structs[id.index()].form, Form::Choice(_))
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

    /// Returns true if a struct has only fields of one word, which are compared as words.
    fn is_flat(&self, id: StructId) -> bool {
        let rotation = self.cx.known_of(id).unit == Some(true);
        let fields = self.cx.fields(id);
        let list = self.cx.module.structs[id.index()].form == Form::Sequence;
        !rotation && !list && fields.iter().all(|field| field.ty.is_word())
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
        if let Some(known) = self.cx.known_of(id).equality {
            return Ok(known);
        }
        let (name, item) = (name_of_equality(self, id), &self.cx.module.structs[id.index()]);
        let (module, span, ty) = (item.module.clone(), item.span, Type::Struct(id));
        let mut inner = Lowering::new(&mut *self.cx, self.source)?;
        inner.naming = words::ALL_PARTS.into();
        let sides = words::COMPARED.map(|name| {
            let local = inner.declare(name, ty.clone(), Mode::Ref, span);
            Place::local(local, ty.clone(), span)
        });
        equality_body(&mut inner, id, &Pair { sides, site, span })?;
        let (locals, out) = (std::mem::take(&mut inner.locals), std::mem::take(&mut inner.out));
        self.cx.module.functions.push(Function {
            name,
            module,
            owner: Some(Owner::Struct(id)),
            role: Role::Inline { public: true },
            attributes: Attributes::default(),
            docs: vec!["Whether the two are equal, part by part.".to_owned()],
            locals: locals.into_all().into_iter().map(without_marks).collect(),
            params: 2,
            result: Type::BOOL,
            result_name: String::new(),
            body: Block(out),
            kernel: None,
            span,
        });
        let function = FunctionId(self.cx.module.functions.len() as u32 - 1);
        self.cx.note(&ty).equality = Some(function);
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
        if self.cx.known(&sides[0].ty).reversed {
            sides.reverse();
        }
        let pair = Pair { span: sides[0].span, site, sides };
        match self.ordered_choice(&pair.sides[0].ty) {
            Some(id) => self.by_variants(op, id, &pair),
            None => {
                let steps = self.steps_to_parts(&pair.sides[0]);
                let steps = steps.or_refused(site, refusals::ORDER)?;
                self.by_parts(op, &pair, steps)
            }
        }
    }

    /// Compares part by part; the first unequal parts decide.
    fn by_parts(&mut self, op: CompareOp, pair: &Pair, steps: Vec<(Step, Type)>) -> Result<Expr> {
        let site = pair.site;
        let mut decided: Option<Expr> = None;
        for (step, ty) in steps.into_iter().rev() {
            let [one, other] = pair.at(&step, &ty).sides.map(|part| part.load());
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

    /// Returns the struct of an ordered enum with payload, an `Option` or a `Result`.
    fn ordered_choice(&self, ty: &Type) -> Option<StructId> {
        let Type::Struct(id) = *ty else { return None };
        let known = self.cx.known(ty);
        let is_ordered = known.ordered || known.shown.is_some();
        (is_ordered && !known.cases.is_empty()).then_some(id)
    }

    /// Compares the variants, then the payloads of equal variants.
    fn by_variants(&mut self, op: CompareOp, id: StructId, pair: &Pair) -> Result<Expr> {
        let span = pair.span;
        let [one, other] = pair.parts(|whole| self.part(whole, id, 0)).sides.map(|tag| tag.load());
        let same = Expr::compare(CompareOp::Eq, one.clone(), other.clone()).at(span);
        let tags = [one, other].map(|tag| match tag.ty {
            Type::Enum(of) => self.number(of, tag),
            _ => tag,
        });
        // An `Ok` comes before an `Err`, though its word is the larger.
        let [one, other] = match (self.cx.known_of(id).error.is_some(), tags) {
            (true, [one, other]) => [other, one],
            (false, tags) => tags,
        };
        let first = Expr::compare(strict(op), one, other).at(span);
        // A payload is read where both have its variant, also by what an operand of `&&` computes before.
        let held =
            self.logic_and(same, &mut Vec::new(), |inner, _| payloads(inner, op, id, pair))?;
        Ok(Expr::logic(LogicOp::Or, first, held))
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

    /// Returns the step to each field, and its type.
    fn steps_to_fields(&self, id: StructId) -> Vec<(Step, Type)> {
        let fields = self.cx.fields(id).iter();
        (0..).zip(fields).map(|(at, it)| (Step::Field(at), it.ty.clone())).collect()
    }

    /// Returns the step to each part, and its type; none if the type has no order by parts.
    fn steps_to_parts(&self, place: &Place) -> Option<Vec<(Step, Type)>> {
        let known = self.cx.known(&place.ty);
        let is_tuple = known.shown.is_some() && known.cases.is_empty();
        match &place.ty {
            Type::Struct(id) if is_tuple || known.ordered || known.reversed => {
                Some(self.steps_to_fields(*id))
            }
            Type::Array { element, len } if *len <= MOST => {
                let step = |at: u32| Step::Index(Expr::usize(u64::from(at), place.span));
                Some((0..*len).map(|at| (step(at), (**element).clone())).collect())
            }
            _ => None,
        }
    }
}

/// Compares the payloads of two values of one variant.
fn payloads(
    lower: &mut Lowering<'_, '_>,
    op: CompareOp,
    id: StructId,
    pair: &Pair,
) -> Result<Expr> {
    let span = pair.span;
    let mut held: Option<Expr> = None;
    for (word, case) in (0..).zip(lower.cx.known_of(id).cases.clone()) {
        let Some(field) = case.field else { continue };
        let there = lower.tag_is(&pair.sides[0], id, word);
        let part = pair.parts(|whole| lower.part(whole, id, field as usize));
        let ordered = |inner: &mut Lowering<'_, '_>| match (case.single, &part.sides[0].ty) {
            (false, Type::Struct(parts)) => {
                let steps = inner.steps_to_fields(*parts);
                inner.by_parts(op, &part, steps)
            }
            _ => {
                let [one, other] = part.sides.clone().map(|side| side.load());
                inner.compare_node(op, one, other, part.site)
            }
        };
        let of_case = if op == strict(op) {
            lower.logic_and(there, &mut Vec::new(), |inner, _| ordered(inner))?
        } else {
            lower.short_circuit(LogicOp::Or, there.negated(), span, ordered)?
        };
        held = Some(match held {
            None => of_case,
            Some(held) if op == strict(op) => Expr::logic(LogicOp::Or, held, of_case),
            Some(held) => Expr::logic(LogicOp::And, held, of_case),
        });
    }
    Ok(held.unwrap_or_else(|| Expr::bool(op != strict(op), span)))
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

/// Returns true if a comparison of two values of a type loops over their elements.
fn has_loop(lower: &Lowering<'_, '_>, ty: &Type) -> bool {
    match ty {
        _ if lower.cx.known(ty).own_equality.is_some() => false,
        Type::Array { element, len } => *len > FEW || !element.is_word(),
        Type::Matrix { rows, cols, .. } => rows * cols > FEW || (*rows > 1 && *cols > 1),
        _ => false,
    }
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

/// Returns the name `equal`, or another one if the author has a function whose C name would be the same.
fn name_of_equality(lower: &Lowering<'_, '_>, id: StructId) -> String {
    let (cx, ty) = (&lower.cx, Type::Struct(id));
    let paths = cx.types.by_path.iter().filter(|(_, it)| **it == ty);
    let mut homes: Vec<String> = paths.map(|(path, _)| format!("{path}::equal")).collect();
    let own = super::names::snake(cx.name_of(&ty).unwrap_or_default());
    homes.push(format!("::{own}::equal"));
    let taken = |known: &String| homes.iter().any(|home| known.ends_with(home));
    let name = if cx.authored.iter().any(taken) { words::SAME_PARTS } else { words::EQUAL };
    name.to_owned()
}

/// Returns the comparison without equality: `<` for `<=`.
fn strict(op: CompareOp) -> CompareOp {
    match op {
        CompareOp::Le => CompareOp::Lt,
        CompareOp::Ge => CompareOp::Gt,
        op => op,
    }
}

/// Negates a comparison of equality, also of floats.
fn opposite(same: Expr) -> Expr {
    let span = same.span;
    match same.kind {
        ExprKind::Compare(CompareOp::Eq, one, other) => {
            Expr::compare(CompareOp::Ne, *one, *other).at(span)
        }
        _ => same.negated(),
    }
}
