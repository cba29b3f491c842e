// Light and dark.
import { byId } from "./panel.js";

const kKept = "minksum-theme";

function set(theme: string): void {
  document.documentElement.dataset["theme"] = theme;
  byId("theme").textContent = theme === "dark" ? "☀" : "☾";
}
/** A folder that is opened as a file may have no storage. */
function stored(theme?: string): string | null {
  try {
    if (theme) localStorage.setItem(kKept, theme);
    return localStorage.getItem(kKept);
  } catch {
    return null;
  }
}
/** Begins with what was chosen last, or with what the system likes. */
export function listenToTheme(changed: () => void): void {
  set(stored() ?? (matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light"));
  byId("theme").onclick = () => {
    const next = document.documentElement.dataset["theme"] === "dark" ? "light" : "dark";
    set(next);
    stored(next);
    changed();
  };
}
