// SPDX-License-Identifier: BSD-3-Clause
// berm.engine.MacroElement: the C code of the macro-element, the same that berm macro-element writes.
#include "macro_element/parameters.hpp"

#include <array>
#include <optional>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

namespace py = pybind11;
using namespace py::literals;

namespace {

using Three = std::array<double, 3>;

void ask(int error)
{
  if (error != BERM_MACRO_ELEMENT_OK) throw py::value_error(berm_macro_element_error(error));
}

/// A pipe on the seabed with its state.
class MacroElement {
public:
  MacroElement(const std::string& text, const std::string& name) : parameters_(berm::macro_element::parameters_in(text, name))
  {
    start(0, 0, 0, 0);
  }
  void start(double x, double u, double w, double V)
  {
    const double displacement[3] = {x, u, w};
    ask(berm_macro_element_start(&parameters_, displacement, V, &state_));
  }
  /// What is not given stays.
  Three step(std::optional<double> x, std::optional<double> u, std::optional<double> w)
  {
    const double displacement[3] = {x.value_or(state_.x), u.value_or(state_.u), w.value_or(state_.w)};
    double K[3][3];
    Three F{};
    ask(berm_macro_element_step(&parameters_, &state_, displacement, &state_, F.data(), K));
    for (std::size_t i = 0; i < 3; ++i) stiffness_[i] = std::to_array(K[i]);
    return F;
  }
  const berm_macro_element_state& state() const { return state_; }
  const std::array<Three, 3>& stiffness() const { return stiffness_; }

private:
  berm_macro_element_parameters parameters_;
  berm_macro_element_state state_{};
  std::array<Three, 3> stiffness_{};
};

}  // namespace

void add_macro_element(py::module_& module)
{
  py::class_<MacroElement> element(module, "MacroElement",
                                   "A macro-element of a pipe on the seabed with its state; read one with berm.macro_element().");
  element
      .def(py::init<const std::string&, const std::string&>(), "text"_a, "name"_a = "macro_element.json",
           "text: what a macro_element.json holds; name: what messages call it. The pipe touches the seabed. Throws InputError.")
      .def("start", &MacroElement::start, py::kw_only(), "x"_a = 0., "u"_a = 0., "w"_a = 0., "V"_a = 0.,
           "A pipe at x and u that was pushed straight down to w (m) into undisturbed soil, where V (N/m, 0 to V0) acts on it.")
      .def("step", &MacroElement::step, py::kw_only(), "x"_a = py::none(), "u"_a = py::none(), "w"_a = py::none(),
           "Moves the pipe to x along it, u across it and w downwards (m); what is not given stays. Returns T, H and V, N/m. With a "
           "ValueError the state stays as it was.")
      .def("__copy__", [](const MacroElement& self) { return self; })
      .def_property_readonly("stiffness", &MacroElement::stiffness,
                             "derivatives of T, H and V (rows) by x, u and w in the last step, N/m^2");
  const auto number = [&](const char* name, double berm_macro_element_state::*member, const char* unit) {
    element.def_property_readonly(
        name, [member](const MacroElement& self) { return self.state().*member; }, unit);
  };
  using State = berm_macro_element_state;
  number("x", &State::x, "m");
  number("u", &State::u, "m");
  number("w", &State::w, "m");
  number("T", &State::T, "N/m");
  number("H", &State::H, "N/m");
  number("V", &State::V, "N/m");
}
