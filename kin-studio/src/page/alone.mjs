/** The page of one report, whose data and whose solver stand before this script. */
import { part } from "./elements.mjs";
import { keptState, pageAsWritten } from "./keeping.mjs";
import { start } from "./main.mjs";

const written = pageAsWritten();
start(JSON.parse(part("report").textContent), kinSolver, keptState(), written);
