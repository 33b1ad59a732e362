//! A street.

use cga::cga;

cga! {
    @Allow(missing_asset)
    pub grammar House;

    /// The number of storeys.
    @Range(min = 1, max = 5)
    attr storeys = rint(rand(1, 3))
    /// The tint of the bricks.
    attr tint = 40% : "#ffffff" 30% : "#ffe3c4" else : "#d9e2e6"
    /// The slope of the roof in degrees.
    @Range(min = 20, max = 60)
    attr slope = rand(32, 48)
    const height = 2.8

    Lot     --> report("floor area", storeys * geometry.area)
                extrude(0.75 + storeys * height) split(y) { 0.5 : Plinth | ~1 : Walls | 0.25 : Cornice }
    Plinth  --> s(scope.sx + 0.2, ^1, scope.sz + 0.2) center(xz) color("#8d8a83") Plinth.
    Walls   --> comp(f) { front : Facade(true) | side : Facade(false) }
    Facade(hasDoor) -->
        setupProjection(0, scope.xy, 1.8, 1.2)
        split(y) { ~height : Ground(hasDoor) | { ~height : Storey }* }
    Ground(hasDoor) -->
        case hasDoor : split(x) { ~1 : Storey | 1.5 : Entrance | ~1 : Storey }
        else         : Storey
    Entrance --> split(y) { 2.3 : Door | ~1 : Wall }
    Door    --> [ t(0, -0.5, 0) s(^1, 0.5, ^1) color("#8d8a83") extrude(0.7) Step. ] offset(-0.08) comp(f) { inside : t(0, 0, -0.12) Paint | border : Frame }
    Paint   --> 50% : color("#3f5f4a") Door. else : color("#7a2e2a") Door.
    Storey  --> split(x) { 0.5 : Wall | { ~2.4 : Bay }* | 0.5 : Wall }
    Bay     --> split(x) { ~1 : Wall | 1.1 : Column | ~1 : Wall }
    Column  --> split(y) { 0.8 : Wall | 1.5 : Window | ~1 : Wall }
    Window  --> offset(-0.08) comp(f) { inside : Pane | border : Frame }
    Pane    --> 80% : Glass("#6f93ab") else : Glass("#f0d48c")
    Glass(light) --> t(0, 0, -0.12) color(light) Glass.
    Frame   --> t(0, 0, -0.12) extrude(0.18) color("#fbf8f1") Frame.
    Wall    --> color(tint) texture("bricks.png") projectUV(0) Wall.
    Cornice --> s(scope.sx + 0.4, ^1, scope.sz + 0.4) center(xz) color("#f6f0e4") comp(f) { top : Roof | all : Cornice. }
    Roof    --> roofGable(slope, 0.5, 0.4) comp(f) { isTagged("roof.side") : Gable | isTagged("roof.bottom") : NIL | all : Plane }
    Gable   --> setupProjection(0, scope.xy, 1.8, 1.2) Wall
    Plane   --> setupProjection(0, scope.xy, 2, 2) extrude(0.12) comp(f) { top : Tiled | all : color("#8a4231") Tiles. }
    Tiled   --> texture("tiles.png") projectUV(0) Tiles.
}
