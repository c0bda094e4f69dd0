// MuJoCo loads every model of samples.json, and its motors fold it along the keyframes.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import load from '@mujoco/mujoco';

const mujoco = await load();
for (const { name, joints } of JSON.parse(readFileSync('samples.json', 'utf8'))) fold(name, joints);

function fold(name, joints) {
  mujoco.FS.writeFile('/model.xml', readFileSync(`${name}.xml`, 'utf8'));
  const model = mujoco.MjModel.from_xml_path('/model.xml');
  const data = new mujoco.MjData(model);
  assert.equal(model.nu, joints, name);
  const worst = joints > 0 ? followKeyframes(model, data) : 0;
  assert.ok(worst < 0.05, `${name}: a hinge ends ${worst} rad from its goal`);
  console.log(`${name}: ${model.nbody - 1} bodies, ${model.nu} motors, ends within ${worst.toExponential(1)} rad`);
  data.delete();
  model.delete();
}

// The target moves as the path does, then rests for a second.
function followKeyframes(model, data) {
  const controls = Array.from({ length: model.nkey }, (_, k) => Array.from(model.key_ctrl.slice(k * model.nu, (k + 1) * model.nu)));
  const times = Array.from(model.key_time);
  const goal = controls.at(-1);
  mujoco.mj_resetDataKeyframe(model, data, 0);
  const dt = 0.002;
  for (let step = 0, k = 0; step * dt < times.at(-1) + 1; ++step) {
    while (k < model.nkey - 2 && times[k + 1] <= step * dt) ++k;
    const s = Math.min(1, (step * dt - times[k]) / (times[k + 1] - times[k]));
    const ctrl = data.ctrl;
    controls[k].forEach((x, i) => { ctrl[i] = (1 - s) * x + s * controls[k + 1][i]; });
    mujoco.mj_step(model, data);
  }
  const qpos = data.qpos;
  return Math.max(...goal.map((angle, i) => Math.abs(angle - qpos[i])));
}
