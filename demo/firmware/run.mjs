// SPDX-License-Identifier: MIT
// Runs the firmware as WebAssembly: node run.mjs firmware.wasm dense|runs JOB [STATE [LAYERS]]
import fs from "node:fs";

const words = process.argv.slice(2);
const files = [];
let memory;

const bytes = (at, size) => new Uint8Array(memory.buffer, at, size);
const text = (at, size) => new TextDecoder().decode(bytes(at, size));

function open(path, toChange) {
  try {
    const there = !toChange || fs.existsSync(path);
    const file = fs.openSync(path, toChange ? (there ? "r+" : "w+") : "r");
    return files.push({ file, at: 0 }) - 1;
  } catch {
    return -1;
  }
}

const board = {
  argument: (index, at, capacity) =>
    index < words.length
      ? new TextEncoder().encodeInto(words[index], bytes(at, capacity)).written
      : 0,
  print: (at, size) => process.stdout.write(text(at, size)),
  open: (at, size, toChange) => open(text(at, size), toChange),
  read: (which, at, size) => {
    const f = files[which];
    const got = fs.readSync(f.file, bytes(at, size), 0, size, f.at);
    f.at += got;
    return got;
  },
  seek: (which, offset) => ((files[which].at = offset), 1),
  write: (which, at, size) => {
    const f = files[which];
    fs.writeSync(f.file, bytes(at, size), 0, size, f.at);
    f.at += size;
    return 1;
  },
};

const { instance } = await WebAssembly.instantiate(fs.readFileSync(words[0]), { board });
memory = instance.exports.memory;
process.exitCode = instance.exports.firmware();
