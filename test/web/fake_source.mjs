// A source for tests of the page: serves web/dist, and people who walk on circles. Prints its address.
// usage: node fake_source.mjs [PEOPLE] [FOLDER OF THE PAGE]
import {readFile} from 'node:fs/promises';
import {createServer} from 'node:http';
import {dirname, extname, join, normalize} from 'node:path';
import {fileURLToPath} from 'node:url';
import {WebSocketServer} from 'ws';

const TICK = 0.1;
const TYPES = {'.html': 'text/html', '.js': 'text/javascript', '.css': 'text/css'};
const COMMANDS = ['play', 'pause', 'step', 'speed', 'scenario', 'reset', 'add_agent', 'remove_agent', 'set_goal',
  'add_obstacle', 'remove_obstacle', 'add_wall', 'remove_wall', 'select', 'recordings', 'open_recording'];

/** People who walk on circles around the middle, and what is told of them. */
class FakeCrowd {
  constructor(people) {
    this.people = people;
    this.reset();
  }

  reset() {
    const size = 1.2 * Math.sqrt(this.people) + 3;
    Object.assign(this, {tick: 0, playing: true, speed: 1, selected: null, nextId: this.people, size});
    this.agents = Array.from({length: this.people}, (_, id) => {
      const radius = size * Math.sqrt((id + 1) / (this.people + 1));
      return {id, radius, angle: 2.4 * id, speed: 0.8 + 0.8 * (id * 0.618 % 1), side: id % 2 ? 1 : -1};
    });
    this.obstacles = [{id: 0, position: [0, 0], radius: 0.6}];
    this.walls = [{id: 0, from: [-size, -size], to: [size, -size]}, {id: 1, from: [-size, -size], to: [-size, size]}];
  }

  step() {
    ++this.tick;
    for (const agent of this.agents) {
      agent.angle += agent.side * agent.speed * TICK / agent.radius;
    }
  }

  scene() {
    const {size} = this;
    return {type: 'scene', scenario: `circles_${this.people}`, tick_duration: TICK, bounds: [-size, -size, size, size],
      agents: this.agents.map(({id}) => ({id, radius: 0.25, goal: this.goalOf(id)})), obstacles: this.obstacles,
      walls: this.walls, map: null, robots: [{name: 'robot_0', radius: 0.3}]};
  }

  goalOf(id) {
    return this.agents.find((agent) => agent.id === id)?.goal ?? [-this.size / 2, this.size / 2];
  }

  status() {
    return {type: 'status', playing: this.playing, speed: this.speed, tick: this.tick, time: this.tick * TICK,
      walking: this.agents.length, arrived: 0, contacts: 0, episode: 0, over: false};
  }

  robots() {
    return {type: 'robots', tick: this.tick, robots: [{name: 'robot_0', pose: [2, 2, this.tick * 0.05], goal: [-2, 2],
      scan: {angle_min: -1.5, angle_increment: 0.05, ranges: Array.from({length: 61}, (_, i) => 2 + Math.sin(i / 5))}}]};
  }

  mind() {
    const actions = Array.from({length: 15}, (_, i) => ({direction: (i % 5 - 2) * 0.5, speed: 0.6 + 0.4 * Math.floor(i / 5),
      value: -Math.abs(i % 5 - 2 + Math.sin(this.tick / 10)) + i / 15, visits: 10 * i}));
    return {type: 'mind', agent: this.selected, tick: this.tick, actions, chosen: 12, neighbours: [1, 2, 3]};
  }

  frame() {
    const count = this.agents.length;
    const buffer = new ArrayBuffer(24 + 21 * count);
    const view = new DataView(buffer);
    view.setUint32(0, 0x57524331, true);
    view.setUint32(4, this.tick, true);
    view.setFloat64(8, this.tick * TICK, true);
    view.setUint32(16, count, true);
    const floats = [1, 2, 3, 4].map((i) => new Float32Array(buffer, 24 + 4 * i * count, count));
    const ids = new Uint32Array(buffer, 24, count);
    this.agents.forEach(({id, angle, radius, speed, side}, i) => {
      ids[i] = id;
      floats[0][i] = radius * Math.cos(angle);
      floats[1][i] = radius * Math.sin(angle);
      floats[2][i] = angle + side * Math.PI / 2;
      floats[3][i] = speed;
    });
    return buffer;
  }

  /** Obeys a command. Returns messages for all pages; throws if it is refused. */
  obey({command, ...keys}) {
    switch (command) {
      case 'play': case 'pause':
        this.playing = command === 'play';
        return [this.status()];
      case 'step':
        this.step();
        return [this.frame(), this.status(), ...this.selected === null ? [] : [this.mind()]];
      case 'speed':
        this.speed = keys.factor;
        return [this.status()];
      case 'scenario': case 'reset':
        this.reset();
        return [this.scene(), this.frame(), this.status()];
      case 'select':
        this.selected = keys.agent;
        return [];
      case 'add_agent': {
        const [x, y] = keys.position;
        this.agents.push({id: this.nextId++, radius: Math.max(Math.hypot(x, y), 0.1), angle: Math.atan2(y, x), speed: 1,
          side: 1, goal: keys.goal});
        return [this.scene(), this.frame(), this.status()];
      }
      case 'remove_agent':
        this.agents = this.agents.filter(({id}) => id !== keys.agent);
        return [this.scene(), this.frame(), this.status()];
      case 'set_goal':
        this.agents.find(({id}) => id === keys.agent).goal = keys.goal;
        return [this.scene()];
      case 'add_obstacle':
        this.obstacles.push({id: this.nextId++, ...keys});
        return [this.scene()];
      case 'add_wall':
        this.walls.push({id: this.nextId++, ...keys});
        return [this.scene()];
      case 'remove_obstacle':
        this.obstacles = this.obstacles.filter(({id}) => id !== keys.obstacle);
        return [this.scene()];
      case 'remove_wall':
        if (this.walls.every(({id}) => id !== keys.wall)) {
          throw new Error(`there is no wall ${keys.wall}`);
        }
        this.walls = this.walls.filter(({id}) => id !== keys.wall);
        return [this.scene()];
      case 'recordings':
        return [{type: 'recordings', names: ['walk', 'broken']}];
      case 'open_recording':
        return [{type: 'recording', name: keys.name, csv: keys.name === 'walk' ? recording() : 'nothing'}];
      default:
        throw new Error('unknown command');
    }
  }
}

/** A recording of three people, 10 s long. */
function recording() {
  const rows = Array.from({length: 303}, (_, i) => [0, Math.floor(i / 3), i % 3, Math.floor(i / 3) / 8, i % 3]);
  return ['instance,tick,agent,x,y', ...rows.map((row) => row.join(','))].join('\n');
}

const here = dirname(fileURLToPath(import.meta.url));
const folder = process.argv[3] ?? join(here, '../../web/dist');
const crowd = new FakeCrowd(Number(process.argv[2] ?? 50));
const server = createServer(async (request, response) => {
  const name = normalize(new URL(request.url, 'http://page').pathname).replace(/\/$/, '/index.html');
  try {
    const content = await readFile(join(folder, name));
    response.writeHead(200, {'Content-Type': TYPES[extname(name)] ?? 'application/octet-stream'}).end(content);
  } catch {
    response.writeHead(404).end();
  }
});
const sockets = new WebSocketServer({server, path: '/ws', perMessageDeflate: false});
const tell = (messages, targets = sockets.clients) => targets.forEach((socket) => messages.forEach((message) =>
  socket.send(message instanceof ArrayBuffer ? message : JSON.stringify(message))));
sockets.on('connection', (socket) => {
  const hello = {type: 'hello', protocol: 1, back_end: 'python', scenarios: [`circles_${crowd.people}`, 'other'], commands: COMMANDS};
  tell([hello, crowd.scene(), crowd.status(), crowd.frame()], [socket]);
  socket.on('message', (text) => {
    const command = JSON.parse(text);
    try {
      tell(crowd.obey(command));
    } catch (error) {
      tell([{type: 'error', command: command.command, message: error.message}], [socket]);
    }
  });
});
setInterval(() => {
  if (crowd.playing && sockets.clients.size > 0) {
    crowd.step();
    tell([crowd.frame(), crowd.status(), crowd.robots(), ...crowd.selected === null ? [] : [crowd.mind()]]);
  }
}, 1000 * TICK);
server.listen(0, '127.0.0.1', () => console.log(`http://127.0.0.1:${server.address().port}/`));
