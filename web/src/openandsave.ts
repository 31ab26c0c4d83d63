// The tools in the header: examples and files in, links out.
import { h } from "./dom";
import type { Scene } from "./engine";

export interface Example {
  title: string;
  scene: Scene;
}

export interface OpenHost {
  open(example: Example): void;
  read(files: File[]): Promise<void>;
  share(): Promise<void>;
}

/** Those that the page brings with it, by their names: none, if it is the viewer's. */
export function pageExamples(): Record<string, Example> {
  return JSON.parse(document.getElementById("taut-examples")?.textContent ?? "{}") as Record<string, Example>;
}

export function headerTools(examples: Record<string, Example>, host: OpenHost): HTMLElement[] {
  const button = (id: string, label: string, title: string, action: () => void): HTMLButtonElement =>
    h("button", { type: "button", id, title, onclick: action }, label);
  return [
    ...(Object.keys(examples).length > 0 ? [exampleSelect(examples, host)] : []),
    fileButton(host),
    button("share", "Copy link", "A link with the whole scene in it", () => void host.share()),
  ];
}

function exampleSelect(examples: Record<string, Example>, host: OpenHost): HTMLElement {
  const select = h(
    "select",
    {
      id: "example",
      "aria-label": "Example",
      onchange: () => {
        const example = examples[select.value];
        if (example) host.open(example);
        select.value = "";
      },
    },
    h("option", { value: "" }, "Examples"),
    ...Object.entries(examples).map(([name, { title }]) => h("option", { value: name }, title)),
  );
  return select;
}

function fileButton(host: OpenHost): HTMLElement {
  const file = h("input", {
    type: "file",
    id: "file",
    multiple: true,
    class: "hidden",
    accept: ".json,.wkt,.geojson,.txt,.svg,.dxf,.kicad_pcb",
    onchange: () => void host.read([...(file.files ?? [])]).then(() => (file.value = "")),
  });
  const title =
    "A scene, a drawing (SVG, DXF, KiCad), or an outline in WKT or GeoJSON for the chosen body. Files can be dropped on the page, too.";
  return h("label", { class: "button", for: "file", title }, "Open", file);
}

/** Files dropped on the element are read like those that are opened. */
export function acceptDrops(element: HTMLElement, host: OpenHost): void {
  element.addEventListener("dragover", (e) => e.preventDefault());
  element.addEventListener("drop", (e) => {
    e.preventDefault();
    void host.read([...(e.dataTransfer?.files ?? [])]);
  });
}
