// Runs an image in node: node run.mjs IMAGE.wasm
import { readFileSync, writeSync } from 'node:fs'

const decoder = new TextDecoder()
const host = {
  print: (start, length) =>
    writeSync(1, decoder.decode(new Uint8Array(instance.exports.memory.buffer, start, length))),
  exit: code => process.exit(code),
}
const module = new WebAssembly.Module(readFileSync(process.argv[2]))
const instance = new WebAssembly.Instance(module, { host })
instance.exports.run()
