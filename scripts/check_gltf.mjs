// SPDX-License-Identifier: Apache-2.0
//
// Khronos' validator over .glb files: node scripts/check_gltf.mjs FOLDER FILE...
// FOLDER has node_modules/gltf-validator. Exit code 1: a file has an error.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { resolve } from "node:path";

const [folder, ...files] = process.argv.slice(2);
const validator = createRequire(resolve(folder, "x.js"))("gltf-validator");
let failed = files.length === 0;
for (const file of files) {
  const report = await validator.validateBytes(new Uint8Array(readFileSync(file)), {
    uri: file, maxIssues: 20,
  });
  const { numErrors, numWarnings, numInfos, messages } = report.issues;
  console.log(`${file}: ${numErrors} errors, ${numWarnings} warnings, ${numInfos} infos; ` +
              `${report.info.animationCount ?? 0} animations, ${report.info.materialCount ?? 0} materials`);
  for (const m of messages.slice(0, 10)) console.log(`  ${m.code} ${m.pointer}: ${m.message}`);
  failed = failed || numErrors > 0;
}
process.exit(failed ? 1 : 0);
