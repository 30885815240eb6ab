import { DoubleSide, GreaterDepth, LineBasicMaterial, MeshBasicMaterial, MeshStandardMaterial, type Material } from "three";
import { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";
import { mix } from "../data/palette";
import { LIGHT, type Theme } from "../planar/theme";

type Painted = Material & { color: { set(color: string): unknown } };

/** A colour that may depend on the theme. */
export type Paint = string | ((theme: Theme) => string);

/** Materials by colour, each made once; a change of theme repaints them all. */
export class Materials {
  private theme: Theme = LIGHT;
  private readonly made = new Map<string, Painted>();
  private readonly paints: { material: Painted; paint: (theme: Theme) => string }[] = [];

  setTheme(theme: Theme): void {
    if (theme === this.theme) return;
    this.theme = theme;
    for (const { material, paint } of this.paints) material.color.set(paint(theme));
  }

  /** The matt surface of a body. */
  solid(color: string): Material {
    return this.get(`solid ${color}`, surfaceOf(color), () => new MeshStandardMaterial({ roughness: 0.62, metalness: 0, side: DoubleSide, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 }));
  }

  /** The surface of the body under the pointer. */
  lit(color: string): Material {
    return this.get(`lit ${color}`, (theme) => mix(surfaceOf(color)(theme), theme === LIGHT ? "#ffffff" : "#fff6d8", 0.42), () => new MeshStandardMaterial({ roughness: 0.62, metalness: 0, side: DoubleSide, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 }));
  }

  /** A surface that one can look through. */
  glass(color: string, opacity: number): Material {
    return this.get(`glass ${opacity} ${color}`, surfaceOf(color), () => new MeshStandardMaterial({ roughness: 0.62, metalness: 0, side: DoubleSide, transparent: true, opacity, depthWrite: false }));
  }

  /** Edges of a body. */
  edge(color: string): Material {
    return this.get(`edge ${color}`, (theme) => mix(color, theme === LIGHT ? "#000000" : "#ffffff", theme === LIGHT ? 0.5 : 0.35), () => new LineBasicMaterial());
  }

  /** Edges of what is cut out: seen through the body. */
  hiddenEdge(color: string): Material {
    return this.get(`hidden edge ${color}`, (theme) => mix(color, theme === LIGHT ? "#000000" : "#ffffff", 0.45), () => new LineBasicMaterial({ transparent: true, opacity: 0.7, depthTest: false }));
  }

  /** A line some pixels wide. */
  line(paint: Paint, width: number): LineMaterial {
    const key = typeof paint === "string" ? paint : paint(LIGHT);
    return this.get(`line ${width} ${key}`, paint, () => new LineMaterial({ linewidth: width })) as LineMaterial;
  }

  /** A wide line that nothing hides, dashed where dashes have a length. */
  overlay(paint: Paint, width: number, dash = 0): LineMaterial {
    const key = typeof paint === "string" ? paint : paint(LIGHT);
    return this.get(
      `overlay ${width} ${dash} ${key}`,
      paint,
      () => new LineMaterial({ linewidth: width, depthTest: false, transparent: true, opacity: 0.9, dashed: dash > 0, dashSize: dash > 0 ? dash : 1, gapSize: dash > 0 ? 0.6 * dash : 1 }),
    ) as LineMaterial;
  }

  /** An even colour, and the same where something hides it: pale. */
  arrow(paint: (theme: Theme) => string): readonly [Material, Material] {
    const key = paint(LIGHT);
    const plain = this.get(`arrow ${key}`, paint, () => new MeshStandardMaterial({ roughness: 0.8, metalness: 0 }));
    const ghost = this.get(`ghost ${key}`, paint, () => new MeshBasicMaterial({ transparent: true, opacity: 0.55, depthFunc: GreaterDepth, depthWrite: false }));
    return [plain, ghost];
  }

  private get(key: string, paint: Paint, make: () => Painted | LineMaterial): Painted {
    const known = this.made.get(key);
    if (known) return known;
    const material = make() as unknown as Painted;
    const of = typeof paint === "string" ? () => paint : paint;
    material.color.set(of(this.theme));
    this.made.set(key, material);
    this.paints.push({ material, paint: of });
    return material;
  }
}

/** Colours of the palette are made for lines: surfaces are a little lighter on light paper. */
function surfaceOf(color: string): (theme: Theme) => string {
  return (theme) => (theme === LIGHT ? mix(color, "#ffffff", 0.28) : mix(color, "#ffffff", 0.06));
}
