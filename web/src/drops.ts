// What is dropped and pasted.
import { byId } from "./panel.js";

export function listenToDrops(
  target: () => string,
  take: (file: File) => void,
  takeText: (text: string) => void,
): void {
  const shade = byId("drop");
  document.addEventListener("dragover", (event) => {
    event.preventDefault();
    shade.hidden = false;
    shade.textContent = `Drop a file for ${target()}: WKT, GeoJSON, SVG or DXF`;
  });
  document.addEventListener("dragleave", (event) => {
    if (event.relatedTarget === null) shade.hidden = true;
  });
  document.addEventListener("drop", (event) => {
    event.preventDefault();
    shade.hidden = true;
    const file = event.dataTransfer?.files[0];
    const text = event.dataTransfer?.getData("text");
    if (file) take(file);
    else if (text) takeText(text);
  });
  document.addEventListener("paste", (event) => {
    if ((event.target as Element).matches?.("input, textarea")) return;
    const text = event.clipboardData?.getData("text");
    if (text) takeText(text);
  });
}
