// Says what is being computed, and how far it is, while that takes long.
import type { Progress, ProgressStage } from "minksum";
import type { Engine } from "./engine.js";

const words: Record<ProgressStage, string> = {
  operands: "preparing the operands",
  convolution: "convolution",
  cover: "cover",
  arrangement: "arrangement",
  loops: "loops",
  filters: "rejecting loops",
  output: "writing the result",
  overlay: "joining areas",
  rounding: "rounding",
  checking: "checking",
  search: "looking for a path",
};

/** The stages of one sum, in their order. */
const sumStages: ProgressStage[] = [
  "operands",
  "convolution",
  "cover",
  "arrangement",
  "loops",
  "filters",
  "output",
];

/** Says how far an operation is: in words, and as a part of a whole if that is known. */
function tell(progress: Progress | undefined): [string, number?, number?] {
  if (progress === undefined) return ["Computing…"];
  const { stage, done, parts } = progress;
  const text = `Computing: ${words[stage]}`;
  if (parts > 1) return [`${text}, ${done} of ${parts} parts done`, done, parts];
  const number = sumStages.findIndex((name) => name === stage);
  if (number < 0) return [text];
  return [`${text}, stage ${number + 1} of ${sumStages.length}`, number, sumStages.length];
}
export function showBusy(engine: Engine): void {
  const box = document.getElementById("busy")!;
  box.hidden = engine.busyFor < 350;
  if (box.hidden) return;
  const [text, done, all] = tell(engine.progress);
  const doing = document.getElementById("doing")!;
  if (doing.textContent !== text) doing.textContent = text;
  const bar = document.getElementById("done") as HTMLProgressElement;
  // Without a value, the bar says that it is not known how much there is to do.
  if (done === undefined) bar.removeAttribute("value");
  else [bar.max, bar.value] = [all!, done];
}
