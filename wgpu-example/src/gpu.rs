//! Buffers, textures and pixels of wgpu in few words.

use std::error::Error;

use wgpu::util::{BufferInitDescriptor, DeviceExt};
use wgpu::*;

pub(crate) fn buffer(device: &Device, contents: &[u8], usage: BufferUsages) -> Buffer {
    device.create_buffer_init(&BufferInitDescriptor { label: None, contents, usage })
}

/// A texture without smaller levels.
pub(crate) fn texture(
    device: &Device,
    [width, height]: [u32; 2],
    format: TextureFormat,
    sample_count: u32,
    usage: TextureUsages,
) -> Texture {
    device.create_texture(&TextureDescriptor {
        label: None,
        size: Extent3d { width, height, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count,
        dimension: TextureDimension::D2,
        format,
        usage: TextureUsages::RENDER_ATTACHMENT | usage,
        view_formats: &[],
    })
}

/// The depth texture of a pass, which is cleared first.
pub(crate) fn depth(view: &TextureView, store: StoreOp) -> Option<RenderPassDepthStencilAttachment<'_>> {
    let depth_ops = Some(Operations { load: LoadOp::Clear(1.0), store });
    Some(RenderPassDepthStencilAttachment { view, depth_ops, stencil_ops: None })
}

/// The resources of a pipeline by their number.
pub(crate) fn group(device: &Device, pipeline: &RenderPipeline, resources: &[BindingResource<'_>]) -> BindGroup {
    let numbered = (0..).zip(resources);
    let entries: Vec<BindGroupEntry<'_>> =
        numbered.map(|(binding, resource)| BindGroupEntry { binding, resource: resource.clone() }).collect();
    let layout = &pipeline.get_bind_group_layout(0);
    device.create_bind_group(&BindGroupDescriptor { label: None, layout, entries: &entries })
}

/// A buffer with the pixels of an image of four bytes a pixel. Rows must be multiples of 256 bytes.
pub(crate) fn pixels(device: &Device, encoder: &mut CommandEncoder, image: &Texture) -> Buffer {
    let Extent3d { width, height, .. } = image.size();
    let layout = TexelCopyBufferLayout { bytes_per_row: Some(width * 4), ..Default::default() };
    let pixels = device.create_buffer(&BufferDescriptor {
        label: None,
        size: u64::from(width * height * 4),
        usage: BufferUsages::COPY_DST | BufferUsages::MAP_READ,
        mapped_at_creation: false,
    });
    encoder.copy_texture_to_buffer(
        image.as_image_copy(),
        TexelCopyBufferInfo { buffer: &pixels, layout },
        image.size(),
    );
    pixels
}

/// Waits for the submitted work and copies the bytes of a buffer.
pub(crate) fn read(device: &Device, buffer: &Buffer) -> Result<Vec<u8>, Box<dyn Error>> {
    let (send, receive) = std::sync::mpsc::channel();
    buffer.map_async(MapMode::Read, .., move |result| drop(send.send(result)));
    device.poll(PollType::wait_indefinitely())?;
    receive.try_recv()?.map_err(|error| format!("the picture cannot be read: {error}"))?;
    Ok(buffer.get_mapped_range(..)?.to_vec())
}
