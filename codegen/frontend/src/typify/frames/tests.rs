//! Ways to leave loops and blocks.

use super::*;

fn of(frames: Vec<Frame>) -> Frames {
    Frames(frames)
}

/// The body of a loop over a generator leaves the generator's own loops, and does not see their labels.
#[test]
fn a_body_of_several_loops_leaves_the_outermost() {
    let body = Frame { outermost: Some(1), ..Frame::of(Some("a"), None) };
    let frames = of(vec![
        Frame::of(Some("o"), None),
        Frame::of(None, None),
        Frame::of(Some("g"), None),
        body,
    ]);
    let site = Site::default();
    let left = |label, leaving| frames.left(label, leaving, site).map(|it| it.0).ok();
    assert_eq!(left(None, Leaving::Break), Some(1));
    assert_eq!(left(None, Leaving::Continue), Some(2));
    assert_eq!(left(Some("o"), Leaving::Break), Some(0));
    assert_eq!(left(Some("g"), Leaving::Break), None);
}

/// A loop in between needs a flag, which each loop on the way tests once.
#[test]
fn a_loop_in_between_tests_a_flag() {
    let mut frames = of((0..3).map(|_| Frame::of(None, None)).collect());
    assert!(frames.way_out(2, Leaving::Continue) == Some(StmtKind::Continue));
    assert!(frames.way_out(0, Leaving::Break).is_none());
    assert!(frames.flag(0, Leaving::Break).is_none() && !frames.declares_flag(0));
    for _ in 0..2 {
        frames.test_behind(0, LocalId(7), Leaving::Break);
    }
    assert_eq!(frames.flag(0, Leaving::Break), Some(LocalId(7)));
    assert_eq!(frames.flag(0, Leaving::Continue), None);
    assert_eq!([frames.end().len(), frames.end().len(), frames.end().len()], [1, 1, 0]);
}

/// A block is left by its mark, from within another block, too.
#[test]
fn a_block_is_left_by_its_mark() {
    let block = |mark| Frame { mark: Some(LocalId(mark)), ..Frame::of(None, None) };
    let frames = of(vec![block(4), block(5)]);
    assert!(frames.way_out(0, Leaving::Break) == Some(marks::mark(LocalId(4))));
    assert_eq!(frames.marks(), [LocalId(4), LocalId(5)]);
    assert_eq!(frames.flag(0, Leaving::Break), Some(LocalId(4)));
}
