// The reference library of the format reads a net of ours and finds in it what we meant.
// usage: read_net.js NET.fold PANELS FOLDS      or, from another script: read_net(path, panels, folds)
const assert = require('assert');
const fs = require('fs');
const FOLD = require('fold');

function read_net(path, panels, folds) {
  const net = JSON.parse(fs.readFileSync(path, 'utf8'));
  assert.strictEqual(net.file_spec, 1.2);
  assert.strictEqual(net.faces_vertices.length, Number(panels));
  assert.strictEqual(net.edges_assignment.filter((letter) => 'MVF'.includes(letter)).length, Number(folds));

  // Its own walk around the edges finds our panels, with our orientation.
  const normal = (face) => {
    const start = face.indexOf(Math.min(...face));
    return face.slice(start).concat(face.slice(0, start)).join(' ');
  };
  const found = FOLD.convert.edges_vertices_to_faces_vertices(FOLD.convert.deepCopy(net));
  const ours = new Set(net.faces_vertices.map(normal));
  assert.strictEqual(found.faces_vertices.map(normal).filter((face) => ours.has(face)).length, Number(panels));

  // What it takes for boundary is what we marked as boundary.
  const marked = net.edges_assignment.map((letter, e) => (letter === 'B' ? e : -1)).filter((e) => e >= 0);
  FOLD.convert.faces_vertices_to_faces_edges(net);
  const uses = new Array(net.edges_vertices.length).fill(0);
  net.faces_edges.flat().forEach((e) => uses[e]++);
  assert.deepStrictEqual(uses.map((n, e) => (n === 1 ? e : -1)).filter((e) => e >= 0), marked);

  // The folded form inherits everything but its coordinates, and no side changes its length.
  const folded = net.file_frames[0];
  assert.deepStrictEqual(folded.frame_classes, ['foldedForm']);
  for (const [a, b] of net.edges_vertices) {
    const flat = FOLD.geom.dist(net.vertices_coords[a], net.vertices_coords[b]);
    const solid = FOLD.geom.dist(folded.vertices_coords[a], folded.vertices_coords[b]);
    assert(Math.abs(flat - solid) < 1e-9 * (1 + solid), `edge ${a}-${b}: ${flat} flat, ${solid} folded`);
  }
  console.log(`${path}: ${panels} panels, ${folds} folds`);
}

module.exports = read_net;
if (require.main === module) read_net(...process.argv.slice(2));
