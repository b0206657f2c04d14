/** The page of one report, whose data and whose solver stand before this script. */
import { part } from "./elements.mjs";
import { start } from "./main.mjs";

start(JSON.parse(part("report").textContent), kinSolver);
