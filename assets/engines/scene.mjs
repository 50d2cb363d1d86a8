// What runners share: vectors and quaternions [x, y, z, w] as lists, frames of joints, and what engines cannot do.

/** Thrown where an engine has nothing for what the scene needs: the message names it, "a cone". */
export class Lacks extends Error {}

export const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const sub = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scale = (a, s) => [a[0] * s, a[1] * s, a[2] * s];
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const conjugate = q => [-q[0], -q[1], -q[2], q[3]];
export const multiply = (p, q) => [
  p[3] * q[0] + p[0] * q[3] + p[1] * q[2] - p[2] * q[1],
  p[3] * q[1] - p[0] * q[2] + p[1] * q[3] + p[2] * q[0],
  p[3] * q[2] + p[0] * q[1] - p[1] * q[0] + p[2] * q[3],
  p[3] * q[3] - p[0] * q[0] - p[1] * q[1] - p[2] * q[2]];
export const rotate = (q, v) => {
  const t = scale(cross(q, v), 2);
  return add(add(v, scale(t, q[3])), cross(q, t));
};
export const normalized = v => scale(v, 1 / Math.hypot(...v));
/** A unit vector across the unit vector `axis`. */
export const across = axis => normalized(cross(axis, Math.abs(axis[0]) < 0.7 ? [1, 0, 0] : [0, 1, 0]));
/** The rotation that turns +X to the unit vector `axis`. */
export function turnXTo(axis) {
  const y = across(axis), z = cross(axis, y);
  const m = [axis, y, z];  // columns
  const trace = m[0][0] + m[1][1] + m[2][2];
  const q = trace > 0 ? [m[1][2] - m[2][1], m[2][0] - m[0][2], m[0][1] - m[1][0], 1 + trace]
    : m[0][0] > m[1][1] && m[0][0] > m[2][2]
      ? [1 + m[0][0] - m[1][1] - m[2][2], m[1][0] + m[0][1], m[2][0] + m[0][2], m[1][2] - m[2][1]]
      : m[1][1] > m[2][2]
        ? [m[1][0] + m[0][1], 1 + m[1][1] - m[0][0] - m[2][2], m[2][1] + m[1][2], m[2][0] - m[0][2]]
        : [m[2][0] + m[0][2], m[2][1] + m[1][2], 1 + m[2][2] - m[0][0] - m[1][1], m[0][1] - m[1][0]];
  const length = Math.hypot(...q);
  return q.map(each => each / length);
}
/** A place and a rotation of the world, seen from a body; no body: the world. */
export function seenFrom(body, at, turn = [0, 0, 0, 1]) {
  if (!body) return { at, turn };
  const back = conjugate(body.turn);
  return { at: rotate(back, sub(at, body.at_m)), turn: multiply(back, turn) };
}
/** The least and the most distance that a joint of distance allows. */
export const distances = joint => joint.limits ?? [joint.rest_length_m, joint.rest_length_m];
/** The angle of a cone joint at most between its axes, rad; none: free. */
export const coneAngle = joint => joint.limits ? Math.max(Math.abs(joint.limits[0]), Math.abs(joint.limits[1])) : undefined;

/** What hardly any engine has. */
export function refuseSpecials(scene) {
  for (const body of scene.bodies) {
    if (body.rolling_friction_m || body.spinning_friction_m) throw new Lacks("rolling friction");
    if (body.kind === "dynamic" && body.linear_factor.some(each => each !== 1))
      throw new Lacks("bodies held along an axis");
  }
  for (const joint of scene.joints) {
    if (joint.kind === "elastic") throw new Lacks("elastic joints");
    if (joint.breaks) throw new Lacks("joints that break at a force, counted over a step");
  }
}
/** Refuses a hinge that may turn farther than `most`, rad: engines know angles up to there. */
export function refuseTurns(joint, most = Math.PI) {
  if (joint.kind === "hinge" && joint.limits && Math.max(-joint.limits[0], joint.limits[1]) > most) throw new Lacks("a hinge that counts turns");
}
/** Lists of groups and masks that occur, and which of them each body is of. */
export function layers(scene) {
  const list = [];
  const of = scene.bodies.map(body => {
    const same = list.findIndex(each => each.group === body.group && each.mask === body.collides_with);
    if (same >= 0) return same;
    list.push({ group: body.group, mask: body.collides_with });
    return list.length - 1;
  });
  const touch = (a, b) => (list[a].group & list[b].mask) !== 0 && (list[b].group & list[a].mask) !== 0;
  return { of, count: list.length, touch };
}
