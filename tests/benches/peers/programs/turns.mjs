// Takes turns with a module of kin, as turns.c does with a kernel. The module `call.mjs` knows the arguments.
import { readFileSync, writeFileSync } from "node:fs";
import { argv, hrtime, stdin } from "node:process";
import { createInterface } from "node:readline";
import { solve, given } from "./call.mjs";

const [width, name] = [Number(argv[2]), argv[3]];
const bytes = readFileSync("in");
const rows = [];
for (let start = 0; start < bytes.length; start += 8 * width) {
  rows.push(given(Array.from({ length: width }, (_, index) => bytes.readDoubleLE(start + 8 * index))));
}
const found = rows.flatMap(([parameters, inputs, assembly]) =>
  Object.values(solve(parameters, inputs, assembly).pose).flat(),
);
const out = Buffer.alloc(8 * found.length);
found.forEach((number, index) => out.writeDoubleLE(number, 8 * index));
writeFileSync(name, out);
console.log("ready");

let last;
for await (const _ of createInterface({ input: stdin })) {
  let shortest = Infinity;
  for (let pass = 0; pass < 10; pass++) {
    const start = hrtime.bigint();
    for (const [parameters, inputs, assembly] of rows) last = solve(parameters, inputs, assembly);
    shortest = Math.min(shortest, Number(hrtime.bigint() - start));
  }
  console.log(shortest);
}
if (!last?.ok) process.exitCode = 1;
