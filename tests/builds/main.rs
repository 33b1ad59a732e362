//! Packages that are built as a user builds them: messages of mistakes, changes of rule files, what editors see.

mod editor;
mod outside;
mod package;
mod rebuild;
mod ui;
