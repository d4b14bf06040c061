// SPDX-License-Identifier: BSD-3-Clause
#include "run_folder/frame.hpp"

namespace berm::run_folder {

template <int dim>
std::vector<FrameRigid<dim>> frame_rigids(const problem::Model<dim>& model, const std::vector<bodies::RigidState<dim>>& rigid_bodies)
{
  std::vector<FrameRigid<dim>> shown;
  for (std::size_t r = 0; r < model.rigid_bodies.size(); ++r)
    shown.push_back({surface_of<dim>(placed<dim>(model.rigid_bodies[r], rigid_bodies[r]), model.mesh.lower, model.mesh.upper),
                     rigid_bodies[r].velocity});
  return shown;
}

template std::vector<FrameRigid<2>> frame_rigids(const problem::Model<2>&, const std::vector<bodies::RigidState<2>>&);
template std::vector<FrameRigid<3>> frame_rigids(const problem::Model<3>&, const std::vector<bodies::RigidState<3>>&);

}  // namespace berm::run_folder
