/** One worker for all blocks of a chapter: a question waits until those of other blocks are answered. */

/**
 * @param {(question: object, limit: number) => Promise<any>} ask a later question ends an earlier one
 * @returns a function that gives a block its own `ask`, whose later questions end its earlier ones
 */
export function createTurns(ask) {
  /** The block whose question is being answered. */
  let asking = null;
  const waiting = new Map();

  async function answered(block, { question, limit, resolve }) {
    asking = block;
    const answer = await ask(question, limit);
    resolve(answer);
    // a question that was ended has a later one in its place
    if (!answer.superseded) {
      asking = null;
      const [next] = waiting;
      if (next) {
        waiting.delete(next[0]);
        answered(...next);
      }
    }
  }

  return () => {
    const block = {};
    return (question, limit) =>
      new Promise((resolve) => {
        waiting.get(block)?.resolve({ superseded: true });
        waiting.delete(block);
        const entry = { question, limit, resolve };
        if (asking === null || asking === block) {
          answered(block, entry);
        } else {
          waiting.set(block, entry);
        }
      });
  };
}
