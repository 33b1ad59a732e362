// Colour and depth of the triangles of a model, lit by the sun and the sky.

struct Views {
    camera: mat4x4f,
    sun: mat4x4f,
    to_sun: vec4f,
}

@group(0) @binding(0) var<uniform> views: Views;
@group(0) @binding(1) var shadow: texture_depth_2d;
@group(0) @binding(2) var in_sun: sampler_comparison;

// Columns 2 to 5 are the place of an instance.
struct Corner {
    @location(0) position: vec3f, @location(1) normal: vec3f,
    @location(2) x: vec4f, @location(3) y: vec4f, @location(4) z: vec4f, @location(5) origin: vec4f,
    @location(6) color: vec4f,
}

struct Varying {
    @builtin(position) position: vec4f,
    @location(0) normal: vec3f,
    @location(1) color: vec4f,
    @location(2) world: vec3f,
}

fn world(in: Corner) -> vec4f {
    return mat4x4f(in.x, in.y, in.z, in.origin) * vec4f(in.position, 1.0);
}

@vertex
fn shade(in: Corner) -> @builtin(position) vec4f {
    return views.sun * world(in);
}

@vertex
fn vertex(in: Corner) -> Varying {
    let place = world(in);
    // Normals turn with the inverse transpose, up to a factor.
    let turn = mat3x3f(cross(in.y.xyz, in.z.xyz), cross(in.z.xyz, in.x.xyz), cross(in.x.xyz, in.y.xyz));
    return Varying(views.camera * place, turn * in.normal, in.color, place.xyz);
}

// The share of the sun that reaches a place: the mean of nine pixels of the sun's picture.
fn sunlight(place: vec3f) -> f32 {
    let seen = views.sun * vec4f(place, 1.0);
    let at = vec2f(0.5 + 0.5 * seen.x, 0.5 - 0.5 * seen.y);
    let pixel = 1.0 / vec2f(textureDimensions(shadow));
    var light = 0.0;
    for (var step = 0; step < 9; step++) {
        let moved = at + pixel * vec2f(f32(step % 3 - 1), f32(step / 3 - 1));
        light += textureSampleCompareLevel(shadow, in_sun, moved, seen.z);
    }
    return light / 9.0;
}

@fragment
fn fragment(in: Varying) -> @location(0) vec4f {
    let normal = normalize(in.normal);
    let sun = max(dot(normal, views.to_sun.xyz), 0.0) * sunlight(in.world + 0.03 * normal);
    let sky = vec3f(0.36, 0.42, 0.5) * (0.6 + 0.4 * normal.y);
    let linear = pow(in.color.rgb, vec3f(2.2));
    return vec4f(linear * (sky + vec3f(0.95, 0.9, 0.8) * sun), in.color.a);
}
