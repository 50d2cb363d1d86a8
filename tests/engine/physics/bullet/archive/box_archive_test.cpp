// The broad phase of a saved game.
#include "engine/core/io/archive.h"
#include "engine/physics/query.h"
#include "tests/engine/physics/test_world.h"

#include <functional>
#include <vector>

namespace plumbline::physics {
namespace {

/// A row of boxes in the air; `ids` in their order.
struct RowOfBoxes {
    TestWorld test{weightless()};
    std::vector<BodyId> ids;

    explicit RowOfBoxes(int count) {
        for (int i = 0; i < count; ++i) ids.push_back(test.add(BoxShape{}, {place_of(i), 0, 0}));
    }
    static Real place_of(int i) { return 3 * static_cast<Real>(i); }
    /// Which of the boxes a ray from above meets, moved by z.
    bool is_met(std::size_t i, Real z) const {
        const Real x = place_of(static_cast<int>(i));
        const auto hit = cast_ray(test.world, {x, 5, z}, {x, -5, z});
        return hit && hit->body == ids[i];
    }
};

// Of a part of the bodies there is no tree to put back; each box is put where it was.
TEST(BoxArchive, BodiesAreFoundWhereTheyWereWholeOrInPart) {
    for (const bool whole : {true, false}) {
        SCOPED_TRACE(whole);
        RowOfBoxes there(whole ? 6 : 7);
        for (std::size_t i = 0; i < 6; ++i)
            there.test.world.set_pose(
                there.ids[i], {.position = {RowOfBoxes::place_of(static_cast<int>(i)), 0, 8}});
        there.test.run(0.2);
        Archive out;
        const BodyId left_out = there.ids.back();
        if (whole)
            there.test.world.serialize(out);
        else
            there.test.world.serialize(out, [&](BodyId id) { return id != left_out; });
        RowOfBoxes here(6);
        Archive in(out.written());
        here.test.world.serialize(
            in, whole ? std::function<bool(BodyId)>{} : [](BodyId) { return true; });
        ASSERT_FALSE(in.failed()) << in.fault();
        for (std::size_t i = 0; i < 6; ++i) {
            EXPECT_TRUE(here.is_met(i, 8)) << i;
            EXPECT_FALSE(here.is_met(i, 0)) << i;
        }
        // New pairs are found: a ball from above is held up.
        const BodyId ball = here.test.add(
            SphereShape{}, {0, 3, 8}, {.kind = BodyKind::Dynamic, .velocity_mps = {0, -3, 0}});
        here.test.run(2);
        EXPECT_GT(here.test.at(ball).y, here.test.at(here.ids[0]).y + 0.9);
    }
}

}  // namespace
}  // namespace plumbline::physics
