//! Old names of the library compile, with a deprecation, and do the same as the new names.

use cga::sink::buffers::Buffers;
use cga::{Grammar, Model, Settings, Shape, Sink, cga};

cga! { grammar House; Lot --> extrude(2) House. }

#[test]
fn old_names_do_what_the_new_ones_do() {
    let (house, lots, settings) = (House::default(), [Shape::rectangle(3.0, 4.0)], Settings::default());
    let mut model = Model::new();
    house.generate_into(&lots[0], &settings, &mut model).expect("no limit");
    Grammar::derive(&house, &lots[0], &settings, &mut model).expect("no limit");
    house.run(&lots[0], &settings, &mut model).expect("no limit");
    assert_eq!((model.len(), model.volume()), (3, 72.0));

    let buffers: cga::parallel::Batches<Buffers> =
        house.generate_all_into(&lots, &settings, |_: &cga::parallel::Stretch| Buffers::new()).expect("no limit");
    let others: Result<_, cga::parallel::ShapeError> =
        cga::parallel::derive_all(&house, &lots, &settings, |_| Buffers::new());
    let new = house.run_all(&lots, &settings, |_| Buffers::new()).expect("no limit");
    for old in [buffers, others.expect("no limit")] {
        assert_eq!(old.sinks().next().map(Buffers::vertices), new.sinks().next().map(Buffers::vertices));
    }
    let _: Option<cga::parallel::Batch<Buffers>> = new.into_iter().next();
    let _: Option<cga::ShapeError> = None;
}

#[test]
fn old_addresses_lead_to_the_same_types() {
    let mut builder = cga::mesh::MeshBuilder::new();
    let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(|corner| builder.point(corner));
    builder.polygon(&corners);
    let mesh: Result<cga::mesh::Mesh, cga::mesh::MeshError> = builder.build();
    let _: cga::Mesh = mesh.expect("a triangle");
    let same: fn(cga::sink::Leaf<'_>) -> cga::Leaf<'_> = |leaf| leaf;
    let _ =
        (same, |quad: cga::sink::Quad| -> cga::Quad { quad }, |cuboid: cga::sink::Cuboid| -> cga::Cuboid { cuboid });
    let _: cga::sink::Flow = Model::new().finish();
    let _ = |error: cga::sink::error::WriteError| -> cga::WriteError { error };
}
