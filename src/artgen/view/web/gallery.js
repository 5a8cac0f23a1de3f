// The gallery: cards of assets, and filters that hide some of them.

const find = (id) => document.getElementById(id);

function options(select, names, first) {
  select.append(element("option", { value: "" }, first), ...names.map((name) => element("option", { value: name }, name)));
}

const PROOFS = { true: ["good", "proven"], false: ["bad", "not proven"], null: ["", "not certified"] };

function card(asset) {
  const [state, verdict] = PROOFS[asset.proven];
  const pictures = element("div", { className: "picture" });
  pictures.append(element("img", { src: asset.closed, alt: asset.name, loading: "lazy" }));
  if (asset.open) pictures.append(element("img", { src: asset.open, alt: "", className: "open", loading: "lazy" }));
  const count = asset.joints.length;
  const mass = asset.mass < 1 ? `${(1000 * asset.mass).toFixed(0)} g` : `${asset.mass.toPrecision(3)} kg`;
  const facts = `${count} joint${count === 1 ? "" : "s"} · ${mass}`;
  const made = element(
    "a",
    { className: "card", href: asset.page, title: asset.features },
    pictures,
    element(
      "div",
      { className: "text" },
      element("b", {}, element("i", { className: state, title: verdict }), asset.name),
      element("small", { className: "features" }, asset.features),
      element("small", {}, facts),
    ),
  );
  made.dataset.name = asset.name;
  return made;
}

/** Returns the text of an asset for the search. */
function searchText({ name, features, parameters }) {
  return [name, features, ...Object.values(parameters)].join(" ").toLowerCase();
}

class Gallery {
  constructor(assets) {
    this.assets = assets.map((asset) => ({ ...asset, card: card(asset), text: searchText(asset) }));
    const unique = (values) => [...new Set(values)].sort();
    options(find("category"), unique(assets.map((asset) => asset.category)), "all categories");
    options(find("parameter"), unique(assets.flatMap((asset) => Object.keys(asset.parameters))), "any parameters");
    find("parameter").addEventListener("change", () => this.showValues());
    find("filters").addEventListener("input", () => this.update());
    find("clear").addEventListener("click", () => this.clear());
    this.update();
  }

  /** Shows fields for the values of the selected parameter: a range for numbers, else a menu. */
  showValues() {
    const name = find("parameter").value;
    const values = this.assets.filter((asset) => name in asset.parameters).map((asset) => asset.parameters[name]);
    const fields = find("values");
    if (!name) fields.replaceChildren();
    else if (values.every((value) => typeof value === "number")) {
      const field = (id, value, label) => {
        const input = element("input", { id, type: "number", step: "any", placeholder: Number(value.toPrecision(4)) });
        input.setAttribute("aria-label", label);
        return input;
      };
      fields.replaceChildren(field("from", Math.min(...values), "from"), "to", field("to", Math.max(...values), "to"));
    } else {
      const select = element("select", { id: "value" });
      options(select, [...new Set(values.map(String))].sort(), "any");
      fields.replaceChildren(select);
    }
    this.update();
  }

  matches(asset) {
    const searched = find("search").value.trim().toLowerCase().split(/\s+/);
    if (!searched.every((word) => asset.text.includes(word))) return false;
    if (find("category").value && asset.category !== find("category").value) return false;
    if (find("joint").value && !asset.joints.includes(find("joint").value)) return false;
    const name = find("parameter").value;
    if (!name) return true;
    if (!(name in asset.parameters)) return false;
    const value = asset.parameters[name];
    const [from, to, one] = ["from", "to", "value"].map((id) => find(id)?.value ?? "");
    return (!from || value >= Number(from)) && (!to || value <= Number(to)) && (!one || String(value) === one);
  }

  update() {
    const order = find("order").value;
    const key = { mass: (asset) => asset.mass, count: (asset) => asset.joints.length }[order];
    const shown = this.assets.filter((asset) => this.matches(asset));
    if (key) shown.sort((one, other) => key(one) - key(other));
    find("cards").replaceChildren(...shown.map((asset) => asset.card));
    const of = shown.length === this.assets.length ? "" : ` of ${this.assets.length}`;
    find("count").textContent = `${shown.length}${of} assets`;
    find("none").hidden = shown.length > 0;
  }

  clear() {
    for (const id of ["search", "category", "joint", "parameter"]) find(id).value = "";
    this.showValues();
  }
}

new Gallery(JSON.parse(await unpackedText("data")));
