//! The description of a tree of tiles: `tileset.json` of 3D Tiles 1.1.

use cga_geo::frame::Frame;
use serde_json::{Value, json};

use crate::glb_bounds::Bounds;

/// A node of the tree.
#[derive(Clone, Debug, PartialEq)]
pub struct Node {
    /// The frame of its contents and of its box.
    pub frame: Frame,
    /// The box around its contents and its children: east, north and up in metres.
    pub bounds: Bounds,
    /// The error in metres if it is shown without its children.
    pub error: f64,
    /// The address of its contents, relative to the folder of the tileset.
    pub content: Option<String>,
    /// The nodes that replace it nearby.
    pub children: Vec<Node>,
}

impl Node {
    /// A node around others, without contents. A viewer goes on to the children unless they are so small that nothing of them is seen.
    pub fn around(frame: Frame, children: Vec<Node>) -> Self {
        let mut node = Node { frame, bounds: Bounds::EMPTY, error: 0.0, content: None, children };
        node.grow();
        let Bounds { low, high } = node.bounds;
        let size = [0, 1, 2].map(|axis| if node.bounds.is_empty() { 0.0 } else { high[axis] - low[axis] });
        let largest = node.children.iter().map(|child| child.error).fold(0.0, f64::max);
        node.error = (size[0] * size[0] + size[1] * size[1] + size[2] * size[2]).sqrt().max(2.0 * largest);
        node
    }

    /// Grows the box to the boxes of the children.
    pub fn grow(&mut self) {
        let frame = self.frame;
        for child in &self.children {
            let own = |corner| match child.frame == frame {
                true => corner,
                false => frame.from_geocentric(child.frame.to_geocentric(corner)),
            };
            child.bounds.corners().map(own).into_iter().for_each(|point| self.bounds.add(point));
        }
    }

    /// The tile below another one with a frame; at the root of a file, the frame that the file is placed in.
    fn tile(&self, outer: Option<&Frame>) -> Value {
        // A city without buildings has a box, too.
        let Bounds { low, high } =
            if self.bounds.is_empty() { Bounds { low: [0.0; 3], high: [0.0; 3] } } else { self.bounds };
        let middle = [0, 1, 2].map(|axis| (low[axis] + high[axis]) / 2.0);
        // A flat box would be hit by no ray.
        let half = [0, 1, 2].map(|axis| ((high[axis] - low[axis]) / 2.0).max(0.5));
        let [[e, n, u], [x, y, z]] = [middle, half];
        let mut tile = json!({
            "boundingVolume": { "box": [e, n, u, x, 0.0, 0.0, 0.0, y, 0.0, 0.0, 0.0, z] },
            "geometricError": self.error,
        });
        match outer {
            None => tile["transform"] = json!(self.frame.matrix()),
            Some(outer) if *outer != self.frame => tile["transform"] = json!(self.frame.matrix_in(outer)),
            Some(_) => {}
        }
        if let Some(uri) = &self.content {
            tile["content"] = json!({ "uri": uri });
        }
        if !self.children.is_empty() {
            let children: Vec<Value> = self.children.iter().map(|child| child.tile(Some(&self.frame))).collect();
            tile["children"] = Value::Array(children);
        }
        tile
    }

    /// The file of the whole city, in geocentric metres.
    pub fn tileset(&self) -> Vec<u8> {
        self.file(None)
    }

    /// A file that another one refers to, in the frame of the tile that refers to it: the frame of this node.
    pub fn inner_tileset(&self) -> Vec<u8> {
        self.file(Some(&self.frame))
    }

    fn file(&self, outer: Option<&Frame>) -> Vec<u8> {
        let mut root = self.tile(outer);
        root["refine"] = json!("REPLACE");
        let file = json!({
            "asset": { "version": "1.1", "generator": concat!("cga-city ", env!("CARGO_PKG_VERSION")) },
            "geometricError": 2.0 * self.error.max(1.0),
            "root": root,
        });
        let mut text = file.to_string().into_bytes();
        text.push(b'\n');
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn boxes_contain_the_boxes_of_their_children() {
        let leaf = |place, error| Node {
            frame: Frame::at(place),
            bounds: Bounds { low: [-10.0, -10.0, 0.0], high: [10.0, 10.0, 30.0] },
            error,
            content: Some("a.glb".into()),
            children: Vec::new(),
        };
        let parent = Node::around(Frame::at([9.1, 48.7]), vec![leaf([9.1, 48.7], 0.0), leaf([9.11, 48.7], 8.0)]);
        let Bounds { low, high } = parent.bounds;
        assert!(low[0] == -10.0 && 740.0 < high[0] && high[0] < 760.0, "{high:?}");
        assert!(parent.error > 750.0);
        let text: Value = serde_json::from_slice(&parent.tileset()).expect("JSON");
        assert_eq!(text["root"]["children"][0].get("transform"), None);
        let moved = text["root"]["children"][1]["transform"][12].as_f64().expect("a matrix");
        assert!((moved - 736.0).abs() < 1.0, "{moved}");
    }
}
