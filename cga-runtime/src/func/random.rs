//! Random numbers, from the shape's own stream.

use crate::run::env::Env;
use crate::shape::view::View;

/// `rand()`: uniform in 0..1 (*rand function*).
pub fn rand(shape: &mut impl View) -> f64 {
    shape.draw()
}

/// `rand(max)`: uniform between 0 and `max` (*rand function*).
pub fn rand_to(env: &mut Env, shape: &mut impl View, max: f64) -> f64 {
    env.finite(max, "the largest random number") * shape.draw()
}

/// `rand(min, max)`: uniform between the two (*rand function*).
pub fn rand_between(env: &mut Env, shape: &mut impl View, min: f64, max: f64) -> f64 {
    let min = env.finite(min, "the smallest random number");
    let max = env.finite(max, "the largest random number");
    let (extent, draw) = (max - min, shape.draw());
    // The difference may overflow.
    if extent.is_finite() { min + extent * draw } else { min * (1.0 - draw) + max * draw }
}

/// `p(q)`: true with probability `q`. False for `q` <= 0, true for `q` >= 1 (*p function*). Always draws a random
/// number.
pub fn chance(env: &mut Env, shape: &mut impl View, q: f64) -> bool {
    let q = env.finite(q, "the probability");
    drawn_below(shape, q)
}

/// Returns true if the next random number in 0..1 is below `q`.
pub(crate) fn drawn_below(shape: &mut impl View, q: f64) -> bool {
    shape.draw() < q
}

#[cfg(test)]
mod tests {
    use super::super::tests::{env, faults};
    use super::*;
    use crate::shape::Shape;

    #[test]
    fn certain_and_impossible_chances() {
        let (mut env, mut shape) = (env(), Shape::rectangle(1.0, 1.0));
        for _ in 0..1000 {
            assert!(chance(&mut env, &mut shape, 1.0) && chance(&mut env, &mut shape, 2.0));
            assert!(!chance(&mut env, &mut shape, 0.0) && !chance(&mut env, &mut shape, -1.0));
        }
        let often = (0..1000).filter(|_| chance(&mut env, &mut shape, 0.3)).count();
        assert!((250..350).contains(&often), "{often}");
        assert_eq!(faults(&mut env), 0);
        assert!(!chance(&mut env, &mut shape, f64::NAN) && !chance(&mut env, &mut shape, f64::INFINITY));
        assert_eq!(faults(&mut env), 2);
    }

    #[test]
    fn a_draw_is_used_up_in_any_case() {
        let (mut env, mut shape, mut other) = (env(), Shape::rectangle(1.0, 1.0), Shape::rectangle(1.0, 1.0));
        chance(&mut env, &mut shape, 2.0);
        rand_to(&mut env, &mut shape, f64::NAN);
        rand(&mut other);
        rand(&mut other);
        assert_eq!(rand(&mut shape), rand(&mut other));
    }

    #[test]
    fn numbers_lie_between_the_ends() {
        let (mut env, mut shape) = (env(), Shape::rectangle(1.0, 1.0));
        for (low, high) in [(0.0, 1.0), (-3.0, 5.0), (5.0, 5.0), (f64::MIN, f64::MAX)] {
            for _ in 0..100 {
                let number = rand_between(&mut env, &mut shape, low, high);
                assert!((low..=high).contains(&number), "{number} in {low}..={high}");
            }
        }
        assert!((0..100).all(|_| (-2.0..=0.0).contains(&rand_to(&mut env, &mut shape, -2.0))));
        assert_eq!(rand_between(&mut env, &mut shape, f64::NAN, f64::INFINITY), 0.0);
        assert_eq!(faults(&mut env), 2);
    }
}
