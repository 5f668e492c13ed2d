// Bundles the page and its worker into dist, which is committed: the same files give the same bytes.
import {cpSync, existsSync, mkdirSync} from 'node:fs';
import {build} from 'esbuild';

const entries = ['src/main.ts', 'src/wasm_worker.ts'].filter((file) => existsSync(file));
await build({
  entryPoints: entries, outdir: 'dist', bundle: true, minify: true, format: 'iife', target: 'es2022',
  legalComments: 'eof', logLevel: 'warning',
});
mkdirSync('dist', {recursive: true});
for (const file of ['index.html', 'style.css']) {
  cpSync(file, `dist/${file}`);
}
