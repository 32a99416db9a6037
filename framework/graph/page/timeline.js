// Lifetimes over the heap: passes from left to right, bytes from top to bottom, a box a resource. What has memory of
// its own stands below in rows.

const timeline = document.getElementById("timeline");
const axisWidth = 86;
const headHeight = 34;
const rowHeight = 15;

/** 1, 2 or 4 times a power of 16 bytes or so: about six steps of the heap. */
function byteStep(bytes) {
  let step = 1;
  while (bytes / step > 7) step *= 2;
  return step;
}

function isLiving(resource) {
  return resource.first !== undefined;
}

function boxOf(index, x, y, width, height) {
  const resource = plan.resources[index];
  const group = svgElement("g", {class: "life", style: `--hue: ${Math.round((resource.writers[0] ?? index) * 137.5) % 360}`});
  group.dataset.resource = index;
  group.append(svgElement("rect", {x, y, width: Math.max(width, 1), height: Math.max(height, 1)}),
      svgElement("title", {}, `${resource.name}: ${resource.format} ${resource.size}, ${bytesInWords(resource.bytes)}, ` +
          `${resource.place}, passes ${resource.first} to ${resource.last}`));
  const letters = Math.floor((width - 6) / 6.2);
  if (height >= 11 && letters >= 3) {
    const text = resource.name.length <= letters ? resource.name : `${resource.name.slice(0, letters - 1)}…`;
    group.append(svgElement("text", {x: x + 3, y: y + Math.min(height / 2 + 4, 13)}, text));
  }
  group.addEventListener("click", () => selectResource(index));
  return group;
}

function drawPassHeads(svg, column, height) {
  const every = column >= 18 ? 1 : Math.ceil(30 / column);
  passNodes.forEach((node, pass) => {
    const x = axisWidth + pass * column;
    const head = svgElement("g", {class: "pass-head"});
    head.dataset.node = node.index;
    head.append(svgElement("rect", {x, y: 0, width: column, height, class: "column"}),
        svgElement("title", {}, `pass ${pass}: ${node.name}`));
    if (pass % every === 0) {
      const letters = Math.floor((column - 4) / 6);
      head.append(svgElement("text", {x: x + 2, y: 12}, pass));
      if (letters >= 4)
        head.append(svgElement("text", {x: x + 2, y: 26, class: "faint"},
            node.name.length <= letters ? node.name : `${node.name.slice(0, letters - 1)}…`));
    }
    head.addEventListener("click", () => select(node, {reveal: true}));
    svg.append(head);
  });
}

function drawHeap(svg, column, top, height) {
  const scale = height / plan.heapBytes;
  const step = byteStep(plan.heapBytes);
  for (let at = 0; at <= plan.heapBytes; at += step) {
    const y = top + at * scale;
    svg.append(svgElement("line", {x1: axisWidth, x2: axisWidth + passNodes.length * column, y1: y, y2: y, class: "grid"}),
        svgElement("text", {x: axisWidth - 6, y: y + 4, class: "axis"}, bytesInWords(at)));
  }
  plan.resources.forEach((resource, index) => {
    if (resource.offset === undefined || !isLiving(resource)) return;
    svg.append(boxOf(index, axisWidth + resource.first * column, top + resource.offset * scale,
        (resource.last - resource.first + 1) * column, resource.bytes * scale));
  });
}

function drawOwnMemory(svg, column, top, resources) {
  svg.append(svgElement("text", {x: axisWidth - 6, y: top + 11, class: "axis"}, "own memory"));
  resources.forEach((index, row) => {
    const resource = plan.resources[index];
    svg.append(boxOf(index, axisWidth + resource.first * column, top + row * rowHeight,
        (resource.last - resource.first + 1) * column, rowHeight - 2));
  });
}

function drawTimeline() {
  timeline.replaceChildren();
  if (timeline.hidden || timeline.clientWidth === 0) return;
  const own = plan.resources.map((resource, index) => index)
      .filter((index) => plan.resources[index].offset === undefined && isLiving(plan.resources[index]));
  const room = timeline.clientWidth - axisWidth - 24;
  const column = Math.max(room / Math.max(passNodes.length, 1), 5);
  const ownHeight = own.length === 0 ? 0 : own.length * rowHeight + 10;
  const heapHeight = plan.heapBytes === 0 ? 0 : Math.max(timeline.clientHeight - headHeight - ownHeight - 18, 140);
  const height = headHeight + heapHeight + ownHeight + 10;
  const svg = svgElement("svg", {width: axisWidth + passNodes.length * column + 8, height});
  drawPassHeads(svg, column, height);
  if (heapHeight > 0) drawHeap(svg, column, headHeight, heapHeight);
  if (own.length > 0) drawOwnMemory(svg, column, headHeight + heapHeight + 10, own);
  timeline.append(svg);
  markTimeline();
}

/** What the selected node writes and reads, and its column. */
function markTimeline() {
  const node = selection.node;
  const indexIn = (list) => node !== null && list.includes(node.index);
  for (const box of timeline.querySelectorAll(".life")) {
    const resource = plan.resources[box.dataset.resource];
    const isChosen = Number(box.dataset.resource) === selection.resource;
    box.classList.toggle("written", indexIn(resource.writers) || isChosen);
    box.classList.toggle("read", indexIn(resource.readers));
    box.classList.toggle("dimmed", node !== null && !indexIn(resource.writers) && !indexIn(resource.readers));
  }
  for (const head of timeline.querySelectorAll(".pass-head"))
    head.classList.toggle("selected", node !== null && Number(head.dataset.node) === node.index);
}
