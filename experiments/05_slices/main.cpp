// SPDX-License-Identifier: GPL-3.0-or-later
// @question  How finely does CT sample a femoral head, and how finely must it be? (Section 3.5.2)
// @writes    slices slice_band_limit spectrum band_limit
// @writes-with-bones  spectrum_bones band_limit_bones
// @timing    no
// @seconds   1 4
// @links     harness real_joints spectrum
//
// The thesis' slices of a sphere; then its question put to the surfaces themselves: the power of their
// spherical harmonics by degree, and the entries that the sampling theorems ask for.

#include <utility>

#include "05_slices/spectrum_tables.hpp"
#include "harness/driver.hpp"
#include "harness/real_joints.hpp"
#include "mesh/generated_pair.hpp"
#include "spectrum/grid_radii.hpp"
#include "spectrum/power_spectrum.hpp"
#include "spectrum/slices.hpp"
#include "sphere/schemes/rsid.hpp"

namespace {

using namespace impinge;
using namespace impinge::lab;

constexpr double kRadius = 22.0;         // mm (thesis, Section 3.5.2)
constexpr double kThickness = 1.25;      // mm
constexpr double kPixel = 0.7;           // mm: 360 mm in 512 pixels; the thesis gives the 512 alone
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

// Both names end in `suffix`.
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
