#![deny(warnings)]

use cga::cga;

cga! {
    pub grammar Facade;
    @Range(min = 3, max = 60)
    attr height = 24
    attr bay = 3
    Lot --> split(x) { ^0.5 : Z. | ^0.6 : Y. | ^0.1 : X. } Wall
    Wall --> s(5, height, 0) split(x) { 3 : A. | 2 : B. | ~1 : C. } split(x) { -2 : A. | 4 : B. | 2 : C. }
        split(x) { ^0.7 : A. | ^0.7 : B. } split(x) { ^0.5 : A. | 3 : B. } split(x) { 2.4 : A. | 2.4 : B. }
        split(x) { bay : A. | bay : B. | ~1 : C. } split(z) { 1 : A. } split(y) { height : A. | ~1 : B. }
}

cga! {
    pub grammar Text = "Lot --> split(x) { '0.5 : Z. | '0.6 : Y. | 3 : X. }";
}

fn main() {}
