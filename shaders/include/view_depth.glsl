// The depth image as metres along the line of sight.

uniform sampler2D depth_image;
uniform vec2 depth_line;  // 1 / metres = x + y * depth

const float kFarthest_m = 6e4;     // that a half float holds
const float kLeastReach_px = 3.0;  // whose occlusion cannot be seen any more

float view_depth(float depth) { return 1.0 / max(depth_line.x + depth_line.y * depth, 1e-6); }
