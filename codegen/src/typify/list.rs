//! The methods of `List`: its length, and the elements below it.
//!
//! Room and indices are checked before anything is written.

use bessemer_ir::tree::{self, Builtin, ListMethod};
use bessemer_ir::{
    Block, CompareOp, Expr, Fault, Form, Intrinsic, LogicOp, Place, Span, Step, Stmt, StmtKind,
    StructId, Type,
};

use super::comparison::Pair;
use super::expr::Call;
use super::lengths::lesser;
use super::lowering::Lowering;
use super::order::is_free;
use super::words;
use super::{OUR_FAULT, Result, problem, struct_of};

/// A list in its place.
struct List {
    place: Place,
    /// The place of its length.
    length: Place,
    element: Type,
    capacity: u32,
}

impl List {
    /// The place of all elements, those behind the length too.
    fn items(&self) -> Place {
        let ty = Type::Array { element: Box::new(self.element.clone()), len: self.capacity };
        self.place.inside(Step::Field(1), ty)
    }

    /// The place of an element.
    fn at(&self, index: Expr) -> Place {
        self.items().inside(Step::Index(index), self.element.clone())
    }

    /// How the length compares with a number.
    fn length_is(&self, op: CompareOp, number: u32, span: Span) -> Expr {
        Expr::compare(op, self.length.load(), Expr::usize(u64::from(number), span)).at(span)
    }

    /// Whether the length is one that a list may have.
    fn is_sound(&self, span: Span) -> Expr {
        self.length_is(CompareOp::Le, self.capacity, span)
    }

    fn set_length(&self, value: Expr) -> StmtKind {
        StmtKind::Assign { place: self.length.clone(), value }
    }

    /// A length that is greater or less by one.
    fn moved_length(&self, op: Intrinsic, span: Span) -> StmtKind {
        let operands = vec![self.length.load(), Expr::usize(1, span)];
        self.set_length(Expr::intrinsic(op, operands).at(span))
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

    /// The list at a place, if one is there.
    fn list_at(&self, place: Place) -> Option<List> {
        let (_, element, capacity) = self.list_type(&place.ty)?;
        let length = place.inside(Step::Field(0), Type::USIZE);
        Some(List { place, length, element, capacity })
    }

    /// The places of a list's length and of its elements.
    pub(super) fn list_items(&self, place: &Place) -> Option<(Place, Place)> {
        let list = self.list_at(place.clone())?;
        let items = list.items();
        Some((list.length, items))
    }

    fn list(&mut self, expr: &tree::Expr) -> Result<List> {
        let mut place = self.base(expr)?;
        self.keep_indices(&mut place, |index| !index.is_literal());
        match self.list_at(place) {
            Some(list) => Ok(list),
            None => problem(expr.site, "this is not a `List`", OUR_FAULT),
        }
    }

    /// An element of a list, its index checked against the length.
    pub(super) fn list_element(&mut self, place: Place, index: Expr, span: Span) -> Place {
        let Some(list) = self.list_at(place.clone()) else { return place };
        let index = match is_free(&index) {
            true => index,
            false => self.temporary(words::INDEX, index),
        };
        // The first half holds of every list, and keeps a damaged one from being read beyond its end.
        let sound = list.is_sound(span);
        let inside = Expr::compare(CompareOp::Lt, index.clone(), list.length.load()).at(span);
        self.check(Expr::logic(LogicOp::And, sound, inside), Fault::Index, span);
        list.at(index)
    }

    fn check(&mut self, condition: Expr, fault: Fault, span: Span) {
        self.emit(StmtKind::Check { condition, fault }, span);
    }

    /// The value of a method of `List` that has one.
    pub(super) fn list_method(&mut self, method: ListMethod, call: Call<'_>) -> Result<Expr> {
        let Call { arguments, expr } = call;
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
            ListMethod::IsEmpty => Ok(self.list(&arguments[0])?.length_is(CompareOp::Eq, 0, span)),
            ListMethod::Pop => self.pop(&arguments[0], expr),
            ListMethod::Push | ListMethod::Clear | ListMethod::Truncate | ListMethod::Resize => {
                problem(site, "this has no value", "write it as a statement")
            }
        }
    }

    fn pop(&mut self, list: &tree::Expr, expr: &tree::Expr) -> Result<Expr> {
        let (site, span) = (expr.site, self.span(expr.site));
        let ty = self.slot_of(expr)?;
        let option = struct_of(&ty, site, "an `Option`")?;
        let list = self.list(list)?;
        let none = self.choice(option, 0, None, site)?;
        let place = self.temporary_place("popped", none);
        let held = place.load();
        let some = self.choice(option, 1, Some(list.at(list.length.load()).load()), site)?;
        let then = vec![
            Stmt::new(list.moved_length(Intrinsic::WrappingSub, span), span),
            Stmt::new(StmtKind::Assign { place, value: some }, span),
        ];
        let some_left = list.length_is(CompareOp::Gt, 0, span);
        let condition = Expr::logic(LogicOp::And, some_left, list.is_sound(span));
        self.emit_if(condition, Block(then), span);
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
                self.emit(list.set_length(Expr::usize(0, span)), span);
            }
            ListMethod::Truncate => {
                let list = self.list(&arguments[0])?;
                let length = self.length_argument(&arguments[1])?;
                let less =
                    Expr::compare(CompareOp::Lt, length.clone(), list.length.load()).at(span);
                self.emit_if(less, Block::of(list.set_length(length), span), span);
            }
            ListMethod::Resize => self.resize(arguments, span)?,
            ListMethod::Pop => {
                let list = self.list(&arguments[0])?;
                let shorter = list.moved_length(Intrinsic::WrappingSub, span);
                let some_left = list.length_is(CompareOp::Gt, 0, span);
                self.emit_if(some_left, Block::of(shorter, span), span);
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

    fn push(&mut self, list: &tree::Expr, element: &tree::Expr, span: Span) -> Result<()> {
        let list = self.list(list)?;
        let mut value = self.value(element, Some(&list.element))?;
        self.agree(&value.ty, &list.element, element.site)?;
        // Rust computes the element before it looks for room.
        if !is_free(&value) {
            value = self.temporary("element", value);
        }
        self.check(list.length_is(CompareOp::Lt, list.capacity, span), Fault::Capacity, span);
        let place = list.at(list.length.load());
        self.emit(StmtKind::Assign { place, value }, span);
        self.emit(list.moved_length(Intrinsic::WrappingAdd, span), span);
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
        let body = Block::of(StmtKind::Assign { place, value: element }, span);
        self.emit(StmtKind::for_range(variable, before, length.clone(), body), span);
        self.emit(list.set_length(length), span);
        Ok(())
    }

    /// `==` of two lists: as long, and the same elements.
    pub(super) fn equal_lists(&mut self, pair: &Pair) -> Result<Expr> {
        let (site, span) = (pair.site, pair.span);
        let [left, right] = pair.sides.clone().map(|list| self.list_at(list));
        let (Some(left), Some(right)) = (left, right) else {
            return problem(site, "this is not a `List`", OUR_FAULT);
        };
        let (one, other) = (left.length.load(), right.length.load());
        let as_long = Expr::compare(CompareOp::Eq, one.clone(), other).at(span);
        self.and_then(as_long, |inner| {
            let count = lesser(one, Expr::usize(u64::from(left.capacity), span));
            inner.all_equal(count, span, |inner, index| {
                let sides = [left.at(index.clone()), right.at(index)];
                inner.equal(&Pair { sides, site, span })
            })
        })
    }
}
