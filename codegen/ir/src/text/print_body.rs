//! Prints the body of a function: declarations and statements.

use crate::ir::{Arm, Block, Expr, Function, LocalId, Span, Stmt, StmtKind, Type};
use crate::visit::{Visit, walk_block};

use super::names::{fault_name, shown};
use super::print::{Printer, relative};

/// Set of locals that the statements declare.
struct Declared(alloc::vec::Vec<bool>);

impl Visit for Declared {
    fn declaration(&mut self, local: &LocalId) {
        if let Some(declared) = self.0.get_mut(local.index()) {
            *declared = true;
        }
    }
}

impl<'m> Printer<'m> {
    /// Prints ` { … }`, after the head of a function.
    pub fn body(&mut self, function: &'m Function) {
        let mut declared = Declared(self.locals.declared.clone());
        walk_block(&mut declared, &function.body);
        self.out.push_str(" {\n");
        self.indent = 1;
        for (index, declared) in declared.0.into_iter().enumerate() {
            if !declared {
                self.line();
                self.out.push_str("var ");
                self.declare(LocalId(index as u32), function.span);
                self.out.push_str(";\n");
            }
        }
        for stmt in &function.body.0 {
            self.stmt(stmt, function.span);
        }
        self.indent = 0;
        self.line();
        self.out.push('}');
    }

    fn block(&mut self, block: &Block, base: Span) {
        self.out.push('{');
        if !block.0.is_empty() {
            self.out.push('\n');
            self.indent += 1;
            for stmt in &block.0 {
                self.stmt(stmt, base);
            }
            self.indent -= 1;
            self.line();
        }
        self.out.push('}');
    }

    fn stmt(&mut self, stmt: &Stmt, around: Span) {
        self.remarks("//", &stmt.comments);
        self.line();
        let place = relative(stmt.span, around, around);
        if !place.is_empty() {
            self.put(format_args!("{place} "));
        }
        let base = stmt.span;
        match &stmt.kind {
            StmtKind::Let { local, value } => {
                self.out.push_str("let ");
                self.binding(*local, base);
                if let Some(value) = value {
                    self.out.push_str(" = ");
                    self.expr(value, base);
                }
                self.out.push(';');
            }
            StmtKind::Assign { place, value } => {
                self.place(place, base, base, true);
                self.out.push_str(" = ");
                self.expr(value, base);
                self.out.push(';');
            }
            StmtKind::Expr(expr) => {
                self.expr(expr, base);
                self.out.push(';');
            }
            StmtKind::If { condition, then, otherwise } => {
                self.out.push_str("if ");
                self.expr(condition, base);
                self.out.push(' ');
                self.block(then, base);
                if !otherwise.0.is_empty() {
                    self.out.push_str(" else ");
                    self.block(otherwise, base);
                }
            }
            StmtKind::Match { scrutinee, arms, otherwise } => {
                self.matching(scrutinee, arms, otherwise.as_ref(), base);
            }
            StmtKind::For { .. } => self.repeat(&stmt.kind, base),
            StmtKind::Check { condition, fault } => {
                self.out.push_str("check ");
                self.expr(condition, base);
                self.put(format_args!(" else {};", fault_name(*fault)));
            }
            StmtKind::Return(None) => self.out.push_str("return;"),
            StmtKind::Return(Some(value)) => {
                self.out.push_str("return ");
                self.expr(value, base);
                self.out.push(';');
            }
            StmtKind::Break => self.out.push_str("break;"),
            StmtKind::Continue => self.out.push_str("continue;"),
        }
        self.out.push('\n');
    }

    /// Prints a local in its declaration: with its type the first time, by its name afterwards.
    fn binding(&mut self, local: LocalId, base: Span) {
        if self.locals.declared.get(local.index()) == Some(&false) {
            self.declare(local, base);
        } else {
            let name = self.local_name(local);
            self.out.push_str(&name);
        }
    }

    fn matching(&mut self, scrutinee: &Expr, arms: &[Arm], rest: Option<&Block>, base: Span) {
        self.out.push_str("match ");
        self.expr(scrutinee, base);
        self.out.push_str(" {\n");
        self.indent += 1;
        for arm in arms {
            self.line();
            for (index, value) in arm.values.iter().enumerate() {
                let gap = if index == 0 { "" } else { ", " };
                match self.variant(&scrutinee.ty, u64::try_from(*value).ok()) {
                    Some(name) => self.put(format_args!("{gap}{name}")),
                    None => self.put(format_args!("{gap}{value}")),
                }
            }
            self.out.push_str(if arm.values.is_empty() { "=> " } else { " => " });
            self.block(&arm.body, base);
            self.out.push('\n');
        }
        if let Some(rest) = rest {
            self.line();
            self.out.push_str("_ => ");
            self.block(rest, base);
            self.out.push('\n');
        }
        self.indent -= 1;
        self.line();
        self.out.push('}');
    }

    /// Returns the variant's name, such as `Mode::Hover`, if it identifies this value of an enum.
    pub fn variant(&self, ty: &Type, value: Option<u64>) -> Option<alloc::string::String> {
        let Type::Enum(id) = ty else { return None };
        let variants = &self.module.enums.get(id.index())?.variants;
        let name = &variants.get(usize::try_from(value?).ok()?)?.name;
        if variants.iter().filter(|variant| variant.name == *name).count() > 1 {
            return None;
        }
        let path = self.type_name(super::print::TypeId::Enum(*id));
        Some(alloc::format!("{path}::{}", shown(name)))
    }

    fn repeat(&mut self, kind: &StmtKind, base: Span) {
        let StmtKind::For { variable, from, to, inclusive, reversed, unroll, ended, body } = kind
        else {
            return;
        };
        self.out.push_str("for ");
        self.binding(*variable, base);
        self.out.push_str(if *reversed { " in rev " } else { " in " });
        self.expr(from, base);
        self.out.push_str(if *inclusive { "..=" } else { ".." });
        self.expr(to, base);
        if *ended {
            self.out.push_str(" while");
        }
        if let Some(count) = unroll {
            self.out.push_str(&alloc::format!(" #{count}"));
        }
        self.out.push(' ');
        self.block(body, base);
    }
}
