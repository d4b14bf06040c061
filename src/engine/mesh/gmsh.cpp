// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/gmsh.hpp"

#include "mesh/doubled_nodes.hpp"
#include "mesh/line_reader.hpp"
#include "mesh/unconnected_faces.hpp"
#include "os/error.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <unordered_map>

namespace berm::mesh {
namespace {

constexpr BigIndex any_tag = std::numeric_limits<std::int32_t>::max();
constexpr BigIndex any_node_tag = std::numeric_limits<BigIndex>::max();
constexpr std::string_view of_partition = "_part{";  // begins the names of the groups that Gmsh adds where it partitions a mesh
constexpr const char* kinds[] = {"point", "curve", "surface", "volume"};

// A group by its name: the indices of the region or boundary that it becomes.
struct Group {
  int dimension;
  BigIndex tag;
  std::string name;
};

// Contents of the file, section by section. Sections pass on what later ones need.
template <int dim>
class Reader {
public:
  Reader(const std::filesystem::path& path, const GmshFile* settings) : name_(path.string()), lines_(path), settings_(settings)
  {
    for (int d = 0; d < 3; ++d) axis_[d] = d, factor_[d] = settings == nullptr ? 1 : settings->scale;
    if (settings == nullptr) return;
    bool taken[3] = {};
    for (std::size_t d = 0; d < settings->axes.size(); ++d) {
      const std::string& word = settings->axes[d];
      axis_[d] = word.back() - 'x';
      taken[axis_[d]] = true;
      if (word.front() == '-') factor_[d] = -factor_[d];
    }
    if (settings->axes.size() == 2) axis_[2] = !taken[0] ? 0 : !taken[1] ? 1 : 2;
    for (std::size_t d = 0; d < settings->shift.size(); ++d) shift_[static_cast<int>(d)] = settings->shift[d];
  }

  Mesh<dim> read()
  {
    read_format();
    while (lines_.next()) {
      const std::string section(lines_.text());
      constexpr std::size_t max = 60;
      if (section[0] != '$' || section.size() > max) lines_.fail_expected("the beginning of a section ($...)");
      const std::string name = section.substr(1);
      if (name == "PhysicalNames")
        read_names();
      else if (name == "Entities")
        read_entities();
      else if (name == "PartitionedEntities")
        read_partitioned_entities();
      else if (name == "Nodes")
        read_nodes();
      else if (name == "Elements")
        read_elements();
      else {
        skip_section(name);
        continue;
      }
      need_end_of(name);
    }
    return finish();
  }

private:
  void read_format()
  {
    if (!lines_.next() || lines_.text() != "$MeshFormat") lines_.fail("expected $MeshFormat: this is not a mesh file of Gmsh (.msh)");
    lines_.need("the version of the format: 4.1 0 8");
    const Real version = lines_.real("the version of the format: 4.1 0 8");
    if (version != 4.1)
      lines_.fail(fmt::format("the format is version {}, but 4.1 is needed: convert with \"gmsh {} -save -format msh41 -o NEW.msh\"",
                              version, name_));
    if (lines_.integer("0 for ASCII", 0, 1) == 1)
      lines_.fail(fmt::format(
          "the file is binary, but ASCII is needed: convert with \"gmsh {} -save -format msh41 -setnumber Mesh.Binary 0 -o NEW.msh\"",
          name_));
    need_end_of("MeshFormat");
  }

  void need_end_of(const std::string& section)
  {
    const std::string end = "$End" + section;
    lines_.need(end.c_str());
    if (lines_.text() != end) lines_.fail_expected(end.c_str());
  }

  void skip_section(const std::string& section)
  {
    const std::string end = "$End" + section;
    do lines_.need(end.c_str());
    while (lines_.text() != end);
  }

  void once(bool& seen, const char* section)
  {
    if (seen) lines_.fail(fmt::format("there is a second section {}", section));
    seen = true;
  }

  void read_names()
  {
    once(has_names_, "$PhysicalNames");
    lines_.need("the number of physical names");
    const BigIndex count = lines_.count("the number of physical names", 8);
    for (BigIndex n = 0; n < count; ++n) {
      constexpr const char* expected = "a physical name: dimension, tag, \"name\"";
      lines_.need(expected);
      const auto dimension = static_cast<int>(lines_.integer(expected, 0, 3));
      const BigIndex tag = lines_.integer(expected, 0, any_tag);
      const std::string_view line = lines_.text();
      const std::size_t first = line.find('"'), last = line.rfind('"');
      if (first == line.npos || last <= first + 1 || last + 1 != line.size()) lines_.fail_expected(expected);
      const std::string name(line.substr(first + 1, last - first - 1));
      if (std::any_of(name.begin(), name.end(), [](unsigned char c) { return c < ' ' || c == 0x7F; }))
        lines_.fail_expected("a physical name without control characters");
      if (!name.starts_with(of_partition)) group_index_[{dimension, tag}] = add_group(dimension, name);
    }
  }

  // The region (dimension = dim) or boundary of that name; a name may stand for groups of several dimensions or tags.
  Index add_group(int dimension, const std::string& name)
  {
    auto& names = dimension < dim ? mesh_.boundary_names : dimension == dim ? mesh_.region_names : higher_names_;
    const auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end()) return static_cast<Index>(found - names.begin());
    names.push_back(name);
    return static_cast<Index>(names.size()) - 1;
  }

  void read_entities()
  {
    once(has_entities_, "$Entities");
    constexpr const char* expected_counts = "the numbers of points, curves, surfaces and volumes";
    lines_.need(expected_counts);
    BigIndex counts[4];
    for (BigIndex& count : counts) count = lines_.count(expected_counts, 8);
    for (int dimension = 0; dimension < 4; ++dimension)
      for (BigIndex n = 0; n < counts[dimension]; ++n) read_entity(dimension);
  }

  // The parts of the entities: elements name these where the mesh is partitioned. Elements on the far side of a border (ghosts) are in a section of their own.
  void read_partitioned_entities()
  {
    if (!has_entities_) lines_.fail("$PartitionedEntities comes before $Entities");
    once(has_partitions_, "$PartitionedEntities");
    constexpr const char *expected_parts = "the number of partitions", *expected_ghosts = "the number of ghost entities";
    constexpr const char* expected_counts = "the numbers of points, curves, surfaces and volumes";
    lines_.need(expected_parts);
    lines_.integer(expected_parts, 0, any_tag);
    lines_.need(expected_ghosts);
    const BigIndex ghosts = lines_.count(expected_ghosts, 4);
    for (BigIndex n = 0; n < ghosts; ++n) lines_.need("a ghost entity: tag and partition");
    lines_.need(expected_counts);
    BigIndex counts[4];
    for (BigIndex& count : counts) count = lines_.count(expected_counts, 8);
    for (int dimension = 0; dimension < 4; ++dimension)
      for (BigIndex n = 0; n < counts[dimension]; ++n) read_entity(dimension, true);
  }

  void read_entity(int dimension, bool is_part = false)
  {
    const std::string expected =
        fmt::format("a {}: tag,{} {} coordinates, number of physical tags and the tags", kinds[dimension],
                    is_part ? " dimension and tag of what it is a part of, number of partitions and these," : "", dimension == 0 ? 3 : 6);
    lines_.need(expected.c_str());
    const BigIndex tag = lines_.integer(expected.c_str(), -any_tag, any_tag);
    if (is_part) {
      lines_.integer(expected.c_str(), -1, 3);
      lines_.integer(expected.c_str(), -any_tag, any_tag);
      const BigIndex partitions = lines_.count(expected.c_str(), 1);
      for (BigIndex n = 0; n < partitions; ++n) lines_.integer(expected.c_str(), 0, any_tag);
      entity_groups_.erase({dimension, tag});  // a whole that has the number of one of its parts
    }
    for (int k = 0; k < (dimension == 0 ? 3 : 6); ++k) lines_.real(expected.c_str());
    const BigIndex count = lines_.count(expected.c_str(), 1);
    std::vector<Index> groups;
    for (BigIndex n = 0; n < count; ++n) {
      const BigIndex group = lines_.integer(expected.c_str(), -any_tag, any_tag);
      const auto named = group_index_.find({dimension, std::abs(group)});
      if (named != group_index_.end()) groups.push_back(named->second);
    }
    std::sort(groups.begin(), groups.end());
    groups.erase(std::unique(groups.begin(), groups.end()), groups.end());
    if (dimension == dim && groups.size() > 1)
      lines_.fail(fmt::format("{} {} is in the groups \"{}\" and \"{}\"; a cell is in one region only: take it out of one of them, or name "
                              "a third group of what they share",
                              kinds[dimension], tag, mesh_.region_names[groups[0]], mesh_.region_names[groups[1]]));
    if (!entity_groups_.emplace(std::pair{dimension, tag}, std::move(groups)).second)
      lines_.fail(fmt::format("{} {} is defined twice", kinds[dimension], tag));
  }

  // The head of a block of nodes or elements: the groups of its entity.
  struct Block {
    int dimension;
    const std::vector<Index>* groups;
    BigIndex third;  // whether nodes are parametric, or the type of the elements
    BigIndex count;
  };
  Block read_block(const char* expected, BigIndex max_third, BigIndex bytes)
  {
    static const std::vector<Index> no_groups;
    lines_.need(expected);
    Block block{};
    block.dimension = static_cast<int>(lines_.integer(expected, 0, 3));
    const BigIndex tag = lines_.integer(expected, -any_tag, any_tag);
    block.third = lines_.integer(expected, 0, max_third);
    block.count = lines_.count(expected, bytes);
    lines_.need_end(expected);
    const auto entity = entity_groups_.find({block.dimension, tag});
    if (has_entities_ && entity == entity_groups_.end())
      lines_.fail(fmt::format("{} {} is not among the entities of the file", kinds[block.dimension], tag));
    block.groups = entity == entity_groups_.end() ? &no_groups : &entity->second;
    return block;
  }

  void read_nodes()
  {
    once(has_nodes_, "$Nodes");
    constexpr const char* expected_counts = "the numbers of blocks and nodes, the smallest and the largest node tag";
    lines_.need(expected_counts);
    const BigIndex blocks = lines_.count(expected_counts, 8), total = lines_.count(expected_counts, 8);
    if (total > std::numeric_limits<Index>::max() - 1) lines_.fail(fmt::format("{} nodes are more than can be numbered", total));
    node_index_.reserve(total);
    for (BigIndex b = 0; b < blocks; ++b) {
      const Block block = read_block("a block of nodes: dimension, entity, 0 or 1 (parametric), number of nodes", 1, 8);
      const Index first = static_cast<Index>(points_.size());
      for (BigIndex n = 0; n < block.count; ++n) {
        lines_.need("a node tag");
        const BigIndex tag = lines_.integer("a node tag", 1, any_node_tag);
        lines_.need_end("a node tag");
        if (!node_index_.emplace(tag, first + static_cast<Index>(n)).second) lines_.fail(fmt::format("node {} is defined twice", tag));
      }
      for (BigIndex n = 0; n < block.count; ++n) {
        lines_.need("the coordinates x y z of a node");
        Vec<3> x;
        for (int d = 0; d < 3; ++d) x[d] = lines_.real("the coordinates x y z of a node");
        points_.push_back(placed(x));
      }
    }
    if (static_cast<BigIndex>(points_.size()) != total)
      lines_.fail(fmt::format("the blocks up to here hold {} nodes, but the section began with {}", points_.size(), total));
  }

  // Where a point of the file is, m.
  Vec<3> placed(const Vec<3>& x) const
  {
    Vec<3> y;
    for (int d = 0; d < 3; ++d) y[d] = factor_[d] * x[axis_[d]] + shift_[d];
    return y;
  }

  void read_elements()
  {
    once(has_elements_, "$Elements");
    if (!has_nodes_) lines_.fail("$Elements comes before $Nodes");
    if (!has_entities_) lines_.fail("there is no section $Entities before $Elements: without it no cell has a physical group");
    for (const auto& point : points_) mesh_.position.push_back(point.template head<dim>());
    mesh_.boundary_nodes.resize(mesh_.boundary_names.size());
    constexpr const char* expected_counts = "the numbers of blocks and elements, the smallest and the largest element tag";
    lines_.need(expected_counts);
    const BigIndex blocks = lines_.count(expected_counts, 8), total = lines_.count(expected_counts, 4);
    BigIndex read = 0;
    for (BigIndex b = 0; b < blocks; ++b) {
      const Block block = read_block("a block of elements: dimension, entity, type of element, number of elements", 1000, 4);
      if (block.groups->empty())
        skip_elements(block);
      else if (block.dimension < dim)
        read_boundary(block);
      else
        read_cells(block);
      read += block.count;
    }
    if (read != total) lines_.fail(fmt::format("the blocks up to here hold {} elements, but the section began with {}", read, total));
  }

  void skip_elements(const Block& block)
  {
    for (BigIndex n = 0; n < block.count; ++n) {
      lines_.need("an element");
      lines_.integer("an element tag", 1, any_node_tag);
    }
  }

  Index node(const char* expected)
  {
    const BigIndex tag = lines_.integer(expected, 1, any_node_tag);
    const auto found = node_index_.find(tag);
    if (found == node_index_.end()) lines_.fail(fmt::format("node {} is not among the nodes of the file", tag));
    return found->second;
  }

  void read_boundary(const Block& block)
  {
    for (BigIndex n = 0; n < block.count; ++n) {
      lines_.need("an element tag and its node tags");
      lines_.integer("an element tag", 1, any_node_tag);
      do {
        const Index i = node("an element tag and its node tags");
        for (const Index boundary : *block.groups) mesh_.boundary_nodes[boundary].push_back(i);
      } while (!lines_.at_end());
    }
  }

  void read_cells(const Block& block)
  {
    constexpr BigIndex simplex = dim == 2 ? 2 : 4;
    constexpr const char* expected = dim == 2 ? "an element tag and the tags of the 3 nodes of a triangle"
                                              : "an element tag and the tags of the 4 nodes of a tetrahedron";
    constexpr BigIndex of_second_order = dim == 2 ? 9 : 11;
    if (block.dimension > dim) lines_.fail("a named group of volumes cannot be in a plane mesh; is the case 3D?");
    const bool middles = block.third == of_second_order;
    has_middles_ = has_middles_ || middles;
    if (block.third != simplex && !middles)
      lines_.fail(fmt::format("a named group has elements of type {} ({}), but cells must be {} (type {})", block.third,
                              name_of_type(block.third), dim == 2 ? "triangles" : "tetrahedra", simplex));
    for (BigIndex n = 0; n < block.count; ++n) {
      lines_.need(expected);
      lines_.integer(expected, 1, any_node_tag);
      typename Mesh<dim>::Corners corner;
      for (Index& i : corner) {
        i = node(expected);
        if (dim == 2 && std::abs(points_[i][2]) > 1e-9 * points_[i].norm())
          lines_.fail(fmt::format(
              "a plane mesh must lie in z = 0, but a node of this triangle is at z = {} m; mesh.axes = [\"x\", \"z\"] takes the x and z "
              "of the file as x and y",
              points_[i][2]));
      }
      for (int k = 0; k < (middles ? dim * (dim + 1) / 2 : 0); ++k) node("an element of second order with all its nodes");
      lines_.need_end(expected);
      mesh_.nodes.push_back(corner);
      mesh_.region.push_back(block.groups->front());
    }
  }

  static const char* name_of_type(BigIndex type)
  {
    switch (type) {
    case 2:
      return "triangles";
    case 3:
      return "quadrangles";
    case 4:
      return "tetrahedra";
    case 5:
      return "hexahedra";
    case 6:
      return "prisms";
    case 7:
      return "pyramids";
    default:
      return "of another shape or order";
    }
  }

  Mesh<dim> finish()
  {
    const auto missing = [&](const char* section) { lines_.fail(fmt::format("the file ends without a section {}", section)); };
    if (!has_entities_) missing("$Entities");
    if (!has_nodes_) missing("$Nodes");
    if (!has_elements_) missing("$Elements");
    if (mesh_.cell_count() == 0)
      throw InputError(fmt::format("{}: no {} is in a named physical group: name one with Physical {}(\"bed\") = {{...}};", name_,
                                   dim == 2 ? "triangle" : "tetrahedron", dim == 2 ? "Surface" : "Volume"));
    if (has_middles_)
      mesh_.remarks.push_back(fmt::format("has {} of second order: their corners are used, with straight sides between them",
                                          dim == 2 ? "triangles" : "tetrahedra"));
    const bool is_of_user = settings_ != nullptr && !settings_->made_from;
    if (is_of_user) join_doubled_nodes(mesh_, settings_->merge_tolerance, name_);
    try {
      mesh_.complete();
    } catch (const RunError& error) {
      throw InputError(fmt::format("{}: {}", name_, error.what()));
    }
    if (is_of_user) refuse_unconnected_faces(mesh_, name_);
    return std::move(mesh_);
  }

  std::string name_;
  Lines lines_;
  Mesh<dim> mesh_;
  const GmshFile* settings_;  // null: of a mesh that berm made
  int axis_[3];
  Real factor_[3];
  Vec<3> shift_ = Vec<3>::Zero();
  bool has_names_ = false, has_entities_ = false, has_partitions_ = false, has_nodes_ = false, has_elements_ = false, has_middles_ = false;
  std::vector<std::string> higher_names_;
  std::map<std::pair<int, BigIndex>, Index> group_index_;                 // (dimension, physical tag)
  std::map<std::pair<int, BigIndex>, std::vector<Index>> entity_groups_;  // (dimension, entity tag)
  std::unordered_map<BigIndex, Index> node_index_;
  std::vector<Vec<3>> points_;
};

}  // namespace

void describe(Describe& d, GmshFile& mesh)
{
  d.value("file", mesh.file,
          {.meaning = "mesh of Gmsh (.msh, format 4.1, ASCII), or a geometry (.geo) for Gmsh to mesh; its path relative to this file",
           .required = true});
  d.value("scale", mesh.scale, {.meaning = "metres per unit of the file: 0.001 for a mesh in millimetres", .range = positive});
  d.value("axes", mesh.axes,
          {.meaning = "which coordinates of the file become x, y (and z), such as [\"x\", \"z\"] of a section drawn in x and z, or "
                      "[\"x\", \"z\", \"-y\"] of a mesh with z up; left out, they are unchanged"});
  d.value("shift", mesh.shift, {.meaning = "added to the coordinates, after axes and scale", .unit = "m"});
  d.value("merge_tolerance", mesh.merge_tolerance,
          {.meaning =
               "nodes no farther apart are merged, for meshes whose parts do not share nodes; left out, nodes at one position are refused",
           .unit = "m",
           .range = positive});
}

void check_axes(Describe& d, const std::string& path, const std::vector<std::string>& axes, int dimension)
{
  static const std::vector<std::string> words = {"x", "y", "z", "-x", "-y", "-z"};
  d.check(axes.empty() || axes.size() == static_cast<std::size_t>(dimension), path,
          fmt::format("needs {} axes, and has {}", dimension, axes.size()));
  for (std::size_t k = 0; k < axes.size(); ++k) {
    d.check(std::find(words.begin(), words.end(), axes[k]) != words.end(), path, fmt::format("\"{}\" is not an axis", axes[k]), words);
    for (std::size_t other = 0; other < k; ++other)
      d.check(axes[k].empty() || axes[other].empty() || axes[k].back() != axes[other].back(), path,
              fmt::format("takes {} of the file twice", axes[k].empty() ? ' ' : axes[k].back()));
  }
}

template <int dim>
Mesh<dim> read_msh(const std::filesystem::path& path)
{
  return Reader<dim>(path, nullptr).read();
}

template <int dim>
Mesh<dim> read_msh(const std::filesystem::path& path, const GmshFile& settings)
{
  return Reader<dim>(path, &settings).read();
}

template Mesh<2> read_msh<2>(const std::filesystem::path&);
template Mesh<3> read_msh<3>(const std::filesystem::path&);
template Mesh<2> read_msh<2>(const std::filesystem::path&, const GmshFile&);
template Mesh<3> read_msh<3>(const std::filesystem::path&, const GmshFile&);

}  // namespace berm::mesh
