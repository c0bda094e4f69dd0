// plico_node.mjs PACKAGE JOB ARGUMENT...: the npm package in the place of the program, for tests that compare bytes.
// PACKAGE is its index.js. Reads and writes files of the current folder, and knows just what those tests need of the
// command line.
import fs from 'node:fs';
import { pathToFileURL } from 'node:url';

const [packagePath, ...words] = process.argv.slice(2);
const { createPlico } = await import(pathToFileURL(packagePath).href);
const plico = await createPlico();

const twoWords = plico.jobs.find((j) => j.name === words.slice(0, 2).join(' '));
const job = twoWords ?? plico.jobs.find((j) => j.name === words[0]);
if (!job) throw new Error(`no job ${words[0]}`);
const rest = words.slice(twoWords ? 2 : 1).filter((w) => w !== '-q');
const positionals = job.options.filter((o) => o.positional);

const values = {};
for (let i = 0; i < rest.length; ++i) {
  if (!rest[i].startsWith('-')) values[positionals.shift().name] = rest[i];
  else if (rest[i] === '-o') values.output = rest[++i];
  else values[rest[i]] = job.options.find((o) => o.name === rest[i]).value ? rest[++i] : true;
}

const inputs = Object.values(values).filter((value) => typeof value === 'string' && fs.existsSync(value));
try {
  const { exitCode, files } = plico.run(job.name, values, Object.fromEntries(inputs.map((path) => [path, fs.readFileSync(path)])));
  for (const [path, bytes] of Object.entries(files)) fs.writeFileSync(path, bytes);
  process.exitCode = exitCode;
} catch (error) {
  console.error(error.message);
  process.exitCode = error.exitCode;
}
