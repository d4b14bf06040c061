// SPDX-License-Identifier: BSD-3-Clause
#include "run_folder/frame.hpp"

namespace berm::run_folder {

template <int dim>
std::vector<FrameRigid<dim>> frame_rigids(const problem::Model<dim>& model, const std::vector<bodies::RigidState<dim>>& rigids)
{
  std::vector<FrameRigid<dim>> shown;
  for (std::size_t r = 0; r < model.rigids.size(); ++r)
    shown.push_back({surface_of<dim>(placed<dim>(model.rigids[r], rigids[r]), model.mesh.lower, model.mesh.upper), rigids[r].velocity});
  return shown;
}

template std::vector<FrameRigid<2>> frame_rigids(const problem::Model<2>&, const std::vector<bodies::RigidState<2>>&);
template std::vector<FrameRigid<3>> frame_rigids(const problem::Model<3>&, const std::vector<bodies::RigidState<3>>&);

}  // namespace berm::run_folder
