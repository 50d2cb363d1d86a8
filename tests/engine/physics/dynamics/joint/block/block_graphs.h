// Graphs of blocks, for tests of what eliminates them.
#pragma once

#include "engine/physics/dynamics/joint/block/block_pattern.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace plumbline::physics {

using Graph = std::vector<std::vector<std::uint32_t>>;

inline Graph graph_of(std::uint32_t count,
                      const std::vector<std::pair<std::uint32_t, std::uint32_t>>& edges) {
    Graph graph(count);
    for (const auto& [a, b] : edges) {
        graph[a].push_back(b);
        graph[b].push_back(a);
    }
    return graph;
}

inline Graph chain(std::uint32_t count) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (std::uint32_t i = 0; i + 1 < count; ++i) edges.emplace_back(i, i + 1);
    return graph_of(count, edges);
}

/// The pattern of a graph whose vertices are one block each, columns in order of elimination.
inline BlockPattern pattern_of(const EliminationOrder& order) {
    std::vector<std::uint32_t> column(order.order.size());
    for (std::uint32_t i = 0; i < order.order.size(); ++i) column[order.order[i]] = i;
    std::vector<std::vector<std::uint32_t>> later(order.order.size());
    for (std::uint32_t v = 0; v < order.order.size(); ++v) {
        for (const std::uint32_t other : order.later[v]) later[column[v]].push_back(column[other]);
        std::ranges::sort(later[column[v]]);
    }
    return BlockPattern::from_columns(later);
}

inline EliminationOrder order_of(const Graph& graph) {
    const std::vector<std::uint32_t> weights(graph.size(), 1);
    return minimum_degree_order(graph, weights, 1e9);
}

}  // namespace plumbline::physics
