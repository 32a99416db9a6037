// The names in the nodes: never smaller than can be read, and whole or with their middle left out.

const nameSize = {usual: 13, leastOnScreen: 11.5};
const roomBesideName = 20;  // padding and borders
const pen = document.createElement("canvas").getContext("2d");
pen.font = `600 100px ${getComputedStyle(document.body).fontFamily}`;

/** Width of a name's text at a size of letters. */
function widthOf(text, size) {
  return pen.measureText(text).width * size / 100;
}

/** The text with as much of its middle left out as makes it fit. */
function withoutMiddle(text, width, size) {
  for (let kept = text.length - 1; kept > 1; --kept) {
    const shorter = `${text.slice(0, Math.ceil(kept / 2))}…${text.slice(text.length - Math.floor(kept / 2))}`;
    if (widthOf(shorter, size) <= width) return shorter;
  }
  return "…";
}

/** The name on one line; or on as many as may be, broken after its parts only; or without its middle. */
function fittingName(name, width, size, mostLines) {
  if (widthOf(name, size) <= width) return name;
  const lines = [""];
  for (const part of name.split(/(?<=[-_. (])/)) {
    if (widthOf(lines.at(-1) + part, size) > width && lines.at(-1) !== "") lines.push("");
    lines[lines.length - 1] += part;
  }
  const fits = lines.length <= mostLines && lines.every((line) => widthOf(line, size) <= width);
  return fits ? lines.join("\n") : withoutMiddle(name, width, size);
}

/** Writes the names for a zoom. Where ports are shown they take one line, else two if their boxes are high enough. */
function fitNames(zoom, showsPorts) {
  const size = Math.max(nameSize.usual, nameSize.leastOnScreen / zoom);
  plane.style.setProperty("--name-size", `${size}px`);
  for (const node of nodes) {
    const [, , width, height] = node.box;
    const lines = showsPorts || height < 4 * size ? 1 : 2;
    node.nameElement.textContent = fittingName(node.name, width - roomBesideName, size, lines);
  }
}
