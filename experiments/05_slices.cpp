// SPDX-License-Identifier: GPL-3.0-or-later
// @question  How finely does CT sample a femoral head, and how finely must it be? (Section 3.5.2)
// @writes    slices slice_band_limit spectrum band_limit
// @writes-with-bones  spectrum_bones band_limit_bones
// @timing    no
// @seconds   1 4
// @links     harness real_joints spectrum
//
// First the thesis' slices of a sphere. Then the same question for real surfaces: the power of their
// spherical harmonics by degree, and the number of entries that sampling theorems require.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "files/csv.hpp"
#include "harness/driver.hpp"
#include "harness/real_joints.hpp"
#include "mesh/generated_pair.hpp"
#include "spectrum/gauss_grid.hpp"
#include "spectrum/power_spectrum.hpp"
#include "sphere/schemes/rsid.hpp"

namespace {

using namespace impinge;
using namespace impinge::lab;

// A table of band limits: its `own` columns, the band limit, and the entries that each theorem requires,
// compared with a scheme that has reference_entries.
struct BandLimitTable {
  Table table;                        // with `own` columns first
  std::size_t reference_entries = 0;  // of the scheme that is compared
};

// A surface sampled on a Gauss grid.
struct NamedSurface {
  std::string name;           // in the results
  std::vector<double> radii;  // mm, of a Gauss grid; NaN where there is no surface
};

// A band limit must carry one of these shares of the power of degrees 1 and up, or leave out only a rest.
constexpr std::array kPowerShares{0.99, 0.999, 0.9999};

constexpr std::array kRests{0.1, 0.05, 0.02};  // mm, root mean square over the sphere

struct SpectrumTables {
  Table spectrum;         // surface, filling, degree, power, cumulative_share
  BandLimitTable limits;  // surface, filling, covered_share, asked, power_share, rest_rms_mm, band_limit ...
};

// A table with its columns and no rows; `reference` is the scheme's name.
BandLimitTable band_limit_table(std::vector<Column> own, std::string_view reference,
                                std::size_t reference_entries) {
  BandLimitTable limits;
  limits.reference_entries = reference_entries;
  limits.table.columns = std::move(own);
  for (Column column : {Column{"band_limit", "1", "L: degrees below it"},
                        {"optimal", "1", "coefficients, L^2; entries of Khalid, Kennedy and McEwen (2014)"},
                        {"mcewen_wiaux", "1", "entries of McEwen and Wiaux (2011)"},
                        {"driscoll_healy", "1", "entries of Driscoll and Healy (1994)"},
                        {"reference_entries", "1", "entries of " + std::string(reference)},
                        {"oversampling", "1", "those divided by McEwen and Wiaux's"},
                        {"nyquist_deg", "deg", "pi / L"}}) {
    limits.table.columns.push_back(std::move(column));
  }
  return limits;
}

// Adds a row for a band limit.
void add_band_limit(BandLimitTable& limits, std::vector<Cell> own, std::size_t band_limit) {
  const std::size_t exact = mcewen_wiaux_entries(band_limit);
  own.emplace_back(band_limit);
  own.emplace_back(optimal_entries(band_limit));
  own.emplace_back(exact);
  own.emplace_back(driscoll_healy_entries(band_limit));
  own.emplace_back(limits.reference_entries);
  own.emplace_back(static_cast<double>(limits.reference_entries) / static_cast<double>(exact));
  own.emplace_back(nyquist_angle_deg(band_limit));
  limits.table.add_row(std::move(own));
}

const Column kSurface{"surface", "", "what was sampled"};
const Column kFilling{"filling", "", "of holes: membrane, plate, or none where there is no hole"};

void add_surface(SpectrumTables& tables, const GaussGrid& grid, const NamedSurface& surface,
                 std::string_view filling, const std::vector<double>& filled) {
  const std::vector<double> power = power_by_degree(analyse(grid, filled));
  const std::vector<double> shares = cumulative_shares(power);
  for (std::size_t l = 0; l < power.size(); ++l)
    tables.spectrum.add_row({surface.name, filling, l, power[l], shares[l]});
  const double covered = covered_share(grid, surface.radii);
  const auto add = [&](std::string_view asked, double value, std::size_t limit) {
    add_band_limit(
        tables.limits,
        {surface.name, filling, covered, asked, value, shares[limit - 1], rms_beyond(power, limit)}, limit);
  };
  for (const double share : kPowerShares) add("power_share", share, band_limit(power, share));
  for (const double rest : kRests) add("rest_rms_mm", rest, band_limit_leaving(power, rest));
}

// A surface with holes has rows for each way to fill them; a surface without has rows for none.
SpectrumTables spectrum_tables(const GaussGrid& grid, const std::vector<NamedSurface>& surfaces,
                               std::string_view reference, std::size_t reference_entries) {
  SpectrumTables tables;
  tables.spectrum.columns = {
      kSurface,
      kFilling,
      {"degree", "1", "of the spherical harmonics"},
      {"power", "mm^2", "sum of the squared coefficients: its part of the integral over the sphere"},
      {"cumulative_share", "1", "of degrees 1 to this one in the power of degrees 1 and up"}};
  tables.limits =
      band_limit_table({kSurface,
                        kFilling,
                        {"covered_share", "1", "of the sphere in which there is a surface"},
                        {"asked", "", "what the band limit is to reach: power_share or rest_rms_mm"},
                        {"value", "1 or mm", "of what is asked"},
                        {"power_share", "1", "of the power of degrees 1 and up that is carried"},
                        {"rest_rms_mm", "mm", "root mean square over the sphere of what is not carried"}},
                       reference, reference_entries);
  for (const NamedSurface& surface : surfaces) {
    if (std::ranges::none_of(surface.radii, [](double r) { return std::isnan(r); })) {
      add_surface(tables, grid, surface, "none", surface.radii);
      continue;
    }
    for (const Filling filling : {Filling::membrane, Filling::plate})
      add_surface(tables, grid, surface, name_of(filling), fill_holes(grid, surface.radii, filling));
  }
  return tables;
}

constexpr double kRadius = 22.0;         // mm (thesis, Section 3.5.2)
constexpr double kThickness = 1.25;      // mm
constexpr double kPixel = 0.7;           // mm: 360 mm in 512 pixels; the thesis only gives the 512
constexpr std::size_t kGridLimit = 256;  // the faces of the heads are 2 degrees wide, 0.7 degrees a column
constexpr const char* kReference = "RSID at 1 degree";

std::size_t reference_entries() { return Rsid::with_precision(1.0).size(); }

void write_slices(DriverRun& run) {
  const std::vector<Slice> slices = slices_of_sphere(kRadius, kThickness);
  Result angles{"slices", "At which angles do the slices of a CT scan cut a femoral head?"};
  angles.parameters = {{"head_diameter_mm", 2.0 * kRadius}, {"thickness_mm", kThickness}};
  angles.table.columns = {{"slice", "1", "counted upwards from the middle plane; as many lie below"},
                          {"height_mm", "mm", "above the middle plane"},
                          {"phi_deg", "deg", "arccos(height / radius)"},
                          {"gap_deg", "deg", "to the slice below; empty for the middle one"}};
  for (const Slice& s : slices) {
    const Cell gap = s.index == 0 ? Cell() : Cell(s.gap / kDegree);
    angles.table.add_row({s.index, s.height, s.phi / kDegree, gap});
  }
  run.write(angles);

  Result limits{"slice_band_limit", "Which band limit do the samples of a CT scan determine?"};
  limits.parameters = angles.parameters;
  limits.parameters["pixel_mm"] = kPixel;
  BandLimitTable table = band_limit_table(
      {{"distance", "", "between samples"}, {"gap_deg", "deg", "the angle it makes at the centre"}},
      kReference, reference_entries());
  for (const auto& [name, gap] : {std::pair{"slices, middle", slices[1].gap},
                                  {"slices, last two", slices.back().gap},
                                  {"slices, across the pole", 2.0 * slices.back().phi},
                                  {"pixel", kPixel / kRadius},
                                  {"RSID, 1 degree", kDegree}}) {
    add_band_limit(table, {name, gap / kDegree}, band_limit_of_gap(gap));
  }
  limits.table = std::move(table.table);
  run.write(limits);
}

// The names of both results end in `suffix`.
void write_spectra(DriverRun& run, const std::string& suffix, const std::vector<NamedSurface>& surfaces) {
  SpectrumTables tables = spectrum_tables(GaussGrid(kGridLimit), surfaces, kReference, reference_entries());
  Result spectrum{"spectrum" + suffix, "How is the shape of a head spread over degrees?"};
  spectrum.parameters = {
      {"grid_band_limit", kGridLimit},
      {"membrane", "holes filled by a harmonic function, as steep as it likes at their edges"},
      {"plate", "holes filled with the least squared Laplacian, without a kink"}};
  Result limits{"band_limit" + suffix, "Which band limit carries the shape of a head?"};
  limits.parameters = spectrum.parameters;
  spectrum.table = std::move(tables.spectrum);
  limits.table = std::move(tables.limits.table);
  run.write(spectrum);
  run.write(limits);
}

void body(DriverRun& run) {
  write_slices(run);
  const GaussGrid grid(kGridLimit);
  std::vector<NamedSurface> heads{
      {"smooth head", sample(grid, [](const Vec3& u) { return ball_radius(u); })}};
  for (const std::size_t faces : {std::size_t{12000}, std::size_t{3000}}) {
    heads.push_back({"head of " + std::to_string(faces) + " faces",
                     grid_radii(grid, make_ball_socket_pair(faces).ball, Layer::farthest)});
  }
  write_spectra(run, "", heads);
  if (!run.bones) return;
  std::vector<NamedSurface> real;
  for (const RealJoint& joint : read_real_joints(*run.bones, run.progress))
    real.push_back({joint.subject, grid_radii(grid, joint.meshes.ball, Layer::farthest)});
  write_spectra(run, "_bones", real);
}

}  // namespace

int main(int argc, char** argv) {
  return impinge::lab::run_driver(argc, argv,
                                  {"05_slices", "Slices and spectra of a head (Section 3.5.2).",
                                   /*takes_bones=*/true},
                                  body);
}
