//! The methods of `List`: its length, and the elements below it.
//!
//! Room and indices are checked before anything is written.

use bessemer_ir::tree::{self, Builtin, ListMethod, Site};
use bessemer_ir::{
    Block, CompareOp, Expr, ExprKind, Fault, Form, Intrinsic, LogicOp, Place, Span, Step, Stmt,
    StmtKind, StructId, Type,
};

use super::lengths::lesser;
use super::lowering::Lowering;
use super::words;
use super::{OUR_FAULT, Result, problem};

/// A list in its place.
struct List {
    place: Place,
    /// The place of its length.
    length: Place,
    element: Type,
    capacity: u32,
}

impl List {
    /// The place of an element.
    fn at(&self, index: Expr) -> Place {
        let ty = Type::Array { element: Box::new(self.element.clone()), len: self.capacity };
        let items = self.place.inside(Step::Field(1), ty);
        items.inside(Step::Index(index), self.element.clone())
    }
}

impl Lowering<'_, '_> {
    /// The parts of a type that is a list: of its elements, and how many there may be.
    pub(super) fn list_type(&self, ty: &Type) -> Option<(StructId, Type, u32)> {
        let Type::Struct(id) = ty else { return None };
        let definition = &self.cx.module.structs[id.index()];
        match (&definition.form, &definition.fields.get(1)?.ty) {
            (Form::Sequence, Type::Array { element, len }) => {
                Some((*id, (**element).clone(), *len))
            }
            _ => None,
        }
    }

    /// The place of a list's length.
    pub(super) fn length_of(&self, place: &Place) -> Place {
        place.inside(Step::Field(0), Type::USIZE)
    }

    /// The places of a list's length and of its elements.
    pub(super) fn list_items(&self, place: &Place) -> Option<(Place, Place)> {
        let (_, element, len) = self.list_type(&place.ty)?;
        let ty = Type::Array { element: Box::new(element), len };
        Some((self.length_of(place), place.inside(Step::Field(1), ty)))
    }

    fn list(&mut self, expr: &tree::Expr) -> Result<List> {
        let mut place = self.base(expr)?;
        self.keep_indices(&mut place, |index| !index.is_literal());
        match self.list_type(&place.ty) {
            Some((_, element, capacity)) => {
                let length = self.length_of(&place);
                Ok(List { place, length, element, capacity })
            }
            None => problem(expr.site, "this is not a `List`", OUR_FAULT),
        }
    }

    /// An element of a list, its index checked against the length.
    pub(super) fn list_element(&mut self, place: Place, index: Expr, span: Span) -> Place {
        let Some((_, element, capacity)) = self.list_type(&place.ty) else { return place };
        let index = match super::order::is_free(&index) {
            true => index,
            false => self.temporary(words::INDEX, index),
        };
        let length = self.length_of(&place);
        // The first half holds of every list, and keeps a damaged one from being read beyond its end.
        let sound = at_most(length.load(), capacity, span);
        let inside = Expr::compare(CompareOp::Lt, index.clone(), length.load()).at(span);
        self.check(Expr::logic(LogicOp::And, sound, inside), Fault::Index, span);
        List { place, length, element, capacity }.at(index)
    }

    fn check(&mut self, condition: Expr, fault: Fault, span: Span) {
        self.emit(StmtKind::Check { condition, fault }, span);
    }

    /// The value of a method of `List` that has one.
    pub(super) fn list_method(
        &mut self,
        method: ListMethod,
        arguments: &[tree::Expr],
        expr: &tree::Expr,
    ) -> Result<Expr> {
        let (site, span) = (expr.site, self.span(expr.site));
        match method {
            ListMethod::New => {
                let ty = self.slot_of(expr)?;
                Ok(self.zero(&ty, span))
            }
            ListMethod::Len => Ok(self.list(&arguments[0])?.length.load()),
            ListMethod::Capacity => {
                let capacity = self.list(&arguments[0])?.capacity;
                Ok(Expr::usize(u64::from(capacity), span))
            }
            ListMethod::IsEmpty => {
                let length = self.list(&arguments[0])?.length.load();
                Ok(Expr::compare(CompareOp::Eq, length, Expr::usize(0, span)).at(span))
            }
            ListMethod::Pop => self.pop(&arguments[0], expr),
            ListMethod::Push | ListMethod::Clear | ListMethod::Truncate | ListMethod::Resize => {
                problem(site, "this has no value", "write it as a statement")
            }
        }
    }

    fn pop(&mut self, list: &tree::Expr, expr: &tree::Expr) -> Result<Expr> {
        let (site, span) = (expr.site, self.span(expr.site));
        let ty = self.slot_of(expr)?;
        let Type::Struct(option) = ty else {
            return problem(site, "this is not an `Option`", OUR_FAULT);
        };
        let list = self.list(list)?;
        let none = self.choice(option, 0, None, site)?;
        let held = self.temporary("popped", none);
        let ExprKind::Load(target) = held.kind.clone() else { return Ok(held) };
        let some = self.choice(option, 1, Some(list.at(list.length.load()).load()), site)?;
        let shorter = minus_one(list.length.load(), span);
        let then = vec![
            Stmt::new(StmtKind::Assign { place: list.length.clone(), value: shorter }, span),
            Stmt::new(StmtKind::Assign { place: target, value: some }, span),
        ];
        let some_left =
            Expr::compare(CompareOp::Gt, list.length.load(), Expr::usize(0, span)).at(span);
        let sound = at_most(list.length.load(), list.capacity, span);
        let condition = Expr::logic(LogicOp::And, some_left, sound);
        let kind = StmtKind::If { condition, then: Block(then), otherwise: Block::default() };
        self.emit(kind, span);
        Ok(held)
    }

    /// A method of `List` for its effect; false if it is none.
    pub(super) fn list_effect(&mut self, expr: &tree::Expr) -> Result<bool> {
        let Some((Builtin::List(method), arguments)) = self.builtin_call(expr) else {
            return Ok(false);
        };
        let (site, span) = (expr.site, self.span(expr.site));
        match method {
            ListMethod::Push => self.push(&arguments[0], &arguments[1], span)?,
            ListMethod::Clear => {
                let list = self.list(&arguments[0])?;
                self.set_length(&list, Expr::usize(0, span), span);
            }
            ListMethod::Truncate => {
                let list = self.list(&arguments[0])?;
                let length = self.length_argument(&arguments[1])?;
                let condition =
                    Expr::compare(CompareOp::Lt, length.clone(), list.length.load()).at(span);
                let assign = StmtKind::Assign { place: list.length, value: length };
                let (then, otherwise) = (Block(vec![Stmt::new(assign, span)]), Block::default());
                self.emit(StmtKind::If { condition, then, otherwise }, span);
            }
            ListMethod::Resize => self.resize(arguments, span)?,
            ListMethod::Pop => {
                let list = self.list(&arguments[0])?;
                let condition =
                    Expr::compare(CompareOp::Gt, list.length.load(), Expr::usize(0, span)).at(span);
                let shorter = minus_one(list.length.load(), span);
                let assign = StmtKind::Assign { place: list.length, value: shorter };
                let (then, otherwise) = (Block(vec![Stmt::new(assign, span)]), Block::default());
                self.emit(StmtKind::If { condition, then, otherwise }, span);
            }
            ListMethod::New | ListMethod::Len | ListMethod::IsEmpty | ListMethod::Capacity => {
                return problem(site, "the value of this is not used", "leave it out");
            }
        }
        Ok(true)
    }

    /// An argument, computed once.
    fn length_argument(&mut self, argument: &tree::Expr) -> Result<Expr> {
        let length = self.value(argument, Some(&Type::USIZE))?;
        Ok(match length.is_literal() {
            true => length,
            false => self.temporary("length", length),
        })
    }

    fn set_length(&mut self, list: &List, value: Expr, span: Span) {
        self.emit(StmtKind::Assign { place: list.length.clone(), value }, span);
    }

    fn push(&mut self, list: &tree::Expr, element: &tree::Expr, span: Span) -> Result<()> {
        let list = self.list(list)?;
        let mut value = self.value(element, Some(&list.element))?;
        self.agree(&value.ty, &list.element, element.site)?;
        // Rust computes the element before it looks for room.
        if !super::order::is_free(&value) {
            value = self.temporary("element", value);
        }
        let capacity = Expr::usize(u64::from(list.capacity), span);
        let room = Expr::compare(CompareOp::Lt, list.length.load(), capacity).at(span);
        self.check(room, Fault::Capacity, span);
        let place = list.at(list.length.load());
        self.emit(StmtKind::Assign { place, value }, span);
        let operands = vec![list.length.load(), Expr::usize(1, span)];
        let longer = Expr::intrinsic(Intrinsic::WrappingAdd, operands).at(span);
        self.set_length(&list, longer, span);
        Ok(())
    }

    fn resize(&mut self, arguments: &[tree::Expr], span: Span) -> Result<()> {
        let list = self.list(&arguments[0])?;
        let length = self.length_argument(&arguments[1])?;
        let element = self.value(&arguments[2], Some(&list.element))?;
        let element = match element.is_literal() {
            true => element,
            false => self.temporary("element", element),
        };
        let capacity = Expr::usize(u64::from(list.capacity), span);
        let room = Expr::compare(CompareOp::Le, length.clone(), capacity).at(span);
        self.check(room, Fault::Capacity, span);
        let before = self.temporary("before", list.length.load());
        let variable = self.counter("i", span);
        let index = Place::local(variable, Type::USIZE, span);
        let place = list.at(index.load());
        let body = Block(vec![Stmt::new(StmtKind::Assign { place, value: element }, span)]);
        let (inclusive, reversed) = (false, false);
        let to = length.clone();
        let kind = StmtKind::For {
            variable,
            from: before,
            to,
            inclusive,
            reversed,
            unroll: None,
            ended: false,
            body,
        };
        self.emit(kind, span);
        self.set_length(&list, length, span);
        Ok(())
    }

    /// `==` of two lists: as long, and the same elements.
    pub(super) fn equal_lists(
        &mut self,
        (left, right): (&Place, &Place),
        site: Site,
        span: Span,
    ) -> Result<Expr> {
        let (one, other) = (self.length_of(left), self.length_of(right));
        let length = Expr::compare(CompareOp::Eq, one.load(), other.load()).at(span);
        let Some((_, element, capacity)) = self.list_type(&left.ty) else { return Ok(length) };
        let list = |place: &Place, length: &Place| List {
            place: place.clone(),
            length: length.clone(),
            element: element.clone(),
            capacity,
        };
        let (left, right) = (list(left, &one), list(right, &other));
        self.and_then(length, |inner| {
            inner.all_equal(
                lesser(one.load(), Expr::usize(u64::from(capacity), span)),
                span,
                |inner, index| inner.equal(&left.at(index.clone()), &right.at(index), site, span),
            )
        })
    }
}

/// `length <= capacity`.
fn at_most(length: Expr, capacity: u32, span: Span) -> Expr {
    Expr::compare(CompareOp::Le, length, Expr::usize(u64::from(capacity), span)).at(span)
}

fn minus_one(length: Expr, span: Span) -> Expr {
    Expr::intrinsic(Intrinsic::WrappingSub, vec![length, Expr::usize(1, span)]).at(span)
}
