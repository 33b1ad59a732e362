use cga::cga;

cga! {
    pub grammar House;
    attr name = "Facade"
    const tagged = isTagged("Facade")
    Lot --> comp(f) { eave : Wall. | top && !insid : Wall. | name : Wall. }
    Edges --> comp(e) { case front : 1 else : 2 : Edge. | eave && scope.sx > 1 = Edge. }
    Holes --> print(comp(h) { border : 1 | all : "a" })
}

fn main() {}
