//! Finds out if a rule has made a child by the end of its body. A shape without children is a leaf. `NIL` is a child that
//! vanishes.

use crate::ir::{BlockParts, Childless, Step, StepKind};

/// Which paths can get to a place: with a child made, without one.
#[derive(Clone, Copy, Default, PartialEq, Eq)]
struct Paths {
    with: bool,
    without: bool,
}

impl Paths {
    fn or(self, other: Paths) -> Paths {
        Paths { with: self.with || other.with, without: self.without || other.without }
    }

    /// Behind something that makes a child for certain.
    fn child(self) -> Paths {
        Paths { with: self.with || self.without, without: false }
    }
}

pub(super) fn of(body: &[Step]) -> Childless {
    let paths = walk(body, Paths { with: false, without: true });
    match (paths.with, paths.without) {
        (false, true) => Childless::Always,
        (_, false) => Childless::Never,
        (true, true) => Childless::Depends,
    }
}

fn walk(steps: &[Step], start: Paths) -> Paths {
    let mut paths = start;
    for step in steps {
        paths = match &step.kind {
            StepKind::Do(..) | StepKind::SetAttr(..) | StepKind::SetShape(..) | StepKind::Rust(..) => paths,
            StepKind::Give(_) | StepKind::Renew(_) => paths.child(),
            StepKind::Block(block) => match block.parts {
                BlockParts::Arms(_) | BlockParts::Sections(_) | BlockParts::Each(_) => paths.child(),
                // It may not divide: the scope can be empty, every slot dropped.
                BlockParts::Slots(_) => paths.or(paths.child()),
                BlockParts::Operands(_) => paths,
            },
            StepKind::Push(steps) => walk(steps, paths),
            StepKind::Case { arms, otherwise } => {
                let end = walk(otherwise, paths);
                arms.iter().fold(end, |all, (_, steps)| all.or(walk(steps, paths)))
            }
        };
    }
    paths
}
