import { BufferGeometry, Float32BufferAttribute, LineBasicMaterial, LineSegments, type Box3, Vector3 } from "three";
import { roundDown125 } from "../data/format";
import { mix } from "../data/palette";
import type { Theme } from "../planar/theme";

/** Cells from the middle to the rim. */
const CELLS = 14;

/** A grid of round cells under the machine that fades into the background. */
export class Floor {
  readonly lines: LineSegments;
  /** Width of a cell [m]. */
  readonly cell: number;
  private readonly shares: readonly number[];
  private theme: Theme | null = null;

  constructor(box: Box3) {
    const size = box.getSize(new Vector3()).length() || 1;
    const middle = box.getCenter(new Vector3());
    this.cell = roundDown125(size / 6);
    const { positions, shares } = gridPieces(CELLS);
    this.shares = shares;
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new Float32BufferAttribute(positions, 3));
    geometry.setAttribute("color", new Float32BufferAttribute(new Float32Array(positions.length), 3));
    geometry.scale(this.cell, this.cell, 1);
    this.lines = new LineSegments(geometry, new LineBasicMaterial({ vertexColors: true, depthWrite: false }));
    this.lines.renderOrder = -1;
    // Lines of the grid lie at whole cells of the ground axes.
    const whole = (x: number) => Math.round(x / this.cell) * this.cell;
    this.lines.position.set(whole(middle.x), whole(middle.y), floorHeight(box.min.z, box.max.z, size));
    this.lines.updateMatrix();
    this.lines.matrixAutoUpdate = false;
  }

  paint(theme: Theme): void {
    if (theme === this.theme) return;
    this.theme = theme;
    const colors = this.lines.geometry.getAttribute("color");
    const grid = mix(theme.grid, theme.axis, 0.75);
    this.shares.forEach((share, i) => {
      const color = mix(theme.background, grid, share);
      // The renderer works in linear light.
      colors.setXYZ(i, ...([1, 3, 5].map((k) => linear(parseInt(color.slice(k, k + 2), 16) / 255)) as [number, number, number]));
    });
    colors.needsUpdate = true;
  }
}

/** The floor lies at zero where the machine stands just above it, else under the machine. */
export function floorHeight(low: number, high: number, size: number): number {
  const nearZero = low >= 0 && low < 0.5 * size && high > 0;
  // A little lower, so that it does not flicker through surfaces at the same height.
  return (nearZero ? 0 : low) - 1e-3 * size;
}

/** Lines of a grid with cells of size 1, cut at every crossing, and how strong each end is. */
function gridPieces(cells: number): { positions: number[]; shares: number[] } {
  const positions: number[] = [];
  const shares: number[] = [];
  const add = (x: number, y: number) => {
    positions.push(x, y, 0);
    shares.push(Math.max(0, 1 - Math.hypot(x, y) / cells) ** 0.8);
  };
  for (let i = -cells; i <= cells; i++) {
    for (let j = -cells; j < cells; j++) {
      if (Math.hypot(i, j + 0.5) > cells) continue;
      add(i, j);
      add(i, j + 1);
      add(j, i);
      add(j + 1, i);
    }
  }
  return { positions, shares };
}

function linear(value: number): number {
  return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
}
