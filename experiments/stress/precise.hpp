// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <boost/multiprecision/mpfr.hpp>

namespace impinge::lab {

// Numbers of 200 bits: the truth where no closed form is exact in double.
using Precise = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<61>,
                                              boost::multiprecision::et_off>;

}  // namespace impinge::lab
