#pragma once
#include <cstdint>
namespace plumbline::ecs {
struct Entity {
    std::uint32_t index{0};
    std::uint32_t generation{0};
};
class Registry {};
}  // namespace plumbline::ecs
