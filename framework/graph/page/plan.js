// The plan as the page's JSON gives it, and what follows from it.
"use strict";

const plan = JSON.parse(document.getElementById("data").textContent);
const nodes = plan.nodes;
const passNodes = [];  // by pass: its node
nodes.forEach((node, index) => {
  node.index = index;
  if (node.pass !== undefined) passNodes[node.pass] = node;
});
const isMeasured = plan.frames > 0;
const passMsTotal = nodes.reduce((sum, node) => sum + (node.gpuMs ?? 0), 0);

const ownBytes = plan.resources.reduce((sum, {offset, bytes}) => sum + (offset === undefined ? bytes : 0), 0);

const states = {
  run: "runs",
  kept: "runs, result kept",
  skipped: "skipped",
  culled: "culled",
  import: "from outside",
  output: "output",
};

/** Share of the frame's GPU time, 0 to 1. */
function shareOf(node) {
  return passMsTotal > 0 ? (node.gpuMs ?? 0) / passMsTotal : 0;
}

function doesRun(node) {
  return node.state !== "skipped" && node.state !== "culled";
}

/**
 * Indices of the nodes that `start` needs (backwards) or feeds, through any number of others. Through those that run
 * only what flows in this frame counts; what does not run is followed as the graph declares it.
 */
function reach(start, backwards) {
  const found = new Set();
  const open = [start.index];
  const follow = (edge) => edge.kind !== "history" && (edge.kind !== "off" || !doesRun(start));
  while (open.length > 0) {
    const at = open.pop();
    for (const edge of backwards ? edgesInto[at] : edgesFrom[at]) {
      const next = backwards ? edge.from : edge.to;
      if (!follow(edge) || found.has(next)) continue;
      found.add(next);
      open.push(next);
    }
  }
  found.delete(start.index);
  return found;
}

// Edges that leave one port start alike: the data has those points once.
for (const edge of plan.edges)
  if (edge.along !== undefined) edge.curve.unshift(...plan.edges[edge.along].curve.slice(0, 2 * edge.shared));

const edgesInto = nodes.map(() => []);
const edgesFrom = nodes.map(() => []);
for (const edge of plan.edges) {
  edgesInto[edge.to].push(edge);
  edgesFrom[edge.from].push(edge);
}

function bytesInWords(bytes) {
  const units = ["B", "KiB", "MiB", "GiB", "TiB"];
  let unit = 0;
  for (; bytes >= 1024 && unit + 1 < units.length; ++unit) bytes /= 1024;
  return unit === 0 ? `${bytes} B` : `${bytes.toFixed(bytes < 10 ? 2 : 1)} ${units[unit]}`;
}

function msInWords(ms) {
  return ms >= 100 ? `${ms.toFixed(0)} ms` : ms >= 1 ? `${ms.toFixed(1)} ms` : `${(ms * 1000).toFixed(0)} µs`;
}

/** An element with properties, data-* and children; children that are strings become text, never markup. */
function element(tag, properties = {}, ...children) {
  const made = document.createElement(tag);
  const {style, dataset, ...rest} = properties;
  Object.assign(made, rest);
  Object.assign(made.dataset, dataset);
  for (const [key, value] of Object.entries(style ?? {})) made.style.setProperty(key, value);
  made.append(...children.filter((child) => child !== undefined && child !== null));
  return made;
}

function svgElement(tag, attributes = {}, text = "") {
  const made = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  if (text !== "") made.textContent = text;
  return made;
}
