// Light from above, a little from everywhere, and a little from the camera.
uniform vec3 g_CameraDirection;

in vec3 normal;
in vec4 colour;

out vec4 painted;

const vec3 SUN = normalize(vec3(0.35, -0.25, 0.9));

void main() {
    vec3 n = normalize(normal);
    float towards = -dot(n, g_CameraDirection);
    n = towards < 0.0 ? -n : n;
    float light = 0.42 + 0.08 * n.z + 0.38 * max(dot(n, SUN), 0.0) + 0.18 * abs(towards);
    painted = vec4(colour.rgb * light, colour.a);
}
