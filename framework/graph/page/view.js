// Pan, zoom and the small overview. What would be too small to read gives way to names that are not.

const graph = document.getElementById("graph");
const overview = document.getElementById("overview");
const view = {x: 0, y: 0, zoom: 1};
const zoomRange = [0.02, 4];
// From which zoom on there is room for ports and labels, for times, and for names.
const zoomFor = {ports: 0.85, times: 0.55, names: 0.42};
const margin = 20;

function detailAt(zoom) {
  return zoom >= zoomFor.ports ? "near" : zoom >= zoomFor.times ? "middle" : zoom >= zoomFor.names ? "far" : "outline";
}

function applyView() {
  plane.style.transform = `translate(${view.x}px, ${view.y}px) scale(${view.zoom})`;
  const detail = detailAt(view.zoom);
  if (view.zoom !== view.drawnZoom) {
    view.drawnZoom = view.zoom;
    plane.className = detail;
    plane.style.setProperty("--sub-size", `${Math.max(11, 10.5 / view.zoom)}px`);
    plane.style.setProperty("--pixel", `${1 / view.zoom}px`);
    if (detail !== "outline") fitNames(view.zoom, detail === "near");
  }
  drawOverview();
}

/** Zooms by a factor so that the point (x, y) of the graph's area stays where it is. */
function zoomAt(factor, x = graph.clientWidth / 2, y = graph.clientHeight / 2) {
  const zoom = Math.min(Math.max(view.zoom * factor, zoomRange[0]), zoomRange[1]);
  view.x = x - (x - view.x) * zoom / view.zoom;
  view.y = y - (y - view.y) * zoom / view.zoom;
  view.zoom = zoom;
  applyView();
}

function shownNodes() {
  return nodes.filter((node) => !node.element.classList.contains("hidden"));
}

/** The whole of what is shown, as large as it fits. */
function fit() {
  const shown = shownNodes();
  if (shown.length === 0) return;
  const boxes = shown.map(({box}) => box);
  if (shown.length === nodes.length) boxes.push([0, 0, plan.drawing.width, plan.drawing.height]);  // edges too
  const left = Math.min(...boxes.map((box) => box[0]));
  const top = Math.min(...boxes.map((box) => box[1]));
  const width = Math.max(...boxes.map((box) => box[0] + box[2])) - left;
  const height = Math.max(...boxes.map((box) => box[1] + box[3])) - top;
  const zoom = Math.min((graph.clientWidth - 2 * margin) / width, (graph.clientHeight - 2 * margin) / height);
  view.zoom = Math.min(Math.max(zoom, zoomRange[0]), 1.5);
  view.x = (graph.clientWidth - width * view.zoom) / 2 - left * view.zoom;
  view.y = (graph.clientHeight - height * view.zoom) / 2 - top * view.zoom;
  applyView();
}

/** All of it if its names can be read then; else where it starts, with names, and the overview for the rest. */
function openView() {
  fit();
  if (view.zoom >= zoomFor.names) return;
  const first = nodes.find((node) => node.pass === 0) ?? nodes[0];
  view.zoom = zoomFor.times;
  const within = (start, extent, room) => Math.min(Math.max(start, room - extent - margin), margin);
  view.x = within(graph.clientWidth / 3 - first.box[0] * view.zoom, plan.drawing.width * view.zoom, graph.clientWidth);
  view.y = within(graph.clientHeight / 2 - (first.box[1] + first.box[3] / 2) * view.zoom,
      plan.drawing.height * view.zoom, graph.clientHeight);
  applyView();
}

/** Brings a node into view; zooms in where its name could not be read. */
function reveal(node) {
  if (view.zoom < zoomFor.names) view.zoom = zoomFor.times;
  const [x, y, width, height] = node.box;
  const left = x * view.zoom + view.x;
  const top = y * view.zoom + view.y;
  const isInside = left >= 0 && top >= 0 && left + width * view.zoom <= graph.clientWidth &&
      top + height * view.zoom <= graph.clientHeight;
  if (!isInside) {
    view.x = graph.clientWidth / 2 - (x + width / 2) * view.zoom;
    view.y = graph.clientHeight / 2 - (y + height / 2) * view.zoom;
  }
  applyView();
}

function overviewScale() {
  return Math.min(overview.width / plan.drawing.width, overview.height / plan.drawing.height);
}

function drawOverview() {
  const isNeeded = plan.drawing.width * view.zoom > graph.clientWidth ||
      plan.drawing.height * view.zoom > graph.clientHeight;
  overview.classList.toggle("hidden", !isNeeded);
  if (!isNeeded) return;
  const scale = overviewScale();
  const pen = overview.getContext("2d");
  const colors = getComputedStyle(document.documentElement);
  pen.clearRect(0, 0, overview.width, overview.height);
  for (const node of shownNodes()) {
    const [x, y, width, height] = node.box.map((length) => length * scale);
    const isMarked = ["selected", "needed", "fed"].some((mark) => node.element.classList.contains(mark));
    pen.fillStyle = colors.getPropertyValue(isMarked ? "--accent" : `--${node.state}-line`);
    pen.fillRect(x, y, Math.max(width, 2), Math.max(height, 2));
  }
  pen.strokeStyle = colors.getPropertyValue("--text");
  pen.strokeRect(-view.x / view.zoom * scale, -view.y / view.zoom * scale,
      graph.clientWidth / view.zoom * scale, graph.clientHeight / view.zoom * scale);
}

/** Calls move(dx, dy, event) while the pointer, pressed on `target`, is dragged. */
function onDrag(target, move) {
  target.addEventListener("pointerdown", (event) => {
    if (event.button !== 0 || event.target.closest(".node")) return;
    const stop = new AbortController();
    let [x, y] = [event.clientX, event.clientY];
    target.classList.add("dragged");
    addEventListener("pointermove", (moved) => {
      move(moved.clientX - x, moved.clientY - y, moved);
      [x, y] = [moved.clientX, moved.clientY];
    }, stop);
    addEventListener("pointerup", () => {
      target.classList.remove("dragged");
      stop.abort();
    }, stop);
  });
}

function pan(dx, dy) {
  view.x += dx;
  view.y += dy;
  applyView();
}

function lookAt(event) {
  const area = overview.getBoundingClientRect();
  const scale = overviewScale();
  view.x = graph.clientWidth / 2 - (event.clientX - area.left) / scale * view.zoom;
  view.y = graph.clientHeight / 2 - (event.clientY - area.top) / scale * view.zoom;
  applyView();
}

function startView() {
  // As large as it may be in the drawing's shape.
  const scale = overviewScale();
  [overview.width, overview.height] = [plan.drawing.width * scale, plan.drawing.height * scale].map(Math.ceil);
  onDrag(graph, (dx, dy, event) => event.target !== overview && pan(dx, dy));
  onDrag(overview, (dx, dy, event) => lookAt(event));
  overview.addEventListener("pointerdown", lookAt);
  graph.addEventListener("wheel", (event) => {
    event.preventDefault();
    const area = graph.getBoundingClientRect();
    zoomAt(Math.exp(-event.deltaY * (event.ctrlKey ? 0.01 : 0.0015)), event.clientX - area.left,
        event.clientY - area.top);
  }, {passive: false});
  graph.addEventListener("dblclick", (event) => event.target.closest(".node") || fit());
  new ResizeObserver(drawOverview).observe(graph);
}
