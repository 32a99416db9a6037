// Puts the page together: selection, keys, tabs.

const selection = {node: null, resource: null};

/** Selects a node, or nothing: marks what it needs and what it feeds. */
function select(node, {resource = null, reveal: wantsReveal = false} = {}) {
  selection.node = node;
  selection.resource = resource;
  const needed = node ? reach(node, true) : new Set();
  const fed = node ? reach(node, false) : new Set();
  for (const other of nodes) {
    const marks = {selected: other === node, needed: needed.has(other.index), fed: fed.has(other.index)};
    for (const [mark, isOn] of Object.entries(marks)) other.element.classList.toggle(mark, isOn);
    other.element.setAttribute("aria-pressed", String(other === node));
  }
  graph.classList.toggle("choosing", node !== null);
  const isIn = (set, index) => set.has(index) || (node !== null && index === node.index);
  for (const edge of plan.edges) {
    const isTouching = node !== null && (edge.from === node.index || edge.to === node.index);
    const isFlow = edge.kind !== "history" && (edge.kind !== "off" || (node !== null && !doesRun(node)));
    edge.element.classList.toggle("needed", isFlow && isIn(needed, edge.from) && isIn(needed, edge.to));
    edge.element.classList.toggle("fed", isFlow && isIn(fed, edge.from) && isIn(fed, edge.to));
    edge.element.classList.toggle("touching", isTouching);
  }
  showDetails();
  markTimeline();
  markBarriers();
  markNodeTable();
  if (node && wantsReveal) reveal(node);
  else drawOverview();
}

/** Selects the node that writes a resource first. */
function selectResource(index) {
  const writer = nodes[plan.resources[index].writers[0]] ?? nodes[plan.resources[index].readers[0]];
  if (writer) select(writer, {resource: index, reveal: true});
}

function openTab(name) {
  for (const tab of document.querySelectorAll("[role=tab]")) {
    const isOpen = tab.id === `tab-${name}`;
    tab.setAttribute("aria-selected", String(isOpen));
    tab.tabIndex = isOpen ? 0 : -1;
    document.getElementById(tab.getAttribute("aria-controls")).hidden = !isOpen;
  }
  if (name === "timeline") drawTimeline();
}

function startTabs() {
  const tabs = [...document.querySelectorAll("[role=tab]")];
  for (const [index, tab] of tabs.entries()) {
    tab.addEventListener("click", () => openTab(tab.getAttribute("aria-controls")));
    tab.addEventListener("keydown", (event) => {
      const step = {ArrowLeft: -1, ArrowRight: 1}[event.key];
      if (!step) return;
      event.stopPropagation();
      const next = tabs[(index + step + tabs.length) % tabs.length];
      next.focus();
      next.click();
    });
  }
}

/** Along an edge to a source or a reader, or to the pass before or after. */
function walk(key) {
  const node = selection.node;
  const nextIn = {
    ArrowLeft: () => nodes[edgesInto[node.index][0]?.from],
    ArrowRight: () => nodes[edgesFrom[node.index][0]?.to],
    ArrowUp: () => passNodes[(node.pass ?? 0) - 1],
    ArrowDown: () => passNodes[(node.pass ?? -1) + 1],
  }[key]();
  if (!nextIn) return;
  select(nextIn, {reveal: true});
  nextIn.element.focus({preventScroll: true});
}

function onKey(event) {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  if (event.target.matches("input")) {
    if (event.key === "Escape") event.target.blur();
    return;
  }
  const step = 60;
  const pans = {ArrowLeft: [step, 0], ArrowRight: [-step, 0], ArrowUp: [0, step], ArrowDown: [0, -step]};
  const keys = {
    "/": () => search.focus(), "f": fit, "+": () => zoomAt(1.25), "=": () => zoomAt(1.25), "-": () => zoomAt(0.8),
    "?": toggleHelp, "Escape": () => help.hidden ? select(null) : toggleHelp(),
  };
  const isInLists = event.target.closest("#lists, #details, #splitter");
  if (pans[event.key] && !isInLists) selection.node ? walk(event.key) : pan(...pans[event.key]);
  else if (keys[event.key]) keys[event.key]();
  else return;
  event.preventDefault();
}

const help = document.getElementById("help");
function toggleHelp() {
  help.hidden = !help.hidden;
  document.getElementById("help-button").setAttribute("aria-expanded", String(!help.hidden));
}

function makeHelp() {
  const line = (className, text) => element("li", {}, element("span", {className: `swatch ${className}`}), text);
  help.append(element("h2", {}, "Legend"), element("ul", {},
      ...Object.entries(states).map(([state, words]) => line(state, words)),
      line("needed", "what the chosen node needs"), line("fed", "what it feeds")),
  element("p", {}, "Solid lines flow in this frame, dotted ones list tiles, long dashes come from an earlier frame, " +
      "short grey dashes carry nothing. The bar in a node is its share of the passes' GPU time."),
  element("h2", {}, "Keys"),
  element("p", {}, "Drag or arrows: pan. Wheel, + and −: zoom. f: fit. /: search, Enter and Shift+Enter: next and last. " +
      "Tab and Enter: choose a node. With one chosen, arrows: its source, its reader, the pass before, the pass after. " +
      "Esc: choose none."));
}

function startSplitter() {
  const lists = document.getElementById("lists");
  const splitter = document.getElementById("splitter");
  const resize = (by) => {
    const height = Math.min(Math.max(lists.offsetHeight + by, 40), innerHeight - 200);
    lists.style.height = `${height}px`;
  };
  onDrag(splitter, (dx, dy) => resize(-dy));
  splitter.addEventListener("keydown", (event) => {
    const by = {ArrowUp: 20, ArrowDown: -20}[event.key];
    if (by) resize(by);
  });
  new ResizeObserver(drawTimeline).observe(timeline);
}

function showTitle() {
  document.title = `Plan of ${plan.graph}`;
  document.getElementById("title").textContent = `Plan of ${plan.graph}`;
  const running = nodes.filter((node) => node.pass !== undefined && doesRun(node)).length;
  const time = isMeasured ? `${msInWords(plan.frameMs)} a frame on ${plan.device}` : "not measured";
  document.getElementById("summary").textContent =
      `${plan.width} × ${plan.height} · ${running} passes · heap ${bytesInWords(plan.heapBytes)} and ` +
      `${bytesInWords(ownBytes)} of own memory · ` +
      `${plan.barriers} barriers in ${plan.barrierBatches} batches · ${time}`;
}

function start() {
  showTitle();
  drawGraph();
  startView();
  startFilters();
  drawBarriers();
  drawNodeTable();
  makeHelp();
  startTabs();
  startSplitter();
  document.getElementById("zoom-in").addEventListener("click", () => zoomAt(1.25));
  document.getElementById("zoom-out").addEventListener("click", () => zoomAt(0.8));
  document.getElementById("fit").addEventListener("click", fit);
  document.getElementById("help-button").addEventListener("click", toggleHelp);
  addEventListener("keydown", onKey);
  openTab("timeline");
  select(null);
  openView();
  // After the frame that first shows it: how long a reader waits.
  requestAnimationFrame(() => setTimeout(() => {
    document.documentElement.dataset.readyMs = performance.now().toFixed(0);
  }));
}

start();
