#![deny(warnings)]

use cga::cga;

cga! {
    pub grammar Stuck;
    Lot --> split(x) { 0 : A. }* split(x) { ^0.00000001 : A. }*
        split(x) { ^0.6 : A. | ^0.5 : B. }* split(x) { ^0.33 : A. }*
}

cga! {
    pub grammar Repeats = "Lot --> split(x) { '0.00000001 : A. }* split(x) { '0.6 : A. | '0.5 : B. }* split(x) { '0.33 : A. }*";
}

fn main() {}
