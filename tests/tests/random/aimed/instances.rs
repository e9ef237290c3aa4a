//! The instances of a text without rustc. It compiles one function of the constants, or one instance and one arm of the
//! selector, which takes a tenth of the time.
//!
//! Invariant: what is made here is what rustc makes of the whole text. Batches that rustc gets as a whole hold it.

use std::collections::BTreeMap;

use bessemer_ir::tree::visit::{self, Visit, VisitMut};
use bessemer_ir::tree::{Argument, Arm, Callee, Expr, ExprKind, Function, Package, Pattern};

use super::super::writer::Program;

/// The text as a function of the constants, in which it is generic: the selector takes them from a table.
pub fn with_constants_as_arguments(program: &Program) -> String {
    let all = constants(program);
    let Some(first) = all.first() else { return program.text.clone() };
    let (name, declared) = (&program.name, format!("{}_of<", program.name));
    let table = format!("{}_CONSTANTS", name.to_uppercase());
    let given = (0..first.len()).map(|at| format!("{table}[which as usize][{at}], "));
    let given: String = given.collect();
    let arm = |after: &str| format!("0..{} => {name}_of({given}{after}", all.len());
    let text = changed(&with_one_arm(program, arm), |line| {
        let (before, rest) = line.split_once(&declared)?;
        let (constants, after) = rest.split_once(">(").expect("constants, then parameters");
        Some(format!("{before}{name}_of({}, {after}", constants.replace("const ", "")))
    });
    format!("{text}const {table}: [[usize; {}]; {}] = {all:?};\n", first.len(), all.len())
}

/// The text with its first instance alone.
pub fn of_first_instance(program: &Program) -> String {
    let Some(first) = constants(program).into_iter().next() else { return program.text.clone() };
    with_one_arm(program, |after| format!("0 => {}{}>({after}", given(program), text(&first)))
}

/// Puts the instances into the tree of a text that has its first one alone.
pub fn instantiate(package: &mut Package, program: &Program) {
    let constants = constants(program);
    let Some(first) = place(package, program, constants.first()) else { return };
    let (mut made, mut arms) = (BTreeMap::new(), Arms { of: None, paths: Vec::new(), from: 0 });
    for constants in &constants {
        let one = instance(&package.functions[first], constants);
        arms.paths.push(one.path.clone());
        made.insert(one.path.clone(), one);
    }
    made.remove(&arms.paths[0]);
    let selector = package.functions.iter_mut().find(|it| it.tree.name == program.name);
    let selector = selector.expect("it calls its instances");
    let is_first = |it: &Callee| matches!(it, Callee::Function(path) if *path == arms.paths[0]);
    arms.of = selector.callees.iter().position(is_first).map(|at| at as u32);
    arms.from = selector.callees.len() as u32;
    arms.block(&mut selector.tree.body);
    selector.callees.extend(arms.paths.drain(1..).map(Callee::Function));
    package.functions.splice(first + 1..first + 1, made.into_values());
}

/// Writes the arms of a selector that has the first one alone.
struct Arms {
    /// The place of its callee.
    of: Option<u32>,
    /// The instances.
    paths: Vec<String>,
    /// The place of the second one's callee.
    from: u32,
}

impl VisitMut for Arms {
    fn expr(&mut self, expr: &mut Expr) {
        if let ExprKind::Match(_, arms) = &mut expr.kind
            && let Some(first) = arms.first().filter(|arm| self.is_first(arm)).cloned()
        {
            let others = (1..self.paths.len() as u32).map(|at| {
                let mut arm = first.clone();
                if let Pattern::Value(Expr { kind: ExprKind::Int(digits, _), .. }) =
                    &mut arm.pattern
                {
                    *digits = at.to_string();
                }
                if let ExprKind::Call(callee, _) = &mut arm.body.kind {
                    *callee = self.from + at - 1;
                }
                arm
            });
            arms.splice(1..1, others.collect::<Vec<_>>());
        }
    }
}

impl Arms {
    fn is_first(&self, arm: &Arm) -> bool {
        matches!(arm.body.kind, ExprKind::Call(callee, _) if Some(callee) == self.of)
    }
}

/// Checks that rustc's instances equal those made here.
pub fn hold(package: &Package, program: &Program) {
    let constants = constants(program);
    let Some(first) = place(package, program, constants.first()) else { return };
    for constants in &constants {
        let made = instance(&package.functions[first], constants);
        let Some(of_rustc) = package.functions.iter().find(|it| it.path == made.path) else {
            panic!("{} is no instance of rustc's", made.path)
        };
        assert_eq!(of_rustc, &made);
    }
}

fn given(program: &Program) -> String {
    format!("{}_of::<", program.name)
}

/// The text with another line in place of each that is changed.
fn changed(text: &str, mut change: impl FnMut(&str) -> Option<String>) -> String {
    text.lines().map(|line| change(line).unwrap_or_else(|| line.to_owned()) + "\n").collect()
}

/// The text with this arm of its selector, which gets the arguments behind the constants; the lines of the others are empty.
fn with_one_arm(program: &Program, arm: impl Fn(&str) -> String) -> String {
    let (given, mut is_first) = (given(program), true);
    changed(&program.text, |line| {
        let (_, rest) = line.split_once(&given)?;
        let (_, after) = rest.split_once(">(").expect("constants, then arguments");
        Some(if std::mem::take(&mut is_first) { arm(after) } else { String::new() })
    })
}

fn text(constants: &[u64]) -> String {
    constants.iter().map(u64::to_string).collect::<Vec<_>>().join(", ")
}

/// The constants of each instance, in the order of the selector's arms.
fn constants(program: &Program) -> Vec<Vec<u64>> {
    let mark = given(program);
    let given = program.text.lines().filter_map(|line| line.split_once(&mark)?.1.split_once(">("));
    given.map(|(all, _)| all.split(", ").filter_map(|it| it.parse().ok()).collect()).collect()
}

fn place(package: &Package, program: &Program, first: Option<&Vec<u64>>) -> Option<usize> {
    let path = format!("{}_of<{}>", program.name, text(first?));
    package.functions.iter().position(|it| it.path.ends_with(&path))
}

/// The instance of these constants, from one of others.
fn instance(of: &Function, constants: &[u64]) -> Function {
    let mut one = of.clone();
    let (head, _) = one.path.split_once('<').expect("it is generic");
    one.path = format!("{head}<{}>", text(constants));
    let mut words = BTreeMap::new();
    for ((name, argument), word) in one.generics.iter_mut().zip(constants) {
        if let Argument::Number(_, number) = argument {
            *number = *word;
        }
        words.insert(name.clone(), *word);
    }
    for (argument, word) in one.suffix.iter_mut().zip(constants) {
        if let Argument::Number(_, number) = argument {
            *number = *word;
        }
    }
    let mut paths = Paths(BTreeMap::new());
    paths.block(&one.tree.body);
    for (at, name) in paths.0 {
        if let Some(word) = words.get(&name) {
            one.constants[at as usize].words = vec![*word];
        }
    }
    one
}

/// The paths of a text that are constants, by their places among these.
struct Paths(BTreeMap<u32, String>);

impl Visit for Paths {
    fn expr(&mut self, expr: &Expr) {
        if let ExprKind::Path(at, name) = &expr.kind {
            self.0.insert(*at, name.clone());
        }
        visit::walk_expr(self, expr);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::aimed::{ANY, POSITIVE, program};
    use bessemer_tests::random::Random;

    #[test]
    fn constants_become_arguments_where_they_are_declared_and_given() {
        let program = program(&mut Random(5), "aimed5_0", 3);
        let text = with_constants_as_arguments(&program);
        let constants = ANY.iter().chain(&POSITIVE).map(|name| format!("{name}: usize, "));
        let declared = format!("fn aimed5_0_of({}mut a:", constants.collect::<String>());
        assert!(text.contains(&declared), "{text}");
        assert_eq!(text.matches("0..3 => aimed5_0_of(AIMED5_0_CONSTANTS[").count(), 1, "{text}");
        assert!(!text.contains("_of<") && !text.contains("_of::<"), "{text}");
        assert_eq!(text.lines().count(), program.text.lines().count() + 1);
    }

    #[test]
    fn the_first_instance_stands_alone() {
        let program = program(&mut Random(5), "aimed5_0", 3);
        let all = constants(&program);
        assert_eq!((all.len(), all[0].len()), (3, ANY.len() + POSITIVE.len()));
        let text = of_first_instance(&program);
        let first = format!("0 => aimed5_0_of::<{}>(", super::text(&all[0]));
        assert_eq!(
            (text.matches(&first).count(), text.matches("_of::<").count()),
            (1, 1),
            "{text}"
        );
        assert_eq!(text.lines().count(), program.text.lines().count());
    }
}
