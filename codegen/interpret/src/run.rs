//! Executes statements and evaluates expressions.
//!
//! Memory is one stack of words. A frame holds a function's locals; temporaries are above it, until their statement
//! ends. An address is an index into the memory.
//!
//! Invariants: a value is never written over words that are still to be read (an assignment of several words uses a
//! copy); memory above `top` is free.

use std::collections::BTreeSet;

use bessemer_ir::{
    Argument, Block, Expr, ExprKind, Fault, Function, FunctionId, Int, Intrinsic, LogicOp, Mode,
    Module, Place, Routine, Span, Step, Stmt, StmtKind, Type,
};

use super::layout::Layout;
use super::routine::{Operand, routine};
use super::{Stop, scalar};

/// One call from outside, with all inner calls.
pub(super) struct Run<'m, 'r> {
    module: &'m Module,
    layout: &'r Layout,
    memory: &'r mut Vec<u64>,
    top: usize,
    /// Number of statements that may still be executed.
    left: u64,
    /// Spans of the executed statements, if they are recorded.
    pub ran: Option<&'r mut BTreeSet<Span>>,
}

/// A function that is being executed.
#[derive(Clone, Copy)]
struct Frame<'m, 'r> {
    id: FunctionId,
    function: &'m Function,
    /// Offset of each local from `base`.
    offsets: &'r [usize],
    base: usize,
    /// Address of the result.
    result: usize,
}

impl Frame<'_, '_> {
    fn fault<T>(&self, fault: Fault, span: Span) -> Result<T, Stop> {
        Err(Stop::Fault { fault, function: self.id, span })
    }

    fn at<T>(&self, span: Span, outcome: Result<T, Fault>) -> Result<T, Stop> {
        outcome.or_else(|fault| self.fault(fault, span))
    }
}

/// Control flow after a statement.
enum Flow {
    Next,
    Break,
    Continue,
    Return,
}

impl<'m, 'r> Run<'m, 'r> {
    pub fn new(
        module: &'m Module,
        layout: &'r Layout,
        memory: &'r mut Vec<u64>,
        left: u64,
    ) -> Self {
        Run { module, layout, memory, top: 0, left, ran: None }
    }

    /// Calls a function from outside; returns its outcome and the addresses of the arguments.
    pub fn enter(
        &mut self,
        id: FunctionId,
        arguments: &[&[u64]],
    ) -> (Result<Vec<u64>, Stop>, Vec<usize>) {
        let size = self.layout.size(&self.module.functions[id.index()].result);
        let result = self.allocate(size);
        let frame = self.frame(id, result);
        let mut addresses = Vec::new();
        for (index, (local, words)) in frame.function.locals.iter().zip(arguments).enumerate() {
            let slot = frame.base + frame.offsets[index];
            let address = match local.mode {
                Mode::Value => slot,
                Mode::Ref | Mode::RefMut => {
                    let address = self.allocate(words.len());
                    self.memory[slot] = address as u64;
                    address
                }
            };
            self.memory[address..address + words.len()].copy_from_slice(words);
            addresses.push(address);
        }
        let outcome = self.body(frame);
        (outcome.map(|_| self.memory[result..result + size].to_vec()), addresses)
    }

    fn allocate(&mut self, words: usize) -> usize {
        let address = self.top;
        self.top += words;
        if self.memory.len() < self.top {
            self.memory.resize(self.top, 0);
        }
        address
    }

    fn frame(&mut self, id: FunctionId, result: usize) -> Frame<'m, 'r> {
        let locals = self.layout.locals(id);
        let base = self.allocate(locals.size);
        let function = &self.module.functions[id.index()];
        Frame { id, function, offsets: &locals.offsets, base, result }
    }

    /// Executes a function whose arguments are in memory.
    fn body(&mut self, frame: Frame<'m, 'r>) -> Result<Flow, Stop> {
        let Some(kernel) = &frame.function.kernel else {
            return self.block(frame, &frame.function.body);
        };
        let references = frame.function.parameters().iter().zip(frame.offsets);
        let operands: Vec<Operand<'_>> = references
            .map(|(local, offset)| Operand {
                ty: &local.ty,
                at: self.memory[frame.base + offset] as usize,
            })
            .collect();
        super::kernel::run(self.memory, kernel, &operands, frame.result);
        Ok(Flow::Next)
    }

    fn copy(&mut self, from: usize, to: usize, words: usize) {
        self.memory.copy_within(from..from + words, to);
    }

    fn block(&mut self, frame: Frame<'m, 'r>, block: &'m Block) -> Result<Flow, Stop> {
        for stmt in &block.0 {
            let top = self.top;
            self.left = self.left.checked_sub(1).ok_or(Stop::Limit)?;
            if let Some(ran) = &mut self.ran {
                ran.insert(stmt.span);
            }
            let flow = self.stmt(frame, stmt)?;
            self.top = top;
            if !matches!(flow, Flow::Next) {
                return Ok(flow);
            }
        }
        Ok(Flow::Next)
    }

    fn stmt(&mut self, frame: Frame<'m, 'r>, stmt: &'m Stmt) -> Result<Flow, Stop> {
        match &stmt.kind {
            StmtKind::Let { local, value } => {
                let slot = frame.base + frame.offsets[local.index()];
                match (frame.function.local(*local).mode, value) {
                    (_, None) => {}
                    (Mode::RefMut, Some(Expr { kind: ExprKind::Load(place), .. })) => {
                        self.memory[slot] = self.address(frame, place)? as u64;
                    }
                    (_, Some(value)) => self.value(frame, value, slot)?,
                }
            }
            StmtKind::Assign { place, value } if value.ty.is_word() => {
                let word = self.word(frame, value)?;
                let address = self.address(frame, place)?;
                self.memory[address] = word;
            }
            StmtKind::Assign { place, value } => {
                let size = self.layout.size(&value.ty);
                let copy = self.allocate(size);
                self.value(frame, value, copy)?;
                let address = self.address(frame, place)?;
                self.copy(copy, address, size);
            }
            StmtKind::Expr(expr) => {
                let unused = self.allocate(self.layout.size(&expr.ty));
                self.value(frame, expr, unused)?;
            }
            StmtKind::If { condition, then, otherwise } => {
                let holds = self.word(frame, condition)? != 0;
                return self.block(frame, if holds { then } else { otherwise });
            }
            StmtKind::Match { scrutinee, arms, otherwise } => {
                let word = self.word(frame, scrutinee)?;
                let value =
                    scrutinee.ty.as_int().map_or(i128::from(word), |int| int.from_word(word));
                let arm = arms.iter().find(|arm| arm.values.contains(&value));
                return match arm.map(|arm| &arm.body).or(otherwise.as_ref()) {
                    Some(body) => self.block(frame, body),
                    None => frame.fault(Fault::Variant, scrutinee.span),
                };
            }
            StmtKind::For { .. } => return self.repeat(frame, stmt),
            StmtKind::Check { condition, fault } => {
                if self.word(frame, condition)? == 0 {
                    return frame.fault(*fault, stmt.span);
                }
            }
            StmtKind::Return(value) => {
                if let Some(value) = value {
                    self.value(frame, value, frame.result)?;
                }
                return Ok(Flow::Return);
            }
            StmtKind::Break => return Ok(Flow::Break),
            StmtKind::Continue => return Ok(Flow::Continue),
        }
        Ok(Flow::Next)
    }

    fn repeat(&mut self, frame: Frame<'m, 'r>, stmt: &'m Stmt) -> Result<Flow, Stop> {
        let StmtKind::For { variable, from, to, inclusive, reversed, ended, body, .. } = &stmt.kind
        else {
            unreachable!("called for loops only")
        };
        let Some(int) = from.ty.as_int() else { unreachable!("validated: bounds are integers") };
        let first = int.from_word(self.word(frame, from)?);
        let last = int.from_word(self.word(frame, to)?) - i128::from(!inclusive);
        // A loop that ends itself may begin one pass more than the bounds count: in that pass its condition fails.
        let last = if *ended { last.max(first - 1) + 1 } else { last };
        let slot = frame.base + frame.offsets[variable.index()];
        let mut passed = 0;
        while first + passed <= last {
            let value = if *reversed { last - passed } else { first + passed };
            passed += 1;
            self.left = self.left.checked_sub(1).ok_or(Stop::Limit)?;
            self.memory[slot] = value as u64;
            match self.block(frame, body)? {
                Flow::Next | Flow::Continue => {}
                Flow::Break => return Ok(Flow::Next),
                Flow::Return => return Ok(Flow::Return),
            }
        }
        if *ended {
            // In the C nothing counts, so it would go on.
            return frame.fault(Fault::LeftOut, stmt.span);
        }
        Ok(Flow::Next)
    }

    /// Returns the address of a place that is read, whose payloads must be there.
    fn read(&mut self, frame: Frame<'m, 'r>, place: &'m Place) -> Result<usize, Stop> {
        match self.locate(frame, place)? {
            (address, true) => Ok(address),
            (_, false) => Err(Stop::Absent { function: frame.id, span: place.span }),
        }
    }

    /// Returns the address of a place; its indices are evaluated and checked in order.
    fn address(&mut self, frame: Frame<'m, 'r>, place: &'m Place) -> Result<usize, Stop> {
        Ok(self.locate(frame, place)?.0)
    }

    /// Returns the address of a place, and false if it is in a payload whose variant is not there.
    fn locate(&mut self, frame: Frame<'m, 'r>, place: &'m Place) -> Result<(usize, bool), Stop> {
        let mut is_there = true;
        let local = frame.function.local(place.root);
        let slot = frame.base + frame.offsets[place.root.index()];
        let mut address = match local.mode {
            Mode::Value => slot,
            Mode::Ref | Mode::RefMut => self.memory[slot] as usize,
        };
        let mut ty = &local.ty;
        for step in &place.steps {
            match (step, ty) {
                (Step::Field(field), Type::Struct(id)) => {
                    let (definition, field) = (&self.module.structs[id.index()], *field as usize);
                    let tag = self.memory.get(address).copied().unwrap_or_default();
                    is_there &= definition.holds(field, tag);
                    address += self.layout.fields(*id).offsets[field];
                    ty = &definition.fields[field].ty;
                }
                (Step::From(from), Type::Array { element, len }) => {
                    address += self.index(frame, from, *len + 1)? * self.layout.size(element);
                    ty = &place.ty;
                }
                (Step::From(from), Type::Matrix { rows, cols, .. }) => {
                    address += self.index(frame, from, rows * cols + 1)?;
                    ty = &place.ty;
                }
                (Step::Index(index) | Step::From(index), Type::Slice(element)) => {
                    let most = u64::from(matches!(step, Step::From(_)));
                    let length = self.memory[frame.base + frame.offsets[place.root.index() + 1]];
                    let at = self.word(frame, index)?;
                    if at >= length.saturating_add(most) {
                        return frame.fault(Fault::Index, index.span);
                    }
                    address += at as usize * self.layout.size(element);
                    ty = if most == 0 { element } else { ty };
                }
                (Step::Index(index), Type::Array { element, len }) => {
                    address += self.index(frame, index, *len)? * self.layout.size(element);
                    ty = element;
                }
                (Step::Index(index), Type::Matrix { rows, cols, .. }) => {
                    address += self.index(frame, index, rows * cols)?;
                    ty = &place.ty;
                }
                (Step::Element(row, col), Type::Matrix { rows, cols, .. }) => {
                    // Rust makes the pair of indices first, then checks each.
                    let (row_word, col_word) = (self.word(frame, row)?, self.word(frame, col)?);
                    address += self.within(frame, row, row_word, *rows)?;
                    address += self.within(frame, col, col_word, *cols)? * *rows as usize;
                    ty = &place.ty;
                }
                _ => unreachable!("validated: steps fit the types they step into"),
            }
        }
        Ok((address, is_there))
    }

    fn index(&mut self, frame: Frame<'m, 'r>, index: &'m Expr, len: u32) -> Result<usize, Stop> {
        let word = self.word(frame, index)?;
        self.within(frame, index, word, len)
    }

    /// Returns the index in `word`, or a fault unless it is below `len`.
    fn within(
        &self,
        frame: Frame<'m, 'r>,
        index: &'m Expr,
        word: u64,
        len: u32,
    ) -> Result<usize, Stop> {
        match index.ty.as_int().unwrap_or(Int::Usize).from_word(word) {
            value if 0 <= value && value < i128::from(len) => Ok(value as usize),
            _ => frame.fault(Fault::Index, index.span),
        }
    }

    /// Evaluates an expression of one word.
    fn word(&mut self, frame: Frame<'m, 'r>, expr: &'m Expr) -> Result<u64, Stop> {
        match &expr.kind {
            ExprKind::Literal(word) => Ok(*word),
            ExprKind::Const(id) => Ok(self.module.consts[id.index()].words[0]),
            ExprKind::Load(place) => {
                let address = self.read(frame, place)?;
                Ok(self.memory[address])
            }
            ExprKind::Unary(op, operand) => {
                let word = self.word(frame, operand)?;
                frame.at(expr.span, scalar::unary(*op, &expr.ty, word))
            }
            ExprKind::Binary(op, left, right) => {
                let (a, b) = (self.word(frame, left)?, self.word(frame, right)?);
                frame.at(expr.span, scalar::binary(*op, &expr.ty, a, &right.ty, b))
            }
            ExprKind::Compare(op, left, right) => {
                let (a, b) = (self.word(frame, left)?, self.word(frame, right)?);
                Ok(u64::from(scalar::compare(*op, &left.ty, a, b)))
            }
            ExprKind::Logic(op, left, right) => match (op, self.word(frame, left)? != 0) {
                (LogicOp::And, false) => Ok(0),
                (LogicOp::Or, true) => Ok(1),
                _ => self.word(frame, right),
            },
            ExprKind::Cast(operand) => {
                let word = self.word(frame, operand)?;
                if let Type::Enum(id) = operand.ty {
                    let value = self.module.enums[id.index()].value(word).unwrap_or_default();
                    return Ok(scalar::cast_number(value.into(), &expr.ty));
                }
                Ok(scalar::cast(&operand.ty, &expr.ty, word))
            }
            ExprKind::Intrinsic(Intrinsic::Variant, operands) => {
                let word = self.word(frame, &operands[0])?;
                let Type::Enum(id) = operands[0].ty else { unreachable!("validated: an enum") };
                let last = self.module.enums[id.index()].variants.len().saturating_sub(1);
                Ok(word.min(last as u64))
            }
            ExprKind::Intrinsic(function, operands) => {
                let mut words = [0; 3];
                for (word, operand) in words.iter_mut().zip(operands) {
                    *word = self.word(frame, operand)?;
                }
                frame.at(expr.span, scalar::intrinsic(*function, &operands[0].ty, &words))
            }
            ExprKind::Call(..) | ExprKind::Routine(..) => {
                let top = self.top;
                let address = self.allocate(1);
                self.value(frame, expr, address)?;
                self.top = top;
                Ok(self.memory[address])
            }
            ExprKind::Struct(_) | ExprKind::Array(_) | ExprKind::Splat(_) | ExprKind::Matrix(_) => {
                unreachable!("validated: an aggregate is not one word")
            }
        }
    }

    /// Evaluates an expression of any type, and writes its words from the address `out` on.
    fn value(&mut self, frame: Frame<'m, 'r>, expr: &'m Expr, out: usize) -> Result<(), Stop> {
        match &expr.kind {
            ExprKind::Load(place) => {
                let address = self.read(frame, place)?;
                self.copy(address, out, self.layout.size(&expr.ty));
            }
            ExprKind::Const(id) => {
                let words = &self.module.consts[id.index()].words;
                self.memory[out..out + words.len()].copy_from_slice(words);
            }
            ExprKind::Call(callee, arguments) => self.call(frame, *callee, arguments, out)?,
            ExprKind::Struct(parts) | ExprKind::Array(parts) | ExprKind::Matrix(parts) => {
                let mut at = out;
                for part in parts {
                    self.value(frame, part, at)?;
                    at += self.layout.size(&part.ty);
                }
            }
            ExprKind::Splat(part) => {
                self.value(frame, part, out)?;
                let size = self.layout.size(&part.ty);
                for at in (out..out + self.layout.size(&expr.ty)).step_by(size).skip(1) {
                    self.copy(out, at, size);
                }
            }
            ExprKind::Routine(what, operands) => self.routine(frame, *what, operands, out)?,
            _ => self.memory[out] = self.word(frame, expr)?,
        }
        Ok(())
    }

    fn routine(
        &mut self,
        frame: Frame<'m, 'r>,
        what: Routine,
        operands: &'m [Expr],
        out: usize,
    ) -> Result<(), Stop> {
        let top = self.top;
        let mut evaluated = Vec::with_capacity(2);
        for (index, operand) in operands.iter().enumerate() {
            let at = match &operand.kind {
                // Read where it lies, unless what follows could write there.
                ExprKind::Load(place) if operands[index + 1..].iter().all(is_plain) => {
                    self.read(frame, place)?
                }
                _ => {
                    let at = self.allocate(self.layout.size(&operand.ty));
                    self.value(frame, operand, at)?;
                    at
                }
            };
            evaluated.push(Operand { ty: &operand.ty, at });
        }
        routine(self.memory, what, &evaluated, out);
        self.top = top;
        Ok(())
    }

    fn call(
        &mut self,
        frame: Frame<'m, 'r>,
        id: FunctionId,
        arguments: &'m [Argument],
        out: usize,
    ) -> Result<(), Stop> {
        let top = self.top;
        let callee = self.frame(id, out);
        for (index, argument) in arguments.iter().enumerate() {
            let slot = callee.base + callee.offsets[index];
            match argument {
                Argument::Value(expr) => self.value(frame, expr, slot)?,
                Argument::Ref(Expr { kind: ExprKind::Load(place), .. }) => {
                    self.memory[slot] = self.read(frame, place)? as u64;
                }
                Argument::RefMut(place) => {
                    self.memory[slot] = self.address(frame, place)? as u64;
                }
                Argument::Ref(expr) => {
                    let at = self.allocate(self.layout.size(&expr.ty));
                    self.value(frame, expr, at)?;
                    self.memory[slot] = at as u64;
                }
            }
        }
        self.body(callee)?;
        self.top = top;
        Ok(())
    }
}

/// Returns true if evaluating `expr` certainly writes nothing.
fn is_plain(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Literal(_) | ExprKind::Const(_) => true,
        ExprKind::Load(place) => place.steps.iter().all(|step| match step {
            Step::Field(_) => true,
            Step::Index(index) | Step::From(index) => is_plain(index),
            Step::Element(row, col) => is_plain(row) && is_plain(col),
        }),
        _ => false,
    }
}
