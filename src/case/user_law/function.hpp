// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "material/user_law.hpp"

#include <berm/law.h>

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace berm::user_law {

/// What a call says. `smaller`: the law asks for a smaller increment.
enum class Answer { done, smaller, failed };

/// What a law receives besides the increment.
struct Constants {
  std::string material;  ///< name of its table
  std::vector<Real> properties;
  int state_variables = 0;
};

/// Calls a function once. Where a tangent is asked for and the law gives none, `tangent_given` stays false.
using OwnFunction = std::function<int(berm_law_increment*)>;
Answer call(const OwnFunction& function, const Constants& constants, material::UserIncrement& increment, bool& tangent_given);

/// The interface of Abaqus' UMAT, as Fortran calls it: all by address, the length of CMNAME at the end.
extern "C" {
using UmatFunction = void (*)(double* stress, double* statev, double* ddsdde, double* sse, double* spd, double* scd, double* rpl,
                              double* ddsddt, double* drplde, double* drpldt, const double* stran, const double* dstran, const double* time,
                              const double* dtime, const double* temp, const double* dtemp, const double* predef, const double* dpred,
                              const char* cmname, const int* ndi, const int* nshr, const int* ntens, const int* nstatv, const double* props,
                              const int* nprops, const double* coords, const double* drot, double* pnewdt, const double* celent,
                              const double* dfgrd0, const double* dfgrd1, const int* noel, const int* npt, const int* layer,
                              const int* kspt, const int* kstep, const int* kinc, std::size_t length_of_cmname);
}

/// Arguments of a UMAT for which berm has no number. A law that uses one of them gives another result where it is another number.
struct Unknown {
  Real stran = 0, coords = 0, celent = 0, temp = 0, predef = 0;
  Real stretch = 1;  ///< the diagonal of DFGRD0 and DFGRD1
  int number = 0;    ///< NOEL and NPT
};

struct Umat {
  UmatFunction function = nullptr;
  Unknown unknown = {};
};

/// PNEWDT below 1 is Answer::smaller. A DDSDDE of zeros counts as none. KSTEP is 1; KINC is 1 while the time is 0, and 2 after.
Answer call(const Umat& umat, const Constants& constants, material::UserIncrement& increment, bool& tangent_given);

}  // namespace berm::user_law
