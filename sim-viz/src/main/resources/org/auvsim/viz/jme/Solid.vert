// One instance: three columns of turn and size with red, green and blue in their fourth places,
// and the place with the opacity.
uniform mat4 g_ViewProjectionMatrix;

in vec3 inPosition;
in vec3 inNormal;
in mat4 inInstanceData;

out vec3 normal;
out vec4 colour;

void main() {
    vec3 x = inInstanceData[0].xyz;
    vec3 y = inInstanceData[1].xyz;
    vec3 z = inInstanceData[2].xyz;
    vec3 place = inPosition.x * x + inPosition.y * y + inPosition.z * z + inInstanceData[3].xyz;
    // Across a stretched surface: by the sizes' inverses.
    normal = inNormal.x * x / max(dot(x, x), 1e-12)
            + inNormal.y * y / max(dot(y, y), 1e-12)
            + inNormal.z * z / max(dot(z, z), 1e-12);
    colour = vec4(inInstanceData[0].w, inInstanceData[1].w, inInstanceData[2].w, inInstanceData[3].w);
    gl_Position = g_ViewProjectionMatrix * vec4(place, 1.0);
}
