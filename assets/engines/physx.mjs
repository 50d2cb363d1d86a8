// PhysX as WebAssembly (npm: physx-js-webidl): its own defaults with the solver TGS (or the knob `pgs`), but no damping beyond
// the scene's, no sleep, gyroscopic torque, and no limit of spin that a scene reaches.
import { readFileSync } from "node:fs";

import { Lacks, coneAngle, distances, multiply, refuseSpecials, seenFrom, turnXTo } from "./scene.mjs";

const PACKAGE = "physx-js-webidl";

export async function load(packages) {
  const PhysX = await asInBrowser(async () => {
    const { default: init } = await packages.load(PACKAGE);
    return init({ wasmBinary: readFileSync(packages.fileOf(PACKAGE, "physx-js-webidl.wasm")) });
  });
  const version = PhysX.PHYSICS_VERSION;
  const foundation = PhysX.CreateFoundation(version, new PhysX.PxDefaultAllocator(), new PhysX.PxDefaultErrorCallback());
  const scales = new PhysX.PxTolerancesScale();
  const physics = PhysX.CreatePhysics(version, foundation, scales);
  PhysX.InitExtensions(physics);
  return { version: packages.version(PACKAGE), world: scene => new World(PhysX, physics, scales, scene) };
}

/** The package is built for browsers and refuses Node: while it starts, it sees none. */
async function asInBrowser(start) {
  const versions = Object.getOwnPropertyDescriptor(process, "versions");
  Object.defineProperty(process, "versions", { value: {}, configurable: true });
  globalThis.window ??= globalThis;
  try {
    return await start();
  } finally {
    Object.defineProperty(process, "versions", versions);
  }
}

class World {
  constructor(PhysX, physics, scales, scene) {
    Object.assign(this, { PhysX, physics, scales });
    refuseSpecials(scene);
    const desc = new PhysX.PxSceneDesc(scales);
    desc.gravity = this.vec(scene.gravity_mps2);
    desc.cpuDispatcher = PhysX.DefaultCpuDispatcherCreate(0);
    desc.filterShader = PhysX.DefaultFilterShader();
    desc.solverType = scene.knobs?.pgs ? PhysX.PxSolverTypeEnum.ePGS : PhysX.PxSolverTypeEnum.eTGS;
    if (scene.bodies.some(body => body.continuous)) desc.flags.raise(PhysX.PxSceneFlagEnum.eENABLE_CCD);
    this.scene = physics.createScene(desc);
    PhysX.destroy(desc);
    this.iterations = scene.knobs?.iterations;
    this.list = scene.bodies.map(body => this.add(body));
    for (const joint of scene.joints) this.join(scene, joint);
  }

  vec(v) { return new this.PhysX.PxVec3(...v); }
  pose(at, turn) { return new this.PhysX.PxTransform(this.vec(at), new this.PhysX.PxQuat(...turn)); }

  /** A shape's geometry, and how its own axes lie in the part. */
  geometryOf(part) {
    const { PhysX } = this;
    const along_y = turnXTo([0, 1, 0]);
    if (part.shape === "box") return [new PhysX.PxBoxGeometry(...part.half_m)];
    if (part.shape === "sphere") return [new PhysX.PxSphereGeometry(part.radius_m)];
    if (part.shape === "capsule") return [new PhysX.PxCapsuleGeometry(part.radius_m, part.half_height_m), along_y];
    if (part.shape !== "hull" && part.shape !== "mesh") throw new Lacks(`a ${part.shape}`);
    const isHull = part.shape === "hull";
    const desc = isHull ? new PhysX.PxConvexMeshDesc() : new PhysX.PxTriangleMeshDesc();
    desc.points.count = part.points_m.length;
    desc.points.stride = 12;
    const points = new PhysX.Vector_PxVec3(part.points_m.length);
    part.points_m.forEach(([x, y, z], i) => Object.assign(points.at(i), { x, y, z }));
    desc.points.data = points.data();
    const cooking = new PhysX.PxCookingParams(this.scales);
    if (isHull) {
      desc.flags.raise(PhysX.PxConvexFlagEnum.eCOMPUTE_CONVEX);
      const hull = PhysX.CreateConvexMesh(cooking, desc);
      if (!hull?.ptr) throw new Error("it refuses a hull");
      return [new PhysX.PxConvexMeshGeometry(hull)];
    }
    desc.triangles.count = part.triangles.length;
    desc.triangles.stride = 12;
    const corners = new PhysX.PxArray_PxU32(3 * part.triangles.length);
    part.triangles.flat().forEach((corner, i) => corners.set(i, corner));
    desc.triangles.data = corners.begin();
    return [new PhysX.PxTriangleMeshGeometry(PhysX.CreateTriangleMesh(cooking, desc))];
  }

  add(body) {
    const { PhysX, physics } = this;
    const pose = this.pose(body.at_m, body.turn);
    const made = body.kind === "static" ? physics.createRigidStatic(pose) : physics.createRigidDynamic(pose);
    // Two bodies' factors are multiplied.
    const factor = Math.sqrt(body.friction);
    const material = physics.createMaterial(factor, factor, body.restitution);
    material.setFrictionCombineMode(PhysX.PxCombineModeEnum.eMULTIPLY);
    material.setRestitutionCombineMode(PhysX.PxCombineModeEnum.eMAX);
    const filter = new PhysX.PxFilterData(body.group >>> 0, body.collides_with >>> 0, 0, 0);
    const flags = new PhysX.PxShapeFlags(PhysX.PxShapeFlagEnum.eSIMULATION_SHAPE);
    for (const part of body.parts) {
      const [geometry, own] = this.geometryOf(part);
      const shape = physics.createShape(geometry, material, true, flags);
      shape.setLocalPose(this.pose(part.at_m, own ? multiply(part.turn, own) : part.turn));
      shape.setSimulationFilterData(filter);
      made.attachShape(shape);
    }
    if (body.kind !== "static") this.weigh(made, body);
    this.scene.addActor(made);
    return made;
  }

  weigh(made, body) {
    const { PhysX } = this;
    const flag = PhysX.PxRigidBodyFlagEnum;
    if (body.kind === "kinematic") return made.setRigidBodyFlag(flag.eKINEMATIC, true);
    made.setCMassLocalPose(this.pose([0, 0, 0], [0, 0, 0, 1]));
    made.setMass(body.mass_kg);
    made.setMassSpaceInertiaTensor(this.vec(body.inertia_kgm2));
    made.setLinearDamping(body.linear_damping_per_s);
    made.setAngularDamping(body.angular_damping_per_s);
    made.setMaxLinearVelocity(1e4);
    made.setMaxAngularVelocity(1e4);
    made.setSleepThreshold(0);
    made.setStabilizationThreshold(0);
    made.setRigidBodyFlag(flag.eENABLE_GYROSCOPIC_FORCES, true);
    if (body.continuous) made.setRigidBodyFlag(flag.eENABLE_CCD, true);
    if (this.iterations) made.setSolverIterationCounts(this.iterations, 1);
  }

  join(scene, joint) {
    const { PhysX, physics } = this;
    const a = scene.bodies[joint.a], b = joint.b >= 0 ? scene.bodies[joint.b] : undefined;
    const turn = turnXTo(joint.axis);
    const on = (body, at) => { const frame = seenFrom(body, at, turn); return this.pose(frame.at, frame.turn); };
    // Angles and displacements are of a against b, and PhysX's are of its second actor.
    const ends = [physics, b ? this.list[joint.b] : null, on(b, joint.anchor_b_m), this.list[joint.a], on(a, joint.anchor_a_m)];
    let made;
    if (joint.kind === "distance" || joint.kind === "spring") made = this.distanceJoint(joint, ends);
    else if (joint.kind === "hinge") made = this.hinge(joint, ends);
    else made = this.sixAxes(joint, ends);
    made.setConstraintFlag(PhysX.PxConstraintFlagEnum.eCOLLISION_ENABLED, joint.collide);
  }

  distanceJoint(joint, ends) {
    const { PhysX } = this;
    const made = PhysX.DistanceJointCreate(...ends);
    const flag = PhysX.PxDistanceJointFlagEnum;
    const [least, most] = joint.kind === "spring" ? [joint.rest_length_m, joint.rest_length_m] : distances(joint);
    made.setMinDistance(least);
    made.setMaxDistance(most);
    made.setTolerance(0);
    made.setDistanceJointFlag(flag.eMIN_DISTANCE_ENABLED, true);
    made.setDistanceJointFlag(flag.eMAX_DISTANCE_ENABLED, true);
    if (joint.kind === "spring") {
      made.setStiffness(joint.stiffness_Npm);
      made.setDamping(joint.damping_Nspm);
      made.setDistanceJointFlag(flag.eSPRING_ENABLED, true);
    }
    return made;
  }

  hinge(joint, ends) {
    const { PhysX } = this;
    const made = PhysX.RevoluteJointCreate(...ends);
    const flag = PhysX.PxRevoluteJointFlagEnum;
    if (joint.limits) {
      if (Math.max(-joint.limits[0], joint.limits[1]) >= 2 * Math.PI) throw new Lacks("a hinge that counts turns");
      made.setLimit(new PhysX.PxJointAngularLimitPair(...joint.limits));
      made.setRevoluteJointFlag(flag.eLIMIT_ENABLED, true);
    }
    if (joint.motor) {
      made.setDriveVelocity(joint.motor.target);
      made.setDriveForceLimit(joint.motor.max);
      made.setRevoluteJointFlag(flag.eDRIVE_ENABLED, true);
      made.setConstraintFlag(PhysX.PxConstraintFlagEnum.eDRIVE_LIMITS_ARE_FORCES, true);
    }
    return made;
  }

  sixAxes(joint, ends) {
    const { PhysX } = this;
    const made = PhysX.D6JointCreate(...ends);
    const axis = PhysX.PxD6AxisEnum, motion = PhysX.PxD6MotionEnum;
    if (joint.motor) throw new Lacks("a slider with a motor of a largest force");
    if (joint.kind === "ball" || joint.kind === "cone")
      for (const each of [axis.eTWIST, axis.eSWING1, axis.eSWING2]) made.setMotion(each, motion.eFREE);
    if (joint.kind === "cone" && joint.limits) {
      const angle = coneAngle(joint);
      made.setMotion(axis.eSWING1, motion.eLIMITED);
      made.setMotion(axis.eSWING2, motion.eLIMITED);
      made.setSwingLimit(new PhysX.PxJointLimitCone(angle, angle));
    }
    if (joint.kind === "cone" && joint.twist_limits) {
      made.setMotion(axis.eTWIST, motion.eLIMITED);
      made.setTwistLimit(new PhysX.PxJointAngularLimitPair(...joint.twist_limits));
    }
    if (joint.kind === "slider") {
      made.setMotion(axis.eX, joint.limits ? motion.eLIMITED : motion.eFREE);
      if (joint.limits) made.setLinearLimit(axis.eX, new PhysX.PxJointLinearLimitPair(...joint.limits, new PhysX.PxSpring(0, 0)));
    }
    return made;
  }

  setState(i, [x, y, z, qx, qy, qz, qw, vx, vy, vz, wx, wy, wz]) {
    const body = this.list[i];
    body.setGlobalPose(this.pose([x, y, z], [qx, qy, qz, qw]));
    body.setLinearVelocity(this.vec([vx, vy, vz]));
    body.setAngularVelocity(this.vec([wx, wy, wz]));
  }

  setGravity(gravity_mps2) {
    this.scene.setGravity(this.vec(gravity_mps2));
  }

  step(step_s) {
    this.scene.simulate(step_s);
    this.scene.fetchResults(true);
  }

  state(i, out, at) {
    const body = this.list[i];
    const put = v => { out[at++] = v.x; out[at++] = v.y; out[at++] = v.z; };
    const { p, q } = body.getGlobalPose();
    put(p);
    put(q);
    out[at++] = q.w;
    put(body.getLinearVelocity());
    put(body.getAngularVelocity());
  }

  free() {
    this.scene.release();
  }
}
