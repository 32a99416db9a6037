// The barriers, batch by batch, and the table of nodes.

function cell(...content) {
  return element("td", {}, ...content);
}

function barrierRow(barrier) {
  const resource = plan.resources[barrier.resource];
  const layout = barrier.oldLayout === undefined ? "buffer"
      : barrier.oldLayout === barrier.newLayout ? `stays ${barrier.newLayout}`
      : `${barrier.oldLayout} → ${barrier.newLayout}`;
  const name = element("button", {className: "link"}, resource.name);
  name.addEventListener("click", () => selectResource(barrier.resource));
  const row = element("tr", {}, cell(name, barrier.part ? ` (${barrier.part})` : ""),
      cell(`${barrier.from || "nothing"} → ${barrier.to}`), cell(layout), cell(barrier.why));
  row.dataset.resource = barrier.resource;
  return row;
}

function batchHead(batch, number) {
  const head = element("th", {colSpan: 4, scope: "rowgroup"}, `Batch ${number} `);
  if (batch.pass === null) head.append("before the outputs are copied");
  else head.append("before pass ", link(passNodes[batch.pass], `${batch.pass} ${passNodes[batch.pass].name}`));
  if (batch.point) head.append(`, ${batch.point}`);
  return element("tr", {className: "batch"}, head);
}

function drawBarriers() {
  const table = element("table", {}, element("thead", {}, element("tr", {},
      ...["Resource", "From use → to use", "Layout", "Why"].map((title) => element("th", {scope: "col"}, title)))));
  plan.batches.forEach((batch, number) => {
    const body = element("tbody", {}, batchHead(batch, number), ...batch.barriers.map(barrierRow));
    if (batch.pass !== null) body.dataset.node = passNodes[batch.pass].index;
    table.append(body);
  });
  document.getElementById("barriers").append(table);
}

/** Rows on what the selected node reads or writes, and the batches before it. */
function markBarriers() {
  const node = selection.node;
  for (const row of document.querySelectorAll("#barriers tr[data-resource]")) {
    const resource = plan.resources[row.dataset.resource];
    const touches = node !== null && [...resource.writers, ...resource.readers].includes(node.index);
    row.classList.toggle("marked", Number(row.dataset.resource) === selection.resource);
    row.classList.toggle("dimmed", node !== null && !touches);
  }
  for (const body of document.querySelectorAll("#barriers tbody"))
    body.classList.toggle("marked", node !== null && body.dataset.node === String(node.index));
  document.querySelector("#barriers .marked")?.scrollIntoView({block: "nearest"});
}

const columns = [
  {title: "Pass", value: (node) => node.pass ?? Infinity, text: (node) => node.pass ?? ""},
  {title: "Node", value: (node) => node.name},
  {title: "State", value: (node) => states[node.state]},
  {title: "Why", value: (node) => node.why},
  {title: "GPU", value: (node) => -(node.gpuMs ?? -1), text: (node) => node.gpuMs === undefined ? "" : msInWords(node.gpuMs)},
  {title: "Memory", value: (node) => -(node.bytes ?? -1), text: (node) => node.bytes === undefined ? "" : bytesInWords(node.bytes)},
];

function nodeRow(node) {
  const row = element("tr", {dataset: {node: node.index}});
  for (const column of columns) {
    const text = String((column.text ?? column.value)(node));
    row.append(cell(column.title === "Node" ? link(node) : text));
  }
  return row;
}

function drawNodeTable() {
  const body = element("tbody");
  const sortBy = (column) => {
    const order = (a, b) => {
      const [x, y] = [column.value(a), column.value(b)];
      return x < y ? -1 : x > y ? 1 : a.index - b.index;
    };
    body.replaceChildren(...nodes.filter((node) => node.state !== "output").sort(order).map(nodeRow));
    applyFilters();
  };
  const heads = columns.map((column) => {
    const button = element("button", {className: "link", title: "Sort"}, column.title);
    button.addEventListener("click", () => sortBy(column));
    return element("th", {scope: "col"}, button);
  });
  document.getElementById("passes").append(
      element("table", {}, element("thead", {}, element("tr", {}, ...heads)), body));
  sortBy(columns[0]);
}

function markNodeTable() {
  for (const row of document.querySelectorAll("#passes tr[data-node]"))
    row.classList.toggle("marked", selection.node !== null && row.dataset.node === String(selection.node.index));
  document.querySelector("#passes .marked")?.scrollIntoView({block: "nearest"});
}
