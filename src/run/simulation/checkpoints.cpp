// SPDX-License-Identifier: BSD-3-Clause
#include "simulation/checkpoints.hpp"

#include "core/timer.hpp"
#include "io/atomic_file.hpp"
#include "io/log.hpp"

#include <fmt/format.h>

namespace berm::simulation {

namespace fs = std::filesystem;

fs::path checkpoints_in(const fs::path& run_folder)
{
  return run_folder / "checkpoint";
}

Checkpoints::Checkpoints(const fs::path& run_folder, Real wall_time) : folder_(checkpoints_in(run_folder)), wall_time_(wall_time) {}

bool Checkpoints::due() const
{
  return asked_ || (wall_time_ > 0 && Clock::now() - last_ >= std::chrono::duration<Real>(wall_time_));
}

void Checkpoints::write(BigIndex step, const run_folder::Contents& contents, io::WriterThread& thread, const std::function<void()>& vital,
                        const std::function<void()>& before)
{
  const Timer timer("write checkpoints");
  thread.wait_for(piece_);
  tell();
  std::function<void()> finish;
  try {
    finish = folder_.begin(step, contents);
  } catch (const RunError& error) {
    warn(step, error.what());
  }
  step_ = step;
  written_ = finish != nullptr;
  piece_ = thread.hand_over([vital, before, finish, fault = fault_.get()] {
    vital();
    if (finish) try {
        before();
        finish();
      } catch (const RunError& error) {
        fault->why = error.what();
        fault->there = true;
      }
  });
  last_ = Clock::now();
  asked_ = false;
}

bool Checkpoints::tell()
{
  if (!fault_->there) return written_;
  warn(step_, fault_->why);
  fault_->there = false;
  return written_ = false;
}

void Checkpoints::warn(BigIndex step, const std::string& why)
{
  io::warn("no checkpoint of step {}: {}", step, why);
}

bool Checkpoints::read(const run_folder::Contents& contents)
{
  const fs::path used = folder_.read(
      contents, [](const fs::path& file, const std::string& why) { io::warn("the checkpoint {} is not used: {}", file.string(), why); });
  if (!used.empty()) io::info("resumes from the checkpoint {}", used.string());
  return !used.empty();
}

void archive_same(Archive& k, const std::string& name, const std::string& own, const std::string& why)
{
  std::string found = own;
  k(name, found);
  if (found != own) k.refuse(why);
}

template <int dim>
void archive_same_mesh(Archive& k, const mesh::Mesh<dim>& mesh)
{
  const std::uint32_t of_positions =
      run_folder::crc_of(mesh.position.data(), sizeof(Vec<dim>) * static_cast<std::size_t>(mesh.node_count()));
  const std::uint32_t of_cells = run_folder::crc_of(mesh.nodes.data(), sizeof(mesh.nodes[0]) * static_cast<std::size_t>(mesh.cell_count()));
  const std::string own = fmt::format("{} nodes {:08x}, {} cells {:08x}", mesh.node_count(), of_positions, mesh.cell_count(), of_cells);
  archive_same(k, "mesh", own, "it is of another mesh");
}

void archive_history(Archive& k, const fs::path& history, BigIndex& bytes)
{
  // -1 where the file has not as many bytes.
  const auto crc_of_rows = [&] {
    const std::optional<std::uint32_t> crc = bytes < 0 ? std::nullopt : run_folder::crc_of(history, bytes);
    return crc ? static_cast<BigIndex>(*crc) : -1;
  };
  BigIndex crc = k.reads() ? 0 : crc_of_rows();
  k("bytes", bytes);
  k("crc", crc);
  if (crc < 0 || (k.reads() && crc != crc_of_rows()))
    k.refuse(fmt::format("{} has not the {} bytes any more that it had then", history.string(), bytes));
}

template void archive_same_mesh(Archive&, const mesh::Mesh<2>&);
template void archive_same_mesh(Archive&, const mesh::Mesh<3>&);

}  // namespace berm::simulation
