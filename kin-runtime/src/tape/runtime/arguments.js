/**
 * How many names an object has.
 * @param {any} given
 * @returns {number}
 */
function kinCount(given) {
  let count = 0;
  for (const _ in given) count += 1;
  return count;
}

/**
 * A motion, or an empty one if it is no array of a position and its rates.
 * @param {any} motion
 * @returns {any}
 */
function kinMotion(motion) {
  return (Array.isArray(motion) || ArrayBuffer.isView(motion)) && motion.length <= @ENTRIES@ ? motion : [];
}

/**
 * What is wrong with the arguments of `solve`.
 * @param {any} parameters
 * @param {any} inputs
 * @param {any} assembly
 * @returns {TypeError}
 */
function kinMistake(parameters, inputs, assembly) {
  const isNumber = (value) => typeof value === "number";
  const isChoice = (value) => value === OPEN || value === CROSSED;
  const isMotion = (value) => kinMotion(value).length > 0 && Array.from(value).every(isNumber);
  const choice = "OPEN or CROSSED, which this module exports";
  const wanted = [
    ["parameters", parameters, NAMES.parameters, isNumber, "a number"],
    ["inputs", inputs, NAMES.inputs, isMotion, "its motion as an array, as in [position, velocity]"],
    ["assembly", assembly, NAMES.near, isNumber, "a value near this unknown"],
    ["assembly", assembly, NAMES.assemblies, isChoice, choice],
  ];
  for (const [what, given, names, isRight, advice] of wanted) {
    // an assembly is of the last two kinds or of neither
    if (what === "assembly" && names.length === 0) continue;
    for (const name in given) {
      if (!names.includes(name)) {
        const others = names.length > 0 ? `its names are ${names.join(", ")}` : "it is an object without names";
        return new TypeError(`${what} has no ${name}: ${others}`);
      }
    }
    for (const name of names) {
      const value = given?.[name];
      if (!isRight(value)) return new TypeError(`${what}.${name} is ${JSON.stringify(value)}: give ${advice}`);
    }
  }
  return new TypeError(`assembly is ${JSON.stringify(assembly)}: give ${choice}`);
}
