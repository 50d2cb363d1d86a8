// Whose state an archive holds.
#pragma once

#include "engine/core/io/archive.h"
#include "engine/core/slot_map.h"
#include "engine/physics/body.h"
#include "engine/physics/joint.h"

#include <functional>
#include <memory>
#include <string_view>
#include <vector>

namespace plumbline::physics {

struct BodyRecord;
struct JointRecord;
using BodyTable = SlotMap<BodyId, std::unique_ptr<BodyRecord>>;
using JointTable = SlotMap<JointId, std::unique_ptr<JointRecord>>;

/// The fault of an archive of bodies that the world does not have.
inline constexpr std::string_view kOtherBodies = "its bodies are not those of this scene";

struct BodyScope {
    const BodyTable& bodies;
    const std::function<bool(BodyId)>& keeps;  ///< when written; empty: all

    bool holds(BodyId id) const { return !keeps || keeps(id); }
    bool holds(const JointRecord& joint) const;
    bool is_whole() const { return !keeps; }
};

/// Bodies by their ids; those out of scope are left out.
void serialize(Archive& archive, std::vector<BodyRecord*>& list, const BodyScope& scope);

}  // namespace plumbline::physics
