// A run in columns, as the server packs it: a header that says where each column lies, then the numbers themselves.

const arrays = {
  f64: Float64Array,
  f32: Float32Array,
  i32: Int32Array,
  u32: Uint32Array,
  u16: Uint16Array,
  u8: Uint8Array,
};

/** @returns {{records, duration, kinds: string[], names: string[], complete: boolean, columns: Object<string, TypedArray>}} */
export function readColumns(buffer) {
  const length = new DataView(buffer).getUint32(0, true);
  const header = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 4, length)));
  const start = Math.ceil((4 + length) / 8) * 8;
  const columns = {};
  for (const [name, {type, offset, length: count}] of Object.entries(header.columns))
    columns[name] = new arrays[type](buffer, start + offset, count);
  return {...header, columns};
}

/** The lane of this name: {n, from, to} and what else it has; all empty where the run has none. */
export function laneOf(columns, name) {
  const lane = {n: new Uint32Array(), from: new Float64Array(), to: new Float64Array()};
  for (const key of Object.keys(columns))
    if (key.startsWith(`${name}.`)) lane[key.slice(name.length + 1)] = columns[key];
  return lane;
}
