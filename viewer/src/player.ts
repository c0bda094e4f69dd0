// Time: one slider, play and pause, speed. Everybody who shows something is told.

export class Player {
  time = 0;
  playing = false;
  speed = 1;
  private last = 0;
  private readonly seconds = 6; // from flat to folded at speed 1

  constructor(private readonly changed: () => void) {}

  set(time: number): void {
    this.time = Math.min(1, Math.max(0, time));
    this.changed();
  }
  step(by: number): void {
    this.pause();
    this.set(Math.round((this.time + by) * 1e6) / 1e6);
  }
  toggle(): void {
    if (this.playing) this.pause();
    else this.play();
  }
  pause(): void {
    this.playing = false;
    this.changed();
  }
  play(): void {
    if (this.time >= 1) this.time = 0;
    this.playing = true;
    this.last = performance.now();
    this.changed();
    requestAnimationFrame((now) => this.tick(now));
  }
  faster(factor: number): void {
    this.speed = Math.min(4, Math.max(0.25, this.speed * factor));
    this.changed();
  }

  private tick(now: number): void {
    if (!this.playing) return;
    // A slow frame does not make the sheet jump.
    this.time = Math.min(1, this.time + (Math.min(0.1, Math.max(0, (now - this.last) / 1000)) * this.speed) / this.seconds);
    this.last = now;
    if (this.time >= 1) this.playing = false;
    this.changed();
    if (this.playing) requestAnimationFrame((next) => this.tick(next));
  }
}
