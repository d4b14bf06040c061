// SPDX-License-Identifier: BSD-3-Clause
// berm.engine.MacroElement: the C code of the macro-element, the same that berm macro-element writes.
#include "macro_element/members.hpp"

#include <algorithm>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

namespace py = pybind11;
using namespace py::literals;

namespace {

using Parameters = berm_macro_element_parameters;
using Pair = std::array<double, 2>;

void ask(int error)
{
  if (error != BERM_MACRO_ELEMENT_OK) throw py::value_error(berm_macro_element_error(error));
}

/// A pipe on the seabed with its state.
class MacroElement {
public:
  explicit MacroElement(const std::map<std::string, double>& numbers, const std::vector<double>& w, const std::vector<double>& V)
  {
    parameters_.version = BERM_MACRO_ELEMENT_VERSION;
    for (const auto& [name, member, unit] : berm::macro_element::members) {
      if (!numbers.contains(name)) throw py::key_error(std::string("no parameter ") + name);
      parameters_.*member = numbers.at(name);
    }
    if (numbers.size() != std::size(berm::macro_element::members))
      throw py::value_error("a parameter that the macro-element does not have");
    if (w.size() != V.size() || w.size() > BERM_MACRO_ELEMENT_MAX_POINTS) throw py::value_error("backbone: as many w as V, 32 at most");
    std::copy(w.begin(), w.end(), parameters_.backbone_w);
    std::copy(V.begin(), V.end(), parameters_.backbone_V);
    parameters_.backbone_points = static_cast<int>(w.size());
    ask(berm_macro_element_check(&parameters_));
    start(0, 0, 0);
  }
  void start(double u, double w, double V) { ask(berm_macro_element_start(&parameters_, u, w, V, &state_)); }
  Pair step(double du, double dw)
  {
    const double by[2] = {du, dw};
    double K[2][2];
    Pair F{};
    ask(berm_macro_element_step(&parameters_, &state_, by, F.data(), K));
    stiffness_ = {{{K[0][0], K[0][1]}, {K[1][0], K[1][1]}}};
    return F;
  }
  const berm_macro_element_state& state() const { return state_; }
  const std::array<Pair, 2>& stiffness() const { return stiffness_; }

private:
  Parameters parameters_{};
  berm_macro_element_state state_{};
  std::array<Pair, 2> stiffness_{};
};

}  // namespace

void add_macro_element(py::module_& module)
{
  py::class_<MacroElement>(module, "MacroElement",
                           "A macro-element of a pipe on the seabed with its state; read one with berm.macro_element().")
      .def(py::init<const std::map<std::string, double>&, const std::vector<double>&, const std::vector<double>&>(), "parameters"_a,
           "backbone_w"_a = std::vector<double>(), "backbone_V"_a = std::vector<double>(),
           "parameters: all by name, SI units; V0 over the plastic embedment as points (m, N/m) or none. The pipe touches the seabed. "
           "Throws "
           "ValueError and KeyError.")
      .def("start", &MacroElement::start, "u"_a = 0., "w"_a = 0., "V"_a = 0.,
           "A pipe pushed straight down to w (m) into undisturbed soil, where V (N/m, 0 to V0) acts on it.")
      .def("step", &MacroElement::step, "du"_a, "dw"_a,
           "Moves the pipe by du and dw (m, w downwards). Returns H and V, N/m. The state stays as it was with a ValueError.")
      .def_property_readonly("stiffness", &MacroElement::stiffness, "[[dH/du, dH/dw], [dV/du, dV/dw]] of the last step, N/m^2")
      .def_property_readonly(
          "u", [](const MacroElement& self) { return self.state().u; }, "m")
      .def_property_readonly(
          "w", [](const MacroElement& self) { return self.state().w; }, "m")
      .def_property_readonly(
          "H", [](const MacroElement& self) { return self.state().H; }, "N/m")
      .def_property_readonly(
          "V", [](const MacroElement& self) { return self.state().V; }, "N/m");
}
