// SPDX-License-Identifier: GPL-3.0-or-later
// A joint and all that says whether it touches.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "13_contact/contact_scans.hpp"
#include "contact/coherent_contact.hpp"
#include "mesh/ball_socket_pair.hpp"
#include "methods/fcl_distance.hpp"
#include "methods/touch_method.hpp"

namespace impinge::lab {

// One joint and all that answers. It stays where it is made: some of its members keep references to others.
struct ContactStage {
  explicit ContactStage(std::size_t triangles);  // of each model
  ContactStage(const ContactStage&) = delete;
  ContactStage& operator=(const ContactStage&) = delete;

  BallSocketPair pair;               // both meshes, mm
  CulledJoint culled;                // pose by pose
  CoherentContact coherent;          // from one pose to the next
  std::unique_ptr<TouchMethod> fcl;  // contact of faces
  FclDistance distance;              // of faces
  std::unique_ptr<TouchMethod> vtk;  // contact of faces
  ContactScans scans;                // all gaps
};

// Compares answers in some of the poses. std::runtime_error where the culled ones are not those of all
// vertices, those of VTK not those of FCL, or gaps of the scans too far off. The largest error of a gap, mm,
// by the method of a scan.
std::map<std::string, double> compare(ContactStage& stage, const std::vector<Pose>& poses);

}  // namespace impinge::lab
