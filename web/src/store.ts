// Holds the state, tells who listens, and undoes.
import type { State } from "./model.js";

type Listener = (state: State, before: State) => void;

const kMostSteps = 200;

export class Store {
  private undone: State[] = [];
  private done: State[] = [];
  private listeners: Listener[] = [];
  /** the state before the gesture that goes on */
  private start: State | undefined;

  constructor(private current: State) {}
  get state(): State {
    return this.current;
  }
  get canUndo(): boolean {
    return this.done.length > 0;
  }
  get canRedo(): boolean {
    return this.undone.length > 0;
  }
  listen(listener: Listener): void {
    this.listeners.push(listener);
  }
  /** Changes the state: one step to undo, unless a gesture goes on. */
  change(part: Partial<State>): void {
    const before = this.current;
    if (this.start === undefined) this.remember(before);
    this.set({ ...before, ...part });
  }
  /** What is changed from here to `finish` is one step to undo. */
  begin(): void {
    this.start ??= this.current;
  }
  finish(): void {
    const { start } = this;
    this.start = undefined;
    if (start !== undefined && start !== this.current) {
      this.remember(start);
      this.set(this.current);
    }
  }
  /** Takes back what has been changed since `begin`. */
  revert(): void {
    const { start } = this;
    this.start = undefined;
    if (start !== undefined) this.set(start);
  }
  undo(): void {
    this.step(this.done, this.undone);
  }
  redo(): void {
    this.step(this.undone, this.done);
  }
  private step(from: State[], to: State[]): void {
    const next = from.pop();
    if (next === undefined) return;
    to.push(this.current);
    // The view of an operation is not what people undo, but they must see what they undid.
    this.set(next);
  }
  private remember(state: State): void {
    this.done.push(state);
    if (this.done.length > kMostSteps) this.done.shift();
    this.undone = [];
  }
  private set(next: State): void {
    const before = this.current;
    this.current = next;
    for (const listener of this.listeners) listener(next, before);
  }
}
