//! The example `district`: lengths of degrees.

use cga_tests::metres_a_degree;

#[test]
fn degrees_have_the_lengths_of_the_ellipsoid() {
    // Published lengths of a degree of longitude and of latitude, in metres.
    let published = [(0.0, [111_319.5, 110_574.3]), (45.0, [78_846.8, 111_131.8]), (90.0, [0.0, 111_693.9])];
    for (latitude, expected) in published {
        let found = metres_a_degree(latitude);
        assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 0.1), "{latitude}: {found:?}");
    }
}
