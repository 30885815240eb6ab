// Closed-form motions of well-known mechanisms, to look at the page without the engine.

const range = (n, f) => Array.from({ length: n }, (_, i) => f(i));
const times = (end, n) => range(n, (i) => (end * i) / (n - 1));
const side = (body, x, y, angle) => ({ body, at: [x, y, 0], direction: angle === undefined ? null : [Math.cos(angle), Math.sin(angle), 0] });
const joint = (kind, name, first, second) => ({ name, kind, first, second });
const shape = (kind, sizes, x = 0, y = 0, angle = 0) => ({ kind, ...sizes, position: [x, y, 0], quaternion: [Math.cos(angle / 2), 0, 0, Math.sin(angle / 2)], color: null, cut: false });
const bar = (length, width) => shape("bar", { length, width });

/** A body from its poses [x, y, angle]. */
function body(name, poses, shapes = [], color = null) {
  return {
    name,
    color,
    position: poses.flatMap(([x, y]) => [x, y, 0]),
    quaternion: poses.flatMap(([, , a]) => [Math.cos(a / 2), 0, 0, Math.sin(a / 2)]),
    shapes,
  };
}

function channels(time, bodies, poses) {
  return bodies.flatMap((b, k) =>
    [["x", "m", "x of the body frame"], ["y", "m", "y of the body frame"], ["angle", "rad", "angle of the body frame"]].flatMap(([key, unit, meaning], c) => {
      const values = poses[k].map((p) => p[c]);
      const rate = values.map((v, i) => (i === 0 ? (values[1] - v) / (time[1] - time[0]) : (v - values[i - 1]) / (time[i] - time[i - 1])));
      return [
        { name: `${b.name}.${key}`, unit, meaning, values },
        { name: `${b.name}.${key}.rate`, unit: `${unit}/s`, meaning: `rate of ${meaning}`, values: rate },
      ];
    }),
  );
}

function page(title, time, bodies, poses, rest) {
  return {
    format: "dalembert-animation/1", title, space: "planar", analysis: "kinematics", time, bodies, ground: { shapes: [] },
    joints: [], springs: [], traces: [], channels: time.length > 1 ? channels(time, bodies, poses) : [], notes: [],
    summary: [["Degrees of freedom", "0 (1 driven)"], ["Frames", String(time.length)], ["Largest constraint error", "3.1e-16 m"]],
    ...rest,
  };
}

export function sliderCrank() {
  const [a, b] = [0.15, 0.35];
  const time = times(0.4, 201);
  const theta = time.map((t) => Math.PI / 6 + 5 * Math.PI * t);
  const phi = theta.map((q) => -Math.asin((a / b) * Math.sin(q)));
  const poses = [
    theta.map((q) => [(a / 2) * Math.cos(q), (a / 2) * Math.sin(q), q]),
    theta.map((q, i) => [a * Math.cos(q) + (b / 2) * Math.cos(phi[i]), a * Math.sin(q) + (b / 2) * Math.sin(phi[i]), phi[i]]),
    theta.map((q, i) => [a * Math.cos(q) + b * Math.cos(phi[i]), 0, 0]),
  ];
  const bodies = [body("crank", poses[0], [bar(a, 0.022)]), body("rod", poses[1], [bar(b, 0.022)]), body("slider", poses[2], [shape("rectangle", { width: 0.08, height: 0.05 })])];
  return page("Slider crank", time, bodies, poses, {
    joints: [
      joint("revolute", "O", side("ground", 0, 0), side("crank", -a / 2, 0)),
      joint("revolute", "A", side("crank", a / 2, 0), side("rod", -b / 2, 0)),
      joint("revolute", "B", side("rod", b / 2, 0), side("slider", 0, 0)),
      joint("prismatic", "guide", side("ground", 0, 0, 0), side("slider", 0, 0, 0)),
    ],
    traces: [{ name: "middle", body: "rod", at: [0, 0, 0] }],
  });
}

export function fourBar() {
  const [ground, a, b, c] = [0.4, 0.12, 0.38, 0.3];
  const time = times(2, 241);
  const rows = time.map((t) => {
    const q = Math.PI * t;
    const [ax, ay] = [a * Math.cos(q), a * Math.sin(q)];
    const d = Math.hypot(ground - ax, ay);
    const base = Math.atan2(-ay, ground - ax);
    const p = base + Math.acos((b * b + d * d - c * c) / (2 * b * d));
    const r = Math.atan2(ay + b * Math.sin(p), ax + b * Math.cos(p) - ground);
    return { q, ax, ay, p, r };
  });
  const poses = [rows.map(({ q }) => [0, 0, q]), rows.map(({ ax, ay, p }) => [ax, ay, p]), rows.map(({ r }) => [ground, 0, r])];
  const coupler = [b / 2, 0.16];
  const corners = [[0, 0], [b, 0], coupler];
  const beams = corners.map(([x, y], i) => {
    const [u, v] = corners[(i + 1) % 3];
    return shape("bar", { length: Math.hypot(u - x, v - y), width: 0.026 }, (x + u) / 2, (y + v) / 2, Math.atan2(v - y, u - x));
  });
  const bodies = [
    body("crank", poses[0], [shape("bar", { length: a, width: 0.026 }, a / 2)]),
    body("coupler", poses[1], [shape("polygon", { points: [[0, 0], [b, 0], coupler] }), ...beams, { ...shape("circle", { radius: 0.03 }, b / 2, 0.06), cut: true }]),
    body("rocker", poses[2], [shape("bar", { length: c, width: 0.026 }, c / 2)]),
  ];
  return page("Four-bar linkage with a coupler curve", time, bodies, poses, {
    joints: [
      joint("revolute", "O", side("ground", 0, 0), side("crank", 0, 0)),
      joint("revolute", "A", side("crank", a, 0), side("coupler", 0, 0)),
      joint("revolute", "B", side("coupler", b, 0), side("rocker", c, 0)),
      joint("revolute", "C", side("ground", ground, 0), side("rocker", 0, 0)),
    ],
    traces: [{ name: "coupler point", body: "coupler", at: [...coupler, 0] }],
  });
}

export function springMass() {
  const time = times(4, 401);
  const poses = [time.map((t) => [0, -0.35 + 0.12 * Math.exp(-0.4 * t) * Math.cos(8 * t), 0])];
  const bodies = [body("mass", poses[0], [shape("rectangle", { width: 0.14, height: 0.1 })])];
  return page("Mass on a spring", time, bodies, poses, {
    analysis: "dynamics",
    joints: [joint("prismatic", "guide", side("ground", 0, 0, -Math.PI / 2), side("mass", 0, 0, -Math.PI / 2))],
    springs: [{ name: "spring", kind: "spring-damper", first: side("ground", 0, 0), second: side("mass", 0, 0.05) }],
    notes: ["warning: the damper has no effect on the equilibrium.", "The motion starts at rest, 120 mm above the equilibrium."],
  });
}

export function cam() {
  const radius = (phi) => 0.09 + 0.03 * (1 - Math.cos(phi)) * 0.5 + 0.006 * (1 - Math.cos(2 * phi));
  const profile = range(180, (i) => (2 * Math.PI * i) / 180).map((phi) => [radius(phi) * Math.cos(phi), radius(phi) * Math.sin(phi)]);
  const time = times(1, 181);
  const poses = [time.map((t) => [0, 0, 2 * Math.PI * t]), time.map((t) => [0, radius(Math.PI / 2 - 2 * Math.PI * t), 0])];
  const bodies = [body("cam", poses[0], [shape("polygon", { points: profile })]), body("follower", poses[1], [shape("polygon", { points: [[0, 0], [0.012, 0.02], [0.012, 0.16], [-0.012, 0.16], [-0.012, 0.02]] })])];
  return page("Cam with a knife-edge follower", time, bodies, poses, {
    joints: [
      joint("revolute", "shaft", side("ground", 0, 0), side("cam", 0, 0)),
      joint("prismatic", "guide", side("ground", 0, 0.2, Math.PI / 2), side("follower", 0, 0.08, Math.PI / 2)),
      joint("cam", "contact", side("cam", 0, 0, 0), side("follower", 0, 0)),
    ],
    springs: [{ name: "return", kind: "spring-damper", first: side("ground", 0, 0.38), second: side("follower", 0, 0.16) }],
  });
}

export function chain(count = 20, shapes = true) {
  const time = times(6, 361);
  const l = 0.1;
  const poses = range(count, () => []);
  for (const t of time) {
    let [x, y] = [0, 0];
    for (let k = 0; k < count; k++) {
      const angle = -Math.PI / 2 + (0.9 - 0.02 * k) * Math.cos(2.2 * t - 0.22 * k) * Math.exp(-0.05 * t);
      poses[k].push([x + (l / 2) * Math.cos(angle), y + (l / 2) * Math.sin(angle), angle]);
      x += l * Math.cos(angle);
      y += l * Math.sin(angle);
    }
  }
  const bodies = poses.map((p, k) => body(`link ${k + 1}`, p, shapes ? [bar(l, 0.02)] : []));
  return page(`Chain of ${count} links`, time, bodies, poses, {
    analysis: "dynamics",
    joints: range(count, (k) => joint("revolute", `J${k + 1}`, k === 0 ? side("ground", 0, 0) : side(`link ${k}`, l / 2, 0), side(`link ${k + 1}`, -l / 2, 0))),
    traces: [{ name: "tip", body: `link ${count}`, at: [l / 2, 0, 0] }],
  });
}

/** Bodies without shapes; rods, slots and rolling. */
export function bare() {
  const time = times(3, 241);
  const q = time.map((t) => (2 * Math.PI * t) / 3);
  const yoke = q.map((a) => [0.1 * Math.cos(a), 0, 0]);
  const wheel = time.map((t) => [0.35 + 0.12 * Math.sin(2 * t), -0.15, -(0.12 * Math.sin(2 * t)) / 0.05]);
  const poses = [q.map((a) => [0, 0, a]), yoke, wheel];
  const bodies = poses.map((p, k) => body(["crank", "yoke", "wheel"][k], p));
  return page("Scotch yoke and wheel, without shapes", time, bodies, poses, {
    joints: [
      joint("revolute", "O", side("ground", 0, 0), side("crank", 0, 0)),
      joint("pin-slot", "slot", side("yoke", 0, 0, Math.PI / 2), side("crank", 0.1, 0)),
      joint("prismatic", "guide", side("ground", 0, 0, 0), side("yoke", 0.2, 0, 0)),
      joint("rolling-on-line", "contact", side("ground", 0, -0.2, 0), side("wheel", 0, 0)),
    ],
    springs: [{ name: "spring", kind: "spring-damper", first: side("ground", 0.6, -0.15), second: side("wheel", 0, 0) }],
  });
}

/** Joints that the other samples lack: gears, a rack, rods, a weld. */
export function catalogue() {
  const time = times(4, 241);
  const q = time.map((t) => 0.8 * Math.sin((Math.PI * t) / 2));
  const ring = (radius) => range(60, (i) => [radius * Math.cos((i * Math.PI) / 30), radius * Math.sin((i * Math.PI) / 30)]);
  const swing = q.map((a) => 0.35 * a);
  const poses = [
    q.map((a) => [0, 0, a]),
    q.map((a) => [0.18, 0, -a / 2]),
    q.map((a) => [0.06 * a, 0.06, 0]),
    swing.map((a) => [0.4 + 0.2 * Math.sin(a), 0.1 - 0.2 * Math.cos(a), 0]),
    swing.map((a) => [0.4 + 0.2 * Math.sin(a) + 0.06, 0.1 - 0.2 * Math.cos(a) - 0.06, 0]),
  ];
  const names = ["pinion", "wheel", "rack", "platform", "load"];
  const sizes = [[], [], [shape("rectangle", { width: 0.3, height: 0.02 }, 0, 0.01)], [shape("rectangle", { width: 0.16, height: 0.02 })], [shape("rectangle", { width: 0.04, height: 0.1 })]];
  const bodies = poses.map((p, k) => body(names[k], p, sizes[k]));
  return page("Gears, a rack, rods and a weld", time, bodies, poses, {
    joints: [
      joint("revolute", "O", side("ground", 0, 0), side("pinion", 0, 0)),
      joint("revolute", "P", side("ground", 0.18, 0), side("wheel", 0, 0)),
      joint("gear", "mesh", { ...side("pinion", 0, 0), outline: ring(0.06) }, { ...side("wheel", 0, 0), outline: ring(0.12) }),
      joint("rack", "teeth", side("pinion", 0, 0), side("rack", 0, 0, 0)),
      joint("prismatic", "guide", side("ground", 0, 0.07, 0), side("rack", 0, 0.01, 0)),
      joint("distance", "rod 1", side("ground", 0.33, 0.1), side("platform", -0.07, 0)),
      joint("distance", "rod 2", side("ground", 0.47, 0.1), side("platform", 0.07, 0)),
      joint("weld", "bolt", side("platform", 0.06, 0), side("load", 0, 0.06)),
    ],
  });
}

/** One instant: a ladder at rest. */
export function equilibrium() {
  const a = (65 * Math.PI) / 180;
  const poses = [[[0.5 * Math.cos(a) * 2, 0.5 * Math.sin(a) * 2, Math.PI - a]]];
  const bodies = [body("ladder", poses[0], [bar(2, 0.06)])];
  return page("Ladder at rest", [0], bodies, poses, {
    analysis: "statics",
    ground: { shapes: [shape("rectangle", { width: 2.4, height: 0.08 }, 0.8, -0.04), shape("rectangle", { width: 0.08, height: 2.4 }, -0.04, 1.1)] },
    joints: [joint("pin-slot", "wall", side("ground", 0, 0, Math.PI / 2), side("ladder", 1, 0)), joint("revolute", "foot", side("ground", 2 * Math.cos(a), 0), side("ladder", -1, 0))],
    loads: [{ name: "weight", on: side("ladder", 0, 0) }],
    channels: [["foot", -228.7, 981], ["wall", 228.7, 0], ["weight", 0, -981]].flatMap(([name, x, y]) => [
      { name: `${name}.force_x`, unit: "N", meaning: "force on the ladder", values: [x] },
      { name: `${name}.force_y`, unit: "N", meaning: "force on the ladder", values: [y] },
    ]),
    notes: ["The equilibrium is stable."],
  });
}
