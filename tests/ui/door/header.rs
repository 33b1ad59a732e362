use cga::cga;

cga! { pub gramar Tower; Lot --> A. }

cga! { pub grammar House in house; }

fn main() {
    let _ = House::default();
}
