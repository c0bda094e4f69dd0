// Khronos' validator finds nothing to complain about in any animation of samples.json.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import validator from 'gltf-validator';

for (const { name, joints, surfaces } of JSON.parse(readFileSync('samples.json', 'utf8'))) {
  const { issues, info } = await validator.validateBytes(new Uint8Array(readFileSync(`${name}.glb`)));
  assert.deepEqual(issues.messages.filter(({ severity }) => severity < 2).slice(0, 3), [], name);
  assert.equal(info.animationCount, joints > 0 ? 1 : 0, name);
  assert.equal(info.drawCallCount, surfaces, name);
  console.log(`${name}: ${surfaces} surfaces, ${info.totalTriangleCount} triangles`);
}
