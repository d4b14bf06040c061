// SPDX-License-Identifier: BSD-3-Clause
// A case as text whose values a form changes: all else stays as it was written.
import assert from "node:assert/strict";
import { test } from "node:test";
import { CaseText, type Path } from "../src/desk/case_text";
import { element_tests } from "../src/desk/case_view";
import { range_in, with_range, wrong_in } from "../src/desk/ranges";
import { in_unit, quantity_of, spelled, units_of } from "../src/desk/units";

const text = `# A case.
title = "A pipe"   # of steel

[mesh]
kind = "seabed"
near_size = "20 mm"   # <- cells
trench = {depth = "0.5 m", width = "1 m"}

# The soil.
[material.clay]
cohesion = 2000.0

[[stage]]
name = "lay"
until.time = "1 s"

[[stage]]
name = "drag"
`;
const changed = (path: Path, literal: string) => new CaseText(text).with(path, literal);

test("a_value_is_replaced_where_it_stands_and_comments_stay", () => {
  assert.equal(changed(["mesh", "near_size"], '"10 mm"'), text.replace('"20 mm"', '"10 mm"'));
  assert.equal(changed(["title"], '"Another"'), text.replace('"A pipe"', '"Another"'));
  assert.equal(changed(["mesh", "trench", "depth"], "1"), text.replace('"0.5 m"', "1"));
  assert.equal(changed(["stage", 0, "until", "time"], '"2 s"'), text.replace('"1 s"', '"2 s"'));
});

test("a_new_key_goes_to_the_end_of_its_table", () => {
  assert.equal(changed(["mesh", "growth"], "0.2"), text.replace('width = "1 m"}\n', 'width = "1 m"}\ngrowth = 0.2\n'));
  assert.equal(changed(["stage", 0, "until", "force"], "1"), text.replace('until.time = "1 s"\n', 'until.time = "1 s"\nuntil.force = 1\n'));
  assert.equal(changed(["mesh", "trench", "center"], "0"), text.replace('width = "1 m"}', 'width = "1 m", center = 0}'));
  assert.equal(changed(["method"], '"fem"'), text.replace("# of steel\n", '# of steel\nmethod = "fem"\n'));
  assert.ok(changed(["output", "frame_time"], "1").endsWith('\n[output]\nframe_time = 1\n'));
});

test("what_a_change_makes_says_what_was_meant", () => {
  for (const path of [["mesh", "growth"], ["method"], ["stage", 1, "until", "displacement"], ["mesh", "trench", "center"], ["material", "clay", "water", "drainage"], ["output", "frame_time"], ["material", "clay", "odd name"]] as Path[]) {
    const next = new CaseText(changed(path, '"x"'));
    assert.equal(next.at(path), "x", JSON.stringify(path));
    assert.equal(new CaseText(next.without(path)).at(path), undefined, JSON.stringify(path));
    assert.equal(next.at(["mesh", "near_size"]), "20 mm");
  }
});

test("a_key_with_a_comment_is_commented_out_and_comes_back_where_it_was", () => {
  const cleared = new CaseText(text).without(["mesh", "near_size"]);
  assert.equal(cleared, text.replace("near_size =", "# near_size ="));
  const after = new CaseText(cleared);
  assert.equal(after.at(["mesh", "near_size"]), undefined);
  assert.equal(after.comment(["mesh", "near_size"]), "<- cells");
  assert.equal(after.former(["mesh", "near_size"]), '"20 mm"');
  assert.equal(after.with(["mesh", "near_size"], '"20 mm"'), text);
  assert.equal(after.with(["mesh", "near_size"], '"0.0200001 m"'), text.replace('"20 mm"  ', '"0.0200001 m"'));
  const inner = 'a = 1 # one\n[[stage]]\n[[stage]]\n# until.force = "800 kN" # <- or a load\n# prose = without a comment of its own\n# and more # prose\n';
  assert.equal(new CaseText(inner).comment(["stage", 1, "until", "force"]), "<- or a load");
  assert.equal(new CaseText(inner).comment(["stage", 1, "prose"]), "");
  assert.ok(new CaseText(inner).with(["stage", 1, "until", "force"], "5").includes("\nuntil.force = 5"));
});

test("low_and_high_stand_in_the_comment_of_a_key", () => {
  const of = (comment: string) => range_in(comment);
  assert.deepEqual(of("<- s_u at the seabed; low 2 kPa, high 4.5 kPa"), { low: "2 kPa", high: "4.5 kPa" });
  assert.deepEqual(of("low 0.3, high 0.6"), { low: "0.3", high: "0.6" });
  for (const other of ["", "<- the low water, high tide", "low 2 kPa", "low, high", "lower 2, high 3"]) assert.equal(of(other), null, other);
  assert.equal(with_range("<- s_u", { low: "2", high: "4,5" }, "kPa"), "<- s_u; low 2 kPa, high 4.5 kPa");
  assert.equal(with_range("<-", { low: "2", high: "3 MPa" }, "kPa"), "<- low 2 kPa, high 3 MPa");
  assert.equal(with_range("<- s_u; low 2 kPa, high 4 kPa", { low: "", high: "" }, "kPa"), "<- s_u");
  for (const comment of ["", "<-", "<- s_u", "of silt"]) assert.deepEqual(of(with_range(comment, { low: "1", high: "2" }, "")), { low: "1", high: "2" }, comment);
  for (const [low, high, word] of [["2", "4,5", ""], ["2 kPa", "1 MPa", ""], ["", "", ""], ["2", "x # y", "number"], ["2 k Pa", "3", "number"], ["4", "2", "less"], ["2 kPa", "2 kPa", "less"]]) assert.ok(wrong_in({ low, high }).includes(word) && (word !== "" || wrong_in({ low, high }) === ""), `${low}, ${high}`);
  const read = new CaseText(text);
  assert.equal(read.with_comment(["mesh", "near_size"], "<- low 1 mm, high 2 mm"), text.replace("<- cells", "<- low 1 mm, high 2 mm"));
  assert.equal(read.with_comment(["material", "clay", "cohesion"], "c"), text.replace("2000.0", "2000.0  # c"));
  assert.equal(read.with_comment(["title"], ""), text.replace("   # of steel", ""));
});

test("a_key_goes_with_its_line_or_its_comma", () => {
  assert.equal(new CaseText(text).without(["material", "clay", "cohesion"]), text.replace("cohesion = 2000.0\n", ""));
  assert.equal(new CaseText(text).without(["mesh", "trench", "depth"]), text.replace('depth = "0.5 m", ', ""));
  assert.equal(new CaseText(text).without(["mesh", "trench", "width"]), text.replace(', width = "1 m"', ""));
  assert.equal(new CaseText(text).without(["mesh", "layer"]), text);
});

test("an_empty_text_and_one_that_is_no_toml", () => {
  assert.equal(new CaseText("").with(["title"], '"x"'), 'title = "x"\n');
  assert.equal(new CaseText("[mesh").value, null);
  assert.equal(new CaseText("[mesh]\n").with(["mesh", "kind"], '"box"'), '[mesh]\nkind = "box"\n');
});

test("lines_are_those_of_the_key_or_of_its_table", () => {
  const parsed = new CaseText(text);
  assert.equal(parsed.line(["mesh", "near_size"]), 6);
  assert.equal(parsed.line(["mesh", "growth"]), 4);
  assert.equal(parsed.line(["stage", 1, "until", "time"]), 17);
});

test("quantities_change_their_unit_and_keep_their_size", () => {
  const cell = quantity_of('"20 mm"', "m")!;
  assert.deepEqual(cell, { number: "20", unit: "mm", plain: false });
  assert.equal(spelled(in_unit(cell, "m", "in"), "m"), '"0.78740157 in"');
  assert.equal(spelled(in_unit({ number: "2", unit: "kPa", plain: false }, "Pa", "lbf/ft^2"), "Pa"), '"41.770868 lbf/ft^2"');
  assert.equal(spelled(quantity_of("2000.0", "Pa")!, "Pa"), "2000.0");
  assert.equal(spelled({ number: "0,5", unit: "m", plain: false }, "m"), '"0.5 m"');
  assert.equal(spelled({ number: ".5", unit: "", plain: false }, ""), "0.5");
  assert.equal(spelled({ number: "unlimited", unit: "m", plain: false }, "m"), '"unlimited"');
  assert.equal(spelled({ number: " ", unit: "m", plain: false }, "m"), "");
  assert.equal(quantity_of('"3 furlong"', "m"), null);
  assert.deepEqual(units_of("1/furlong"), ["1/furlong"]);
});

test("tests_of_a_soil_are_undrained_where_its_strength_is", () => {
  const made = element_tests("case.toml", new CaseText('[material.clay]\nlaw = "mohr_coulomb"\nfriction_angle = "0 deg"\n[material.sand]\nlaw = "mohr_coulomb"\nfriction_angle = "33 deg"\n'));
  const tests = new CaseText(made).at(["test"]) as { material: string; drained: boolean }[];
  assert.deepEqual(tests.map(({ material, drained }) => [material, drained]), [["clay", false], ["clay", false], ["sand", true], ["sand", true]]);
});
