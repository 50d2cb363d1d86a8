// The way of what is here in pixels, and whether it is here as the shutter closes (1) or was before
// (0.5). Passes: motion_blur.

in vec4 place_now;
in vec4 place_before;
flat in float surface_moment;
uniform vec2 size_px;

layout(location = 0) out vec4 out_way;

void main() {
    vec2 way = place_now.xy / max(place_now.w, 1e-3) - place_before.xy / max(place_before.w, 1e-3);
    out_way = vec4(way * 0.5 * size_px, surface_moment > 0.0 ? 0.5 : 1.0, 1.0);
}
