// SPDX-License-Identifier: BSD-3-Clause
#include "material/user_law.hpp"

#include "material/describe_elasticity.hpp"

#include <fmt/format.h>
#include <stdexcept>

namespace berm::material {

template <Interface interface>
void describe(Describe& d, UserLaw<interface>& law)
{
  d.value("library", law.library,
          {.meaning = "shared library (.so) with the law; a relative path starts at the folder of the case", .required = true});
  d.value("library_sha256", law.library_sha256,
          {.meaning = "SHA-256 that the library must have; a run writes that of its library here, and is resumed with no other"});
  d.value("symbol", law.symbol,
          {.meaning = interface == Interface::umat ? "name of the function in the library; not given: umat_, or else umat"
                                                   : "name of the function in the library; not given: berm_law"});
  d.value("properties", law.properties, {.meaning = "numbers that the law receives (PROPS), in the units that it expects"});
  d.value("state_variables", law.state_variables,
          {.meaning = "number of its state variables (NSTATV)", .range = {0, static_cast<Real>(max_user_state)}});
  d.value("initial_state", law.initial_state, {.meaning = "their values at the start, as many as there are; not given: 0"});
  d.value("state_names", law.state_names,
          {.meaning = "their names in frames and pictures, as many as there are; not given: state_1, state_2, ..."});
  describe_weight(d, law);
  d.value("inertia_density", law.inertia_density,
          {.meaning = "density that gives the inertia, where it is not `density`, which gives the weight",
           .unit = "kg/m^3",
           .range = positive});
  describe_water(d, law);
  d.value("young_modulus", law.young_modulus,
          {.meaning =
               "Young's modulus of the stiffest response that the law will ever give: it sets the time step, and in finite elements the "
               "trial stress of the relaxation",
           .unit = "Pa",
           .range = positive,
           .required = true});
  d.value("poisson_ratio", law.poisson_ratio, {.meaning = "Poisson's ratio belonging to it", .range = {0, 0.495}, .required = true});
  d.value("can_yield", law.can_yield,
          {.meaning = "whether the law has a yield surface: soil that can yield gets bulk viscosity and the velocity filter"});
  d.choice("thread_safe", law.thread_safe, {"probed", "yes", "no"},
           {.meaning = "whether several threads may call the law at a time; probed: as a trial says when the library is loaded"});
}

template <Interface interface>
void check(Describe& d, const std::string& path, const UserLaw<interface>& law)
{
  const auto count = static_cast<std::size_t>(law.state_variables);
  const auto as_many = [&](const char* key, std::size_t given) {
    d.check(given == 0 || given == count, fmt::format("{}.{}", path, key),
            fmt::format("has {} entries, but state_variables = {}", given, count));
  };
  as_many("initial_state", law.initial_state.size());
  as_many("state_names", law.state_names.size());
  for (std::size_t k = 0; k < law.state_names.size(); ++k) {
    const std::string& name = law.state_names[k];
    const bool valid =
        !name.empty() && name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_") == std::string::npos;
    d.check(valid, path + ".state_names", fmt::format("\"{}\" is not a name: letters, digits and _ only", name));
    d.check(std::find(law.state_names.begin(), law.state_names.begin() + static_cast<std::ptrdiff_t>(k), name) ==
                law.state_names.begin() + static_cast<std::ptrdiff_t>(k),
            path + ".state_names", fmt::format("\"{}\" occurs twice", name));
  }
}

template <Interface interface>
std::vector<FieldInfo> state_fields(const UserLaw<interface>& law)
{
  std::vector<FieldInfo> fields;
  for (int k = 0; k < law.state_variables; ++k) {
    const bool named = !law.state_names.empty();
    // A word of its own before the user's name, which may be that of another field of the particles.
    fields.push_back({named ? "law_" + law.state_names[static_cast<std::size_t>(k)] : fmt::format("law_state_{}", k + 1),
                      named ? law.state_names[static_cast<std::size_t>(k)] : fmt::format("state variable {} of the law", k + 1), ""});
  }
  return fields;
}

template <Interface interface>
PreparedUserLaw prepare(const UserLaw<interface>& law)
{
  if (!law.loaded) throw std::logic_error("the library of a law was not loaded");
  return {elasticity(law), law.state_variables, law.loaded.get()};
}

#define BERM_INSTANTIATE(interface)                                                                                                        \
  template void describe(Describe&, UserLaw<interface>&);                                                                                  \
  template void check(Describe&, const std::string&, const UserLaw<interface>&);                                                           \
  template std::vector<FieldInfo> state_fields(const UserLaw<interface>&);                                                                 \
  template PreparedUserLaw prepare(const UserLaw<interface>&);
BERM_INSTANTIATE(Interface::own)
BERM_INSTANTIATE(Interface::umat)
#undef BERM_INSTANTIATE

}  // namespace berm::material
