// SPDX-License-Identifier: BSD-3-Clause
// What the schema of a case (`berm params --json-schema case`) says of a place in its tables.

export interface Schema {
  type?: string | string[];
  title?: string;
  description?: string;
  default?: unknown;
  enum?: string[];
  properties?: Record<string, Schema>;
  required?: string[];
  additionalProperties?: boolean | Schema;
  items?: Schema;
  oneOf?: Schema[];
}

/** The words that the keys of a table have, for those that select others. */
export type Words = ReadonlyMap<string, string>;

/** The keys that such a table has: of alternatives those of the words, and where a word is none of them or is not written yet and has no default, the selector alone. */
export function keys_of(table: Schema, words: Words): Record<string, Schema> {
  if (!table.oneOf) return table.properties ?? {};
  const fits = (one: Schema): boolean =>
    selectors_of(table).every((key) => {
      const word = one.properties?.[key]?.enum?.[0];
      return word === undefined || (words.has(key) ? words.get(key) === word : !one.required?.includes(key));
    });
  const properties = table.oneOf.find(fits)?.properties ?? {};
  const selectors = selectors_of(table).map((key) => [key, selector(table, key)] as const);
  return { ...properties, ...Object.fromEntries(selectors) };
}

/** Keys whose words differ from alternative to alternative. */
function selectors_of(table: Schema): string[] {
  const keys = new Set<string>();
  for (const one of table.oneOf ?? [])
    for (const [key, schema] of Object.entries(one.properties ?? {}))
      if (schema.enum?.length === 1) keys.add(key);
  return [...keys];
}

/** A selector with the words of all alternatives. */
function selector(table: Schema, key: string): Schema {
  const all = (table.oneOf ?? []).flatMap((one) => one.properties?.[key] ?? []);
  return { ...all[0], enum: [...new Set(all.flatMap((one) => one.enum ?? []))] };
}

/** The table below `table` under a key or a name, or the items of an array; none where there is no such table. */
export function below(table: Schema, words: Words, key: string): Schema | undefined {
  const own = keys_of(table, words)[key];
  const found = own ?? (typeof table.additionalProperties === "object" ? table.additionalProperties : undefined);
  return found?.items ?? found;
}

export function is_table(schema: Schema): boolean {
  return schema.type === "object" || schema.items?.type === "object";
}

/** As it is written in a header: "[mesh]", "[material.NAME]", "[[stage]]". */
export function header_of(key: string, schema: Schema): string {
  if (schema.items) return `[[${key}]]`;
  return typeof schema.additionalProperties === "object" ? `[${key}.NAME]` : `[${key}]`;
}

/** What may stand behind "key = ", with "" for what is to be typed. */
export function value_of(schema: Schema): string {
  if (schema.default !== undefined) return JSON.stringify(schema.default);
  if (schema.type === "string") return '""';
  if (schema.type === "array") return "[]";
  if (schema.type === "object") return "{}";
  return "";
}
