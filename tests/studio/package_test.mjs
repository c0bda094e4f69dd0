// The npm package as someone uses it who installed it.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { createPlico, PlicoError } from 'plico';

const plico = await createPlico();
const text = (bytes) => new TextDecoder().decode(bytes);

test('the version is that of the package', () => {
  assert.equal(plico.version, JSON.parse(readFileSync('node_modules/plico/package.json', 'utf8')).version);
});

test('a sample becomes a net and a page', () => {
  const { files: mesh } = plico.run('sample', { name: 'bird', output: 'bird.obj' });
  const net = plico.run('unfold', { mesh: 'bird.obj', output: 'bird.fold' }, mesh);
  assert.equal(net.exitCode, 0);
  assert.equal(JSON.parse(text(net.files['bird.fold'])).file_spec, 1.2);
  const pages = plico.run('print', { net: 'bird.fold', output: ['bird.pdf', 'bird.svg'], longest: '15cm' }, net.files);
  assert.deepEqual(Object.keys(pages.files).map((name) => name.replace(/-\d+/, '')).filter((n, i, all) => all.indexOf(n) === i).sort(), ['bird.pdf', 'bird.svg']);
  const pdf = Object.entries(pages.files).find(([name]) => name.endsWith('.pdf'))[1];
  assert.equal(text(pdf.slice(0, 8)), '%PDF-1.5');
});

test('a pattern folds, and tells how far it is', () => {
  const { files } = plico.run('origami make', { name: 'miura', size: '5x4', output: 'miura.fold' });
  const phases = new Set();
  const { exitCode } = plico.run('fold', { net: 'miura.fold', output: 'motion.fold' }, files, (phase) => phases.add(phase));
  assert.equal(exitCode, 0);
  assert.ok(phases.size > 0);
});

test('what cannot be used is told, and the next call works', () => {
  for (const [name, values, files, exitCode] of [
    ['unfold', { mesh: 'empty.obj' }, { 'empty.obj': '' }, 3],
    ['unfold', { mesh: 'none.obj' }, {}, 4],
    ['unfold', { mesh: 'x.obj', colour: 'red' }, { 'x.obj': 'v 0 0 0' }, 2],
    ['unfolt', {}, {}, 2],
  ]) {
    assert.throws(() => plico.run(name, values, files), (error) => {
      assert.ok(error instanceof PlicoError);
      assert.equal(error.exitCode, exitCode);
      assert.match(error.code, /^[a-z]+\/[a-z-]+$/);
      return true;
    });
  }
  assert.equal(plico.run('sample', { name: 'cube', output: 'cube.obj' }).exitCode, 0);
});
