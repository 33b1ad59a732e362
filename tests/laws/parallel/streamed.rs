//! Chunks: the same triangles in the same order, in bounded memory.

use std::ops::ControlFlow;
use std::sync::Mutex;

use cga::mesh::FaceTag;
use cga::sink::buffers::{Buffers, Chunks, Submesh, Vertex};
use cga::{Flow, Material, Mesh, MeshBuilder, Settings, Shape, Sink, Text, cga};

use super::THREADS;
use super::grammars::{cases, settings};
use crate::laws::with_threads;

/// A triangle with all that is known of it.
pub(crate) type Triangle = ([[u32; 8]; 3], Text, Material);

/// The triangles of buffers, in order.
pub(crate) fn triangles(buffers: &Buffers) -> Vec<Triangle> {
    let corner = |index: u32| {
        let [x, y, z, u, v, w]: Vertex = buffers.vertices()[index as usize];
        let [s, t] = buffers.uvs().get(index as usize).copied().unwrap_or_default();
        [x, y, z, u, v, w, s, t].map(f32::to_bits)
    };
    let of = |submesh: Submesh| {
        let (rule, material) =
            (&buffers.rules()[submesh.rule as usize], &buffers.materials()[submesh.material as usize]);
        let (triangles, rest) = buffers.indices()[submesh.indices].as_chunks::<3>();
        assert!(rest.is_empty());
        triangles.iter().map(move |t| (t.map(corner), rule.clone(), Material::clone(material))).collect::<Vec<_>>()
    };
    assert!(buffers.uvs().is_empty() || buffers.uvs().len() == buffers.vertices().len());
    assert!(buffers.indices().iter().all(|&index| (index as usize) < buffers.vertices().len()));
    buffers.submeshes().flat_map(of).collect()
}

/// Runs with chunks of at most that many vertices; gives their triangles, and the size of each.
pub(crate) fn chunks(max: usize, run: impl FnOnce(&mut dyn Sink)) -> (Vec<Triangle>, Vec<usize>) {
    let (mut all, mut sizes) = (Vec::new(), Vec::new());
    let mut sink = Chunks::new(max, |chunk: &Buffers| {
        assert!(!chunk.vertices().is_empty() && chunk.vertices().len() <= max);
        // Vertices take 24 bytes each; indices, texture coordinates and parts grow with them.
        assert!(chunk.memory() <= 96 * max, "{} bytes for {max}", chunk.memory());
        all.extend(triangles(chunk));
        sizes.push(chunk.vertices().len());
        Flow::Continue(())
    });
    run(&mut sink);
    assert!(sink.finish().is_continue() && sink.finish().is_continue());
    assert_eq!(sink.handed_out(), sizes.len() as u64);
    (all, sizes)
}

#[test]
fn chunks_have_the_same_triangles() {
    for (grammar, shapes) in cases() {
        let shapes = &shapes[..shapes.len().min(30)];
        let run = |sink: &mut dyn Sink| {
            for shape in shapes {
                assert!(grammar.run(shape, &settings(), sink).is_ok());
            }
        };
        let mut whole = Buffers::new();
        run(&mut whole);
        let whole = triangles(&whole);
        for max in [24, 25, 100, 4096, 1_000_000] {
            let (streamed, sizes) = chunks(max, run);
            assert!(streamed == whole, "{} with {max}", grammar.name());
            assert!(max != 1_000_000 || sizes.len() == usize::from(!whole.is_empty()), "a run ends no chunk");
        }
    }
}

cga! {
    grammar Show;
    Lot --> i("mesh") Mesh.
}

fn show(mesh: Mesh, sink: &mut dyn Sink) {
    let assets = std::sync::Arc::new(cga::Assets::new().with("mesh", mesh));
    let settings = Settings { assets, ..Settings::default() };
    for lot in 0..3 {
        let shape = Shape::cuboid(9.0, 9.0, 9.0).at([20.0 * f64::from(lot), 0.0, 0.0]);
        assert!(Show::default().run(&shape, &settings, sink).is_ok());
    }
}

/// A closed prism over a star of that many corners, its sides in two materials, with texture coordinates if asked.
fn prism(corners: u32, textured: bool) -> Mesh {
    let mut builder = MeshBuilder::new();
    let mut ring = |y: f64| -> Vec<u32> {
        let point = |at: u32| {
            let (angle, radius) = (f64::from(at) / f64::from(corners) * std::f64::consts::TAU, f64::from(1 + at % 2));
            builder.point([radius * libm::cos(angle), y, -radius * libm::sin(angle)])
        };
        (0..corners).map(point).collect()
    };
    let (low, high) = (ring(0.0), ring(1.0));
    builder.polygon(&high);
    builder.face(&low.iter().rev().copied().collect::<Vec<_>>(), &[], FaceTag::PLAIN);
    for at in 0..corners as usize {
        let next = (at + 1) % corners as usize;
        builder.face(
            &[low[at], low[next], high[next], high[at]],
            &[],
            FaceTag { material: at as u32 % 2, ..FaceTag::PLAIN },
        );
    }
    let colour = |r| Material::with(|look| look.color = Some(cga::Color::new(r, 0.5, 0.5)));
    builder.materials([colour(0.2), colour(0.8)]);
    if textured {
        let uvs: Vec<_> = (0..6 * corners).map(|at| cga::glam::dvec2(f64::from(at), 0.5)).collect();
        builder.uvs(&uvs);
    }
    builder.build().expect("a mesh")
}

#[test]
fn a_leaf_larger_than_a_chunk_is_divided() {
    for textured in [false, true] {
        let mut whole = Buffers::new();
        show(prism(50, textured), &mut whole);
        assert_eq!(whole.vertices().len(), 3 * 300);
        let whole = triangles(&whole);
        // Larger than the mesh; larger than a face; smaller than a face.
        for (max, whole_chunks) in [(300, true), (299, false), (60, false), (24, false)] {
            let (streamed, sizes) = chunks(max, |sink| show(prism(50, textured), sink));
            assert!(streamed == whole, "{max}");
            assert_eq!(sizes == [300; 3], whole_chunks, "{max}: {sizes:?}");
        }
    }
}

#[test]
fn a_chunk_that_is_refused_ends_the_run() {
    let (grammar, shapes) = (super::grammars::Street::default(), super::grammars::lots(5));
    let mut seen = 0;
    let mut sink = Chunks::new(1000, |_: &Buffers| {
        seen += 1;
        if seen == 3 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    });
    let stopped = shapes.iter().map(|shape| grammar.run(shape, &settings(), &mut sink).expect("no limit").stopped);
    assert!(stopped.collect::<Vec<_>>().iter().any(|&stopped| stopped));
    assert!(sink.finish().is_break());
    drop(sink);
    assert_eq!(seen, 3);
}

#[test]
fn the_error_of_a_chunk_arrives_from_one_sink_and_from_many() {
    let (grammar, shapes) = (super::grammars::Street::default(), super::grammars::lots(300));
    let mut sink = Chunks::new(100, |_: &Buffers| Err("the disk is full"));
    assert!(grammar.run(&shapes[0], &settings(), &mut sink).expect("no limit").stopped);
    assert_eq!(sink.into_result(), Err("the disk is full"));
    for threads in THREADS {
        let parts = with_threads(threads, || {
            grammar.run_all(&shapes, &settings(), |stretch| {
                let number = stretch.number;
                Chunks::new(2048, move |_: &Buffers| if number < 3 { Ok(()) } else { Err(number) })
            })
        });
        let parts = parts.expect("no limit");
        assert!(parts.report().stopped && parts.len() == 4, "{threads} threads");
        assert_eq!(parts.into_iter().try_for_each(|part| part.sink.into_result()), Err(3));
    }
}

#[test]
fn stretches_stream_in_parallel() {
    let (grammar, shapes) = (super::grammars::Street::default(), super::grammars::lots(300));
    let mut whole = Buffers::new();
    for shape in &shapes {
        assert!(grammar.run(shape, &settings(), &mut whole).is_ok());
    }
    let mut sizes = Vec::new();
    for threads in THREADS {
        let all = Mutex::new(Vec::new());
        let parts = with_threads(threads, || {
            grammar.run_all(&shapes, &settings(), |stretch| {
                let (all, stretch, mut number) = (&all, stretch.number, 0);
                Chunks::new(2048, move |chunk: &Buffers| {
                    number += 1;
                    all.lock().expect("no panic").push((stretch, number, triangles(chunk)));
                    Flow::Continue(())
                })
            })
        });
        assert_eq!(parts.expect("no limit").len(), 150);
        let mut all = all.into_inner().expect("no panic");
        all.sort_by_key(|chunk| (chunk.0, chunk.1));
        sizes.push(all.iter().map(|chunk| chunk.2.len()).collect::<Vec<_>>());
        let streamed: Vec<_> = all.into_iter().flat_map(|chunk| chunk.2).collect();
        assert!(streamed == triangles(&whole), "{threads} threads");
    }
    assert!(sizes.iter().all(|borders| *borders == sizes[0]), "threads move no border");
}

cga! {
    /// Floors that repeat, with more vertices than a small chunk.
    grammar Floors;
    Lot   --> comp(f) { side : split(y) { { ~3.1 : Floor }* } | all : NIL }
    Floor --> split(x) { { ~2.3 : split(x) { ~1 : A. | 1.2 : B. | ~0.7 : C. } }* }
}

#[test]
fn far_from_the_origin_chunks_have_the_bits_of_whole_buffers() {
    let far = cga::glam::DVec3::new(512_345.3, 0.7, 5_400_000.1);
    let grammar = Floors::default();
    let shapes: Vec<Shape> = (0..8)
        .map(|at| Shape::cuboid(13.5, 31.0, 11.0).at((far + 20.1 * f64::from(at)).to_array()).seed(at as u64))
        .collect();
    let mut whole = Buffers::new().with_origin(far);
    let mut streamed = Vec::new();
    let mut sink = Chunks::new(50, |chunk: &Buffers| {
        streamed.extend(triangles(chunk));
        Flow::Continue(())
    })
    .with_origin(far);
    for shape in &shapes {
        assert!(grammar.run(shape, &settings(), &mut whole).is_ok());
        assert!(grammar.run(shape, &settings(), &mut sink).is_ok());
    }
    assert!(sink.finish().is_continue());
    drop(sink);
    assert!(streamed == triangles(&whole));
}

#[test]
fn each_chunk_is_a_file() {
    let (grammar, shape) = (super::grammars::Street::default(), &super::grammars::lots(1)[0]);
    let mut files = Vec::new();
    let mut sink = Chunks::new(100, |chunk: &Buffers| {
        files.push((chunk.triangle_count(), chunk.to_glb().expect("a file")));
        Flow::Continue(())
    });
    assert!(grammar.run(shape, &settings(), &mut sink).is_ok() && sink.finish().is_continue());
    drop(sink);
    assert!(2 < files.len());
    for (triangles, file) in files {
        let length = u32::from_le_bytes(file[12..16].try_into().expect("four bytes")) as usize;
        let json: serde_json::Value = serde_json::from_slice(&file[20..20 + length]).expect("JSON");
        let primitives = json["meshes"][0]["primitives"].as_array().expect("primitives");
        let count = |primitive: &serde_json::Value| {
            let accessor = primitive["indices"].as_u64().expect("a number") as usize;
            json["accessors"][accessor]["count"].as_u64().expect("a number") as usize
        };
        assert_eq!(primitives.iter().map(count).sum::<usize>(), 3 * triangles);
    }
}
