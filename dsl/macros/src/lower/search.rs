//! Chains of iterators that end in an `Option`: `.max()`, `.find(…)` and the like.
//!
//! In the tree the loop assigns what it has found so far.

use bessemer_ir::tree::{self, BinaryOp, ExprKind, Order, Pattern, Start};
use bessemer_ir::{Int, Scalar};

use super::closure::closure_of;
use super::flow::{Flow, Item, Over, Step, Takes, named_by};
use super::item::look_on_the_way;
use super::made::{UNIT, plain};
use super::names::{GENERATING, slot_name};
use super::refuse;
use super::syntax::is_made_of_plain;
use super::walk::Lowering;

/// The ends of such a chain.
pub(super) const ENDS: [&str; 8] =
    ["min", "max", "last", "find", "position", "rposition", "next", "nth"];

impl Lowering<'_> {
    /// The value of such a chain; none if the DSL does not take it.
    pub(super) fn search(&mut self, it: &mut syn::ExprMethodCall, end: &str) -> Option<ExprKind> {
        let node = it.method.clone();
        let mut flow = self.flow(&mut it.receiver)?;
        let slot = self.slot();
        let name = self.hidden(end);
        let local = |name: &str| plain(ExprKind::Local(name.to_owned()), &node);
        let option = |name: &str, parts| tree::Expr {
            kind: ExprKind::Constructor(name.to_owned(), parts),
            slot: Some(slot),
            ..plain(UNIT, &node)
        };
        let told = |item: tree::Expr| {
            let some = Box::new(option("Some", vec![item]));
            tree::Stmt::Expr(plain(ExprKind::Assign(None, Box::new(local(&name)), some), &node))
        };
        let block = |stmts| tree::Block { stmts, tail: None };
        let when = |condition: tree::Expr, then, otherwise: Option<tree::Block>| {
            let otherwise = otherwise.map(|it| Box::new(plain(ExprKind::Block(it), &node)));
            let kind = ExprKind::If(Box::new(condition), then, otherwise);
            tree::Stmt::Expr(plain(kind, &node))
        };
        let stop = tree::Stmt::Expr(plain(ExprKind::Break(None, None), &node));
        let last = match end {
            "position" | "rposition" => {
                let index = self.count_from_zero(&mut flow, end == "rposition")?;
                let closure = closure_of(it.args.get_mut(0)?)?;
                let condition = self.through(&mut flow, closure, (0, Takes::Items))?;
                when(condition, block(vec![told(local(&index)), stop]), None)
            }
            "find" => {
                let closure = closure_of(it.args.get_mut(0)?)?;
                let condition = self.through(&mut flow, closure, (0, Takes::References))?;
                let item = Self::named_value(&flow.item, &node)?;
                when(condition, block(vec![told(item), stop]), None)
            }
            end => {
                let (item, slot) = self.item_name(&mut flow, it)?;
                if end == "last" {
                    told(local(&item))
                } else if end == "next" {
                    tree::Stmt::Expr(plain(
                        ExprKind::Block(block(vec![told(local(&item)), stop])),
                        &node,
                    ))
                } else if end == "nth" {
                    let left = self.passed_over(&mut flow, it)?;
                    let number =
                        |digits: &str| Box::new(plain(ExprKind::Int(digits.into(), None), &node));
                    let none = ExprKind::Binary(BinaryOp::Eq, Box::new(local(&left)), number("0"));
                    let less =
                        ExprKind::Assign(Some(BinaryOp::Sub), Box::new(local(&left)), number("1"));
                    let less = block(vec![tree::Stmt::Expr(plain(less, &node))]);
                    let found = block(vec![told(local(&item)), stop]);
                    when(plain(none, &node), found, Some(less))
                } else {
                    let best = self.hidden("best");
                    let name_best =
                        Pattern::Name { name: best.clone(), slot, mutable: false, inner: None };
                    let pattern = Pattern::Constructor("Some".into(), vec![name_best]);
                    let found = ExprKind::Let(Box::new(pattern), Box::new(local(&name)));
                    let op = if end == "max" { BinaryOp::Gt } else { BinaryOp::Lt };
                    let sides = (Box::new(local(&item)), Box::new(local(&best)));
                    let better = plain(ExprKind::Binary(op, sides.0, sides.1), &node);
                    let replace = when(better, block(vec![told(local(&item))]), None);
                    let first = block(vec![told(local(&item))]);
                    when(plain(found, &node), block(vec![replace]), Some(first))
                }
            }
        };
        let start = Start::Value(Box::new(option("None", Vec::new())));
        let each = Box::new(plain(flow.into_loop(last, None), &node));
        if GENERATING {
            let (slot, call) = (slot_name(slot), it.clone());
            *it = syn::parse_quote! { #slot.__glance(#call) };
        }
        Some(ExprKind::Fold { name, start, each })
    }

    /// How many items `.nth(n)` passes over still.
    fn passed_over(&mut self, flow: &mut Flow, it: &mut syn::ExprMethodCall) -> Option<String> {
        if !is_made_of_plain(&it.args[0]) {
            // It would be computed before what the chain begins with.
            self.refusals.add(&it.args[0], refuse::SCAN);
            return None;
        }
        let mut count = self.value(&mut it.args[0]);
        if let ExprKind::Int(_, suffix @ None) = &mut count.kind {
            *suffix = Some(Scalar::Int(Int::Usize));
        }
        let (name, slot, site) = (self.hidden("left"), tree::NO_SLOT, count.site);
        flow.before.push(tree::Stmt::Let { name: name.clone(), slot, value: Some(count), site });
        Some(name)
    }

    /// The index of the elements, counted as they come; or, `back`, from the last one.
    fn count_from_zero(&mut self, flow: &mut Flow, back: bool) -> Option<String> {
        let plain = flow.steps.is_empty() && matches!(flow.item, Item::Source(_));
        let Over::Each { index, indexed: false, order, cuts, .. } = &mut flow.over else {
            return None;
        };
        if !plain || !cuts.is_empty() {
            return None;
        }
        match (*order, back) {
            (Order::Up, true) => *order = Order::Down,
            (Order::Down, false) => *order = Order::Mirrored,
            (Order::Up, false) => {}
            _ => return None,
        }
        let name = self.hidden("i");
        *index = Some(name.clone());
        Some(name)
    }

    /// A name for what flows out of a chain, and the slot of its type.
    fn item_name(
        &mut self,
        flow: &mut Flow,
        it: &mut syn::ExprMethodCall,
    ) -> Option<(String, u32)> {
        if let Item::Value(value) = &flow.item {
            let (slot, site) = (value.slot?, value.site);
            let name = self.hidden("value");
            let value = Some(value.clone());
            flow.steps.push(Step::Do(tree::Stmt::Let { name: name.clone(), slot, value, site }));
            return Some((name, slot));
        }
        if let Item::Optional(value) | Item::Leading(value) = &flow.item {
            let (value, leading) = (value.clone(), matches!(flow.item, Item::Leading(_)));
            flow.item = Item::Taken;
            return Some(self.optional_name(flow, (value, leading), &mut it.receiver));
        }
        let value = self.item_value(flow, &mut it.receiver)?;
        let ExprKind::Local(name) = value.kind else { return None };
        let slot = match &flow.over {
            Over::Range(_, variable) => variable.as_ref()?.1,
            Over::Each { parts, .. } => named_by(parts.first()?)?.1,
            Over::Nested(..) | Over::Both(..) => {
                let slot = self.slot();
                look_on_the_way(slot, &mut it.receiver);
                slot
            }
        };
        Some((name, slot))
    }
}
