//! Everything generated code may touch, and nothing else. Not part of the public promise: versions are pinned to each
//! other.

pub use std::boxed::Box;
pub use std::ops::ControlFlow;
pub use std::string::String;

pub use crate::asset::File;
pub use crate::comp::select::Word;
pub use crate::comp::{Align, Arm, Candidate, Components, Mode, Select, comp, comp_values, never};
pub use crate::fault::{Error, Fault};
pub use crate::func::{host, later};
pub use crate::geometry::Axis;
pub use crate::geometry::mesh::TextureSpace;
pub use crate::geometry::mesh::UvAxis;
pub use crate::grammar::attribute::{Attribute, AttributeDefault, AttributeKind, ChoiceValues, Choices, Range, check};
pub use crate::grammar::lazy::{Lazy, Origin, computed};
pub use crate::grammar::parallel::{Parts, ShapeError, Stretch, generate_all, run_all};
pub use crate::grammar::session::{DynSession, Session, generate, run};
pub use crate::grammar::support::{anew, array, bake, branch, global, image, string, text};
pub use crate::grammar::{Field, Grammar, Unrunnable};
pub use crate::op::Length;
pub use crate::op::set;
pub use crate::op::slim;
pub use crate::output::model::Model;
pub use crate::query::get;
pub use crate::run::context::{Cx, Painting};
pub use crate::run::env::Env;
pub use crate::run::report::Report;
pub use crate::run::rules::Rules;
pub use crate::run::settings::Settings;
pub use crate::run::sink::{Flow, Sink};
pub use crate::run::start_rule::StartRule;
pub use crate::run::template::Last;
pub use crate::shape::base::Base;
pub use crate::shape::scope::Scope;
pub use crate::shape::slim::{become_successor, hand_on, push, successor};
pub use crate::shape::view::View;
pub use crate::shape::{Shape, ShapeRef};
pub use crate::split::divide::{areas, extent, sizes, solved};
pub use crate::split::division::{Division, Made, Slot};
pub use crate::split::row::{Pattern, Row};
pub use crate::split::texture::texture;
pub use crate::split::{Adjust, Item, Piece, Size, solve, solve_any};
pub use crate::value::Value;
pub use crate::value::array::{Array, Element};
pub use crate::value::text::Text;
pub use crate::{op, query};

/// Functions of the language.
pub mod func {
    pub use crate::comp::{Subcomponent, is_tagged, is_tagged_at};
    pub use crate::func::*;
    pub use crate::query::*;
}
pub use cga_split::List;
