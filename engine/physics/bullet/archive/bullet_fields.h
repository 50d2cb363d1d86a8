// The fields of Bullet's plain data, for archives.
#pragma once

#include "engine/core/io/pose_archive.h"

#include <btBulletDynamicsCommon.h>

namespace plumbline {

inline void serialize(Archive& archive, btVector3& v) {
    archive(v[0], v[1], v[2]);
}
inline void serialize(Archive& archive, btMatrix3x3& m) {
    archive(m[0], m[1], m[2]);
}
inline void serialize(Archive& archive, btTransform& at) {
    archive(at.getBasis(), at.getOrigin());
}

inline void serialize(Archive& archive, btJointFeedback& load) {
    archive(load.m_appliedForceBodyA,
            load.m_appliedTorqueBodyA,
            load.m_appliedForceBodyB,
            load.m_appliedTorqueBodyB);
}

}  // namespace plumbline
