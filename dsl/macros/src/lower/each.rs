//! `for` over the elements of arrays: `iter`, `enumerate`, `zip`, `rev`, `skip`, `take`, `windows`.
//!
//! The adaptors stay as they are in the witness copy; the names look at the types that they are given.

use bessemer_ir::tree::{self, ExprKind, Order};
use bessemer_ir::{Int, Scalar};
use syn::spanned::Spanned;

use super::link::{Link, gives_references, is_range, is_source};
use super::made::plain;
use super::names::{site, text};
use super::refuse;
use super::walk::Lowering;

/// The type of a count.
const SIZE: Option<Scalar> = Some(Scalar::Int(Int::Usize));

/// The sequence of a loop.
enum Source {
    One { array: Box<tree::Expr>, owned: bool, group: Option<tree::Group>, reversed: bool },
    Zip(Box<Source>, Box<Source>),
}

impl Source {
    /// Whether nothing ends it.
    fn is_open(&self) -> bool {
        match self {
            Source::One { array, .. } => matches!(array.kind, ExprKind::From(_)),
            Source::Zip(left, right) => left.is_open() && right.is_open(),
        }
    }
}

/// The sequence of a loop, and how it goes through it.
struct Way {
    source: Source,
    indexed: bool,
    order: tree::Order,
    cuts: Vec<tree::Cut>,
}

impl Lowering<'_> {
    pub(super) fn each_loop(&mut self, it: &mut syn::ExprForLoop) -> Option<ExprKind> {
        let label = it.label.as_ref().map(|label| text(&label.name.ident));
        let before = self.refusals.len();
        let limits = it.expr.span();
        let Way { source, indexed, order, cuts } = self.way(&mut it.expr);
        if source.is_open() {
            self.refusals.add(limits, refuse::OPEN_RANGE);
        }
        let refused = self.refusals.len();
        self.scoped(|walk| {
            let (mut parts, mut looks) = (Vec::new(), Vec::new());
            let (index, elements) = match (indexed, &*it.pat) {
                (false, pattern) => (None, Some(pattern)),
                (true, syn::Pat::Tuple(pair)) if pair.elems.len() == 2 => {
                    (Some(&pair.elems[0]), Some(&pair.elems[1]))
                }
                (true, _) => (None, None),
            };
            let mut own = None;
            let index = match index {
                Some(syn::Pat::Ident(it)) if it.by_ref.is_none() && it.subpat.is_none() => {
                    let name = walk.bind_here(&text(&it.ident));
                    let copy = || copied(name.clone(), &name, tree::NO_SLOT, &it.ident);
                    own = it.mutability.map(|_| copy());
                    Some(name)
                }
                None | Some(syn::Pat::Wild(_)) => None,
                Some(other) => {
                    walk.refusals.add(other, refuse::DESTRUCTURING);
                    None
                }
            };
            match elements {
                Some(pattern) => walk.elements(pattern, source, &mut parts, &mut looks),
                None => walk.refusals.add(&it.pat, refuse::DESTRUCTURING),
            }
            if refused > before {
                // What does not go through anything has no elements to tell about.
                walk.refusals.forget_since(refused);
            }
            let mut body = walk.branch(&mut it.body, false);
            body.stmts.splice(0..0, own);
            it.body.stmts.splice(0..0, looks);
            Some(ExprKind::Each { label, index, parts, order, cuts, body })
        })
    }

    /// The adaptors behind the source: `.enumerate()`, `.rev()`, `.skip(n)`, `.take(n)`.
    fn way(&mut self, expr: &mut syn::Expr) -> Way {
        if !is_source(expr) {
            return self.plain_way(expr);
        }
        match expr {
            syn::Expr::Paren(it) if !is_range(&it.expr) => self.way(&mut it.expr),
            syn::Expr::MethodCall(it) => match Link::of(it) {
                Some(Link::Copied) => self.way(&mut it.receiver),
                Some(Link::Enumerate) => {
                    let mut way = self.way(&mut it.receiver);
                    if way.indexed || !way.cuts.is_empty() {
                        self.refusals.add(&it.method, refuse::ITERATOR);
                    }
                    if way.order == Order::Down {
                        way.order = Order::Mirrored;
                    }
                    Way { indexed: true, ..way }
                }
                Some(Link::Rev) => {
                    let way = self.way(&mut it.receiver);
                    let order = match way.order {
                        Order::Up => Order::Down,
                        Order::Down => Order::Up,
                        Order::Mirrored => {
                            self.refusals.add(&it.method, refuse::ITERATOR);
                            Order::Mirrored
                        }
                    };
                    Way { order, ..way }
                }
                Some(link @ (Link::Skip | Link::Take)) => self.cut(it, link == Link::Skip),
                _ => self.plain_way(expr),
            },
            other => self.plain_way(other),
        }
    }

    fn plain_way(&mut self, expr: &mut syn::Expr) -> Way {
        let source = self.source(expr);
        Way { source, indexed: false, order: Order::Up, cuts: Vec::new() }
    }

    fn cut(&mut self, it: &mut syn::ExprMethodCall, skip: bool) -> Way {
        let mut way = self.way(&mut it.receiver);
        let place = site(&it.method);
        let back = way.order == Order::Down;
        let cut = tree::Cut { skip, back, count: self.value(&mut it.args[0]) };
        match way.source {
            // An index behind it begins anew.
            Source::One { array, owned, group: None, reversed: false }
                if has_elements(&array)
                    && !way.indexed
                    && way.order == Order::Up
                    && way.cuts.is_empty() =>
            {
                let kind = ExprKind::Cut(array, Box::new(cut));
                let array = Box::new(tree::Expr { kind, site: place, slot: None });
                let source = Source::One { array, owned, group: None, reversed: false };
                Way { source, ..way }
            }
            // Begins further on.
            Source::One {
                array,
                owned,
                group: Some(tree::Group { way: around, size }),
                reversed,
            } if around == tree::Grouping::Around
                && cut.skip
                && matches!(&size.kind, ExprKind::Int(digits, _) if digits == "0")
                && !way.indexed
                && way.cuts.is_empty() =>
            {
                let group = Some(tree::Group { way: around, size: cut.count });
                Way { source: Source::One { array, owned, group, reversed }, ..way }
            }
            source => {
                way.cuts.push(cut);
                Way { source, ..way }
            }
        }
    }

    fn source(&mut self, expr: &mut syn::Expr) -> Source {
        if !is_source(expr) {
            return self.whole_source(expr);
        }
        let it = match expr {
            syn::Expr::Paren(it) if !matches!(&*it.expr, syn::Expr::Range(_)) => {
                return self.source(&mut it.expr);
            }
            syn::Expr::MethodCall(it) => it,
            other => return self.whole_source(other),
        };
        match Link::of(it) {
            Some(Link::Zip) => {
                let left = self.source(&mut it.receiver);
                Source::Zip(Box::new(left), Box::new(self.source(&mut it.args[0])))
            }
            Some(Link::Chain) => self.chained(it),
            Some(Link::Group(way)) => {
                let array = Box::new(self.value(&mut it.receiver));
                let group = Some(tree::Group { way, size: self.value(&mut it.args[0]) });
                Source::One { array, owned: false, group, reversed: false }
            }
            Some(Link::Skip | Link::Take) => {
                let Way { source, indexed, order, cuts } = self.way(expr);
                if source.is_open() {
                    self.refusals.add(&expr, refuse::LINKED_RANGE);
                } else if indexed || order != Order::Up || !cuts.is_empty() {
                    self.refusals.add(&expr, refuse::ITERATOR);
                }
                source
            }
            None | Some(Link::Enumerate | Link::Sift) => self.whole_source(expr),
            Some(link) => self.linked(link, it),
        }
    }

    /// A link behind a source: of two that are paired, none but what goes through one alone.
    fn linked(&mut self, link: Link, it: &mut syn::ExprMethodCall) -> Source {
        match (link, self.source(&mut it.receiver)) {
            (
                Link::Iter | Link::IntoIter | Link::Copied,
                Source::One { array, owned, group, reversed },
            ) => {
                let owned = owned && link == Link::IntoIter;
                Source::One { array, owned, group, reversed }
            }
            // Behind `zip`, or before it: one of the two is gone through from its end.
            (Link::Rev, Source::One { array, owned, group: None, reversed }) => {
                Source::One { array, owned, group: None, reversed: !reversed }
            }
            (Link::StepBy, Source::One { array, owned, group: None, reversed })
                if has_elements(&array) =>
            {
                let way = tree::Grouping::First;
                let group = Some(tree::Group { way, size: self.value(&mut it.args[0]) });
                Source::One { array, owned, group, reversed }
            }
            (Link::Cycle, Source::One { array, owned: false, group: None, reversed: false })
                if has_elements(&array) =>
            {
                let size = plain(ExprKind::Int("0".into(), SIZE), &it.method);
                let group = Some(tree::Group { way: tree::Grouping::Around, size });
                Source::One { array, owned: false, group, reversed: false }
            }
            (_, other) => {
                let open = other.is_open();
                let reason = if open { refuse::LINKED_RANGE } else { refuse::ITERATOR };
                self.refusals.add(&it.method, reason);
                other
            }
        }
    }

    /// All that is in an array, or what a call gives.
    fn whole_source(&mut self, expr: &mut syn::Expr) -> Source {
        if let Some(numbers) = self.numbers(expr) {
            let array = Box::new(numbers);
            return Source::One { array, owned: true, group: None, reversed: false };
        }
        let (owned, range) = (!matches!(expr, syn::Expr::Reference(_)), is_range(expr));
        if range {
            self.refusals.add(&expr, refuse::LINKED_RANGE);
        }
        let array = Box::new(self.value(expr));
        Source::One { array, owned, group: None, reversed: false }
    }

    /// The numbers from one on, `1..`, as they stand beside elements.
    fn numbers(&mut self, expr: &mut syn::Expr) -> Option<tree::Expr> {
        match expr {
            syn::Expr::Paren(it) => self.numbers(&mut it.expr),
            syn::Expr::Range(it) if it.end.is_none() => {
                let site = site(it);
                let first = it.start.as_mut()?;
                let kind = ExprKind::From(Box::new(self.value(first)));
                Some(tree::Expr { kind, site, slot: Some(self.see(first)) })
            }
            _ => None,
        }
    }

    /// `a.iter().chain(b)`, of elements that are read.
    fn chained(&mut self, it: &mut syn::ExprMethodCall) -> Source {
        let reads = !is_range(&it.args[0]);
        // What stands beside references is one, whatever it is called.
        let lent = gives_references(&it.receiver);
        match (self.source(&mut it.receiver), self.source(&mut it.args[0])) {
            (
                Source::One { array: one, owned: false, group: None, reversed: false },
                Source::One { array: other, owned, group: None, reversed: false },
            ) if reads && (lent || !owned) => {
                let (kind, site) = (ExprKind::Chain(one, other), site(&it.method));
                let array = Box::new(tree::Expr { kind, site, slot: None });
                Source::One { array, owned: false, group: None, reversed: false }
            }
            (other, _) => {
                self.refusals.add(&it.method, refuse::CHAINED);
                other
            }
        }
    }

    fn elements(
        &mut self,
        pattern: &syn::Pat,
        source: Source,
        parts: &mut Vec<tree::Part>,
        looks: &mut Vec<syn::Stmt>,
    ) {
        match (pattern, source) {
            (syn::Pat::Tuple(pair), Source::Zip(left, right)) if pair.elems.len() == 2 => {
                self.elements(&pair.elems[0], *left, parts, looks);
                self.elements(&pair.elems[1], *right, parts, looks);
            }
            (pattern, Source::One { array, owned, group, reversed }) => {
                let pattern = self.pattern(pattern, looks);
                parts.push(tree::Part { pattern, array: *array, owned, group, reversed });
            }
            (other, _) => self.refusals.add(other, refuse::DESTRUCTURING),
        }
    }
}

/// Whether a part is one array, which has elements at its indices.
fn has_elements(array: &tree::Expr) -> bool {
    !matches!(array.kind, ExprKind::Chain(..) | ExprKind::From(_))
}

/// `let name = known;`, where one may be changed and the other is a place or a counter.
pub(super) fn copied(name: String, known: &str, slot: u32, node: &syn::Ident) -> tree::Stmt {
    let value = plain(ExprKind::Local(known.to_owned()), node);
    tree::Stmt::Let { name, slot, site: value.site, value: Some(value), mutable: true }
}

/// Whether what a pattern names may be changed.
pub(super) fn is_mutable(pattern: &syn::Pat) -> bool {
    match pattern {
        syn::Pat::Ident(it) => it.mutability.is_some(),
        syn::Pat::Reference(it) => is_mutable(&it.pat),
        syn::Pat::Paren(it) => is_mutable(&it.pat),
        syn::Pat::Type(it) => is_mutable(&it.pat),
        _ => false,
    }
}
