use cga::cga;

// Text.
cga! {
    pub grammar Curly = r#"
        attr roof = “flat”
        Lot --> case roof == "flat" : Deck. else : extrude(3) Attic."#;
}

cga! {
    pub grammar LostQuote = r##"
        Lot --> extrude(3) color("#ff8000) Wall.
        Door --> color("#402010") Leaf."##;
}

cga! {
    pub grammar LostEnd = r#"
        Lot --> split(y) { 4 : Shop. | ~1 : Floors. }
        /* The garden comes later.
        Garden --> extrude(0.2) Lawn."#;
}

cga! {
    pub grammar Metres = r#"
        Lot --> extrude(12.5m) Tower."#;
}

cga! {
    pub grammar Backslash = r#"
        Lot --> extrude(3) texture("walls\dark.jpg") Wall."#;
}

// Among Rust.
cga! {
    pub grammar InlineSign;
    attr height = 12
    Lot --> case height > 3 & scope.sx > 5 : Tower. else : Shed.
}

cga! {
    pub grammar InlineMetres;
    Lot --> split(y) { 35cm : Plinth. | ~1 : Wall. }
}

fn main() {}
