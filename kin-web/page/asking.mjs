/** Questions to kin, which runs in a worker with a limit of time, so that no declaration stops the page. */

const TOO_LONG = "This takes longer than the page waits.";
const ABSENT = "kin cannot be loaded here. The page `kin.html`, which is one file, holds it.";
const BROKEN = "kin stopped at this text. That is a defect of kin: the text is worth a report.";

/**
 * @param {() => Worker} start a worker that runs `worker.mjs`
 * @param {Promise<WebAssembly.Module>} module
 * @returns a function that asks a question with a limit in milliseconds; a later question ends an earlier one
 */
export function createAsking(start, module) {
  let worker = null;
  let pending = null;
  let last = 0;

  async function begin() {
    const begun = start();
    worker = begun;
    try {
      begun.postMessage({ module: await module });
    } catch {
      if (begun === worker) {
        stop({ refused: ABSENT });
      }
    }
    return begun;
  }

  function end(answer) {
    clearTimeout(pending?.timer);
    pending?.resolve(answer);
    pending = null;
  }

  /** Ends the worker, which cannot be interrupted otherwise. */
  function stop(answer) {
    worker?.terminate();
    worker = null;
    end(answer);
  }

  return async function ask(question, limit) {
    if (pending) {
      stop({ superseded: true });
    }
    last += 1;
    const id = last;
    const answer = new Promise((resolve) => {
      pending = { id, resolve, timer: setTimeout(() => stop({ refused: TOO_LONG }), limit) };
    });
    const asked = worker ?? (await begin());
    if (pending?.id === id) {
      asked.onmessage = ({ data }) => data.id === pending?.id && end(data.answer);
      asked.onerror = (event) => {
        event.preventDefault();
        if (asked === worker) {
          stop({ refused: BROKEN });
        }
      };
      asked.postMessage({ id, question });
    }
    return answer;
  };
}
