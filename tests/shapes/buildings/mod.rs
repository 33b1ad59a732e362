//! Buildings as features: in GLB files, read by a reader of their own, in models, meshes and OBJ files.

mod reader;

use cga::sink::gltf::Glb;
use cga::{Building, Grammars, Settings, Shape, Sink, Value, cga};
use cga_gates::GlbFile;
use serde_json::Value as Json;

use self::reader::BuildingTable as _;

cga! {
    @Allow(unused_attribute)
    grammar House;
    attr height = 6
    attr floors = rint(height / 3)
    attr form = case p(0.5) : "flat" else : "hip"
    attr garden = p(0.5)
    attr storeys = [height / 2, height / 2]
    Lot --> report("area.lot", geometry.area) color(case form == "flat" : "#ff0000" else : "#00ff00")
            offset(-1) comp(f) { inside : House | border : color(rand(0, 1), 0.5, 0.5) Lawn. }
    House --> report("volume", geometry.area * height) extrude(height) comp(f) { side : Facade | top : Roof. }
    Facade --> split(y) { { ~3 : split(x) { { ~2 : Tile }* } }* }
    Tile --> split(x) { ~1 : Wall. | 0.8 : color("#336699") Glass. | ~1 : Wall. }
}

cga! {
    @Allow(unused_attribute)
    grammar Block;
    attr height = 12
    attr form = 7
    Lot --> report("use", "shop") report("use", "flat") offset(-1) comp(f) { inside : extrude(height) Block. | border : Pavement. }
}

cga! { grammar Park;  Lot --> Lawn. [ scatter(surface, 3, uniform) { Lamp. } ] s(^0.5, ^1, ^0.5) center(xz) color("#00ff00") Tree. }

/// A lot of 12 by 12 m, with 3 m to the next, far from the origin of the world.
fn lot(number: u32) -> Shape {
    let place = place(number);
    let lot = Shape::rectangle(12.0, 12.0).at([place[0], 100.0, place[1]]).seed((1 << 53) + 1 + u64::from(number));
    let lot = lot.named(format!("\"lot\" {number} ä"));
    match number % 3 {
        0 => lot.grammar("House").attribute("height", 3 + number % 7),
        1 => lot.grammar("Block").attribute("height", 8.5),
        _ => lot.grammar("Park"),
    }
}

fn place(number: u32) -> [f64; 2] {
    [4_000_000.0 + 15.0 * f64::from(number % 12), 15.0 * f64::from(number / 12)]
}

fn grammars() -> Grammars {
    Grammars::new().with(House::default()).with(Block::default()).with(Park::default())
}

/// All points of each building lie in its lot, and each has points.
fn lie_in_their_lots(points: &[(usize, [f64; 3])], count: u32) {
    let mut seen = vec![0; count as usize];
    for (building, [x, y, z]) in points {
        let place = place(*building as u32);
        let is_in = |value: f64, from: f64| (from - 0.3..=from + 12.3).contains(&value);
        assert!(is_in(*x, place[0]) && is_in(*z, place[1]) && 99.9 < *y, "{building}: {x} {y} {z}");
        seen[*building] += 1;
    }
    assert!(seen.iter().all(|count| 4 <= *count), "{seen:?}");
}

#[test]
fn a_reader_finds_each_building_with_its_name_and_its_values() {
    let lots: Vec<Shape> = (0..144).map(lot).collect();
    let all = grammars().generate_all(&lots, &Settings::default()).unwrap();
    let file = GlbFile::new(&all.to_glb().unwrap());
    lie_in_their_lots(&file.points_of_buildings(), 144);
    let [names, grammars, seeds] = ["name", "grammar", "seed"].map(|id| file.column(id));
    let [heights, floors, forms, gardens, storeys] =
        ["height", "floors", "form", "garden", "storeys"].map(|id| file.column(id));
    let [areas, volumes, uses] = ["area_lot", "volume", "use"].map(|id| file.column(id));
    for (at, building) in all.sinks().enumerate() {
        let number = at as u32;
        assert_eq!(names[at], format!("\"lot\" {number} ä"));
        assert_eq!(grammars[at], ["House", "Block", "Park"][at % 3]);
        assert_eq!(seeds[at].as_u64(), Some((1 << 53) + 1 + u64::from(number)));
        let (own, _) = building.buildings().next().unwrap();
        let is_house = at % 3 == 0;
        let height = [Json::from(3.0 + f64::from(number % 7)), Json::from(8.5), Json::Null];
        assert_eq!(heights[at], height[at % 3]);
        let text = |name: &str| own.attribute(name).map_or(Json::Null, |value| Json::from(value.to_string()));
        // Attributes of several types, and truth values that some buildings do not have, are texts.
        assert_eq!((&forms[at], &gardens[at]), (&text("form"), &text("garden")));
        assert_eq!(floors[at].is_null(), !is_house);
        // An array that a building does not have is empty.
        let half = (3.0 + f64::from(number % 7)) / 2.0;
        assert_eq!(storeys[at], if is_house { Json::from(vec![half; 2]) } else { Json::from(Vec::<f64>::new()) });
        let sum = |key: &str| building.reported(key).map_or(Json::Null, |found| Json::from(found.summary().sum));
        assert_eq!((&areas[at], &volumes[at]), (&sum("area.lot"), &sum("volume")));
        assert_eq!(uses[at], if at % 3 == 1 { Json::from("flat, shop") } else { Json::Null });
    }
    // The name in the rules is there where the schema needs another.
    let class = &file.json["extensions"]["EXT_structural_metadata"]["schema"]["classes"]["building"];
    assert_eq!(class["properties"]["area_lot"]["name"], "area.lot");
}

#[test]
fn values_have_columns_of_their_type_where_all_buildings_have_them() {
    let lots: Vec<Shape> = (0..6).map(|number| lot(3 * number)).collect();
    let all = House::default().generate_all(&lots, &Settings::default()).unwrap();
    let file = GlbFile::new(&all.to_glb().unwrap());
    for (at, model) in all.sinks().enumerate() {
        let (own, leaves) = model.buildings().next().unwrap();
        assert_eq!(leaves, 0..model.len());
        let garden = own.attribute("garden") == Some(&Value::Bool(true));
        assert_eq!(file.column("garden")[at], garden);
        let height = own.attribute("height").unwrap().to_string().parse::<f64>().unwrap();
        assert_eq!(file.column("storeys")[at], Json::from(vec![height / 2.0; 2]));
    }
}

#[test]
fn one_building_costs_no_bytes_a_vertex() {
    let model = grammars().generate(&lot(0)).unwrap();
    let file = GlbFile::new(&model.to_glb().unwrap());
    lie_in_their_lots(&file.points_of_buildings(), 1);
    assert_eq!(file.column("name"), ["\"lot\" 0 ä"]);
    let empty = file.json["accessors"].as_array().unwrap().iter().filter(|accessor| accessor["bufferView"].is_null());
    assert!(0 < empty.count());
    // A sink that is filled by hand has no buildings, and no table of them.
    let mut glb = Glb::new();
    for leaf in &model {
        let _ = leaf.replay(&mut glb);
    }
    let file = GlbFile::new(&glb.into_bytes().unwrap());
    assert_eq!((file.table("rule"), file.table("building")), (Some(0), None));
}

#[test]
fn the_size_counts_the_vertices_and_indices_of_the_file() {
    let mut glb = Glb::new();
    let mut sizes = vec![glb.size()];
    for number in 0..4 {
        let _ = grammars().generate(&lot(number)).unwrap().replay(&mut glb);
        sizes.push(glb.size());
    }
    assert!(sizes[0] == 0 && sizes.is_sorted_by(|a, b| a < b), "{sizes:?}");
    let file = GlbFile::new(&glb.into_bytes().unwrap());
    let all: u64 =
        file.json["bufferViews"].as_array().unwrap().iter().map(|view| view["byteLength"].as_u64().unwrap()).sum();
    // Views of property tables come on top.
    assert!(sizes[4] <= all && all < sizes[4] + 5_000, "{sizes:?} {all}");
}

#[test]
fn leaves_after_the_last_building_have_a_row_too() {
    let model = grammars().generate(&lot(1)).unwrap();
    let mut glb = Glb::new();
    let _ = model.replay(&mut glb);
    let other = grammars().generate(&lot(2)).unwrap();
    for leaf in &other {
        let _ = leaf.replay(&mut glb);
    }
    let file = GlbFile::new(&glb.into_bytes().unwrap());
    assert_eq!(file.column("name"), ["\"lot\" 1 ä", ""]);
    assert!(file.points_of_buildings().iter().any(|(building, _)| *building == 1));
    // Buildings without leaves have rows as well.
    let mut glb = Glb::new();
    glb.end_building(&|| Building::new("empty", 1));
    let _ = model.replay(&mut glb);
    let file = GlbFile::new(&glb.into_bytes().unwrap());
    assert_eq!((file.column("name").len(), file.points_of_buildings()[0].0), (2, 1));
}

/// The nodes of a file below a node, with all that is below them.
fn below(json: &Json, node: usize) -> Vec<usize> {
    let children =
        json["nodes"][node]["children"].as_array().into_iter().flatten().map(|child| child.as_u64().unwrap() as usize);
    children.flat_map(|child| std::iter::once(child).chain(below(json, child))).collect()
}

#[test]
fn on_request_buildings_are_nodes() {
    let lots: Vec<Shape> = (0..12).map(lot).collect();
    let all = grammars().generate_all(&lots, &Settings::default()).unwrap();
    for by_rule in [false, true] {
        let mut glb = Glb::new().by_building().with_placements().with_origin([4_000_000.0, 0.0, 0.0].into());
        if by_rule {
            glb = glb.by_rule();
        }
        let _ = all.replay(&mut glb);
        let file = GlbFile::new(&glb.into_bytes().unwrap());
        let nodes = file.json["nodes"].as_array().unwrap();
        let children: Vec<usize> =
            nodes[0]["children"].as_array().unwrap().iter().map(|child| child.as_u64().unwrap() as usize).collect();
        assert_eq!(children.len(), 12);
        assert_eq!(below(&file.json, 0).len(), nodes.len() - 1, "each node has one parent");
        for (number, child) in (0..12).zip(children) {
            let node = &nodes[child];
            assert_eq!(node["name"], format!("\"lot\" {number} ä"));
            assert_eq!(node["extras"]["grammar"], ["House", "Block", "Park"][number as usize % 3]);
            if number % 3 == 0 {
                assert_eq!(node["extras"]["attributes"]["height"], 3 + number % 7);
                assert!(node["extras"]["reports"]["area.lot"].as_f64().is_some_and(|area| (area - 144.0).abs() < 1e-9));
            }
            // Its mesh, or the meshes of its rules, have its vertices.
            let own: Vec<usize> = std::iter::once(child).chain(below(&file.json, child)).collect();
            let meshes: Vec<&Json> =
                own.iter().map(|own| &nodes[*own]["mesh"]).filter(|mesh| !mesh.is_null()).collect();
            assert_eq!(meshes.len() == 1, !by_rule);
            let mut points = Vec::new();
            for primitive in meshes
                .iter()
                .flat_map(|mesh| file.json["meshes"][mesh.as_u64().unwrap() as usize]["primitives"].as_array().unwrap())
            {
                assert_eq!(primitive["attributes"]["_FEATURE_ID_0"].is_null(), by_rule);
                points.extend(file.rows::<3>(&primitive["attributes"]["POSITION"]));
            }
            let moved = |place: &[f64; 3]| [4_000_000.0 + place[0], place[1], place[2]];
            let points: Vec<(usize, [f64; 3])> = points.iter().map(|place| (number as usize, moved(place))).collect();
            let all = (0..12)
                .map(|other| (other as usize, [place(other)[0], 100.0, place(other)[1]]))
                .flat_map(|point| [point; 4]);
            lie_in_their_lots(&points.into_iter().chain(all).collect::<Vec<_>>(), 12);
            let lamps = own.iter().filter(|own| nodes[**own]["name"] == "Lamp").count();
            assert_eq!(lamps, if number % 3 == 2 { 3 } else { 0 });
        }
    }
}

#[test]
fn instances_know_their_buildings() {
    cga! {
        grammar Tiles;
        Lot --> extrude(9) comp(f) { side : split(y) { { ~3 : split(x) { { ~2 : Tile }* } }* } | top : Roof. }
        Tile --> split(x) { ~1 : Wall. | 0.8 : color("#336699") Glass. | ~1 : Wall. }
    }
    let lots: Vec<Shape> = (0..9).map(|number| lot(3 * number + 2)).collect();
    for by_building in [false, true] {
        let mut glb = Glb::new().with_instances().with_origin([4_000_000.0, 0.0, 0.0].into());
        if by_building {
            glb = glb.by_building();
        }
        for lot in &lots {
            Tiles::default().run(&lot.clone().start("Lot"), &Settings::default(), &mut glb).unwrap();
        }
        let file = GlbFile::new(&glb.into_bytes().unwrap());
        let nodes = file.json["nodes"].as_array().unwrap();
        let mut seen = [0; 9];
        let shared =
            nodes.iter().enumerate().filter(|(_, node)| !node["extensions"]["EXT_mesh_gpu_instancing"].is_null());
        for (number, node) in shared {
            let attributes = &node["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
            let places = file.rows::<3>(&attributes["TRANSLATION"]);
            let buildings: Vec<usize> = if by_building {
                let parent = (0..nodes.len())
                    .find(|parent| below(&file.json, *parent).contains(&number) && *parent != 0)
                    .unwrap();
                let name = nodes[parent]["name"].as_str().unwrap();
                let own = lots.iter().position(|lot| lot.name() == name).unwrap();
                vec![own; places.len()]
            } else {
                let feature = &node["extensions"]["EXT_instance_features"]["featureIds"][0];
                assert_eq!(feature["propertyTable"].as_u64().unwrap() as usize, file.table("building").unwrap());
                file.rows::<1>(&attributes["_FEATURE_ID_0"]).iter().map(|id| id[0] as usize).collect()
            };
            for (place, building) in places.iter().zip(buildings) {
                let lot = self::place(3 * building as u32 + 2);
                let (x, z) = (4_000_000.0 + place[0], place[2]);
                assert!(
                    (lot[0]..=lot[0] + 12.0).contains(&x) && (lot[1]..=lot[1] + 12.0).contains(&z),
                    "{building}: {place:?}"
                );
                seen[building] += 1;
            }
        }
        assert!(seen.iter().all(|count| 0 < *count), "{seen:?}");
    }
}

#[test]
fn solids_are_single_sided_on_request() {
    cga! { grammar Sides;  Lot --> [ extrude(3) color("#ff0000") Solid. ] [ t(0, 9, 0) color("#00ff00") Sheet. ]
    [ t(9, 0, 0) extrude(1) color("#0000ff") comp(f) { side : Wall. | all : NIL } ]
    [ t(20, 0, 0) primitiveSphere(8, 8, 1) color("#ffff00") Ball. ] [ t(30, 0, 0) extrude(3) color("#ff00ff") set(material.doubleSided, true) Own. ]
    [ t(40, 0, 0) primitiveCube s(-1, 1, 1) color("#00ffff") Turned. ] }
    let sides = |glb: Glb| {
        let mut glb = glb;
        let _ = Sides::default().generate(&Shape::rectangle(2.0, 2.0)).unwrap().replay(&mut glb);
        let file = GlbFile::new(&glb.into_bytes().unwrap());
        let materials = file.json["materials"].as_array().unwrap();
        materials
            .iter()
            .map(|material| (material["name"].as_str().unwrap().to_owned(), material["doubleSided"] == true))
            .collect::<Vec<_>>()
    };
    assert!(sides(Glb::new()).iter().all(|(_, double)| *double));
    let single: Vec<String> = sides(Glb::new().with_single_sided_solids())
        .into_iter()
        .filter(|(_, double)| !double)
        .map(|(name, _)| name)
        .collect();
    assert_eq!(single, ["#ff0000", "#ffff00"]);
}

#[test]
fn models_and_their_meshes_know_buildings() {
    use cga::sink::meshes::Granularity;
    let lots: Vec<Shape> = (0..12).map(lot).collect();
    let all = grammars().generate_all(&lots, &Settings::default()).unwrap().to_model();
    let buildings: Vec<(&Building, std::ops::Range<usize>)> = all.buildings().collect();
    assert_eq!(buildings.len(), 12);
    assert!(buildings.iter().zip(&lots).all(|((building, _), lot)| building.name.as_str() == lot.name()));
    assert!(buildings.windows(2).all(|pair| pair[0].1.end == pair[1].1.start) && buildings[11].1.end == all.len());
    assert_eq!(buildings[0].0.reports.get("volume").map(|found| found.summary().count), Some(1));
    let meshes = all.meshes(Granularity::Building);
    for mesh in &meshes {
        let own = place(mesh.building.unwrap() as u32);
        let is_in = |value: f64, from: f64| (from - 0.3..=from + 12.3).contains(&value);
        for place in &mesh.positions {
            let at = [0, 2].map(|i| f64::from(place[i]) + meshes.origin[i]);
            assert!(is_in(at[0], own[0]) && is_in(at[1], own[1]), "{at:?} {own:?}");
        }
        assert!(mesh.leaves.iter().all(|leaf| buildings[mesh.building.unwrap()].1.contains(&leaf.leaf)));
    }
    let by_material = all.meshes(Granularity::Material);
    assert!(by_material.list.iter().all(|mesh| mesh.building.is_none()) && by_material.list.len() < meshes.list.len());
    let triangles =
        |list: &[cga::sink::meshes::TriangleMesh]| list.iter().map(|mesh| mesh.indices.len()).sum::<usize>();
    assert_eq!(triangles(&by_material.list), triangles(&meshes.list));
}

#[test]
fn objects_of_obj_files_are_buildings() {
    let lots = [lot(0), Shape::rectangle(2.0, 2.0), Shape::rectangle(2.0, 2.0).named("a\nb # c")];
    let all = House::default().generate_all(&lots, &Settings::default()).unwrap();
    let (text, _) = all.to_obj("a.mtl");
    let objects: Vec<&str> = text.lines().filter(|line| line.starts_with("o ")).collect();
    assert_eq!(objects, ["o \"lot\" 0 ä", "o building_1", "o a_b _ c"]);
    // Each object begins its groups anew.
    let keys: Vec<&str> =
        text.lines().filter_map(|line| line.split(' ').next()).filter(|key| "ogf".contains(key)).collect();
    assert!(keys.windows(2).all(|pair| pair[0] != "o" || pair[1] == "g"), "{keys:?}");
}

#[test]
fn buffers_and_chunks_record_buildings_on_request() {
    use cga::sink::buffers::{Buffers, Chunks};
    let lots: Vec<Shape> = (0..12).map(lot).collect();
    let run = |sink: &mut dyn Sink| {
        for lot in &lots {
            grammars().run(lot, &Settings::default(), sink).unwrap();
        }
    };
    let new = || Buffers::new().with_origin([4_000_000.0, 0.0, 0.0].into());
    let (mut plain, mut buffers) = (new(), new().with_buildings());
    run(&mut plain);
    run(&mut buffers);
    assert_eq!((plain.buildings().count(), buffers.buildings().count()), (0, 12));
    assert_eq!((plain.vertices(), plain.indices()), (buffers.vertices(), buffers.indices()));
    let ends: Vec<usize> = buffers.buildings().map(|(_, indices)| indices.end).collect();
    assert!(ends.windows(2).all(|pair| pair[0] < pair[1]) && ends.last() == Some(&buffers.indices().len()));
    let file = GlbFile::new(&buffers.to_glb().unwrap());
    lie_in_their_lots(&file.points_of_buildings(), 12);
    assert_eq!(file.column("name"), lots.iter().map(|lot| Json::from(lot.name())).collect::<Vec<_>>());
    // A building that two chunks share has its name in both, and its values in the last.
    let mut names: Vec<Vec<String>> = Vec::new();
    let mut complete = 0;
    let mut chunks = Chunks::new(100, |chunk: &Buffers| {
        let file = GlbFile::new(&chunk.to_glb().unwrap());
        names.push(file.column("name").iter().map(|name| name.as_str().unwrap().to_owned()).collect());
        complete += chunk.buildings().filter(|(building, _)| !building.grammar.is_empty()).count();
        for (building, [x, ..]) in file.points_of_buildings() {
            let own = lots.iter().position(|lot| lot.name() == names[names.len() - 1][building]).unwrap();
            let from = place(own as u32)[0];
            assert!((from - 0.3..=from + 12.3).contains(&x), "{own} {x}");
        }
        cga::Flow::Continue(())
    })
    .with_buildings()
    .with_origin([4_000_000.0, 0.0, 0.0].into());
    run(&mut chunks);
    let _ = chunks.into_result();
    assert_eq!(complete, 12);
    assert!(12 < names.iter().map(Vec::len).sum::<usize>());
}

#[test]
fn leaves_outside_of_buildings_belong_to_none() {
    let house = grammars().generate(&lot(1)).unwrap();
    let loose = grammars().generate(&lot(2)).unwrap();
    let hand = |sink: &mut dyn Sink| loose.leaves().for_each(|leaf| _ = leaf.replay(sink));
    let mut model = cga::Model::new();
    hand(&mut model);
    let _ = house.replay(&mut model);
    hand(&mut model);
    let (before, own) = (loose.len(), house.len());
    let ranges = |model: &cga::Model| model.buildings().map(|(_, leaves)| leaves).collect::<Vec<_>>();
    assert_eq!(ranges(&model), vec![before..before + own; 1]);
    // A replay gives the same model.
    let mut again = cga::Model::new();
    let _ = model.replay(&mut again);
    assert_eq!(ranges(&again), ranges(&model));
    assert_eq!(again.len(), model.len());
    let file = GlbFile::new(&model.to_glb().unwrap());
    assert_eq!(file.column("name"), ["", "\"lot\" 1 ä", ""]);
    assert!(
        file.points_of_buildings()
            .iter()
            .all(|(building, place)| (*building == 1) == (place[0] < self::place(2)[0] - 1.0))
    );
    let objects = model.to_obj("a.mtl").0;
    let objects: Vec<&str> = objects.lines().filter(|line| line.starts_with("o ")).collect();
    assert_eq!(objects, ["o \"lot\" 1 ä", "o rest"]);
    let meshes = model.meshes(cga::sink::meshes::Granularity::Building);
    assert!(
        meshes.list.iter().any(|mesh| mesh.building.is_none())
            && meshes.list.iter().any(|mesh| mesh.building == Some(0))
    );
    // Without any building, a division by buildings leaves all in one mesh.
    let mut glb = Glb::new().by_building();
    hand(&mut glb);
    let file = GlbFile::new(&glb.into_bytes().unwrap());
    assert_eq!((&file.json["nodes"][0]["mesh"], file.table("building")), (&Json::from(0), None));
}

#[test]
fn buildings_without_faces_keep_their_data() {
    cga! { grammar Points;  Lot --> scatter(surface, 2, uniform) { Lamp. } }
    let all =
        Points::default().generate_all(&[lot(2).start("Lot"), lot(5).start("Lot")], &Settings::default()).unwrap();
    let mut glb = Glb::new().with_placements();
    let _ = all.replay(&mut glb);
    let file = GlbFile::new(&glb.into_bytes().unwrap());
    assert_eq!(file.column("name"), ["\"lot\" 2 ä", "\"lot\" 5 ä"]);
    let lamps: Vec<&Json> =
        file.json["nodes"].as_array().unwrap().iter().filter(|node| node["name"] == "Lamp").collect();
    assert_eq!(lamps.iter().map(|lamp| lamp["extras"]["building"].as_u64().unwrap()).collect::<Vec<_>>(), [0, 0, 1, 1]);
    let mut glb = Glb::new().by_building();
    let _ = all.replay(&mut glb);
    let file = GlbFile::new(&glb.into_bytes().unwrap());
    assert_eq!(file.json["nodes"].as_array().unwrap().len(), 3);
}

#[test]
fn names_that_few_buildings_have_cost_no_column_each() {
    cga! { grammar Keys;  Lot --> report(initialShape.name, 1) report("all", 2) extrude(2) X. }
    let size = |count: u32| {
        let lots: Vec<Shape> =
            (0..count).map(|number| Shape::rectangle(1.0, 1.0).named(format!("{number:04}"))).collect();
        Keys::default().generate_all(&lots, &Settings::default()).unwrap().to_glb().unwrap()
    };
    let file = size(1000);
    assert!(file.len() < 4 * size(500).len());
    let file = GlbFile::new(&file);
    assert_eq!(file.column("all"), vec![Json::from(2.0); 1000]);
    let more = file.column("more_reports");
    assert_eq!((&more[0], &more[999]), (&Json::Null, &Json::from("{\"0999\":1}")));
}

#[test]
fn pixels_know_their_leaves_and_buildings() {
    use cga::sink::picture::Picture;
    let lots: Vec<Shape> = (0..12).map(lot).collect();
    let all = grammars().generate_all(&lots, &Settings::default()).unwrap().to_model();
    let picture = Picture::new(120, 90).looking_from(0.0, 90.0);
    let leaves = picture.leaves(&all);
    assert_eq!(leaves.len(), 120 * 90);
    // Seen from above, each lot is there, and its leaves are below its own pixels: from the left to the right.
    let building = |leaf: usize| all.buildings().position(|(_, own)| own.contains(&leaf)).unwrap();
    let row: Vec<usize> = leaves[45 * 120..46 * 120].iter().flatten().map(|leaf| building(*leaf)).collect();
    assert!(row.is_sorted() && (0..12).all(|building| row.contains(&building)), "{row:?}");
    assert!(leaves[0].is_none() && leaves.iter().flatten().all(|leaf| *leaf < all.len()));
}
