#include "engine/study/report/peers.h"

#include "engine/core/io/files.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace plumbline::study {

namespace {

const std::string kHeading = "scene,engine,substeps,cpu_ms_per_frame,cost_ratio,metric,value\n";

std::string refusal(const std::string& csv) {
    const auto rows = parse_peers(csv);
    return rows ? "accepted" : rows.error().message;
}

TEST(Peers, RowsCommentsAndEmptyLines) {
    const auto rows = parse_peers("# measured once\r\n" + kHeading +
                                  "\nchainv,jolt,2,0.05,1.1,stretch_end_pct,-2.01\n");
    ASSERT_TRUE(rows);
    ASSERT_EQ(rows->size(), 1U);
    const PeerRow& row = rows->front();
    EXPECT_EQ(row.scene, "chainv");
    EXPECT_EQ(row.engine, "jolt");
    EXPECT_EQ(row.substeps, 2);
    EXPECT_DOUBLE_EQ(row.cpu_ms_per_frame, 0.05);
    EXPECT_DOUBLE_EQ(row.cost_ratio, 1.1);
    EXPECT_EQ(row.metric, "stretch_end_pct");
    EXPECT_DOUBLE_EQ(row.value, -2.01);
}

TEST(Peers, EachFaultNamesItsLine) {
    EXPECT_EQ(refusal(""), "peers.csv is empty");
    EXPECT_EQ(refusal("scene,engine\n"),
              "peers.csv line 1: expected the heading "
              "scene,engine,substeps,cpu_ms_per_frame,cost_ratio,metric,value");
    EXPECT_EQ(refusal(kHeading + "a,b,1,1,1,m\n"),
              "peers.csv line 2: 6 fields, expected 7: "
              "scene,engine,substeps,cpu_ms_per_frame,cost_ratio,metric,value");
    EXPECT_EQ(refusal(kHeading + "a,b,0,1,1,m,1\n"),
              "peers.csv line 2: '0' is no number of sub-steps");
    EXPECT_EQ(refusal(kHeading + "a,b,1,dear,1,m,1\n"), "peers.csv line 2: 'dear' is no cost");
    EXPECT_EQ(refusal(kHeading + "a,b,1,nan,1,m,1\n"), "peers.csv line 2: 'nan' is no cost");
    EXPECT_EQ(refusal(kHeading + "a,b,1,1,1x,m,1\n"), "peers.csv line 2: '1x' is no cost ratio");
    EXPECT_EQ(refusal(kHeading + "a,b,1,1,1,m,\n"), "peers.csv line 2: '' is no value");
    EXPECT_EQ(refusal(kHeading + "a,,1,1,1,m,1\n"), "peers.csv line 2: field 2 is empty");
}

TEST(Peers, OnlyTheSameSceneAndTheSameMeaningCompare) {
    const auto rows = parse_peers(kHeading +
                                  "chainv,jolt,1,0.05,1,stretch_end_pct,-2\n"
                                  "chainv,jolt,1,0.05,1,vrms_end,7\n"
                                  "chainh,jolt,1,0.05,1,stretch_end_pct,9\n");
    ASSERT_TRUE(rows);
    const auto points = comparable_peers(*rows, "chainv", "stretch at the end");
    ASSERT_EQ(points.size(), 1U);
    EXPECT_DOUBLE_EQ(points[0].error, 0.02);  // -2 %, as a size
    EXPECT_DOUBLE_EQ(points[0].cpu_ms_per_s, 0.05 * 60);
    EXPECT_TRUE(comparable_peers(*rows, "chainv", "energy").empty());
    EXPECT_TRUE(comparable_peers(*rows, "", "stretch at the end").empty());
}

TEST(Peers, WhatFellIsWhollyWrong) {
    const auto rows = parse_peers(kHeading +
                                  "heavy100,a,1,1,1,pen_max,0.02\nheavy100,a,1,1,1,stands,1\n"
                                  "heavy100,b,1,1,1,pen_max,0.02\nheavy100,b,1,1,1,stands,0\n"
                                  "heavy100,b,4,1,1,pen_max,0.01\nheavy100,b,4,1,1,stands,1\n");
    ASSERT_TRUE(rows);
    const auto points = comparable_peers(*rows, "heavy100", "largest penetration");
    ASSERT_EQ(points.size(), 3U);
    EXPECT_DOUBLE_EQ(points[0].error, 0.02);
    EXPECT_DOUBLE_EQ(points[1].error, 1);
    EXPECT_DOUBLE_EQ(points[2].error, 0.01);
}

TEST(Peers, OurCopyIsWhole) {
    const auto csv = read_file("assets/data/peers.csv", std::size_t{1} << 24U);
    ASSERT_TRUE(csv);
    const auto rows = parse_peers(*csv);
    ASSERT_TRUE(rows) << rows.error().message;
    EXPECT_EQ(rows->size(), 4414U);
    std::set<std::string> scenes;
    for (const PeerRow& row : *rows) scenes.insert(row.scene);
    EXPECT_EQ(scenes.size(), 21U);
    // The pyramid of Box3D, as docs and tables everywhere quote it: 1.62 mm of creep.
    for (const PeerPoint& point : comparable_peers(*rows, "pyramid", "creep after 1 s")) {
        if (point.engine == "box3d" && point.substeps == 1) {
            EXPECT_NEAR(point.error, 1.62e-3, 1e-5);
        }
    }
}

}  // namespace

}  // namespace plumbline::study
