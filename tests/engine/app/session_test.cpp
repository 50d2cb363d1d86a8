#include "engine/app/session.h"

#include "engine/scene/simulation/sun_hour.h"
#include "tests/engine/app/session_fixture.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <new>

namespace plumbline::app {
namespace {

bool has(const Session& session, const std::filesystem::path& file) {
    return std::ranges::any_of(session.files(),
                               [&](const scene::FileStamp& each) { return each.path == file; });
}

TEST_F(SessionTest, ReloadReadsWhatWasSaved) {
    const auto session = open();
    ASSERT_TRUE(session);
    EXPECT_EQ(session->simulation->moving_bodies().size(), 2U);
    std::string text = kTwoCubes;
    text.resize(text.rfind("[[entity]]"));
    folder_.write("scene.toml", text);
    ASSERT_TRUE(session->reload().ok());
    EXPECT_EQ(session->simulation->moving_bodies().size(), 1U);
    ASSERT_TRUE(session->apply(StartAgain{}).ok());
    EXPECT_EQ(session->simulation->moving_bodies().size(), 1U) << "reset keeps what was read";
}

TEST_F(SessionTest, TheHourThatWasAskedForIsThatOfEveryStart) {
    folder_.write("scene.toml", "[sun]\n[time]\nhour = 9\n" + kTwoCubes);
    for (const std::optional<double> hour :
         {std::optional<double>{}, std::optional<double>{21.5}}) {
        const auto session = open(hour);
        ASSERT_TRUE(session);
        const double expected = hour.value_or(9.0);
        EXPECT_NEAR(hour_of(*session->simulation).value_or(-1.0), expected, 0.01);
        set_hour(*session->simulation, 3.0);
        ASSERT_TRUE(session->apply(StartAgain{}).ok());
        EXPECT_NEAR(hour_of(*session->simulation).value_or(-1.0), expected, 0.01);
        ASSERT_TRUE(session->reload().ok());
        EXPECT_NEAR(hour_of(*session->simulation).value_or(-1.0), expected, 0.01);
    }
}

TEST_F(SessionTest, AnotherFidelityBuildsAnewAndIsSavedAlong) {
    folder_.write("scene.toml",
                  kTwoCubes + "[[cloth]]\nsize_m = [1, 1]\nposition_m = [0, 20, 0]\n");
    const auto session = open();
    ASSERT_TRUE(session);
    const auto points = [&] {
        return session->simulation->cloths().front().body->body().positions_m().size();
    };
    EXPECT_EQ(points(), 21U * 21U);
    study::Setting setting = session->accuracy();
    setting.fidelity = {{"cloth", scene::Fidelity::Draft}};
    ASSERT_TRUE(session->apply(SetAccuracy{setting}).ok());
    EXPECT_EQ(points(), 11U * 11U);
    EXPECT_EQ(session->accuracy(), setting);
    const auto file = folder_.path() / "a.save";
    ASSERT_TRUE(session->save(file, 0).ok());
    ASSERT_TRUE(session->apply(StartAgain{}).ok());
    EXPECT_EQ(points(), 11U * 11U) << "it starts as it was chosen";
    ASSERT_TRUE(session->reload().ok());
    EXPECT_EQ(points(), 21U * 21U) << "as the file says";
    const Result<std::uint64_t> loaded = session->load(file);
    ASSERT_TRUE(loaded.ok()) << loaded.error().message;
    EXPECT_EQ(points(), 11U * 11U);
    EXPECT_EQ(session->accuracy(), setting);
}

// EXPERIENCE F20
TEST_F(SessionTest, TheHandIsOpenWhenWhatItHeldIsGone) {
    const auto session = open();
    ASSERT_TRUE(session);
    Actions grab;
    grab.pressed[static_cast<std::size_t>(Action::Grab)] = 1;
    effects::advance(*session->simulation, *session->effects, *session->game, grab);
    EXPECT_TRUE(session->game->holds());
    std::string text = kTwoCubes;
    text.resize(text.rfind("[[entity]]"));
    folder_.write("scene.toml", text);
    ASSERT_TRUE(session->reload().ok());
    EXPECT_FALSE(session->game->holds());
    for (int i = 0; i < 10; ++i)
        effects::advance(*session->simulation, *session->effects, *session->game, grab);
    EXPECT_FALSE(session->game->holds());
}

// EXPERIENCE F21
TEST_F(SessionTest, AFaultLeavesTheRunningSceneAsItIs) {
    const auto session = open();
    ASSERT_TRUE(session);
    effects::advance(*session->simulation, *session->effects, *session->game, {});
    const scene::Simulation* running = session->simulation.get();
    for (const char* broken : {"[[entity]\n", "[accuracy]\nstep_hz = 0\n", ""}) {
        folder_.write("scene.toml", broken);
        const Result<Done> reloaded = session->reload();
        if (std::string_view(broken).empty()) {
            EXPECT_TRUE(reloaded.ok()) << "an empty scene is a scene";
            continue;
        }
        ASSERT_FALSE(reloaded.ok()) << broken;
        EXPECT_NE(reloaded.error().message.find("scene.toml:"), std::string::npos);
        EXPECT_EQ(session->simulation.get(), running);
        EXPECT_TRUE(scene::unchanged(session->files())) << "it is read again when it is mended";
        EXPECT_EQ(running->steps(), 1U);
    }
}

#ifndef __SANITIZE_ADDRESS__  // its shadow memory needs more addresses than any limit here
// EXPERIENCE G26: the scene that runs stays whole, and goes on.
TEST_F(SessionTest, AReloadThatIsRefusedMemoryLeavesTheRunningSceneAsItIs) {
    const auto session = open();
    ASSERT_TRUE(session);
    const scene::Simulation* running = session->simulation.get();
    folder_.write("scene.toml",
                  "[[prefab]]\nname = \"b\"\nprimitive = { box = [1, 1, 1] }\n[prefab.body]\n"
                  "mass_kg = 1\n[[array]]\nname = \"a\"\nprefab = \"b\"\ncount = [999, 1, 50]\n"
                  "spacing_m = [2, 2, 2]\n");
    std::ifstream statm("/proc/self/statm");
    std::size_t pages = 0;
    ASSERT_TRUE(statm >> pages);
    rlimit usual{};
    ASSERT_EQ(getrlimit(RLIMIT_AS, &usual), 0);
    // Rooms of several sizes, so that it is refused at several places.
    for (const std::size_t room_mib : {8U, 16U, 24U, 32U, 40U}) {
        rlimit tight = usual;
        tight.rlim_cur = pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) + (room_mib << 20);
        bool refused = false;
        ASSERT_EQ(setrlimit(RLIMIT_AS, &tight), 0);
        try {
            refused = !session->reload().ok();
        } catch (const std::bad_alloc&) {
            refused = true;
        }
        ASSERT_EQ(setrlimit(RLIMIT_AS, &usual), 0);
        ASSERT_TRUE(refused) << room_mib;
        EXPECT_EQ(session->simulation.get(), running);
        EXPECT_EQ(running->moving_bodies().size(), 2U);
        effects::advance(*session->simulation, *session->effects, *session->game, {});
    }
    ASSERT_TRUE(session->reload().ok());
    EXPECT_EQ(session->simulation->moving_bodies().size(), 49'950U);
}
#endif

TEST_F(SessionTest, AFileThatTheFailedReloadStumbledOverIsWatchedToo) {
    const auto session = open();
    ASSERT_TRUE(session);
    folder_.write("parts.toml", "[[material]\n");
    folder_.write("scene.toml", std::string("scene.include = [\"parts.toml\"]\n"));
    ASSERT_FALSE(session->reload().ok());
    EXPECT_TRUE(has(*session, folder_.path() / "scene.toml"));
    EXPECT_TRUE(has(*session, folder_.path() / "parts.toml"));
}

// What fifty saves add to the library: nothing.
TEST_F(SessionTest, FiftyReloadsAddNoMaterialsAndNoMeshes) {
    folder_.write("scene.toml",
                  "[[material]]\nname = \"red\"\n[[entity]]\nname = \"one\"\n"
                  "primitive = { box = [1, 1, 1] }\nmaterial = \"red\"\n");
    const auto session = open();
    ASSERT_TRUE(session);
    const std::size_t materials = session->library.material_count();
    const std::size_t meshes = session->library.mesh_count();
    for (int i = 0; i < 50; ++i) ASSERT_TRUE(session->reload().ok());
    EXPECT_EQ(session->library.material_count(), materials);
    EXPECT_EQ(session->library.mesh_count(), meshes);
}

}  // namespace
}  // namespace plumbline::app
