// Every file in malformed/ is refused with the words listed beside it.

#include "tests/engine/assets/fixture.h"

#include <map>
#include <sstream>

namespace plumbline::assets::test {
namespace {

TEST(Malformed, every_file_is_refused_as_its_list_says) {
    const fs::path folder = fs::path(PL_SOURCE_DIR) / "tests/engine/assets/malformed";
    std::map<std::string, std::string> expected;
    std::ifstream list(folder / "expected.txt");
    for (std::string line; std::getline(list, line);) {
        const std::size_t colon = line.find(": ");
        ASSERT_NE(colon, std::string::npos) << line;
        expected.emplace(line.substr(0, colon), line.substr(colon + 2));
    }
    std::size_t files = 0;
    for (const auto& entry : fs::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        if (name == "expected.txt") continue;
        ++files;
        ASSERT_TRUE(expected.contains(name)) << name << " is not in expected.txt";
        const Import import(entry.path());
        ASSERT_FALSE(import.ok()) << name;
        EXPECT_TRUE(contains(import.error(), expected[name])) << import.error();
        EXPECT_EQ(import.model.error().exit_code, ExitCode::Refused);
    }
    EXPECT_EQ(files, expected.size());
    EXPECT_GE(files, 10U);
}

}  // namespace
}  // namespace plumbline::assets::test
