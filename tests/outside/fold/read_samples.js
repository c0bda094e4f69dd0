// The nets of samples.json, read by the reference library and held against what Origami Simulator asks of a file before
// it imports it: these four arrays, no cut edges in need of splitting, letters that it knows, folds between two faces.
const assert = require('assert');
const fs = require('fs');
const read_net = require('./read_net.js');

const nets = JSON.parse(fs.readFileSync('samples.json', 'utf8')).filter(({ is_net }) => is_net);
assert(nets.length >= 10, `only ${nets.length} nets`);
for (const { name, panels, joints } of nets) {
  read_net(`${name}.fold`, panels, joints);
  the_simulator_imports(name);
}

function the_simulator_imports(name) {
  const net = JSON.parse(fs.readFileSync(`${name}.fold`, 'utf8'));
  for (const key of ['vertices_coords', 'edges_vertices', 'edges_assignment', 'faces_vertices'])
    assert(Array.isArray(net[key]) && net[key].length > 0, `${name}: no ${key}`);
  assert.strictEqual(net.edges_assignment.length, net.edges_vertices.length, name);
  assert.strictEqual(net.edges_foldAngle.length, net.edges_vertices.length, name);
  const key = (a, b) => (a < b ? `${a} ${b}` : `${b} ${a}`);
  const faces = new Map();
  for (const face of net.faces_vertices)
    face.forEach((a, i) => {
      const side = key(a, face[(i + 1) % face.length]);
      faces.set(side, (faces.get(side) ?? 0) + 1);
    });
  net.edges_vertices.forEach(([a, b], e) => {
    const letter = net.edges_assignment[e];
    assert('BMVFU'.includes(letter), `${name}: edge ${e} is '${letter}'`);
    assert.strictEqual(faces.get(key(a, b)), letter === 'B' ? 1 : 2, `${name}: faces of edge ${e}`);
    const angle = net.edges_foldAngle[e];
    if (letter === 'M') assert(angle <= 0 && angle >= -180, `${name}: edge ${e} folds by ${angle}`);
    if (letter === 'V') assert(angle >= 0 && angle <= 180, `${name}: edge ${e} folds by ${angle}`);
  });
  assert.deepStrictEqual([...new Set(net.vertices_coords.map((p) => p.length))], [2], name);
}
