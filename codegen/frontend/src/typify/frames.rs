//! The loops and blocks around the code that is being lowered, and the ways to leave them.
//!
//! Invariant: a frame is left from within, so its index is less than the number of frames.
//!
//! Must not know: how anything is lowered.

use bessemer_ir::tree::Site;
use bessemer_ir::{LocalId, Place, StmtKind};

use super::{Needed, Result, marks};

#[cfg(test)]
mod tests;

/// Destination of a value.
#[derive(Clone)]
pub(super) enum Target {
    /// Assignment to a place.
    Place(Place),
    /// The result of the function.
    Return,
}

/// A loop or a labelled block that is being lowered, or one body for several loops.
pub(super) struct Frame {
    pub label: Option<String>,
    /// Destination of the value of a `break`.
    pub target: Option<Target>,
    /// For a block: the local whose declaration marks an exit ([`labelled`](super::labelled)).
    pub mark: Option<LocalId>,
    /// For a body of several loops: the index of the outermost frame, which a `break` leaves.
    pub outermost: Option<usize>,
    /// True for a body that runs at most once: `break` and `continue` leave it.
    pub pass: bool,
    /// Flags that are tested after the loop.
    pub behind: Vec<Behind>,
}

impl Frame {
    /// Returns true if the frame is a loop in the C.
    fn is_loop(&self) -> bool {
        self.mark.is_none() && self.outermost.is_none()
    }

    /// Returns the frame of a loop. With a mark it becomes the frame of a block.
    pub(super) fn of(label: Option<&str>, target: Option<&Target>) -> Frame {
        let (label, target) = (label.map(str::to_owned), target.cloned());
        Frame { label, target, mark: None, outermost: None, pass: false, behind: Vec::new() }
    }
}

/// A flag that is tested after a loop.
pub(super) struct Behind {
    pub flag: LocalId,
    /// Index of the frame that the flag leaves or continues.
    pub left: usize,
    pub leaving: Leaving,
}

/// Ways to leave a pass of a loop.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Leaving {
    Break,
    Continue,
}

/// The frames, outermost first.
#[derive(Default)]
pub(super) struct Frames(Vec<Frame>);

impl Frames {
    pub(super) fn len(&self) -> usize {
        self.0.len()
    }

    pub(super) fn enter(&mut self, frame: Frame) {
        self.0.push(frame);
    }

    /// Leaves the innermost frame, and returns the flags that are tested after it.
    pub(super) fn end(&mut self) -> Vec<Behind> {
        self.0.pop().map(|frame| frame.behind).unwrap_or_default()
    }

    /// Returns true if the innermost loop is not left by a flag.
    pub(super) fn ends_at_once(&self) -> bool {
        self.0.last().is_some_and(|frame| frame.behind.is_empty())
    }

    /// Returns the marks of all blocks that may be left.
    pub(super) fn marks(&self) -> Vec<LocalId> {
        self.0.iter().filter_map(|frame| frame.mark).collect()
    }

    /// Returns the destination of the value with which the frame of a label is left.
    pub(super) fn target(&self, label: Option<&str>, site: Site) -> Result<Option<Target>> {
        Ok(self.0[self.labelled(label, site)?].target.clone())
    }

    /// Returns the frame that is left, and the label by which it is: that of `label`, or the innermost loop.
    pub(super) fn left(
        &self,
        label: Option<&str>,
        leaving: Leaving,
        site: Site,
    ) -> Result<(usize, Option<String>)> {
        let depth = self.labelled(label, site)?;
        let Frame { label, outermost, .. } = &self.0[depth];
        let innermost = || self.0[..depth].iter().rposition(|it| it.is_loop() || it.pass);
        let left = match (*outermost, leaving) {
            (None, _) => depth,
            (Some(outermost), Leaving::Break) => outermost,
            (Some(outermost), Leaving::Continue) => innermost().unwrap_or(outermost),
        };
        Ok((left, label.clone()))
    }

    /// Returns the frame of a label, or of the innermost loop. Frames of an inlined generator function are skipped,
    /// since their labels are not visible in the author's loop body.
    fn labelled(&self, label: Option<&str>, site: Site) -> Result<usize> {
        let is_meant = |frame: &Frame| match label {
            None => frame.mark.is_none() || frame.pass,
            Some(_) => frame.label.as_deref() == label,
        };
        let mut seen = self.0.as_slice();
        while let [outer @ .., innermost] = seen {
            if is_meant(innermost) {
                return Ok(outer.len());
            }
            seen = innermost.outermost.map_or(outer, |outermost| &outer[..outermost]);
        }
        None.needed(site, "there is no such loop here")
    }

    /// Returns true if no loop is between the frame that is left and the code here.
    fn is_outermost(&self, left: usize) -> bool {
        !self.0[left + 1..].iter().any(Frame::is_loop)
    }

    /// Returns true if a flag that leaves a frame is declared here: outside all loops within the frame, which is no block.
    pub(super) fn declares_flag(&self, left: usize) -> bool {
        self.is_outermost(left) && self.0[left].mark.is_none()
    }

    /// Returns the statement that leaves a frame directly; none if a loop is between.
    pub(super) fn way_out(&self, left: usize, leaving: Leaving) -> Option<StmtKind> {
        self.is_outermost(left).then(|| match (leaving, self.0[left].mark) {
            (_, Some(mark)) => marks::mark(mark),
            (Leaving::Break, None) => StmtKind::Break,
            (Leaving::Continue, None) => StmtKind::Continue,
        })
    }

    /// Returns the flag that leaves a frame from here, if there is one already.
    pub(super) fn flag(&self, left: usize, leaving: Leaving) -> Option<LocalId> {
        let inner = self.0[left + 1..].iter().find(|frame| frame.is_loop());
        let mut behind = inner.into_iter().flat_map(|frame| &frame.behind);
        let is_it = |it: &&Behind| it.left == left && it.leaving == leaving;
        self.0[left].mark.or_else(|| behind.find(is_it).map(|behind| behind.flag))
    }

    /// Lets each loop between a frame and the code here test a flag that leaves the frame.
    pub(super) fn test_behind(&mut self, left: usize, flag: LocalId, leaving: Leaving) {
        for frame in &mut self.0[left + 1..] {
            if frame.is_loop() && !frame.behind.iter().any(|behind| behind.flag == flag) {
                frame.behind.push(Behind { flag, left, leaving });
            }
        }
    }
}
