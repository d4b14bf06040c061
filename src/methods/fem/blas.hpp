// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace berm::fem {

/// While it lives, the BLAS that MUMPS calls computes on one thread, whatever the environment or who embeds berm has set: with another number of threads its sums have other last digits,
/// from which increments and iterations follow. Of OpenBLAS; others are left as they are.
class OneBlasThread {
public:
  OneBlasThread();
  ~OneBlasThread();
  OneBlasThread(const OneBlasThread&) = delete;
  OneBlasThread& operator=(const OneBlasThread&) = delete;

private:
  int before_ = 1;
};

/// The kernel of the BLAS, "OpenBLAS Zen", by which last digits differ from processor to processor; "unknown" where it does not say.
std::string blas_kernel();

}  // namespace berm::fem
