//! Containers with a run-time size and a fixed capacity: `List` and `BoundedMatrix`.
//!
//! An element of a matrix is read by row and column, each checked against its size. A `for` over a matrix is two
//! nested loops, column by column, which the author wrote as one.
//!
//! Invariant: capacity and indices are checked before anything is written.

use bessemer_ir::tree::{self, Builtin, ListMethod, Site};
use bessemer_ir::{
    Block, CompareOp, Expr, Fault, Form, Intrinsic, LogicOp, Place, Span, Step, Stmt, StmtKind,
    Type,
};

use super::each::Each;
use super::expr::Call;
use super::lengths::{least, lesser};
use super::lowering::Lowering;
use super::syntax::is_named;
use super::value::Value;
use super::words;
use super::{Needed, Result, refusals, refused, struct_of};

/// A container at a place.
struct Bounded {
    /// Place of all elements, including those beyond its size.
    items: Place,
    element: Type,
    /// Place of the length (in a matrix, of the number of rows), and the greatest valid value.
    length: Place,
    capacity: u32,
    /// Place of the number of columns of a matrix, and the greatest valid value.
    columns: Option<(Place, u32)>,
}

impl Bounded {
    /// Returns the place of the element at an index, or at a column and a row of a matrix.
    fn at(&self, indices: impl IntoIterator<Item = Expr>) -> Place {
        indices.into_iter().fold(self.items.clone(), |place, index| match &place.ty {
            Type::Array { element, .. } => place.inside(Step::Index(index), (**element).clone()),
            _ => place,
        })
    }

    /// Compares the length with a number.
    fn length_is(&self, op: CompareOp, number: u32, span: Span) -> Expr {
        Expr::compare(op, self.length.load(), Expr::usize(u64::from(number), span)).at(span)
    }

    /// Returns the condition that the length is at most the capacity.
    fn is_sound(&self, span: Span) -> Expr {
        self.length_is(CompareOp::Le, self.capacity, span)
    }

    fn set_length(&self, value: Expr) -> StmtKind {
        StmtKind::Assign { place: self.length.clone(), value }
    }

    /// Returns a statement that increases or decreases the length by one.
    fn moved_length(&self, op: Intrinsic, span: Span) -> StmtKind {
        let operands = vec![self.length.load(), Expr::usize(1, span)];
        self.set_length(Expr::intrinsic(op, operands).at(span))
    }
}

impl Lowering<'_, '_> {
    /// Returns the element type and the capacity of a container; of a matrix, the capacity of a column and the
    /// greatest number of columns.
    pub(super) fn contained(&self, ty: &Type) -> Option<(Type, u32, Option<u32>)> {
        let Type::Struct(id) = ty else { return None };
        let definition = &self.cx.module.structs[id.index()];
        let array = |at: usize| match &definition.fields.get(at)?.ty {
            Type::Array { element, len } => Some((&**element, *len)),
            _ => None,
        };
        if self.cx.known(ty).bounded {
            let (Type::Array { element, len }, columns) = array(2)? else { return None };
            return Some(((**element).clone(), *len, Some(columns)));
        }
        let (element, len) = array(1).filter(|_| definition.form == Form::Sequence)?;
        Some((element.clone(), len, None))
    }

    /// Returns the container at a place, if its type is one.
    fn bounded(&self, place: &Place) -> Option<Bounded> {
        let (element, capacity, columns) = self.contained(&place.ty)?;
        let array = |element: &Type, len| Type::Array { element: Box::new(element.clone()), len };
        let size = |field| place.inside(Step::Field(field), Type::USIZE);
        let column = array(&element, capacity);
        let items = match columns {
            Some(columns) => place.inside(Step::Field(2), array(&column, columns)),
            None => place.inside(Step::Field(1), column),
        };
        let columns = columns.map(|most| (size(1), most));
        Some(Bounded { items, element, length: size(0), capacity, columns })
    }

    fn list_at(&self, place: &Place) -> Option<Bounded> {
        self.bounded(place).filter(|it| it.columns.is_none())
    }

    /// Returns the places of a list's length and of its elements.
    pub(super) fn list_items(&self, place: &Place) -> Option<(Place, Place)> {
        self.list_at(place).map(|list| (list.length, list.items))
    }

    fn list(&mut self, expr: &tree::Expr) -> Result<Bounded> {
        let place = self.base(expr)?;
        self.list_at(&place).needed(expr.site, "this is not a `List`")
    }

    /// Lowers `list[index]` and `matrix[(row, column)]`. Each index is checked against the size, and the size against
    /// the capacity, so that a corrupt size cannot cause a read beyond the array.
    pub(super) fn bounded_element(
        &mut self,
        place: Place,
        index: &tree::Expr,
        span: Span,
    ) -> Result<Place> {
        let is_matrix = self.contained(&place.ty).is_some_and(|(.., columns)| columns.is_some());
        let indices = match is_matrix {
            true => self.bounded_indices(index)?.to_vec(),
            false => {
                let index = self.value(index, Some(&Type::USIZE))?;
                Vec::from([self.atom(words::INDEX, index)])
            }
        };
        let Some(bounded) = self.bounded(&place) else { return Ok(place) };
        let sizes = || {
            [(&bounded.length, bounded.capacity)]
                .into_iter()
                .chain(bounded.columns.iter().map(|(size, most)| (size, *most)))
        };
        let sound = sizes().map(|(size, most)| {
            Expr::compare(CompareOp::Le, size.load(), Expr::usize(u64::from(most), span))
        });
        let inside = sizes()
            .zip(&indices)
            .map(|((size, _), index)| Expr::compare(CompareOp::Lt, index.clone(), size.load()));
        let conditions = sound.chain(inside).map(|it| it.at(span));
        if let Some(all) = conditions.reduce(|a, b| Expr::logic(LogicOp::And, a, b)) {
            self.check(all, Fault::Index, span);
        }
        let place = bounded.at(indices.into_iter().rev());
        Ok(if is_matrix { Place { span, ..place } } else { self.indexed(place) })
    }

    fn bounded_indices(&mut self, index: &tree::Expr) -> Result<[Expr; 2]> {
        let tree::ExprKind::Tuple(parts) = &index.kind else {
            return refused(index.site, refusals::ROW_AND_COLUMN);
        };
        let [row, column] = parts.as_slice() else {
            return refused(index.site, refusals::TWO_INDICES);
        };
        let [row, column] = self.row_and_column([row, column])?;
        Ok([self.atom("row", row), self.atom("column", column)])
    }

    /// Returns the place of a named `BoundedMatrix` that a loop iterates over.
    pub(super) fn bounded_place(&mut self, expr: &tree::Expr) -> Option<Place> {
        // Whatever else is wrong with it is told where it is lowered.
        let place = is_named(expr, true).then(|| self.base(expr).ok())??;
        self.contained(&place.ty)?.2.map(|_| place)
    }

    /// Lowers a `for` over all elements of a matrix.
    pub(super) fn each_of_bounded(
        &mut self,
        matrix: Place,
        Each { site, label, pattern, body, .. }: Each,
    ) -> Result<()> {
        let span = self.span(site);
        let Some(matrix) = self.bounded(&matrix) else { return Ok(()) };
        let Some((columns, most)) = &matrix.columns else { return Ok(()) };
        let mut end = |name, size: &Place, most: u32| {
            self.atom(name, least(size.load(), Expr::usize(u64::from(most), span)))
        };
        let rows = end("rows", &matrix.length, matrix.capacity);
        let columns = end("columns", columns, *most);
        let outermost = self.frames.len();
        self.below("column", columns, span, |walk, column| {
            walk.below("row", rows, span, |walk, row| {
                let place = Place { span, ..matrix.at([column, row]) };
                walk.bind_pattern(pattern, &Value::Place(place), site)?;
                walk.pass_of(label, outermost, |walk| walk.statements(body))
            })
        })
    }

    /// Lowers a method of `List` that returns a value.
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
            ListMethod::Pop => self.pop_element(&arguments[0], expr),
            ListMethod::Push | ListMethod::Clear | ListMethod::Truncate | ListMethod::Resize => {
                refused(site, refusals::STATEMENT)
            }
        }
    }

    fn pop_element(&mut self, list: &tree::Expr, expr: &tree::Expr) -> Result<Expr> {
        let (site, span) = (expr.site, self.span(expr.site));
        let ty = self.slot_of(expr)?;
        let option = struct_of(&ty, site, "an `Option`")?;
        let list = self.list(list)?;
        let none = self.choice(option, 0, None, site)?;
        let place = self.assigned("popped", none);
        let held = place.load();
        let some = self.choice(option, 1, Some(list.at([list.length.load()]).load()), site)?;
        let then = vec![
            Stmt::new(list.moved_length(Intrinsic::WrappingSub, span), span),
            Stmt::new(StmtKind::Assign { place, value: some }, span),
        ];
        let some_left = list.length_is(CompareOp::Gt, 0, span);
        let condition = Expr::logic(LogicOp::And, some_left, list.is_sound(span));
        self.emit_if(condition, Block(then), span);
        Ok(held)
    }

    /// Lowers a method of `List` that is called for its effect; returns false for another expression.
    pub(super) fn list_effect(&mut self, expr: &tree::Expr) -> Result<bool> {
        let Some((Builtin::List(method), arguments)) = self.builtin_call(expr) else {
            return Ok(false);
        };
        let (site, span) = (expr.site, self.span(expr.site));
        match method {
            ListMethod::Push => self.push_element(&arguments[0], &arguments[1], span)?,
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
            ListMethod::Resize => self.resize_list(arguments, span)?,
            ListMethod::Pop => {
                let list = self.list(&arguments[0])?;
                let shorter = list.moved_length(Intrinsic::WrappingSub, span);
                let some_left = list.length_is(CompareOp::Gt, 0, span);
                self.emit_if(some_left, Block::of(shorter, span), span);
            }
            ListMethod::New | ListMethod::Len | ListMethod::IsEmpty | ListMethod::Capacity => {
                return refused(site, refusals::UNUSED_VALUE);
            }
        }
        Ok(true)
    }

    /// Evaluates an argument once.
    fn length_argument(&mut self, argument: &tree::Expr) -> Result<Expr> {
        let length = self.value(argument, Some(&Type::USIZE))?;
        Ok(self.atom("length", length))
    }

    fn push_element(&mut self, list: &tree::Expr, element: &tree::Expr, span: Span) -> Result<()> {
        let list = self.list(list)?;
        let value = self.value(element, Some(&list.element))?;
        self.agree(&value.ty, &list.element, element.site)?;
        // Rust computes the element before it looks for room.
        let value = self.atom("element", value);
        self.check(list.length_is(CompareOp::Lt, list.capacity, span), Fault::Capacity, span);
        let place = list.at([list.length.load()]);
        self.emit(StmtKind::Assign { place, value }, span);
        self.emit(list.moved_length(Intrinsic::WrappingAdd, span), span);
        Ok(())
    }

    fn resize_list(&mut self, arguments: &[tree::Expr], span: Span) -> Result<()> {
        let list = self.list(&arguments[0])?;
        let length = self.length_argument(&arguments[1])?;
        let value = self.value(&arguments[2], Some(&list.element))?;
        let value = self.atom("element", value);
        let capacity = Expr::usize(u64::from(list.capacity), span);
        let room = Expr::compare(CompareOp::Le, length.clone(), capacity).at(span);
        self.check(room, Fault::Capacity, span);
        let before = self.atom("before", list.length.load());
        let variable = self.local("i", Type::USIZE, span);
        let place = list.at([Expr::local(variable, &Type::USIZE, span)]);
        let body = Block::of(StmtKind::Assign { place, value }, span);
        self.emit(StmtKind::for_range(variable, before, length.clone(), body), span);
        self.emit(list.set_length(length), span);
        Ok(())
    }
}

/// Returns the condition that two lists have the same length, the number of elements to compare, and both elements at an
/// index.
pub(super) fn compared(
    lower: &Lowering<'_, '_>,
    [left, right]: &[Place; 2],
    site: Site,
) -> Result<(Expr, Expr, impl Fn(Expr) -> [Place; 2] + use<>)> {
    let list = |side: &Place| lower.list_at(side).needed(site, "this is not a `List`");
    let (left, right) = (list(left)?, list(right)?);
    let (one, other) = (left.length.load(), right.length.load());
    let span = one.span;
    let same = Expr::compare(CompareOp::Eq, one.clone(), other).at(span);
    let count = lesser(one, Expr::usize(u64::from(left.capacity), span));
    Ok((same, count, move |index: Expr| [left.at([index.clone()]), right.at([index])]))
}
