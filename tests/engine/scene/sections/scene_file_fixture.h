// Scene texts in a folder of their own, loaded, and what was said about them.
#pragma once

#include "engine/scene/scene_file.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::scene {

inline constexpr Real kSlack{1e-6_r};

/// Four lines: an entity "a" with a body.
inline constexpr const char* kMovable = "[[entity]]\nname=\"a\"\nprimitive={sphere=1}\nbody={}\n";

inline void expect_near(const Vec3& value, const Vec3& wanted) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(value[i], wanted[i], kSlack) << "part " << i;
}
inline void expect_near_f(const Vec3f& value, const Vec3f& wanted) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(value[i], wanted[i], 1e-6F) << "part " << i;
}

/// A folder that is empty at first and gone at the end. Inside: assets/, and whatever is written.
class SceneFileTest : public testing::Test {
protected:
    void SetUp() override {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        folder_ =
            std::filesystem::temp_directory_path() /
            fmt::format("plumbline_{}_{}_{}", test->test_suite_name(), test->name(), getpid());
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(assets());
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    const std::filesystem::path& folder() const { return folder_; }
    std::filesystem::path assets() const { return folder_ / "assets"; }

    /// `name` is relative to the test's folder.
    void write(const std::string& name, std::string_view text) const {
        const std::filesystem::path file = folder_ / name;
        std::filesystem::create_directories(file.parent_path());
        std::ofstream out(file, std::ios::binary);
        out.write(text.data(), static_cast<std::streamsize>(text.size()));
    }

    struct Outcome {
        Result<SceneDescription> scene;
        std::vector<std::string> faults;  ///< as printed, without the folder
        std::vector<Diagnostic> diagnostics;
    };

    Outcome load_file(const std::string& name) const {
        Diagnostics faults;
        Result<SceneDescription> scene = read_description(folder_ / name, assets(), faults);
        Outcome outcome{std::move(scene), {}, faults.list()};
        for (const Diagnostic& fault : faults.list()) {
            std::string line = to_string(fault);
            const std::string prefix = folder_.string() + "/";
            if (line.rfind(prefix, 0) == 0) line.erase(0, prefix.size());
            outcome.faults.push_back(std::move(line));
        }
        return outcome;
    }

    Outcome load(std::string_view text) const {
        write("scene.toml", text);
        return load_file("scene.toml");
    }

    /// The scene, when nothing is said about it.
    SceneDescription good(std::string_view text) const {
        const Outcome outcome = load(text);
        EXPECT_TRUE(outcome.faults.empty()) << (outcome.faults.empty() ? "" : outcome.faults[0]);
        EXPECT_TRUE(outcome.scene.ok());
        return outcome.scene ? *outcome.scene : SceneDescription{};
    }
    /// `fault` begins with the line; it is all that is said.
    void expect_only(const std::string& text, const std::string& fault) const {
        const Outcome outcome = load(text);
        ASSERT_EQ(outcome.faults.size(), 1U) << text;
        EXPECT_EQ(outcome.faults[0], "scene.toml:" + fault) << text;
    }
    void expect_first(const std::string& text, const std::string& start) const {
        const Outcome outcome = load(text);
        ASSERT_FALSE(outcome.faults.empty()) << text;
        EXPECT_EQ(outcome.faults[0].substr(0, start.size()), start) << text;
    }

private:
    std::filesystem::path folder_;
};

}  // namespace plumbline::scene
