// What there is to know of the selected node, or of the whole plan.

const details = document.getElementById("details");

function definition(term, ...words) {
  return [element("dt", {}, term), element("dd", {}, ...words)];
}

function link(node, text = node.name) {
  const button = element("button", {className: "link"}, text);
  button.addEventListener("click", () => select(node, {reveal: true}));
  return button;
}

function separated(elements) {
  return elements.flatMap((made, i) => i === 0 ? [made] : [", ", made]);
}

function inputLine(node, input, row) {
  const edge = edgesInto[node.index].find((into) => into.input === row);
  const resource = plan.resources[input.resource];
  const line = element("li", {title: input.doc ?? ""}, element("b", {}, input.name), " ");
  if (resource) {
    line.append("← ", edge ? link(nodes[edge.from], resource.name) : resource.name,
        element("span", {className: "faint"}, ` ${resource.format} ${resource.size}`));
  } else {
    line.append(input.source ? `← ${input.source}` : "unconnected");
    if (input.constant !== undefined)
      line.append(`${input.source ? ", which gives nothing" : ""}: reads ${input.constant}`);
  }
  if (input.detail) line.append(`, ${input.detail}`);
  return line;
}

/** "first of 2 layers": what of an image its picture shows. */
function partShown(resource) {
  const parts = [];
  if (resource.layers > 1) parts.push(`${resource.layers} layers`);
  if (resource.mips > 1) parts.push(`${resource.mips} mips`);
  return parts.length === 0 ? "" : `first of ${parts.join(", ")}; `;
}

function outputItem(node, output, row) {
  const resource = plan.resources[output.resource];
  const readers = edgesFrom[node.index].filter((edge) => edge.output === row).map((edge) => nodes[edge.to]);
  const item = element("li", {title: output.doc ?? ""}, element("b", {}, output.name), " ",
      element("span", {className: "faint"}, resource ? `${resource.format} ${resource.size}` : output.format));
  if (resource) {
    const life = resource.first === undefined ? "" : `, passes ${resource.first} to ${resource.last}`;
    item.append(element("div", {className: "faint"}, `${bytesInWords(resource.bytes)}, ${resource.place}${life}`));
  }
  if (readers.length > 0) item.append(element("div", {}, "→ ", ...separated(readers.map((reader) => link(reader)))));
  if (output.picture) {
    item.append(element("figure", {}, pictureOf(output, "picture"),
        element("figcaption", {className: "faint"}, partShown(resource) + output.scale)));
  }
  if (resource && output.resource === selection.resource) item.className = "chosen";
  return item;
}

function figuresOf(node) {
  const list = element("dl");
  if (node.pass !== undefined) list.append(...definition("pass", `${node.pass} of ${passNodes.length}`));
  if (node.iterations > 1) list.append(...definition("iterations", `${node.iterations}`));
  if (node.gpuMs !== undefined) {
    list.append(...definition("GPU time", `${msInWords(node.gpuMs)}, ${(100 * shareOf(node)).toFixed(1)} % of all passes`),
        ...definition("recording", msInWords(node.cpuMs)));
    if (node.rests) list.append(...definition("at rest", "it does not run in a frame in which nothing has changed"));
  }
  if (node.bytes !== undefined) list.append(...definition("memory", `${bytesInWords(node.bytes)} for its outputs`));
  if (node.pass !== undefined || !doesRun(node)) {
    list.append(...definition("needs", `${reach(node, true).size} nodes`),
        ...definition("feeds", `${reach(node, false).size} nodes`));
  }
  return list;
}

function showNode(node) {
  const close = element("button", {className: "close", title: "Close ( Esc )", ariaLabel: "Close"}, "×");
  close.addEventListener("click", () => select(null));
  details.append(close, element("h2", {}, node.name),
      element("p", {}, element("span", {className: `badge ${node.state}`}, states[node.state]),
          ` ${node.kind ?? ""} ${node.type}`),
      element("p", {}, node.state === "output" ? node.why : `${states[node.state].split(",")[0]}: ${node.why}.`));
  if (node.doc) details.append(element("p", {className: "faint"}, node.doc));
  details.append(figuresOf(node));
  if (node.inputs.length > 0)
    details.append(element("h3", {}, "Reads"),
        element("ul", {}, ...node.inputs.map((input, row) => inputLine(node, input, row))));
  if (node.outputs.length > 0)
    details.append(element("h3", {}, "Writes"),
        element("ul", {}, ...node.outputs.map((output, row) => outputItem(node, output, row))));
  if (node.words.length > 0)
    details.append(element("h3", {}, "Why so"), element("ul", {}, ...node.words.map((line) => element("li", {}, line))));
}

function showPlan() {
  const list = element("dl");
  list.append(...definition("picture", `${plan.width} × ${plan.height}`),
      ...definition("ordered for", plan.policy),
      ...definition("heap", `${bytesInWords(plan.heapBytes)}; at most ${bytesInWords(plan.peakLiveBytes)} in use at once`),
      ...definition("own memory", `${bytesInWords(ownBytes)} for results kept over frames and images from outside`),
      ...definition("apart", `${bytesInWords(plan.naiveBytes)} if nothing shared memory`),
      ...definition("barriers", `${plan.barriers} in ${plan.barrierBatches} batches; one a use would be ${plan.naiveBarriers}`));
  if (isMeasured) {
    list.append(...definition("frame", `${msInWords(plan.frameMs)}, each pass timed alone; passes ${msInWords(passMsTotal)}`),
        ...definition("measured", `median of ${plan.frames} frames`));
  }
  if (plan.device) list.append(...definition("device", plan.device));
  details.append(element("h2", {}, "The plan"), list);
  if (plan.note) details.append(element("p", {className: "note"}, plan.note));
  if (isMeasured) {
    const slowest = nodes.filter((node) => node.gpuMs > 0).sort((a, b) => b.gpuMs - a.gpuMs).slice(0, 8);
    details.append(element("h3", {}, "Slowest passes"), element("ul", {className: "bars"}, ...slowest.map((node) =>
      element("li", {style: {"--share": `${100 * node.gpuMs / slowest[0].gpuMs}%`}}, link(node),
          element("span", {}, ` ${msInWords(node.gpuMs)}`)))));
  }
  details.append(element("p", {className: "faint"}, "Choose a node to see what it needs and what it feeds."));
}

function showDetails() {
  details.replaceChildren();
  details.scrollTop = 0;
  if (selection.node) showNode(selection.node);
  else showPlan();
}
