// Jolt Physics as WebAssembly (npm: jolt-physics): its own defaults, but no damping beyond the scene's, no sleep, gyroscopic
// torque, and no limit of speed that a scene reaches.
import { Lacks, across, coneAngle, distances, layers, refuseSpecials, refuseTurns } from "./scene.mjs";

export async function load(packages) {
  const { default: init } = await packages.load("jolt-physics");
  const Jolt = await init();
  return { version: packages.version("jolt-physics"), world: scene => new World(Jolt, scene) };
}

class World {
  constructor(Jolt, scene) {
    this.Jolt = Jolt;
    refuseSpecials(scene);
    this.makeSystem(scene);
    this.addBodies(scene);
    for (const joint of scene.joints) this.system.AddConstraint(this.constraint(scene, joint));
    this.system.OptimizeBroadPhase();
  }

  makeSystem(scene) {
    const Jolt = this.Jolt;
    const { of, count, touch } = layers(scene);
    const still = scene.bodies.map(body => body.kind === "static");
    // A layer of what stands and one of what moves, for each of the scene's.
    const pairs = new Jolt.ObjectLayerPairFilterTable(2 * count);
    for (let a = 0; a < 2 * count; ++a) {
      for (let b = 0; b <= a; ++b) {
        if (touch(a >> 1, b >> 1) && ((a | b) & 1)) pairs.EnableCollision(a, b);
      }
    }
    const places = new Jolt.BroadPhaseLayerInterfaceTable(2 * count, 2);
    const [ground, air] = [new Jolt.BroadPhaseLayer(0), new Jolt.BroadPhaseLayer(1)];
    for (let layer = 0; layer < 2 * count; ++layer) places.MapObjectToBroadPhaseLayer(layer, layer & 1 ? air : ground);
    const settings = new Jolt.JoltSettings();
    settings.mMaxBodies = scene.bodies.length + 16;
    settings.mMaxContactConstraints = Math.max(settings.mMaxContactConstraints, 16 * scene.bodies.length);
    settings.mMaxBodyPairs = Math.max(settings.mMaxBodyPairs, 64 * scene.bodies.length);
    settings.mObjectLayerPairFilter = pairs;
    settings.mBroadPhaseLayerInterface = places;
    settings.mObjectVsBroadPhaseLayerFilter = new Jolt.ObjectVsBroadPhaseLayerFilterTable(places, 2, pairs, 2 * count);
    this.jolt = new Jolt.JoltInterface(settings);
    Jolt.destroy(settings);
    this.system = this.jolt.GetPhysicsSystem();
    this.bodies = this.system.GetBodyInterfaceNoLock();
    this.setGravity(scene.gravity_mps2);
    if (scene.knobs?.iterations) {
      const physics = this.system.GetPhysicsSettings();
      physics.mNumVelocitySteps = scene.knobs.iterations;
      this.system.SetPhysicsSettings(physics);
    }
    this.layerOf = i => 2 * of[i] + (still[i] ? 0 : 1);
    this.groups = new Jolt.GroupFilterTable(scene.bodies.length);
    for (const joint of scene.joints) {
      if (!joint.collide && joint.b >= 0) this.groups.DisableCollision(joint.a, joint.b);
    }
  }

  shapeOf(part) {
    const Jolt = this.Jolt;
    if (part.shape === "box") {
      // Its convex radius must fit into it.
      const radius = Math.min(0.05, ...part.half_m);
      return new Jolt.BoxShapeSettings(new Jolt.Vec3(...part.half_m), radius);
    }
    if (part.shape === "sphere") return new Jolt.SphereShapeSettings(part.radius_m);
    if (part.shape === "capsule") return new Jolt.CapsuleShapeSettings(part.half_height_m, part.radius_m);
    if (part.shape === "cylinder")
      return new Jolt.CylinderShapeSettings(part.half_height_m, part.radius_m, Math.min(0.05, part.radius_m, part.half_height_m));
    if (part.shape === "hull") {
      const hull = new Jolt.ConvexHullShapeSettings();
      for (const point of part.points_m) hull.mPoints.push_back(new Jolt.Vec3(...point));
      return hull;
    }
    if (part.shape === "mesh") {
      const corners = new Jolt.VertexList(), triangles = new Jolt.IndexedTriangleList();
      corners.resize(part.points_m.length);
      part.points_m.forEach(([x, y, z], i) => Object.assign(corners.at(i), { x, y, z }));
      triangles.resize(part.triangles.length);
      part.triangles.forEach((corner, i) => corner.forEach((each, k) => triangles.at(i).set_mIdx(k, each)));
      return new Jolt.MeshShapeSettings(corners, triangles, new Jolt.PhysicsMaterialList());
    }
    throw new Lacks(`a ${part.shape}`);
  }

  made(settings) {
    const result = settings.Create();
    if (result.HasError()) throw new Error(result.GetError().c_str());
    return result.Get();
  }

  /** All parts of a body, its centre of mass where the scene has it. */
  wholeShape(body) {
    const Jolt = this.Jolt;
    const [first] = body.parts;
    const isPlain = body.parts.length === 1 && first.at_m.every(each => each === 0) && first.turn[3] === 1;
    let settings = this.shapeOf(first);
    if (!isPlain) {
      settings = new Jolt.StaticCompoundShapeSettings();
      for (const part of body.parts)
        settings.AddShape(new Jolt.Vec3(...part.at_m), new Jolt.Quat(...part.turn), this.shapeOf(part), 0);
      if (body.parts.length === 1)
        settings = new Jolt.RotatedTranslatedShapeSettings(new Jolt.Vec3(...first.at_m), new Jolt.Quat(...first.turn), this.shapeOf(first));
    }
    const shape = this.made(settings);
    const center = shape.GetCenterOfMass();
    const off = [center.GetX(), center.GetY(), center.GetZ()];
    if (body.kind !== "dynamic" || Math.hypot(...off) === 0) return shape;
    return this.made(new Jolt.OffsetCenterOfMassShapeSettings(new Jolt.Vec3(-off[0], -off[1], -off[2]), settings));
  }

  addBodies(scene) {
    const Jolt = this.Jolt;
    const kinds = { static: Jolt.EMotionType_Static, kinematic: Jolt.EMotionType_Kinematic, dynamic: Jolt.EMotionType_Dynamic };
    this.list = scene.bodies.map((body, i) => {
      const settings = new Jolt.BodyCreationSettings(this.wholeShape(body), new Jolt.RVec3(...body.at_m),
        new Jolt.Quat(...body.turn), kinds[body.kind], this.layerOf(i));
      settings.mFriction = body.friction;
      settings.mRestitution = body.restitution;
      settings.mLinearDamping = body.linear_damping_per_s;
      settings.mAngularDamping = body.angular_damping_per_s;
      settings.mMaxLinearVelocity = 1e4;
      settings.mMaxAngularVelocity = 1e4;
      settings.mAllowSleeping = false;
      settings.mApplyGyroscopicForce = true;
      if (body.continuous) settings.mMotionQuality = Jolt.EMotionQuality_LinearCast;
      if (body.kind === "dynamic") {
        settings.mOverrideMassProperties = Jolt.EOverrideMassProperties_MassAndInertiaProvided;
        settings.mMassPropertiesOverride.mMass = body.mass_kg;
        settings.mMassPropertiesOverride.mInertia = Jolt.Mat44.prototype.sScaleVec3(new Jolt.Vec3(...body.inertia_kgm2));
      }
      settings.mCollisionGroup.SetGroupFilter(this.groups);
      settings.mCollisionGroup.SetGroupID(0);
      settings.mCollisionGroup.SetSubGroupID(i);
      const made = this.bodies.CreateBody(settings);
      Jolt.destroy(settings);
      this.bodies.AddBody(made.GetID(), Jolt.EActivation_Activate);
      return made;
    });
  }

  motor(settings, limit, isAngular) {
    if (isAngular) settings.mMinTorqueLimit = -limit, settings.mMaxTorqueLimit = limit;
    else settings.mMinForceLimit = -limit, settings.mMaxForceLimit = limit;
  }

  constraint(scene, joint) {
    const Jolt = this.Jolt;
    const a = this.list[joint.a];
    const b = joint.b >= 0 ? this.list[joint.b] : Jolt.Body.prototype.sFixedToWorld;
    const point = new Jolt.RVec3(...joint.anchor_a_m);
    const axis = new Jolt.Vec3(...joint.axis), normal = new Jolt.Vec3(...across(joint.axis));
    // Angles and displacements are of a against b, and Jolt's are of its second body.
    const make = settings => settings.Create(b, a);
    const both = (settings, names, value) => names.forEach(name => { settings[name + "1"] = settings[name + "2"] = value; });
    if (joint.kind === "ball") {
      const settings = new Jolt.PointConstraintSettings();
      both(settings, ["mPoint"], point);
      return make(settings);
    }
    if (joint.kind === "fixed") {
      const settings = new Jolt.FixedConstraintSettings();
      settings.mAutoDetectPoint = false;
      both(settings, ["mPoint"], point);
      return make(settings);
    }
    if (joint.kind === "distance" || joint.kind === "spring") {
      const settings = new Jolt.DistanceConstraintSettings();
      settings.mPoint1 = new Jolt.RVec3(...joint.anchor_b_m);
      settings.mPoint2 = point;
      const [least, most] = joint.kind === "spring" ? [joint.rest_length_m, joint.rest_length_m] : distances(joint);
      settings.mMinDistance = least;
      settings.mMaxDistance = most;
      if (joint.kind === "spring") {
        settings.mLimitsSpringSettings.mMode = Jolt.ESpringMode_StiffnessAndDamping;
        settings.mLimitsSpringSettings.mStiffness = joint.stiffness_Npm;
        settings.mLimitsSpringSettings.mDamping = joint.damping_Nspm;
      }
      return make(settings);
    }
    if (joint.kind === "cone") {
      const settings = new Jolt.SwingTwistConstraintSettings();
      both(settings, ["mPosition"], point);
      both(settings, ["mTwistAxis"], axis);
      both(settings, ["mPlaneAxis"], normal);
      settings.mNormalHalfConeAngle = settings.mPlaneHalfConeAngle = coneAngle(joint) ?? Math.PI;
      [settings.mTwistMinAngle, settings.mTwistMaxAngle] = joint.twist_limits ?? [-Math.PI, Math.PI];
      return make(settings);
    }
    return this.axisConstraint(joint, make, both, point, axis, normal);
  }

  axisConstraint(joint, make, both, point, axis, normal) {
    const Jolt = this.Jolt;
    const isHinge = joint.kind === "hinge";
    const settings = isHinge ? new Jolt.HingeConstraintSettings() : new Jolt.SliderConstraintSettings();
    both(settings, ["mPoint"], point);
    both(settings, [isHinge ? "mHingeAxis" : "mSliderAxis"], axis);
    both(settings, ["mNormalAxis"], normal);
    refuseTurns(joint);
    if (joint.limits) [settings.mLimitsMin, settings.mLimitsMax] = joint.limits;
    if (joint.motor) this.motor(settings.mMotorSettings, joint.motor.max, isHinge);
    const made = Jolt.castObject(make(settings), isHinge ? Jolt.HingeConstraint : Jolt.SliderConstraint);
    if (joint.motor) {
      made.SetMotorState(Jolt.EMotorState_Velocity);
      if (isHinge) made.SetTargetAngularVelocity(joint.motor.target);
      else made.SetTargetVelocity(joint.motor.target);
    }
    return made;
  }

  setState(i, [x, y, z, qx, qy, qz, qw, vx, vy, vz, wx, wy, wz]) {
    const Jolt = this.Jolt, id = this.list[i].GetID();
    this.bodies.SetPositionAndRotation(id, new Jolt.RVec3(x, y, z), new Jolt.Quat(qx, qy, qz, qw), Jolt.EActivation_Activate);
    this.bodies.SetLinearAndAngularVelocity(id, new Jolt.Vec3(vx, vy, vz), new Jolt.Vec3(wx, wy, wz));
  }

  setGravity(gravity_mps2) {
    this.system.SetGravity(new this.Jolt.Vec3(...gravity_mps2));
  }

  step(step_s) {
    this.jolt.Step(step_s, 1);
  }

  state(i, out, at) {
    const body = this.list[i];
    const put = v => { out[at++] = v.GetX(); out[at++] = v.GetY(); out[at++] = v.GetZ(); };
    put(body.GetCenterOfMassPosition());
    const q = body.GetRotation();
    put(q);
    out[at++] = q.GetW();
    put(body.GetLinearVelocity());
    put(body.GetAngularVelocity());
  }

  free() {
    this.Jolt.destroy(this.jolt);
  }
}
