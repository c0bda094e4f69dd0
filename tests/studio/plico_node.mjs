// plico_node.mjs MODULE JOB ARGUMENT...: the WebAssembly module in the place of the program, for tests that compare bytes.
// Reads and writes files of the current folder, and knows just what those tests need of the command line.
import fs from 'node:fs';
import { pathToFileURL } from 'node:url';

const [modulePath, ...words] = process.argv.slice(2);
const { default: createPlico } = await import(pathToFileURL(modulePath).href);
const plico = await createPlico({ wasmBinary: fs.readFileSync(modulePath.replace(/mjs$/, 'wasm')) });

const jobs = JSON.parse(plico.describeJobs());
const twoWords = jobs.find(j => j.name === words.slice(0, 2).join(' '));
const job = twoWords ?? jobs.find(j => j.name === words[0]);
if (!job) throw new Error(`no job ${words[0]}`);
const rest = words.slice(twoWords ? 2 : 1).filter(w => w !== '-q');
const positionals = job.options.filter(o => o.positional);

const values = [];
for (let i = 0; i < rest.length; ++i) {
  if (!rest[i].startsWith('-')) values.push([positionals.shift().name, rest[i]]);
  else if (rest[i] === '-o') values.push(['output', rest[++i]]);
  else {
    const option = job.options.find(o => o.name === rest[i]);
    values.push([rest[i], option.value ? rest[++i] : 'true']);
  }
}

const workspace = new plico.Workspace();
for (const [, value] of values) if (fs.existsSync(value)) workspace.put(value, fs.readFileSync(value));
const inputs = new Set(JSON.parse(workspace.list()));
const result = JSON.parse(workspace.run(job.name, JSON.stringify(values), undefined));
if (result.error) {
  console.error(result.error.message);
  process.exit(result.error.exit_code);
}
for (const path of JSON.parse(workspace.list())) if (!inputs.has(path)) fs.writeFileSync(path, workspace.get(path));
process.exit(result.exit_code);
