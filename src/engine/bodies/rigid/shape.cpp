// SPDX-License-Identifier: BSD-3-Clause
#include "bodies/rigid/shape.hpp"

namespace berm::bodies {
namespace {

template <class... Ts>
std::vector<const char*> words(const std::variant<Ts...>&)
{
  return {Ts::word...};
}

}  // namespace

void describe_shape(Describe& d, RigidShapeSettings& shape)
{
  d.one_of("shape", shape, words(shape),
           {.meaning = "exact surface of the body; in space circle and polygon are infinite along z", .required = true});
}

bool is_endless(const RigidShapeSettings& shape)
{
  return std::visit(
      []<class S>(const S&) {
        return requires
        {
          requires S::endless;
        };
      },
      shape);
}

bool is_round_from_above(const RigidShapeSettings& shape)
{
  return std::visit(
      [](const auto& s) {
        if constexpr (requires { s.round_from_above(); })
          return s.round_from_above();
        else
          return false;
      },
      shape);
}

std::optional<DiskOutline> pipe_section(const RigidShapeSettings& shape)
{
  const Outline outline = std::visit([](const auto& s) { return outline_of(s); }, shape);
  const auto* disk = std::get_if<DiskOutline>(&outline);
  return disk != nullptr && is_endless(shape) ? std::optional(*disk) : std::nullopt;
}

template <int dim>
RigidShape<dim> make_shape(const RigidShapeSettings& settings)
{
  return std::visit([](const auto& s) { return RigidShape<dim>(make_shape<dim>(s)); }, settings);
}

template <int dim>
SurfacePoint<dim> surface_at(const RigidShape<dim>& shape, const Vec<dim>& x)
{
  return std::visit([&](const auto& s) { return surface_at<dim>(s, x); }, shape);
}

template <int dim>
Real lowest_level(const RigidShape<dim>& shape, const Vec<dim>& up)
{
  return std::visit([&](const auto& s) { return lowest_level<dim>(s, up); }, shape);
}

template <int dim>
Vec<dim> center_of(const RigidShape<dim>& shape)
{
  return std::visit([](const auto& s) { return center_of<dim>(s); }, shape);
}

template <int dim>
Real width_of(const RigidShape<dim>& shape)
{
  return std::visit([](const auto& s) { return width_of<dim>(s); }, shape);
}

template <int dim>
Real reach_of(const RigidShape<dim>& shape)
{
  return std::visit([](const auto& s) { return reach_of<dim>(s); }, shape);
}

template <int dim>
Vec<3> inertia_over_mass(const RigidShape<dim>& shape)
{
  return std::visit([](const auto& s) { return inertia_over_mass<dim>(s); }, shape);
}

#define BERM_INSTANTIATE(dim)                                                                                                              \
  template RigidShape<dim> make_shape<dim>(const RigidShapeSettings&);                                                                     \
  template SurfacePoint<dim> surface_at<dim>(const RigidShape<dim>&, const Vec<dim>&);                                                     \
  template Real lowest_level<dim>(const RigidShape<dim>&, const Vec<dim>&);                                                                \
  template Vec<dim> center_of<dim>(const RigidShape<dim>&);                                                                                \
  template Real width_of<dim>(const RigidShape<dim>&);                                                                                     \
  template Real reach_of<dim>(const RigidShape<dim>&);                                                                                     \
  template Vec<3> inertia_over_mass<dim>(const RigidShape<dim>&);
BERM_INSTANTIATE(2)
BERM_INSTANTIATE(3)
#undef BERM_INSTANTIATE

}  // namespace berm::bodies
