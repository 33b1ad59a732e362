//! Bad input from outside: meshes and numbers of any kind cause no panic, no hang and no broken mesh.

mod first_use;
mod guards;
mod inputs;
mod operations;
mod recomposition;
