//! Bays.

use cga::cga;

cga! {
    pub grammar House;

    /// The number of storeys.
    @Range(min = 1, max = 5)
    attr storeys = 2
    const height = 2.8

    Lot     --> extrude(0.75 + storeys * height) split(y) { 0.5 : Plinth | ~1 : Walls | 0.25 : Cornice }
    Plinth  --> s(scope.sx + 0.2, ^1, scope.sz + 0.2) center(xz) color("#8d8a83") Plinth.
    Walls   --> comp(f) { side : Facade }
    Facade  --> split(y) { { ~height : Storey }* }
    Storey  --> split(x) { 0.5 : Wall | { ~2.4 : Bay }* | 0.5 : Wall }
    Bay     --> split(x) { ~1 : Wall | 1.1 : Column | ~1 : Wall }
    Column  --> split(y) { 0.8 : Wall | 1.5 : Window | ~1 : Wall }
    Window  --> color("#6f93ab") Glass.
    Wall    --> color("#e8dcc0") Wall.
    Cornice --> s(scope.sx + 0.4, ^1, scope.sz + 0.4) center(xz) color("#f6f0e4") comp(f) { top : Roof | all : Cornice. }
    Roof    --> color("#9c4a36") Tiles.
}
