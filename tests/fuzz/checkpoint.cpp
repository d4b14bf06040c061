// SPDX-License-Identifier: BSD-3-Clause
// A checkpoint that is damaged. An input is changes to one that is whole; its first byte says to what of it:
//   h  its first bytes, which are replaced by those of the input
//   f  any bytes behind them. Length and CRC-32 are made right again, so that HDF5 sees them.
//   2, 3  the lists of numbers that are the state of a small run in the plane or in space, as HDF5 would give them
// It is refused in one line, or the run goes on from it and ends in RunError at worst. The whole one, read after it into the same run, gives the
// same bits as ever.
#include "target.hpp"

#include "input/read_case.hpp"
#include "io/atomic_file.hpp"
#include "mpm/diagnose.hpp"
#include "mpm/step.hpp"
#include "os/error.hpp"
#include "problem/archive_state.hpp"
#include "problem/stages.hpp"
#include "run_folder/checkpoint_file.hpp"
#include "run_folder/frame_maker.hpp"

#include <cstring>
#include <memory>

using namespace berm;

namespace {

namespace fs = std::filesystem;

/// The bytes of an input, taken one number after the other; zeros where there are no more.
class Input {
public:
  Input(const std::uint8_t* data, std::size_t size) : data_(data), left_(size) {}

  bool empty() const { return left_ == 0; }
  template <class Number>
  Number take()
  {
    Number number{};
    const std::size_t bytes = std::min(left_, sizeof(Number));
    std::memcpy(&number, data_, bytes);
    data_ += bytes, left_ -= bytes;
    return number;
  }
  std::string text(std::size_t max)
  {
    const std::size_t bytes = std::min(left_, max);
    std::string taken = text_of(data_, bytes);
    data_ += bytes, left_ -= bytes;
    return taken;
  }

private:
  const std::uint8_t* data_;
  std::size_t left_;
};

/// True where it is taken.
template <class Read>
bool may_be_refused(const Read& read)
{
  try {
    read();
    return true;
  } catch (const RunError& error) {
    promise_one_line(error.what());
    return false;
  }
}

/// What is read from a file: something of every kind.
void keep_sample(Archive& k)
{
  Real real = 0.5;
  Index index = 7;
  BigIndex big = 9;
  std::optional<Real> given = 1.;
  Vec<3> vec(1, 2, 3);
  std::vector<Real> reals(20, 0.25);
  std::vector<Index> indices = {1, 2, 3};
  std::string text = "words\n";
  k("real", real);
  k("index", index);
  k.table("table", [&] {
    k("big", big);
    k("given", given);
    k("vec", vec);
  });
  k("reals", reals);
  k("indices", indices);
  k("text", text);
}

constexpr std::size_t header_bytes = 512;

std::string whole_file()
{
  const fs::path path = fs::path("/dev/shm") / fmt::format("berm_fuzz_{}.h5", ::getpid());
  run_folder::write_checkpoint(path, keep_sample);
  const std::string bytes = io::read_text_file(path);
  fs::remove(path);
  return bytes;
}

/// The first bytes of a file with the length and sum of what is behind them.
std::string with_true_header(const std::string& file)
{
  const std::string content = file.substr(std::min(file.size(), header_bytes));
  std::size_t line = file.find('\n');
  line = file.find('\n', line + 1) + 1;
  std::string header = file.substr(0, line) + fmt::format("{} bytes, CRC-32 {:08x} from byte {} on\n", header_bytes + content.size(),
                                                          run_folder::crc_of(content.data(), content.size()), header_bytes);
  header.resize(header_bytes, '\n');
  return header + content;
}

void read_file(const std::string& bytes)
{
  static const MemoryFile file;
  const fs::path& path = file.hold(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  may_be_refused([&] { run_folder::read_checkpoint(path, keep_sample); });
}

void change_header(Input input)
{
  static const std::string whole = whole_file();
  const std::string first = input.text(header_bytes);
  read_file(first);
  read_file(first + whole.substr(first.size()));
}

void change_file(Input input)
{
  static const std::string whole = whole_file();
  std::string file = whole;
  while (!input.empty()) {
    const auto change = input.take<std::uint8_t>();
    const std::size_t length = change / 4 % 16 + 1;
    const std::size_t place = header_bytes + input.take<std::uint16_t>() % (file.size() - header_bytes + 1);
    switch (change % 4) {
    case 0:
      file.replace(place, std::min(length, file.size() - place), input.text(length));
      break;
    case 1:
      file.insert(place, input.text(length));
      break;
    case 2:
      file.erase(place, length);
      break;
    default:
      if (length == 1) file.resize(place);
    }
  }
  read_file(with_true_header(file));
}

/// A list of a checkpoint, by its bytes.
struct List {
  std::string name;
  std::size_t width;  ///< bytes of one number
  bool real;
  std::string bytes;

  std::size_t count() const { return bytes.size() / width; }
};
/// Lists that several share are copied only where they are changed.
using Lists = std::vector<std::shared_ptr<const List>>;

template <class Values>
std::string_view bytes_of(const Values& values)
{
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(typename Values::value_type)};
}

class ToLists : public Archive {
public:
  bool reads() const override { return false; }
  void refuse(const std::string& why) const override { throw RunError(why); }
  Lists lists;

protected:
  void list(const std::string& path, std::vector<Real>& numbers) override { add(path, true, numbers); }
  void list(const std::string& path, std::vector<Index>& numbers) override { add(path, false, numbers); }
  void list(const std::string& path, std::vector<BigIndex>& numbers) override { add(path, false, numbers); }
  void list(const std::string& path, std::string& text) override { add(path, false, text); }

private:
  template <class Values>
  void add(const std::string& path, bool real, const Values& values)
  {
    lists.push_back(std::make_shared<List>(List{path, sizeof(typename Values::value_type), real, std::string(bytes_of(values))}));
  }
};

/// Whether what is kept has the same bits.
class Compares : public Archive {
public:
  explicit Compares(const Lists& lists) : lists_(lists) {}
  bool reads() const override { return false; }
  void refuse(const std::string& why) const override { throw RunError(why); }
  bool same() const { return same_ && next_ == lists_.size(); }

protected:
  void list(const std::string& path, std::vector<Real>& numbers) override { compare(path, bytes_of(numbers)); }
  void list(const std::string& path, std::vector<Index>& numbers) override { compare(path, bytes_of(numbers)); }
  void list(const std::string& path, std::vector<BigIndex>& numbers) override { compare(path, bytes_of(numbers)); }
  void list(const std::string& path, std::string& text) override { compare(path, text); }

private:
  void compare(const std::string& path, std::string_view bytes)
  {
    same_ = same_ && next_ < lists_.size() && lists_[next_]->name == path && lists_[next_]->bytes == bytes;
    ++next_;
  }

  const Lists& lists_;
  std::size_t next_ = 0;
  bool same_ = true;
};

class FromLists : public Archive {
public:
  explicit FromLists(const Lists& lists) : lists_(lists) {}
  bool reads() const override { return true; }
  void refuse(const std::string& why) const override { throw RunError(why); }

protected:
  void list(const std::string& path, std::vector<Real>& numbers) override { put(path, numbers); }
  void list(const std::string& path, std::vector<Index>& numbers) override { put(path, numbers); }
  void list(const std::string& path, std::vector<BigIndex>& numbers) override { put(path, numbers); }
  void list(const std::string& path, std::string& text) override { put(path, text); }

private:
  template <class Values>
  void put(const std::string& path, Values& values)
  {
    if (next_ >= lists_.size() || lists_[next_]->name != path) refuse("it has no " + path);
    const List& found = *lists_[next_++];
    values.resize(found.count());
    if (!values.empty()) std::memcpy(values.data(), found.bytes.data(), found.bytes.size());
  }

  const Lists& lists_;
  std::size_t next_ = 0;
};

constexpr Real odd_reals[] = {0,     -0.,    1,      -1,     infinity, -infinity, std::numeric_limits<Real>::quiet_NaN(),
                              1e308, -1e308, 1e-308, 5e-324, 1e9};
constexpr BigIndex odd_integers[] = {
    0, 1, -1, 7, 8, 9, 0x7fffffff, -0x7fffffff - 1, std::numeric_limits<BigIndex>::max(), std::numeric_limits<BigIndex>::min()};

/// One change: another number, other length, a list of another name, or one that is missing.
void change(Lists& lists, Input& input)
{
  const auto what = input.take<std::uint8_t>();
  const std::size_t which = input.take<std::uint8_t>() % lists.size();
  const auto changed = std::make_shared<List>(*lists[which]);
  List& list = *changed;
  const std::size_t place = list.count() == 0 ? 0 : input.take<std::uint8_t>() % list.count();
  char* number = list.bytes.data() + place * list.width;
  switch (what % 6) {
  case 0:
    if (list.count() > 0) {
      const auto bits = input.take<std::uint64_t>();
      std::memcpy(number, &bits, list.width);
    }
    break;
  case 1:
    if (list.count() > 0) {
      const auto choice = input.take<std::uint8_t>();
      if (list.real)
        std::memcpy(number, &odd_reals[choice % std::size(odd_reals)], list.width);
      else
        std::memcpy(number, &odd_integers[choice % std::size(odd_integers)], list.width);
    }
    break;
  case 2:
    list.bytes.resize(list.width * (input.take<std::uint16_t>() % 1000));
    break;
  case 3:
    if (list.count() > 0) list.bytes.replace(place * list.width, list.width, list.bytes.substr(0, list.width));
    break;
  case 4: {
    const List& other = *lists[input.take<std::uint8_t>() % lists.size()];
    if (other.width == list.width) list.bytes = other.bytes;
    break;
  }
  default:
    lists.erase(lists.begin() + static_cast<std::ptrdiff_t>(which));
    return;
  }
  lists[which] = changed;
}

/// Two bodies, a disk (cylinder) that is pushed and dragged, as few cells as hold all that, one of them with more particles than a block holds. 0 to 3: a
/// third number of gravity, of a centre, of a size, of cells; 4: geometry; 5: more supports.
constexpr const char* small_case = R"(geometry = "{4}"
gravity = [0, -10{0}]
surface = 0.5
mesh = {{kind = "box", size = [1, 1{2}], cells = [2, 1{3}]}}
material.sand = {{law = "mohr_coulomb", density = 1600, young_modulus = 1e6, poisson_ratio = 0.3, friction_angle = 0.6, dilation_angle = 0.1}}
material.solid = {{law = "linear_elastic", density = 1500, young_modulus = 1e6, poisson_ratio = 0.3}}
body.left = {{material = "sand", block = {{center = [0.25, 0.25{1}], size = [0.5, 0.5{2}], spacing = 0.17}}}}
body.right = {{material = "solid", damping = 0.1, block = {{center = [0.75, 0.25{1}], size = [0.5, 0.5{2}], spacing = 0.25}}}}
rigid.disk = {{shape = "circle", center = [0.3, 0.62{1}], diameter = 0.24, mass = 10}}
contact.skin = {{body = "left", rigid = "disk", friction_angle = 0.4}}
contact.between = {{body = "left", other_body = "right", friction_angle = 0.3}}
support.base = {{boundary = "bottom", fixed = ["x", "y"]}}
support.left = {{boundary = "left", fixed = ["x"]}}
support.right = {{boundary = "right", fixed = ["x"]}}
{5}
watch.mark = {{body = "right", point = [0.7, 0.3{1}]}}
stage = [{{name = "push", kind = "push", velocity = 0.25, until.time = 1}},
         {{name = "drag", kind = "drag", velocity = 0.25, until.displacement = 0.01}}]
)";

template <int dim>
problem::Problem<dim> small_problem()
{
  const auto third = [](const char* text) { return dim == 3 ? text : ""; };
  const std::string text =
      fmt::format(small_case, third(", 0"), third(", 0.125"), third(", 0.25"), third(", 1"), dim == 3 ? "space" : "plane_strain",
                  third("support.front = {boundary = \"front\", fixed = [\"z\"]}\nsupport.back = {boundary = \"back\", fixed = [\"z\"]}"));
  return problem::build<dim>(input::read_case_text("small.toml", text), "", "/dev/shm");
}

/// A run of the material point method: its state, and what its next frame counts from.
template <int dim>
class SmallRun {
public:
  SmallRun()
  {
    mpm::Workspace<dim> workspace(problem_.model, problem_.state);
    for (int n = 0; n < 37; ++n) step(problem_.model, problem_.state, workspace);
    frame_maker_.make(problem_.state);
    ToLists to;
    archive(to);
    whole_ = to.lists;
  }

  void read_changed(Input input)
  {
    Lists changed = whole_;
    while (!input.empty() && !changed.empty()) change(changed, input);
    FromLists from(changed);
    if (may_be_refused([&] { archive(from); })) may_be_refused([&] { go_on(); });
    FromLists again(whole_);
    archive(again);
    Compares compares(whole_);
    archive(compares);
    promise(compares.same(), "a checkpoint gives its bits back whatever was read before", "");
  }

private:
  void archive(Archive& k)
  {
    k.table("state", [&] { problem::archive(k, problem_.model, problem_.state); });
    k.table("increments", [&] { frame_maker_.archive(k, problem_.state.lengthened); });
  }
  void go_on() const
  {
    problem::State<dim> state = problem_.state;
    run_folder::FrameMaker<dim> frames = frame_maker_;
    mpm::Workspace<dim> workspace(problem_.model, state);
    for (int n = 0; n < 2; ++n) {
      step(problem_.model, state, workspace);
      mpm::refuse_rigid_outside_mesh(problem_.model, state);
      if (stage_ended(problem_.model, state)) break;
    }
    frames.make(state);
  }

  problem::Problem<dim> problem_ = small_problem<dim>();
  run_folder::FrameMaker<dim> frame_maker_{problem_.model, problem_.state};
  Lists whole_;
};

template <int dim>
void change_state(Input input)
{
  static SmallRun<dim> run;
  run.read_changed(input);
}

}  // namespace

/// HDF5 keeps some hundred bytes where it refuses a file whose own tables are damaged.
extern "C" const char* __lsan_default_suppressions()
{
  return "leak:libhdf5";
}

/// HDF5 asks for as much memory as a damaged table names, and says so where it does not get it.
extern "C" const char* __asan_default_options()
{
  return "allocator_may_return_null=1:max_allocation_size_mb=4096";
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  Input input(data, size);
  switch (input.take<char>()) {
  case 'h':
    change_header(input);
    break;
  case 'f':
    change_file(input);
    break;
  case '3':
    change_state<3>(input);
    break;
  default:
    change_state<2>(input);
  }
  return 0;
}
