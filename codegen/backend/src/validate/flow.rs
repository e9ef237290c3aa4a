//! Data flow of a function's locals: declared, in scope, assigned.
//!
//! Invariant: at an unreachable point every local counts as assigned, so the join of paths is "and".

use bessemer_ir::{Function, LocalId, Mode};

use super::problem::Problem;

/// Locals of a function at the present point.
pub(super) struct Flow {
    declared: Vec<bool>,
    visible: Vec<bool>,
    counters: Vec<bool>,
    references: Vec<bool>,
    assigned: Vec<bool>,
}

impl Flow {
    /// Returns the state at the beginning: parameters are declared and assigned.
    pub fn new(function: &Function) -> Flow {
        let count = function.locals.len();
        let params: Vec<bool> = (0..count).map(|index| index < function.params as usize).collect();
        Flow {
            declared: params.clone(),
            visible: params.clone(),
            counters: vec![false; count],
            references: function.locals.iter().map(|local| local.mode == Mode::Ref).collect(),
            assigned: params,
        }
    }

    /// Declares a local by a `let`, or as the variable of a `for`.
    pub fn declare(&mut self, id: LocalId, assigned: bool, counter: bool) -> Result<(), Problem> {
        let index = id.index();
        match self.declared.get(index) {
            None => return Err(Problem::UnknownLocal(id)),
            Some(true) => return Err(Problem::DeclaredTwice(id)),
            Some(false) => {}
        }
        self.declared[index] = true;
        self.visible[index] = true;
        self.counters[index] = counter;
        self.assigned[index] = assigned;
        Ok(())
    }

    /// Ends the scope of these locals, at the end of their block.
    pub fn forget(&mut self, ids: &[LocalId]) {
        for id in ids {
            self.visible[id.index()] = false;
        }
    }

    /// Checks a use that needs the local's value.
    pub fn read(&self, id: LocalId) -> Result<(), Problem> {
        self.see(id)?;
        if self.assigned[id.index()] { Ok(()) } else { Err(Problem::NotAssigned(id)) }
    }

    /// Checks a write to the whole local, or to a part of it.
    pub fn write(&mut self, id: LocalId, whole: bool) -> Result<(), Problem> {
        self.see(id)?;
        if self.references[id.index()] {
            return Err(Problem::WrittenReference(id));
        }
        if self.counters[id.index()] {
            return Err(Problem::WrittenCounter(id));
        }
        if !whole {
            return self.read(id);
        }
        self.assigned[id.index()] = true;
        Ok(())
    }

    fn see(&self, id: LocalId) -> Result<(), Problem> {
        match self.visible.get(id.index()) {
            None => Err(Problem::UnknownLocal(id)),
            Some(false) => Err(Problem::NotInScope(id)),
            Some(true) => Ok(()),
        }
    }

    /// Returns the locals that are assigned here.
    pub fn assigned(&self) -> Vec<bool> {
        self.assigned.clone()
    }

    /// Restores the assigned locals of an earlier point.
    pub fn rewind(&mut self, assigned: Vec<bool>) {
        self.assigned = assigned;
    }

    /// Marks the following statements as unreachable.
    pub fn diverge(&mut self) {
        self.assigned.fill(true);
    }
}

/// Returns the locals that are assigned where two paths meet.
pub(super) fn join(mut one: Vec<bool>, other: &[bool]) -> Vec<bool> {
    for (one, other) in one.iter_mut().zip(other) {
        *one &= other;
    }
    one
}
