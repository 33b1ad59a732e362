//! Draws a garden with a house, without a window and without an engine: `wgpu.png`.
//!
//! `Model::meshes` gives one mesh for each material, and one for the tree, which the rules insert at many places.

mod garden;
#[cfg(test)]
mod tests;

use std::error::Error;

use bytemuck::cast_slice;
use cga::glam::camera::rh::proj::directx::perspective;
use cga::glam::camera::rh::view::look_at_mat4;
use cga::glam::{DMat4, Mat4, Vec3};
use cga::sink::meshes::{Granularity, Meshes, TriangleMesh};
use wgpu::util::{BufferInitDescriptor, DeviceExt};
use wgpu::*;

const WIDTH: u32 = 960;
const HEIGHT: u32 = 640;
const COLOR: TextureFormat = TextureFormat::Rgba8UnormSrgb;
const DEPTH: TextureFormat = TextureFormat::Depth32Float;
const SAMPLES: u32 = 4;

fn main() -> Result<(), Box<dyn Error>> {
    let model = garden::model()?;
    let pixels = pollster::block_on(draw(&model.meshes(Granularity::Material)))?;
    let mut png = png::Encoder::new(std::fs::File::create("wgpu.png")?, WIDTH, HEIGHT);
    png.set_color(png::ColorType::Rgba);
    png.write_header()?.write_image_data(&pixels)?;
    println!("wrote wgpu.png: {} leaves", model.len());
    Ok(())
}

/// A mesh in the memory of the graphics card: positions, normals and instances, and its indices.
struct Drawable {
    vertices: [Buffer; 3],
    indices: Buffer,
    counts: [u32; 2],
}

impl Drawable {
    fn new(device: &Device, mesh: &TriangleMesh) -> Self {
        let color = mesh.material.color();
        let color = [color.r, color.g, color.b, mesh.material.opacity()].map(|part| part as f32);
        let mut places: Vec<Mat4> = mesh.places.iter().map(|place| DMat4::from(*place).as_mat4()).collect();
        if places.is_empty() {
            places.push(Mat4::IDENTITY);
        }
        let instances: Vec<f32> =
            places.iter().flat_map(|place| place.to_cols_array().into_iter().chain(color)).collect();
        let lists = [cast_slice(&mesh.positions), cast_slice(&mesh.normals), cast_slice(&instances)];
        Drawable {
            vertices: lists.map(|list| buffer(device, list, BufferUsages::VERTEX)),
            indices: buffer(device, cast_slice(&mesh.indices), BufferUsages::INDEX),
            counts: [mesh.indices.len() as u32, places.len() as u32],
        }
    }
}

fn buffer(device: &Device, contents: &[u8], usage: BufferUsages) -> Buffer {
    device.create_buffer_init(&BufferInitDescriptor { label: None, contents, usage })
}

/// The meshes as an image: four bytes for each pixel.
async fn draw(meshes: &Meshes) -> Result<Vec<u8>, Box<dyn Error>> {
    let instance = wgpu::Instance::new(InstanceDescriptor::new_without_display_handle());
    let adapter = instance.request_adapter(&RequestAdapterOptions::default()).await?;
    let (device, queue) = adapter.request_device(&DeviceDescriptor::default()).await?;
    let module = device.create_shader_module(include_wgsl!("shader.wgsl"));
    let layout = |array_stride, step_mode, attributes| VertexBufferLayout { array_stride, step_mode, attributes };
    let instance_attributes =
        vertex_attr_array![2 => Float32x4, 3 => Float32x4, 4 => Float32x4, 5 => Float32x4, 6 => Float32x4];
    let pipeline = device.create_render_pipeline(&RenderPipelineDescriptor {
        label: None,
        layout: None,
        vertex: VertexState {
            module: &module,
            entry_point: None,
            compilation_options: PipelineCompilationOptions::default(),
            buffers: &[
                Some(layout(12, VertexStepMode::Vertex, &vertex_attr_array![0 => Float32x3])),
                Some(layout(12, VertexStepMode::Vertex, &vertex_attr_array![1 => Float32x3])),
                Some(layout(80, VertexStepMode::Instance, &instance_attributes)),
            ],
        },
        primitive: PrimitiveState { cull_mode: Some(Face::Back), ..PrimitiveState::default() },
        depth_stencil: Some(DepthStencilState {
            format: DEPTH,
            depth_write_enabled: Some(true),
            depth_compare: Some(CompareFunction::Less),
            stencil: StencilState::default(),
            bias: DepthBiasState::default(),
        }),
        multisample: MultisampleState { count: SAMPLES, ..MultisampleState::default() },
        fragment: Some(FragmentState {
            module: &module,
            entry_point: None,
            compilation_options: PipelineCompilationOptions::default(),
            targets: &[Some(COLOR.into())],
        }),
        multiview_mask: None,
        cache: None,
    });
    let view = look_at_mat4(Vec3::new(46.0, 20.0, 56.0), Vec3::new(16.0, 1.5, 14.0), Vec3::Y);
    let camera = perspective(0.52, WIDTH as f32 / HEIGHT as f32, 1.0, 200.0) * view;
    let camera = buffer(&device, cast_slice(&camera.to_cols_array()), BufferUsages::UNIFORM);
    let group = device.create_bind_group(&BindGroupDescriptor {
        label: None,
        layout: &pipeline.get_bind_group_layout(0),
        entries: &[BindGroupEntry { binding: 0, resource: camera.as_entire_binding() }],
    });
    let size = Extent3d { width: WIDTH, height: HEIGHT, depth_or_array_layers: 1 };
    let texture = |format, sample_count, usage| {
        let dimension = TextureDimension::D2;
        let usage = TextureUsages::RENDER_ATTACHMENT | usage;
        device.create_texture(&TextureDescriptor {
            label: None,
            size,
            mip_level_count: 1,
            sample_count,
            dimension,
            format,
            usage,
            view_formats: &[],
        })
    };
    let image = texture(COLOR, 1, TextureUsages::COPY_SRC);
    let [image_view, samples, depth] = [
        image.clone(),
        texture(COLOR, SAMPLES, TextureUsages::empty()),
        texture(DEPTH, SAMPLES, TextureUsages::empty()),
    ]
    .map(|texture| texture.create_view(&TextureViewDescriptor::default()));
    let drawables: Vec<Drawable> = meshes.into_iter().map(|mesh| Drawable::new(&device, mesh)).collect();
    let mut encoder = device.create_command_encoder(&CommandEncoderDescriptor::default());
    let mut pass = encoder.begin_render_pass(&RenderPassDescriptor {
        color_attachments: &[Some(RenderPassColorAttachment {
            view: &samples,
            depth_slice: None,
            resolve_target: Some(&image_view),
            ops: Operations {
                load: LoadOp::Clear(Color { r: 0.62, g: 0.74, b: 0.86, a: 1.0 }),
                store: StoreOp::Discard,
            },
        })],
        depth_stencil_attachment: Some(RenderPassDepthStencilAttachment {
            view: &depth,
            depth_ops: Some(Operations { load: LoadOp::Clear(1.0), store: StoreOp::Discard }),
            stencil_ops: None,
        }),
        ..RenderPassDescriptor::default()
    });
    pass.set_pipeline(&pipeline);
    pass.set_bind_group(0, &group, &[]);
    for Drawable { vertices, indices, counts } in &drawables {
        for (slot, list) in (0..).zip(vertices) {
            pass.set_vertex_buffer(slot, list.slice(..));
        }
        pass.set_index_buffer(indices.slice(..), IndexFormat::Uint32);
        pass.draw_indexed(0..counts[0], 0, 0..counts[1]);
    }
    drop(pass);
    let pixels = device.create_buffer(&BufferDescriptor {
        label: None,
        size: u64::from(WIDTH * HEIGHT * 4),
        usage: BufferUsages::COPY_DST | BufferUsages::MAP_READ,
        mapped_at_creation: false,
    });
    // Rows must be multiples of 256 bytes.
    const { assert!(WIDTH.is_multiple_of(64)) };
    let layout = TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(WIDTH * 4), rows_per_image: None };
    encoder.copy_texture_to_buffer(image.as_image_copy(), TexelCopyBufferInfo { buffer: &pixels, layout }, size);
    queue.submit([encoder.finish()]);
    read(&device, &pixels)
}

/// Waits for the submitted work and copies the bytes of a buffer.
fn read(device: &Device, buffer: &Buffer) -> Result<Vec<u8>, Box<dyn Error>> {
    let (send, receive) = std::sync::mpsc::channel();
    buffer.map_async(MapMode::Read, .., move |result| drop(send.send(result)));
    device.poll(PollType::wait_indefinitely())?;
    receive.try_recv()?.map_err(|error| format!("the picture cannot be read: {error}"))?;
    Ok(buffer.get_mapped_range(..)?.to_vec())
}
