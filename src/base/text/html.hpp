// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace berm::text {

/// A text as HTML shows it: &, <, > and " escaped.
std::string html_text(const std::string& text);

/// What a reader sees of such sentences as plain text: without tags, letters of an index behind "_", those above the line behind "^".
std::string text_of_html(const std::string& html);

/// The element of a page's head that tells a browser what the page may do: run the scripts that `scripts` names ("": none), show pictures that lie in it or beside it, and
/// nothing else; it fetches nothing.
std::string content_policy(const std::string& scripts = "");

/// One cell of a table. The content is HTML: text of the user's goes through html_text first.
struct HtmlCell {
  std::string content;
  bool number = false;  ///< aligned to the right
};

/// A table of the page, in a box that scrolls sideways where it is too wide.
class HtmlTable {
public:
  /// `id` names it for links and for copying, `caption` is text.
  HtmlTable(std::string id, std::string caption) : id_(std::move(id)), caption_(std::move(caption)) {}

  /// The header, before the rows: HTML, by column.
  void columns(std::vector<HtmlCell> cells) { columns_ = std::move(cells); }
  /// A row; its first cell is its header; a single cell spans all columns. `row_class` as the page's style defines it
  /// ("out_of_range", "group"), or "".
  void row(std::vector<HtmlCell> cells, std::string row_class = "");
  bool empty() const { return rows_.empty(); }

  /// With a button to copy it.
  std::string html() const;

private:
  std::string id_, caption_;
  std::vector<HtmlCell> columns_;
  std::vector<std::pair<std::string, std::string>> rows_;  ///< class, HTML
};

/// A section of the page: `id`, its title (text), HTML below it.
std::string html_section(const std::string& id, const std::string& title, const std::string& content);

/// HTML whose tables and paragraphs stand beside one another as far as the page is wide.
std::string html_beside(const std::string& content);

/// A paragraph of text.
std::string html_paragraph(const std::string& text, const std::string& css_class = "");

/// Assessment of a result.
enum class Standing { good, fair, bad, unknown };

/// A short verdict with a colour, and the word itself for readers who do not see it.
std::string html_badge(Standing standing, const std::string& word);

}  // namespace berm::text
