// Films by an ffmpeg that a shell script plays.
#include "engine/app/capture/video_file.h"

#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace plumbline::app {
namespace {

/// A box of an MP4 file: its length, its name, and so many bytes in all.
std::string mp4_box(std::string_view name, unsigned char bytes) {
    return std::string(3, '\0') + static_cast<char>(bytes) + std::string(name) +
           std::string(bytes - 8U, '-');
}

class VideoFileTest : public testing::Test {
protected:
    VideoFileTest() : path_(std::getenv("PATH")) { setenv("PATH", folder_.path().c_str(), 1); }
    ~VideoFileTest() override { setenv("PATH", path_.c_str(), 1); }

    /// What plays ffmpeg: it writes these bytes to the film, then does what the script says.
    void install(std::string_view bytes, std::string_view script = "exec /bin/cat >/dev/null") {
        folder_.write("bytes", bytes);
        const auto file =
            folder_.write("ffmpeg",
                          "#!/bin/sh\nfor last; do :; done\n/bin/cp " +
                              (folder_ / "bytes").string() + " \"${last#file:}\"\necho \"$*\" > " +
                              (folder_ / "said").string() + "\n" + std::string(script) + "\n");
        std::filesystem::permissions(file, std::filesystem::perms::owner_all);
    }
    Result<Done> film(bool live = false) {
        auto video = VideoFile::start({.file = folder_ / "a film.mp4",
                                       .width_px = 2,
                                       .height_px = 1,
                                       .frames_per_s = 30,
                                       .live = live});
        if (!video) return video.error();
        static_cast<void>((*video)->add({.width = 2,
                                         .height = 1,
                                         .format = assets::PixelFormat::Rgb8,
                                         .bytes = {1, 2, 3, 4, 5, 6}}));
        return (*video)->finish();
    }

    test::TemporaryFolder folder_;
    std::string path_;
};

const std::string kHead = mp4_box("ftyp", 16) + mp4_box("moov", 24);
const std::string kFragment = mp4_box("moof", 12) + mp4_box("mdat", 40);

TEST_F(VideoFileTest, WithoutFfmpegItSaysWhatToInstall) {
    EXPECT_EQ(film().error().message,
              "films are written by ffmpeg, which is not installed (package ffmpeg); images can be "
              "had without: render --frames N --out FOLDER");
}

TEST_F(VideoFileTest, HandsTheImagesOverAndTellsFfmpegWhatTheyAre) {
    install(kHead + kFragment, "exec /bin/cat > " + (folder_ / "images").string());
    ASSERT_TRUE(film().ok());
    EXPECT_EQ(folder_.read("images"), "\1\2\3\4\5\6");
    const std::string said = folder_.read("said");
    EXPECT_NE(said.find("-r 30 -pix_fmt rgb24 -s 2x1 -i -"), std::string::npos) << said;
    EXPECT_NE(said.find("-g 15"), std::string::npos) << "fragments of half a second";
    EXPECT_NE(said.find("file:" + (folder_ / "a film.mp4").string()), std::string::npos);
    EXPECT_EQ(said.find("vfr"), std::string::npos);
    ASSERT_TRUE(film(true).ok());
    EXPECT_NE(folder_.read("said").find("-use_wallclock_as_timestamps 1 -framerate 30"),
              std::string::npos);
}

TEST_F(VideoFileTest, CutsOffAFragmentThatWasNotFinished) {
    const std::string whole = kHead + kFragment;
    for (const std::string& half : {whole + mp4_box("moof", 12),
                                    whole + kFragment.substr(0, 30),
                                    whole + std::string("\0\0\0", 3)}) {
        std::filesystem::remove(folder_ / "a film.mp4");
        install(half, "echo disk full; exit 3");
        const Result<Done> ended = film();
        ASSERT_FALSE(ended.ok());
        EXPECT_EQ(ended.error().message,
                  "the film " + (folder_ / "a film.mp4").string() +
                      " is not whole: ffmpeg ended with exit code 3 (disk full); what was written "
                      "until then plays");
        EXPECT_EQ(folder_.read("a film.mp4"), whole) << half.size();
    }
}

TEST_F(VideoFileTest, WithoutOneWholeFragmentNothingWasWritten) {
    for (const std::string& bytes : {std::string(), kHead, kHead + mp4_box("moof", 12)}) {
        install(bytes, "exit 1");
        EXPECT_EQ(film().error().message,
                  "the film " + (folder_ / "a film.mp4").string() +
                      " was not written: ffmpeg ended with exit code 1");
        EXPECT_FALSE(std::filesystem::exists(folder_ / "a film.mp4"));
    }
}

TEST_F(VideoFileTest, LeavesOtherKindsOfFilesAsTheyAre) {
    install("RIFF of another kind", "exit 1");
    EXPECT_NE(film().error().message.find(" is not whole: "), std::string::npos);
    EXPECT_EQ(folder_.read("a film.mp4"), "RIFF of another kind");
}

}  // namespace
}  // namespace plumbline::app
