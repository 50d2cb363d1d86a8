// Steps scenes of rigid bodies with an engine that npm has: `node run.mjs ENGINE FOLDER`. FOLDER/node_modules holds the packages.
// Each line of the standard input is answered with a line, as engine/study/engines/engine_process.h says.
import { readFileSync, writeSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { createInterface } from "node:readline";
import { pathToFileURL } from "node:url";

import { Lacks } from "./scene.mjs";

console.log = console.error;  // engines may print; the standard output is for answers

function say(value) {
  const bytes = Buffer.from(JSON.stringify(value) + "\n");
  for (let at = 0; at < bytes.length;) at += writeSync(1, bytes, at);
}

/** A module of an npm package in the folder, and the package's version. */
function importer(folder) {
  const require = createRequire(join(folder, "package.json"));
  return {
    load: name => import(pathToFileURL(require.resolve(name)).href),
    version: name => JSON.parse(readFileSync(join(folder, "node_modules", name, "package.json"), "utf8")).version,
    fileOf: (name, file) => join(folder, "node_modules", name, file),
  };
}

const cpuMs = () => {
  const { user, system } = process.cpuUsage();
  return (user + system) / 1000;
};

/** Does the steps that are asked for, and says what they cost and led to. */
function advance(world, scene, request) {
  for (const [body, ...state] of request.set ?? []) world.setState(body, state);
  if (request.gravity_mps2) world.setGravity(request.gravity_mps2);
  const step_ms = [];
  const before = cpuMs();
  for (let i = 0; i < request.steps; ++i) {
    const begin = performance.now();
    world.step(1 / scene.step_hz);
    step_ms.push(performance.now() - begin);
  }
  const cpu_ms = cpuMs() - before;
  const states = new Array(13 * scene.moving.length);
  scene.moving.forEach((body, i) => world.state(body, states, 13 * i));
  return { cpu_ms, step_ms, states };
}

async function main() {
  const [name, folder] = process.argv.slice(2);
  const { load } = await import(`./${name}.mjs`);
  const engine = await load(importer(folder));
  say({ version: engine.version });
  let world, scene;
  for await (const line of createInterface({ input: process.stdin })) {
    const request = JSON.parse(line);
    if (request.scene) {
      world?.free();
      scene = request.scene;
      world = engine.world(scene);
      say({});
    } else {
      say(advance(world, scene, request));
    }
  }
}

main().catch(error => {
  if (error instanceof Lacks) say({ lacks: error.message });
  else say({ failed: error.code === "MODULE_NOT_FOUND" ? "its package is not installed" : String(error.message ?? error) });
});
