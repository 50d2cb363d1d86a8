// glTF files that are sound but for one number.
#pragma once

#include "tests/engine/assets/fixture.h"

#include <functional>
#include <ostream>
#include <string>

namespace plumbline::assets::test {

struct Spoiled {
    std::string name;
    std::function<void(TriangleFile&)> spoil;
    std::string why;  ///< it is refused
};

inline void PrintTo(const Spoiled& file, std::ostream* out) {
    *out << file.name;
}

inline std::string name_of(const ::testing::TestParamInfo<Spoiled>& info) {
    return info.param.name;
}

inline void expect_refused(const Spoiled& spoiled) {
    TriangleFile file;
    spoiled.spoil(file);
    expect_refused(file, spoiled.why);
}

}  // namespace plumbline::assets::test
