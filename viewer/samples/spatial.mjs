// Motions of well-known spatial machines, to look at the page without the engine.

const range = (n, f) => Array.from({ length: n }, (_, i) => f(i));
const times = (end, n) => range(n, (i) => (end * i) / (n - 1));
const origin = [0, 0, 0];
const X = [1, 0, 0];
const Y = [0, 1, 0];
const Z = [0, 0, 1];

const add = (a, b) => a.map((v, i) => v + b[i]);
const sub = (a, b) => a.map((v, i) => v - b[i]);
const times3 = (a, s) => a.map((v) => v * s);
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const norm = (a) => Math.hypot(...a);
const unit = (a) => times3(a, 1 / norm(a));

/** The quaternion of a turn by an angle about an axis. */
const turn = (axis, angle) => [Math.cos(angle / 2), ...times3(unit(axis), Math.sin(angle / 2))];
const multiply = ([a, b, c, d], [e, f, g, h]) => [a * e - b * f - c * g - d * h, a * f + b * e + c * h - d * g, a * g - b * h + c * e + d * f, a * h + b * g - c * f + d * e];
const rotate = (q, v) => {
  const u = q.slice(1);
  const c = times3(cross(u, v), 2);
  return add(v, add(times3(c, q[0]), cross(u, c)));
};
/** The quaternion of axes given as unit vectors. */
function fromAxes(x, y, z) {
  const q = [1 + x[0] + y[1] + z[2], 1 + x[0] - y[1] - z[2], 1 - x[0] + y[1] - z[2], 1 - x[0] - y[1] + z[2]].map((v) => Math.sqrt(Math.max(0, v)) / 2);
  return [q[0], q[1] * Math.sign(y[2] - z[1] || 1), q[2] * Math.sign(z[0] - x[2] || 1), q[3] * Math.sign(x[1] - y[0] || 1)];
}
/** Axes with z along a direction, x as near as may be to `like`. */
function alongZ(direction, like) {
  const z = unit(direction);
  const x = unit(sub(like, times3(z, dot(like, z))));
  return fromAxes(x, cross(z, x), z);
}

const shape = (kind, sizes = {}, position = origin, quaternion = [1, 0, 0, 0], rest = {}) => ({ kind, ...sizes, position, quaternion, color: null, cut: false, ...rest });
const end = (body, at, direction = null, reference = null) => ({ body, at, direction, ...(reference && { reference }) });
const joint = (kind, name, first, second) => ({ name, kind, first, second });

/** A body from its poses { p, q }. */
function body(name, poses, shapes = [], color = null) {
  return { name, color, position: poses.flatMap(({ p }) => p), quaternion: poses.flatMap(({ q }) => q), shapes };
}

const channel = (name, unit, meaning, values) => ({ name, unit, meaning, values });
const vectorChannels = (name, unit, meaning, vectors) => range(3, (k) => channel(`${name}_${"xyz"[k]}`, unit, `${meaning}, ${"xyz"[k]}`, vectors.map((v) => v[k])));

function page(title, time, bodies, rest) {
  const places = bodies.slice(0, 6).flatMap((b) => range(3, (k) => channel(`${b.name}.${"xyz"[k]}`, "m", `${"xyz"[k]} of the body frame`, time.map((_, i) => b.position[3 * i + k]))));
  return {
    format: "dalembert-animation/1", title, space: "spatial", analysis: "kinematics", time, bodies, ground: { shapes: [] },
    joints: [], springs: [], loads: [], traces: [], notes: [], summary: [["Frames", String(time.length)]],
    ...rest,
    channels: [...(rest.channels ?? []), ...places],
  };
}

/** A free box that turns about its middle axis and flips. */
export function tumblingBox() {
  const size = [0.3, 0.2, 0.06];
  const inertia = range(3, (k) => (size[(k + 1) % 3] ** 2 + size[(k + 2) % 3] ** 2) / 12);
  const rate = (w) => range(3, (k) => ((inertia[(k + 1) % 3] - inertia[(k + 2) % 3]) * w[(k + 1) % 3] * w[(k + 2) % 3]) / inertia[k]);
  const time = times(8, 481);
  const step = (time[1] - time[0]) / 20;
  let [q, w] = [[1, 0, 0, 0], [0.02, 6, 0.02]];
  const poses = [];
  const spins = [];
  for (const t of time) {
    poses.push({ p: [0, 0, 0.25 + 0.02 * t], q });
    spins.push(rotate(q, w));
    for (let i = 0; i < 20; i++) {
      const half = add(w, times3(rate(w), step / 2));
      w = add(w, times3(rate(half), step));
      q = multiply(q, turn(half, norm(half) * step));
    }
  }
  return page("Tumbling box", time, [body("box", poses, [shape("box", { size }), shape("cylinder", { radius: 0.04, length: 0.12 }, [0.08, 0, 0], undefined, { cut: true })])], {
    analysis: "dynamics",
    traces: [{ name: "corner", body: "box", at: [0.15, 0.1, 0.03] }],
    channels: vectorChannels("box.omega", "rad/s", "angular velocity in ground axes", spins),
  });
}

/** A crank about x drives a slider along x by a rod with a ball and a universal joint. */
export function sliderCrankInSpace() {
  const time = times(2, 241);
  const [radius, length, centre] = [0.08, 0.3, [0, 0.1, 0.12]];
  const poses = { crank: [], rod: [], slider: [] };
  const pulls = [];
  for (const t of time) {
    const angle = Math.PI * t;
    const crank = turn(X, angle);
    const a = add(centre, rotate(crank, [0.03, 0, radius]));
    const b = [a[0] + Math.sqrt(length ** 2 - a[1] ** 2 - a[2] ** 2), 0, 0];
    poses.crank.push({ p: centre, q: crank });
    poses.rod.push({ p: times3(add(a, b), 0.5), q: multiply(alongZ(sub(b, a), Y), turn(Y, -Math.PI / 2)) });
    poses.slider.push({ p: b, q: [1, 0, 0, 0] });
    pulls.push(times3(unit(sub(b, a)), 40 * Math.cos(angle)));
  }
  const lying = turn(Y, Math.PI / 2);
  const bodies = [
    body("crank", poses.crank, [shape("disk", { radius: 0.03, thickness: 0.02 }, origin, lying), shape("plate", { width: 0.1, height: 0.026, thickness: 0.012 }, [0.008, 0, radius / 2], multiply(turn(Y, Math.PI / 2), [1, 0, 0, 0])), shape("rod", { length: 0.03, radius: 0.008 }, [0.016, 0, radius])]),
    body("rod", poses.rod, [shape("rod", { length: length - 0.02, radius: 0.008 })]),
    body("slider", poses.slider, [shape("box", { size: [0.07, 0.05, 0.04] })]),
  ];
  return page("Slider crank in space", time, bodies, {
    ground: { shapes: [shape("box", { size: [0.02, 0.09, 0.16] }, [-0.035, 0.1, 0.1]), shape("box", { size: [0.62, 0.12, 0.01] }, [0.2, 0.02, -0.045])] },
    joints: [
      joint("revolute", "shaft", end("ground", centre, X, Z), end("crank", origin, X, Z)),
      joint("spherical", "ball", end("crank", [0.03, 0, radius]), end("rod", [-length / 2, 0, 0])),
      joint("universal", "cross", end("rod", [length / 2, 0, 0], Y), end("slider", origin, Z)),
      joint("prismatic", "guide", end("ground", [0.25, 0, 0], X), end("slider", origin, X)),
    ],
    loads: [{ name: "motor", on: { body: "crank", at: origin }, along: { body: "crank", direction: X } }, { name: "weight", on: { body: "rod", at: origin } }],
    traces: [{ name: "pin", body: "crank", at: [0.03, 0, radius] }, { name: "middle of the rod", body: "rod", at: origin }],
    channels: [
      ...vectorChannels("ball.force", "N", "force on the rod", pulls),
      ...vectorChannels("cross.force", "N", "force on the slider", pulls),
      ...vectorChannels("guide.force", "N", "force on the slider", pulls.map(([, y, z]) => [0, -y, -z])),
      ...vectorChannels("guide.moment", "N m", "moment on the slider", pulls.map(([, y, z]) => [0, 0.1 * z, -0.1 * y])),
      ...vectorChannels("weight.force", "N", "weight of the rod", pulls.map(() => [0, 0, -15])),
      channel("motor.moment", "N m", "moment of the motor", time.map((t) => 3 * Math.sin(Math.PI * t))),
    ],
  });
}

/** A platform on six legs. */
export function platform() {
  const time = times(6, 361);
  const ring = (radius, spread, height) => range(6, (i) => {
    const angle = (Math.PI / 3) * (2 * Math.floor(i / 2)) + (i % 2 === 0 ? -spread : spread);
    return [radius * Math.cos(angle), radius * Math.sin(angle), height];
  });
  const feet = ring(0.5, 0.25, 0.05);
  const heads = ring(0.3, 0.8, -0.04);
  const plate = time.map((t) => ({
    p: [0.08 * Math.sin(2 * t), 0.08 * Math.cos(2 * t) - 0.04, 0.62 + 0.06 * Math.sin(3 * t)],
    q: multiply(turn(Z, 0.25 * Math.sin(t)), multiply(turn(X, 0.22 * Math.sin(2 * t)), turn(Y, 0.22 * Math.cos(2 * t)))),
  }));
  const bodies = [body("platform", plate, [shape("disk", { radius: 0.36, thickness: 0.035 }), shape("cylinder", { radius: 0.05, length: 0.1 }, [0, 0, 0.065])])];
  const joints = [];
  feet.forEach((foot, i) => {
    const tops = plate.map(({ p, q }) => add(p, rotate(q, heads[i])));
    const along = tops.map((top) => alongZ(sub(top, foot), Math.abs(foot[0]) > 0.1 ? Y : X));
    const name = `leg ${i + 1}`;
    bodies.push(body(`${name} lower`, along.map((q) => ({ p: foot, q })), [shape("tube", { outer: 0.028, inner: 0.02, length: 0.36 }, [0, 0, 0.22])], "#66ccee"));
    bodies.push(body(`${name} upper`, along.map((q, k) => ({ p: tops[k], q })), [shape("cylinder", { radius: 0.016, length: 0.36 }, [0, 0, -0.2])], "#ccbb44"));
    joints.push(joint("universal", `foot ${i + 1}`, end("ground", foot, X), end(`${name} lower`, origin, Y)));
    joints.push(joint("cylindrical", `actuator ${i + 1}`, end(`${name} lower`, [0, 0, 0.4], Z), end(`${name} upper`, [0, 0, -0.36], Z)));
    joints.push(joint("spherical", `head ${i + 1}`, end(`${name} upper`, origin), end("platform", heads[i])));
  });
  return page("Platform on six legs", time, bodies, {
    ground: { shapes: [shape("disk", { radius: 0.6, thickness: 0.03 }, [0, 0, -0.015])] },
    joints,
    traces: [{ name: "tip", body: "platform", at: [0, 0, 0.12] }],
  });
}

/** A toothed wheel given as a mesh, a curved mesh, a surface and a curve. */
export function meshes() {
  const time = times(4, 121);
  const spin = (at, axis, speed) => time.map((t) => ({ p: at, q: turn(axis, speed * t) }));
  const teeth = 14;
  const rim = range(4 * teeth, (i) => {
    const angle = (2 * Math.PI * (i + ((i % 4) % 3 === 0 ? 0.2 : 0))) / (4 * teeth);
    const r = i % 4 === 1 || i % 4 === 2 ? 0.2 : 0.16;
    return [r * Math.cos(angle), r * Math.sin(angle)];
  });
  const n = rim.length;
  const wheel = { vertices: [[0, 0, -0.03], [0, 0, 0.03], ...rim.flatMap(([x, y]) => [[x, y, -0.03], [x, y, 0.03]])].flat(), triangles: rim.flatMap((_, i) => {
    const [a, b, c, d] = [2 + 2 * i, 3 + 2 * i, 2 + 2 * ((i + 1) % n), 3 + 2 * ((i + 1) % n)];
    return [a, c, b, b, c, d, 0, c, a, 1, b, d];
  }) };
  // A pebble: a ball of rings with soft bumps.
  const [rings, sides] = [24, 36];
  const at = (u, v) => {
    const r = 0.14 + 0.015 * Math.sin(3 * v) * Math.sin(u) + 0.02 * Math.cos(2 * u);
    return [1.3 * r * Math.sin(u) * Math.cos(v), r * Math.sin(u) * Math.sin(v), 0.8 * r * Math.cos(u)];
  };
  const pebble = {
    vertices: range(rings + 1, (i) => range(sides, (j) => at((Math.PI * i) / rings, (2 * Math.PI * j) / sides))).flat(2),
    triangles: range(rings, (i) => range(sides, (j) => {
      const [a, b, c, d] = [i * sides + j, i * sides + ((j + 1) % sides), (i + 1) * sides + j, (i + 1) * sides + ((j + 1) % sides)];
      return [...(i > 0 ? [a, c, b] : []), ...(i + 1 < rings ? [b, c, d] : [])];
    })).flat(2),
  };
  const [nu, nv] = [31, 31];
  const bowl = { nu, nv, points: range(nu, (i) => range(nv, (j) => [(i / 15 - 1) * 0.3, (j / 15 - 1) * 0.3, 0.06 * Math.cos(i / 5) * Math.sin(j / 5)])).flat(2) };
  const helix = { points: range(121, (i) => [0.12 * Math.cos(i / 6), 0.12 * Math.sin(i / 6), 0.3 * (i / 120)]).flat() };
  const bodies = [
    body("wheel", spin([0, 0, 0.3], [1, 0.4, 0.2], 1), [shape("mesh", wheel), shape("cylinder", { radius: 0.03, length: 0.14 }, origin, undefined, { color: "#777777" })]),
    body("pebble", spin([0.55, 0, 0.3], [0.3, 1, 0.2], 0.8), [shape("mesh", pebble)]),
    body("surface", spin([0, 0.65, 0.2], Z, 0.3), [shape("surface", bowl)]),
    body("curve", spin([0.55, 0.6, 0.15], Z, 1), [shape("curve", helix), shape("rod", { length: 0.2, radius: 0.01 }, [0, 0, -0.01])]),
  ];
  return page("Meshes, a surface and a curve", time, bodies, {});
}

/** Every form, each turning. */
export function forms() {
  const time = times(8, 241);
  const list = [
    ["box", shape("box", { size: [0.2, 0.14, 0.1] })],
    ["cylinder", shape("cylinder", { radius: 0.08, length: 0.2 })],
    ["tube", shape("tube", { outer: 0.09, inner: 0.065, length: 0.16 })],
    ["sphere", shape("sphere", { radius: 0.1 })],
    ["hemisphere", shape("hemisphere", { radius: 0.1 })],
    ["cone", shape("cone", { radius: 0.09, height: 0.18 })],
    ["rod", shape("rod", { length: 0.26, radius: 0.012 })],
    ["disk", shape("disk", { radius: 0.11, thickness: 0.015 })],
    ["plate", shape("plate", { width: 0.24, height: 0.16, thickness: 0.012 })],
    ["ellipsoid", shape("ellipsoid", { semi_axes: [0.12, 0.08, 0.05] })],
    ["torus", shape("torus", { radius: 0.085, tube: 0.028 })],
    ["revolved", shape("revolved", { profile: [[0, -0.1], [0.06, -0.1], [0.02, -0.06], [0.02, 0], ...range(9, (i) => [0.02 + 0.08 * Math.sin((i * Math.PI) / 20), 0.01 * i + 0.01])] })],
    ["bar", shape("bar", { length: 0.2, width: 0.06 })],
    ["rectangle", shape("rectangle", { width: 0.2, height: 0.14 })],
    ["ring", shape("ring", { outer: 0.1, inner: 0.06 })],
    ["polygon", shape("polygon", { points: [[-0.1, -0.08], [0.1, -0.08], [0.1, 0], [0, 0], [0, 0.1], [-0.1, 0.1]] })],
    ["circle with holes", shape("circle", { radius: 0.1 })],
    ["lump", shape("lump")],
    ["box with a bore", shape("box", { size: [0.2, 0.14, 0.1] })],
    ["no form", null],
  ];
  const extra = {
    "circle with holes": [shape("circle", { radius: 0.025 }, [0.05, 0, 0], undefined, { cut: true }), shape("circle", { radius: 0.025 }, [-0.05, 0, 0], undefined, { cut: true })],
    "box with a bore": [shape("cylinder", { radius: 0.035, length: 0.14 }, [0.03, 0, 0], undefined, { cut: true })],
  };
  const bodies = list.map(([name, form], i) => {
    const p = [0.36 * (i % 5), 0.36 * Math.floor(i / 5), 0.18];
    return body(name, time.map((t) => ({ p, q: turn([0.3 * Math.cos(i), 0.5, 1], (0.25 * Math.PI * t) + 0.2 * i) })), form ? [form, ...(extra[name] ?? [])] : []);
  });
  return page("All forms", time, bodies, {});
}

/** Every joint between a fixed and a moving part. */
export function joints() {
  const time = times(6, 361);
  const wave = (t) => Math.sin((Math.PI * t) / 1.5);
  const kinds = [
    ["revolute", (t) => ({ q: turn(Z, 0.8 * wave(t)) })],
    ["spherical", (t) => ({ q: multiply(turn(X, 0.5 * wave(t)), turn(Y, 0.5 * Math.cos((Math.PI * t) / 1.5))) })],
    ["universal", (t) => ({ q: multiply(turn(X, 0.5 * wave(t)), turn(Y, 0.5 * wave(t / 2))) })],
    ["constant-velocity", (t) => ({ q: turn(X, 0.5 * wave(t)) })],
    ["cylindrical", (t) => ({ p: [0, 0, 0.08 * wave(t)], q: turn(Z, 2 * wave(t)) })],
    ["prismatic", (t) => ({ p: [0, 0, 0.08 * wave(t)] })],
    ["screw", (t) => ({ p: [0, 0, 0.08 * wave(t)], q: turn(Z, 8 * wave(t)) })],
    ["weld", () => ({})],
    ["planar", (t) => ({ p: [0.06 * wave(t), 0.04 * Math.cos((Math.PI * t) / 1.5), 0], q: turn(Z, wave(t)) })],
    ["distance", (t) => ({ p: [0.02 * wave(t), 0.1, 0.06 * wave(t)] })],
    ["point-on-plane", (t) => ({ p: [0.06 * wave(t), 0.05 * wave(t / 2), 0], q: turn(X, 0.3 * wave(t)) })],
    ["point-on-line", (t) => ({ p: [0, 0, 0.08 * wave(t)], q: turn(X, 0.3 * wave(t)) })],
    ["surface-contact", (t) => ({ p: [0.02 * wave(t), 0, 0] })],
  ];
  const bodies = [];
  const fixed = [];
  const list = kinds.map(([kind, motion], i) => {
    const at = [0.5 * (i % 5), 0.5 * Math.floor(i / 5), 0.25];
    bodies.push(body(`${kind} arm`, time.map((t) => {
      const { p = origin, q = [1, 0, 0, 0] } = motion(t);
      return { p: add(at, p), q };
    }), [shape("rod", { length: 0.14, radius: 0.014 }, [0.1, 0, 0])]));
    fixed.push(shape("rod", { length: 0.14, radius: 0.014 }, add(at, [-0.1, 0, 0])));
    const second = kind === "universal" ? Y : kind === "point-on-plane" || kind === "point-on-line" ? null : Z;
    return joint(kind, kind, end("ground", at, kind === "universal" ? X : Z, X), end(`${kind} arm`, origin, second, X));
  });
  return page("All joints", time, bodies, { ground: { shapes: fixed }, joints: list });
}

/** A pendulum on a ball joint with a spring, y upwards. */
export function ballPendulum() {
  const time = times(6, 361);
  const poses = time.map((t) => {
    const q = multiply(turn(Y, 0.9 * t), turn(X, 0.5 + 0.15 * Math.cos(4 * t)));
    return { p: rotate(q, [0, -0.5, 0]), q };
  });
  const upright = turn(X, Math.PI / 2);
  const plate = body("plate", poses, [shape("ring", { outer: 0.15, inner: 0.06 }, origin, upright), shape("rod", { length: 0.5, radius: 0.012 }, [0, 0.25, 0], turn(Z, Math.PI / 2))]);
  return page("Pendulum on a ball joint", time, [plate], {
    up: Y,
    joints: [joint("spherical", "pivot", end("ground", origin), end("plate", [0, 0.5, 0]))],
    springs: [{ name: "spring", kind: "spring-damper", first: { body: "ground", at: [0.5, -0.2, 0] }, second: { body: "plate", at: [0.15, 0, 0] } }],
    loads: [{ name: "weight", on: { body: "plate", at: origin } }],
    traces: [{ name: "centre", body: "plate", at: origin }],
    channels: [...vectorChannels("weight.force", "N", "weight", time.map(() => [0, -20, 0])), channel("spring.force", "N", "tension", time.map((t) => 12 + 6 * Math.cos(t)))],
  });
}

/** Links without shapes in a closed loop. */
export function bareLoop() {
  const time = times(4, 241);
  const poses = { crank: [], coupler: [], rocker: [] };
  const [a, b, c, ground] = [0.1, 0.35, 0.22, [0.3, 0.15, 0]];
  for (const t of time) {
    const angle = (Math.PI / 2) * t;
    const p = [a * Math.cos(angle), a * Math.sin(angle), 0.05];
    // The rocker turns about x: its end is where the coupler's length says.
    const gap = (r) => norm(sub(add(ground, [0, c * Math.sin(r), c * Math.cos(r)]), p)) - b;
    let [low, high] = [-0.9, 0.9];
    for (let i = 0; i < 60; i++) {
      const mid = (low + high) / 2;
      if (gap(low) * gap(mid) <= 0) high = mid;
      else low = mid;
    }
    const tip = add(ground, [0, c * Math.sin(low), c * Math.cos(low)]);
    poses.crank.push({ p: [0, 0, 0.05], q: turn(Z, angle) });
    poses.coupler.push({ p, q: alongZ(sub(tip, p), Y) });
    poses.rocker.push({ p: ground, q: turn(X, -low) });
  }
  return page("Four links without shapes", time, Object.keys(poses).map((name) => body(name, poses[name])), {
    joints: [
      joint("revolute", "O", end("ground", [0, 0, 0.05], Z), end("crank", origin, Z)),
      joint("spherical", "A", end("crank", [a, 0, 0]), end("coupler", origin)),
      joint("spherical", "B", end("coupler", [0, 0, b]), end("rocker", [0, 0, c])),
      joint("revolute", "C", end("ground", ground, X), end("rocker", origin, X)),
    ],
    traces: [{ name: "coupler", body: "coupler", at: [0, 0, b / 2] }],
    notes: ["The bodies of this sample have no shapes: rods between their joints stand for them."],
  });
}

/** Two hundred bodies, to see how fast the page is. */
export function crowd(count = 200) {
  const time = times(6, 121);
  const kinds = [["box", { size: [0.06, 0.05, 0.04] }], ["cylinder", { radius: 0.025, length: 0.07 }], ["torus", { radius: 0.03, tube: 0.01 }], ["sphere", { radius: 0.03 }]];
  const bodies = range(count, (i) => {
    const [ring, place] = [Math.floor(i / 20), (2 * Math.PI * i) / 20];
    const poses = time.map((t) => ({ p: [(0.3 + 0.02 * ring) * Math.cos(place + 0.4 * t), (0.3 + 0.02 * ring) * Math.sin(place + 0.4 * t), 0.1 * ring + 0.03 * Math.sin(2 * t + i)], q: turn([1, Math.sin(i), Math.cos(i)], t + i) }));
    return body(`body ${i + 1}`, poses, [shape(...kinds[i % 4])]);
  });
  const hinges = range(count, (i) => joint("revolute", `joint ${i + 1}`, end("ground", origin, Z), end(`body ${i + 1}`, [0.03, 0, 0], Z)));
  return page(`${count} bodies`, time, bodies, { joints: hinges.slice(0, count) });
}
