// Rapier as WebAssembly (npm: @dimforge/rapier3d-compat): its own defaults, but no sleep.
import { Lacks, distances, refuseSpecials, refuseTurns, rotate, seenFrom, turnXTo } from "./scene.mjs";

const PACKAGE = "@dimforge/rapier3d-compat";
const vec = ([x, y, z]) => ({ x, y, z });
const quat = ([x, y, z, w]) => ({ x, y, z, w });

export async function load(packages) {
  const module = await packages.load(PACKAGE);
  const rapier = module.default?.World ? module.default : module;
  await rapier.init();
  return { version: packages.version(PACKAGE), world: scene => new World(rapier, scene) };
}

/** Its sliders have one axis for both bodies' frames. */
function refuseTurned(a, b) {
  const isTurned = b ? !b.turn.every((each, i) => Math.abs(each - a.turn[i]) < 1e-6) : Math.abs(a.turn[3]) < 1 - 1e-12;
  if (isTurned) throw new Lacks("a slider between bodies that are turned against each other");
}

class World {
  constructor(rapier, scene) {
    this.rapier = rapier;
    refuseSpecials(scene);
    this.world = new rapier.World(vec(scene.gravity_mps2));
    if (scene.knobs?.iterations) this.world.integrationParameters.numSolverIterations = scene.knobs.iterations;
    this.list = scene.bodies.map(body => this.add(body));
    for (const joint of scene.joints) this.join(scene, joint);
  }

  shapeOf(part) {
    const { ColliderDesc } = this.rapier;
    switch (part.shape) {
      case "box": return ColliderDesc.cuboid(...part.half_m);
      case "sphere": return ColliderDesc.ball(part.radius_m);
      case "capsule": return ColliderDesc.capsule(part.half_height_m, part.radius_m);
      case "cylinder": return ColliderDesc.cylinder(part.half_height_m, part.radius_m);
      case "cone": return ColliderDesc.cone(part.half_height_m, part.radius_m);
      case "hull": return ColliderDesc.convexHull(new Float32Array(part.points_m.flat()));
      case "mesh": return ColliderDesc.trimesh(new Float32Array(part.points_m.flat()), new Uint32Array(part.triangles.flat()));
    }
    throw new Lacks(`a ${part.shape}`);
  }

  add(body) {
    const { RigidBodyDesc, CoefficientCombineRule } = this.rapier;
    const desc = { static: RigidBodyDesc.fixed, kinematic: RigidBodyDesc.kinematicVelocityBased, dynamic: RigidBodyDesc.dynamic }[body.kind]();
    desc.setTranslation(...body.at_m).setRotation(quat(body.turn)).setCanSleep(false);
    desc.setLinearDamping(body.linear_damping_per_s).setAngularDamping(body.angular_damping_per_s).setCcdEnabled(body.continuous);
    if (body.kind === "dynamic")
      desc.setAdditionalMassProperties(body.mass_kg, vec([0, 0, 0]), vec(body.inertia_kgm2), quat([0, 0, 0, 1]));
    const made = this.world.createRigidBody(desc);
    if (body.group > 0xffff) throw new Lacks("more than 16 groups");
    for (const part of body.parts) {
      const shape = this.shapeOf(part);
      if (!shape) throw new Error("it refuses a hull");
      shape.setTranslation(...part.at_m).setRotation(quat(part.turn)).setDensity(0);
      // Two bodies' factors are multiplied.
      shape.setFriction(Math.sqrt(body.friction)).setFrictionCombineRule(CoefficientCombineRule.Multiply);
      shape.setRestitution(body.restitution).setRestitutionCombineRule(CoefficientCombineRule.Max);
      shape.setCollisionGroups(((body.group & 0xffff) << 16 | (body.collides_with & 0xffff)) >>> 0);
      this.world.createCollider(shape, made);
    }
    return made;
  }

  /** Axes are along the second body's frame, so that one seen from the first leads to the other. */
  join(scene, joint) {
    const { JointData, RigidBodyDesc } = this.rapier;
    const a = scene.bodies[joint.a], b = joint.b >= 0 ? scene.bodies[joint.b] : undefined;
    const made_b = b ? this.list[joint.b] : (this.anchor ??= this.world.createRigidBody(RigidBodyDesc.fixed()));
    const turn = turnXTo(joint.axis);
    const on_a = seenFrom(a, joint.anchor_a_m, turn), on_b = seenFrom(b, joint.anchor_b_m, turn);
    const [p, q] = [vec(on_b.at), vec(on_a.at)];
    const axisOn = frame => vec(rotate(frame.turn, [1, 0, 0]));
    const datas = {
      ball: () => JointData.spherical(p, q),
      cone: () => { if (joint.limits || joint.twist_limits) throw new Lacks("limits of a cone joint"); return JointData.spherical(p, q); },
      fixed: () => JointData.fixed(p, quat(on_b.turn), q, quat(on_a.turn)),
      hinge: () => JointData.revoluteWithAxes(p, q, axisOn(on_b), axisOn(on_a)),
      slider: () => { refuseTurned(a, b); return JointData.prismatic(p, q, axisOn(on_a)); },
      spring: () => JointData.spring(joint.rest_length_m, joint.stiffness_Npm, joint.damping_Nspm, p, q),
      distance: () => {
        const [least, most] = distances(joint);
        if (least > 0) throw new Lacks("a joint that keeps a distance from below");
        return JointData.rope(most, p, q);
      },
    };
    const data = datas[joint.kind]();
    const made = this.world.createImpulseJoint(data, made_b, this.list[joint.a], true);
    made.setContactsEnabled(joint.collide);
    if (joint.limits && (joint.kind === "hinge" || joint.kind === "slider")) {
      refuseTurns(joint);
      made.setLimits(...joint.limits);
    }
    if (joint.motor) throw new Lacks("a motor with a largest force");
  }

  setState(i, [x, y, z, qx, qy, qz, qw, vx, vy, vz, wx, wy, wz]) {
    const body = this.list[i];
    body.setTranslation({ x, y, z }, true);
    body.setRotation({ x: qx, y: qy, z: qz, w: qw }, true);
    body.setLinvel({ x: vx, y: vy, z: vz }, true);
    body.setAngvel({ x: wx, y: wy, z: wz }, true);
  }

  setGravity(gravity_mps2) {
    this.world.gravity = vec(gravity_mps2);
  }

  step(step_s) {
    this.world.timestep = step_s;
    this.world.step();
  }

  state(i, out, at) {
    const body = this.list[i];
    const put = v => { out[at++] = v.x; out[at++] = v.y; out[at++] = v.z; };
    put(body.translation());
    const q = body.rotation();
    put(q);
    out[at++] = q.w;
    put(body.linvel());
    put(body.angvel());
  }

  free() {
    this.world.free();
  }
}
