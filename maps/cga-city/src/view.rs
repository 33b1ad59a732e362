//! A server for the page and the tiles, on the loopback address alone.

use std::io::{self, BufRead as _, BufReader, Read as _, Write as _};
use std::net::{Ipv4Addr, TcpListener, TcpStream};
use std::path::{Component, Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

use crate::options::ViewOptions;
use crate::stream::say;
use crate::{Problem, Status};

/// The package of the command in the repository. Beside it, `view/build.sh` builds the page.
const PACKAGE: &str = env!("CARGO_MANIFEST_DIR");

/// The most bytes of the head of a request.
const MOST_HEAD: u64 = 16 << 10;

/// Serves a city until the process ends.
pub(crate) fn view(options: &ViewOptions) -> Result<Status, Problem> {
    let city = &options.dir;
    if !city.join("tileset.json").is_file() {
        let tiles = city.join("tiles");
        let help = match tiles.join("tileset.json").is_file() {
            true => format!("did you mean `{}`?", tiles.display()),
            false => "make a city with `cga-city LOTS --rules RULES.cga --out DIR`".to_owned(),
        };
        return Err(Problem::unusable(format!("`{}` has no tileset.json; {help}", city.display())));
    }
    let view = Path::new(PACKAGE).with_file_name("view");
    let page = options.page.clone().unwrap_or_else(|| view.join("dist"));
    if !page.join("index.html").is_file() {
        let (page, script) = (page.display(), view.join("build.sh"));
        let text =
            format!("`{page}` has no index.html; build the page with `{}`, which needs Node.js", script.display());
        return Err(Problem::unusable(text));
    }
    let unusable = |why: io::Error| {
        Problem::unusable(format!("cannot serve port {}: {why}; use another one with `--port`", options.port))
    };
    let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, options.port)).map_err(unusable)?;
    let port = listener.local_addr().map_err(unusable)?.port();
    say(format_args!("http://127.0.0.1:{port}/ shows `{}`; Ctrl+C ends it", city.display()));
    let folders = Arc::new(Folders { page, city: city.clone() });
    for stream in listener.incoming().flatten() {
        let folders = folders.clone();
        // A client that goes away is not a problem.
        std::thread::spawn(move || drop(folders.answer(stream)));
    }
    Ok(Status::Success)
}

/// The folders of the files.
struct Folders {
    page: PathBuf,
    city: PathBuf,
}

impl Folders {
    /// Answers one request.
    fn answer(&self, mut stream: TcpStream) -> io::Result<()> {
        stream.set_read_timeout(Some(Duration::from_secs(10)))?;
        let head = head(&stream)?;
        let file = head.as_deref().and_then(|path| self.file(path));
        let found = file.and_then(|path| Some((kind(&path), std::fs::read(path).ok()?)));
        let (status, kind, bytes) = match found {
            Some((kind, bytes)) => ("200 OK", kind, bytes),
            None => ("404 Not Found", "text/plain", b"not found\n".to_vec()),
        };
        let length = bytes.len();
        write!(
            stream,
            "HTTP/1.1 {status}\r\nContent-Type: {kind}\r\nContent-Length: {length}\r\nCache-Control: no-cache\r\nConnection: close\r\n\r\n"
        )?;
        stream.write_all(&bytes)
    }

    /// The file of an address. No address leads out of the folders.
    fn file(&self, address: &str) -> Option<PathBuf> {
        let path = address.split(['?', '#']).next()?.strip_prefix('/')?;
        let (folder, name) = match path.strip_prefix("city/") {
            Some(name) => (&self.city, name),
            None => (&self.page, if path.is_empty() { "index.html" } else { path }),
        };
        let is_below = Path::new(name).components().all(|part| matches!(part, Component::Normal(_)));
        Some(folder.join(name)).filter(|file| is_below && file.is_file())
    }
}

/// The address of a GET request for this computer. Other names may belong to a foreign page, which must not read the city.
fn head(stream: &TcpStream) -> io::Result<Option<String>> {
    let mut lines = BufReader::new(stream.take(MOST_HEAD)).lines();
    let first = lines.next().transpose()?.unwrap_or_default();
    let mut is_local = false;
    for line in lines {
        let line = line?;
        if line.is_empty() {
            break;
        }
        if let Some((name, value)) = line.split_once(':')
            && name.eq_ignore_ascii_case("host")
        {
            let host = value.trim().rsplit_once(':').map_or(value.trim(), |(host, _)| host);
            is_local = host == "127.0.0.1" || host.eq_ignore_ascii_case("localhost");
        }
    }
    let address = first.strip_prefix("GET ").and_then(|rest| rest.split(' ').next());
    Ok(address.filter(|_| is_local).map(str::to_owned))
}

fn kind(path: &Path) -> &'static str {
    match path.extension().and_then(|ending| ending.to_str()).unwrap_or_default() {
        "html" => "text/html; charset=utf-8",
        "js" => "text/javascript",
        "json" => "application/json",
        "glb" => "model/gltf-binary",
        "png" => "image/png",
        "jpg" => "image/jpeg",
        _ => "application/octet-stream",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn get(port: u16, head: &str) -> String {
        let mut stream = TcpStream::connect((Ipv4Addr::LOCALHOST, port)).expect("a server");
        stream.write_all(head.as_bytes()).expect("a stream");
        let mut text = String::new();
        stream.read_to_string(&mut text).expect("an answer");
        text
    }

    #[test]
    fn files_of_two_folders_are_served_to_this_computer_alone() {
        let folder = tempfile::tempdir().expect("a folder");
        let [page, city] = ["page", "city"].map(|name| folder.path().join(name));
        for (path, text) in [
            (page.join("index.html"), "page"),
            (city.join("tiles/0/a.glb"), "tile"),
            (folder.path().join("secret"), "x"),
        ] {
            std::fs::create_dir_all(path.parent().expect("a folder")).expect("room");
            std::fs::write(path, text).expect("room");
        }
        let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, 0)).expect("a port");
        let port = listener.local_addr().expect("a port").port();
        let folders = Folders { page, city };
        std::thread::spawn(move || listener.incoming().flatten().for_each(|stream| drop(folders.answer(stream))));
        let of = |path: &str| get(port, &format!("GET {path} HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\n\r\n"));
        assert!(of("/").ends_with("\r\n\r\npage") && of("/").contains("text/html"));
        assert!(of("/city/tiles/0/a.glb?v=1").ends_with("\r\n\r\ntile"));
        for path in ["/city/../secret", "/../secret", "/city//secret", "/city/tiles", "/none", "secret"] {
            assert!(of(path).starts_with("HTTP/1.1 404"), "{path}");
        }
        assert!(get(port, "GET / HTTP/1.1\r\nHost: evil.example\r\n\r\n").starts_with("HTTP/1.1 404"));
        assert!(get(port, "POST / HTTP/1.1\r\nHost: localhost\r\n\r\n").starts_with("HTTP/1.1 404"));
    }
}
