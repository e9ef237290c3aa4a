//! Statements: branches, unrolled loops, and what follows them.
//!
//! A path that leaves a branch early goes on behind the construct that it leaves. So the statements after a branch
//! are evaluated within those of its sides that go on, up to the nearest place where all sides meet.

use bessemer_ir::visit::{self, Visit};
use bessemer_ir::{Block, Expr, LocalId, Mode, Span, Stmt, StmtKind};

use crate::expression::literal;
use crate::join::Branch;
use crate::run::{Env, Frame, Run};
use crate::value::{Value, Word};
use crate::{Problem, Result};

/// Largest number of evaluated statements. A statement behind `if a { if b { return x; } }` is in two sides, and sides
/// multiply.
const STEPS: u32 = 20_000;

/// The rest of a path: linked statements and loops.
#[derive(Clone, Copy)]
pub struct Node<'n> {
    what: What<'n>,
    next: Option<&'n Node<'n>>,
    depth: usize,
}

#[derive(Clone, Copy)]
enum What<'n> {
    /// Statements.
    Stmts(&'n [Stmt]),
    /// The next pass of an unrolled loop.
    Pass(Unrolled<'n>, usize),
    /// The end of an unrolled loop with its number of passes, to which `break` leads.
    End(u64),
}

/// A loop that is unrolled.
#[derive(Clone, Copy)]
struct Unrolled<'n> {
    variable: LocalId,
    values: &'n [Expr],
    body: &'n Block,
}

/// Ways to leave a pass of a loop early.
#[derive(Clone, Copy, PartialEq)]
enum Leave {
    Break,
    Continue,
}

type Rest<'n> = Option<&'n Node<'n>>;

fn node<'n>(what: What<'n>, next: Rest<'n>) -> Node<'n> {
    Node { what, next, depth: depth(next) + 1 }
}

fn depth(rest: Rest<'_>) -> usize {
    rest.map_or(0, |node| node.depth)
}

impl Run<'_> {
    /// Evaluates a function on the values of its parameters; returns its values at the end.
    pub fn function(&mut self, function: &bessemer_ir::Function, mut env: Env) -> Result<Env> {
        let frame = Frame { function, carried: None };
        self.run(frame, &mut env, &function.body.0, None, 0)?;
        Ok(env)
    }

    /// Evaluates the body of a loop that stays a loop.
    pub fn pass(&mut self, frame: Frame<'_>, env: &mut Env, body: &Block) -> Result<()> {
        self.run(frame, env, &body.0, None, 0)?;
        if !env.ended {
            self.write_back(frame, env)?;
        }
        Ok(())
    }

    /// Evaluates statements and what follows them, up to the node at depth `stop`.
    fn run(
        &mut self,
        frame: Frame<'_>,
        env: &mut Env,
        stmts: &[Stmt],
        rest: Rest<'_>,
        stop: usize,
    ) -> Result<()> {
        for (index, stmt) in stmts.iter().enumerate() {
            let tail = node(What::Stmts(&stmts[index + 1..]), rest);
            self.steps += 1;
            if self.steps > STEPS {
                return Err(Problem::new(
                    stmt.span,
                    format!("the derivative has more than {STEPS} statements"),
                    "move what follows an early end within branches to a function of its own, or differentiate parts",
                ));
            }
            match &stmt.kind {
                StmtKind::Return(value) => {
                    if frame.carried.is_some() {
                        return Err(Problem::new(
                            stmt.span,
                            "a `return` within a long loop has no derivative",
                            "end the loop by `break`, and return behind it",
                        ));
                    }
                    env.result = match value {
                        Some(value) => {
                            let own = &frame.function.result_name;
                            self.name = self.result_name.clone().unwrap_or_else(|| own.clone());
                            let value = self.value(frame, env, value)?;
                            let name = self.name.clone();
                            Some(self.held(value, &name))
                        }
                        None => Some(Value::Parts(Vec::new())),
                    };
                    return Ok(());
                }
                StmtKind::Break => return self.leave(frame, env, Leave::Break, rest, stop),
                StmtKind::Continue => return self.leave(frame, env, Leave::Continue, rest, stop),
                StmtKind::If { condition, then, otherwise } => {
                    self.name = "compared".to_owned();
                    let condition = self.scalar(frame, env, condition)?;
                    if let Some(known) = literal(&condition) {
                        let block = if known != 0 { then } else { otherwise };
                        return self.run(frame, env, &block.0, Some(&tail), stop);
                    }
                    let blocks = [then, otherwise];
                    let test = Some(condition.clone());
                    let write = |mut sides: Vec<Block>| {
                        let otherwise = sides.pop().unwrap_or_default();
                        let then = sides.pop().unwrap_or_default();
                        StmtKind::If { condition, then, otherwise }
                    };
                    let of = (test, stmt.span);
                    return self.choose(frame, env, &blocks, &tail, stop, of, write);
                }
                StmtKind::Match { scrutinee, arms, otherwise } => {
                    let scrutinee = self.scalar(frame, env, scrutinee)?;
                    let empty = Block::default();
                    let last = otherwise.as_ref().unwrap_or(&empty);
                    if let Some(known) = literal(&scrutinee) {
                        let arm = arms.iter().find(|arm| arm.values.contains(&known));
                        let block = arm.map_or(last, |arm| &arm.body);
                        return self.run(frame, env, &block.0, Some(&tail), stop);
                    }
                    let mut blocks: Vec<&Block> = arms.iter().map(|arm| &arm.body).collect();
                    blocks.extend(otherwise);
                    let write = |mut sides: Vec<Block>| {
                        let otherwise = otherwise.as_ref().and_then(|_| sides.pop());
                        let arms = arms.iter().zip(sides).map(|(arm, body)| bessemer_ir::Arm {
                            values: arm.values.clone(),
                            body,
                        });
                        StmtKind::Match { scrutinee, arms: arms.collect(), otherwise }
                    };
                    let of = (None, stmt.span);
                    return self.choose(frame, env, &blocks, &tail, stop, of, write);
                }
                StmtKind::For { variable, from, to, inclusive, reversed, body, ended, .. } => {
                    let from = self.scalar(frame, env, from)?;
                    let to = self.scalar(frame, env, to)?;
                    let values = match (literal(&from), literal(&to)) {
                        (Some(first), Some(last)) => {
                            self.values((first, last), (*inclusive, *reversed), &from, env.passes)
                        }
                        _ => None,
                    };
                    if let Some(values) = values.filter(|_| !ended) {
                        let count = values.len().max(1) as u64;
                        env.passes *= count;
                        let end = node(What::End(count), Some(&tail));
                        let unrolled = Unrolled { variable: *variable, values: &values, body };
                        let first = node(What::Pass(unrolled, 0), Some(&end));
                        return self.go_on(frame, env, Some(&first), stop);
                    }
                    self.kept(frame, env, &stmt.kind, (from, to), stmt.span)?;
                }
                StmtKind::Let { local, value } => {
                    let declared = frame.function.local(*local);
                    self.name.clone_from(&declared.name);
                    match value {
                        Some(Expr { kind: bessemer_ir::ExprKind::Load(place), .. })
                            if declared.mode == Mode::RefMut =>
                        {
                            let route = self.route(frame, env, place)?;
                            env.aliases.insert(*local, route);
                        }
                        Some(value) => {
                            let value = self.value(frame, env, value)?;
                            let value = self.held(value, &declared.name);
                            env.aliases.remove(local);
                            env.locals.insert(*local, value);
                        }
                        None => {
                            env.locals.remove(local);
                        }
                    }
                }
                StmtKind::Assign { place, value } => {
                    let name = frame.function.local(place.root).name.clone();
                    self.name.clone_from(&name);
                    let value = self.value(frame, env, value)?;
                    let route = self.route(frame, env, place)?;
                    let name =
                        self.named(name, &frame.function.local(place.root).ty, place, &route);
                    let value = self.held(value, &name);
                    self.write(env, &route, value, stmt.span)?;
                }
                StmtKind::Expr(expr) => {
                    self.value(frame, env, expr)?;
                }
                StmtKind::Check { condition, fault } => {
                    let condition = self.scalar(frame, env, condition)?;
                    match literal(&condition) {
                        Some(0) => {
                            return Err(Problem::new(stmt.span, "this always fails", "correct it"));
                        }
                        Some(_) => {}
                        None => self.emit(StmtKind::Check { condition, fault: *fault }, stmt.span),
                    }
                }
            }
        }
        self.go_on(frame, env, rest, stop)
    }

    /// Goes on with the rest of a path, up to the node at depth `stop`.
    fn go_on(
        &mut self,
        frame: Frame<'_>,
        env: &mut Env,
        rest: Rest<'_>,
        stop: usize,
    ) -> Result<()> {
        let Some(next) = rest.filter(|node| node.depth > stop) else { return Ok(()) };
        match next.what {
            What::Stmts(stmts) => self.run(frame, env, stmts, next.next, stop),
            What::End(passes) => {
                env.passes /= passes;
                self.go_on(frame, env, next.next, stop)
            }
            What::Pass(unrolled, index) => {
                let Some(value) = unrolled.values.get(index) else {
                    return self.go_on(frame, env, next.next, stop);
                };
                let counter = Value::Leaf(Word::constant(value.clone()));
                env.locals.insert(unrolled.variable, counter);
                let following = node(What::Pass(unrolled, index + 1), next.next);
                self.run(frame, env, &unrolled.body.0, Some(&following), stop)
            }
        }
    }

    /// Leaves a loop, or a pass of it.
    fn leave(
        &mut self,
        frame: Frame<'_>,
        env: &mut Env,
        leave: Leave,
        rest: Rest<'_>,
        stop: usize,
    ) -> Result<()> {
        match target(leave, rest) {
            Some(node) => self.go_on(frame, env, Some(node), stop),
            None => {
                self.write_back(frame, env)?;
                env.ended = true;
                let kind = match leave {
                    Leave::Break => StmtKind::Break,
                    _ => StmtKind::Continue,
                };
                self.emit(kind, Span::default());
                Ok(())
            }
        }
    }

    /// Evaluates the sides of a branch, joins them and goes on.
    #[allow(clippy::too_many_arguments)]
    fn choose(
        &mut self,
        frame: Frame<'_>,
        env: &mut Env,
        blocks: &[&Block],
        tail: &Node<'_>,
        stop: usize,
        (condition, span): (Option<Expr>, Span),
        write: impl FnOnce(Vec<Block>) -> StmtKind,
    ) -> Result<()> {
        let mut leaves = Leaves::default();
        blocks.iter().for_each(|block| leaves.block(block));
        let meeting = meeting(leaves, tail);
        let name = self.name.clone();
        let branch = Branch { condition, locals: self.locals.len(), span };
        let mut sides = Vec::new();
        for block in blocks {
            let mut side = env.clone();
            self.name.clone_from(&name);
            let written = self.captured(|run| {
                run.run(frame, &mut side, &block.0, Some(tail), depth(meeting))?;
                if meeting.is_none() && frame.carried.is_some() && !side.ended {
                    run.write_back(frame, &mut side)?;
                    side.ended = true;
                }
                Ok(())
            })?;
            sides.push((written.0, side));
        }
        *env = self.join(frame, env, sides, &branch, write)?;
        if env.ended {
            return Ok(());
        }
        self.go_on(frame, env, meeting, stop)
    }
}

/// Returns the node behind a branch where all its sides meet; none for the end of the function. Statements before that node
/// may lead further.
fn meeting<'n>(mut leaves: Leaves, tail: &'n Node<'n>) -> Rest<'n> {
    loop {
        let meeting: Rest<'_> = if leaves.returns {
            None
        } else if leaves.breaks {
            target(Leave::Break, Some(tail))
        } else if leaves.continues {
            target(Leave::Continue, Some(tail))
        } else {
            Some(tail)
        };
        let before = (leaves.returns, leaves.breaks);
        let mut next = Some(tail).filter(|_| meeting.is_some());
        while let Some(node) = next.filter(|node| node.depth > depth(meeting)) {
            match node.what {
                What::Stmts(stmts) => stmts.iter().for_each(|stmt| leaves.stmt(stmt)),
                What::Pass(unrolled, _) => {
                    let mut inner = Leaves { loops: 1, ..Leaves::default() };
                    inner.block(unrolled.body);
                    leaves.returns |= inner.returns;
                }
                What::End(_) => {}
            }
            next = node.next;
        }
        if (leaves.returns, leaves.breaks) == before {
            return meeting;
        }
    }
}

/// Returns the node to which a leaving statement leads; none for the loop that is written, or the function.
fn target<'n>(leave: Leave, mut rest: Rest<'n>) -> Rest<'n> {
    while let Some(node) = rest {
        match (leave, node.what) {
            (Leave::Break, What::End(_)) | (Leave::Continue, What::Pass(..)) => return Some(node),
            _ => rest = node.next,
        }
    }
    None
}

/// Ways to leave a block that lead out of it.
#[derive(Default)]
struct Leaves {
    returns: bool,
    breaks: bool,
    continues: bool,
    loops: usize,
}

impl Visit for Leaves {
    fn stmt(&mut self, stmt: &Stmt) {
        match stmt.kind {
            StmtKind::Return(_) => self.returns = true,
            StmtKind::Break => self.breaks |= self.loops == 0,
            StmtKind::Continue => self.continues |= self.loops == 0,
            StmtKind::For { .. } => {
                self.loops += 1;
                visit::walk_stmt(self, stmt);
                self.loops -= 1;
            }
            _ => visit::walk_stmt(self, stmt),
        }
    }
}
