// Files that a model names, and the two encodings that stand in its text.
#include "engine/assets/model/model_references.h"

#include "engine/core/limits.h"
#include "tests/engine/assets/fixture.h"

namespace plumbline::assets::test {
namespace {

TEST(ModelReferences, lead_to_files_in_the_models_folder_or_below) {
    const TempFolder folder;
    folder.write("models/a.png", "");
    ModelReferences references(folder.path() / "models/m.gltf", folder.path());
    EXPECT_EQ(references.folder(), folder.path() / "models");
    EXPECT_EQ(references.resolve("a.png", "f").value(), folder.path() / "models/a.png");
    EXPECT_EQ(references.resolve("x/../a.png", "f").value(), folder.path() / "models/a.png");
    EXPECT_EQ(references.resolve("sub/none.png", "f").value(),
              folder.path() / "models/sub/none.png")
        << "it need not be there";
    EXPECT_EQ(references.resolve("b.png", "f", folder.path() / "other").value(),
              folder.path() / "other/b.png");
}

TEST(ModelReferences, are_refused_with_the_field_that_holds_them) {
    const TempFolder folder;
    fs::create_directory(folder.path() / "sub");
    ModelReferences references(folder.path() / "m.gltf", folder.path());
    const auto error_of = [&](std::string_view reference) {
        const Result<fs::path> path = references.resolve(reference, "images[3].uri");
        EXPECT_FALSE(path.ok()) << reference;
        if (path.ok()) return std::string();
        EXPECT_EQ(path.error().exit_code, ExitCode::Refused);
        return path.error().message;
    };
    EXPECT_EQ(error_of(""), "images[3].uri: \"\" names no file");
    EXPECT_EQ(error_of("sub"), "images[3].uri: \"sub\" is no regular file");
    EXPECT_EQ(error_of("sub/../../x"), "images[3].uri: \"sub/../../x\" leads out of its folder");
    EXPECT_TRUE(error_of(std::string_view("a\0b", 3)).ends_with("holds a NUL byte"));
    EXPECT_TRUE(error_of("..").ends_with("leads out of its folder"));
    EXPECT_TRUE(error_of("a/b/../../../a").ends_with("leads out of its folder"));
}

TEST(ModelReferences, are_counted_whether_refused_or_not) {
    const TempFolder folder;
    ModelReferences references(folder.path() / "m.gltf", folder.path());
    for (std::size_t i = 0; i < limits::kReferencedFiles; ++i) {
        EXPECT_EQ(references.resolve(i % 2 == 0 ? "a" : "", "f").ok(), i % 2 == 0);
    }
    EXPECT_EQ(references.resolve("a", "f").error().message,
              fmt::format("f: more than {} files are named", limits::kReferencedFiles));
}

TEST(PercentEscapes, are_read_once_and_never_half) {
    EXPECT_EQ(percent_decoded(""), "");
    EXPECT_EQ(percent_decoded("a%20b%2Fc%2f"), "a b/c/");
    EXPECT_EQ(percent_decoded("%2541"), "%41");
    EXPECT_EQ(percent_decoded("%FF"), "\xFF");
    for (const char* bad : {"%", "%4", "a%", "%g0", "%0g", "%00", "% 41"})
        EXPECT_EQ(percent_decoded(bad), std::nullopt) << bad;
}

TEST(Base64, is_read_with_its_padding_and_nothing_beside_the_alphabet) {
    // RFC 4648, section 10.
    EXPECT_EQ(base64_decoded(""), "");
    EXPECT_EQ(base64_decoded("Zg=="), "f");
    EXPECT_EQ(base64_decoded("Zm8="), "fo");
    EXPECT_EQ(base64_decoded("Zm9v"), "foo");
    EXPECT_EQ(base64_decoded("Zm9vYg=="), "foob");
    EXPECT_EQ(base64_decoded("Zm9vYmE="), "fooba");
    EXPECT_EQ(base64_decoded("Zm9vYmFy"), "foobar");
    EXPECT_EQ(base64_decoded("+/+/"), "\xFB\xFF\xBF");
    for (const char* bad : {"Zg=", "Zg", "Z===", "Zm9v\n", "Zm-_", "Zg==Zg==", "Zm 9"})
        EXPECT_EQ(base64_decoded(bad), std::nullopt) << bad;
    std::string all;
    for (int byte = 0; byte < 256; ++byte) all += static_cast<char>(byte);
    for (std::size_t size = 0; size < all.size(); ++size)
        EXPECT_EQ(base64_decoded(base64(all.substr(0, size))), all.substr(0, size));
}

}  // namespace
}  // namespace plumbline::assets::test
