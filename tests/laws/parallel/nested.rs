//! Sinks that use threads themselves.

use std::collections::HashSet;
use std::ops::ControlFlow;
use std::sync::{Arc, Mutex};
use std::thread::{ThreadId, current};

use cga::glam::DAffine3;
use cga::{Flow, Leaf, Mesh, Settings, Sink};

use super::grammars::{Street, lots};
use crate::laws::with_threads;

/// Takes on other work of the pool at each leaf.
struct Yielding<'a> {
    at_work: &'a Mutex<HashSet<ThreadId>>,
}

impl Sink for Yielding<'_> {
    fn mesh(&mut self, _: &Leaf<'_>, _: &Arc<Mesh>, _: &DAffine3) -> Flow {
        rayon::yield_now();
        ControlFlow::Continue(())
    }

    fn finish(&mut self) -> Flow {
        assert!(self.at_work.lock().expect("no panic").remove(&current().id()));
        ControlFlow::Continue(())
    }
}

#[test]
fn no_thread_has_two_workers_on_its_stack() {
    for _ in 0..20 {
        let at_work = Mutex::new(HashSet::new());
        let batches = with_threads(7, || {
            Street::default().run_all(&lots(20), &Settings::default(), |_| {
                let is_new = at_work.lock().expect("no panic").insert(current().id());
                assert!(is_new, "a worker within a worker");
                Yielding { at_work: &at_work }
            })
        });
        assert_eq!(batches.expect("no limit").len(), 20);
    }
}
