uniform mat4 g_ViewProjectionMatrix;

in vec3 inPosition;
in vec4 inColor;

out vec4 colour;

void main() {
    colour = inColor;
    gl_Position = g_ViewProjectionMatrix * vec4(inPosition, 1.0);
}
