//! Functions of gcc's assembly for ARM: instructions in blocks, their successors, calls, and lines of the C.
//!
//! Invariant: a jump whose targets the text does not name makes the whole function unknown.

use std::collections::{BTreeMap, BTreeSet};

/// A function.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Function {
    /// Its name.
    pub name: String,
    /// Blocks in the order of the text; the first is the entry.
    pub blocks: Vec<Block>,
    /// Reason why its paths are not known.
    pub unknown: Option<String>,
}

/// Instructions that are executed one after the other.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Block {
    /// The instructions.
    pub instructions: Vec<Instruction>,
    /// Blocks that may follow.
    pub next: Vec<usize>,
    /// True if the function may be left behind it.
    pub leaves: bool,
}

/// An instruction.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Instruction {
    /// Mnemonic and operands.
    pub text: String,
    /// File and line of the C.
    pub place: Option<(String, u32)>,
    /// Effect on the order of execution.
    pub step: Step,
    /// Constant in `r2` at a call: the third argument, such as the bytes of `memcpy`.
    pub bytes: Option<u64>,
    /// True if `r2` and `r3` are zero at a call: the second argument, if that is a double.
    pub zero: bool,
}

/// Effect of an instruction on the order of execution.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Step {
    /// The next instruction follows.
    Next,
    /// A function is called, then the next instruction follows.
    Call(String),
    /// One of these labels follows; the next instruction too, if `falls`.
    Jump {
        /// The labels.
        to: Vec<String>,
        /// True if the next instruction may follow.
        falls: bool,
    },
    /// The function is left; under a condition if `falls`.
    Leave {
        /// True if the next instruction may follow.
        falls: bool,
    },
}

/// Text of one function with its labels and tables of jumps.
#[derive(Default)]
struct Raw {
    name: String,
    instructions: Vec<(String, Option<(String, u32)>)>,
    labels: BTreeMap<String, usize>,
    tables: BTreeMap<String, Vec<String>>,
}

/// Returns the functions of a text.
pub fn functions(text: &str) -> Vec<Function> {
    let (mut done, mut raw): (Vec<Function>, Option<Raw>) = (Vec::new(), None);
    let mut files: BTreeMap<&str, String> = BTreeMap::new();
    let (mut place, mut name, mut label) = (None, "", String::new());
    for line in text.lines() {
        let code = line.split('@').next().unwrap_or_default().trim_end();
        if let Some(of) = code.strip_suffix(':').filter(|it| !it.starts_with([' ', '\t'])) {
            if of == name {
                raw = Some(Raw { name: of.to_owned(), ..Raw::default() });
            } else if let Some(raw) = &mut raw {
                raw.labels.insert(of.to_owned(), raw.instructions.len());
                of.clone_into(&mut label);
            }
            continue;
        }
        let words: Vec<&str> = code.split_whitespace().collect();
        match words[..] {
            [] => {}
            [".file", number, path] => {
                let file = path.trim_matches('"').rsplit('/').next().unwrap_or_default();
                files.insert(number, file.to_owned());
            }
            [".loc", number, line, ..] => {
                place = files.get(number).cloned().zip(line.parse().ok());
            }
            [".type", of, "%function"] => name = of.trim_end_matches(','),
            [".size", of, ..] => {
                if raw.as_ref().is_some_and(|raw| of.trim_end_matches(',') == raw.name) {
                    done.extend(raw.take().map(Raw::function));
                }
            }
            [".word" | ".byte" | ".2byte" | ".short" | ".hword", ..] => {
                if let Some(raw) = &mut raw {
                    let rest = code.trim_start().split_once('\t').map_or("", |it| it.1);
                    let first = rest.trim_start_matches('(');
                    let end = first.find(|it: char| it != '.' && !it.is_alphanumeric());
                    let target = &first[..end.unwrap_or(first.len())];
                    if target.starts_with(".L") {
                        raw.tables.entry(label.clone()).or_default().push(target.to_owned());
                    }
                }
            }
            [first, ..] if first.starts_with('.') => {}
            _ => {
                if let Some(raw) = raw.as_mut().filter(|_| line.starts_with('\t')) {
                    raw.instructions.push((words.join(" "), place.clone()));
                }
            }
        }
    }
    done
}

/// Conditions of ARM.
const CONDITIONS: [&str; 16] = [
    "eq", "ne", "cs", "hs", "cc", "lo", "mi", "pl", "vs", "vc", "hi", "ls", "ge", "lt", "gt", "le",
];

/// Returns the mnemonic without a condition and a width, and true if it has a condition.
fn mnemonic<'t>(text: &'t str, plain: &[&'static str]) -> (&'t str, bool) {
    let word = text.split(' ').next().unwrap_or_default();
    let word = word.split('.').next().unwrap_or_default();
    if plain.contains(&word) {
        return (word, false);
    }
    match word.len().checked_sub(2).and_then(|at| word.split_at_checked(at)) {
        Some((stem, end)) if CONDITIONS.contains(&end) && plain.contains(&stem) => (stem, true),
        _ => (word, false),
    }
}

/// Registers of arguments, and those that a call leaves as they are.
const REGISTERS: [&str; 12] =
    ["r0", "r1", "r2", "r3", "r4", "r5", "r6", "r7", "r8", "r9", "r10", "fp"];

/// Mnemonics that change the order of execution.
const JUMPS: [&str; 14] = [
    "b", "bl", "bx", "blx", "cbz", "cbnz", "tbb", "tbh", "ldr", "ldm", "ldmfd", "ldmia", "pop",
    "mov",
];

impl Raw {
    /// Returns the effect of an instruction; an error if it has unknown targets.
    fn step(&self, at: usize, in_it: bool) -> Result<Step, String> {
        let text = &self.instructions[at].0;
        let (word, conditional) = mnemonic(text, &JUMPS);
        let falls = conditional || in_it;
        let operands = text.split_once(' ').map_or("", |it| it.1);
        let unknown = || format!("unknown targets of `{text}`");
        let callee = |name: &str| name.trim_end_matches("(PLT)").to_owned();
        Ok(match word {
            "b" if operands.starts_with(".L") => {
                Step::Jump { to: vec![operands.to_owned()], falls }
            }
            // The callee returns to the caller of this function.
            "b" if falls => return Err(unknown()),
            "b" | "bl" => Step::Call(callee(operands)),
            "bx" if operands == "lr" => Step::Leave { falls },
            "bx" if !falls => Step::Jump { to: self.table(at).ok_or_else(unknown)?, falls },
            "bx" | "blx" => return Err(unknown()),
            "cbz" | "cbnz" => {
                let to = operands.rsplit(' ').next().unwrap_or_default().to_owned();
                Step::Jump { to: vec![to], falls: true }
            }
            "tbb" | "tbh" => Step::Jump { to: self.table(at).ok_or_else(unknown)?, falls: false },
            "ldr" if operands.starts_with("pc, [sp]") => Step::Leave { falls },
            "ldr" if operands.starts_with("pc,") => {
                // `ldrls pc, [pc, …]` is followed by the jump to the default.
                Step::Jump { to: self.table(at).ok_or_else(unknown)?, falls: conditional }
            }
            "pop" | "ldm" | "ldmfd" | "ldmia" if is_in_list(operands, "pc") => {
                Step::Leave { falls }
            }
            "mov" if operands == "pc, lr" => Step::Leave { falls },
            _ if operands.starts_with("pc,") => return Err(unknown()),
            _ => Step::Next,
        })
    }

    /// Returns the table of jumps that follows an instruction, if necessary behind one more jump.
    fn table(&self, at: usize) -> Option<Vec<String>> {
        let mut labels = self.labels.iter().filter(|(_, place)| (at + 1..=at + 2).contains(place));
        labels.find_map(|(label, _)| self.tables.get(label).cloned())
    }

    /// Returns the constant in `r2` before a call: the last one in the text, possibly by way of another register.
    fn bytes(&self, at: usize) -> Option<u64> {
        if !matches!(self.step(at, false), Ok(Step::Call(_))) {
            return None;
        }
        let mut register = "r2";
        for (text, _) in self.instructions[..at].iter().rev() {
            let Some((word, operands)) = text.split_once(' ') else { continue };
            if word.starts_with("bl") && register == "r2" {
                return None;
            }
            let Some((written, value)) = operands.split_once(", ") else { continue };
            // A store and a comparison write no register, and a load of two writes both.
            let reads = ["str", "cmp", "cmn", "tst", "cb"].iter().any(|it| word.starts_with(it));
            if reads || written != register {
                continue;
            }
            if !matches!(word, "mov" | "movs" | "movw" | "mov.w") {
                return None;
            }
            match value.strip_prefix('#') {
                Some(number) => return number.parse().ok(),
                None => register = value,
            }
        }
        None
    }

    /// Returns true if both `r2` and `r3` are zero before a call, by instructions of its block that begins at an index.
    fn is_zero(&self, block: usize, at: usize) -> bool {
        matches!(self.step(at, false), Ok(Step::Call(_)))
            && ["r2", "r3"].iter().all(|it| self.is_zeroed(block, at, it))
    }

    fn is_zeroed(&self, block: usize, at: usize, register: &'static str) -> bool {
        let mut register = register;
        for (text, _) in self.instructions[block..at].iter().rev() {
            let (word, operands) = text.split_once(' ').unwrap_or((text, ""));
            let (first, value) = operands.split_once(", ").unwrap_or((operands, ""));
            let is_move = matches!(word, "mov" | "movs" | "mov.w" | "movw");
            if is_move && first == register {
                match REGISTERS.iter().find(|it| **it == value) {
                    Some(source) => register = source,
                    None => return value == "#0",
                }
                continue;
            }
            // A call leaves r4 and those above, and a load of two writes the register behind the named one, too.
            let place = |name: &str| REGISTERS.iter().position(|it| *it == name);
            let called = word.starts_with("bl") && place(register) < Some(4);
            let loaded =
                word.starts_with("ldrd") && place(register) == place(first).map(|it| it + 1);
            let named = operands.split(|it: char| !it.is_alphanumeric()).any(|it| it == register);
            let range = operands.contains("-r");
            if called || loaded || range || named && !is_move {
                return false;
            }
        }
        false
    }

    fn function(self) -> Function {
        let mut steps = Vec::new();
        let mut left_of_it = 0;
        let mut unknown = None;
        for at in 0..self.instructions.len() {
            let word = self.instructions[at].0.split(' ').next().unwrap_or_default();
            let in_it = left_of_it > 0;
            left_of_it = if is_it(word) { word.len() - 1 } else { left_of_it.saturating_sub(1) };
            match self.step(at, in_it) {
                // A call in the place of a return.
                Ok(Step::Call(callee)) if is_tail(&self.instructions[at].0) => {
                    steps.push((Step::Call(callee), true));
                }
                Ok(step) => steps.push((step, false)),
                Err(why) => {
                    unknown.get_or_insert(why);
                    steps.push((Step::Next, false));
                }
            }
        }
        // Blocks begin at labels and behind jumps.
        let ends =
            |(step, tail): &(Step, bool)| *tail || !matches!(step, Step::Next | Step::Call(_));
        let mut starts: BTreeSet<usize> = self.labels.values().copied().collect();
        starts.insert(0);
        starts.extend(steps.iter().enumerate().filter(|(_, it)| ends(it)).map(|(at, _)| at + 1));
        let starts: Vec<usize> = starts.into_iter().filter(|it| *it < steps.len()).collect();
        let block_at = |place: usize| starts.binary_search(&place).ok();
        let mut blocks = Vec::new();
        for (number, start) in starts.iter().enumerate() {
            let end = starts.get(number + 1).copied().unwrap_or(steps.len());
            let instructions = (*start..end).map(|at| {
                let (text, place) = self.instructions[at].clone();
                let (step, bytes) = (steps[at].0.clone(), self.bytes(at));
                Instruction { text, place, step, bytes, zero: self.is_zero(*start, at) }
            });
            let following = block_at(end);
            let mut next: Vec<usize> = Vec::new();
            match &steps[end - 1] {
                (_, true) | (Step::Leave { falls: false }, _) => {}
                (Step::Next | Step::Call(_) | Step::Leave { falls: true }, _) => {
                    next.extend(following)
                }
                (Step::Jump { to, falls }, _) => {
                    for label in to {
                        match self.labels.get(label).and_then(|place| block_at(*place)) {
                            Some(block) => next.push(block),
                            None => {
                                unknown.get_or_insert(format!("no label `{label}`"));
                            }
                        }
                    }
                    next.extend(following.filter(|_| *falls));
                }
            }
            next.sort_unstable();
            next.dedup();
            let leaves = steps[end - 1].1 || matches!(steps[end - 1].0, Step::Leave { .. });
            blocks.push(Block { instructions: instructions.collect(), next, leaves });
        }
        Function { name: self.name, blocks, unknown }
    }
}

/// Returns true for `it`, `ite`, `itt` and longer ones, on which up to four instructions depend.
fn is_it(word: &str) -> bool {
    word.strip_prefix("it")
        .is_some_and(|rest| rest.len() <= 3 && rest.chars().all(|it| matches!(it, 't' | 'e')))
}

fn is_tail(text: &str) -> bool {
    matches!(text.split(' ').next(), Some("b" | "b.w"))
}

fn is_in_list(operands: &str, register: &str) -> bool {
    operands.split(['{', '}', ',', ' ']).any(|it| it == register)
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "\
\t.file 1 \"/x/a.c\"\n\t.type\tf, %function\nf:\n\t.loc 1 3 5\n\tpush\t{r4, lr}\n\tcbz\tr0, .L2\n.L3:\n\t.loc 1 4 5\n\tmovs\tr5, #24\n\tmov\tr2, r5\n\tbl\tmemcpy(PLT)\n\
\tsubs\tr4, r4, #1\n\tbne\t.L3\n.L2:\n\tcmp\tr0, #1\n\tit\teq\n\tpopeq\t{r4, pc}\n\tb\tg\n\t.size\tf, .-f\n";

    #[test]
    fn blocks_calls_and_lines_are_read() {
        let functions = functions(TEXT);
        let [f] = &functions[..] else { panic!("one function") };
        assert_eq!((f.name.as_str(), f.unknown.as_deref()), ("f", None));
        let next: Vec<&[usize]> = f.blocks.iter().map(|it| &*it.next).collect();
        assert_eq!(next, [&[1, 2][..], &[1, 2], &[3], &[]]);
        let call = &f.blocks[1].instructions[2];
        assert_eq!((call.step.clone(), call.bytes), (Step::Call("memcpy".to_owned()), Some(24)));
        assert_eq!(call.place, Some(("a.c".to_owned(), 4)));
        let leaves: Vec<bool> = f.blocks.iter().map(|it| it.leaves).collect();
        assert_eq!(leaves, [false, false, true, true]);
        assert_eq!(f.blocks[3].instructions[0].step, Step::Call("g".to_owned()));
    }

    #[test]
    fn zeros_of_the_same_block_are_known() {
        let is_zero = |before: &str| {
            let text = format!(
                "\t.type\tf, %function\nf:\n{before}\tbl\t__aeabi_dadd\n\tbx\tlr\n\t.size\tf, .-f\n"
            );
            let f = functions(&text).remove(0);
            let all = f.blocks.iter().flat_map(|it| &it.instructions);
            let mut calls = all.filter(|it| matches!(it.step, Step::Call(_)));
            calls.next_back().is_some_and(|it| it.zero)
        };
        assert!(is_zero("\tmovs\tr2, #0\n\tmovs\tr3, #0\n\tldrd\tr0, [r4, #88]\n"));
        assert!(is_zero("\tmovs\tr4, #0\n\tbl\tg\n\tmov\tr2, r4\n\tmov\tr3, r4\n"));
        for other in [
            "\tmovs\tr3, #0\n",
            "\tmovs\tr2, #0\n\tmovs\tr3, #1\n",
            "\tmovs\tr2, #0\n\tmovs\tr3, #0\n\tbl\tg\n",
            "\tmovs\tr2, #0\n\tmovs\tr3, #0\n.L1:\n",
            "\tmovs\tr2, #0\n\tmovs\tr3, #0\n\tldrd\tr2, [r4]\n",
            "\tmovs\tr2, #0\n\tmovs\tr3, #0\n\tit\teq\n\tmoveq\tr3, r5\n",
            "\tmovs\tr2, #0\n\tmovs\tr3, #0\n\tstr\tr0, [r3], #8\n",
            "\tmovs\tr4, #0\n\tadds\tr4, r4, #1\n\tmov\tr2, r4\n\tmov\tr3, r4\n",
        ] {
            assert!(!is_zero(other), "{other}");
        }
    }

    #[test]
    fn tables_of_jumps_are_read_and_unknown_jumps_are_named() {
        let table = "\t.type\tf, %function\nf:\n\ttbb\t[pc, r0]\n.L4:\n\t.byte\t(.L6-.L4)/2\n\t.byte\t(.L5-.L4)/2\n.L6:\n\tbx\tlr\n.L5:\n\tmov\tpc, r3\n\t.size\tf, .-f\n";
        let found = functions(table).remove(0);
        assert_eq!(found.blocks[0].next, [1, 2]);
        assert_eq!(found.unknown.as_deref(), Some("unknown targets of `mov pc, r3`"));
        let wide = "\t.type\tf, %function\nf:\n\tldrls\tpc, [pc, r3, asl #2]\n\tb\t.L5\n.L4:\n\t.word\t.L6\n.L6:\n\tbx\tlr\n.L5:\n\tblx\tr3\n\t.size\tf, .-f\n";
        let found = functions(wide).remove(0);
        assert_eq!(found.blocks[0].next, [1, 2]);
        assert_eq!(found.unknown.as_deref(), Some("unknown targets of `blx r3`"));
    }
}
