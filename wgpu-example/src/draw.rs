//! Meshes as an image: the depth of what the sun sees first, then the picture with its shadows.

use std::error::Error;

use bytemuck::cast_slice;
use cga::glam::{DAffine3, DMat4, Mat4, Vec3, camera::rh};
use cga::sink::meshes::{Meshes, TriangleMesh};
use wgpu::*;

use crate::gpu;

pub(crate) const WIDTH: u32 = 960;
pub(crate) const HEIGHT: u32 = 640;
// Rows of the image are multiples of 256 bytes.
const _: () = assert!(WIDTH.is_multiple_of(64));
const COLOR: TextureFormat = TextureFormat::Rgba8UnormSrgb;
const DEPTH: TextureFormat = TextureFormat::Depth32Float;
const SAMPLES: u32 = 4;
/// The width and the height of the sun's picture in pixels.
const SUN: u32 = 4096;
const SKY: Color = Color { r: 0.62, g: 0.74, b: 0.86, a: 1.0 };

/// Camera and sun as the shader has them: two matrices, and the direction to the sun.
fn views() -> Vec<f32> {
    let centre = Vec3::new(8.5, 9.2, 8.0);
    let camera = rh::view::look_at_mat4(Vec3::new(33.0, 9.5, 39.0), centre, Vec3::Y);
    let camera = rh::proj::directx::perspective(0.84, WIDTH as f32 / HEIGHT as f32, 1.0, 200.0) * camera;
    let to_sun = Vec3::new(-0.35, 0.75, 0.6).normalize();
    let sun = rh::view::look_at_mat4(centre + 60.0 * to_sun, centre, Vec3::Y);
    let sun = rh::proj::directx::orthographic(-32.0, 32.0, -32.0, 32.0, 1.0, 120.0) * sun;
    [camera, sun].iter().flat_map(Mat4::to_cols_array).chain(to_sun.extend(0.0).to_array()).collect()
}

/// Four bytes for each pixel.
pub(crate) async fn draw(meshes: &Meshes) -> Result<Vec<u8>, Box<dyn Error>> {
    let adapter = Instance::default().request_adapter(&Default::default()).await?;
    let (device, queue) = adapter.request_device(&Default::default()).await?;
    let meshes: Vec<Buffers> = meshes.into_iter().map(|mesh| Buffers::new(&device, mesh)).collect();
    let views = gpu::buffer(&device, cast_slice(&views()), BufferUsages::UNIFORM);
    let view = |texture: &Texture| texture.create_view(&Default::default());

    let shadow = view(&gpu::texture(&device, [SUN; 2], DEPTH, 1, TextureUsages::TEXTURE_BINDING));
    let mut encoder = device.create_command_encoder(&Default::default());
    let casting = pipeline(&device, "shade", None);
    let group = gpu::group(&device, &casting, &[views.as_entire_binding()]);
    let mut pass = encoder.begin_render_pass(&RenderPassDescriptor {
        depth_stencil_attachment: gpu::depth(&shadow, StoreOp::Store),
        ..Default::default()
    });
    record(&mut pass, &casting, &group, &meshes);
    drop(pass);

    let compare = Some(CompareFunction::LessEqual);
    let [mag_filter, min_filter] = [FilterMode::Linear; 2];
    let sampler = device.create_sampler(&SamplerDescriptor { compare, mag_filter, min_filter, ..Default::default() });
    let size = [WIDTH, HEIGHT];
    let image = gpu::texture(&device, size, COLOR, 1, TextureUsages::COPY_SRC);
    let samples = view(&gpu::texture(&device, size, COLOR, SAMPLES, TextureUsages::empty()));
    let depth = view(&gpu::texture(&device, size, DEPTH, SAMPLES, TextureUsages::empty()));
    let lighting = pipeline(&device, "vertex", Some("fragment"));
    let resources =
        [views.as_entire_binding(), BindingResource::TextureView(&shadow), BindingResource::Sampler(&sampler)];
    let group = gpu::group(&device, &lighting, &resources);
    let mut pass = encoder.begin_render_pass(&RenderPassDescriptor {
        color_attachments: &[Some(RenderPassColorAttachment {
            view: &samples,
            depth_slice: None,
            resolve_target: Some(&view(&image)),
            ops: Operations { load: LoadOp::Clear(SKY), store: StoreOp::Discard },
        })],
        depth_stencil_attachment: gpu::depth(&depth, StoreOp::Discard),
        ..Default::default()
    });
    record(&mut pass, &lighting, &group, &meshes);
    drop(pass);

    let pixels = gpu::pixels(&device, &mut encoder, &image);
    queue.submit([encoder.finish()]);
    gpu::read(&device, &pixels)
}

/// A mesh on the graphics card: positions, normals and instances, and indices.
struct Buffers {
    vertices: [Buffer; 3],
    indices: Buffer,
    counts: [u32; 2],
}

impl Buffers {
    fn new(device: &Device, mesh: &TriangleMesh) -> Self {
        let instances = instances(mesh);
        let lists = [cast_slice(&mesh.positions), cast_slice(&mesh.normals), cast_slice(&instances)];
        Buffers {
            vertices: lists.map(|list| gpu::buffer(device, list, BufferUsages::VERTEX)),
            indices: gpu::buffer(device, cast_slice(&mesh.indices), BufferUsages::INDEX),
            counts: [mesh.indices.len(), instances.len()].map(|count| count as u32),
        }
    }
}

/// For each place of a mesh: the columns of its matrix, and the colour of the material.
pub(crate) fn instances(mesh: &TriangleMesh) -> Vec<[[f32; 4]; 5]> {
    let color = mesh.material.color();
    let color = [color.r, color.g, color.b, mesh.material.opacity()].map(|part| part as f32);
    let places = if mesh.places.is_empty() { &[DAffine3::IDENTITY] } else { mesh.places.as_slice() };
    let columns = places.iter().map(|place| DMat4::from(*place).as_mat4().to_cols_array_2d());
    columns.map(|[x, y, z, origin]| [x, y, z, origin, color]).collect()
}

fn record(pass: &mut RenderPass<'_>, pipeline: &RenderPipeline, group: &BindGroup, meshes: &[Buffers]) {
    pass.set_pipeline(pipeline);
    pass.set_bind_group(0, group, &[]);
    for Buffers { vertices, indices, counts: [corners, instances] } in meshes {
        for (slot, list) in (0..).zip(vertices) {
            pass.set_vertex_buffer(slot, list.slice(..));
        }
        pass.set_index_buffer(indices.slice(..), IndexFormat::Uint32);
        pass.draw_indexed(0..*corners, 0, 0..*instances);
    }
}

/// The way from meshes to a picture. Without a function for pixels it makes depths alone.
fn pipeline(device: &Device, vertex: &str, fragment: Option<&str>) -> RenderPipeline {
    let module = &device.create_shader_module(include_wgsl!("shader.wgsl"));
    let layout = |array_stride, step_mode, attributes| Some(VertexBufferLayout { array_stride, step_mode, attributes });
    let instance = vertex_attr_array![2 => Float32x4, 3 => Float32x4, 4 => Float32x4, 5 => Float32x4, 6 => Float32x4];
    let buffers = &[
        layout(12, VertexStepMode::Vertex, &vertex_attr_array![0 => Float32x3]),
        layout(12, VertexStepMode::Vertex, &vertex_attr_array![1 => Float32x3]),
        layout(80, VertexStepMode::Instance, &instance),
    ];
    let compilation_options = PipelineCompilationOptions::default;
    let targets = &[Some(COLOR.into())];
    let is_shadow = fragment.is_none();
    device.create_render_pipeline(&RenderPipelineDescriptor {
        label: None,
        layout: None,
        vertex: VertexState { module, entry_point: Some(vertex), compilation_options: compilation_options(), buffers },
        // Thin parts cast shadows with both sides.
        primitive: PrimitiveState { cull_mode: (!is_shadow).then_some(Face::Back), ..Default::default() },
        depth_stencil: Some(DepthStencilState {
            format: DEPTH,
            depth_write_enabled: Some(true),
            depth_compare: Some(CompareFunction::Less),
            stencil: Default::default(),
            // A surface casts no shadow on itself.
            bias: DepthBiasState { slope_scale: if is_shadow { 2.0 } else { 0.0 }, ..Default::default() },
        }),
        multisample: MultisampleState { count: if is_shadow { 1 } else { SAMPLES }, ..Default::default() },
        fragment: fragment.map(|name| FragmentState {
            module,
            entry_point: Some(name),
            compilation_options: compilation_options(),
            targets,
        }),
        multiview_mask: None,
        cache: None,
    })
}
