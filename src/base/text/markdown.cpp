// SPDX-License-Identifier: BSD-3-Clause
#include "text/markdown.hpp"

#include "os/error.hpp"
#include "text/tex_math.hpp"

#include <cmark-gfm-core-extensions.h>
#include <cmark-gfm-extension_api.h>
#include <cmark-gfm.h>
#include <cstdlib>
#include <fmt/format.h>
#include <memory>
#include <vector>

namespace berm::text {
namespace {

/// Placeholder of formula k while Markdown is read, whose syntax uses underscores and backslashes, too: letters that no text
/// uses.
std::string stand_in(std::size_t k)
{
  return fmt::format("\uE000{}\uE001", k);
}

/// The end of the code that begins at `at` with one or more backquotes, or `at` where it does not end.
std::size_t end_of_code(const std::string& text, std::size_t at)
{
  const std::size_t count = text.find_first_not_of('`', at) - at;
  for (std::size_t k = at + count; (k = text.find('`', k)) != std::string::npos;) {
    const std::size_t end = std::min(text.find_first_not_of('`', k), text.size());
    if (end - k == count) return end;
    k = end;
  }
  return at;
}

/// The end of the formula that begins at `at`, behind its last $, or `at` where there is none: "$5 and $6" is no formula.
std::size_t end_of_formula(const std::string& text, std::size_t at)
{
  const bool block = text.compare(at, 2, "$$") == 0;
  const std::size_t begin = at + (block ? 2 : 1), end = text.find(block ? "$$" : "$", begin), paragraph = text.find("\n\n", begin);
  if (end == std::string::npos || end == begin || paragraph < end) return at;
  const std::size_t behind = end + (block ? 2 : 1);
  if (block) return behind;
  const auto is_space = [&](std::size_t k) { return text[k] == ' ' || text[k] == '\n'; };
  const bool before_digit = behind < text.size() && text[behind] >= '0' && text[behind] <= '9';
  return is_space(begin) || is_space(end - 1) || before_digit ? at : behind;
}

/// Replaces formulas by placeholders; their HTML goes to `formulas`.
std::string without_formulas(const std::string& text, std::vector<std::string>& formulas)
{
  std::string rest;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = at;
    if (text[at] == '`') {
      end = end_of_code(text, at);
      if (end == at) end = std::min(text.find_first_not_of('`', at), text.size());
      rest += text.substr(at, end - at);
    } else if (text[at] == '\\' && at + 1 < text.size()) {
      end = at + 2;
      rest += text.substr(at, 2);
    } else if (text[at] == '$' && (end = end_of_formula(text, at)) != at) {
      const std::size_t sign = text[at + 1] == '$' ? 2 : 1;
      rest += stand_in(formulas.size());
      formulas.push_back(html_math(text.substr(at + sign, end - at - 2 * sign), sign == 2));
    } else {
      end = at + 1;
      rest += text[at];
    }
    at = end;
  }
  return rest;
}

struct Free {
  void operator()(cmark_parser* parser) const { cmark_parser_free(parser); }
  void operator()(cmark_node* node) const { cmark_node_free(node); }
  void operator()(cmark_iter* iterator) const { cmark_iter_free(iterator); }
  void operator()(char* text) const { std::free(text); }
};

void set_addresses(cmark_node* document, const std::function<std::string(const std::string&)>& link)
{
  const std::unique_ptr<cmark_iter, Free> nodes(cmark_iter_new(document));
  for (cmark_event_type event = cmark_iter_next(nodes.get()); event != CMARK_EVENT_DONE; event = cmark_iter_next(nodes.get())) {
    cmark_node* node = cmark_iter_get_node(nodes.get());
    const cmark_node_type type = cmark_node_get_type(node);
    if (event == CMARK_EVENT_ENTER && (type == CMARK_NODE_LINK || type == CMARK_NODE_IMAGE))
      cmark_node_set_url(node, link(cmark_node_get_url(node)).c_str());
  }
}

}  // namespace

std::string html_of_markdown(const std::string& text, const std::function<std::string(const std::string&)>& link)
{
  std::vector<std::string> formulas;
  const std::string source = without_formulas(text, formulas);

  cmark_gfm_core_extensions_ensure_registered();
  const std::unique_ptr<cmark_parser, Free> parser(cmark_parser_new(CMARK_OPT_DEFAULT));
  cmark_syntax_extension* tables = cmark_find_syntax_extension("table");
  if (tables == nullptr) throw RunError("the Markdown library has no tables");
  cmark_parser_attach_syntax_extension(parser.get(), tables);
  cmark_parser_feed(parser.get(), source.data(), source.size());
  const std::unique_ptr<cmark_node, Free> document(cmark_parser_finish(parser.get()));
  set_addresses(document.get(), link);
  const std::unique_ptr<char, Free> rendered(
      cmark_render_html(document.get(), CMARK_OPT_DEFAULT, cmark_parser_get_syntax_extensions(parser.get())));

  std::string html = rendered.get();
  for (std::size_t k = 0; k < formulas.size(); ++k)
    if (const std::size_t at = html.find(stand_in(k)); at != std::string::npos) html.replace(at, stand_in(k).size(), formulas[k]);
  return html;
}

}  // namespace berm::text
