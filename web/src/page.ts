/** Returns the element of the page with the given id. */
export function element<T extends HTMLElement = HTMLElement>(id: string): T {
  return document.getElementById(id) as T;
}

const ICONS = {
  play: '<path d="M7 5l12 7-12 7z"/>',
  pause: '<path d="M8 5v14M16 5v14" stroke-width="4"/>',
  step: '<path d="M5 5l9 7-9 7zM19 5v14"/>',
  reset: '<path d="M4 12a8 8 0 1 0 3-6.2M4 4v4h4"/>',
  fit: '<path d="M4 9V4h5M20 9V4h-5M4 15v5h5M20 15v5h-5"/>',
  panel: '<path d="M4 20V10M10 20V4M16 20v-7M21 20H3"/>',
  select: '<path d="M6 3l12 9-6 1-3 6z"/>',
  person: '<circle cx="10" cy="6" r="3"/><path d="M4 20c0-5 2-8 6-8s6 3 6 8M20 5v6M17 8h6"/>',
  obstacle: '<circle cx="12" cy="12" r="8"/><path d="M12 8v8M8 12h8"/>',
  wall: '<path d="M3 7h18v10H3zM3 12h18M9 7v5M15 12v5"/>',
  goal: '<path d="M6 21V4M6 4h12l-3 4 3 4H6"/>',
  remove: '<path d="M5 7h14M10 7V4h4v3M7 7l1 13h8l1-13"/>',
};

export type Icon = keyof typeof ICONS;

/** Shows an icon on a button. */
export function setIcon(button: HTMLElement, icon: Icon): void {
  if (button.dataset.icon !== icon) {
    button.dataset.icon = icon;
    button.innerHTML = `<svg viewBox="0 0 24 24" aria-hidden="true">${ICONS[icon]}</svg>`;
  }
}

/** Sets the text of an element if it is another. */
export function setText(id: string, text: string): void {
  const target = element(id);
  if (target.textContent !== text) {
    target.textContent = text;
  }
}

const SHOWN = 6000;   // [ms]
const MOST = 4;

/** Shows a message that goes away. */
export function notify(text: string, isError = true): void {
  const box = element('messages');
  const message = document.createElement('p');
  message.textContent = text;
  message.className = isError ? 'error' : 'note';
  box.append(message);
  while (box.childElementCount > MOST) {
    box.firstElementChild!.remove();
  }
  setTimeout(() => message.remove(), SHOWN);
}
