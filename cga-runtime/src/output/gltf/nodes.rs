//! The nodes of a file. The first node contains all others, so that one translation moves everything.

use std::fmt::Write as _;

use glam::{DQuat, DVec3};

use super::Glb;
use super::json::{self, joined, quoted};
use super::primitive::Owner;
use super::property_table::Tables;
use super::quantized::Grid;
use super::scene::{INSTANCING, MeshPlacement, NodePlaces, SceneMesh};
use crate::geometry::each::Each;
use crate::output::number_text::list;
use crate::run::building::Building;
use crate::shape::scope::Scope;
use crate::value::Value;

/// A node with its children.
struct Node {
    name: String,
    /// Its members besides name and children, each with a comma before it.
    members: String,
    children: Vec<Node>,
}

impl Node {
    fn new(name: &str, members: String) -> Self {
        Node { name: quoted(name), members, children: Vec::new() }
    }

    /// Writes the node and all below it to a list.
    fn add_to(self, list: &mut Vec<String>) {
        let own = list.len();
        list.push(String::new());
        let mut children = Vec::new();
        for child in self.children {
            children.push(list.len().to_string());
            child.add_to(list);
        }
        let children = match children.len() {
            0 => String::new(),
            _ => format!(",\"children\":[{}]", children.join(",")),
        };
        list[own] = format!("{{\"name\":{}{}{children}}}", self.name, self.members);
    }
}

/// The name of a mesh and of its node: the name of its building or its rule, or of the file if it has several.
pub(super) fn name(glb: &Glb, mesh: &SceneMesh) -> String {
    let of_file = || glb.name.as_deref().unwrap_or("model").to_owned();
    match (mesh.building, &mesh.places, mesh.rule()) {
        (Some(building), ..) if !glb.division.by_rule => building_name(glb, building),
        (_, MeshPlacement::Root, _) | (.., None) => of_file(),
        (.., Some(rule)) => glb.numbers.table.rules()[rule as usize].to_string(),
    }
}

fn building_name(glb: &Glb, building: u32) -> String {
    let name = glb.rows.get(building as usize).map_or("", |building| building.name.as_str());
    if name.is_empty() { format!("building {building}") } else { name.to_owned() }
}

/// The member `nodes`. `places` are the nodes of meshes with instances, and `grid` has the positions of the mesh in the root node.
pub(super) fn nodes(
    glb: &Glb,
    meshes: &[SceneMesh],
    places: &[NodePlaces],
    tables: &Tables,
    grid: Option<&Grid>,
) -> String {
    let mut root = Node::new(glb.name.as_deref().unwrap_or("model"), String::new());
    let (mut main, mut children) = (String::new(), Vec::new());
    let mut buildings: Vec<Node> = Vec::new();
    if glb.division.by_building {
        buildings.extend((0..).zip(&glb.rows).map(|(number, building)| {
            Node::new(&building_name(glb, number), format!(",\"extras\":{}", building_extras(building)))
        }));
    }
    let mut places = places.iter().peekable();
    for (number, mesh) in meshes.iter().enumerate() {
        let name = name(glb, mesh);
        let mut add = |building: Option<u32>, node: Node| match building.and_then(|own| buildings.get_mut(own as usize))
        {
            Some(own) => own.children.push(node),
            None => children.push(node),
        };
        match &mesh.places {
            // It is the first mesh. Its numbers become metres in a node of their own, so that the children of the root stay as they are.
            MeshPlacement::Root => match grid {
                None => main.push_str(",\"mesh\":0"),
                Some(Grid { low, step }) => {
                    let (low, scale) = (list(&low.to_array()), list(&[*step; 3]));
                    children.push(Node::new(&name, format!(",\"mesh\":0,\"translation\":[{low}],\"scale\":[{scale}]")));
                }
            },
            MeshPlacement::Child if !glb.division.by_rule && mesh.building.is_some() => {
                let own = mesh.building.and_then(|own| buildings.get_mut(own as usize));
                own.into_iter().for_each(|own| own.members.insert_str(0, &format!(",\"mesh\":{number}")));
            }
            MeshPlacement::Child => add(mesh.building, Node::new(&name, format!(",\"mesh\":{number}"))),
            MeshPlacement::Nodes(nodes) => {
                for (place, building) in nodes {
                    let [x, y, z] = [place.matrix3.x_axis, place.matrix3.y_axis, place.matrix3.z_axis];
                    let translation = (place.translation - glb.origin).extend(1.0);
                    let columns = [x.extend(0.0), y.extend(0.0), z.extend(0.0), translation];
                    let matrix = list(columns.each(|column| column.to_array()).as_flattened());
                    let extras = match tables.buildings {
                        Some(_) => format!(",\"extras\":{{\"building\":{building}}}"),
                        None => String::new(),
                    };
                    let node = Node::new(&name, format!(",\"mesh\":{number},\"matrix\":[{matrix}]{extras}"));
                    add(Some(*building), node);
                }
            }
            MeshPlacement::Instances(_) => {
                while let Some(own) = places.next_if(|own| own.mesh == number) {
                    add(own.building, Node::new(&name, instances(own, tables)));
                }
            }
        }
    }
    for (owner, scope) in glb.placements.iter().flatten() {
        let node = placement(glb, *owner, scope, tables);
        match buildings.get_mut(owner.building as usize) {
            Some(own) => own.children.push(node),
            None => children.push(node),
        }
    }
    let moved = match glb.origin {
        DVec3::ZERO => String::new(),
        origin => format!(",\"translation\":[{}]", list(&origin.to_array())),
    };
    let extras = joined(glb.extras.iter().map(|(name, value)| format!("{}:{value}", quoted(name))));
    let extras = if extras.is_empty() { extras } else { format!(",\"extras\":{{{extras}}}") };
    root.members = format!("{main}{moved}{extras}");
    root.children = buildings.into_iter().chain(children).collect();
    let mut list = Vec::new();
    root.add_to(&mut list);
    format!("\"nodes\":[{}]", list.join(","))
}

/// The members of a node that shows a mesh at several places.
fn instances(own: &NodePlaces, tables: &Tables) -> String {
    let mut attributes = format!("\"TRANSLATION\":{},\"ROTATION\":{}", own.translations, own.rotations);
    let mut features = String::new();
    if let (Some(buildings), Some(rows)) = (own.buildings, tables.buildings) {
        let _ = write!(attributes, ",\"_FEATURE_ID_0\":{buildings}");
        let table = tables.of_buildings();
        let _ = write!(
            features,
            ",\"EXT_instance_features\":{{\"featureIds\":[{{\"featureCount\":{rows},\"attribute\":0,\"propertyTable\":{table}}}]}}"
        );
    }
    format!(",\"mesh\":{},\"extensions\":{{\"{INSTANCING}\":{{\"attributes\":{{{attributes}}}}}{features}}}", own.mesh)
}

/// The node of a leaf without faces.
fn placement(glb: &Glb, owner: Owner, scope: &Scope, tables: &Tables) -> Node {
    let translation = list(&(scope.origin - glb.origin).to_array());
    let rotation = list(&DQuat::from_mat3(&scope.axes).normalize().to_array());
    let size = list(&scope.size.to_array());
    let building = tables.buildings.map_or(String::new(), |_| format!(",\"building\":{}", owner.building));
    let members = format!(
        ",\"translation\":[{translation}],\"rotation\":[{rotation}],\"extras\":{{\"size\":[{size}]{building}}}"
    );
    Node::new(&glb.numbers.table.rules()[owner.rule as usize], members)
}

/// The data of a building, as custom properties of its node.
fn building_extras(building: &Building) -> String {
    let member = |(name, value): (&str, &Value)| format!("{}:{}", quoted(name), json::value(value));
    let attributes = joined(building.attributes.iter().map(|(name, value)| member((name, value))));
    // Many readers hold numbers as `f64`, which has the whole numbers up to 2⁵³.
    let seed = building.seed.to_string();
    let seed = if building.seed <= 1 << 53 { seed } else { quoted(&seed) };
    let reports = joined(building.report_values().iter().map(|(key, value)| member((key, value))));
    format!(
        "{{\"grammar\":{},\"seed\":{seed},\"attributes\":{{{attributes}}},\"reports\":{{{reports}}}}}",
        quoted(&building.grammar),
    )
}
