// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/text/markdown_test.cpp
#include "text/tex_math.hpp"

#include "text/html.hpp"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <map>
#include <stdexcept>

namespace berm::text {
namespace {

/// Thrown for TeX that is not supported.
struct Unknown : std::runtime_error {
  using std::runtime_error::runtime_error;
};

const std::map<std::string, std::string> letters = {
    {"alpha", "α"},  {"beta", "β"},    {"gamma", "γ"},    {"delta", "δ"},   {"epsilon", "ϵ"}, {"varepsilon", "ε"}, {"zeta", "ζ"},
    {"eta", "η"},    {"theta", "θ"},   {"vartheta", "ϑ"}, {"iota", "ι"},    {"kappa", "κ"},   {"lambda", "λ"},     {"mu", "μ"},
    {"nu", "ν"},     {"xi", "ξ"},      {"pi", "π"},       {"rho", "ρ"},     {"sigma", "σ"},   {"tau", "τ"},        {"upsilon", "υ"},
    {"phi", "ϕ"},    {"varphi", "φ"},  {"chi", "χ"},      {"psi", "ψ"},     {"omega", "ω"},   {"Gamma", "Γ"},      {"Delta", "Δ"},
    {"Theta", "Θ"},  {"Lambda", "Λ"},  {"Xi", "Ξ"},       {"Pi", "Π"},      {"Sigma", "Σ"},   {"Phi", "Φ"},        {"Psi", "Ψ"},
    {"Omega", "Ω"},  {"infty", "∞"},   {"ell", "ℓ"},      {"partial", "∂"}, {"nabla", "∇"},   {"prime", "′"},      {"circ", "∘"},
    {"degree", "°"}, {"emptyset", "∅"}};

const std::map<std::string, std::string> signs = {
    {"le", "≤"},         {"leq", "≤"},       {"ge", "≥"},         {"geq", "≥"},    {"ne", "≠"},     {"neq", "≠"},   {"approx", "≈"},
    {"sim", "∼"},        {"equiv", "≡"},     {"ll", "≪"},         {"gg", "≫"},     {"pm", "±"},     {"mp", "∓"},    {"times", "×"},
    {"cdot", "⋅"},       {"cdots", "⋯"},     {"ldots", "…"},      {"dots", "…"},   {"in", "∈"},     {"notin", "∉"}, {"to", "→"},
    {"rightarrow", "→"}, {"leftarrow", "←"}, {"Rightarrow", "⇒"}, {"mapsto", "↦"}, {"otimes", "⊗"}, {"perp", "⊥"},  {"parallel", "∥"},
    {"propto", "∝"},     {"mid", "∣"},       {"langle", "⟨"},     {"rangle", "⟩"}, {"lvert", "|"},  {"rvert", "|"}, {"lVert", "‖"},
    {"rVert", "‖"},      {"|", "‖"},         {"{", "{"},          {"}", "}"},      {"%", "%"},      {"_", "_"},     {"#", "#"},
    {"&", "&"}};

const std::map<std::string, std::string> large_signs = {{"sum", "∑"}, {"prod", "∏"}, {"int", "∫"}};

const std::map<std::string, std::string> accents = {{"bar", "¯"}, {"overline", "¯"}, {"dot", "˙"}, {"ddot", "¨"},
                                                    {"hat", "^"}, {"tilde", "~"},    {"vec", "→"}};

const std::map<std::string, std::string> spaces = {{",", "0.17em"}, {":", "0.22em"}, {";", "0.28em"}, {"!", "-0.17em"},
                                                   {" ", "0.3em"},  {"quad", "1em"}, {"qquad", "2em"}};

bool is_function(const std::string& name)
{
  constexpr const char* names[] = {"sin", "cos", "tan", "cot", "sinh", "cosh", "tanh", "arcsin", "arccos", "arctan",
                                   "log", "ln",  "exp", "min", "max",  "det",  "lim",  "sgn",    "tr",     "dim"};
  return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

bool one_of(const std::string& word, std::initializer_list<const char*> words)
{
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// MathML drops spaces at the ends of text.
std::string with_firm_spaces(std::string text)
{
  for (std::size_t at; (at = text.find(' ')) != std::string::npos;) text.replace(at, 1, "&#xA0;");
  return text;
}

std::string tag(const char* name, const std::string& content)
{
  return fmt::format("<{0}>{1}</{0}>", name, content);
}

/// Parses the source once, from left to right.
class Formula {
public:
  explicit Formula(const std::string& tex) : tex_(tex) {}

  std::string mathml()
  {
    const std::string row = row_until_end();
    if (!at_end()) throw Unknown("a bracket too many");
    return row;
  }

private:
  bool at_end() const { return at_ >= tex_.size(); }
  void skip_spaces()
  {
    while (!at_end() && std::isspace(static_cast<unsigned char>(tex_[at_])) != 0) ++at_;
  }
  char next()
  {
    if (at_end()) throw Unknown("it ends too early");
    return tex_[at_++];
  }

  /// Everything up to the end, a } or a \right.
  std::string row_until_end()
  {
    std::string row;
    for (skip_spaces(); !at_end() && tex_[at_] != '}' && tex_.compare(at_, 6, "\\right") != 0; skip_spaces()) row += scripted();
    return row;
  }

  std::string scripted()
  {
    bool limits = false;
    const std::string base = atom(limits);
    std::string below, above;
    for (skip_spaces(); !at_end() && (tex_[at_] == '_' || tex_[at_] == '^' || tex_[at_] == '\''); skip_spaces()) {
      const char kind = next();
      if (kind == '\'')
        above += "<mo>′</mo>";
      else
        (kind == '_' ? below : above) += argument();
    }
    if (below.empty() && above.empty()) return base;
    const char* name = below.empty()   ? (limits ? "mover" : "msup")
                       : above.empty() ? (limits ? "munder" : "msub")
                       : limits        ? "munderover"
                                       : "msubsup";
    return tag(name, base + (below.empty() ? "" : tag("mrow", below)) + (above.empty() ? "" : tag("mrow", above)));
  }

  /// {...} or the next atom; of a number its first digit, so that \tfrac12 is a half.
  std::string argument()
  {
    skip_spaces();
    bool limits = false;
    if (!at_end() && std::isdigit(static_cast<unsigned char>(tex_[at_])) != 0) return tag("mrow", tag("mn", std::string(1, next())));
    return tag("mrow", atom(limits));
  }

  /// The text of {...} as it stands.
  std::string words()
  {
    skip_spaces();
    if (next() != '{') throw Unknown("words without a bracket");
    const std::size_t end = tex_.find('}', at_);
    if (end == std::string::npos) throw Unknown("an open bracket");
    const std::string text = tex_.substr(at_, end - at_);
    if (text.find_first_of("\\{$") != std::string::npos) throw Unknown("a formula among words");
    at_ = end + 1;
    return text;
  }

  std::string atom(bool& limits)
  {
    const char c = next();
    if (c == '{') {
      const std::string row = row_until_end();
      if (next() != '}') throw Unknown("an open bracket");
      return tag("mrow", row);
    }
    if (c == '\\') return command(limits);
    if (std::isdigit(static_cast<unsigned char>(c)) != 0) return number(c);
    if (std::isalpha(static_cast<unsigned char>(c)) != 0) return tag("mi", std::string(1, c));
    if (c == '-') return tag("mo", "−");
    if (c == '~') return "<mspace width=\"0.3em\"/>";
    if (std::string("()[]|/").find(c) != std::string::npos) return fmt::format("<mo stretchy=\"false\">{}</mo>", c);
    if (std::string("+=<>,.;:!*").find(c) != std::string::npos) return tag("mo", html_text(std::string(1, c)));
    throw Unknown(std::string("the sign ") + c);
  }

  std::string number(char first)
  {
    std::string digits(1, first);
    const auto digit = [&](std::size_t k) { return k < tex_.size() && std::isdigit(static_cast<unsigned char>(tex_[k])) != 0; };
    while (digit(at_) || (at_ < tex_.size() && tex_[at_] == '.' && digit(at_ + 1))) digits += next();
    return tag("mn", digits);
  }

  std::string command(bool& limits)
  {
    std::string name(1, next());
    if (std::isalpha(static_cast<unsigned char>(name[0])) != 0)
      while (!at_end() && std::isalpha(static_cast<unsigned char>(tex_[at_])) != 0) name += next();
    if (const auto space = spaces.find(name); space != spaces.end()) return fmt::format("<mspace width=\"{}\"/>", space->second);
    if (const auto letter = letters.find(name); letter != letters.end()) return tag("mi", letter->second);
    if (const auto sign = signs.find(name); sign != signs.end()) return tag("mo", html_text(sign->second));
    if (const auto sign = large_signs.find(name); sign != large_signs.end()) {
      limits = name != "int";
      return tag("mo", sign->second);
    }
    if (is_function(name)) {
      limits = one_of(name, {"min", "max", "lim"});
      skip_spaces();
      const bool tight = limits || at_end() || std::string("(^_").find(tex_[at_]) != std::string::npos;
      return tag("mi", name) + (tight ? "" : "<mspace width=\"0.17em\"/>");
    }
    if (const auto accent = accents.find(name); accent != accents.end())
      return fmt::format("<mover accent=\"true\">{}<mo>{}</mo></mover>", argument(), accent->second);
    if (one_of(name, {"frac", "tfrac", "dfrac"})) {
      const std::string above = argument();
      return tag("mfrac", above + argument());
    }
    // Not msqrt: without a font for formulas its sign is as high as a letter, and covers no fraction. The page's style draws it.
    if (name == "sqrt")
      return fmt::format("<mrow class=\"root\" intent=\"square-root($of)\"><mrow arg=\"of\">{}</mrow></mrow>", argument());
    if (one_of(name, {"text", "mathrm", "textrm"})) return tag("mtext", with_firm_spaces(html_text(words())));
    if (name == "operatorname") return tag("mi", html_text(words()));
    if (one_of(name, {"mathbf", "boldsymbol", "bm"})) return fmt::format("<mrow style=\"font-weight:bold\">{}</mrow>", argument());
    if (one_of(name, {"big", "Big", "bigg", "Bigg", "bigl", "bigr", "Bigl", "Bigr", "displaystyle"})) return "";
    if (name == "left") return bracketed();
    throw Unknown("\\" + name);
  }

  /// A bracket after \left or \right, as high as what it encloses; "." is none.
  std::string fence()
  {
    skip_spaces();
    const char c = next();
    if (c == '.') return "";
    if (std::string("()[]|").find(c) == std::string::npos) throw Unknown("a bracket of another kind");
    return tag("mo", std::string(1, c));
  }
  std::string bracketed()
  {
    const std::string open = fence(), row = row_until_end();
    if (tex_.compare(at_, 6, "\\right") != 0) throw Unknown("\\left without \\right");
    at_ += 6;
    return tag("mrow", open + row + fence());
  }

  const std::string& tex_;
  std::size_t at_ = 0;
};

}  // namespace

std::string html_math(const std::string& tex, bool block)
{
  try {
    return fmt::format("<math display=\"{}\"><mrow>{}</mrow></math>", block ? "block" : "inline", Formula(tex).mathml());
  } catch (const Unknown&) {
    return fmt::format("<code class=\"tex\">{}</code>", html_text(tex));
  }
}

}  // namespace berm::text
