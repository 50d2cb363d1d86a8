// Models as bytes, there and back.
#include "engine/assets/foreign/model_wire.h"

#include "engine/assets/foreign/foreign_import.h"
#include "tests/engine/assets/foreign/collada.h"

namespace plumbline::assets::test {
namespace {

TEST(ModelWire, hands_a_model_over_as_bytes_without_loss) {
    const Result<ModelData> model = read_foreign(kCollada, "m.dae");
    ASSERT_TRUE(model.ok()) << model.error().message;
    const std::string bytes = bytes_of(*model);
    const Result<ModelData> again = model_of_bytes(bytes);
    ASSERT_TRUE(again.ok()) << again.error().message;
    EXPECT_EQ(bytes_of(*again), bytes);
    EXPECT_EQ(again->nodes.size(), model->nodes.size());
}

TEST(ModelWire, refuses_an_answer_that_is_cut_or_lies) {
    const Result<ModelData> model = read_foreign(kCollada, "m.dae");
    ASSERT_TRUE(model.ok()) << model.error().message;
    const std::string bytes = bytes_of(*model);
    for (std::size_t length = 0; length < bytes.size(); ++length) {
        ASSERT_FALSE(model_of_bytes(std::string_view(bytes).substr(0, length)).ok()) << length;
    }
    ModelData lying = *model;
    lying.meshes[0].indices[1] = 3;
    const Result<ModelData> refused = model_of_bytes(bytes_of(lying));
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().message, "mesh 0 names vertices that it lacks");
}

}  // namespace
}  // namespace plumbline::assets::test
