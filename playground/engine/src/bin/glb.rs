//! Writes the GLB file of each request that it reads, made by compiled rules: the files that the page must equal.
//!
//! `glb FOLDER` reads lines with a file name, a space and the JSON of a request.

use std::error::Error;
use std::io::stdin;
use std::path::PathBuf;

use cga_playground::compiled::glb;

fn main() -> Result<(), Box<dyn Error>> {
    let folder = PathBuf::from(std::env::args_os().nth(1).ok_or("name the folder for the files")?);
    for line in stdin().lines() {
        let line = line?;
        let (name, request) = line.split_once(' ').ok_or("a line has a file name and a request")?;
        std::fs::write(folder.join(name), glb(&serde_json::from_str(request)?)?)?;
    }
    Ok(())
}
