// SPDX-License-Identifier: GPL-3.0-or-later
#include "curves/carlson.hpp"

#include <cmath>

#include <gsl/gsl_mode.h>
#include <gsl/gsl_sf_ellint.h>

#include "curves/gsl_errors.hpp"

namespace impinge {

double gsl_carlson_rf(double x, double y, double z) {
  keep_gsl_quiet();
  gsl_sf_result result;
  require_gsl(gsl_sf_ellint_RF_e(x, y, z, GSL_PREC_DOUBLE, &result), "elliptic integral R_F");
  return result.val;
}

double gsl_carlson_rd(double x, double y, double z) {
  keep_gsl_quiet();
  gsl_sf_result result;
  require_gsl(gsl_sf_ellint_RD_e(x, y, z, GSL_PREC_DOUBLE, &result), "elliptic integral R_D");
  return result.val;
}

double arc_of_growing_speed(double phi, double n) {
  const double sine = std::sin(phi);
  if (sine == 0.0) return 0.0;
  const double square = sine * sine;
  const double cosine = std::cos(phi);
  const double speed = 1.0 + n * square;
  return sine * (gsl_carlson_rf(cosine * cosine, speed, 1.0) +
                 n / 3.0 * square * gsl_carlson_rd(cosine * cosine, speed, 1.0));
}

double arc_of_falling_speed(double phi, double rest) {
  const double sine = std::sin(phi);
  if (sine == 0.0) return 0.0;
  const double square = sine * sine;
  const double cosine = std::cos(phi);
  const double m = 1.0 - rest;
  const double speed = cosine * cosine + rest * square;  // 1 - m sin^2, no cancellation
  const double carlson = gsl_carlson_rf(cosine * cosine, speed, 1.0) +
                         m / 3.0 * square * gsl_carlson_rd(cosine * cosine, 1.0, speed);
  return sine * (rest * carlson + m * cosine / std::sqrt(speed));
}

}  // namespace impinge
