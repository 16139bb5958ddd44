// Where a shader finds what shaders/shared/parameters.glsl names.

uniform Surface surface;
uniform Layer layers[MAX_LAYERS];
uniform int layer_count;
uniform sampler2D surface_data;  // one float a texel, rows of 1024

float fetch(int index) {
    return texelFetch(surface_data, ivec2(index & 1023, index >> 10), 0).r;
}
