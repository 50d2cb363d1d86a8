// Jolt's soft bodies as WebAssembly (npm: jolt-physics): `node jolt_soft.mjs PACKAGES PROBLEM` prints where the points are in the end and
// what a step cost. Edges are springs of the problem's stiffness, volumes are kept where it says so.
import { readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";
import path from "node:path";

const [packages, file] = process.argv.slice(2);
const problem = JSON.parse(readFileSync(file, "utf8"));
const { default: init } = await import(pathToFileURL(path.join(packages, "node_modules/jolt-physics/dist/jolt-physics.wasm-compat.js")));
const Jolt = await init();

const pairs = new Jolt.ObjectLayerPairFilterTable(1);
const places = new Jolt.BroadPhaseLayerInterfaceTable(1, 1);
places.MapObjectToBroadPhaseLayer(0, new Jolt.BroadPhaseLayer(0));
const settings = new Jolt.JoltSettings();
settings.mObjectLayerPairFilter = pairs;
settings.mBroadPhaseLayerInterface = places;
settings.mObjectVsBroadPhaseLayerFilter = new Jolt.ObjectVsBroadPhaseLayerFilterTable(places, 1, pairs, 1);
const jolt = new Jolt.JoltInterface(settings);
const system = jolt.GetPhysicsSystem();
const bodies = system.GetBodyInterface();
system.SetGravity(new Jolt.Vec3(0, -problem.gravity_mps2, 0));

const shared = new Jolt.SoftBodySharedSettings();
problem.points_m.forEach((point, i) => {
  const vertex = new Jolt.SoftBodySharedSettingsVertex();
  vertex.mPosition = new Jolt.Float3(...point);
  vertex.mInvMass = problem.masses_kg[i] > 0 ? 1 / problem.masses_kg[i] : 0;
  shared.mVertices.push_back(vertex);
});
for (const [a, b, stiff_Npm] of problem.edges) shared.mEdgeConstraints.push_back(new Jolt.SoftBodySharedSettingsEdge(a, b, 1 / stiff_Npm));
for (const corners of problem.tetrahedra) shared.mVolumeConstraints.push_back(new Jolt.SoftBodySharedSettingsVolume(...corners, 0));
for (const corners of problem.faces) shared.AddFace(new Jolt.SoftBodySharedSettingsFace(...corners, 0));
shared.CalculateEdgeLengths();
shared.CalculateVolumeConstraintVolumes();
shared.Optimize();

const creation = new Jolt.SoftBodyCreationSettings(shared, new Jolt.RVec3(0, 0, 0), new Jolt.Quat(0, 0, 0, 1), 0);
creation.mNumIterations = problem.iterations;
creation.mAllowSleeping = false;
const body = bodies.CreateSoftBody(creation);
bodies.AddBody(body.GetID(), Jolt.EActivation_Activate);

const steps = Math.round(problem.seconds * problem.hz);
const timed = Math.round(problem.timed_s * problem.hz);
let used = 0;
for (let i = 0; i < steps; ++i) {
  if (i === 0) used = process.cpuUsage();
  if (i === timed) used = process.cpuUsage(used);
  jolt.Step(1 / problem.hz, 1);
}
const vertices = Jolt.castObject(body.GetMotionProperties(), Jolt.SoftBodyMotionProperties).GetVertices();
const origin = body.GetCenterOfMassPosition();
const points_m = problem.points_m.map((_, i) => {
  const at = vertices.at(i).mPosition;
  return [origin.GetX() + at.GetX(), origin.GetY() + at.GetY(), origin.GetZ() + at.GetZ()];
});
console.log(JSON.stringify({ points_m, step_ms: (used.user + used.system) / 1e3 / timed }));
