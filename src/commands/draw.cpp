// SPDX-License-Identifier: BSD-3-Clause
#include "commands/case_options.hpp"
#include "commands/command.hpp"
#include "fem/cut_mesh.hpp"
#include "io/atomic_file.hpp"
#include "io/scratch_folder.hpp"
#include "os/error.hpp"
#include "picture/model_picture.hpp"

#include <fmt/format.h>

namespace berm::commands {
namespace {

namespace fs = std::filesystem;

struct Picture {
  simulation::RunRequest request;
  fs::path file;
};

/// Where each picture goes: beside its run folder, of one case to the file that -o names, of several to files of their names in the folder that it names.
std::vector<Picture> pictures(const CaseOptions& options)
{
  std::vector<Picture> all;
  for (simulation::RunRequest& request : requests(options)) {
    const bool named = !options.output.empty() && options.files.size() == 1;
    const fs::path file = options.output == "-" ? fs::path("-") : named ? request.folder : fs::path(request.folder.string() + ".png");
    if (file != "-" && file.extension() != ".png" && file.extension() != ".svg")
      throw InputError(fmt::format("-o {}: the picture of a case is a .png or an .svg; name it so", options.output));
    all.push_back({std::move(request), file});
  }
  return all;
}

mesh::Mesh<2> mesh_of(const simulation::RunRequest& request, const fs::path& work_folder)
{
  const fs::path folder = request.case_file.parent_path();
  return request.settings.method == settings::Method::fem ? fem::make_cut_mesh(request.settings, folder, work_folder)
                                                          : mesh::make_mesh<2>(request.settings.mesh, folder, work_folder);
}

/// To the file of the picture; "-" is the standard output, for an SVG.
void draw(const Picture& picture)
{
  const io::ScratchFolder scratch;
  const fs::path file = picture.file == "-" ? scratch.path() / "model.svg" : picture.file;
  const settings::Case& settings = picture.request.settings;
  try {
    if (settings.dimension() == 2)
      picture::draw_model(settings, mesh_of(picture.request, scratch.path()), file);
    else
      picture::draw_space(settings, mesh::make_mesh<3>(settings.mesh, picture.request.case_file.parent_path(), scratch.path()), file);
  } catch (const KeyError& error) {
    throw input::LocatedError(picture.request.places.located(error));
  }
  if (picture.file == "-")
    fmt::print("{}", io::read_text_file(file));
  else
    fmt::print("{}\n", file.string());
}

}  // namespace

Command add_draw(CLI::App& program)
{
  const auto options = std::make_shared<CaseOptions>();
  CLI::App* app = program.add_subcommand("draw", "draw the model of a case before it is run; gmsh runs the geometry (.geo) that it names");
  options->take_cases(*app);
  options->take_stdin(*app);
  options->take_no_programs(*app);
  options->take_sandbox(*app);
  app->add_option("-o,--output", options->output,
                  "picture to write (.png or .svg; -: an SVG to the standard output); of several cases: the folder that theirs go into "
                  "(default: out/FOLDER/NAME.png of "
                  "FOLDER/NAME.toml)");
  return {app, [options] {
            messages_to_stderr();
            const std::vector<Picture> all = pictures(*options);
            std::vector<fs::path> folders;
            for (const Picture& picture : all) folders.push_back(fs::absolute(picture.file).parent_path());
            options->enter_sandbox(false, folders);
            for (const Picture& picture : all) draw(picture);
            return 0;
          }};
}

}  // namespace berm::commands
