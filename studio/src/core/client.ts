// The page's end of the worker: calls in order, progress, and a stop that works at any time.
import type { Begin, Calls, Failure, Packed, Progress, Reply, Unpacked } from './protocol';

export class Refused extends Error {
  constructor(readonly failure: Failure) {
    super(failure.message);
  }
}
export class Stopped extends Error {}

interface Waiting {
  resolve: (value: any) => void;
  reject: (error: Error) => void;
  progress?: (progress: Progress) => void;
}

const workerOf = (script: string): Worker => new Worker(URL.createObjectURL(new Blob([script], { type: 'text/javascript' })));

export class Core {
  private worker!: Worker;
  private waiting = new Map<number, Waiting>();
  private lastId = 0;
  private unpacked?: Unpacked;
  private broken?: Failure; // why the worker did not start
  onRestart = (): void => undefined;

  constructor(private readonly loader: string, private readonly packed: Packed) {
    this.start();
  }

  call<Name extends keyof Calls>(
    name: Name, args: Parameters<Calls[Name]>, progress?: (progress: Progress) => void,
  ): Promise<ReturnType<Calls[Name]>> {
    if (this.broken) return Promise.reject(new Refused(this.broken));
    const id = ++this.lastId;
    return new Promise((resolve, reject) => {
      this.waiting.set(id, { resolve, reject, progress });
      this.worker.postMessage({ id, call: name, args });
    });
  }

  /** Ends whatever runs: calls without an answer are Stopped, and the next worker knows no model. */
  restart(): void {
    this.replace(new Stopped());
  }
  private replace(reason: Error): void {
    this.worker.terminate();
    const left = [...this.waiting.values()];
    this.waiting.clear();
    this.start();
    this.onRestart();
    for (const { reject } of left) reject(reason);
  }

  private start(): void {
    this.broken = undefined;
    this.worker = workerOf(this.unpacked?.script ?? this.loader);
    this.worker.onmessage = (event: MessageEvent<Reply | Unpacked>) => {
      if ('module' in event.data) this.warm(event.data);
      else this.hear(event.data);
    };
    this.worker.onerror = (event) => this.fail(event.message);
    this.worker.postMessage(this.unpacked ? { begin: this.unpacked.module } satisfies Begin : this.packed);
  }
  /** The engine's code is the module's, whichever worker makes it compile that: one that nobody waits for. */
  private warm(unpacked: Unpacked): void {
    this.unpacked = unpacked;
    workerOf(unpacked.script).postMessage({ warm: unpacked.module } satisfies Begin);
  }

  private hear(reply: Reply): void {
    const caller = this.waiting.get(reply.id);
    if (!caller) return;
    if ('progress' in reply) return caller.progress?.(reply.progress);
    if ('failure' in reply && reply.ended) return this.replace(new Refused(reply.failure));
    this.waiting.delete(reply.id);
    if ('failure' in reply) caller.reject(new Refused(reply.failure));
    else caller.resolve(reply.result);
  }

  private fail(message: string): void {
    this.broken = { code: 'internal', message: `the core stopped: ${message}`, where: '', suggestion: 'reload the page' };
    for (const { reject } of this.waiting.values()) reject(new Refused(this.broken));
    this.waiting.clear();
  }
}
