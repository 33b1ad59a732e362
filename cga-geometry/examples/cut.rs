//! Cuts a mesh from a file into slabs, as a command: how the cutter is compared with others.
//!
//! ```text
//! cut --mesh MESH.ply --axis 0|1|2 --offsets FILE --out DIR --repeat N [--triangles]
//! ```
//!
//! The mesh is binary little-endian PLY (double coordinates, `uchar` count and `int` indices); the offsets stand one a
//! line, rising. Slab i is written as `DIR/part_0000i.ply` in triangles, nothing for an empty one. The last line printed
//! is JSON with the time of each repeat in milliseconds: the cut with its caps, which are polygons, and with `--triangles`
//! their triangulation too.

use std::error::Error;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, Instant};
use std::{env, fs};

use cga_geometry::Axis;
use cga_geometry::cut;
use cga_geometry::mesh::{FaceTag, Mesh, MeshBuilder};
use cga_geometry::triangulate::Triangulator;

type Failure = Box<dyn Error>;

struct Options {
    mesh: PathBuf,
    axis: Axis,
    offsets: Vec<f64>,
    out: PathBuf,
    repeat: usize,
    triangles: bool,
}

fn main() -> Result<(), Failure> {
    let options = options()?;
    let bytes = fs::read(&options.mesh)?;
    let start = Instant::now();
    let mesh = match read_ply(&bytes) {
        Ok(mesh) => Arc::new(mesh),
        Err(error) => {
            println!("{{\"refused\": {:?}}}", error.to_string());
            return Ok(());
        }
    };
    mesh.bounds();
    let prepared = start.elapsed().as_secs_f64() * 1e3;
    let mut triangulator = Triangulator::new();
    let mut cut = || {
        let slabs = cut::slabs(&mesh, options.axis, &options.offsets);
        let triangles: Vec<Vec<[u32; 3]>> = if options.triangles {
            slabs.parts.iter().flatten().map(|part| triangles(&mut triangulator, part)).collect()
        } else {
            Vec::new()
        };
        (slabs, triangles)
    };
    // A cut that takes less than this is repeated for each measurement, because clocks are too coarse for it.
    const SHORT: Duration = Duration::from_millis(5);
    let start = Instant::now();
    let mut last = cut();
    let times = (SHORT.as_secs_f64() / start.elapsed().as_secs_f64()).ceil() as u32;
    let (mut wall, mut cpu) = (Vec::new(), Vec::new());
    for _ in 0..options.repeat.max(1) {
        let (start, busy) = (Instant::now(), processor_time());
        for _ in 1..times {
            cut();
        }
        let result = cut();
        let each = 1e3 / f64::from(times);
        cpu.extend(processor_time().zip(busy).map(|(end, start)| (end - start).as_secs_f64() * each));
        wall.push(start.elapsed().as_secs_f64() * each);
        last = result;
    }
    let (slabs, _) = last;
    for (number, part) in slabs.parts.iter().enumerate() {
        if let Some(part) = part {
            let file = options.out.join(format!("part_{number:05}.ply"));
            write_ply(&file, part, &triangles(&mut triangulator, part))?;
        }
    }
    println!(
        "{{\"wall_ms\": {wall:?}, \"cpu_ms\": {cpu:?}, \"prep_ms\": {prepared}, \"open_chains\": {}}}",
        slabs.open.len()
    );
    Ok(())
}

fn options() -> Result<Options, Failure> {
    let mut found = std::collections::HashMap::new();
    let mut triangles = false;
    let mut args = env::args().skip(1);
    while let Some(key) = args.next() {
        if key == "--triangles" {
            triangles = true;
        } else {
            let value = args.next().ok_or_else(|| format!("{key} needs a value"))?;
            found.insert(key, value);
        }
    }
    let get = |key: &str| found.get(key).cloned().ok_or_else(|| format!("{key} is missing"));
    let axis = match get("--axis")?.as_str() {
        "0" => Axis::X,
        "1" => Axis::Y,
        "2" => Axis::Z,
        other => return Err(format!("no axis {other}").into()),
    };
    let lines = fs::read_to_string(get("--offsets")?)?;
    let offsets = lines.split_whitespace().map(str::parse).collect::<Result<Vec<f64>, _>>()?;
    let repeat = found.get("--repeat").map_or(Ok(1), |text| text.parse())?;
    Ok(Options { mesh: get("--mesh")?.into(), axis, offsets, out: get("--out")?.into(), repeat, triangles })
}

/// The processor time of this thread, where the system reports it.
fn processor_time() -> Option<Duration> {
    #[cfg(unix)]
    {
        let time = rustix::time::clock_gettime(rustix::time::ClockId::ThreadCPUTime);
        Some(Duration::new(time.tv_sec as u64, time.tv_nsec as u32))
    }
    #[cfg(not(unix))]
    None
}

fn triangles(triangulator: &mut Triangulator, mesh: &Mesh) -> Vec<[u32; 3]> {
    let mut found = Vec::with_capacity(mesh.corners().len());
    (0..mesh.face_count()).for_each(|face| triangulator.face(mesh, face, &mut found));
    found.iter_mut().flatten().for_each(|corner| *corner = mesh.corners()[*corner as usize]);
    found
}

fn read_ply(bytes: &[u8]) -> Result<Mesh, Failure> {
    let marker = b"end_header\n";
    let header_end = bytes.windows(marker.len()).position(|w| w == marker).ok_or("no header")? + marker.len();
    let header = String::from_utf8_lossy(&bytes[..header_end]).into_owned();
    let count = |name: &str| -> Result<usize, Failure> {
        let line = header.lines().find_map(|line| line.strip_prefix(&format!("element {name} ")));
        Ok(line.ok_or_else(|| format!("no {name}"))?.trim().parse()?)
    };
    let mut rest = &bytes[header_end..];
    let mut builder = MeshBuilder::new();
    for _ in 0..count("vertex")? {
        let mut point = [0.0; 3];
        for coordinate in &mut point {
            *coordinate = f64::from_le_bytes(take(&mut rest)?);
        }
        builder.point(point);
    }
    let mut outline = Vec::new();
    for _ in 0..count("face")? {
        let [corners] = take(&mut rest)?;
        outline.clear();
        for _ in 0..corners {
            outline.push(u32::from_le_bytes(take(&mut rest)?));
        }
        builder.face(&outline, &[], FaceTag::PLAIN);
    }
    Ok(builder.build()?)
}

fn take<const N: usize>(rest: &mut &[u8]) -> Result<[u8; N], Failure> {
    let (head, tail) = rest.split_first_chunk::<N>().ok_or("the file is too short")?;
    *rest = tail;
    Ok(*head)
}

fn write_ply(file: &Path, mesh: &Mesh, triangles: &[[u32; 3]]) -> Result<(), Failure> {
    let mut header = String::from("ply\nformat binary_little_endian 1.0\n");
    writeln!(header, "element vertex {}", mesh.points().len())?;
    header += "property double x\nproperty double y\nproperty double z\n";
    writeln!(header, "element face {}", triangles.len())?;
    header += "property list uchar int vertex_indices\nend_header\n";
    let mut bytes = header.into_bytes();
    for point in mesh.points() {
        point.to_array().iter().for_each(|c| bytes.extend(c.to_le_bytes()));
    }
    for triangle in triangles {
        bytes.push(3);
        triangle.iter().for_each(|i| bytes.extend(i.to_le_bytes()));
    }
    Ok(fs::write(file, bytes)?)
}
