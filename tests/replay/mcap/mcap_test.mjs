// MCAP files as others read and write them: @mcap/core the file, @foxglove/rosmsg2-serialization the messages of ROS 2.
//   CONTINUA=build/continua CONTINUA_NODE_MODULES=… node mcap_test.mjs
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {tmpdir} from 'node:os';
import {dirname, join} from 'node:path';
import {after, test} from 'node:test';
import {fileURLToPath} from 'node:url';
import {gunzipSync} from 'node:zlib';

const source = join(dirname(fileURLToPath(import.meta.url)), '../../..');
const require = createRequire(join(process.env.CONTINUA_NODE_MODULES ?? '', 'x.js'));
let mcap, zstd, rosmsg, serialization;
try {
  mcap = require('@mcap/core');
  zstd = require('fzstd');
  rosmsg = require('@foxglove/rosmsg');
  serialization = require('@foxglove/rosmsg2-serialization');
} catch (problem) {
  console.log(`@mcap/core, fzstd or @foxglove's packages are missing: skipped (${problem.code ?? problem})`);
  process.exit(77);
}

const folder = mkdtempSync(join(tmpdir(), 'mcap'));
after(() => rmSync(folder, {recursive: true}));
const program = (...words) => execFileSync(process.env.CONTINUA, words, {maxBuffer: 2 ** 30});

// Whether a value has the types of a schema, and no members that our own schemas do not have.
function conforms(value, schema, place) {
  const types = {string: 'string', number: 'number', integer: 'number', boolean: 'boolean'};
  if (schema.type === 'array') return value.forEach((one, i) => conforms(one, schema.items, `${place}/${i}`));
  if (schema.type !== 'object') return assert.equal(typeof value, types[schema.type], `${place}: ${value}`);
  for (const [name, member] of Object.entries(value))
    if (schema.properties[name]) conforms(member, schema.properties[name], `${place}/${name}`);
    else assert.equal(schema.title, 'continua.Event', `${place}/${name} is not in the schema`);
}

// All that is in a file, by its index.
async function contentOf(file) {
  const bytes = readFileSync(file);
  const readable = {
    size: async () => BigInt(bytes.length),
    read: async (offset, length) => new Uint8Array(bytes.subarray(Number(offset), Number(offset + length))),
  };
  const decompressHandlers = {zstd: (packed, size) => zstd.decompress(packed, new Uint8Array(Number(size)))};
  const reader = await mcap.McapIndexedReader.Initialize({readable, decompressHandlers});
  const messages = {};
  for await (const message of reader.readMessages()) {
    const {topic, schemaId, messageEncoding} = reader.channelsById.get(message.channelId);
    const schema = reader.schemasById.get(schemaId);
    const text = new TextDecoder().decode(schema.data);
    const data =
      messageEncoding === 'json'
        ? JSON.parse(new TextDecoder().decode(message.data))
        : new serialization.MessageReader(rosmsg.parse(text, {ros2: true})).readMessage(message.data);
    (messages[topic] ??= []).push({t_ns: message.logTime, data});
    if (schema.encoding === 'jsonschema') conforms(data, JSON.parse(text), topic);
  }
  const attachments = [];
  for await (const attachment of reader.readAttachments()) attachments.push(attachment);
  const metadata = [];
  for await (const one of reader.readMetadata()) metadata.push(one);
  return {reader, messages, attachments, metadata};
}

for (const name of ['building_blocks', 'talk/speech_only', 'paper/one_breath.physics', 'corner/header_only'])
  test(`@mcap/core reads all of ${name}`, async () => {
    const run = join(source, 'traces', `${name}.run.jsonl`);
    const file = join(folder, 'run.mcap');
    program('export', run, '--to', 'mcap', '-o', file);
    const log = program('export', run, '--to', 'jsonl');
    const {reader, messages, attachments, metadata} = await contentOf(file);
    const counted = Object.values(messages).reduce((sum, list) => sum + list.length, 0);
    assert.equal(Number(reader.statistics.messageCount), counted);
    assert.equal(attachments.length, 1);
    assert.deepEqual(gunzipSync(attachments[0].data), log);
    assert.equal(JSON.parse(metadata[0].metadata.get('trace')).kind, 'trace');
    const said = log
      .toString()
      .split('\n')
      .filter(Boolean)
      .map(JSON.parse)
      .filter((one) => one.kind === 'utterance');
    assert.deepEqual(
      (messages['/avatar/say'] ?? []).map((one) => one.data.data),
      said.map((one) => one.text),
    );
    for (const {t_ns, data} of messages['/humans/voices/human/speech'] ?? []) {
      assert.equal(
        BigInt(data.header.stamp.sec) * 1000000000n + BigInt(data.header.stamp.nanosec ?? data.header.stamp.nsec),
        t_ns,
      );
      assert.ok(data.final && data.confidence > 0);
    }
  });

const header = `${'='.repeat(80)}\nMSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id\n${'='.repeat(80)}
MSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec\n`;
const speech = `# words
std_msgs/Header header
string incremental # may change
string final
float64 confidence
string locale
${header}`;
const gesture = `std_msgs/Header header\nuint8 WAVING = 6\nuint8 OTHER = 0\nuint8 gesture\n${header}`;

// A bag as others write it; each message is [seconds, topic, type, definition, message].
async function writeBag(file, messages) {
  const parts = [];
  let position = 0n;
  const writable = {
    position: () => position,
    write: async (bytes) => {
      parts.push(Buffer.from(bytes));
      position += BigInt(bytes.length);
    },
  };
  const writer = new mcap.McapWriter({writable, chunkSize: 100});
  await writer.start({profile: 'ros2', library: 'test'});
  for (const [t_s, topic, name, definition, message] of messages) {
    const schemaId = await writer.registerSchema({
      name,
      encoding: 'ros2msg',
      data: new TextEncoder().encode(definition),
    });
    const channelId = await writer.registerChannel({schemaId, topic, messageEncoding: 'cdr', metadata: new Map()});
    const data = new serialization.MessageWriter(rosmsg.parse(definition, {ros2: true})).writeMessage(message);
    const time = 1700000000000000000n + BigInt(t_s * 1e9);
    await writer.addMessage({channelId, sequence: 0, logTime: time, publishTime: time, data});
  }
  await writer.end();
  writeFileSync(file, Buffer.concat(parts));
}

test('a bag with ROS4HRI becomes a trace', async () => {
  const bag = join(folder, 'bag.mcap');
  const stamp = {stamp: {sec: 1, nanosec: 2, nsec: 2}, frame_id: 'camera'};
  await writeBag(bag, [
    [
      0,
      '/humans/voices/v/speech',
      'hri_msgs/msg/LiveSpeech',
      speech,
      {header: stamp, incremental: 'take', final: '', confidence: 0, locale: 'en'},
    ],
    [
      0.5,
      '/humans/voices/v/speech',
      'hri_msgs/msg/LiveSpeech',
      speech,
      {header: stamp, incremental: '', final: 'take the cup', confidence: 0.5, locale: 'en'},
    ],
    [2, '/humans/bodies/b/gesture', 'hri_msgs/msg/Gesture', gesture, {header: stamp, gesture: 6}],
  ]);
  const trace = program('import', bag, '-o', '-').toString().split('\n').slice(1, -1).map(JSON.parse);
  assert.deepEqual(trace, [
    {t: 0, kind: 'speech', text: 'take', final: false},
    {t: 0.5, kind: 'speech', text: 'take the cup', confidence: 0.5},
    {t: 2, kind: 'gesture', name: 'waving'},
  ]);
});
