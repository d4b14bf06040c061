// SPDX-License-Identifier: BSD-3-Clause
#include "text/html.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace berm::text {
namespace {

std::string class_attribute(const std::string& name)
{
  return name.empty() ? "" : fmt::format(" class=\"{}\"", name);
}

}  // namespace

std::string html_text(const std::string& text)
{
  std::string html;
  for (const char c : text) {
    const char* escaped = c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '"' ? "&quot;" : nullptr;
    escaped == nullptr ? static_cast<void>(html += c) : static_cast<void>(html += escaped);
  }
  return html;
}

std::string text_of_html(const std::string& html)
{
  constexpr std::pair<std::string_view, std::string_view> signs[] = {{"<sub>", "_"}, {"<sup>", "^"},   {"&lt;", "<"},  {"&gt;", ">"},
                                                                     {"&amp;", "&"}, {"&quot;", "\""}, {"&nbsp;", " "}};
  std::string words;
  for (std::string_view rest = html; !rest.empty();) {
    const auto sign = std::ranges::find_if(signs, [&](const auto& one) { return rest.starts_with(one.first); });
    const bool tag = rest[0] == '<' && rest.find('>') != std::string_view::npos;
    if (sign != std::end(signs))
      words += sign->second;
    else if (!tag)
      words += rest[0];
    rest.remove_prefix(sign != std::end(signs) ? sign->first.size() : tag ? rest.find('>') + 1 : 1);
  }
  return words;
}

std::string content_policy(const std::string& scripts)
{
  return fmt::format("<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src {}; style-src 'unsafe-inline'; "
                     "img-src 'self' file: data: blob:; base-uri 'none'; form-action 'none'\">\n",
                     scripts.empty() ? "'none'" : scripts);
}

void HtmlTable::row(std::vector<HtmlCell> cells, std::string row_class)
{
  const std::string span = cells.size() == 1 && columns_.size() > 1 ? fmt::format(" colspan=\"{}\"", columns_.size()) : "";
  std::string html;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const std::string attributes = class_attribute(cells[k].number ? "number" : "") + span;
    const std::string& content = cells[k].content;
    html += k > 0 ? fmt::format("<td{}>{}</td>", attributes, content)
                  : fmt::format("<th scope=\"row\"{}>{}</th>", attributes, span.empty() ? content : "<span>" + content + "</span>");
  }
  rows_.emplace_back(std::move(row_class), std::move(html));
}

std::string HtmlTable::html() const
{
  std::string html = fmt::format("<div class=\"table\">\n<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"{1}\"><table "
                                 "id=\"{0}\">\n<caption><span>{1}</span></caption>\n",
                                 html_text(id_), html_text(caption_));
  if (!columns_.empty()) {
    html += "<thead><tr>";
    for (const HtmlCell& cell : columns_)
      html += fmt::format("<th scope=\"col\"{}>{}</th>", class_attribute(cell.number ? "number" : ""), cell.content);
    html += "</tr></thead>\n";
  }
  html += "<tbody>\n";
  for (const auto& [row_class, cells] : rows_) html += fmt::format("<tr{}>{}</tr>\n", class_attribute(row_class), cells);
  return html +
         fmt::format("</tbody>\n</table></div>\n<button type=\"button\" class=\"copy\" data-copy=\"{}\">Copy the table</button>\n</div>\n",
                     html_text(id_));
}

std::string html_section(const std::string& id, const std::string& title, const std::string& content)
{
  return fmt::format("<section id=\"{0}\" aria-labelledby=\"{0}-title\">\n<h2 id=\"{0}-title\">{1}</h2>\n{2}</section>\n", id,
                     html_text(title), content);
}

std::string html_beside(const std::string& content)
{
  return "<div class=\"beside\">\n" + content + "</div>\n";
}

std::string html_paragraph(const std::string& text, const std::string& css_class)
{
  return fmt::format("<p{}>{}</p>\n", class_attribute(css_class), html_text(text));
}

std::string html_badge(Standing standing, const std::string& word)
{
  constexpr std::array classes{"good", "fair", "bad", "none"};
  return fmt::format("<span class=\"badge {}\">{}</span>", classes[static_cast<std::size_t>(standing)], html_text(word));
}

}  // namespace berm::text
