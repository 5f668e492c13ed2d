// usage: node foxglove_client.mjs URL TOPIC ...
// Subscribes to topics with Foxglove's client, until each has had a message; then calls a service that succeeds and one
// that fails. Prints what it got as JSON: types and messages by topic, and the results of the calls.
import foxglove from '@foxglove/ws-protocol';
import rosmsg from '@foxglove/rosmsg';
import serialization from '@foxglove/rosmsg-serialization';
import WebSocket from 'ws';

const [url, ...topics] = process.argv.slice(2);
const client = new foxglove.FoxgloveClient({
  ws: new WebSocket(url, [foxglove.FoxgloveClient.SUPPORTED_SUBPROTOCOL], { maxPayload: 2 ** 30 }),
});
const channels = new Map(); // by topic
const subscribed = new Map(); // channels by number of the subscription
const services = new Map(); // by name
const seen = { info: null, types: {}, messages: {}, calls: [] };

const fail = (error) => {
  console.error(error);
  process.exit(1);
};
client.on('error', fail);
client.on('status', fail);
client.on('close', () => fail('closed'));
client.on('serverInfo', (info) => (seen.info = info));
client.on('advertise', (added) => {
  for (const channel of added) {
    channels.set(channel.topic, channel);
    if (topics.includes(channel.topic)) subscribed.set(client.subscribe(channel.id), channel);
  }
});
client.on('message', ({ subscriptionId, data }) => {
  const channel = subscribed.get(subscriptionId);
  if (channel.topic in seen.messages) return; // sent before the server has heard of the end of the subscription
  const reader = new serialization.MessageReader(rosmsg.parse(channel.schema));
  seen.types[channel.topic] = channel.schemaName;
  seen.messages[channel.topic] = reader.readMessage(data);
  client.unsubscribe(subscriptionId);
  if (Object.keys(seen.messages).length === topics.length) callServices();
});

client.on('advertiseServices', (added) => added.forEach((service) => services.set(service.name, service)));
const call = (name, request, callId) => {
  const service = services.get(name);
  const writer = new serialization.MessageWriter(rosmsg.parse(service.request.schema));
  client.sendServiceCallRequest({ serviceId: service.id, callId, encoding: 'ros1', data: writer.writeMessage(request) });
};
function callServices() {
  call('/crowd_controller/pause', { data: true }, 1);
}
client.on('serviceCallResponse', ({ serviceId, callId, data }) => {
  const service = [...services.values()].find(({ id }) => id === serviceId);
  const reader = new serialization.MessageReader(rosmsg.parse(service.response.schema));
  seen.calls.push({ callId, ...reader.readMessage(new DataView(data.buffer, data.byteOffset, data.byteLength)) });
  if (callId === 1) return call('/crowd_controller/remove_agent', { agent: 4000000 }, 2); // there is no such agent
  client.sendServiceCallRequest({ serviceId, callId: 3, encoding: 'ros1', data: new Uint8Array(1) }); // too short
});
client.on('serviceCallFailure', ({ callId, message }) => {
  seen.calls.push({ callId, failure: message });
  // Numbers of 64 bits are BigInt.
  const text = JSON.stringify(seen, (_, value) => (typeof value === 'bigint' ? Number(value) : value));
  process.stdout.write(text, () => process.exit(0));
});
