// Checks a glTF file with the validator of Khronos: node validate_gltf.mjs FILE. Prints its report; status 3: the
// validator is not installed (npm ci in this folder).
import fs from 'node:fs';

let validator;
try {
  validator = await import('gltf-validator');
} catch {
  process.exit(3);
}
const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(process.argv[2])));
console.log(JSON.stringify({ ...report.issues, info: report.info }));
