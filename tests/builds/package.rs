//! A package of a user, outside the workspace. All of them share one folder of artifacts and the features of `cga`, so it is checked once.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use cga_tests::tree::root;

/// The folder of all artifacts.
pub(crate) fn target() -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join("users")
}

pub(crate) struct Package {
    pub(crate) folder: PathBuf,
}

impl Package {
    /// A package that depends on `cga` under the name `dependency`, with the edition of new packages and the features that documents use.
    /// `more` follows in its manifest.
    pub(crate) fn new(name: &str, dependency: &str, more: &str) -> Self {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
        let package = Package { folder };
        let manifest = format!(
            "[package]\nname = \"{name}\"\nversion = \"0.0.0\"\nedition = \"2024\"\npublish = false\n\n[dependencies]\n\
             {dependency} = {{ package = \"cga\", path = {:?}, features = [\"live\", \"geo-types\", \"serde\"] }}\n\n{more}\n\
             [workspace]\n",
            root()
        );
        package.write("Cargo.toml", &manifest);
        // The versions that are there already.
        fs::copy(root().join("Cargo.lock"), package.folder.join("Cargo.lock")).expect("a lock file");
        package
    }

    /// Writes a file and the folders above it.
    pub(crate) fn write(&self, file: &str, text: &str) {
        let path = self.folder.join(file);
        fs::create_dir_all(path.parent().expect("a folder")).expect("a writable target folder");
        fs::write(path, text).expect("a writable target folder");
    }

    /// `cargo check` with the packages that are there already.
    pub(crate) fn check(&self) -> Command {
        self.command("check")
    }

    /// A command of cargo with the packages that are there already.
    pub(crate) fn command(&self, name: &str) -> Command {
        let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
        let mut command = Command::new(cargo);
        command
            .args([name, "--offline", "--color=never"])
            .current_dir(&self.folder)
            .env("CARGO_TARGET_DIR", target())
            .env_remove("RUSTFLAGS");
        command
    }
}
