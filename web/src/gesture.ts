// What a pointer does, and what the editor tells.
import type { Position, Shape, Vertex } from "./model.js";

export type Tool = "move" | "polygon" | "hole" | "line";
export type Name = "a" | "b";
export interface Selection {
  name: Name;
  vertex: Vertex;
}
export interface Drag {
  pointer: number;
  /** what the pointer moves */
  what: "vertex" | "part" | "place" | "start" | "goal" | "pan" | "nothing";
  name: Name;
  vertex?: Vertex;
  /** where the pointer was at first, on the screen and in the world */
  sx: number;
  sy: number;
  origin: Position;
  before: { shape: Shape; place: Position; x: number; y: number };
  moved: boolean;
}
export interface Hooks {
  /** something was selected, or the view or what is drawn has changed */
  changed(): void;
  say(text: string): void;
  /** returns a place to which the part that is dragged shall snap */
  tightPlace(x: number, y: number, within: number): Position | null;
}
