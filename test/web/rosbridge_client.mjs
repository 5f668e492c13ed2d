// usage: node rosbridge_client.mjs URL TOPIC TYPE ...
// Subscribes to topics with roslib, until each has had a message; then calls services. Prints what it got as JSON.
import { Ros, Service, Topic } from 'roslib';

const [url, ...words] = process.argv.slice(2);
const ros = new Ros({ url });
const seen = { messages: {}, calls: [] };
const fail = (error) => {
  console.error(error);
  process.exit(1);
};
ros.on('error', fail);
ros.on('close', () => fail('closed'));

const nextMessage = (name, messageType) =>
  new Promise((resolve) => {
    const topic = new Topic({ ros, name, messageType, throttle_rate: 100, queue_length: 1 });
    topic.subscribe((message) => {
      topic.unsubscribe();
      resolve(message);
    });
  });
const call = (name, serviceType, request) =>
  new Promise((resolve) => {
    new Service({ ros, name, serviceType }).callService(request, resolve, (failure) => resolve({ failure }));
  });

ros.on('connection', async () => {
  seen.topics = await new Promise((resolve, reject) => ros.getTopics(resolve, reject));
  for (let i = 0; i < words.length; i += 2) seen.messages[words[i]] = await nextMessage(words[i], words[i + 1]);
  seen.calls.push(await call('/crowd_controller/pause', 'std_srvs/SetBool', { data: true }));
  const start = { x: 8, y: 8, theta: 0 }; // outside of the circle: there is always room
  const agent = { pose: start, goal: { x: 11, y: 8, z: 0 }, max_speed: 1.2, radius: 0.2 };
  seen.calls.push(await call('/crowd_controller/spawn_agent', 'social_crowd/SpawnAgent', agent));
  seen.calls.push(await call('/crowd_controller/spawn_agent', 'social_crowd/SpawnAgent', { position: start })); // no such field
  seen.calls.push(await call('/rosout/get_loggers', 'roscpp/GetLoggers', {})); // not of the crowd
  process.stdout.write(JSON.stringify(seen), () => process.exit(0));
});
