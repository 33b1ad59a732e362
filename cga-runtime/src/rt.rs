//! The names that generated code uses; `cga-macros/src/tests/rt.rs` compares this list with the code generator. The modules
//! [`op`] and [`func`] have all operations and functions; `rows.rs` beside that test compares them with the tables. This module
//! is not part of the public promise, as the versions of the crates are pinned to each other.

pub use std::boxed::Box;
/// The type of waiting calls of grammars in which no call waits.
pub use std::convert::Infallible as NoCall;
pub use std::string::String;
pub use std::sync::LazyLock;
pub use std::vec::Vec;

pub use crate::asset::{File, Files};
pub use crate::comp::select::Word;
pub use crate::comp::{
    Align, Arm, Components, Mode, Select, comp, comp_and_rest, comp_values, divide, each, never, sections,
};
pub use crate::fault::Error;
pub use crate::func::host;
pub use crate::geometry::Axis;
pub use crate::geometry::mesh::{TextureSpace, UvAxis};
pub use crate::grammar::attribute::{Attribute, AttributeKind, ChoiceValues, Choices, Range, check};
pub use crate::grammar::lazy::{Lazy, Origin, computed};
pub use crate::grammar::parallel::{Stretch, generate_all, run_all};
pub use crate::grammar::session::{DynSession, Session, generate, generate_from, open, run, used_values};
pub use crate::grammar::support::{array, bake, branch, global, hidden, image, renew, string, text};
pub use crate::grammar::{Evaluated, Field, Grammar, RuleSource, RustCall, RustCode, Unrunnable};
pub use crate::op::{Length, set, slim};
pub use crate::output::batches::{Batches, RunError};
pub use crate::output::model::Model;
pub use crate::query::get;
pub use crate::run::context::{Cx, MaterialCx};
pub use crate::run::env::Env;
pub use crate::run::operand::operand;
pub use crate::run::report::Report;
pub use crate::run::rules::{Checked, RuleTables, Rules, entries, list, names, texts};
pub use crate::run::settings::Settings;
pub use crate::run::sink::{Flow, Sink};
pub use crate::run::start_rule::StartRule;
pub use crate::run::template::RepeatedSlot;
pub use crate::shape::look_changes::ChangePlace;
pub use crate::shape::slim::{become_successor, hand_on, push, successor};
pub use crate::shape::step_bases::Bases;
pub use crate::shape::view::View;
pub use crate::shape::{Shape, ShapeRef};
pub use crate::split::divide::extent;
pub use crate::split::division::{Division, Made, Slot};
pub use crate::split::row::{Pattern, Row};
pub use crate::split::walk::{Split, Successor, split, split_area, split_solved, split_texture};
pub use crate::split::{Adjust, Item, Piece, Size, solve};
pub use crate::value::array::Array;
pub use crate::value::read::Read;
pub use crate::value::text::Text;
pub use crate::value::{Value, ValueType};

/// Operations of the language.
pub mod op {
    pub use crate::op::*;
}

/// Functions of the language.
pub mod func {
    pub use crate::comp::{Subcomponent, is_tagged, is_tagged_at};
    pub use crate::func::*;
    pub use crate::query::*;
}
