// The graph: a box a node, placed as the plan's drawing says, over the curves of its edges.

const plane = document.getElementById("plane");
const edgesSvg = document.getElementById("edges");

function curvePath(points) {
  const pairs = [];
  for (let i = 0; i < points.length; i += 2) pairs.push(`${points[i]} ${points[i + 1]}`);
  return `M${pairs[0]}C${pairs.slice(1).join(" ")}`;
}

function drawEdge(edge, labelled) {
  const group = svgElement("g", {class: `edge ${edge.kind}`});
  const from = nodes[edge.from];
  const to = nodes[edge.to];
  const words = `${from.name} → ${to.name}: ${edge.label}${edge.kind === "history" ? ", of an earlier frame" : ""}`;
  const path = curvePath(edge.curve);
  const grip = svgElement("path", {d: path, class: "grip"});
  grip.append(svgElement("title", {}, words));
  grip.addEventListener("click", () => select(doesRun(from) ? from : to));
  group.append(grip, svgElement("path", {d: path, class: "line", "marker-end": "url(#arrow)"}));
  const place = `${edge.from}.${edge.output}`;  // what leaves one port is the same along all of its edges
  if (!labelled.has(place)) {
    labelled.add(place);
    const [x, y] = edge.labelStart;
    group.append(svgElement("text", {x, y, class: "label"}, edge.label));
  }
  edgesSvg.append(group);
  edge.element = group;
}

function pictureOf(output, className) {
  if (!output.picture) return null;
  return element("img", {src: output.picture, alt: "", className, title: `${output.name}: ${output.scale}`});
}

function drawNode(node) {
  const [x, y, width, height] = node.box;
  const time = node.gpuMs === undefined ? "" : msInWords(node.gpuMs);
  const box = element("div", {
    className: `node ${node.state}`,
    tabIndex: 0,
    dataset: {name: node.name},
    style: {left: `${x}px`, top: `${y}px`, width: `${width}px`, height: `${height}px`},
  });
  box.setAttribute("role", "button");
  box.setAttribute("aria-label", `${node.name}: ${states[node.state]}, ${node.why}${time ? `, ${time}` : ""}`);
  box.title = `${node.name}: ${states[node.state]}: ${node.why}`;
  node.nameElement = element("div", {className: "name"});
  box.append(element("div", {className: "head"}, node.nameElement,
      element("div", {className: "sub"},
          element("span", {}, doesRun(node) ? `${node.pass ?? ""} ${node.type}` : `${states[node.state]} ${node.type}`),
          element("span", {className: "time"}, time))));
  const last = node.outputs.findLast((output) => output.picture);
  if (last) box.append(pictureOf(last, "face"));
  if (node.gpuMs !== undefined)
    box.append(element("div", {className: "bar", style: {width: `${100 * shareOf(node)}%`}}));
  if (node.state !== "output") {
    for (const input of node.inputs)
      box.append(element("span", {
        className: `port in${input.resource === undefined ? " empty" : ""}`,
        style: {top: `${input.y}px`},
      }, input.name));
    for (const output of node.outputs)
      box.append(element("span", {className: "port out", style: {top: `${output.y}px`}},
          element("span", {}, output.name), pictureOf(output, "thumbnail")));
  }
  box.addEventListener("click", () => select(node));
  box.addEventListener("keydown", (event) => {
    if (event.key !== "Enter" && event.key !== " ") return;
    event.preventDefault();
    select(node);
  });
  plane.append(box);
  node.element = box;
}

function drawArrow() {
  const marker = svgElement("marker", {
    id: "arrow", viewBox: "0 0 8 8", refX: 8, refY: 4, markerWidth: 7, markerHeight: 7, orient: "auto",
    markerUnits: "userSpaceOnUse",
  });
  marker.append(svgElement("path", {d: "M0 0L8 4L0 8z", class: "head"}));
  const definitions = svgElement("defs");
  definitions.append(marker);
  edgesSvg.append(definitions);
}

function drawGraph() {
  edgesSvg.setAttribute("width", plan.drawing.width);
  edgesSvg.setAttribute("height", plan.drawing.height);
  drawArrow();
  const labelled = new Set();
  for (const edge of plan.edges) drawEdge(edge, labelled);
  nodes.forEach(drawNode);
}
