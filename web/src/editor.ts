// Drawing and dragging by pointers: mouse, pen and touch.
import {
  addHole,
  addLine,
  addPolygon,
  insertVertex,
  movePart,
  moveVertex,
  removeVertex,
} from "./edit.js";
import { nearestEdge, nearestVertex, pairs, polygonAt, same } from "./hit.js";
import {
  add,
  negated,
  pathOf,
  snapTo,
  toNumber,
  verticesOf,
  type Position,
  type Shape,
  type Vertex,
} from "./model.js";
import type { Drag, Hooks, Name, Selection, Tool } from "./gesture.js";
import { hasPoses, places } from "./picture.js";
import { outlineOf, posed } from "./shapes.js";
import type { Store } from "./store.js";
import type { View } from "./view.js";

export type { Name, Selection, Tool };

export class Editor {
  tool: Tool = "move";
  target: Name = "a";
  snap = true;
  selection: Selection | null = null;
  /** the vertices of what is drawn */
  drawing: Position[] = [];
  /** where the pointer, or the keyboard's cursor, is */
  cursor: [number, number] | null = null;
  private drag: Drag | undefined;
  private readonly pointers = new Map<number, [number, number]>();
  private lastTap = { time: 0, x: 0, y: 0 };

  constructor(
    private readonly element: SVGSVGElement,
    private readonly store: Store,
    private readonly view: View,
    private readonly hooks: Hooks,
  ) {
    element.addEventListener("pointerdown", (event) => this.down(event));
    element.addEventListener("pointermove", (event) => this.move(event));
    element.addEventListener("pointerup", (event) => this.up(event));
    element.addEventListener("pointercancel", (event) => this.up(event));
    element.addEventListener("pointerleave", () => {
      if (!this.drag && this.tool === "move") this.setCursor(null);
    });
    element.addEventListener(
      "wheel",
      (event) => {
        event.preventDefault();
        const [x, y] = this.at(event);
        view.zoom(Math.exp(-event.deltaY * 0.0015), x, y);
        hooks.changed();
      },
      { passive: false },
    );
  }
  get dragging(): boolean {
    return this.drag !== undefined && this.drag.what !== "pan";
  }
  /** How far the world of an operand is moved on the screen. */
  offset(name: Name): Position {
    return name === "b" && places(this.store.state) ? this.store.state.place : [0, 0];
  }
  /** Whether vertices of an operand can be seen and moved. */
  editable(name: Name): boolean {
    const { op, degrees } = this.store.state;
    if (op === "slices") return false;
    if (name === "a") return true;
    return op !== "offset" && op !== "path" && !(op === "robot" && degrees !== 0);
  }

  // -- Places --------------------------------------------------------------------------------
  private at(event: PointerEvent | WheelEvent): [number, number] {
    const box = this.element.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }
  /** A place of the world as decimals: at a vertex nearby, or on a grid. */
  snapped(x: number, y: number, without: Selection | null = null): Position {
    if (this.snap) {
      const near = this.vertexNear(x, y, 7, without);
      if (near) return near;
    }
    const fine = 10 ** Math.floor(Math.log10(0.5 / this.view.scale));
    const step = this.snap ? this.view.step / 2 : fine;
    return [snapTo(x, step), snapTo(y, step)];
  }
  private vertexNear(
    x: number,
    y: number,
    pixels: number,
    without: Selection | null,
  ): Position | null {
    let best: { distance: number; p: Position } | null = null;
    for (const name of ["a", "b"] as const) {
      if (!this.editable(name) || (without === null && this.drag)) continue;
      const [ox, oy] = this.offset(name);
      for (const [vertex, p] of verticesOf(this.store.state[name])) {
        if (without?.name === name && same(without.vertex, vertex)) continue;
        const place: Position = [add(p[0], ox), add(p[1], oy)];
        const distance =
          Math.hypot(toNumber(place[0]) - x, toNumber(place[1]) - y) * this.view.scale;
        if (distance < pixels && (!best || distance < best.distance)) best = { distance, p: place };
      }
    }
    return best?.p ?? null;
  }
  private setCursor(cursor: [number, number] | null): void {
    this.cursor = cursor;
    this.hooks.changed();
  }

  // -- Pointers ------------------------------------------------------------------------------
  private down(event: PointerEvent): void {
    if (event.button > 1) return;
    const [sx, sy] = this.at(event);
    this.pointers.set(event.pointerId, [sx, sy]);
    this.element.setPointerCapture(event.pointerId);
    this.element.focus({ preventScroll: true });
    if (this.pointers.size === 2) {
      // A second finger zooms. What the first one has moved goes back.
      this.store.revert();
      this.drag = undefined;
      return;
    }
    const [x, y] = this.view.toWorld(sx, sy);
    const touch = event.pointerType === "touch";
    const twice =
      performance.now() - this.lastTap.time < 350 &&
      Math.hypot(sx - this.lastTap.x, sy - this.lastTap.y) < 8;
    this.lastTap = { time: performance.now(), x: sx, y: sy };
    if (this.tool !== "move" && event.button === 0) {
      this.draw(x, y, twice, touch);
      return;
    }
    this.beginDrag(event, sx, sy, x, y, touch, twice);
  }
  private beginDrag(
    event: PointerEvent,
    sx: number,
    sy: number,
    x: number,
    y: number,
    touch: boolean,
    twice: boolean,
  ): void {
    const { state } = this.store;
    const found =
      event.button === 1
        ? { what: "pan" as const, name: "a" as const }
        : this.under(x, y, touch ? 18 : 9);
    if (twice && found.what === "vertex" && found.vertex) {
      this.remove({ name: found.name, vertex: found.vertex });
      return;
    }
    const pose = found.what === "goal" ? state.to : state.from;
    const before = { shape: state[found.name], place: state.place, x: pose.x, y: pose.y };
    const origin: Position = this.snapped(x, y);
    this.drag = { pointer: event.pointerId, sx, sy, origin, before, moved: false, ...found };
    this.selection = found.what === "vertex" ? { name: found.name, vertex: found.vertex! } : null;
    this.hooks.changed();
  }
  /** Says what a pointer at a place would move. */
  private under(x: number, y: number, pixels: number): Pick<Drag, "what" | "name" | "vertex"> {
    const { state } = this.store;
    const reach = pixels / this.view.scale;
    const order: Name[] = ["b", "a"];
    for (const name of order.filter((n) => this.editable(n))) {
      const [ox, oy] = this.offset(name).map(toNumber) as [number, number];
      const hit = nearestVertex(state[name], x - ox, y - oy);
      if (hit && hit.distance <= reach) return { what: "vertex", name, vertex: hit.vertex };
    }
    if (hasPoses(state)) {
      const robot = outlineOf(state.b);
      for (const [what, pose] of [
        ["start", state.from],
        ["goal", state.to],
      ] as const) {
        const outline = posed(robot, pose.x, pose.y, pose.degrees);
        const shape: Shape = {
          polygons: outline.rings.map((ring) => [pairs(ring)]),
          lines: [],
          points: [],
        };
        const near = Math.hypot(x - pose.x, y - pose.y) <= 2 * reach;
        if (near || polygonAt(shape, x, y)) return { what, name: "b" };
      }
    }
    for (const name of order.filter((n) => this.editable(n))) {
      const [ox, oy] = this.offset(name).map(toNumber) as [number, number];
      const edge = nearestEdge(state[name], x - ox, y - oy);
      const inside =
        polygonAt(state[name], x - ox, y - oy) ??
        (edge && edge.distance <= reach ? edge.vertex : null);
      if (!inside) continue;
      return name === "b" && places(state)
        ? { what: "place", name }
        : { what: "part", name, vertex: inside };
    }
    return { what: "pan", name: "a" };
  }
  private move(event: PointerEvent): void {
    const [sx, sy] = this.at(event);
    const last = this.pointers.get(event.pointerId);
    if (this.pointers.size === 2 && last) {
      this.pinch(event.pointerId, last, [sx, sy]);
      return;
    }
    this.pointers.has(event.pointerId) && this.pointers.set(event.pointerId, [sx, sy]);
    const { drag } = this;
    const [x, y] = this.view.toWorld(sx, sy);
    if (!drag) {
      const p =
        this.tool === "move"
          ? ([x, y] as [number, number])
          : (this.snapped(x, y).map(toNumber) as [number, number]);
      this.setCursor(p);
      return;
    }
    if (!drag.moved && Math.hypot(sx - drag.sx, sy - drag.sy) < 3) return;
    if (!drag.moved && drag.what !== "pan") this.store.begin();
    drag.moved = true;
    this.cursor = null;
    if (drag.what === "pan") {
      this.view.x += sx - last![0];
      this.view.y += sy - last![1];
      this.hooks.changed();
    } else {
      this.apply(drag, x, y);
    }
  }
  private pinch(pointer: number, from: [number, number], to: [number, number]): void {
    const other = [...this.pointers].find(([id]) => id !== pointer)![1];
    const before = Math.hypot(from[0] - other[0], from[1] - other[1]);
    const after = Math.hypot(to[0] - other[0], to[1] - other[1]);
    this.view.x += (to[0] - from[0]) / 2;
    this.view.y += (to[1] - from[1]) / 2;
    if (before > 0) this.view.zoom(after / before, (to[0] + other[0]) / 2, (to[1] + other[1]) / 2);
    this.pointers.set(pointer, to);
    this.hooks.changed();
  }
  /** Does what a drag means, with the pointer at a place of the world. */
  private apply(drag: Drag, x: number, y: number): void {
    const { state } = this.store;
    const { before } = drag;
    if (drag.what === "vertex") {
      const [ox, oy] = this.offset(drag.name);
      const to = this.snapped(x, y, { name: drag.name, vertex: drag.vertex! });
      const local: Position = [add(to[0], negated(ox)), add(to[1], negated(oy))];
      this.store.change({ [drag.name]: moveVertex(before.shape, drag.vertex!, local) });
      return;
    }
    const to = this.snapped(x, y);
    const by: Position = [add(to[0], negated(drag.origin[0])), add(to[1], negated(drag.origin[1]))];
    const shift = (p: Position): Position => [add(p[0], by[0]), add(p[1], by[1])];
    if (drag.what === "part") {
      this.store.change({ [drag.name]: movePart(before.shape, drag.vertex!, shift) });
    } else if (drag.what === "place") {
      const free = shift(before.place);
      const within = 11 / this.view.scale;
      const tight =
        this.snap &&
        state.op === "nofit" &&
        this.hooks.tightPlace(toNumber(free[0]), toNumber(free[1]), within);
      this.store.change({ place: tight || free });
    } else {
      const name = drag.what === "start" ? "from" : "to";
      const [px, py] = [toNumber(add(before.x, by[0])), toNumber(add(before.y, by[1]))];
      this.store.change({ [name]: { ...state[name], x: px, y: py } });
    }
  }
  private up(event: PointerEvent): void {
    this.pointers.delete(event.pointerId);
    const { drag } = this;
    if (!drag || drag.pointer !== event.pointerId) return;
    this.drag = undefined;
    if (drag.moved && drag.what !== "pan") this.store.finish();
    else if (!drag.moved) this.click(drag, event.pointerType === "touch");
    this.hooks.changed();
  }
  /** A click on an edge inserts a vertex there. */
  private click(drag: Drag, touch: boolean): void {
    if (drag.what === "vertex") {
      this.sayVertex();
      return;
    }
    if (drag.what !== "part" && drag.what !== "place") return;
    const [x, y] = this.view.toWorld(drag.sx, drag.sy);
    const [ox, oy] = this.offset(drag.name);
    const edge = nearestEdge(this.store.state[drag.name], x - toNumber(ox), y - toNumber(oy));
    if (!edge || edge.distance * this.view.scale > (touch ? 14 : 7)) return;
    const at = this.snapped(edge.at[0] + toNumber(ox), edge.at[1] + toNumber(oy));
    this.insert(drag.name, edge.vertex, [add(at[0], negated(ox)), add(at[1], negated(oy))]);
  }

  // -- Changes, which the keyboard makes as well ---------------------------------------------
  insert(name: Name, vertex: Vertex, at: Position): void {
    this.store.change({ [name]: insertVertex(this.store.state[name], vertex, at) });
    this.selection = { name, vertex: { ...vertex, index: vertex.index + 1 } };
    this.sayVertex("Inserted. ");
    this.hooks.changed();
  }
  remove(selection: Selection): void {
    this.selection = null;
    this.store.change({
      [selection.name]: removeVertex(this.store.state[selection.name], selection.vertex),
    });
    this.hooks.say("Vertex removed.");
    this.hooks.changed();
  }
  sayVertex(before = ""): void {
    const { selection } = this;
    if (!selection) return;
    const path = pathOf(this.store.state[selection.name], selection.vertex);
    const [x, y] = path[selection.vertex.index]!;
    const { index, ring } = selection.vertex;
    const where = ring > 0 ? `, hole ${ring}` : "";
    this.hooks.say(
      `${before}${selection.name.toUpperCase()}${where}, vertex ${index + 1} of ${path.length}: ` +
        `${x}, ${y}`,
    );
  }
  /** Adds a vertex to what is drawn, or ends it. */
  draw(x: number, y: number, twice: boolean, touch: boolean): void {
    const [first] = this.drawing;
    const reach = (touch ? 20 : 10) / this.view.scale;
    const atFirst =
      first &&
      this.drawing.length > 2 &&
      Math.hypot(toNumber(first[0]) - x, toNumber(first[1]) - y) < reach;
    if (atFirst || twice) {
      this.finishDrawing();
      return;
    }
    const at = this.snapped(x, y);
    const last = this.drawing.at(-1);
    if (last && last[0] === at[0] && last[1] === at[1]) return;
    this.drawing.push(at);
    this.cursor = at.map(toNumber) as [number, number];
    this.hooks.say(`Vertex ${this.drawing.length} at ${at[0]}, ${at[1]}`);
    this.hooks.changed();
  }
  finishDrawing(): void {
    const { drawing, tool, target } = this;
    const [ox, oy] = this.offset(target);
    const path = drawing.map(([x, y]): Position => [add(x, negated(ox)), add(y, negated(oy))]);
    this.drawing = [];
    const shape = this.store.state[target];
    const least = tool === "line" ? 1 : 3;
    if (path.length < least) {
      if (path.length > 0) this.hooks.say("A ring needs three vertices. Nothing was drawn.");
    } else if (tool === "hole") {
      const [x, y] = path[0]!.map(toNumber) as [number, number];
      const part = polygonAt(shape, x, y)?.part;
      if (part === undefined)
        this.hooks.say(`A hole begins inside of a polygon of ${target.toUpperCase()}.`);
      else this.store.change({ [target]: addHole(shape, part, path) });
    } else {
      this.store.change({
        [target]: tool === "line" ? addLine(shape, path) : addPolygon(shape, path),
      });
      this.hooks.say(
        `${tool === "line" ? "Polyline" : "Polygon"} of ${path.length} vertices added to ` +
          `${target.toUpperCase()}.`,
      );
    }
    this.hooks.changed();
  }
  stopDrawing(): void {
    this.drawing = [];
    this.hooks.changed();
  }
}
