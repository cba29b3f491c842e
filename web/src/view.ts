// Where the world is on the screen.
export interface Box {
  minX: number;
  minY: number;
  maxX: number;
  maxY: number;
}

export class View {
  /** pixels by unit */
  scale = 20;
  /** where (0, 0) is on the screen */
  x = 0;
  y = 0;
  width = 800;
  height = 600;

  toScreen(x: number, y: number): [number, number] {
    return [this.x + x * this.scale, this.y - y * this.scale];
  }
  toWorld(x: number, y: number): [number, number] {
    return [(x - this.x) / this.scale, (this.y - y) / this.scale];
  }
  /** Shows a box with a margin of so many pixels. */
  fit(box: Box | null, margin = 48): void {
    if (box === null) return;
    const width = Math.max(box.maxX - box.minX, 1e-9);
    const height = Math.max(box.maxY - box.minY, 1e-9);
    const free = Math.min(margin, this.width / 8, this.height / 8);
    this.scale = Math.min((this.width - 2 * free) / width, (this.height - 2 * free) / height);
    this.x = this.width / 2 - (this.scale * (box.minX + box.maxX)) / 2;
    this.y = this.height / 2 + (this.scale * (box.minY + box.maxY)) / 2;
  }
  zoom(factor: number, x: number, y: number): void {
    const scale = Math.min(1e9, Math.max(1e-9, this.scale * factor));
    this.x = x + ((this.x - x) * scale) / this.scale;
    this.y = y + ((this.y - y) * scale) / this.scale;
    this.scale = scale;
  }
  /** The distance of grid lines: a power of ten, or two or five times one. */
  get step(): number {
    const least = 22 / this.scale;
    const power = 10 ** Math.floor(Math.log10(least));
    for (const times of [1, 2, 5]) if (power * times >= least) return times * power;
    return 10 * power;
  }
}

/** The box of x and y in turn. */
export function boxOf(lists: ArrayLike<number>[]): Box | null {
  const box = { minX: Infinity, minY: Infinity, maxX: -Infinity, maxY: -Infinity };
  for (const list of lists) {
    for (let i = 0; i + 1 < list.length; i += 2) {
      box.minX = Math.min(box.minX, list[i]!);
      box.maxX = Math.max(box.maxX, list[i]!);
      box.minY = Math.min(box.minY, list[i + 1]!);
      box.maxY = Math.max(box.maxY, list[i + 1]!);
    }
  }
  return box.minX <= box.maxX ? box : null;
}
