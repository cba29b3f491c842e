// Programs that make what is on the screen.
import { limitsWkt } from "./limits.js";
import { places } from "./picture.js";
import { decimal, position, toWkt, type State } from "./model.js";

export const languages = ["Shell", "C++", "Python", "JavaScript"] as const;
export type Language = (typeof languages)[number];

/** Digits that mean exactly this double. */
function exact(value: number): string {
  for (let bits = 0, times = 1; bits <= 52; ++bits, times *= 2) {
    if (!Number.isInteger(value * times)) continue;
    return bits <= 6 ? decimal(value) : `${value * times}/${times}`;
  }
  return decimal(value);
}
const rational = (text: string) => (text.includes("/") || text.includes(".") ? `"${text}"` : text);
const poseText = (pose: State["from"]) => [pose.x, pose.y, pose.degrees].map(decimal).join(",");

/** What the operation is called in each language. */
const names = {
  sum: { shell: "sum", cpp: "minkowski_sum", python: "minkowski_sum", js: "minkowskiSum" },
  steps: { shell: "sum", cpp: "minkowski_sum", python: "minkowski_sum", js: "minkowskiSum" },
  erode: { shell: "erode", cpp: "erode", python: "erode", js: "erode" },
  open: { shell: "open", cpp: "open", python: "opening", js: "opening" },
  close: { shell: "close", cpp: "close", python: "closing", js: "closing" },
} as const;

function shell(state: State, a: string, b: string): string {
  const fill =
    state.fill === "automatic"
      ? ""
      : state.fill === "strict"
        ? " --strict"
        : ` --fill ${state.fill}`;
  const save = (name: string, wkt: string) => `cat > ${name} <<'END'\n${wkt}\nEND\n`;
  const limits = limitsWkt(state);
  const files =
    save("a.wkt", a) +
    (state.op === "offset" ? "" : save("b.wkt", b)) +
    (limits ? save("limits.wkt", limits) : "");
  const within = limits ? " --workspace limits.wkt" : "";
  const command = () => {
    switch (state.op) {
      case "offset":
        return (
          `offset a.wkt --distance=${exact(state.distance)} --tolerance ` +
          `${exact(state.tolerance)} ` +
          `--join ${state.join} --side ${state.side} --coords exact`
        );
      case "nofit":
        return "nfp a.wkt b.wkt --reference 0,0 --coords exact";
      case "depth":
        return "depth a.wkt b.wkt";
      case "robot":
        return (
          `cspace b.wkt a.wkt --theta ${exact(state.degrees)}:${exact(state.degrees)}:1 ` +
          `--coords exact${within}`
        );
      case "slices":
        return `cspace b.wkt a.wkt --angles ${state.slices} --coords exact${within}`;
      case "path":
        return (
          `reach b.wkt a.wkt --from=${poseText(state.from)} --to=${poseText(state.to)} ` +
          `--angles ${state.slices}${within}`
        );
      case "steps":
        return "sum a.wkt b.wkt --trace stages --coords exact";
      default:
        return `${names[state.op].shell} a.wkt b.wkt --coords exact`;
    }
  };
  return `${files}minksum ${command()}${fill}\n`;
}

function cpp(state: State, a: string, b: string): string {
  const fills: Record<string, string> = {
    evenodd: "kEvenOdd",
    nonzero: "kNonZero",
    positive: "kPositive",
    negative: "kNegative",
    strict: "kStrict",
  };
  const how = fills[state.fill] ? `, options` : "";
  const options = fills[state.fill]
    ? `  Options options;\n  options.fill = FillRule::${fills[state.fill]};\n`
    : "";
  const number = (value: number) => `*Rational::parse("${exact(value)}")`;
  const point = (x: number, y: number) => `{${x}, ${y}}`;
  const print = "io::to_wkt(RESULT, io::Coordinates{io::Coordinates::Style::kExact})";
  const lines = (made: string, shown = print.replace("RESULT", "result")) =>
    `  const auto result = ${made};\n  std::cout << ${shown} << '\\n';\n`;
  const limits = limitsWkt(state);
  const setting = limits ? "{.workspace = limits}" : "{}";
  const body = () => {
    switch (state.op) {
      case "offset": {
        const [join, side] = [state.join, state.side].map(
          (n) => `k${n[0]!.toUpperCase()}${n.slice(1)}`,
        );
        return (
          `  OffsetOptions shape;\n  shape.tolerance = ${number(state.tolerance)};\n` +
          `  shape.join = Join::${join};\n  shape.side = RoundingSide::${side};\n` +
          lines(`offset(a, ${number(state.distance)}, shape${how})`)
        );
      }
      case "nofit":
        return lines(`no_fit_polygon(a, b, Point{0, 0}${how})`);
      case "depth":
        return lines(`penetration_depth(a, b${how})`, "(result ? result->distance : 0.0)");
      case "robot":
        return lines(
          `ConfigurationSpace(b, a, ${setting}${how})` +
            `.slice(nearest_turn(${number(state.degrees)}))`,
          print.replace("RESULT", "result.obstacles"),
        );
      case "slices":
        return (
          `  const ConfigurationSpace space(b, a, ${setting}${how});\n` +
          `  for (const Turn& turn : full_turn(${state.slices}))\n` +
          `    std::cout << io::to_wkt(space.slice(turn).obstacles) << '\\n';\n`
        );
      case "path":
        return (
          `  ReachOptions way;\n  way.angles = ${state.slices};\n` +
          (limits ? `  way.workspace = limits;\n` : "") +
          lines(
            `reach(b, a, {${point(state.from.x, state.from.y)}, ${state.from.degrees}}, ` +
              `{${point(state.to.x, state.to.y)}, ${state.to.degrees}}, way${how})`,
            `(result.reachable ? "yes" : "no")`,
          )
        );
      default:
        return lines(`minksum::${names[state.op].cpp}(a, b${how})`);
    }
  };
  const second =
    (state.op === "offset" ? "" : `  const Geometry b = io::read_geometry(R"(${b})");\n`) +
    (limits ? `  const Geometry limits = io::read_geometry(R"(${limits})");\n` : "");
  return (
    `#include <iostream>\n#include <minksum/io.hpp>\n#include <minksum/minksum.hpp>\nusing ` +
    `namespace minksum;\n\nint main() {\n` +
    `  const Geometry a = io::read_geometry(R"(${a})");\n${second}${options}${body()}}\n`
  );
}

function python(state: State, a: string, b: string): string {
  const fill = state.fill === "automatic" ? "" : `, fill="${state.fill}"`;
  const number = (value: number) => rational(exact(value));
  const limits = limitsWkt(state);
  const within = limits ? ", workspace=limits" : "";
  const made = () => {
    switch (state.op) {
      case "offset":
        return (
          `minksum.offset(a, ${number(state.distance)}, tolerance=${number(state.tolerance)}, ` +
          `join="${state.join}", side="${state.side}"${fill})`
        );
      case "nofit":
        return `minksum.no_fit_polygon(a, b, reference=(0, 0)${fill})`;
      case "depth":
        return `minksum.penetration_depth(a, b${fill})`;
      case "robot":
        return (
          `minksum.ConfigurationSpace(b, a${within}${fill})` +
          `.slice("${decimal(state.degrees)}").obstacles`
        );
      case "slices":
        return (
          `list(minksum.ConfigurationSpace(b, a${within}${fill})` +
          `.slices(${state.slices}))`
        );
      case "path": {
        const pose = (p: State["from"]) => `(${p.x}, ${p.y}, ${p.degrees})`;
        return (
          `minksum.reach(b, a, ${pose(state.from)}, ${pose(state.to)}, ` +
          `angles=${state.slices}${within}${fill})`
        );
      }
      default:
        return `minksum.${names[state.op].python}(a, b${fill})`;
    }
  };
  const second =
    (state.op === "offset" ? "" : `b = minksum.from_wkt("${b}")\n`) +
    (limits ? `limits = minksum.from_wkt("${limits}")\n` : "");
  return `import minksum\n\na = minksum.from_wkt("${a}")\n${second}print(${made()})\n`;
}

function javascript(state: State, a: string, b: string): string {
  const options: Record<string, unknown> = {};
  if (state.fill !== "automatic") options["fill"] = state.fill;
  const limits = limitsWkt(state);
  const more = (extra: object = {}) => {
    const all = { ...options, ...extra };
    const texts = Object.entries(all).map(([name, value]) => `${name}: ${JSON.stringify(value)}`);
    if (limits) texts.push("workspace: limits");
    return texts.length ? `, { ${texts.join(", ")} }` : "";
  };
  const exactWkt = { as: "wkt", coords: "exact" };
  const made = () => {
    switch (state.op) {
      case "offset": {
        const { tolerance, join, side } = state;
        return `mk.offset(a, ${state.distance}${more({ tolerance, join, side, ...exactWkt })})`;
      }
      case "nofit":
        return `mk.noFitPolygon(a, b${more({ reference: [0, 0], ...exactWkt })})`;
      case "depth":
        return `mk.penetrationDepth(a, b${more()})`;
      case "robot":
        return `mk.slices(b, a, [${state.degrees}]${more(exactWkt)})[0].obstacles`;
      case "slices":
        return (
          `mk.slices(b, a, Array.from({ length: ${state.slices} }, (_, i) => (360 * i) / ` +
          `${state.slices})${more()})`
        );
      case "path":
        return (
          `mk.reach(b, a, ${JSON.stringify(state.from)}, ` +
          `${JSON.stringify(state.to)}${more({ angles: state.slices })})`
        );
      case "steps":
        return `mk.trace(a, b${more()})`;
      default:
        return `mk.${names[state.op].js}(a, b${more(exactWkt)})`;
    }
  };
  const second =
    (state.op === "offset" ? "" : `const b = ${JSON.stringify(b)};\n`) +
    (limits ? `const limits = ${JSON.stringify(limits)};\n` : "");
  return (
    `import { load } from "minksum";\n\nconst mk = await load();\nconst a = ` +
    `${JSON.stringify(a)};\n` +
    `${second}console.log(${made()});\n`
  );
}

/** Returns a program that prints the result. `placed` is B where it was dragged to. */
export function snippet(language: Language, state: State, placed: string): string {
  const a = toWkt(state.a);
  const b = state.op === "depth" ? placed : toWkt(state.b);
  const at = places(state) ? `B was dragged to ${position(state.place)}` : "";
  const note = at && (language === "C++" || language === "JavaScript" ? `// ${at}\n` : `# ${at}\n`);
  const write = { Shell: shell, "C++": cpp, Python: python, JavaScript: javascript }[language];
  return note + write(state, a, b);
}
