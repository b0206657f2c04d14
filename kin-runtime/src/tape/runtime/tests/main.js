
// Reads cases and writes results, as doubles.
const CODES = ["", "not converged", "singular", "not finite"];

function fourBar(r) {
  return (u) => {
    const [s2, c2] = kinSineCosine(r[4]);
    const [s3, c3] = kinSineCosine(u[0]);
    const [s4, c4] = kinSineCosine(u[1]);
    return [
      [r[1] * c2 + r[2] * c3 - r[0] - r[3] * c4, r[1] * s2 + r[2] * s3 - r[3] * s4],
      [[-(r[2] * s3), r[3] * s4], [r[2] * c3, -(r[3] * c4)]],
    ];
  };
}

function surfaces(g) {
  return (u) => [
    [u[0] * u[0] + u[1] * u[1] + u[2] * u[2] - g[0], u[0] * u[1] - g[1] * u[2], u[0] + u[1] * u[2] - g[2]],
    [[2 * u[0], 2 * u[1], 2 * u[2]], [u[1], u[0], -g[1]], [1, u[2], u[1]]],
  ];
}

function newton(numbers, count, givenCount, equations, sizes) {
  const { unknowns, code, detail } = kinNewton(numbers.slice(givenCount), sizes, equations(numbers));
  return [CODES.indexOf(code), detail, ...unknowns];
}

function matrix(numbers) {
  const factors = kinFactor([0, 4, 8, 12].map((start) => numbers.slice(start, start + 4)));
  const solution = factors.code ? [0, 0, 0, 0] : kinSubstitute(factors, numbers.slice(16));
  return [CODES.indexOf(factors.code), factors.detail, ...solution];
}

const CASES = {
  elementary: [2, ([y, x]) => [...kinSineCosine(y), kinAtan2(y, x)]],
  "four-bar": [7, (numbers) => newton(numbers, 2, 5, fourBar, [1, 1])],
  surfaces: [6, (numbers) => newton(numbers, 3, 3, surfaces, [1, 2, 0.5])],
  matrices: [20, matrix],
};

import { readFileSync, writeFileSync } from "node:fs";

const [length, solve] = CASES[process.argv[2]];
const bytes = readFileSync("in");
const numbers = Array.from({ length: bytes.length / 8 }, (_, index) => bytes.readDoubleLE(8 * index));
const found = [];
for (let start = 0; start < numbers.length; start += length) {
  found.push(...solve(numbers.slice(start, start + length)));
}
const out = Buffer.alloc(8 * found.length);
found.forEach((number, index) => out.writeDoubleLE(number, 8 * index));
writeFileSync("out", out);
