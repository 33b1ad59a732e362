use cga::cga;

cga! {
    pub grammar Mixed;
    Facade --> case scope.sx > 12 : Shop. 30% : Garage. else : Wall.
}

cga! {
    pub grammar MixedText = "
        Facade --> 30% : Garage. case scope.sx > 12 : Shop. else : Wall.";
}

cga! {
    pub grammar Late;
    Lot --> extrude(12) case scope.sx > 30 : Hall. else : House.
}

cga! {
    pub grammar LateText = "
        Lot --> extrude(12) 20% : Ruin. else : House.";
}

fn main() {}
