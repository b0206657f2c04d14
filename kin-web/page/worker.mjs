/** The worker: it runs kin, and answers one question after the other. */
import { ask } from "./ask.mjs";

let kin = null;

onmessage = async ({ data }) => {
  if (data.module) {
    kin = (await WebAssembly.instantiate(data.module, {})).exports;
    return;
  }
  postMessage({ id: data.id, answer: ask(kin, data.question) });
};
