// Havok as WebAssembly (npm: @babylonjs/havok): its own defaults, but no damping beyond the scene's, no sleep, and a limit of
// speed that no scene reaches.
import { readFileSync } from "node:fs";

import { Lacks, across, distances, refuseSpecials, refuseTurns, rotate, seenFrom } from "./scene.mjs";

const PACKAGE = "@babylonjs/havok";

export async function load(packages) {
  const { default: init } = await packages.load(PACKAGE);
  const havok = await init({ wasmBinary: readFileSync(packages.fileOf(PACKAGE, "lib/esm/HavokPhysics.wasm")) });
  return { version: packages.version(PACKAGE), world: scene => new World(havok, scene) };
}

class World {
  constructor(havok, scene) {
    this.havok = havok;
    refuseSpecials(scene);
    this.world = this.call("HP_World_Create");
    this.setGravity(scene.gravity_mps2);
    this.call("HP_World_SetSpeedLimit", this.world, 1e4, 1e4);
    if (scene.step_hz) this.call("HP_World_SetIdealStepTime", this.world, 1 / scene.step_hz);
    this.list = scene.bodies.map(body => this.add(body));
    this.joints = scene.joints.map(joint => this.join(scene, joint));
  }

  /** Calls it, and gives what it gives beside its result. */
  call(name, ...values) {
    const answer = this.havok[name](...values);
    const [result, value] = Array.isArray(answer) ? answer : [answer];
    if (result !== this.havok.Result.RESULT_OK) throw new Error(`${name} failed`);
    return value;
  }

  /** Puts numbers where the engine reads them. */
  withNumbers(list, Kind, use) {
    const bytes = list.length * 4;
    const at = this.havok._malloc(bytes);
    new Kind(this.havok.HEAPU8.buffer, at, list.length).set(list);
    try {
      return use(at);
    } finally {
      this.havok._free(at);
    }
  }

  shapeOf(part) {
    const end = sign => [0, sign * part.half_height_m, 0];
    const none = [0, 0, 0], turn = [0, 0, 0, 1];
    switch (part.shape) {
      case "box": return this.call("HP_Shape_CreateBox", none, turn, part.half_m.map(each => 2 * each));
      case "sphere": return this.call("HP_Shape_CreateSphere", none, part.radius_m);
      case "capsule": return this.call("HP_Shape_CreateCapsule", end(-1), end(1), part.radius_m);
      case "cylinder": return this.call("HP_Shape_CreateCylinder", end(-1), end(1), part.radius_m);
      case "hull": return this.withNumbers(part.points_m.flat(), Float32Array, at =>
        this.call("HP_Shape_CreateConvexHull", at, part.points_m.length));
      case "mesh": return this.withNumbers(part.points_m.flat(), Float32Array, at =>
        this.withNumbers(part.triangles.flat(), Int32Array, triangles =>
          this.call("HP_Shape_CreateMesh", at, part.points_m.length, triangles, part.triangles.length)));
    }
    throw new Lacks(`a ${part.shape}`);
  }

  add(body) {
    const { MotionType, MaterialCombine, ActivationControl } = this.havok;
    const whole = this.call("HP_Shape_CreateContainer");
    for (const part of body.parts) {
      const shape = this.shapeOf(part);
      this.call("HP_Shape_SetMaterial", shape,
        [body.friction, body.friction, body.restitution, MaterialCombine.GEOMETRIC_MEAN, MaterialCombine.MAXIMUM]);
      this.call("HP_Shape_SetFilterInfo", shape, [body.group | 0, body.collides_with | 0]);
      this.call("HP_Shape_AddChild", whole, shape, [part.at_m, part.turn, [1, 1, 1]]);
    }
    const made = this.call("HP_Body_Create");
    this.call("HP_Body_SetShape", made, whole);
    this.call("HP_Body_SetQTransform", made, [body.at_m, body.turn]);
    this.call("HP_Body_SetMotionType", made,
      { static: MotionType.STATIC, kinematic: MotionType.KINEMATIC, dynamic: MotionType.DYNAMIC }[body.kind]);
    if (body.kind === "dynamic")
      this.call("HP_Body_SetMassProperties", made, [[0, 0, 0], body.mass_kg, body.inertia_kgm2.map(each => each / body.mass_kg), [0, 0, 0, 1]]);
    this.call("HP_Body_SetLinearDamping", made, body.linear_damping_per_s);
    this.call("HP_Body_SetAngularDamping", made, body.angular_damping_per_s);
    this.call("HP_World_AddBody", this.world, made, false);
    if (body.kind === "dynamic") this.call("HP_Body_SetActivationControl", made, ActivationControl.ALWAYS_ACTIVE);
    return made;
  }

  join(scene, joint) {
    const { ConstraintAxis: Axis, ConstraintAxisLimitMode: Mode, ConstraintMotorType } = this.havok;
    const made = this.call("HP_Constraint_Create");
    const a = scene.bodies[joint.a], b = joint.b >= 0 ? scene.bodies[joint.b] : undefined;
    const other = b ? this.list[joint.b] : (this.anchor ??= this.makeAnchor());
    this.call("HP_Constraint_SetParentBody", made, other);
    this.call("HP_Constraint_SetChildBody", made, this.list[joint.a]);
    const anchor = (body, at) => {
      const frame = seenFrom(body, at);
      return [frame.at, rotate(frame.turn, joint.axis), rotate(frame.turn, across(joint.axis))];
    };
    this.call("HP_Constraint_SetAnchorInParent", made, ...anchor(b, joint.anchor_b_m));
    this.call("HP_Constraint_SetAnchorInChild", made, ...anchor(a, joint.anchor_a_m));
    this.call("HP_Constraint_SetCollisionsEnabled", made, joint.collide ? 1 : 0);
    const set = (axis, mode) => this.call("HP_Constraint_SetAxisMode", made, axis, mode);
    const limit = (axis, [least, most]) => {
      this.havok.HP_Constraint_SetAxisMode(made, axis, Mode.LIMITED);
      this.call("HP_Constraint_SetAxisMinLimit", made, axis, least);
      this.call("HP_Constraint_SetAxisMaxLimit", made, axis, most);
    };
    const linear = [Axis.LINEAR_X, Axis.LINEAR_Y, Axis.LINEAR_Z], angular = [Axis.ANGULAR_X, Axis.ANGULAR_Y, Axis.ANGULAR_Z];
    const free = { hinge: [Axis.ANGULAR_X], slider: [Axis.LINEAR_X], ball: angular, cone: angular, fixed: [] }[joint.kind];
    if (joint.kind === "distance") {
      limit(Axis.LINEAR_DISTANCE, distances(joint));
    } else if (joint.kind === "spring") {
      limit(Axis.LINEAR_DISTANCE, [joint.rest_length_m, joint.rest_length_m]);
      this.call("HP_Constraint_SetAxisStiffness", made, Axis.LINEAR_DISTANCE, joint.stiffness_Npm);
      this.call("HP_Constraint_SetAxisDamping", made, Axis.LINEAR_DISTANCE, joint.damping_Nspm);
    } else {
      for (const axis of [...linear, ...angular]) set(axis, free.includes(axis) ? Mode.FREE : Mode.LOCKED);
    }
    if (joint.kind === "cone" && (joint.limits || joint.twist_limits)) throw new Lacks("a round cone of limits");
    if (joint.limits && (joint.kind === "hinge" || joint.kind === "slider")) {
      refuseTurns(joint);
      limit(free[0], joint.limits);
    }
    if (joint.motor) {
      this.call("HP_Constraint_SetAxisMotorType", made, free[0], ConstraintMotorType.VELOCITY);
      this.call("HP_Constraint_SetAxisMotorVelocityTarget", made, free[0], joint.motor.target);
      this.call("HP_Constraint_SetAxisMotorMaxForce", made, free[0], joint.motor.max);
    }
    this.call("HP_Constraint_SetEnabled", made, 1);
    return made;
  }

  makeAnchor() {
    const made = this.call("HP_Body_Create");
    this.call("HP_Body_SetMotionType", made, this.havok.MotionType.STATIC);
    this.call("HP_World_AddBody", this.world, made, false);
    return made;
  }

  setState(i, [x, y, z, qx, qy, qz, qw, vx, vy, vz, wx, wy, wz]) {
    this.call("HP_Body_SetQTransform", this.list[i], [[x, y, z], [qx, qy, qz, qw]]);
    this.call("HP_Body_SetLinearVelocity", this.list[i], [vx, vy, vz]);
    this.call("HP_Body_SetAngularVelocity", this.list[i], [wx, wy, wz]);
  }

  setGravity(gravity_mps2) {
    this.call("HP_World_SetGravity", this.world, gravity_mps2);
  }

  step(step_s) {
    this.call("HP_World_Step", this.world, step_s);
  }

  state(i, out, at) {
    const [place, turn] = this.call("HP_Body_GetQTransform", this.list[i]);
    const numbers = [...place, ...turn, ...this.call("HP_Body_GetLinearVelocity", this.list[i]),
      ...this.call("HP_Body_GetAngularVelocity", this.list[i])];
    for (const number of numbers) out[at++] = number;
  }

  free() {
    this.call("HP_World_Release", this.world);
  }
}
