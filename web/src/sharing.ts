// A scene in the fragment of an address: packed, and written in letters that need no escapes.
import { TautError, type Scene } from "./engine";

export interface Shared {
  scene: Scene;
  touch: "open" | "closed";
}

async function through(bytes: Uint8Array, stream: CompressionStream | DecompressionStream): Promise<Uint8Array> {
  const body = new Blob([bytes as BlobPart])
    .stream()
    .pipeThrough(stream as ReadableWritablePair<Uint8Array, BufferSource>);
  return new Uint8Array(await new Response(body as ReadableStream).arrayBuffer());
}

export async function toFragment(shared: Shared): Promise<string> {
  const bytes = await through(new TextEncoder().encode(JSON.stringify(shared)), new CompressionStream("deflate-raw"));
  let binary = "";
  for (const byte of bytes) binary += String.fromCharCode(byte);
  return "#s=" + btoa(binary).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}

/** Null if the fragment is no shared link. Throws TautError if it is a damaged one. */
export async function fromFragment(fragment: string): Promise<Shared | null> {
  if (!fragment.startsWith("#s=")) return null;
  const shared = await unpacked(fragment).catch(() => null);
  if (typeof shared?.scene === "object" && shared.scene) return shared;
  throw TautError.input("it was cut off or changed on its way", "ask for it again, or for the scene as a file");
}

async function unpacked(fragment: string): Promise<Shared | null> {
  const binary = atob(fragment.slice(3).replaceAll("-", "+").replaceAll("_", "/"));
  const bytes = Uint8Array.from(binary, (c) => c.charCodeAt(0));
  const text = new TextDecoder().decode(await through(bytes, new DecompressionStream("deflate-raw")));
  return JSON.parse(text) as Shared | null;
}

/** Puts a link to it into the address bar and the clipboard; says so. */
export async function shareLink(shared: Shared): Promise<string> {
  history.replaceState(null, "", await toFragment(shared));
  let copied = Boolean(navigator.clipboard);
  await navigator.clipboard?.writeText(location.href).catch(() => (copied = false));
  const size = location.href.length;
  return (
    (copied ? "The link is copied" : "The link is in the address bar") +
    `, ${size} characters` +
    (size > 30000 ? ". Some programs cut links as long as that: save the scene instead." : ".")
  );
}
