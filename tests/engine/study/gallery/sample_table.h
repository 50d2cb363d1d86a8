// A small table of stability, without a run.
#pragma once

#include "engine/core/io/files.h"
#include "tests/engine/study/gallery/sample_cells.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace plumbline::study {

inline const std::filesystem::path kAssets = std::filesystem::path(PL_SOURCE_DIR) / "assets";
inline const DataFolders kFolders{
    .assets = kAssets, .shaders = {}, .config = std::filesystem::path(PL_SOURCE_DIR) / "config"};

class StabilityTableTest : public testing::Test {
protected:
    StabilityTable table = sample_table();
};

}  // namespace plumbline::study
