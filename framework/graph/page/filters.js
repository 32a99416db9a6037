// Which nodes are shown, and which are found by name.

const filters = {hiddenStates: new Set(), slow: document.getElementById("slow"), share: document.getElementById("slow-share")};
const search = document.getElementById("search");

function isSlow(node) {
  return node.gpuMs !== undefined && 100 * shareOf(node) >= Number(filters.share.value);
}

function isShown(node) {
  return !filters.hiddenStates.has(node.state) && (!filters.slow.checked || isSlow(node));
}

function applyFilters() {
  for (const node of nodes) node.element.classList.toggle("hidden", !isShown(node));
  for (const edge of plan.edges)
    edge.element.classList.toggle("hidden", !isShown(nodes[edge.from]) || !isShown(nodes[edge.to]));
  for (const row of document.querySelectorAll("#passes tr[data-node]")) row.hidden = !isShown(nodes[row.dataset.node]);
  document.getElementById("slow-count").textContent = isMeasured ? `(${nodes.filter(isSlow).length})` : "";
  drawOverview();
}

function makeStateChip(state) {
  const count = nodes.filter((node) => node.state === state).length;
  const button = element("button", {className: `chip ${state}`, title: `Show or hide what is ${states[state]}`},
      element("span", {className: "swatch"}), states[state], element("span", {className: "count"}, String(count)));
  button.dataset.state = state;
  button.setAttribute("aria-pressed", "true");
  button.disabled = count === 0;
  button.addEventListener("click", () => {
    const isHidden = !filters.hiddenStates.delete(state);
    if (isHidden) filters.hiddenStates.add(state);
    button.setAttribute("aria-pressed", String(!isHidden));
    applyFilters();
  });
  document.getElementById("filters").append(button);
}

/** Marks what is found and says how many; the others are dimmed while something is typed. */
function applySearch() {
  const query = search.value.trim().toLowerCase();
  const found = query === "" ? [] : nodes.filter((node) => isShown(node) && node.name.toLowerCase().includes(query));
  for (const node of nodes) node.element.classList.toggle("found", found.includes(node));
  plane.parentElement.classList.toggle("searching", query !== "");
  document.getElementById("found").textContent = query === "" ? "" : `${found.length} found`;
  return found;
}

/** The next one found after the selected one, and round again. */
function goToFound(step) {
  const found = applySearch();
  if (found.length === 0) return;
  const at = found.indexOf(selection.node);
  const next = at < 0 ? (step > 0 ? 0 : found.length - 1) : (at + step + found.length) % found.length;
  select(found[next], {reveal: true});
}

function startFilters() {
  for (const state of ["run", "kept", "skipped", "culled"]) makeStateChip(state);
  const chip = document.getElementById("slow-chip");
  chip.title = isMeasured ? "Show only passes that take this share of all passes' GPU time" : plan.note;
  for (const input of [filters.slow, filters.share]) {
    input.disabled = !isMeasured;
    input.addEventListener("input", applyFilters);
  }
  chip.classList.toggle("disabled", !isMeasured);
  search.addEventListener("input", applySearch);
  search.addEventListener("keydown", (event) => {
    if (event.key === "Enter") goToFound(event.shiftKey ? -1 : 1);
  });
}
