// SPDX-License-Identifier: BSD-3-Clause
#include "run_folder/frame.hpp"

#include "bodies/particle_fields.hpp"

#include <stdexcept>

namespace berm::run_folder {

template <int dim>
void Frame<dim>::allocate(std::size_t count, const std::vector<FieldInfo>& infos)
{
  points.assign(count, Vec<dim>::Zero());
  volume.assign(count, 0);
  body.assign(count, 0);
  id.assign(count, 0);
  fields.resize(infos.size());
  for (std::size_t k = 0; k < infos.size(); ++k) {
    fields[k].info = infos[k];
    fields[k].values.assign(count * static_cast<std::size_t>(infos[k].components), 0);
  }
}

template <int dim>
const FieldValues<Real>& Frame<dim>::field(const std::string& name) const
{
  const FieldValues<Real>* found = find_field(fields, name);
  if (found == nullptr) throw std::logic_error("the frame has no field " + name);
  return *found;
}

template <int dim>
FieldValues<Real>& Frame<dim>::field(const std::string& name)
{
  return const_cast<FieldValues<Real>&>(std::as_const(*this).field(name));
}

template <int dim>
std::vector<FieldInfo> common_fields(const std::string& since)
{
  const std::string begin = since.empty() ? "since the start" : since;
  std::vector<FieldInfo> fields;
  bodies::for_each_field<dim>([&](const auto& field) {
    if ((field.travel & to_frame) != 0) fields.push_back(field.info());
  });
  fields.insert(fields.end(),
                {{"displacement", "displacement " + begin, "m", dim, to_frame},
                 {"mean_stress", "mean stress (tension positive)", "Pa", 1, to_frame},
                 {"deviatoric_strain", "deviatoric strain of displacement " + begin, "", 1, to_frame},
                 {"volumetric_strain", "volumetric strain of displacement " + begin + " (expansion positive)", "", 1, to_frame},
                 {"incremental_deviatoric_strain", "deviatoric strain of displacement since the frame before", "", 1, to_frame}});
  return fields;
}

template <int dim>
std::vector<FieldInfo> effective_stress_fields()
{
  return {{"effective_stress", "effective stress (tension positive)", "Pa", tensor_size<dim>, to_frame},
          {"mean_effective_stress", "mean effective stress (tension positive)", "Pa", 1, to_frame}};
}

FieldInfo pore_pressure_ratio_field()
{
  return {"pore_pressure_ratio", "r_u: excess pore pressure divided by the effective vertical stress at rest", "", 1, to_frame};
}

template <int dim>
FieldInfo water_flux_field()
{
  return {"water_flux", "flow of the water (Darcy's flux)", "m/s", dim, to_frame};
}

template <int dim>
Real overburden(const problem::Model<dim>& model, Index body, const std::string& region, const settings::SoilPlace& place)
{
  return model.gravity.norm() * model.bodies[body].soil.mass_above(region, place);
}

bool is_common_field(const std::string& name)
{
  const std::vector<FieldInfo> fields = common_fields<2>();
  return std::any_of(fields.begin(), fields.end(), [&](const FieldInfo& info) { return info.name == name; });
}

std::vector<std::string> own_fields(const Frame<2>& frame)
{
  std::vector<std::string> names;
  for (const FieldValues<Real>& field : frame.fields) {
    const bool zero = std::all_of(field.values.begin(), field.values.end(), [](Real value) { return value == 0; });
    if (field.info.components == 1 && !zero && !is_common_field(field.info.name)) names.push_back(field.info.name);
  }
  return names;
}

template <int dim>
std::size_t bytes_of_point(int more_numbers)
{
  std::size_t numbers = dim + 1 + static_cast<std::size_t>(more_numbers);  // point and volume
  for (const FieldInfo& info : common_fields<dim>()) numbers += static_cast<std::size_t>(info.components);
  return numbers * sizeof(Real) + 2 * sizeof(std::int32_t);
}

template <int dim>
std::vector<FrameRigid<dim>> frame_rigids(const problem::Model<dim>& model, const std::vector<bodies::RigidState<dim>>& rigid_bodies)
{
  std::vector<FrameRigid<dim>> shown;
  for (std::size_t r = 0; r < model.rigid_bodies.size(); ++r)
    shown.push_back({surface_mesh<dim>(placed<dim>(model.rigid_bodies[r], rigid_bodies[r]), model.mesh.lower, model.mesh.upper),
                     rigid_bodies[r].velocity});
  return shown;
}

#define BERM_INSTANTIATE(dim)                                                                                                              \
  template struct Frame<dim>;                                                                                                              \
  template std::vector<FieldInfo> effective_stress_fields<dim>();                                                                          \
  template FieldInfo water_flux_field<dim>();                                                                                              \
  template Real overburden(const problem::Model<dim>&, Index, const std::string&, const settings::SoilPlace&);                             \
  template std::vector<FieldInfo> common_fields<dim>(const std::string&);                                                                  \
  template std::size_t bytes_of_point<dim>(int);                                                                                           \
  template std::vector<FrameRigid<dim>> frame_rigids(const problem::Model<dim>&, const std::vector<bodies::RigidState<dim>>&);
BERM_INSTANTIATE(2)
BERM_INSTANTIATE(3)
#undef BERM_INSTANTIATE

}  // namespace berm::run_folder
