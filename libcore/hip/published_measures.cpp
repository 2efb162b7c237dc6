// SPDX-License-Identifier: GPL-3.0-or-later
#include "hip/published_measures.hpp"

#include <array>

namespace impinge {
namespace {

constexpr PublishedMeasure mean_of(std::string_view measure, double mean, double sd, std::string_view of,
                                   std::string_view source) {
  return {measure, mean, sd, {}, {}, {}, of, source};
}

constexpr std::string_view kHack = "Hack 2010, J Bone Joint Surg Am 92(14)";
constexpr std::string_view kVolunteers = "right hips of 200 volunteers without symptoms, by MRI";
constexpr std::string_view kHartel = "Hartel 2016, PLoS One 11(3), e0149480, PMC4775021";

constexpr std::array kPublished{
    PublishedMeasure{"neck_shaft_angle", {}, {}, 122.2, 117.9, 125.6, "1,070 femora, by CT", kHartel},
    PublishedMeasure{"femoral_torsion", {}, {}, 14.2, 7.4, 20.4, "1,070 femora, by CT", kHartel},
    mean_of("alpha_at_1_30", 50.2, 8.0, kVolunteers, kHack),
    mean_of("alpha_at_3", 40.9, 7.0, kVolunteers, kHack),
    mean_of("alpha_notzli", 42.0, 2.2, "35 volunteers without symptoms, by MRI (39 patients: 74.0 +- 5.4)",
            "Notzli 2002, J Bone Joint Surg Br 84-B(4), 556"),
    mean_of("version", 17.9, 4.9,
            "404 adults, by CT: men 16.5 +- 4.4 and women 19.3 +- 5.0, half of each (pooled here)",
            "Klasan 2019, J Orthop Translat 18, 7"),
    mean_of("half_opening", 87.0, 4.0, "20 healthy hips, by CT",
            "Cobb 2010, Clin Orthop Relat Res 468(8), 2143, PMC2895857"),
    mean_of("lateral_centre_edge", 31.5, 6.1,
            "2,011 adults of 19 years, by radiograph: men 32.1 +- 6.1 and women 31.0 +- 6.1 (pooled here)",
            "Laborie 2013, Skeletal Radiol 42, 925")};

}  // namespace

PublishedMeasure published_measure(std::string_view measure) {
  for (const PublishedMeasure& one : kPublished) {
    if (one.measure == measure) return one;
  }
  return {};
}

}  // namespace impinge
