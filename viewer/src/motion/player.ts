import { nearestFrame } from "./frame";

/** The clock of the animation: what time is shown, and how it goes on. Knows nothing of the screen. */
export class Player {
  time: number;
  playing = false;
  loop = true;
  speed: number;

  constructor(private readonly instants: Float64Array) {
    this.time = this.start;
    this.speed = defaultSpeed(this.duration);
  }

  get start(): number {
    return this.instants[0]!;
  }

  get end(): number {
    return this.instants[this.instants.length - 1]!;
  }

  get duration(): number {
    return this.end - this.start;
  }

  /** Is there more than one instant to show? */
  get moves(): boolean {
    return this.duration > 0;
  }

  /** Number of the frame nearest to the time. */
  get frame(): number {
    return nearestFrame(this.instants, this.time);
  }

  play(): void {
    if (!this.moves) return;
    if (this.time >= this.end) this.time = this.start;
    this.playing = true;
  }

  pause(): void {
    this.playing = false;
  }

  toggle(): void {
    if (this.playing) this.pause();
    else this.play();
  }

  seek(time: number): void {
    if (Number.isFinite(time)) this.time = Math.min(this.end, Math.max(this.start, time));
  }

  /** Stops, and goes to a neighbouring frame. */
  step(count: number): void {
    this.pause();
    this.toFrame(this.frame + count);
  }

  toFrame(number: number): void {
    const last = this.instants.length - 1;
    this.time = this.instants[Math.min(last, Math.max(0, Math.round(number)))]!;
  }

  /** Goes on by `seconds` of the wall clock. */
  advance(seconds: number): void {
    if (!this.playing) return;
    const next = this.time + seconds * this.speed;
    if (next < this.end) this.time = next;
    else if (this.loop) this.time = this.start + ((next - this.start) % this.duration);
    else {
      this.time = this.end;
      this.playing = false;
    }
  }
}

const WANTED_SECONDS = 10;

/** Speeds to choose from, times real time: 1, 2, 5 in every power of ten, with `also` among them. */
export function speedSteps(also: number): readonly number[] {
  const steps: number[] = [];
  const lowest = Math.min(-3, Math.floor(Math.log10(also)));
  const highest = Math.max(1, Math.ceil(Math.log10(also) - 1e-9));
  for (let power = lowest; power < highest; power++) {
    for (const digit of [1, 2, 5]) steps.push(Number(`${digit}e${power}`));
  }
  steps.push(Number(`1e${highest}`));
  return steps;
}

/** The speed at which the run lasts about ten seconds. */
export function defaultSpeed(duration: number): number {
  if (!(duration > 0)) return 1;
  const wanted = duration / WANTED_SECONDS;
  const near = speedSteps(wanted);
  return near.reduce((best, speed) => (Math.abs(Math.log(speed / wanted)) < Math.abs(Math.log(best / wanted)) ? speed : best));
}

/** The next speed up or down. */
export function nextSpeed(steps: readonly number[], speed: number, direction: 1 | -1): number {
  const beyond = direction > 0 ? steps.find((s) => s > speed * 1.0001) : [...steps].reverse().find((s) => s < speed * 0.9999);
  return beyond ?? speed;
}
