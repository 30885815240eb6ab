import { ContractError, type Animation, type Attachment, type Body, type Channel, type Joint, type Load, type Shape, type Trace, type Vec3 } from "./contract";
import { Fields, type Json } from "./fields";
import { normalColor, paletteColor } from "./palette";
import { readFlatForm, readSolidForm } from "./read-form";

export const FORMAT = "dalembert-animation/1";

/** Reads the JSON of a page; throws a `ContractError` that names everything that is wrong. */
export function readAnimation(text: string): Animation {
  if (text.trim() === "") throw new ContractError(["There is no animation in this page. The program dalembert puts one in: dalembert view model.toml"]);
  let parsed: unknown;
  try {
    parsed = JSON.parse(text);
  } catch (error) {
    throw new ContractError([`The data of this page is not JSON: ${(error as Error).message}`]);
  }
  const fields = new Fields();
  const root = fields.object(parsed, "The data");
  if (root.format !== FORMAT) {
    throw new ContractError([
      `This page shows "${FORMAT}"; its data says "${String(root.format)}". Write the page anew with the same version of dalembert.`,
    ]);
  }
  const animation = new Reader(fields).animation(root);
  if (fields.problems.length > 0) throw new ContractError(fields.problems);
  return animation;
}

class Reader {
  private readonly skipped: string[] = [];
  private readonly bodies = new Map<string, Body>();
  private spatial = false;

  constructor(private readonly fields: Fields) {}

  animation(root: Json): Animation {
    const f = this.fields;
    const timeList = f.list(root.time, "time");
    if (timeList.length === 0) f.problem("time must have at least one instant.");
    const time = f.numbers(root.time, timeList.length, "time");
    if (time.some((t, i) => !Number.isFinite(t) || (i > 0 && t < time[i - 1]!))) f.problem("time must be finite and must not fall.");
    if (root.space !== "planar" && root.space !== "spatial") f.problem('space must be "planar" or "spatial".');
    this.spatial = root.space === "spatial";

    f.list(root.bodies, "bodies").forEach((entry, i) => this.body(entry, i, time.length));
    const ground = root.ground === undefined || root.ground === null ? {} : f.object(root.ground, "ground");
    return {
      title: f.text(root.title, "title", "Untitled"),
      space: root.space === "spatial" ? "spatial" : "planar",
      up: f.direction(root.up, "up") ?? [0, 0, 1],
      analysis: f.text(root.analysis, "analysis", ""),
      time,
      bodies: [...this.bodies.values()],
      groundShapes: this.shapes(ground.shapes, "ground"),
      joints: this.joints(root.joints, "joints"),
      springs: this.joints(root.springs, "springs"),
      loads: this.loads(root.loads),
      traces: this.traces(root.traces),
      channels: this.channels(root.channels, time.length),
      notes: f.list(root.notes, "notes").map((note, i) => f.text(note, `notes[${i}]`)),
      summary: f.list(root.summary, "summary").map((row, i) => {
        const pair = f.list(row, `summary[${i}]`);
        return [f.text(pair[0], `summary[${i}][0]`), f.text(pair[1], `summary[${i}][1]`)] as const;
      }),
      skipped: this.skipped,
    };
  }

  private body(entry: unknown, index: number, frames: number): void {
    const f = this.fields;
    const raw = f.object(entry, `bodies[${index}]`);
    const name = f.text(raw.name, `bodies[${index}].name`);
    const where = `body "${name}"`;
    if (this.bodies.has(name)) f.problem(`${where} is there twice.`);
    this.bodies.set(name, {
      name,
      color: normalColor(raw.color) ?? paletteColor(index),
      track: {
        position: f.numbers(raw.position, 3 * frames, `${where}: position`),
        quaternion: f.numbers(raw.quaternion, 4 * frames, `${where}: quaternion`),
      },
      shapes: this.shapes(raw.shapes, where),
    });
  }

  private shapes(list: unknown, where: string): readonly Shape[] {
    const out: Shape[] = [];
    this.fields.list(list, `${where}: shapes`).forEach((entry, i) => {
      const place = `${where}: shapes[${i}]`;
      const raw = this.fields.object(entry, place);
      const form = this.form(raw, place);
      if (form === null) {
        this.skipped.push(`This page cannot draw the shape "${String(raw.kind)}" of ${where}.`);
        return;
      }
      out.push({
        form,
        position: this.fields.vec3(raw.position, `${place}.position`, [0, 0, 0]),
        quaternion: this.fields.quaternion(raw.quaternion, `${place}.quaternion`),
        color: normalColor(raw.color),
        cut: raw.cut === true,
      });
    });
    return out;
  }

  private form(raw: Json, where: string): Shape["form"] | null {
    const flat = readFlatForm(this.fields, raw, where);
    // Flat pictures have no place for solids.
    return flat ?? (this.spatial ? readSolidForm(this.fields, raw, where) : null);
  }

  private joints(list: unknown, key: string): readonly Joint[] {
    const out: Joint[] = [];
    this.fields.list(list, key).forEach((entry, i) => {
      const raw = this.fields.object(entry, `${key}[${i}]`);
      const name = this.fields.text(raw.name, `${key}[${i}].name`, "");
      const first = this.attachment(raw.first, `${key}[${i}] "${name}", first`);
      const second = this.attachment(raw.second, `${key}[${i}] "${name}", second`);
      if (first && second) out.push({ name, kind: this.fields.text(raw.kind, `${key}[${i}].kind`), first, second });
    });
    return out;
  }

  private loads(list: unknown): readonly Load[] {
    const out: Load[] = [];
    this.fields.list(list, "loads").forEach((entry, i) => {
      const raw = this.fields.object(entry, `loads[${i}]`);
      const name = this.fields.text(raw.name, `loads[${i}].name`, "");
      const at = this.attachment(raw.on, `loads[${i}] "${name}", on`);
      if (at) out.push({ name, at, along: this.line(raw.along, `loads[${i}] "${name}", along`) });
    });
    return out;
  }

  private line(value: unknown, where: string): Load["along"] {
    if (value === undefined || value === null) return null;
    const raw = this.fields.object(value, where);
    const body = this.reference(raw.body, where);
    const direction = this.fields.direction(raw.direction, `${where}: direction`);
    if (direction === null) this.fields.problem(`${where}: direction must not be zero.`);
    return body !== undefined && direction ? { body, direction } : null;
  }

  private attachment(value: unknown, where: string): Attachment | null {
    const raw = this.fields.object(value, where);
    const body = this.reference(raw.body, where);
    if (body === undefined) return null;
    const direction = this.fields.direction(raw.direction, `${where}: direction`);
    const outline = this.fields.points(raw.outline, `${where}: outline`);
    return {
      body,
      at: this.fields.vec3(raw.at, `${where}: at`, [0, 0, 0]),
      direction,
      reference: across(this.fields.direction(raw.reference, `${where}: reference`), direction),
      outline: outline.length > 2 ? outline : null,
    };
  }

  /** The named body, null for the ground, undefined for a name that nobody has. */
  private reference(value: unknown, where: string): Body | null | undefined {
    const name = this.fields.text(value, `${where}: body`);
    if (name === "ground") return null;
    const body = this.bodies.get(name);
    if (body === undefined) this.fields.problem(`${where}: there is no body "${name}".`);
    return body;
  }

  private traces(list: unknown): readonly Trace[] {
    const out: Trace[] = [];
    this.fields.list(list, "traces").forEach((entry, i) => {
      const raw = this.fields.object(entry, `traces[${i}]`);
      const name = this.fields.text(raw.name, `traces[${i}].name`, "");
      const body = this.reference(raw.body, `trace "${name}"`);
      if (body !== undefined) out.push({ name, body, at: this.fields.vec3(raw.at, `trace "${name}": at`, [0, 0, 0]) });
    });
    return out;
  }

  private channels(list: unknown, frames: number): readonly Channel[] {
    return this.fields.list(list, "channels").map((entry, i) => {
      const raw = this.fields.object(entry, `channels[${i}]`);
      const name = this.fields.text(raw.name, `channels[${i}].name`);
      return {
        name,
        unit: this.fields.text(raw.unit, `channel "${name}": unit`, ""),
        meaning: this.fields.text(raw.meaning, `channel "${name}": meaning`, ""),
        values: this.fields.numbers(raw.values, frames, `channel "${name}": values`),
      };
    });
  }
}

/** The part of a joint's x axis that is across its axis; null where nothing is left of it. */
function across(x: Vec3 | null, axis: Vec3 | null): Vec3 | null {
  if (x === null || axis === null) return x;
  const along = x[0] * axis[0] + x[1] * axis[1] + x[2] * axis[2];
  const rest: Vec3 = [x[0] - along * axis[0], x[1] - along * axis[1], x[2] - along * axis[2]];
  const length = Math.hypot(...rest);
  return length > 1e-9 ? [rest[0] / length, rest[1] / length, rest[2] / length] : null;
}
