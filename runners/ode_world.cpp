// ODE as Debian packages it (in double precision), with its own contacts and defaults: QuickStep, or with the knob `direct`
// its direct solver.
#include "runners/engine_world.h"
#include <ode/ode.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace plumbline::engines {
namespace {

constexpr int kContacts = 8;  // of a pair

struct OdeBody {
    dBodyID body{nullptr};  ///< null: it does not move
    std::vector<dGeomID> geoms{};
    double friction{0};
    double restitution{0};
    std::uint32_t group{0};
    std::uint32_t mask{0};
};

/// Our shapes stand along Y, ODE's along Z.
constexpr dQuaternion kZToY = {0.7071067811865476, -0.7071067811865476, 0, 0};

class OdeWorld : public EngineWorld {
public:
    explicit OdeWorld(const Json& scene)
        : step_s_(1.0 / scene.at("step_hz").get<double>()),
          is_direct_(knob(scene, "direct", 0) != 0),
          world_(dWorldCreate()),
          space_(dHashSpaceCreate(nullptr)),
          contacts_(dJointGroupCreate(0)) {
        refuse_specials(scene);
        dWorldSetGravity(world_,
                         scene.at("gravity_mps2").at(0),
                         scene.at("gravity_mps2").at(1),
                         scene.at("gravity_mps2").at(2));
        dWorldSetQuickStepNumIterations(
            world_, knob(scene, "iterations", dWorldGetQuickStepNumIterations(world_)));
        bodies_.reserve(scene.at("bodies").size());
        for (const Json& body : scene.at("bodies")) add(body);
        for (const Json& joint : scene.at("joints")) join(joint);
    }
    ~OdeWorld() override {
        dJointGroupDestroy(contacts_);
        dSpaceDestroy(space_);
        dWorldDestroy(world_);
        for (const dTriMeshDataID mesh : meshes_) dGeomTriMeshDataDestroy(mesh);
    }

    void set_state(std::size_t index, std::span<const double, kNumbers> s) override {
        const dBodyID body = bodies_[index].body;
        const dQuaternion turn = {s[6], s[3], s[4], s[5]};
        dBodySetPosition(body, s[0], s[1], s[2]);
        dBodySetQuaternion(body, turn);
        dBodySetLinearVel(body, s[7], s[8], s[9]);
        dBodySetAngularVel(body, s[10], s[11], s[12]);
    }
    void get_state(std::size_t index, std::span<double, kNumbers> state) const override {
        const dBodyID body = bodies_[index].body;
        const dReal* q = dBodyGetQuaternion(body);
        std::copy_n(dBodyGetPosition(body), 3, state.begin());
        const std::array<double, 4> turn{q[1], q[2], q[3], q[0]};
        std::ranges::copy(turn, state.begin() + 3);
        std::copy_n(dBodyGetLinearVel(body), 3, state.begin() + 7);
        std::copy_n(dBodyGetAngularVel(body), 3, state.begin() + 10);
    }
    void set_gravity(const Json& gravity_mps2) override {
        dWorldSetGravity(world_, gravity_mps2.at(0), gravity_mps2.at(1), gravity_mps2.at(2));
    }
    void step() override {
        dSpaceCollide(space_, this, near);
        if (is_direct_)
            dWorldStep(world_, step_s_);
        else
            dWorldQuickStep(world_, step_s_);
        dJointGroupEmpty(contacts_);
    }

private:
    dGeomID geom_of(const Json& part) {
        const std::string kind = part.at("shape");
        if (kind == "box") {
            const Json& half = part.at("half_m");
            return dCreateBox(space_,
                              2 * half.at(0).get<double>(),
                              2 * half.at(1).get<double>(),
                              2 * half.at(2).get<double>());
        }
        if (kind == "sphere") return dCreateSphere(space_, part.at("radius_m"));
        if (kind == "mesh") return mesh_of(part);
        // Its convex hulls miss contacts with each other, and it has no cones.
        if (kind != "capsule" && kind != "cylinder") throw Lacks("a " + kind);
        const double height_m = 2 * part.at("half_height_m").get<double>();
        return kind == "capsule" ? dCreateCapsule(space_, part.at("radius_m"), height_m)
                                 : dCreateCylinder(space_, part.at("radius_m"), height_m);
    }

    dGeomID mesh_of(const Json& part) {
        std::vector<double>& points = points_.emplace_back();
        std::vector<dTriIndex>& corners = corners_.emplace_back();
        for (const Json& point : part.at("points_m"))
            for (const Json& each : point) points.push_back(each);
        for (const Json& triangle : part.at("triangles"))
            for (const Json& each : triangle) corners.push_back(each);
        meshes_.push_back(dGeomTriMeshDataCreate());
        dGeomTriMeshDataBuildDouble(meshes_.back(),
                                    points.data(),
                                    3 * sizeof(double),
                                    static_cast<int>(points.size() / 3),
                                    corners.data(),
                                    static_cast<int>(corners.size()),
                                    3 * sizeof(dTriIndex));
        return dCreateTriMesh(space_, meshes_.back(), nullptr, nullptr, nullptr);
    }

    void add(const Json& json) {
        OdeBody& made = bodies_.emplace_back();
        made.friction = json.at("friction");
        made.restitution = json.at("restitution");
        made.group = json.at("group");
        made.mask = json.at("collides_with");
        const std::vector<double> at = json.at("at_m");
        const std::vector<double> turn = json.at("turn");
        const dQuaternion q = {turn[3], turn[0], turn[1], turn[2]};
        const std::string kind = json.at("kind");
        if (kind == "kinematic") throw Lacks("kinematic bodies");
        if (kind == "dynamic") {
            made.body = dBodyCreate(world_);
            const Json& inertia = json.at("inertia_kgm2");
            dMass mass;
            dMassSetParameters(&mass,
                               json.at("mass_kg"),
                               0,
                               0,
                               0,
                               inertia.at(0),
                               inertia.at(1),
                               inertia.at(2),
                               0,
                               0,
                               0);
            dBodySetMass(made.body, &mass);
            dBodySetPosition(made.body, at[0], at[1], at[2]);
            dBodySetQuaternion(made.body, q);
            const auto share = [&](const char* key) {
                return -std::expm1(-json.at(key).get<double>() * step_s_);
            };
            dBodySetLinearDamping(made.body, share("linear_damping_per_s"));
            dBodySetAngularDamping(made.body, share("angular_damping_per_s"));
        }
        for (const Json& part : json.at("parts")) place(made, part, at, q);
    }

    void place(OdeBody& made,
               const Json& part,
               const std::vector<double>& at,
               const dQuaternion& q) {
        const dGeomID geom = geom_of(part);
        made.geoms.push_back(geom);
        dGeomSetData(geom, &made);
        const Json& off = part.at("at_m");
        const Json& turn = part.at("turn");
        dQuaternion own = {turn.at(3), turn.at(0), turn.at(1), turn.at(2)};
        if (part.at("shape") == "capsule" || part.at("shape") == "cylinder") {
            const dQuaternion of_part = {own[0], own[1], own[2], own[3]};
            dQMultiply0(own, of_part, kZToY);
        }
        if (made.body != nullptr) {
            dGeomSetBody(geom, made.body);
            dGeomSetOffsetPosition(geom, off.at(0), off.at(1), off.at(2));
            dGeomSetOffsetQuaternion(geom, own);
            return;
        }
        dMatrix3 rotation;
        dQtoR(q, rotation);
        const dVector3 local = {off.at(0), off.at(1), off.at(2)};
        dVector3 moved;
        dMultiply0_331(moved, rotation, local);
        dQuaternion whole;
        dQMultiply0(whole, q, own);
        dGeomSetPosition(geom, at[0] + moved[0], at[1] + moved[1], at[2] + moved[2]);
        dGeomSetQuaternion(geom, whole);
    }

    void join(const Json& joint) {
        const std::string kind = joint.at("kind");
        const dBodyID a = bodies_[joint.at("a").get<std::size_t>()].body;
        const int number_of_b = joint.at("b");
        const dBodyID b =
            number_of_b < 0 ? nullptr : bodies_[static_cast<std::size_t>(number_of_b)].body;
        const std::vector<double> at = joint.at("anchor_a_m");
        const std::vector<double> at_b = joint.at("anchor_b_m");
        const std::vector<double> axis = joint.at("axis");
        if (!joint.at("collide")) apart_.emplace_back(a, b);
        dJointID made = nullptr;
        if (kind == "ball") {
            made = dJointCreateBall(world_, nullptr);
            dJointAttach(made, a, b);
            dJointSetBallAnchor(made, at[0], at[1], at[2]);
        } else if (kind == "fixed") {
            made = dJointCreateFixed(world_, nullptr);
            dJointAttach(made, a, b);
            dJointSetFixed(made);
        } else if (kind == "hinge") {
            made = dJointCreateHinge(world_, nullptr);
            dJointAttach(made, a, b);
            dJointSetHingeAnchor(made, at[0], at[1], at[2]);
            dJointSetHingeAxis(made, axis[0], axis[1], axis[2]);
            set_axis(joint,
                     [made](int key, double value) { dJointSetHingeParam(made, key, value); });
        } else if (kind == "slider") {
            made = dJointCreateSlider(world_, nullptr);
            dJointAttach(made, a, b);
            dJointSetSliderAxis(made, axis[0], axis[1], axis[2]);
            set_axis(joint,
                     [made](int key, double value) { dJointSetSliderParam(made, key, value); });
        } else if (kind == "distance" && !joint.contains("limits")) {
            made = dJointCreateDBall(world_, nullptr);
            dJointAttach(made, a, b);
            dJointSetDBallAnchor1(made, at[0], at[1], at[2]);
            dJointSetDBallAnchor2(made, at_b[0], at_b[1], at_b[2]);
            dJointSetDBallDistance(made, joint.at("rest_length_m"));
        } else {
            throw Lacks("joints of kind " + kind);
        }
    }

    template <class Set>
    static void set_axis(const Json& joint, const Set& set) {
        if (joint.contains("limits")) {
            const double least = joint.at("limits").at(0);
            const double most = joint.at("limits").at(1);
            if (joint.at("kind") == "hinge" && std::max(-least, most) > M_PI)
                throw Lacks("a hinge that counts turns");
            set(dParamLoStop, least);
            set(dParamHiStop, most);
        }
        if (joint.contains("motor")) {
            set(dParamVel, joint.at("motor").at("target"));
            set(dParamFMax, joint.at("motor").at("max"));
        }
    }

    bool are_apart(dBodyID a, dBodyID b) const {
        return std::ranges::any_of(apart_, [&](const auto& pair) {
            return (pair.first == a && pair.second == b) || (pair.first == b && pair.second == a);
        });
    }

    static void near(void* data, dGeomID first, dGeomID second) {
        auto& world = *static_cast<OdeWorld*>(data);
        const auto& a = *static_cast<const OdeBody*>(dGeomGetData(first));
        const auto& b = *static_cast<const OdeBody*>(dGeomGetData(second));
        if (a.body == b.body) return;
        if ((a.group & b.mask) == 0 || (b.group & a.mask) == 0) return;
        if (a.body != nullptr && b.body != nullptr && world.are_apart(a.body, b.body)) return;
        std::array<dContact, kContacts> contacts{};
        const int count = dCollide(first, second, kContacts, &contacts[0].geom, sizeof(dContact));
        for (int i = 0; i < count; ++i) {
            dContact& contact = contacts[static_cast<std::size_t>(i)];
            contact.surface.mode = dContactApprox1;
            contact.surface.mu = std::sqrt(a.friction * b.friction);
            contact.surface.bounce = std::max(a.restitution, b.restitution);
            if (contact.surface.bounce > 0) contact.surface.mode |= dContactBounce;
            dJointAttach(
                dJointCreateContact(world.world_, world.contacts_, &contact), a.body, b.body);
        }
    }

    double step_s_;
    bool is_direct_;
    dWorldID world_;
    dSpaceID space_;
    dJointGroupID contacts_;
    std::vector<OdeBody> bodies_;
    std::vector<std::pair<dBodyID, dBodyID>> apart_;
    std::vector<dTriMeshDataID> meshes_;
    std::vector<std::vector<double>> points_;  ///< of meshes, which read them here
    std::vector<std::vector<dTriIndex>> corners_;
};

}  // namespace

Engine ode_engine() {
    dInitODE2(0);
    return {"ode", dODE_VERSION, [](const Json& scene) -> std::unique_ptr<EngineWorld> {
                return std::make_unique<OdeWorld>(scene);
            }};
}

}  // namespace plumbline::engines
