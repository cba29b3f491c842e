// Shapes to begin with. All are this page's own.
import { defaults, emptyShape, type Position, type Shape, type State } from "./model.js";

const polygon = (...rings: Position[][]): Shape => ({ ...emptyShape(), polygons: [rings] });
const moved = (ring: Position[], x: number, y: number): Position[] =>
  ring.map(([px, py]) => [round((px as number) + x), round((py as number) + y)]);
const round = (value: number) => Math.round(value * 100) / 100 + 0;

/** A closed curve through all these places, as so many vertices. */
function curve(through: [number, number][], count: number): Position[] {
  const n = through.length;
  return Array.from({ length: count }, (_, i) => {
    const place = (i * n) / count;
    const at = Math.floor(place);
    const t = place - at;
    const [p, q, r, s] = [-1, 0, 1, 2].map((k) => through[(at + k + n) % n]!);
    const along = (axis: 0 | 1) =>
      round(
        0.5 *
          (2 * q![axis] +
            (r![axis] - p![axis]) * t +
            (2 * p![axis] - 5 * q![axis] + 4 * r![axis] - s![axis]) * t * t +
            (3 * q![axis] - p![axis] - 3 * r![axis] + s![axis]) * t * t * t),
      );
    return [along(0), along(1)];
  });
}
/** A bird that flies to the right. */
const kBird: [number, number][] = [
  [9.4, 1.1],
  [8.2, 1.5],
  [7.2, 2.1],
  [6.1, 2.2],
  [5.1, 1.7],
  [4.1, 1.9],
  [3.1, 3.1],
  [2.2, 4.8],
  [0.9, 6.6],
  [-0.9, 8.1],
  [-3.2, 9.2],
  [-2.4, 8.3],
  [-2.9, 8.3],
  [-1.8, 7.1],
  [-2.5, 7.1],
  [-1.3, 5.8],
  [-2.1, 5.7],
  [-1.0, 4.4],
  [-1.9, 4.2],
  [-0.9, 2.9],
  [-2.4, 2.0],
  [-4.4, 1.5],
  [-6.5, 1.5],
  [-8.8, 2.2],
  [-7.6, 1.2],
  [-9.2, 0.9],
  [-7.6, 0.4],
  [-8.9, -0.6],
  [-6.6, -0.3],
  [-4.4, -0.4],
  [-2.3, -1.1],
  [-1.9, -2.4],
  [-2.9, -3.7],
  [-2.1, -3.6],
  [-2.7, -4.9],
  [-1.6, -4.5],
  [-1.9, -6.0],
  [-0.6, -5.1],
  [0.6, -3.6],
  [1.6, -2.1],
  [3.1, -1.5],
  [4.9, -1.0],
  [6.4, -0.1],
  [7.6, 0.6],
];
const bird = (count: number): Position[] => curve(kBird, count);
const ngon = (count: number, radius: number): Position[] =>
  Array.from({ length: count }, (_, i) => {
    const angle = (2 * Math.PI * i) / count;
    return [round(radius * Math.cos(angle)), round(radius * Math.sin(angle))];
  });
const star = (rays: number, outer: number, inner: number, turn = 0): Position[] =>
  Array.from({ length: 2 * rays }, (_, i) => {
    const angle = turn + (Math.PI * i) / rays;
    const radius = i % 2 === 0 ? outer : inner;
    return [round(radius * Math.cos(angle)), round(radius * Math.sin(angle))];
  });
/** A band that winds around (x, y). */
function spiral(
  count: number,
  turns: number,
  from: number,
  to: number,
  width: number,
  x: number,
): Position[] {
  const along = (k: number, more: number): Position => {
    const angle = (2 * Math.PI * turns * k) / count;
    const radius = from + ((to - from) * k) / count + more;
    return [round(x + radius * Math.cos(angle)), round(radius * Math.sin(angle))];
  };
  const steps = Array.from({ length: count + 1 }, (_, k) => k);
  return [...steps.map((k) => along(k, width)), ...steps.reverse().map((k) => along(k, 0))];
}
function gear(teeth: number, outer: number, inner: number): Position[] {
  return Array.from({ length: 4 * teeth }, (_, i) => {
    const angle = (2 * Math.PI * (Math.floor(i / 4) + [0, 0.25, 0.5, 0.75][i % 4]!)) / teeth;
    const radius = i % 4 === 1 || i % 4 === 2 ? outer : inner;
    return [round(radius * Math.cos(angle)), round(radius * Math.sin(angle))];
  });
}
const rectangle = (x: number, y: number, width: number, height: number): Position[] => [
  [x, y],
  [x + width, y],
  [x + width, y + height],
  [x, y + height],
];

export interface Example {
  name: string;
  state: Partial<State> & Pick<State, "a" | "b">;
}
export const examples: Example[] = [
  {
    name: "Room and robot",
    state: {
      op: "sum",
      a: polygon(
        [
          [5, 0],
          [16, 0],
          [16, 5],
          [19, 5],
          [19, 11],
          [11, 11],
          [11, 9],
          [5, 9],
        ],
        [
          [7, 3],
          [7, 7],
          [10, 7],
          [10, 3],
        ],
        [
          [13, 2],
          [13, 5],
          [14, 5],
          [14, 2],
        ],
      ),
      b: polygon([
        [-1, -1],
        [1, -0.5],
        [0, 1],
      ]),
    },
  },
  {
    name: "Bird and bird",
    state: { op: "sum", a: polygon(moved(bird(280), 24, 0)), b: polygon(bird(270)) },
  },
  {
    name: "A spiral and a gear",
    state: {
      op: "steps",
      stage: 2,
      a: polygon(spiral(36, 2, 1, 6, 1, 15)),
      b: polygon(gear(6, 1.2, 0.5)),
    },
  },
  {
    name: "Bracket and peg",
    state: {
      op: "nofit",
      a: polygon([
        [0, 0],
        [9, 0],
        [9, 7],
        [6, 7],
        [6, 4],
        [7, 4],
        [7, 2],
        [2, 2],
        [2, 4],
        [4, 4],
        [4, 7],
        [0, 7],
      ]),
      b: polygon([
        [0, 0],
        [2, 0],
        [2, 2],
        [1, 3],
        [0, 2],
      ]),
      place: [4, 8],
    },
  },
  {
    name: "A polyline and a brush",
    state: {
      op: "sum",
      a: {
        ...emptyShape(),
        lines: [
          [
            [5, 1],
            [8, 8],
            [11, 1],
          ],
          [
            [6.5, 4],
            [9.5, 4],
          ],
          [
            [13, 8],
            [13, 1],
            [17, 1],
          ],
        ],
        points: [[17, 6]],
      },
      b: polygon([
        [-0.8, -0.5],
        [-0.5, -0.8],
        [0.8, 0.5],
        [0.5, 0.8],
      ]),
    },
  },
  {
    name: "A plate with a slit",
    state: {
      op: "open",
      a: polygon(
        [
          [4, 0],
          [8, 0],
          [8, 1],
          [11, 1],
          [11, 0],
          [16, 0],
          [16, 6],
          [11, 6],
          [11, 2],
          [8, 2],
          [8, 6],
          [6.25, 6],
          [6.25, 3],
          [5.75, 3],
          [5.75, 6],
          [4, 6],
        ],
        [
          [13, 3.5],
          [13, 4.25],
          [13.75, 4.25],
          [13.75, 3.5],
        ],
      ),
      b: polygon(rectangle(-0.75, -0.75, 1.5, 1.5)),
    },
  },
  {
    name: "A leaf with a margin",
    state: {
      op: "offset",
      distance: 0.75,
      tolerance: 0.125,
      a: polygon(
        [
          [0, 0],
          [3, -2],
          [7, -2.5],
          [10, -1.5],
          [13, 0],
          [9.5, 0.75],
          [8.5, 2.5],
          [6.5, 1.75],
          [4.5, 3],
          [3.5, 1.5],
        ],
        [
          [4, -0.75],
          [6, 0.5],
          [9, -0.5],
          [6.5, -1.25],
        ],
      ),
      b: polygon(ngon(12, 1)),
    },
  },
  {
    name: "Two parts that overlap",
    state: {
      op: "depth",
      a: polygon([
        [0, 0],
        [8, 0],
        [8, 3],
        [5, 3],
        [5, 6],
        [8, 6],
        [8, 8],
        [0, 8],
      ]),
      b: polygon([
        [0, 0],
        [4, -1],
        [5, 2],
        [2, 3],
      ]),
      place: [6, 3],
    },
  },
  {
    name: "A sofa in a hall",
    state: {
      op: "path",
      slices: 36,
      a: {
        ...emptyShape(),
        polygons: [
          [
            rectangle(0, 0, 22, 14),
            [
              [1, 1],
              [1, 13],
              [9, 13],
              [9, 9],
              [10, 9],
              [10, 13],
              [21, 13],
              [21, 1],
              [10, 1],
              [10, 6],
              [9, 6],
              [9, 1],
            ],
          ],
          [
            [
              [14, 5],
              [17, 4.5],
              [17.5, 8.5],
              [14.5, 8],
            ],
          ],
        ],
      },
      b: polygon([
        [-2, -0.5],
        [2, -0.5],
        [2, 0.5],
        [-1, 0.5],
        [-1, 1.25],
        [-2, 1.25],
      ]),
      from: { x: 4.5, y: 4, degrees: 90 },
      to: { x: 18.5, y: 10.5, degrees: 0 },
    },
  },
  {
    name: "Thin stars, which take longer",
    state: {
      op: "sum",
      a: polygon(moved(star(100, 9, 0.8), 22, 0)),
      b: polygon(star(99, 8, 0.7, 0.1)),
    },
  },
  { name: "An empty sheet", state: { a: emptyShape(), b: emptyShape() } },
];

export const stateOf = (example: Example): State => ({ ...defaults, ...example.state });
