use cga::cga;

cga! {
    pub grammar Tower;
    Lot --> case scope.sx > 3 : A.
    Other --> 30% : A.
}

fn main() {}
