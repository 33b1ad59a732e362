// The engine in its worker. The last request counts: a run that a later request supersedes is stopped.

/** Milliseconds. A run that has lasted longer is stopped by ending its worker; a shorter one ends by itself sooner. */
const PATIENCE = 150;

/** Milliseconds after which a run is taken for endless. The engine ends runs after 10 seconds, but not the loading of rules. */
const ENDLESS = 15_000;

export class Engine {
  constructor() {
    this.files = new Map();
    this.number = 0;
    /** The run in the worker: `{ request, begin, resolve }`, and the request that waits for its end. */
    this.running = null;
    this.waiting = null;
    /** The last request with a model, and the one whose model the worker has. */
    this.shown = null;
    this.held = null;
  }

  /** Loads the module and returns the list of grammars. */
  async load() {
    const answer = await fetch(new URL('engine_bg.wasm', document.baseURI));
    if (!answer.ok) throw new Error(`the engine is missing (${answer.status})`);
    this.module = await WebAssembly.compileStreaming(answer);
    this.worker = this.newWorker();
    return this.ask(this.worker, 'catalog');
  }

  /** Makes a second worker, so that a run can be stopped without waiting for another one. */
  prepare() {
    this.spare ??= this.newWorker();
  }

  newWorker() {
    const worker = new Worker(new URL('worker.js', document.baseURI), { type: 'module' });
    worker.open = new Map();
    worker.onmessage = ({ data: { id, value, error, stopped } }) => {
      const { resolve, reject } = worker.open.get(id);
      worker.open.delete(id);
      if (error === undefined && stopped === undefined) return resolve(value);
      reject(Object.assign(new Error(error ?? stopped), { isStopped: stopped !== undefined }));
    };
    worker.onerror = (event) => this.end(worker, new Error(event.message || 'the worker could not be loaded'));
    this.ask(worker, 'start', this.module, [...this.files]).catch(() => {});
    return worker;
  }

  ask(worker, call, ...args) {
    return new Promise((resolve, reject) => {
      const id = this.number++;
      worker.open.set(id, { resolve, reject });
      worker.postMessage({ id, call, args });
    });
  }

  /** Ends a worker. Its open questions fail. */
  end(worker, error) {
    worker.terminate();
    for (const { reject } of worker.open.values()) reject(error);
    worker.open.clear();
  }

  /** Goes on with another worker. */
  replace(error) {
    this.end(this.worker, error);
    this.worker = this.spare ?? this.newWorker();
    this.spare = null;
    this.held = null;
    setTimeout(() => this.prepare(), 500);
  }

  /** Runs a request. Returns the answer of the worker, or null if a later request has superseded it. */
  run(request) {
    this.waiting?.resolve(null);
    return new Promise((resolve, reject) => {
      this.waiting = { request, resolve, reject };
      if (!this.running) return this.next();
      const left = PATIENCE - (performance.now() - this.running.begin);
      clearTimeout(this.stopper);
      this.stopper = setTimeout(() => this.running && this.waiting && this.stop(), Math.max(left, 0));
    });
  }

  /** Stops the run in the worker. */
  stop() {
    const { running } = this;
    this.running = null;
    running.resolve(null);
    this.replace(new Error('superseded'));
    this.next();
  }

  async next() {
    const job = this.waiting;
    this.waiting = null;
    if (!job) return;
    this.running = { ...job, begin: performance.now() };
    const { running, worker } = this;
    const endless = setTimeout(() => this.replace(new Error('the rules take too long to load')), ENDLESS);
    try {
      const answer = await this.ask(worker, 'run', job.request);
      if (this.running !== running) return;
      if (answer.facts) this.shown = this.held = job.request;
      job.resolve(answer);
    } catch (error) {
      if (this.running !== running) return;
      // The module cannot be used after it stopped.
      if (error.isStopped) this.replace(error);
      job.resolve({ findings: [], refused: {}, facts: null, error: error.isStopped ? `the engine stopped at these rules: ${error.message}` : error.message });
    } finally {
      clearTimeout(endless);
    }
    this.running = null;
    this.next();
  }

  /** Asks about the model that is shown. A new worker makes it again first. */
  async query(call, ...args) {
    if (!this.shown) throw new Error('there is no model yet');
    const { worker, shown } = this;
    if (this.held !== shown && !this.running) {
      this.held = shown;
      await this.ask(worker, 'run', shown);
    }
    return this.ask(worker, call, ...args);
  }

  /** Adds a file that rules can name. */
  addFile(name, bytes) {
    this.files.set(name, bytes);
    for (const worker of [this.worker, this.spare].filter(Boolean)) this.ask(worker, 'addFile', name, bytes).catch(() => {});
  }
}
