//! The command of the tutorial, as it is written there.

use std::fs;
use std::path::Path;
use std::process::Command;

#[test]
fn the_command_of_the_tutorial_draws_its_picture() {
    let guide = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/guide");
    let text = fs::read_to_string(guide.join("tutorial.md")).expect("the tutorial");
    let command = text.lines().find_map(|line| line.strip_prefix("cga run ")).expect("a command");
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("tutorial");
    fs::create_dir_all(folder.join("assets")).expect("a folder");
    for file in ["house.cga", "street.geojson", "assets/bricks.png", "assets/tiles.png"] {
        fs::copy(guide.join(file), folder.join(file)).expect("a file of the tutorial");
    }
    let args = command.split_whitespace().chain(["--deny-faults"]);
    let output = Command::new(env!("CARGO_BIN_EXE_cga"))
        .current_dir(&folder)
        .arg("run")
        .args(args)
        .output()
        .expect("the command");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let read = |path: &Path| fs::read(path).expect("a file");
    assert!(read(&folder.join("street.glb")).starts_with(b"glTF"));
    let same = read(&folder.join("street.png")) == read(&guide.join("step-12.png"));
    assert!(same, "docs/guide/step-12.png: run the command of step 12 in docs/guide and take its picture");
}
