/** The example `declare` of kin-sketch as an asynchronous function. */
import { spawn } from "node:child_process";
import { createInterface } from "node:readline";

/** Starts the program that the variable KIN_DECLARE names; without it, the one that cargo built last. */
export function startKin() {
  const built = new URL("../../../target/debug/examples/declare", import.meta.url).pathname;
  const program = spawn(process.env.KIN_DECLARE ?? built, { stdio: ["pipe", "pipe", "inherit"] });
  const waiting = [];
  createInterface({ input: program.stdout }).on("line", (line) => waiting.shift()(JSON.parse(line)));
  return {
    declare(sketch) {
      return new Promise((answer) => {
        waiting.push(answer);
        program.stdin.write(`${JSON.stringify(sketch)}\n`);
      });
    },
    stop: () => program.stdin.end(),
  };
}
