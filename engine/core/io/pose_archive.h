// Vectors, turns and poses as fields of an archive.
#pragma once

#include "engine/core/io/archive.h"
#include "engine/core/pose.h"

namespace plumbline {

template <int kLength, class T, glm::qualifier kQualifier>
void serialize(Archive& archive, glm::vec<kLength, T, kQualifier>& v) {
    for (int i = 0; i < kLength; ++i) archive(v[i]);
}

template <class T, glm::qualifier kQualifier>
void serialize(Archive& archive, glm::qua<T, kQualifier>& q) {
    archive(q.w, q.x, q.y, q.z);
}

inline void serialize(Archive& archive, Pose& pose) {
    archive(pose.position, pose.orientation);
}

}  // namespace plumbline
