// Decodes what tools/report/blocks.py packed: {"block": base64, "rows": n, "columns": [...]} in, values out.
import { readFileSync } from "node:fs";
import { decodeColumn, inflate } from "../../tools/viewer/src/data/blocks.js";

const { block, rows, columns } = JSON.parse(readFileSync(0, "utf8"));
const bytes = await inflate(Buffer.from(block, "base64"));
console.log(JSON.stringify(columns.map((column) => Array.from(decodeColumn(bytes, column, rows), (value) => (Number.isNaN(value) ? null : value)))));
