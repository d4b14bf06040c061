// SPDX-License-Identifier: BSD-3-Clause
// A block of compressed numbers in the page: base64 of zlib-compressed bytes in a <script type="text/plain">.

/** What went wrong with a block, in words for the reader of the page. */
export class BlockError extends Error {}

const BROWSERS = "Chrome or Edge 80, Firefox 113, Safari 16.4, or any newer one";

/** The bytes of the block with this id. */
export async function read_block(id: string): Promise<Uint8Array> {
  if (typeof DecompressionStream === "undefined") {
    throw new BlockError(`This browser cannot unpack the film (it has no DecompressionStream). Open the page with ${BROWSERS}.`);
  }
  const text = document.getElementById(id)?.textContent;
  if (text === undefined || text === null) throw damaged(id, "it is missing from the page");
  try {
    return await inflate(from_base64(text));
  } catch (error) {
    throw damaged(id, error instanceof Error && error.message ? error.message : "it does not unpack");
  }
}

/** The error of a block whose content is not what the film says. */
export function damaged(id: string, why: string): BlockError {
  return new BlockError(`A part of this film is damaged (block ${id}: ${why}). Write the page again with berm report.`);
}

function from_base64(text: string): Uint8Array<ArrayBuffer> {
  const letters = atob(text.trim());
  const bytes = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; i++) bytes[i] = letters.charCodeAt(i);
  return bytes;
}

async function inflate(packed: Uint8Array<ArrayBuffer>): Promise<Uint8Array> {
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}
