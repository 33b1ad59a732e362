// Tabs with arrow keys.

/** `onOpen(id)` gets the id of the panel that opens. Returns a function that opens a panel by its id. */
export function makeTabs(list, onOpen) {
  const tabs = [...list.querySelectorAll('[role=tab]')];
  const open = (tab, focus) => {
    for (const other of tabs) {
      const isOpen = other === tab;
      other.setAttribute('aria-selected', String(isOpen));
      other.tabIndex = isOpen ? 0 : -1;
      document.getElementById(other.getAttribute('aria-controls')).hidden = !isOpen;
    }
    if (focus) tab.focus();
    onOpen(tab.getAttribute('aria-controls'));
  };
  for (const [at, tab] of tabs.entries()) {
    tab.addEventListener('click', () => open(tab, false));
    tab.addEventListener('keydown', (event) => {
      const to = { ArrowRight: at + 1, ArrowLeft: at - 1, Home: 0, End: -1 }[event.key];
      if (to === undefined) return;
      event.preventDefault();
      open(tabs.at(to % tabs.length), true);
    });
  }
  return (id) => open(tabs.find((tab) => tab.getAttribute('aria-controls') === id), false);
}
