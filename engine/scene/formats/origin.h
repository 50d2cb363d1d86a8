// Where in a file something was said.
#pragma once

#include <string>

namespace plumbline::scene {

/// "garden.toml:14".
struct Origin {
    std::string file;
    int line{0};
};
std::string to_string(const Origin& origin);

}  // namespace plumbline::scene
