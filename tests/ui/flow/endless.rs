use cga::cga;

cga! {
    pub grammar Endless;
    Lot --> Ping Tree
    Ping --> t(1, 0, 0) Pong
    Pong --> A. Ping
    Tree --> split(y) { ~1 : Tree }
}

fn main() {}
