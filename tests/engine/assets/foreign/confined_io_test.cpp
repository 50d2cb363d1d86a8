// What assimp gets to see of the file system: one file in memory.
#include "engine/assets/foreign/confined_io_impl.h"

#include <assimp/Importer.hpp>
#include <assimp/importerdesc.h>
#include <gtest/gtest.h>

namespace plumbline::assets::test {
namespace {

TEST(ConfinedIo, opens_its_one_file_for_reading_under_any_folder) {
    ConfinedIo io("m.fbx", "0123456789");
    for (const char* name : {"m.fbx", "/etc/m.fbx", "C:\\a\\m.fbx", "./m.fbx"}) {
        EXPECT_TRUE(io.Exists(name)) << name;
        Assimp::IOStream* stream = io.Open(name, "rb");
        ASSERT_NE(stream, nullptr) << name;
        EXPECT_EQ(stream->FileSize(), 10U);
        io.Close(stream);
    }
    for (const char* name : {"x.fbx", "/etc/passwd", "m.fbx/", ""}) {
        EXPECT_FALSE(io.Exists(name)) << name;
        EXPECT_EQ(io.Open(name, "rb"), nullptr) << name;
    }
    EXPECT_EQ(io.Open("m.fbx", "wb"), nullptr);
    EXPECT_EQ(io.Open("m.fbx", nullptr), nullptr);
}

TEST(ConfinedIo, reads_whole_elements_and_never_past_the_end) {
    ConfinedIo io("m", "0123456789");
    Assimp::IOStream* stream = io.Open("m", "r");
    ASSERT_NE(stream, nullptr);
    std::string target(20, '-');
    EXPECT_EQ(stream->Read(target.data(), 4, 9), 2U) << "ten bytes hold two fours";
    EXPECT_EQ(target.substr(0, 9), "01234567-");
    EXPECT_EQ(stream->Tell(), 8U);
    EXPECT_EQ(stream->Read(target.data(), 0, 9), 0U);
    EXPECT_EQ(stream->Seek(10, aiOrigin_SET), aiReturn_SUCCESS);
    EXPECT_EQ(stream->Read(target.data(), 1, 1), 0U);
    EXPECT_EQ(stream->Seek(11, aiOrigin_SET), aiReturn_FAILURE);
    EXPECT_EQ(stream->Tell(), 10U) << "a step that fails moves nothing";
    // Steps back are large numbers that wrap.
    EXPECT_EQ(stream->Seek(static_cast<std::size_t>(-3), aiOrigin_END), aiReturn_SUCCESS);
    EXPECT_EQ(stream->Read(target.data(), 1, 1), 1U);
    EXPECT_EQ(target[0], '7');
    EXPECT_EQ(stream->Seek(static_cast<std::size_t>(-8), aiOrigin_CUR), aiReturn_SUCCESS);
    EXPECT_EQ(stream->Tell(), 0U);
    EXPECT_EQ(stream->Seek(static_cast<std::size_t>(-1), aiOrigin_CUR), aiReturn_FAILURE);
    EXPECT_EQ(stream->Write("x", 1, 1), 0U);
    io.Close(stream);
}

TEST(ConfinedIo, leaves_only_the_importers_that_are_named) {
    Assimp::Importer importer;
    ASSERT_GT(importer.GetImporterCount(), 2U);
    keep_importers(importer, {"Collada Importer", "no importer"});
    ASSERT_EQ(importer.GetImporterCount(), 1U);
    EXPECT_STREQ(importer.GetImporterInfo(0)->mName, "Collada Importer");
}

}  // namespace
}  // namespace plumbline::assets::test
