/** The page hands the library over itself, so the package looks for no file. */
export function packagedWasm(): never {
  throw new Error("the page has not sent the library");
}
