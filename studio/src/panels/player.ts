// A slider and a button that play a motion: at most one picture is asked for at a time.

const kSecondsForAll = 4;

export interface Controls {
  slider: HTMLInputElement; // from 0 to 1
  play: HTMLElement;
  now: HTMLElement; // what says how far it is
}

export class Player {
  time = 1;
  speed = 1;
  private playing = false;
  private asking = false;
  private wanted?: number;

  /** `draw` may say that nobody looks any more: then the motion stops. */
  constructor(private readonly controls: Controls, private readonly draw: (time: number) => Promise<boolean>) {
    const { slider, play } = controls;
    slider.addEventListener('input', () => void this.set(Number(slider.value)));
    play.addEventListener('click', () => this.toggle());
    this.showButton();
  }

  toggle(): void {
    this.playing = !this.playing;
    if (this.playing && this.time >= 1) this.time = 0;
    this.showButton();
    let last = performance.now();
    const tick = async (now: number): Promise<void> => {
      if (!this.playing) return;
      const shown = await this.set(this.time + ((now - last) / 1000 / kSecondsForAll) * this.speed);
      last = now;
      if (!shown || this.time >= 1) return this.stop();
      requestAnimationFrame((next) => void tick(next));
    };
    requestAnimationFrame((now) => void tick(now));
  }
  stop(): void {
    this.playing = false;
    this.showButton();
  }
  private showButton(): void {
    this.controls.play.textContent = this.playing ? '⏸' : '▶';
    this.controls.play.setAttribute('aria-label', this.playing ? 'Pause' : 'Play');
  }

  /** Only the last wish counts while a picture is being made. False when nobody looks any more. */
  async set(time: number): Promise<boolean> {
    this.time = Math.max(0, Math.min(1, time));
    const percent = `${Math.round(100 * this.time)} %`, { slider, now } = this.controls;
    slider.value = String(this.time);
    slider.setAttribute('aria-valuetext', `${percent} folded`);
    now.textContent = percent;
    this.wanted = this.time;
    if (this.asking) return true;
    this.asking = true;
    try {
      while (this.wanted !== undefined) {
        const wish = this.wanted;
        this.wanted = undefined;
        if (!(await this.draw(wish))) return false;
      }
      return true;
    } finally {
      this.asking = false;
    }
  }
}
