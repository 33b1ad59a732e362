use cga::cga;

// Among Rust, rustc finds it: see `missing_brace.rs`.
cga! {
    pub grammar Text = r#"
        Lot --> extrude(12 split(y) { 4 : Shop. | { ~3 : Floor. }* }
        Shed --> extrude(3) Boards."#;
}

cga! {
    pub grammar Slots = r#"
        Lot --> extrude(12) split(y) { 4 : Shop. | { ~3 : Floor.
        Shed --> extrude(3) Boards."#;
}

// Only programs write this.
cga! {
    pub grammar Deep = "
        Lot --> extrude(
            ((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((
            ((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((
            ((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((
            12
            ))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))
            ))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))
            ))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))
        ) Tower.";
}

fn main() {}
