use cga::cga;

cga! { pub grammar Tower in "ui/door/tower.cga"; }
cga! { pub grammar Missing in "ui/door/missing.cga"; }

fn main() {
    let _ = (Tower { height: 3.0 }, Missing::default());
}
