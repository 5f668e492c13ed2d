import type {App} from './app';
import {Status} from './messages';
import {element, setIcon, setText} from './page';
import {Player} from './player';

/** Play, pause, step, speed, scenario, reset, recordings and the time line. */
export class Transport {
  private readonly timeLine = element<HTMLInputElement>('time-line');
  private readonly scenario = element<HTMLSelectElement>('scenario');
  private readonly recordings = element<HTMLSelectElement>('recordings');
  private readonly speed = element<HTMLSelectElement>('speed');

  constructor(private readonly app: App) {
    setIcon(element('step'), 'step');
    setIcon(element('reset'), 'reset');
    element('play').onclick = () => this.togglePlay();
    element('step').onclick = () => this.step();
    element('reset').onclick = () => this.reset();
    element('live').onclick = () => app.showLive();
    this.scenario.onchange = () => {
      app.showLive();
      app.send({command: 'scenario', name: this.scenario.value});
    };
    this.recordings.onchange = () => {
      app.send({command: 'open_recording', name: this.recordings.value});
      this.recordings.value = '';
    };
    this.speed.onchange = () => this.setSpeed();
    this.timeLine.oninput = () => {
      app.player.playing = false;
      app.player.seek(Number(this.timeLine.value));
      app.isDirty = true;
    };
  }

  togglePlay(): void {
    const {player, status} = this.app;
    if (player.isLive) {
      this.app.send({command: status?.playing ? 'pause' : 'play'});
    } else if (!player.playing && player.isRecording && player.time === player.history.last?.time) {
      player.seek(player.history.first!.time);
      player.playing = true;
    } else {
      player.playing = !player.playing;
    }
  }

  step(direction = 1): void {
    const {player} = this.app;
    if (player.isLive && direction > 0) {
      this.app.send({command: 'step', ticks: 1});
    } else {
      player.step(direction);
      this.app.isDirty = true;
    }
  }

  reset(): void {
    this.app.showLive();
    this.app.send({command: 'reset', seed: 1 + Math.floor(Math.random() * 1e6)});
  }

  listScenarios(names: string[]): void {
    this.scenario.replaceChildren(...names.map((name) => new Option(name)));
    this.scenario.disabled = !this.app.knows('scenario');
  }

  listRecordings(names: string[]): void {
    this.recordings.replaceChildren(new Option('Recordings', ''), ...names.map((name) => new Option(name)));
  }

  showScenario(name: string): void {
    if (![...this.scenario.options].some((option) => option.value === name)) {
      this.scenario.add(new Option(name), 0);
    }
    this.scenario.value = name;
  }

  /** Shows what plays, and when. */
  update(player: Player, status: Status | null): void {
    const plays = player.isLive ? status?.playing ?? false : player.playing;
    setIcon(element('play'), plays ? 'pause' : 'play');
    const label = plays ? 'Pause' : 'Play';
    if (element('play').getAttribute('aria-label') !== label) {
      element('play').setAttribute('aria-label', label);
    }
    element('live').hidden = player.isLive;
    const {first, last} = player.history;
    if (first && last) {
      this.timeLine.min = String(first.time);
      this.timeLine.max = String(last.time);
      this.timeLine.value = String(player.time);
    }
    setText('clock', `${player.time.toFixed(1)} s`);
  }

  private setSpeed(): void {
    const factor = Number(this.speed.value);
    this.app.player.speed = factor;
    if (this.app.knows('speed')) {
      this.app.send({command: 'speed', factor});
    }
  }
}
