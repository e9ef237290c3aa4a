//! Cases of each `switch` for a value that is no variant of its enum, as memory may hold after a fault of the hardware.
//!
//! Without a choice, the case of the last variant carries `default:`. If the author chose a variant, its case does; if
//! the user wants the hook, a case of its own calls it.
//!
//! Invariants: `default:` is the last label, and what happens for a variant stays. A `switch` whose `default:` is for
//! invalid values alone stays, too: an entry point checks its arguments so. Must not know: the IR.

use std::collections::BTreeMap;

use super::tree::{Expr, Stmt, StmtKind, SwitchArm};

/// The enums of a module, and what becomes of an invalid value.
pub struct Corrupted<'n> {
    enums: BTreeMap<&'n str, Enum<'n>>,
    hook: Option<Vec<Stmt>>,
}

/// Enumerators of an enum, and the one that the author chose.
#[derive(Clone, Copy)]
pub struct Enum<'n> {
    /// Enumerators in order.
    pub variants: &'n [String],
    /// The enumerator as which an invalid value counts.
    pub fallback: Option<&'n str>,
}

impl<'n> Corrupted<'n> {
    /// Collects the enums; `hook` has the statements that report an invalid value, if the user wants them.
    pub fn new(enums: impl Iterator<Item = Enum<'n>>, hook: Option<Vec<Stmt>>) -> Corrupted<'n> {
        let named = |it: Enum<'n>| it.variants.iter().map(move |name| (name.as_str(), it));
        Corrupted { enums: enums.flat_map(named).collect(), hook }
    }

    /// Places the cases in a function's body, and returns true if one of them calls the hook.
    pub fn rewrite(&self, body: &mut [Stmt]) -> bool {
        let mut hooked = false;
        for stmt in body {
            for block in stmt.kind.blocks_mut() {
                hooked |= self.rewrite(block);
            }
            if let StmtKind::Switch { arms, .. } = &mut stmt.kind {
                hooked |= self.place(arms);
            }
        }
        hooked
    }

    fn place(&self, arms: &mut Vec<SwitchArm>) -> bool {
        let enumerator = |label: &Expr| match label {
            Expr::Name(name) => self.enums.get(name.as_str()).copied(),
            _ => None,
        };
        let Some(of) = arms.iter().flat_map(|arm| &arm.labels).find_map(enumerator) else {
            return false;
        };
        let named = |arms: &[SwitchArm], name: &str| {
            arms.iter().position(|arm| arm.labels.contains(&Expr::name(name)))
        };
        let left: Vec<Expr> = (of.variants.iter().map(String::as_str))
            .filter(|name| named(arms, name).is_none())
            .map(Expr::name)
            .collect();
        let Some(default) = arms.iter().position(|arm| arm.default) else { return false };
        let alone = arms[default].labels.is_empty() && left.is_empty();
        let chosen = match of.fallback {
            Some(fallback) => named(arms, fallback).filter(|at| *at != default),
            None => self.hook.as_ref().map(|_| default),
        };
        let Some(chosen) = chosen.filter(|_| !alone) else { return false };
        arms[default].labels.extend(left);
        arms[default].default = false;
        match (of.fallback, &self.hook) {
            (None, Some(hook)) => {
                let body = hook.clone();
                arms.push(SwitchArm { labels: Vec::new(), default: true, body });
                true
            }
            _ => {
                let last = arms.remove(chosen);
                arms.push(SwitchArm { default: true, ..last });
                false
            }
        }
    }
}

#[cfg(test)]
mod tests;
