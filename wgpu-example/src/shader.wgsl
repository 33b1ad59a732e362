// Colour and depth of the triangles of a model, lit by the sun and the sky.

@group(0) @binding(0) var<uniform> camera: mat4x4f;

struct Varying {
    @builtin(position) position: vec4f,
    @location(0) normal: vec3f,
    @location(1) color: vec4f,
}

// Columns 2 to 5 are the place of an instance.
@vertex
fn vertex(
    @location(0) position: vec3f, @location(1) normal: vec3f,
    @location(2) x: vec4f, @location(3) y: vec4f, @location(4) z: vec4f, @location(5) origin: vec4f,
    @location(6) color: vec4f,
) -> Varying {
    let place = mat4x4f(x, y, z, origin);
    // Normals turn with the inverse transpose, up to a factor.
    let turn = mat3x3f(cross(y.xyz, z.xyz), cross(z.xyz, x.xyz), cross(x.xyz, y.xyz));
    return Varying(camera * place * vec4f(position, 1.0), turn * normal, color);
}

@fragment
fn fragment(in: Varying) -> @location(0) vec4f {
    let normal = normalize(in.normal);
    let sun = max(dot(normal, normalize(vec3f(0.7, 0.9, 0.4))), 0.0);
    let sky = 0.5 + 0.5 * normal.y;
    let linear = pow(in.color.rgb, vec3f(2.2));
    return vec4f(linear * (0.25 + 0.25 * sky + 0.75 * sun), in.color.a);
}
