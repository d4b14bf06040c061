// SPDX-License-Identifier: BSD-3-Clause
// berm.engine: include/berm/berm.hpp in Python. Numbers are seen where they lie; the interpreter is free for other threads while the run steps.
#include <berm/berm.hpp>
#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <array>
#include <filesystem>

namespace py = pybind11;
using namespace py::literals;

void add_macro_element(py::module_& module);  // macro_element.cpp

namespace {

using Path = std::filesystem::path;

/// An array on memory of the run, which lives as long as the array does; it cannot be written to.
py::array view(const py::object& run, const berm::ParticleField& field)
{
  const auto size = static_cast<py::ssize_t>(field.is_integer ? sizeof(std::int32_t) : sizeof(double));
  const py::dtype type = field.is_integer ? py::dtype::of<std::int32_t>() : py::dtype::of<double>();
  std::vector<py::ssize_t> shape = {static_cast<py::ssize_t>(field.blocks), static_cast<py::ssize_t>(field.lanes)};
  std::vector<py::ssize_t> strides = {static_cast<py::ssize_t>(field.block_stride), size};
  if (field.components > 1) {
    shape.insert(shape.begin() + 1, static_cast<py::ssize_t>(field.components));
    strides.insert(strides.begin() + 1, static_cast<py::ssize_t>(field.component_stride));
  }
  py::array array(type, shape, strides, field.data, run);
  array.attr("flags").attr("writeable") = false;
  return array;
}

/// Numbers that a law gets, in memory of the caller: valid during the call only.
py::array during_call(double* numbers, std::size_t count)
{
  return py::array(py::dtype::of<double>(), {static_cast<py::ssize_t>(count)}, {}, numbers, py::capsule(numbers, [](void*) {}));
}

/// Throws TypeError for what cannot be called.
py::function callable(const py::handle& given, const char* what)
{
  if (PyCallable_Check(given.ptr()) == 0)
    throw py::type_error(std::string(what) + ": not a function: " + py::repr(given).cast<std::string>());
  return py::reinterpret_borrow<py::function>(given);
}

/// A run with what its laws threw: the program would only say that a law failed.
class PythonRun {
public:
  /// act() while other threads may use the interpreter. What a law threw goes on here.
  template <class Act>
  auto freely(const Act& act)
  {
    try {
      const py::gil_scoped_release free;
      return act();
    } catch (const std::exception&) {
      if (!*thrown_) throw;
      std::exception_ptr thrown;
      std::swap(thrown, *thrown_);
      std::rethrow_exception(thrown);
    }
  }

  PythonRun(const Path& case_file, const py::dict& set, const Path& folder, bool replace, int threads, const py::dict& laws,
            const py::object& message, const Path& resume)
  {
    berm::RunOptions options;
    for (const auto& [key, value] : set) {
      const py::str text = py::module_::import("berm.program").attr("toml_value")(value);
      options.set.push_back(key.cast<std::string>() + "=" + text.cast<std::string>());
    }
    options.folder = folder.string();
    options.replace = replace;
    options.threads = threads;
    for (const auto& [material, law] : laws) options.laws[material.cast<std::string>()] = law_of(callable(law, "laws"));
    if (!message.is_none())
      options.message = [take = Callable(callable(message, "message"))](const std::string& line) {
        const py::gil_scoped_acquire held;
        try {
          take.function()(line);
        } catch (py::error_already_set& error) {
          error.discard_as_unraisable("berm.engine: message");
        }
      };
    if (case_file.empty() == resume.empty()) throw berm::InputError("either a case to run or a folder to resume must be given");
    const auto made = [&] { return resume.empty() ? berm::Run(case_file.string(), options) : berm::Run::resume(resume.string(), options); };
    run_ = freely([&] { return std::make_unique<berm::Run>(made()); });
  }
  ~PythonRun()
  {
    const py::gil_scoped_release free;
    run_.reset();
  }

  berm::Run& run() { return *run_; }

  std::unique_ptr<PythonRun> clone(const Path& folder)
  {
    std::unique_ptr<PythonRun> other(new PythonRun);
    other->thrown_ = thrown_;
    other->run_ = freely([&] { return std::make_unique<berm::Run>(run_->clone(folder.string())); });
    return other;
  }

private:
  PythonRun() = default;

  /// A function of Python that is copied and dropped without the interpreter.
  class Callable {
  public:
    explicit Callable(py::function function)
        : function_(new py::function(std::move(function)), [](py::function* dropped) {
            const py::gil_scoped_acquire held;
            delete dropped;
          })
    {
    }
    const py::function& function() const { return *function_; }

  private:
    std::shared_ptr<py::function> function_;
  };

  std::function<int(berm_law_increment*)> law_of(py::function law)
  {
    return [thrown = thrown_, law = Callable(std::move(law))](berm_law_increment* increment) -> int {
      const py::gil_scoped_acquire held;
      try {
        const py::object answer =
            law.function()(during_call(increment->stress, 6), during_call(increment->strain, 6),
                           during_call(increment->state, static_cast<std::size_t>(increment->state_count)), increment->dt, increment->time);
        if (answer.is_none()) return berm_law_done;
        return answer.cast<bool>() ? berm_law_done : berm_law_smaller;
      } catch (...) {
        if (!*thrown) *thrown = std::current_exception();
        return berm_law_failed;
      }
    };
  }

  std::unique_ptr<berm::Run> run_;
  std::shared_ptr<std::exception_ptr> thrown_ = std::make_shared<std::exception_ptr>();  ///< also of clones, whose laws are the same
};

/// Interrupts (Ctrl-C) are looked at between batches of steps, which take a fraction of a second.
template <class Step>
bool interruptible(PythonRun& self, long long count, const Step& step)
{
  constexpr long long batch = 64;
  bool goes_on = true;
  while (count > 0 && goes_on) {
    goes_on = self.freely([&] { return step(std::min(batch, count)); });
    count -= batch;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  }
  return goes_on && !self.run().ended();
}

bool step_to_row(PythonRun& self)
{
  const bool goes_on = self.freely([&] { return self.run().step_to_row(); });
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  return goes_on;
}

void finish(PythonRun& self, const py::object& on_row)
{
  while (step_to_row(self))
    if (!on_row.is_none()) on_row(py::cast(&self));
}

py::dict row(PythonRun& self)
{
  py::dict numbers;
  const std::vector<double>& values = self.run().row();
  for (std::size_t k = 0; k < values.size(); ++k) numbers[py::str(self.run().columns()[k].name)] = values[k];
  return numbers;
}

py::dict particles(const py::object& self, const std::string& body)
{
  py::dict fields;
  for (const berm::ParticleField& field : self.cast<PythonRun&>().run().particles(body)) fields[py::str(field.name)] = view(self, field);
  return fields;
}

berm::Freedom freedom_of(const std::string& name)
{
  const std::array<std::string, 7> names = {"x", "y", "z", "rotation", "rotation_x", "rotation_y", "rotation_z"};  // as berm::Freedom
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw berm::InputError("drive: there is no degree of freedom \"" + name + "\": x, y, z, rotation, rotation_x, rotation_y, rotation_z");
  return static_cast<berm::Freedom>(found - names.begin());
}

void drive(PythonRun& self, const std::map<std::string, double>& velocity, const std::map<std::string, double>& force)
{
  for (const auto& [name, value] : force)
    if (velocity.count(name) > 0) throw berm::InputError("drive: " + name + " has a velocity and a force");
  for (const auto& [name, value] : velocity) self.run().drive_by_velocity(freedom_of(name), value);
  for (const auto& [name, value] : force) self.run().drive_by_force(freedom_of(name), value);
}

py::array_t<double> three(const double (&numbers)[3])
{
  return py::array_t<double>(3, numbers);
}

}  // namespace

PYBIND11_MODULE(engine, module)
{
  module.doc() = "Steps cases inside this process, on arrays that lie in the runs' own memory.";
  const py::module_ errors = py::module_::import("berm.errors");
  static const py::object input_error = errors.attr("InputError"), run_error = errors.attr("RunError");
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const berm::InputError& error) {
      PyErr_SetString(input_error.ptr(), error.what());
    } catch (const berm::RunError& error) {
      PyErr_SetString(run_error.ptr(), error.what());
    }
  });

  add_macro_element(module);
  module.def("version", &berm::version, "Version of the library that is loaded.");

  py::class_<berm::RigidBodyNow>(module, "RigidBody", "A rigid body at a time; vectors of three numbers, z = 0 in plane strain.")
      .def_readonly("name", &berm::RigidBodyNow::name)
      .def_property_readonly(
          "centre", [](const berm::RigidBodyNow& body) { return three(body.centre); }, "m")
      .def_property_readonly(
          "displacement", [](const berm::RigidBodyNow& body) { return three(body.displacement); }, "since the start, m")
      .def_property_readonly(
          "velocity", [](const berm::RigidBodyNow& body) { return three(body.velocity); }, "m/s")
      .def_property_readonly(
          "angular_velocity", [](const berm::RigidBodyNow& body) { return three(body.angular_velocity); },
          "rad/s; in plane strain the last of the three")
      .def_property_readonly(
          "force", [](const berm::RigidBodyNow& body) { return three(body.force); }, "of the soil on it in the last step, N/m, in space N")
      .def_property_readonly(
          "torque", [](const berm::RigidBodyNow& body) { return three(body.torque); }, "the same about its centre, N, in space N m")
      .def_property_readonly(
          "impulse", [](const berm::RigidBodyNow& body) { return three(body.impulse); },
          "of the soil on it since the start, N s/m, in space N s: the difference of two readings over the time between them is the mean "
          "force")
      .def_property_readonly(
          "angular_impulse", [](const berm::RigidBodyNow& body) { return three(body.angular_impulse); },
          "the same of the torque, N s, in space N m s");

  py::class_<PythonRun>(module, "Run", "One run in the hands of its caller; a process may have several of one thread each.")
      .def(
          py::init<const Path&, const py::dict&, const Path&, bool, int, const py::dict&, const py::object&, const Path&>(), "case"_a = "",
          py::kw_only(), "set"_a = py::dict(), "folder"_a = "", "replace"_a = false, "threads"_a = 1, "laws"_a = py::dict(),
          "message"_a = py::none(), "resume"_a = "",
          "Reads and builds the case (or goes to the last checkpoint of the run in the folder `resume`), and finds its start.\n\n"
          "set: changes to the case. folder: where results go as of berm run; without it nothing is kept. laws: by the name of a material "
          "with law = \"user\", a function\n"
          "law(stress, strain, state, dt, time) that changes stress (6 numbers, Pa, tension positive) and state in place for a strain "
          "increment (engineering shear), and\n"
          "returns False to ask for smaller increments. message: gets each line that berm run would print. Throws InputError and RunError.")
      .def(
          "step",
          [](PythonRun& self, long long count) {
            if (count < 0) self.run().step(count);
            return interruptible(self, count, [&](long long part) { return self.run().step(part); });
          },
          "count"_a = 1, "Steps so often, or to the end of the last stage. Returns whether the run goes on.")
      .def("step_to_row", &step_to_row, "Steps until a row is added to the history, or to the end. Returns whether the run goes on.")
      .def("finish", &finish, "on_row"_a = py::none(), "Steps to the end; calls on_row(run) after each row.")
      .def(
          "stop", [](PythonRun& self) { self.freely([&] { self.run().stop(); }); },
          "Ends the run with results and a checkpoint in its folder.")
      .def(
          "clone", [](PythonRun& self, const Path& folder) { return self.clone(folder); }, "folder"_a = "",
          "A second run in the state that this one is in, which goes on by itself to the same bits, in a folder of its own; without one "
          "nothing is kept.")
      .def("drive", &drive, py::kw_only(), "velocity"_a = std::map<std::string, double>(), "force"_a = std::map<std::string, double>(),
           "Drives degrees of freedom of the body that the present stage, of kind \"drive\", drives: x, y and rotation in plane strain; x, "
           "y, z, "
           "rotation_x, "
           "rotation_y and\n"
           "rotation_z in space. velocity: m/s, rad/s. force: N/m, of a rotation N; in space N and N m. It stays until another call or the "
           "end of the "
           "stage.\n"
           "Throws InputError.")
      .def(
          "limit_time_step", [](PythonRun& self, double longest) { self.run().limit_time_step(longest); }, "longest"_a,
          "No step is longer than this from now on, s; math.inf: any that is stable.")
      .def_property_readonly("ended", [](PythonRun& self) { return self.run().ended(); })
      .def_property_readonly("finished", [](PythonRun& self) { return self.run().finished(); })
      .def_property_readonly("steps", [](PythonRun& self) { return self.run().steps(); })
      .def_property_readonly(
          "time", [](PythonRun& self) { return self.run().time(); }, "s")
      .def_property_readonly(
          "time_step", [](PythonRun& self) { return self.run().time_step(); }, "s")
      .def_property_readonly("stage", [](PythonRun& self) { return self.run().stage(); })
      .def_property_readonly("dimension", [](PythonRun& self) { return self.run().dimension(); })
      .def_property_readonly("row", &row, "Numbers of the last row of the history by the names of its columns.")
      .def_property_readonly("bodies", [](PythonRun& self) { return self.run().bodies(); })
      .def_property_readonly("rigid_bodies", [](PythonRun& self) { return self.run().rigid_bodies(); })
      .def("particles", &particles, "body"_a,
           "Fields of a body's particles on the run's own memory, read-only: arrays of shape (blocks, lanes) or (blocks, components, "
           "lanes). A lane holds a particle where\n"
           "its mass is above 0; later steps change the numbers in place and may use more blocks than an array shows.");
}
