// Compiled, not run: the types of the npm package fit its README.
import { createPlico, PlicoError, type JobResult } from 'plico';

export async function use(bytes: Uint8Array): Promise<JobResult> {
  const plico = await createPlico({ wasm: bytes });
  const names: string[] = plico.jobs.map((job) => job.name);
  try {
    const { files } = plico.run(names[0] ?? 'unfold', { mesh: 'a.obj', faces: 300, repair: 'safe', keep: [1, 2] }, { 'a.obj': bytes });
    return plico.run('print', { net: 'a.fold', split: true }, files, (phase, done) => phase.length + done);
  } catch (error) {
    if (error instanceof PlicoError) throw new Error(`${error.code}: ${error.suggestion}`);
    throw error;
  }
}
// @ts-expect-error: a file is bytes or text
export const wrong = async () => (await createPlico()).run('unfold', {}, { 'a.obj': 3 });
