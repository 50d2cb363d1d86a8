// Trees are kept node by node: their shape decides the order in which pairs are found.
#include "engine/physics/bullet/archive/box_archive.h"

#include "engine/physics/bullet/archive/bullet_fields.h"
#include "engine/physics/bullet/contact/pair_filter.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <new>

namespace plumbline::physics {
namespace {

constexpr std::uint32_t kInner = ~0U;
constexpr int kMostCounted = 1'000'000;
constexpr std::string_view kOtherBoxes = "its broad phase has other bodies";

using Places = std::map<const void*, std::uint32_t>;  ///< of bodies in the list, by their objects

/// A node of a tree, parents before children.
struct BoxNode {
    btVector3 low{0, 0, 0};
    btVector3 high{0, 0, 0};
    std::uint32_t body{kInner};  ///< its place in the list
    std::uint32_t rank{0};       ///< of its address: Bullet turns trees by comparing those

    void serialize(Archive& archive) { archive(low, high, body, rank); }
};

struct SavedTree {
    std::vector<BoxNode> nodes;
    std::optional<std::uint32_t> spare_rank{};  ///< of the node that the tree has ready
    int lookahead{-1};
    unsigned path{0};

    void serialize(Archive& archive) { archive(nodes, spare_rank, lookahead, path); }
};

/// Every node of the set, parents before children, the first child's before the second's.
std::vector<const btDbvtNode*> nodes_of(const btDbvt& set) {
    std::vector<const btDbvtNode*> nodes;
    std::vector<const btDbvtNode*> open;
    if (set.m_root != nullptr) open.push_back(set.m_root);
    while (!open.empty()) {
        const btDbvtNode* node = open.back();
        open.pop_back();
        nodes.push_back(node);
        if (!node->isinternal()) continue;
        open.push_back(node->childs[1]);
        open.push_back(node->childs[0]);
    }
    return nodes;
}

std::array<SavedTree, 2> trees_of(const btDbvtBroadphase& broadphase, const Places& places) {
    std::vector<const void*> addresses;
    for (const btDbvt& set : broadphase.m_sets) {
        for (const btDbvtNode* node : nodes_of(set)) addresses.push_back(node);
        if (set.m_free != nullptr) addresses.push_back(set.m_free);
    }
    std::ranges::sort(addresses, std::less<>());
    const auto rank_of = [&](const void* address) {
        const auto found = std::ranges::lower_bound(addresses, address, std::less<>());
        return static_cast<std::uint32_t>(found - addresses.begin());
    };
    std::array<SavedTree, 2> trees;
    for (std::size_t i = 0; i < trees.size(); ++i) {
        const btDbvt& set = broadphase.m_sets[i];
        trees[i].lookahead = set.m_lkhd;
        trees[i].path = set.m_opath;
        if (set.m_free != nullptr) trees[i].spare_rank = rank_of(set.m_free);
        for (const btDbvtNode* node : nodes_of(set)) {
            BoxNode& made = trees[i].nodes.emplace_back();
            made.low = node->volume.Mins();
            made.high = node->volume.Maxs();
            made.rank = rank_of(node);
            if (node->isinternal()) continue;
            const auto found =
                places.find(static_cast<const btDbvtProxy*>(node->data)->m_clientObject);
            made.body = found != places.end() ? found->second : kInner - 1;
        }
    }
    return trees;
}

/// Whether the nodes make whole trees with every body once, and every rank is somebody's.
bool are_sound(const std::array<SavedTree, 2>& trees, std::size_t bodies) {
    std::vector<bool> has_node(bodies, false);
    std::vector<std::uint32_t> ranks;
    std::size_t leaves = 0;
    for (const SavedTree& tree : trees) {
        std::size_t open = tree.nodes.empty() ? 0 : 1;
        for (const BoxNode& node : tree.nodes) {
            if (open == 0) return false;
            ranks.push_back(node.rank);
            if (node.body == kInner) {
                ++open;
                continue;
            }
            if (node.body >= bodies || has_node[node.body]) return false;
            has_node[node.body] = true;
            ++leaves;
            --open;
        }
        if (open != 0) return false;
        if (tree.spare_rank) ranks.push_back(*tree.spare_rank);
    }
    std::ranges::sort(ranks);
    for (std::size_t i = 0; i < ranks.size(); ++i) {
        if (ranks[i] != i) return false;
    }
    return leaves == bodies;
}

/// Memory for nodes, by rising address.
std::vector<btDbvtNode*> new_nodes(std::size_t count) {
    std::vector<btDbvtNode*> nodes;
    for (std::size_t i = 0; i < count; ++i)
        nodes.push_back(new (btAlignedAlloc(sizeof(btDbvtNode), 16)) btDbvtNode());
    std::ranges::sort(nodes, std::less<>());
    return nodes;
}

void build(btDbvt& set,
           const SavedTree& tree,
           const std::vector<btDbvtNode*>& memory,
           const std::vector<BodyRecord*>& in_world) {
    struct Open {
        btDbvtNode* parent;
        int child;
    };
    std::vector<Open> open;
    set.m_leaves = 0;
    for (const BoxNode& from : tree.nodes) {
        btDbvtNode* node = memory[from.rank];
        node->volume = btDbvtVolume::FromMM(from.low, from.high);
        node->parent = nullptr;
        node->childs[0] = node->childs[1] = nullptr;
        if (open.empty()) {
            set.m_root = node;
        } else {
            node->parent = open.back().parent;
            node->parent->childs[open.back().child] = node;
            open.pop_back();
        }
        if (from.body == kInner) {
            open.push_back({node, 1});
            open.push_back({node, 0});
        } else {
            btDbvtProxy& proxy = proxy_of(*in_world[from.body]);
            node->data = &proxy;
            proxy.leaf = node;
            ++set.m_leaves;
        }
    }
    set.m_lkhd = tree.lookahead;
    set.m_opath = tree.path;
    if (tree.spare_rank) set.m_free = memory[*tree.spare_rank];
}

void rebuild(btDbvtBroadphase& broadphase,
             const std::array<SavedTree, 2>& trees,
             const std::vector<BodyRecord*>& in_world) {
    for (btDbvt& set : broadphase.m_sets) {
        set.clear();
        set.m_root = nullptr;
    }
    std::size_t count = 0;
    for (const SavedTree& tree : trees) count += tree.nodes.size() + (tree.spare_rank ? 1 : 0);
    const std::vector<btDbvtNode*> memory = new_nodes(count);
    for (std::size_t i = 0; i < trees.size(); ++i)
        build(broadphase.m_sets[i], trees[i], memory, in_world);
}

/// Of a part of the bodies no tree can be had: each box goes where Bullet puts it.
void insert(btDbvtBroadphase& broadphase,
            const std::array<SavedTree, 2>& trees,
            const std::vector<BodyRecord*>& in_world) {
    for (const BodyRecord* record : in_world) broadphase.m_sets[0].remove(proxy_of(*record).leaf);
    std::vector<bool> is_in(in_world.size(), false);
    const auto put = [&](btDbvt& set, std::uint32_t body, const btDbvtVolume& volume) {
        btDbvtProxy& proxy = proxy_of(*in_world[body]);
        proxy.leaf = set.insert(volume, &proxy);
        is_in[body] = true;
    };
    for (std::size_t i = 0; i < trees.size(); ++i) {
        for (const BoxNode& node : trees[i].nodes) {
            if (node.body < in_world.size() && !is_in[node.body])
                put(broadphase.m_sets[i], node.body, btDbvtVolume::FromMM(node.low, node.high));
        }
    }
    for (std::uint32_t body = 0; body < in_world.size(); ++body) {
        const btDbvtProxy& proxy = proxy_of(*in_world[body]);
        if (!is_in[body])
            put(broadphase.m_sets[0], body, btDbvtVolume::FromMM(proxy.m_aabbMin, proxy.m_aabbMax));
    }
}

/// Which of the two trees holds each body; the first those that none does.
std::vector<int> trees_by_body(const std::array<SavedTree, 2>& trees, std::size_t bodies) {
    std::vector<int> tree(bodies, btDbvtBroadphase::DYNAMIC_SET);
    for (const BoxNode& node : trees[btDbvtBroadphase::FIXED_SET].nodes) {
        if (node.body < bodies) tree[node.body] = btDbvtBroadphase::FIXED_SET;
    }
    for (const BoxNode& node : trees[btDbvtBroadphase::DYNAMIC_SET].nodes) {
        if (node.body < bodies) tree[node.body] = btDbvtBroadphase::DYNAMIC_SET;
    }
    return tree;
}

/// As Bullet does: the newest first.
void list_first(btDbvtProxy& proxy, btDbvtProxy*& list) {
    proxy.links[0] = nullptr;
    proxy.links[1] = list;
    if (list != nullptr) list->links[0] = &proxy;
    list = &proxy;
}

/// Whether the list has each number below `count` once.
bool is_permutation(std::vector<std::uint32_t> list, std::size_t count) {
    std::ranges::sort(list);
    if (list.size() != count) return false;
    for (std::size_t i = 0; i < count; ++i) {
        if (list[i] != i) return false;
    }
    return true;
}

/// The broad phase's place in its own round, and its counts.
void serialize_round(Archive& archive, btDbvtBroadphase& broadphase) {
    archive.within(broadphase.m_stageCurrent, 0, int{btDbvtBroadphase::STAGECOUNT} - 1);
    archive(broadphase.m_newpairs);
    archive.within(broadphase.m_fixedleft, 0, kMostCounted);
    archive(broadphase.m_updates_call,
            broadphase.m_updates_done,
            broadphase.m_updates_ratio,
            broadphase.m_pid);
    archive.within(broadphase.m_cid, 0, kMostCounted);
    archive.within(broadphase.m_gid, 0, std::numeric_limits<int>::max() - kMostCounted);
    archive(broadphase.m_needcleanup);
}

/// Bodies by the broad phase's lists, the oldest of each first.
std::vector<std::uint32_t> listed(const btDbvtBroadphase& broadphase, const Places& places) {
    std::vector<std::uint32_t> order;
    for (const btDbvtProxy* list : broadphase.m_stageRoots) {
        const auto first = static_cast<std::ptrdiff_t>(order.size());
        for (const btDbvtProxy* proxy = list; proxy != nullptr; proxy = proxy->links[1]) {
            if (const auto found = places.find(proxy->m_clientObject); found != places.end())
                order.push_back(found->second);
        }
        std::reverse(order.begin() + first, order.end());
    }
    return order;
}

}  // namespace

void serialize_boxes(Archive& archive,
                     btDbvtBroadphase& broadphase,
                     const std::vector<BodyRecord*>& in_world) {
    Places places;
    for (std::uint32_t i = 0; i < in_world.size(); ++i) places[in_world[i]->rigid.get()] = i;
    std::vector<std::uint32_t> order = listed(broadphase, places);
    std::array<SavedTree, 2> trees = trees_of(broadphase, places);
    archive(order, trees);
    if (!archive.expect(is_permutation(order, in_world.size()), kOtherBoxes)) return;
    if (archive.reads()) {
        const bool is_whole = are_sound(trees, in_world.size());
        (is_whole ? rebuild : insert)(broadphase, trees, in_world);
        for (btDbvtProxy*& list : broadphase.m_stageRoots) list = nullptr;
    }
    std::vector<int> numbers;
    const std::vector<int> tree = trees_by_body(trees, in_world.size());
    for (const std::uint32_t place : order) {
        btDbvtProxy& proxy = proxy_of(*in_world[place]);
        archive(proxy.m_uniqueId, proxy.m_aabbMin, proxy.m_aabbMax, proxy.stage);
        numbers.push_back(proxy.m_uniqueId);
        const bool is_fixed = tree[place] == btDbvtBroadphase::FIXED_SET;
        const bool sound = proxy.stage >= 0 && proxy.stage <= btDbvtBroadphase::STAGECOUNT &&
                           is_fixed == (proxy.stage == btDbvtBroadphase::STAGECOUNT);
        if (!archive.expect(sound, kOtherBoxes))
            proxy.stage = is_fixed ? int{btDbvtBroadphase::STAGECOUNT} : 0;
        if (archive.reads()) list_first(proxy, broadphase.m_stageRoots[proxy.stage]);
    }
    serialize_round(archive, broadphase);
    std::ranges::sort(numbers);
    archive.expect(
        std::ranges::adjacent_find(numbers) == numbers.end() &&
            (numbers.empty() || (numbers.front() >= 0 && numbers.back() <= broadphase.m_gid)),
        kOtherBoxes);
}

}  // namespace plumbline::physics
