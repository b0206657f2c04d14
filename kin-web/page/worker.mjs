/** The worker: it runs kin, and answers one question after the other. */

let kin = null;

onmessage = async ({ data }) => {
  if (data.module) {
    kin = (await WebAssembly.instantiate(data.module, {})).exports;
    return;
  }
  postMessage({ id: data.id, answer: ask(data.question) });
};

/** The answer to a question, as kin-web/src/question.rs defines both. */
function ask(question) {
  const bytes = new TextEncoder().encode(JSON.stringify(question));
  const start = kin.reserve(bytes.length);
  new Uint8Array(kin.memory.buffer, start, bytes.length).set(bytes);
  const length = kin.ask(start, bytes.length);
  return JSON.parse(new TextDecoder().decode(new Uint8Array(kin.memory.buffer, kin.answered(), length)));
}
