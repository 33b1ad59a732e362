//! Networks that are hard to lay out.

use super::Centerline;

/// A line with the default widths.
fn line(points: &[[f64; 2]]) -> Centerline {
    Centerline::new(points)
}

/// A line from the centre at an angle in degrees from the x axis.
fn arm(degrees: f64, length: f64) -> Centerline {
    let angle = degrees.to_radians();
    line(&[[0.0, 0.0], [length * libm::cos(angle), -length * libm::sin(angle)]])
}

/// A circle of a radius as a closed line.
fn circle(centre: [f64; 2], radius: f64, count: usize) -> Vec<[f64; 2]> {
    let point = |at: usize| {
        let angle = std::f64::consts::TAU * (at % count) as f64 / count as f64;
        [centre[0] + radius * libm::cos(angle), centre[1] + radius * libm::sin(angle)]
    };
    (0..=count).map(point).collect()
}

/// Names and lines.
pub(super) fn cases() -> Vec<(&'static str, Vec<Centerline>)> {
    vec![
        ("straight", vec![line(&[[-40.0, 0.0], [40.0, 0.0]])]),
        ("bent", vec![line(&[[-50.0, 10.0], [-20.0, 12.0], [0.0, 5.0], [20.0, -20.0], [50.0, -20.0]])]),
        ("right angle", vec![line(&[[-40.0, 0.0], [20.0, 0.0], [20.0, -40.0]])]),
        ("hairpin", vec![line(&[[-40.0, 0.0], [30.0, 0.0], [-40.0, 6.0]])]),
        ("tight zigzag", vec![line(&[[-40.0, 0.0], [0.0, 0.0], [2.0, -5.0], [6.0, 0.0], [8.0, 6.0], [40.0, 6.0]])]),
        ("T", vec![line(&[[-40.0, 0.0], [40.0, 0.0]]), line(&[[0.0, 0.0], [0.0, 40.0]])]),
        ("X", vec![line(&[[-40.0, 0.0], [40.0, 0.0]]), line(&[[0.0, -40.0], [0.0, 40.0]])]),
        ("Y", vec![arm(90.0, 40.0), arm(210.0, 40.0), arm(330.0, 40.0)]),
        ("10 degrees", vec![line(&[[-60.0, 0.0], [60.0, 0.0]]), arm(10.0, 100.0)]),
        ("30 degrees", vec![line(&[[-60.0, 0.0], [60.0, 0.0]]), arm(30.0, 70.0)]),
        ("5 arms", (0..5).map(|at| arm(72.0 * f64::from(at) + 10.0, 45.0)).collect()),
        ("7 arms", (0..7).map(|at| arm(51.0 * f64::from(at), 45.0)).collect()),
        ("one sided fan", vec![arm(0.0, 50.0), arm(30.0, 50.0), arm(60.0, 50.0), arm(90.0, 50.0)]),
        (
            "short arms",
            vec![
                line(&[[-40.0, 0.0], [40.0, 0.0]]),
                line(&[[0.0, 0.0], [0.0, 3.0]]),
                line(&[[10.0, 0.0], [10.0, -30.0]]),
            ],
        ),
        (
            "widths in a line",
            vec![
                line(&[[-40.0, 0.0], [0.0, 0.0]]).roadway(12.0).sidewalks(3.0, 1.0),
                line(&[[0.0, 0.0], [40.0, 0.0]]).roadway(5.0).sidewalks(1.0, 0.0),
            ],
        ),
        (
            "widths in a bend",
            vec![
                line(&[[-40.0, 0.0], [0.0, 0.0]]).roadway(12.0),
                line(&[[0.0, 0.0], [0.0, 40.0]]).roadway(5.0).sidewalks(3.0, 0.0),
            ],
        ),
        (
            "widths in a T",
            vec![
                line(&[[-40.0, 0.0], [0.0, 0.0]]).roadway(12.0),
                line(&[[0.0, 0.0], [40.0, 0.0]]).roadway(6.0),
                line(&[[0.0, 0.0], [0.0, 40.0]]).roadway(4.0).sidewalks(0.0, 2.0),
            ],
        ),
        (
            "doubled",
            vec![
                line(&[[-40.0, 0.0], [40.0, 0.0]]),
                line(&[[-40.0, 0.0], [40.0, 0.0]]),
                line(&[[20.0, 0.0], [-20.0, 0.0]]),
                line(&[[-30.0, 0.0], [-30.0, 30.0]]),
            ],
        ),
        ("nearly doubled", vec![line(&[[-40.0, 0.0], [40.0, 0.0]]), line(&[[-40.0, 1.0], [40.0, 2.0]])]),
        ("parallel", vec![line(&[[-40.0, 0.0], [40.0, 0.0]]), line(&[[-40.0, 10.0], [40.0, 10.0]])]),
        (
            "dual carriageway",
            vec![
                line(&[[-50.0, 0.0], [50.0, 0.0]]),
                line(&[[-50.0, 11.0], [50.0, 11.0]]),
                line(&[[0.0, -40.0], [0.0, 50.0]]),
            ],
        ),
        (
            "no length",
            vec![line(&[]), line(&[[0.0, 0.0]]), line(&[[5.0, 5.0], [5.0, 5.0]]), line(&[[-20.0, 0.0], [20.0, 0.0]])],
        ),
        ("self crossing", vec![line(&[[-40.0, -20.0], [20.0, 20.0], [20.0, -20.0], [-40.0, 20.0]])]),
        ("loop", vec![line(&circle([0.0, 0.0], 30.0, 16))]),
        ("small loop", vec![line(&circle([0.0, 0.0], 5.0, 12)), line(&[[5.0, 0.0], [40.0, 0.0]])]),
        (
            "roundabout",
            vec![
                line(&circle([0.0, 0.0], 14.0, 16)).roadway(6.0),
                line(&[[14.0, 0.0], [50.0, 0.0]]),
                line(&[[-14.0, 0.0], [-50.0, 0.0]]),
                line(&[[0.0, 14.0], [0.0, 50.0]]),
            ],
        ),
        (
            "loop with a stem",
            vec![line(&[[-40.0, 0.0], [0.0, 0.0], [20.0, 20.0], [40.0, 0.0], [20.0, -20.0], [0.0, 0.0]])],
        ),
        (
            "near ends",
            vec![
                line(&[[-40.0, 0.0], [-0.2, 0.1]]),
                line(&[[0.2, 0.0], [40.0, 0.0]]),
                line(&[[0.0, 0.4], [0.0, 40.0]]),
            ],
        ),
        ("overshoot", vec![line(&[[-40.0, 0.0], [40.0, 0.0]]), line(&[[0.0, -0.3], [0.0, 40.0]])]),
        (
            "fine curve",
            vec![
                line(
                    &(0..60)
                        .map(|at| [f64::from(at) - 30.0, 15.0 * libm::sin(f64::from(at) * 0.1)])
                        .collect::<Vec<_>>(),
                ),
                line(&[[0.0, -40.0], [0.0, 40.0]]),
            ],
        ),
        (
            "dense grid",
            (0..6)
                .flat_map(|at| {
                    let at = 9.0 * f64::from(at) - 22.0;
                    [line(&[[at, -40.0], [at, 40.0]]), line(&[[-40.0, at], [40.0, at]])]
                })
                .collect(),
        ),
        (
            "grid",
            (0..3)
                .flat_map(|at| {
                    let at = 30.0 * f64::from(at) - 30.0;
                    [line(&[[at, -50.0], [at, 50.0]]), line(&[[-50.0, at + 3.0], [50.0, at - 3.0]])]
                })
                .collect(),
        ),
        (
            "inside a wide street",
            vec![line(&[[-50.0, 0.0], [50.0, 0.0]]).roadway(60.0), line(&[[-5.0, 3.0], [15.0, 9.0]])],
        ),
        (
            "no sidewalks",
            vec![line(&[[-40.0, 0.0], [40.0, 0.0]]).sidewalks(0.0, 0.0), arm(70.0, 40.0).sidewalks(0.0, 0.0)],
        ),
    ]
}
