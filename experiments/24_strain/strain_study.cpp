// SPDX-License-Identifier: GPL-3.0-or-later
#include "24_strain/strain_study.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "24_strain/layer_contact.hpp"
#include "gap/gap_scan.hpp"
#include "hip/clock.hpp"
#include "hip/hip.hpp"
#include "hip/hip_presets.hpp"
#include "mesh/bodies.hpp"
#include "reference/closest_point.hpp"
#include "sphere/schemes/rsid.hpp"
#include "sphere/uniform_directions.hpp"
#include "table/exact_raster.hpp"

namespace impinge::lab {
namespace {

constexpr std::size_t kBins = 7;      // bins of the incidence
constexpr double kBinDegrees = 10.0;  // width of a bin
constexpr std::size_t kHours = 12;
constexpr std::size_t kMapDirections = 400;

// Largest shear at the bone, which is under the contact.
double largest_shear(const LayerContact& contact) {
  constexpr int steps = 60;
  double largest = 0.0;
  for (int k = 0; k <= steps; ++k)
    largest = std::max(largest, contact.bone_shear(1.2 * contact.contact() * k / steps));
  return largest;
}

// Displacement of the surface where the gap says that there is no strain, divided by that in the middle: at
// the end of the contact or of the overlap of the undeformed shapes, whichever is wider.
double edge(const LayerContact& contact) {
  const double overlap = std::sqrt(2.0 * contact.approach());
  return contact.sunk(std::max(overlap, contact.contact())) / contact.approach();
}

// The gaps of the socket's vertices from a table of the ball, as a user gets them.
std::vector<double> table_gaps(const TriangleMesh& ball, std::span<const Vec3> vertices, const Pose& pose,
                               double precision_deg) {
  std::vector<double> gap(vertices.size());
  scan_gaps(fill_exact(ball, Rsid::with_precision(precision_deg), Layer::farthest), vertices, pose,
            Surface::socket, gap);
  return gap;
}

// Mean angle of the ray through a point of the socket to the normals of both spheres. To first order the gap
// along the ray is the gap along the normal divided by its cosine.
double angle_of_ray(const Vec3& x, const Vec3& centre, double ball_radius) {
  const double at_socket = angle_between(x.normalized(), (x - centre).normalized());
  // The ray passes the centre of both spheres at the same distance.
  return 0.5 *
         (at_socket + std::asin(std::min(1.0, (x - centre).norm() / ball_radius * std::sin(at_socket))));
}

// Strains at one angle.
struct Incidence {
  std::vector<double> by_gap;
  double angle = 0.0;          // sum over the points
  double largest_error = 0.0;  // largest |strain by gap times cos psi - true strain|
};

struct Cartilage {
  const char* name;
  CartilageMap map;
};

CartilageMap uniform_cartilage(double thickness) { return {{Vec3::UnitZ()}, {thickness}}; }

CartilageMap cartilage_by_place(double mean, Side side) {
  const Vec3 thickest = Vec3(side == Side::right ? 0.2 : -0.2, 0.7, 0.7).normalized();
  CartilageMap map{uniform_directions(kMapDirections, 0), {}};
  for (const Vec3& u : map.directions) map.thickness.push_back(mean * (1.0 + kThicker * u.dot(thickest)));
  return map;
}

// One hour of the dial.
struct Hour {
  double area = 0.0;              // with strain by gap
  double area_by_distance = 0.0;  // with strain by distance
  double either = 0.0;            // with one of them
  double strain = 0.0;            // integrals over the area
  double strain_by_distance = 0.0;
  double most = 0.0;
  double most_by_distance = 0.0;
  double largest_difference = 0.0;
};

void add(Hour& hour, double area, double strain, double by_distance) {
  if (!(strain > 0.0) && !(by_distance > 0.0)) return;
  hour.either += area;
  if (strain > 0.0) hour.area += area;
  if (by_distance > 0.0) hour.area_by_distance += area;
  hour.strain += area * strain;
  hour.strain_by_distance += area * by_distance;
  hour.most = std::max(hour.most, strain);
  hour.most_by_distance = std::max(hour.most_by_distance, by_distance);
  hour.largest_difference = std::max(hour.largest_difference, by_distance - strain);
}

// The data for the hours of a socket in a pose. All lists have the same size.
struct Strained {
  const std::vector<Vec3>& places;
  std::vector<double> gap;       // mm, radial
  std::vector<double> distance;  // mm, Euclidean
  std::vector<double> area;      // mm^2
};

std::array<Hour, kHours> hours_of(const Strained& socket, const ClockFace& dial, const CartilageMap& map) {
  const std::vector<double> by_gap = gap_strains(socket.gap, socket.places, map);
  const std::vector<double> by_distance = gap_strains(socket.distance, socket.places, map);
  std::array<Hour, kHours> hours;
  for (std::size_t i = 0; i < by_gap.size(); ++i) {
    const auto hour = static_cast<std::size_t>(std::lround(dial.hours(socket.places[i]))) % kHours;
    add(hours[hour], socket.area[i], by_gap[i], by_distance[i]);
  }
  return hours;
}

}  // namespace

Table layer_table() {
  Table table;
  table.columns = {
      {"poisson", "1", "Poisson ratio of the layer"},
      {"thickness", "1", "of the layer, over the radius of contact"},
      {"approach", "1", "of the sphere, over a^2 / R"},
      {"area", "1", "where undeformed shapes overlap, over the area of contact"},
      {"pressure", "1", "in the middle, (lambda + 2 mu) times strain by gap over the elastic one"},
      {"force", "1", "the same of its integral"},
      {"bone_strain", "1", "compression at the bone in the middle, over strain by gap there"},
      {"surface_strain", "1", "the same at the surface"},
      {"bone_shear", "1", "largest shear strain at the bone, over strain by gap in the middle"},
      {"edge_strain", "1",
       "mean compression where the gap says none, over that in the middle: at the end of the "
       "contact or of the overlap, whichever is wider"}};
  return table;
}

void add_layer(Table& table, double poisson, double thickness) {
  // All ratios are the same for every radius of the sphere.
  const LayerContact contact({poisson, thickness}, 1.0);
  const double strain = contact.strain_by_gap(0.0);
  const double modulus = contact.aggregate_modulus();
  // For springs side by side this is the volume of the overlap over h; NaN if they are infinitely stiff.
  const double unless = poisson < 0.5 ? 1.0 : std::numeric_limits<double>::quiet_NaN();
  const double pressure = unless * modulus * strain / contact.pressure(0.0);
  const double force = unless * modulus * kPi * contact.approach() * strain / contact.force();
  table.add_row({poisson, thickness, contact.approach(), 2.0 * contact.approach(), pressure, force,
                 contact.bone_strain(0.0) / strain, contact.middle_surface_strain() / strain,
                 largest_shear(contact) / strain, edge(contact)});
}

Table incidence_table() {
  Table table;
  table.columns = {{"gap_mm", "mm", "between the surfaces, along the normal"},
                   {"cartilage_mm", "mm", "both layers, along the normal"},
                   {"from_deg", "deg", "angle between ray and normal, from here over ten degrees"},
                   {"vertices", "1", "of the socket that see it so"},
                   {"angle_deg", "deg", "their mean"},
                   {"strain", "1", "true: 1 - gap / cartilage"},
                   {"by_gap", "1", "by radial gaps, the mean"},
                   {"by_cosine", "1", "1 - gap / (cartilage cos psi), or 0, at the mean angle"},
                   {"mended_error", "1",
                    "largest |1 - radial gap cos psi / cartilage - true|: with the gap along the normal"}};
  return table;
}

void add_incidence(Table& table, const ObliqueJoint& joint) {
  const Vec3 centre(0.0, 0.0, joint.off * joint.ball_radius);
  const TriangleMesh ball = sphere(joint.ball_radius, joint.faces, centre);
  const TriangleMesh socket = sphere(joint.ball_radius + joint.gap, joint.faces, centre);
  const std::vector<double> gap = table_gaps(ball, socket.vertices, {}, joint.precision_deg);
  const double strain = 1.0 - joint.gap / joint.cartilage;
  std::array<Incidence, kBins> bins;
  for (std::size_t i = 0; i < gap.size(); ++i) {
    const Vec3& x = socket.vertices[i];
    const double angle = angle_of_ray(x, centre, joint.ball_radius);
    const auto bin = static_cast<std::size_t>(angle / (kBinDegrees * kDegree));
    if (bin >= kBins || std::isnan(gap[i])) continue;
    bins[bin].by_gap.push_back(gap_strain(gap[i], joint.cartilage));
    bins[bin].angle += angle;
    bins[bin].largest_error = std::max(
        bins[bin].largest_error, std::abs(gap_strain(gap[i] * std::cos(angle), joint.cartilage) - strain));
  }
  for (std::size_t k = 0; k < kBins; ++k) {
    const Incidence& bin = bins[k];
    if (bin.by_gap.empty()) continue;
    const auto count = static_cast<double>(bin.by_gap.size());
    const double angle = bin.angle / count;
    table.add_row({joint.gap, joint.cartilage, kBinDegrees * static_cast<double>(k), bin.by_gap.size(),
                   angle / kDegree, strain, std::reduce(bin.by_gap.begin(), bin.by_gap.end()) / count,
                   gap_strain(joint.gap / std::cos(angle), joint.cartilage), bin.largest_error});
  }
}

Table hip_strain_table() {
  Table table;
  table.columns = {{"hip", "", "name of the preset"},
                   {"pose", "", "motions, degrees"},
                   {"cartilage", "", "uniform, or by_place: thicker in front and above"},
                   {"hour", "h", "of the socket's dial, from half an hour before to half an hour after"},
                   {"area_mm2", "mm^2", "of the socket with strain by gap"},
                   {"area_by_distance_mm2", "mm^2", "the same by Euclidean distance from the ball"},
                   {"strain", "1", "by gap, mean over the area with one of the two"},
                   {"strain_by_distance", "1", "by distance, over the same area"},
                   {"largest_strain", "1", "by gap"},
                   {"largest_strain_by_distance", "1", "by distance"},
                   {"largest_difference", "1", "of a vertex, by distance less by gap"}};
  return table;
}

void add_hip_strain(Table& table, const StrainedHip& strained) {
  const HipParameters parameters = hip_preset(strained.preset);
  const Hip hip = make_hip(parameters, strained.faces);
  const Pose pose{joint_rotation(parse_motion(strained.pose), parameters.side), Vec3::Zero()};
  Strained socket{hip.socket.vertices, {}, {}, vertex_areas(hip.socket)};
  socket.gap = table_gaps(hip.ball, socket.places, pose, strained.precision_deg);
  std::vector<Vec3> turned;
  for (const Vec3& x : socket.places) turned.push_back(to_ball(pose, x));
  socket.distance = closest_distances(hip.ball, {.points = turned});
  for (std::size_t i = 0; i < turned.size(); ++i)
    if (socket.gap[i] < 0.0) socket.distance[i] = 0.0;  // inside of the ball
  const ClockFace dial = clock_face(hip.socket).value();
  for (const Cartilage& cartilage :
       {Cartilage{"uniform", uniform_cartilage(strained.cartilage)},
        Cartilage{"by_place", cartilage_by_place(strained.cartilage, parameters.side)}}) {
    const std::array<Hour, kHours> hours = hours_of(socket, dial, cartilage.map);
    for (std::size_t h = 0; h < kHours; ++h) {
      const Hour& hour = hours[h];
      if (!(hour.either > 0.0)) continue;
      table.add_row({strained.preset, strained.pose, cartilage.name, h == 0 ? kHours : h, hour.area,
                     hour.area_by_distance, hour.strain / hour.either, hour.strain_by_distance / hour.either,
                     hour.most, hour.most_by_distance, hour.largest_difference});
    }
  }
}

}  // namespace impinge::lab
