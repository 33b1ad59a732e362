use cga::cga;

cga! {
    pub grammar Tower;
    # A comment, as in a rule file
    Lot --> extrude(3) # and one behind
        A.
}

fn main() {}
