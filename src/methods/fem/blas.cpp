// SPDX-License-Identifier: BSD-3-Clause
// Tests: tests/unit/fem/direct_solver_test.cpp
#include "fem/blas.hpp"

#include <dlfcn.h>

namespace berm::fem {
namespace {

/// A function of the BLAS that was loaded with this program; null where it has none of that name.
template <class Function>
Function* function(const char* name)
{
  return reinterpret_cast<Function*>(::dlsym(RTLD_DEFAULT, name));
}

int thread_count()
{
  static const auto get = function<int()>("openblas_get_num_threads");
  return get == nullptr ? 1 : get();
}

void set_thread_count(int count)
{
  static const auto set = function<void(int)>("openblas_set_num_threads");
  if (set != nullptr) set(count);
}

}  // namespace

OneBlasThread::OneBlasThread() : before_(thread_count())
{
  if (before_ > 1) set_thread_count(1);
}

OneBlasThread::~OneBlasThread()
{
  if (before_ > 1) set_thread_count(before_);
}

std::string blas_kernel()
{
  const auto name = function<char*()>("openblas_get_corename");
  return name == nullptr ? "unknown" : "OpenBLAS " + std::string(name());
}

}  // namespace berm::fem
