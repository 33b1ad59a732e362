// The border between the view and the rules, which a person can move.

const [LEAST, MOST] = [260, 1200];

/** Sets `--side` of an element by pointer and by arrow keys. */
export function makeDivider(divider, parent) {
  const side = document.getElementById(divider.getAttribute('aria-controls'));
  const set = (width) => {
    const fits = Math.round(Math.min(Math.max(width, LEAST), Math.min(MOST, window.innerWidth - 480)));
    parent.style.setProperty('--side', `${fits}px`);
    divider.setAttribute('aria-valuenow', String(fits));
  };
  divider.addEventListener('pointerdown', (event) => {
    divider.setPointerCapture(event.pointerId);
    const move = ({ clientX }) => set(parent.getBoundingClientRect().right - clientX);
    divider.addEventListener('pointermove', move);
    divider.addEventListener('lostpointercapture', () => divider.removeEventListener('pointermove', move), { once: true });
  });
  divider.addEventListener('keydown', ({ key }) => {
    const step = { ArrowLeft: 24, ArrowRight: -24 }[key];
    if (step) set(side.getBoundingClientRect().width + step);
  });
}
