//! Cities of made-up outlines: the same bytes from all formats and after interrupted runs, tilesets and GLB files read back.

mod formats;
mod glb;
mod hostile;
mod images;
mod inserted;
mod levels;
mod neighbours;
mod resumed;
mod town;
mod units;
mod validator;
