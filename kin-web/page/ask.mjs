/** A question to kin, as kin-web/src/question.rs defines it, and its answer, across the border of the module. */
export function ask(kin, question) {
  const bytes = new TextEncoder().encode(JSON.stringify(question));
  const start = kin.reserve(bytes.length);
  new Uint8Array(kin.memory.buffer, start, bytes.length).set(bytes);
  const length = kin.ask(start, bytes.length);
  return JSON.parse(new TextDecoder().decode(new Uint8Array(kin.memory.buffer, kin.answered(), length)));
}
