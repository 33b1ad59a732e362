//! Draws a garden with a house, without a window and without an engine: `wgpu.png`.
//!
//! `Model::meshes` gives one mesh for each material, and one for the tree, which the rules insert at many places.

mod garden;
#[cfg(test)]
mod tests;

use std::error::Error;

use bytemuck::cast_slice;
use cga::glam::{DAffine3, DMat4, Vec3, camera::rh};
use cga::sink::meshes::{Granularity, Meshes, TriangleMesh};
use wgpu::util::{BufferInitDescriptor, DeviceExt};
use wgpu::*;

const WIDTH: u32 = 960;
const HEIGHT: u32 = 640;
const COLOR: TextureFormat = TextureFormat::Rgba8UnormSrgb;
const DEPTH: TextureFormat = TextureFormat::Depth32Float;
const SAMPLES: u32 = 4;
const SKY: Color = Color { r: 0.62, g: 0.74, b: 0.86, a: 1.0 };

fn main() -> Result<(), Box<dyn Error>> {
    let model = garden::model()?;
    let pixels = pollster::block_on(draw(&model.meshes(Granularity::Material)))?;
    let mut png = png::Encoder::new(std::fs::File::create("wgpu.png")?, WIDTH, HEIGHT);
    png.set_color(png::ColorType::Rgba);
    png.write_header()?.write_image_data(&pixels)?;
    println!("wrote wgpu.png: {} leaves", model.len());
    Ok(())
}

/// The meshes as an image: four bytes for each pixel.
async fn draw(meshes: &Meshes) -> Result<Vec<u8>, Box<dyn Error>> {
    let adapter = Instance::default().request_adapter(&Default::default()).await?;
    let (device, queue) = adapter.request_device(&Default::default()).await?;
    let pipeline = pipeline(&device);
    let view = rh::view::look_at_mat4(Vec3::new(46.0, 20.0, 56.0), Vec3::new(16.0, 1.5, 14.0), Vec3::Y);
    let camera = rh::proj::directx::perspective(0.52, WIDTH as f32 / HEIGHT as f32, 1.0, 200.0) * view;
    let camera = buffer(&device, cast_slice(&camera.to_cols_array()), BufferUsages::UNIFORM);
    let entries = &[BindGroupEntry { binding: 0, resource: camera.as_entire_binding() }];
    let layout = &pipeline.get_bind_group_layout(0);
    let group = device.create_bind_group(&BindGroupDescriptor { label: None, layout, entries });
    let size = Extent3d { width: WIDTH, height: HEIGHT, depth_or_array_layers: 1 };
    let texture = |format, sample_count, usage| {
        device.create_texture(&TextureDescriptor {
            label: None,
            size,
            mip_level_count: 1,
            sample_count,
            dimension: TextureDimension::D2,
            format,
            usage: TextureUsages::RENDER_ATTACHMENT | usage,
            view_formats: &[],
        })
    };
    let image = texture(COLOR, 1, TextureUsages::COPY_SRC);
    let samples = texture(COLOR, SAMPLES, TextureUsages::empty()).create_view(&Default::default());
    let depth = texture(DEPTH, SAMPLES, TextureUsages::empty()).create_view(&Default::default());
    let depth_ops = Some(Operations { load: LoadOp::Clear(1.0), store: StoreOp::Discard });
    let mut encoder = device.create_command_encoder(&Default::default());
    let mut pass = encoder.begin_render_pass(&RenderPassDescriptor {
        color_attachments: &[Some(RenderPassColorAttachment {
            view: &samples,
            depth_slice: None,
            resolve_target: Some(&image.create_view(&Default::default())),
            ops: Operations { load: LoadOp::Clear(SKY), store: StoreOp::Discard },
        })],
        depth_stencil_attachment: Some(RenderPassDepthStencilAttachment { view: &depth, depth_ops, stencil_ops: None }),
        ..Default::default()
    });
    pass.set_pipeline(&pipeline);
    pass.set_bind_group(0, &group, &[]);
    // The pass keeps the buffers until it has run.
    for mesh in meshes {
        let instances = instances(mesh);
        let lists = [cast_slice(&mesh.positions), cast_slice(&mesh.normals), cast_slice(&instances)];
        for (slot, list) in (0..).zip(lists) {
            pass.set_vertex_buffer(slot, buffer(&device, list, BufferUsages::VERTEX).slice(..));
        }
        let indices = buffer(&device, cast_slice(&mesh.indices), BufferUsages::INDEX);
        pass.set_index_buffer(indices.slice(..), IndexFormat::Uint32);
        pass.draw_indexed(0..mesh.indices.len() as u32, 0, 0..instances.len() as u32);
    }
    drop(pass);
    // Rows must be multiples of 256 bytes.
    const { assert!(WIDTH.is_multiple_of(64)) };
    let layout = TexelCopyBufferLayout { bytes_per_row: Some(WIDTH * 4), ..Default::default() };
    let pixels = device.create_buffer(&BufferDescriptor {
        label: None,
        size: u64::from(WIDTH * HEIGHT * 4),
        usage: BufferUsages::COPY_DST | BufferUsages::MAP_READ,
        mapped_at_creation: false,
    });
    encoder.copy_texture_to_buffer(image.as_image_copy(), TexelCopyBufferInfo { buffer: &pixels, layout }, size);
    queue.submit([encoder.finish()]);
    read(&device, &pixels)
}

/// For each place of a mesh: the columns of its matrix, and the colour of the material.
fn instances(mesh: &TriangleMesh) -> Vec<[[f32; 4]; 5]> {
    let color = mesh.material.color();
    let color = [color.r, color.g, color.b, mesh.material.opacity()].map(|part| part as f32);
    let places = if mesh.places.is_empty() { &[DAffine3::IDENTITY] } else { mesh.places.as_slice() };
    let columns = places.iter().map(|place| DMat4::from(*place).as_mat4().to_cols_array_2d());
    columns.map(|[x, y, z, origin]| [x, y, z, origin, color]).collect()
}

fn buffer(device: &Device, contents: &[u8], usage: BufferUsages) -> Buffer {
    device.create_buffer_init(&BufferInitDescriptor { label: None, contents, usage })
}

fn pipeline(device: &Device) -> RenderPipeline {
    let module = &device.create_shader_module(include_wgsl!("shader.wgsl"));
    let layout = |array_stride, step_mode, attributes| Some(VertexBufferLayout { array_stride, step_mode, attributes });
    let instance = vertex_attr_array![2 => Float32x4, 3 => Float32x4, 4 => Float32x4, 5 => Float32x4, 6 => Float32x4];
    let buffers = &[
        layout(12, VertexStepMode::Vertex, &vertex_attr_array![0 => Float32x3]),
        layout(12, VertexStepMode::Vertex, &vertex_attr_array![1 => Float32x3]),
        layout(80, VertexStepMode::Instance, &instance),
    ];
    let targets = &[Some(COLOR.into())];
    device.create_render_pipeline(&RenderPipelineDescriptor {
        label: None,
        layout: None,
        vertex: VertexState { module, entry_point: None, compilation_options: Default::default(), buffers },
        primitive: PrimitiveState { cull_mode: Some(Face::Back), ..Default::default() },
        depth_stencil: Some(DepthStencilState {
            format: DEPTH,
            depth_write_enabled: Some(true),
            depth_compare: Some(CompareFunction::Less),
            stencil: Default::default(),
            bias: Default::default(),
        }),
        multisample: MultisampleState { count: SAMPLES, ..Default::default() },
        fragment: Some(FragmentState { module, entry_point: None, compilation_options: Default::default(), targets }),
        multiview_mask: None,
        cache: None,
    })
}

/// Waits for the submitted work and copies the bytes of a buffer.
fn read(device: &Device, buffer: &Buffer) -> Result<Vec<u8>, Box<dyn Error>> {
    let (send, receive) = std::sync::mpsc::channel();
    buffer.map_async(MapMode::Read, .., move |result| drop(send.send(result)));
    device.poll(PollType::wait_indefinitely())?;
    receive.try_recv()?.map_err(|error| format!("the picture cannot be read: {error}"))?;
    Ok(buffer.get_mapped_range(..)?.to_vec())
}
