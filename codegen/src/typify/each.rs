//! `for` over the elements of arrays and matrices: a `for` over their indices.
//!
//! A name for a reference is another name for the element; a name for a value is a local of its own.

use bessemer_ir::tree::{self, Site};
use bessemer_ir::visit::{self, Visit};
use bessemer_ir::{
    Argument, Block, Expr, ExprKind, Local, LocalId, Mode, Place, Span, Step, Stmt, StmtKind, Type,
};

use super::function::Lowering;
use super::pattern::{Subject, load};
use super::{Result, problem};

impl Lowering<'_, '_> {
    pub(super) fn each_stmt(
        &mut self,
        site: Site,
        (label, index): (Option<&str>, Option<&str>),
        parts: &[tree::Part],
        reversed: bool,
        body: &tree::Block,
    ) -> Result<()> {
        let span = self.span(site);
        let (mut places, mut lists) = (Vec::new(), Vec::new());
        for part in parts {
            let place = self.base(&part.array)?;
            let place = self.held_still(place);
            // Of a list, as many elements as there are.
            places.push(match self.list_items(&place) {
                Some((length, items)) => {
                    lists.push(length);
                    items
                }
                None => place,
            });
        }
        let lengths: Option<Vec<u32>> = places.iter().map(|place| length(&place.ty)).collect();
        let Some(shortest) = lengths.and_then(|lengths| lengths.into_iter().min()) else {
            return problem(
                site,
                "a loop goes through arrays and vectors in the DSL",
                "write `for i in 0..n`, and index",
            );
        };
        let count = |word: u64| Expr { kind: ExprKind::Literal(word), ty: Type::USIZE, span };
        let end = lists
            .iter()
            .fold(count(u64::from(shortest)), |end, length| super::list::lesser(load(length), end));
        let mut copies = Vec::new();
        let mut lowered = |inner: &mut Self| {
            let variable = LocalId(inner.locals.len() as u32);
            let name = index.unwrap_or_else(|| inner.next_index()).to_owned();
            inner.counters.push(variable);
            inner.locals.push(Local { name, ty: Type::USIZE, mode: Mode::Value, span });
            let mut block = inner.scoped(|inner| {
                if let Some(index) = index {
                    inner.bind(index, super::function::Binding::Local(variable));
                }
                inner.name_elements(parts, &places, variable, site)?;
                inner.statements(body)
            })?;
            copies = inner.copy_written(parts, &places, &mut block, span);
            inner.counters.pop();
            let (from, to) = (count(0), end.clone());
            Ok(StmtKind::For { variable, from, to, inclusive: false, reversed, body: block })
        };
        let mark = self.out.len();
        self.repeated(label, None, span, &mut lowered)?;
        self.out.splice(mark..mark, copies);
        Ok(())
    }

    /// Two loops, through the columns of a matrix and in each through its rows.
    pub(super) fn grid_stmt(
        &mut self,
        site: Site,
        (row, column): (&str, &str),
        of: &tree::Expr,
        parts: &[tree::Part],
        body: &tree::Block,
    ) -> Result<()> {
        let span = self.span(site);
        let Type::Matrix { rows, cols, .. } = self.base(of)?.ty else {
            return problem(site, "this fills a matrix", "use `core::array::from_fn`");
        };
        let mut places = Vec::new();
        for part in parts {
            let place = self.base(&part.array)?;
            places.push(self.held_still(place));
        }
        let count = |word: u32| {
            let kind = ExprKind::Literal(u64::from(word));
            Expr { kind, ty: Type::USIZE, span }
        };
        let counter = |name: &str, inner: &mut Self| {
            let variable = LocalId(inner.locals.len() as u32);
            let local = Local { name: name.into(), ty: Type::USIZE, mode: Mode::Value, span };
            inner.locals.push(local);
            inner.counters.push(variable);
            variable
        };
        let (outer, inner) = (counter(column, self), counter(row, self));
        let block = self.scoped(|walk| {
            walk.bind(column, super::function::Binding::Local(outer));
            walk.bind(row, super::function::Binding::Local(inner));
            for (part, place) in parts.iter().zip(&places) {
                let mut element = place.clone();
                let at = |id| load(&Place { root: id, steps: vec![], ty: Type::USIZE, span });
                element.steps.push(Step::Element(at(inner), at(outer)));
                if let Type::Matrix { element: scalar, .. } = place.ty {
                    element.ty = Type::Scalar(scalar);
                }
                let mut names = Vec::new();
                walk.test(&part.pattern, &Subject::Place(element), site, &mut names)?;
                walk.bind_names(&names)?;
            }
            walk.statements(body)
        })?;
        self.counters.truncate(self.counters.len() - 2);
        let through = |variable, to, body| StmtKind::For {
            variable,
            from: count(0),
            to: count(to),
            inclusive: false,
            reversed: false,
            body,
        };
        let rows = Stmt { kind: through(inner, rows, block), span, comments: Vec::new() };
        self.emit(through(outer, cols, Block(vec![rows])), span);
        Ok(())
    }

    /// Computes the indices on the way to an array once.
    fn held_still(&mut self, mut place: Place) -> Place {
        for step in &mut place.steps {
            if let Step::Index(index) = step
                && !super::function::is_literal(index)
                && !self.is_counter(index)
            {
                *index = self.temporary("index", index.clone());
            }
        }
        place
    }

    /// Whether a value is that of a counter, which only its loop changes.
    fn is_counter(&self, index: &Expr) -> bool {
        matches!(&index.kind, ExprKind::Load(place)
            if place.steps.is_empty() && self.counters.contains(&place.root))
    }

    /// What to call the counter of a loop whose author has no name for it.
    fn next_index(&self) -> &'static str {
        let names = ["i", "j", "k"];
        let taken =
            self.counters.iter().filter(|id| names.contains(&&*self.locals[id.index()].name));
        names[taken.count() % names.len()]
    }

    fn name_elements(
        &mut self,
        parts: &[tree::Part],
        places: &[Place],
        variable: LocalId,
        site: Site,
    ) -> Result<()> {
        for (part, place) in parts.iter().zip(places) {
            let element = Subject::Place(self.element_at(place, variable, &part.array));
            let mut names = Vec::new();
            self.test(&part.pattern, &element, site, &mut names)?;
            self.bind_names(&names)?;
        }
        Ok(())
    }

    fn element_at(&mut self, array: &Place, variable: LocalId, expr: &tree::Expr) -> Place {
        let span = array.span;
        let place = Place { root: variable, steps: Vec::new(), ty: Type::USIZE, span };
        let index = Expr { kind: ExprKind::Load(place), ty: Type::USIZE, span };
        let mut element = array.clone();
        (element.steps, element.ty) = match &array.ty {
            Type::Array { element, .. } => {
                let mut steps = array.steps.clone();
                steps.push(Step::Index(index));
                (steps, (**element).clone())
            }
            Type::Matrix { element, rows, cols } => {
                let mut steps = array.steps.clone();
                steps.push(match (rows, cols) {
                    (_, 1) => Step::Element(index, self.index_literal(0, expr)),
                    (1, _) => Step::Element(self.index_literal(0, expr), index),
                    _ => Step::Index(index),
                });
                (steps, Type::Scalar(*element))
            }
            other => (array.steps.clone(), other.clone()),
        };
        element
    }

    /// A loop over a value does not see what its body writes: then it goes through a copy. Gives the
    /// declarations of the copies.
    fn copy_written(
        &mut self,
        parts: &[tree::Part],
        places: &[Place],
        body: &mut Block,
        span: Span,
    ) -> Vec<Stmt> {
        let mut copies = Vec::new();
        for (part, place) in parts.iter().zip(places) {
            if !part.owned || !Written::of(body, place.root) {
                continue;
            }
            let copy = LocalId(self.locals.len() as u32);
            let ty = place.ty.clone();
            self.locals.push(Local {
                name: "elements".into(),
                ty: ty.clone(),
                mode: Mode::Value,
                span,
            });
            for stmt in &mut body.0 {
                // The declarations of the names come first, each with its part of the element.
                if let StmtKind::Let { value: Some(value), .. } = &mut stmt.kind
                    && let ExprKind::Load(element) = &mut value.kind
                    && element.root == place.root
                    && element.steps.len() > place.steps.len()
                    && element.steps.starts_with(&place.steps)
                    && element.span == place.span
                {
                    element.root = copy;
                    element.steps.drain(..place.steps.len());
                }
            }
            let value = Some(Expr { kind: ExprKind::Load(place.clone()), ty, span });
            let kind = StmtKind::Let { local: copy, value };
            copies.push(Stmt { kind, span, comments: Vec::new() });
        }
        copies
    }
}

fn length(ty: &Type) -> Option<u32> {
    match ty {
        Type::Array { len, .. } => Some(*len),
        Type::Matrix { rows, cols, .. } => Some(rows * cols),
        _ => None,
    }
}

/// Whether a block writes to a local.
struct Written(LocalId, bool);

impl Written {
    fn of(block: &Block, local: LocalId) -> bool {
        let mut written = Written(local, false);
        block.0.iter().for_each(|stmt| written.stmt(stmt));
        written.1
    }
}

impl Visit for Written {
    fn stmt(&mut self, stmt: &Stmt) {
        if let StmtKind::Assign { place, .. } = &stmt.kind {
            self.1 |= place.root == self.0;
        }
        visit::walk_stmt(self, stmt);
    }

    fn expr(&mut self, expr: &Expr) {
        if let ExprKind::Call(_, arguments) = &expr.kind {
            let lent =
                |it: &Argument| matches!(it, Argument::RefMut(place) if place.root == self.0);
            self.1 |= arguments.iter().any(lent);
        }
        visit::walk_expr(self, expr);
    }
}
