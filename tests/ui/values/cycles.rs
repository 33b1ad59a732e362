use cga::cga;

cga! {
    pub grammar Percent;
    Facade --> 60% : Shop. 50% : Garage. else : Wall.
}

cga! {
    pub grammar PercentText = "
        Facade --> 60% : Shop. 50% : Garage. else : Wall.";
}

cga! {
    pub grammar Sizes;
    attr height = 3 * floors
    attr floors = floor(height / 3)
    Lot --> extrude(height) split(y) { { ^(1 / floors) : Floor. }* }
}

cga! {
    pub grammar Function;
    steps(height) = 1 + steps(height - 0.18)
    Stairs --> split(x) { { ^(1 / steps(scope.sy)) : Step. }* }
}

cga! {
    pub grammar FunctionText = "
        steps(height) = 1 + rest(height)
        rest(height) = steps(height - 0.18)
        Stairs --> split(x) { { '(1 / steps(scope.sy)) : Step. }* }";
}

fn main() {}
