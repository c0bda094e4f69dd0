// MuJoCo loads every model of samples.json, and its motors fold it along the keyframes.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import load from '@mujoco/mujoco';

const SIDE = 0.05; // metres of a unit, which write_samples chose
const mujoco = await load();
for (const { name, joints } of JSON.parse(readFileSync('samples.json', 'utf8'))) fold(name, joints);

function fold(name, joints) {
  mujoco.FS.writeFile('/model.xml', readFileSync(`${name}.xml`, 'utf8'));
  const model = mujoco.MjModel.from_xml_path('/model.xml');
  const data = new mujoco.MjData(model);
  assert.equal(model.nu, joints, name);
  const { worst, gap } = joints > 0 ? followKeyframes(model, data) : { worst: 0, gap: 0 };
  assert.ok(worst < 0.05, `${name}: a hinge ends ${worst} rad from its goal`);
  assert.ok(gap < 0.02 * SIDE, `${name}: a loop opens by ${gap} m`);
  console.log(`${name}: ${model.nbody - 1} bodies, ${model.nu} motors, ends within ${worst.toExponential(1)} rad, ` +
    `${model.neq} constraints close loops within ${(1e6 * gap).toFixed(1)} micrometres`);
  data.delete();
  model.delete();
}

// How far the two bodies of a loop constraint are apart at its anchor, at most.
function widestLoop(model, data) {
  let gap = 0;
  for (let e = 0; e < model.neq; ++e) {
    const ends = [model.eq_obj1id[e], model.eq_obj2id[e]].map((body, side) => {
      const anchor = model.eq_data.slice(e * 11 + 3 * side, e * 11 + 3 * side + 3);
      const turn = data.xmat.slice(9 * body, 9 * body + 9), at = data.xpos.slice(3 * body, 3 * body + 3);
      return [0, 1, 2].map((i) => at[i] + turn[3 * i] * anchor[0] + turn[3 * i + 1] * anchor[1] + turn[3 * i + 2] * anchor[2]);
    });
    gap = Math.max(gap, Math.hypot(...ends[0].map((x, i) => x - ends[1][i])));
  }
  return gap;
}

// The target moves as the path does, then rests for a second.
function followKeyframes(model, data) {
  const controls = Array.from({ length: model.nkey }, (_, k) => Array.from(model.key_ctrl.slice(k * model.nu, (k + 1) * model.nu)));
  const times = Array.from(model.key_time);
  const goal = controls.at(-1);
  mujoco.mj_resetDataKeyframe(model, data, 0);
  const dt = 0.002;
  let gap = 0;
  for (let step = 0, k = 0; step * dt < times.at(-1) + 1; ++step) {
    while (k < model.nkey - 2 && times[k + 1] <= step * dt) ++k;
    const s = Math.min(1, (step * dt - times[k]) / (times[k + 1] - times[k]));
    const ctrl = data.ctrl;
    controls[k].forEach((x, i) => { ctrl[i] = (1 - s) * x + s * controls[k + 1][i]; });
    mujoco.mj_step(model, data);
    if (step % 50 === 0) gap = Math.max(gap, widestLoop(model, data));
  }
  const qpos = data.qpos;
  return { worst: Math.max(...goal.map((angle, i) => Math.abs(angle - qpos[i]))), gap };
}
