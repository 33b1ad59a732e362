use cga::cga;

cga! {
    pub grammar Misspelt;
    import walls : "ui/door/wals.cga"
    Lot --> extrude(12) comp(f) { side : walls.Wall | top : Roof. }
}

cga! {
    pub grammar MisspeltText = r#"
        import walls : "ui/door/wals.cga"
        Lot --> extrude(12) comp(f) { side : walls.Wall | top : Roof. }"#;
}

// The mistake is in `tower.cga`.
cga! {
    pub grammar Broken;
    import tower : "ui/door/tower.cga"
    Lot --> split(x) { ~1 : tower.Lot | 6 : Garden. }
}

cga! {
    pub grammar BrokenFarther;
    import town : "ui/door/town.cga"
    Lot --> split(x) { ~1 : town.Block | 6 : Garden. }
}

cga! {
    @Deny(unused_import)
    pub grammar Unused;
    import walls : "ui/door/walls.cga"
    Lot --> extrude(12) Wall.
}

cga! {
    pub grammar UnusedText = r#"
        import walls : "ui/door/walls.cga"
        Lot --> extrude(12) Wall."#;
}

fn main() {}
