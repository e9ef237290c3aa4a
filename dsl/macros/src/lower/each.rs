//! `for` over the elements of arrays: `iter`, `enumerate`, `zip`, `rev`, `skip`, `take`, `windows`.
//!
//! The adaptors stay as they are in the witness copy; the names look at the types that they are given.

use bessemer_tree as tree;
use bessemer_tree::number::{Int, Scalar};
use bessemer_tree::{ExprKind, Grouping, Order};
use syn::spanned::Spanned;

use super::link::{Link, gives_references, is_range, is_source};
use super::names::{plain, site, text};
use super::refuse;
use super::walk::Lowering;

/// The type of a count.
const SIZE: Option<Scalar> = Some(Scalar::Int(Int::Usize));

/// The sequence of a loop. What a part's elements are called says the loop's pattern.
enum Source {
    One(Box<tree::Part>),
    Zip(Box<Source>, Box<Source>),
}

impl Source {
    /// The elements of an array, from the first on.
    fn one(array: tree::Expr, owned: bool) -> Source {
        let pattern = tree::Pattern::Any;
        Source::One(Box::new(tree::Part { pattern, array, owned, group: None, reversed: false }))
    }

    /// Whether nothing ends it.
    fn is_open(&self) -> bool {
        match self {
            Source::One(part) => matches!(part.array.kind, ExprKind::From(_)),
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

impl Lowering {
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
                    way.indexed = true;
                    if way.order == Order::Down {
                        way.order = Order::Mirrored;
                    }
                    way
                }
                Some(Link::Rev) => {
                    let mut way = self.way(&mut it.receiver);
                    match way.order {
                        Order::Up => way.order = Order::Down,
                        Order::Down => way.order = Order::Up,
                        Order::Mirrored => self.refusals.add(&it.method, refuse::ITERATOR),
                    }
                    way
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
        let back = way.order == Order::Down;
        let cut = tree::Cut { skip, back, count: self.value(&mut it.args[0]) };
        let first = !way.indexed && way.cuts.is_empty();
        way.source = match way.source {
            // An index behind it begins anew.
            Source::One(part) if first && way.order == Order::Up && is_straight(&part) => {
                let kind = ExprKind::Cut(Box::new(part.array), Box::new(cut));
                Source::one(plain(kind, &it.method), part.owned)
            }
            // Begins further on.
            Source::One(mut part)
                if first && cut.skip && part.group.as_ref().is_some_and(is_cycle) =>
            {
                part.group = Some(tree::Group { way: Grouping::Around, size: cut.count });
                Source::One(part)
            }
            source => {
                way.cuts.push(cut);
                source
            }
        };
        way
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
                let mut source = Source::one(self.value(&mut it.receiver), false);
                let size = self.value(&mut it.args[0]);
                if let Source::One(part) = &mut source {
                    part.group = Some(tree::Group { way, size });
                }
                source
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
        let mut source = self.source(&mut it.receiver);
        match (link, &mut source) {
            (Link::Iter | Link::IntoIter | Link::Copied, Source::One(part)) => {
                part.owned &= link == Link::IntoIter;
            }
            // Behind `zip`, or before it: one of the two is gone through from its end.
            (Link::Rev, Source::One(part)) if part.group.as_ref().is_none_or(is_row) => {
                part.reversed = !part.reversed;
            }
            (Link::StepBy, Source::One(part)) if part.group.is_none() && has_elements(part) => {
                let size = self.value(&mut it.args[0]);
                part.group = Some(tree::Group { way: Grouping::First, size });
            }
            (Link::Cycle, Source::One(part)) if !part.owned && is_straight(part) => {
                let size = plain(ExprKind::Int("0".into(), SIZE), &it.method);
                part.group = Some(tree::Group { way: Grouping::Around, size });
            }
            (_, other) => {
                let open = other.is_open();
                let reason = if open { refuse::LINKED_RANGE } else { refuse::ITERATOR };
                self.refusals.add(&it.method, reason);
            }
        }
        source
    }

    /// All that is in an array, or what a call gives.
    fn whole_source(&mut self, expr: &mut syn::Expr) -> Source {
        if let Some(numbers) = self.numbers(expr) {
            return Source::one(numbers, true);
        }
        let owned = !matches!(expr, syn::Expr::Reference(_));
        if is_range(expr) {
            self.refusals.add(&expr, refuse::LINKED_RANGE);
        }
        Source::one(self.value(expr), owned)
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
            (Source::One(one), Source::One(other))
                if reads
                    && !one.owned
                    && (lent || !other.owned)
                    && is_all(&one)
                    && is_all(&other) =>
            {
                let kind = ExprKind::Chain(Box::new(one.array), Box::new(other.array));
                Source::one(plain(kind, &it.method), false)
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
            (pattern, Source::One(mut part)) => {
                part.pattern = self.pattern(pattern, looks);
                parts.push(*part);
            }
            (other, _) => self.refusals.add(other, refuse::DESTRUCTURING),
        }
    }
}

/// Whether a part is one array, which has elements at its indices.
fn has_elements(part: &tree::Part) -> bool {
    !matches!(part.array.kind, ExprKind::Chain(..) | ExprKind::From(_))
}

/// Whether a part is gone through element by element, from the first on.
fn is_all(part: &tree::Part) -> bool {
    part.group.is_none() && !part.reversed
}

/// Whether that part has elements at its indices.
fn is_straight(part: &tree::Part) -> bool {
    is_all(part) && has_elements(part)
}

/// Whether an item is elements in a row, and so is an iterator from its end on.
fn is_row(group: &tree::Group) -> bool {
    matches!(group.way, Grouping::Windows | Grouping::Whole | Grouping::All)
}

/// Whether elements come again and again, from the first on.
fn is_cycle(group: &tree::Group) -> bool {
    group.way == Grouping::Around
        && matches!(&group.size.kind, ExprKind::Int(digits, _) if digits == "0")
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
