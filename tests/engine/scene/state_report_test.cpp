#include "engine/scene/state_report.h"

#include "engine/core/hash.h"
#include "engine/scene/formats/json_text.h"
#include "tests/support/scene_in_code.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <limits>

namespace plumbline::scene {
namespace {

using nlohmann::json;
using test::cube;
using test::ground;
using test::Running;
using test::scene_of;

TEST(Percentiles, AreTheSmallestValuesThatCoverTheShare) {
    std::vector<float> values;
    for (int i = 100; i >= 1; --i) values.push_back(static_cast<float>(i));
    const Percentiles found = percentiles_of(values);
    EXPECT_EQ(found.median, 50.0);
    EXPECT_EQ(found.p95, 95.0);
    EXPECT_EQ(found.p99, 99.0);
    EXPECT_EQ(found.max, 100.0);
    EXPECT_EQ(percentiles_of({}).max, 0.0);
    EXPECT_EQ(percentiles_of({3.0F}).median, 3.0);
}

TEST(JsonText, EscapesAndNests) {
    JsonText text(JsonLayout::OneLine);
    text.begin_object();
    text.key("a \"b\"").begin_array().number(1).number(0.1F).boolean(true).end_array();
    text.key("c").text("tab\tend\\");
    text.key("empty").begin_object().end_object();
    text.key("nan").number(std::numeric_limits<double>::quiet_NaN());
    text.end_object();
    EXPECT_EQ(text.str(), R"({"a \"b\"":[1,0.1,true],"c":"tab\u0009end\\","empty":{},"nan":null})");
}

TEST(JsonText, ReadableLayoutSaysTheSame) {
    const auto write = [](JsonLayout layout) {
        JsonText text(layout);
        text.begin_object().key("list").begin_array();
        text.begin_object().key("x").number(1).key("y").begin_array().number(2).number(3);
        text.end_array().end_object().end_array().key("last").number(4).end_object();
        return text.str();
    };
    EXPECT_EQ(json::parse(write(JsonLayout::Readable)), json::parse(write(JsonLayout::OneLine)));
    EXPECT_EQ(write(JsonLayout::OneLine).find('\n'), std::string::npos);
}

class StateReport : public testing::Test {
protected:
    StateReport() : run_(scene_of({ground(), cube("cube", {0.1_r, 0.5_r, 0.3_r})})) {
        for (int i = 0; i < 5; ++i) {
            run_.step(1);
            costs_.add(run_->physics.report().cost);
        }
        text_ = state_json(*run_, costs_, "[{\"name\":\"fog\"}]", 0.25, false);
        state_ = json::parse(text_);
    }

    Running run_;
    CostHistory costs_;
    std::string text_;
    json state_;
};

TEST_F(StateReport, HasEveryFieldOfTheContract) {
    for (const char* field : {"scene",
                              "time_s",
                              "steps",
                              "step_s",
                              "substeps",
                              "solver",
                              "precision",
                              "hash",
                              "energy_J",
                              "momentum_kgmps",
                              "angular_momentum_kgm2ps",
                              "max_penetration_m",
                              "max_joint_error_m",
                              "lost_time_s",
                              "removed",
                              "non_finite",
                              "warnings",
                              "bodies",
                              "contacts",
                              "joints",
                              "cost",
                              "effects"}) {
        EXPECT_TRUE(state_.contains(field)) << field;
    }
    EXPECT_EQ(state_["scene"], "test.toml");
    EXPECT_EQ(state_["steps"], 5);
    EXPECT_EQ(state_["solver"], "small_step");
    EXPECT_EQ(state_["precision"], kPrecisionName);
    EXPECT_EQ(state_["lost_time_s"], 0.25);
    EXPECT_EQ(state_["hash"], hex_of(run_->state_hash()));
    EXPECT_EQ(state_["effects"][0]["name"], "fog");
    EXPECT_TRUE(state_["joints"].empty());
    for (const char* field : {"cpu_ms_total",
                              "wall_ms_total",
                              "step_ms",
                              "phases_ms",
                              "row_solves",
                              "contacts_max",
                              "interventions"}) {
        EXPECT_TRUE(state_["cost"].contains(field)) << field;
    }
    for (const char* field : {"broad", "narrow", "solve", "integrate", "other"}) {
        EXPECT_TRUE(state_["cost"]["phases_ms"].contains(field)) << field;
    }
}

TEST_F(StateReport, ListsMovingBodiesWithEveryBit) {
    ASSERT_EQ(state_["bodies"].size(), 1U);
    const json& body = state_["bodies"][0];
    const physics::BodyState state = run_.state("cube");
    EXPECT_EQ(body["name"], "cube");
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_EQ(body["position_m"][static_cast<std::size_t>(axis)].get<Real>(),
                  state.world_from_body.position[axis]);
        EXPECT_EQ(body["velocity_mps"][static_cast<std::size_t>(axis)].get<Real>(),
                  state.velocity_mps[axis]);
    }
    EXPECT_EQ(body["orientation"][0].get<Real>(), state.world_from_body.orientation.w);
    EXPECT_EQ(body["orientation"].size(), 4U);
    EXPECT_EQ(body["awake"], state.awake);
}

TEST_F(StateReport, NamesWhoTouches) {
    ASSERT_EQ(state_["contacts"].size(), 1U);
    const json& contact = state_["contacts"][0];
    const bool named = (contact["a"] == "cube" && contact["b"] == "ground") ||
                       (contact["a"] == "ground" && contact["b"] == "cube");
    EXPECT_TRUE(named) << contact;
    // The floor carries 1000 kg for a step.
    EXPECT_NEAR(contact["impulse_Ns"].get<double>(), 1000.0 * 9.81 / 60.0, 10.0);
}

TEST_F(StateReport, AddsUpTheCosts) {
    EXPECT_EQ(costs_.step_ms.size(), 5U);
    const json& cost = state_["cost"];
    double phases = 0.0;
    for (const auto& [name, ms] : cost["phases_ms"].items()) phases += ms.get<double>();
    EXPECT_NEAR(phases, cost["cpu_ms_total"].get<double>(), 1e-6);
    EXPECT_EQ(cost, json::parse(cost_json(costs_)));
    EXPECT_GE(cost["contacts_max"], 1);
}

TEST_F(StateReport, TraceIsTheSameOnOneLine) {
    const std::string line = state_json(*run_, costs_, "[{\"name\":\"fog\"}]", 0.25, true);
    EXPECT_EQ(line.find('\n'), std::string::npos);
    EXPECT_EQ(json::parse(line), state_);
}

TEST(Interventions, AreToldWhereThereAreAny) {
    EXPECT_EQ(interventions_text({.impacts = 7}), "");
    EXPECT_EQ(interventions_text({.braked_J = 0.3125, .braked_islands = 5, .clamped_bodies = 3}),
              "0.312 J braked in 5 islands, 3 bodies clamped");
    EXPECT_EQ(
        interventions_text({.unresolved_islands = 1, .restored_islands = 2, .limited_bodies = 4}),
        "4 at the speed limit, 1 islands with joints too fast, 2 islands rolled back");
    EXPECT_EQ(interventions_text({.left_out_pairs = 5'000'000'000}),
              "5000000000 pairs of crowds left out");
}

TEST(Interventions, AddUpOverSteps) {
    CostHistory costs;
    costs.add({.interventions = {
                   .braked_J = 0.5, .braked_islands = 1, .impacts = 2, .left_out_pairs = 3}});
    costs.add(
        {.interventions = {
             .braked_J = 0.25, .braked_islands = 3, .limited_bodies = 1, .left_out_pairs = 4}});
    const json written = json::parse(cost_json(costs))["interventions"];
    EXPECT_EQ(written["braked_J"], 0.75);
    EXPECT_EQ(written["braked_islands"], 4);
    EXPECT_EQ(written["limited_bodies"], 1);
    EXPECT_EQ(written["impacts"], 2);
    EXPECT_EQ(written["restored_islands"], 0);
    EXPECT_EQ(written["left_out_pairs"], 7);
}

}  // namespace
}  // namespace plumbline::scene
