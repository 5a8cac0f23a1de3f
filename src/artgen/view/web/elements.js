// Used by all pages: elements, and the data inside a page.

/** Returns an element with properties and children. */
function element(tag, properties = {}, ...children) {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...children);
  return made;
}

/** Returns the bytes that a script element of the page holds. */
async function unpacked(id) {
  const script = document.getElementById(id);
  const text = atob(script.textContent);
  const bytes = new Uint8Array(text.length);
  for (let place = 0; place < text.length; place += 1) bytes[place] = text.charCodeAt(place);
  script.remove();
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Response(stream).arrayBuffer();
}

/** Returns the text that a script element of the page holds. */
async function unpackedText(id) {
  return new TextDecoder().decode(await unpacked(id));
}
