use cga::cga;

cga! {
    pub grammar Tower = r#"
        # The mistake is in the fourth line.
        Lot --> extrude(3)
                splt(x) { '0.5 : Wall }
    "#;
}

cga! { pub grammar Escaped = "Lot --> color(\"#ffffff\")\n comp(f) { sied : Wall. }"; }

fn main() {
    let _ = (Tower::default(), Escaped::default());
}
