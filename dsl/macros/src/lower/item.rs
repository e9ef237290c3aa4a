//! Names for what flows through a chain of iterators, and patterns that take it apart.
//!
//! A value without a name of the author's gets one that no author can write, so that the next closure can use it.

use bessemer_ir::tree::{self, ExprKind};
use quote::{format_ident, quote};

use super::closure::closure_parameter;
use super::flow::{Flow, Item, Over, Source, Step, Takes, named_by, there};
use super::made::plain;
use super::names::{slot_name, text};
use super::walk::Lowering;

/// The name of an item for which its author has none.
pub(super) const ITEM: &str = "item";

impl Lowering<'_> {
    /// Gives what flows out of a chain the names of a pattern.
    pub(super) fn name_item(
        &mut self,
        flow: &mut Flow,
        (pattern, takes): (&mut syn::Pat, Takes),
        looks: &mut Vec<syn::Stmt>,
    ) -> Option<()> {
        let item = std::mem::replace(&mut flow.item, Item::Taken);
        flow.item = match item {
            Item::Source(source) => self.name_elements(flow, source, (&*pattern, takes), looks)?,
            Item::Number => self.name_number(flow, (pattern, takes), looks)?,
            Item::Named(_) | Item::Pair(..) => self.name_again(flow, item, pattern, looks)?,
            Item::Value(value) => match (simple(pattern), takes) {
                (None, Takes::Items) if is_wild(pattern) => {
                    let (site, otherwise) = (value.site, None);
                    let pattern = Box::new(tree::Pattern::Any);
                    flow.steps.push(Step::Do(tree::Stmt::Apart {
                        pattern,
                        value,
                        otherwise,
                        site,
                    }));
                    Item::Taken
                }
                (name, _) => {
                    let (slot, site) = (value.slot?, value.site);
                    let in_tree = match &name {
                        Some(name) => self.bind_apart(&text(name)),
                        None => self.hidden(ITEM),
                    };
                    let (value, known) = (Some(value), in_tree.clone());
                    flow.steps.push(Step::Do(tree::Stmt::Let { name: in_tree, slot, value, site }));
                    match name {
                        Some(_) => Item::Named(known),
                        None => self.name_again(flow, Item::Named(known), pattern, looks)?,
                    }
                }
            },
            item @ (Item::Optional(_) | Item::Leading(_)) => {
                let leading = matches!(item, Item::Leading(_));
                let (Item::Optional(value) | Item::Leading(value)) = item else { return None };
                let inner = self.pattern_apart(pattern, looks);
                let named = match &inner {
                    tree::Pattern::Name { name, inner: None, .. } => Item::Named(name.clone()),
                    _ => Item::Taken,
                };
                let there = there(inner, value);
                flow.steps.push(if leading { Step::WhileLet(there) } else { Step::If(there) });
                named
            }
            Item::Taken => return None,
        };
        Some(())
    }

    /// A pattern whose names are kept apart from those around it.
    pub(super) fn pattern_apart(
        &mut self,
        pattern: &syn::Pat,
        looks: &mut Vec<syn::Stmt>,
    ) -> tree::Pattern {
        let outer = self.apart.replace("");
        let pattern = self.pattern(pattern, looks);
        self.apart = outer;
        pattern
    }

    /// The elements that a loop goes through, perhaps each with its index.
    fn name_elements(
        &mut self,
        flow: &mut Flow,
        source: Source,
        (pattern, takes): (&syn::Pat, Takes),
        looks: &mut Vec<syn::Stmt>,
    ) -> Option<Item> {
        let Over::Each { indexed, .. } = flow.over else { return None };
        if !indexed {
            return self.name_source(flow, source, (pattern, takes), looks);
        }
        let (first, elements) = match behind(pattern) {
            syn::Pat::Tuple(pair) if pair.elems.len() == 2 => (&pair.elems[0], &pair.elems[1]),
            whole @ syn::Pat::Wild(_) => (whole, whole),
            _ => return None,
        };
        let name = match behind(first) {
            syn::Pat::Wild(_) if takes == Takes::Items => None,
            syn::Pat::Wild(_) => Some(self.hidden("i")),
            other => {
                let own = simple(other)?;
                let counter = self.bind_apart(&text(&own));
                if is_mutable(other) {
                    let copy = copied(counter.clone(), &counter, tree::NO_SLOT, &own);
                    flow.steps.push(Step::Do(copy));
                }
                Some(counter)
            }
        };
        if let Over::Each { index, .. } = &mut flow.over {
            index.clone_from(&name);
        }
        let element = self.name_source(flow, source, (elements, takes), looks)?;
        Some(match name {
            Some(name) => Item::Pair(Box::new(Item::Named(name)), Box::new(element)),
            None => Item::Taken,
        })
    }

    /// The same without an index. What is lent to a closure is named again behind it.
    fn name_source(
        &mut self,
        flow: &mut Flow,
        source: Source,
        (pattern, takes): (&syn::Pat, Takes),
        looks: &mut Vec<syn::Stmt>,
    ) -> Option<Item> {
        match (behind(pattern), source) {
            (syn::Pat::Tuple(pair), Source::Zip(left, right)) if pair.elems.len() == 2 => {
                let left = self.name_source(flow, *left, (&pair.elems[0], takes), looks)?;
                let right = self.name_source(flow, *right, (&pair.elems[1], takes), looks)?;
                Some(Item::Pair(Box::new(left), Box::new(right)))
            }
            (whole @ syn::Pat::Wild(_), Source::Zip(left, right)) => {
                let left = self.name_source(flow, *left, (whole, takes), looks)?;
                let right = self.name_source(flow, *right, (whole, takes), looks)?;
                Some(Item::Pair(Box::new(left), Box::new(right)))
            }
            (_, Source::Zip(..)) => None,
            (syn::Pat::Tuple(pair), Source::One { array, owned, group: None, reversed: false })
                if takes == Takes::References
                    && pair.elems.len() == 2
                    && matches!(array.kind, ExprKind::Call(..)) =>
            {
                let mut named = |pattern: &syn::Pat| {
                    if is_wild(pattern) {
                        let (name, slot) = (self.hidden(ITEM), tree::NO_SLOT);
                        let known = Item::Named(name.clone());
                        return (
                            tree::Pattern::Name { name, slot, mutable: false, inner: None },
                            known,
                        );
                    }
                    let pattern = self.pattern_apart(pattern, looks);
                    let known = match &pattern {
                        tree::Pattern::Name { name, inner: None, .. } => Item::Named(name.clone()),
                        _ => Item::Taken,
                    };
                    (pattern, known)
                };
                let (left, right) = (named(&pair.elems[0]), named(&pair.elems[1]));
                let Over::Each { parts, .. } = &mut flow.over else { return None };
                let pattern = tree::Pattern::Tuple(vec![left.0, right.0]);
                parts.push(tree::Part {
                    pattern,
                    array: *array,
                    owned,
                    group: None,
                    reversed: false,
                });
                Some(Item::Pair(Box::new(left.1), Box::new(right.1)))
            }
            (_, Source::One { array, owned, group, reversed }) => {
                let Over::Each { parts, .. } = &mut flow.over else { return None };
                let lent = takes == Takes::References && !owned;
                let mut part = tree::Part {
                    pattern: tree::Pattern::Any,
                    array: *array,
                    owned,
                    group,
                    reversed,
                };
                if lent && simple(pattern).is_none() {
                    let name = self.hidden(ITEM);
                    let (known, slot) = (Item::Named(name.clone()), tree::NO_SLOT);
                    part.pattern = tree::Pattern::Name { name, slot, mutable: false, inner: None };
                    parts.push(part);
                    return self.name_again(flow, known, pattern, looks);
                }
                part.pattern = self.pattern_apart(pattern, looks);
                let item =
                    named_by(&part).map_or(Item::Taken, |(name, _)| Item::Named(name.clone()));
                parts.push(part);
                Some(item)
            }
        }
    }

    /// The number of a range.
    fn name_number(
        &mut self,
        flow: &mut Flow,
        (pattern, takes): (&mut syn::Pat, Takes),
        looks: &mut Vec<syn::Stmt>,
    ) -> Option<Item> {
        let Over::Range(_, variable) = &mut flow.over else { return None };
        let slot = self.slot();
        let in_tree = match simple(pattern) {
            Some(name) => {
                // In the tree the name is the number, also where the closure is lent it.
                let lent = takes == Takes::References && !is_reference(pattern);
                looks.push(if lent {
                    self.look_behind(slot, &name)
                } else {
                    self.look(slot, &name)
                });
                let counter = self.bind_apart(&text(&name));
                if is_mutable(pattern) {
                    flow.steps.push(Step::Do(copied(counter.clone(), &counter, slot, &name)));
                }
                counter
            }
            None if is_wild(pattern) => {
                let (name, slot) = (format_ident!("__number"), slot_name(slot));
                let look = match takes {
                    Takes::Items => quote! { __look(&#slot, &#name); },
                    Takes::References => quote! { __look(&#slot, &*#name); },
                };
                *pattern = syn::parse_quote!(#name);
                looks.push(syn::Stmt::Expr(syn::Expr::Verbatim(look), None));
                self.hidden("i")
            }
            None => return None,
        };
        *variable = Some((in_tree.clone(), slot));
        Some(Item::Named(in_tree))
    }

    /// A name, by those of another pattern.
    fn name_again(
        &mut self,
        flow: &mut Flow,
        item: Item,
        pattern: &syn::Pat,
        looks: &mut Vec<syn::Stmt>,
    ) -> Option<Item> {
        match (item, behind(pattern)) {
            (item, syn::Pat::Wild(_)) => Some(item),
            (Item::Pair(left, right), syn::Pat::Tuple(pair)) if pair.elems.len() == 2 => {
                let left = self.name_again(flow, *left, &pair.elems[0], looks)?;
                let right = self.name_again(flow, *right, &pair.elems[1], looks)?;
                Some(Item::Pair(Box::new(left), Box::new(right)))
            }
            (Item::Named(known), other) => {
                match simple(other) {
                    // What the closure changes is its own.
                    Some(name) if is_mutable(other) => {
                        let copy = self.bind_apart(&text(&name));
                        flow.steps.push(Step::Do(copied(copy, &known, tree::NO_SLOT, &name)));
                    }
                    Some(name) => self.bind_as(&text(&name), &known),
                    None => {
                        let value = plain(ExprKind::Local(known.clone()), other);
                        let (site, otherwise) = (value.site, None);
                        let pattern = Box::new(self.pattern_apart(other, looks));
                        let apart = tree::Stmt::Apart { pattern, value, otherwise, site };
                        flow.steps.push(Step::Do(apart));
                    }
                }
                Some(Item::Named(known))
            }
            _ => None,
        }
    }

    /// Names, as a value.
    pub(super) fn named_value(item: &Item, node: &syn::Ident) -> Option<tree::Expr> {
        Some(match item {
            Item::Named(name) => plain(ExprKind::Local(name.clone()), node),
            Item::Pair(left, right) => {
                let parts = [Self::named_value(left, node)?, Self::named_value(right, node)?];
                plain(ExprKind::Tuple(parts.into()), node)
            }
            _ => return None,
        })
    }

    /// A name for what is in an `Option` that flows out of a chain, and the slot of its type.
    pub(super) fn optional_name(
        &mut self,
        flow: &mut Flow,
        (value, leading): (tree::Expr, bool),
        receiver: &mut syn::Expr,
    ) -> (String, u32) {
        let (name, slot) = (self.hidden("value"), self.slot());
        let inner = tree::Pattern::Name { name: name.clone(), slot, mutable: false, inner: None };
        let there = there(inner, value);
        flow.steps.push(if leading { Step::WhileLet(there) } else { Step::If(there) });
        look_on_the_way(slot, receiver);
        (name, slot)
    }

    /// The items of a chain, as a value.
    pub(super) fn item_value(
        &mut self,
        flow: &mut Flow,
        receiver: &mut syn::Expr,
    ) -> Option<tree::Expr> {
        let named = |name: String, node: &syn::Expr| plain(ExprKind::Local(name), node);
        match std::mem::replace(&mut flow.item, Item::Taken) {
            Item::Value(value) => Some(value),
            Item::Optional(value) => {
                let (name, _) = self.optional_name(flow, (value, false), receiver);
                Some(named(name, receiver))
            }
            Item::Leading(value) => {
                let (name, _) = self.optional_name(flow, (value, true), receiver);
                Some(named(name, receiver))
            }
            Item::Named(name) => Some(named(name, receiver)),
            item @ (Item::Source(Source::One { .. }) | Item::Number) => {
                if matches!(flow.over, Over::Each { indexed: true, .. }) {
                    return None;
                }
                flow.item = item;
                // The author has no name for it; a look on the way tells its type.
                let name = format_ident!("value");
                let mut pattern = syn::parse_quote!(#name);
                self.name_item(flow, (&mut pattern, Takes::Items), &mut Vec::new())?;
                let slot = match &flow.over {
                    Over::Range(_, variable) => variable.as_ref()?.1,
                    Over::Each { parts, .. } => named_by(parts.first()?)?.1,
                    Over::Nested(..) | Over::Both(..) => return None,
                };
                look_on_the_way(slot, receiver);
                match &flow.item {
                    Item::Named(name) => Some(named(name.clone(), receiver)),
                    _ => None,
                }
            }
            _ => None,
        }
    }
}

/// Lets a slot learn the type of the items of a chain.
pub(super) fn look_on_the_way(slot: u32, chain: &mut syn::Expr) {
    let (slot, items) = (slot_name(slot), &*chain);
    *chain = syn::Expr::Verbatim(quote! { #items.inspect(|__item| __look(&#slot, __item)) });
}

/// A pattern behind its `&` and its parentheses.
fn behind(pattern: &syn::Pat) -> &syn::Pat {
    match pattern {
        syn::Pat::Reference(it) => behind(&it.pat),
        syn::Pat::Paren(it) => behind(&it.pat),
        other => other,
    }
}

/// Whether a pattern is `_`, behind any number of `&`.
pub(super) fn is_wild(pattern: &syn::Pat) -> bool {
    matches!(behind(pattern), syn::Pat::Wild(_))
}

/// The name in a pattern, behind any number of `&`.
pub(super) fn simple(pattern: &syn::Pat) -> Option<syn::Ident> {
    match pattern {
        syn::Pat::Reference(it) => simple(&it.pat),
        other => closure_parameter(other),
    }
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

/// `let name = known;`, where one may be changed and the other is a place or a counter.
pub(super) fn copied(name: String, known: &str, slot: u32, node: &syn::Ident) -> tree::Stmt {
    let value = plain(ExprKind::Local(known.to_owned()), node);
    tree::Stmt::Let { name, slot, site: value.site, value: Some(value) }
}

/// Whether a pattern takes a reference apart, `&x`.
fn is_reference(pattern: &syn::Pat) -> bool {
    match pattern {
        syn::Pat::Reference(_) => true,
        syn::Pat::Paren(it) => is_reference(&it.pat),
        _ => false,
    }
}
