// SPDX-License-Identifier: GPL-3.0-or-later
// @can     contact steps
// @links   gap peer::ode
//
// Method ode_collide: trees of boxes along the axes, by OPCODE in the Open Dynamics Engine. It asks for one
// contact and ignores its numbers. OPCODE works in float, so a verdict next to contact may differ from the
// exact one.

#include <memory>
#include <vector>

#include <ode/ode.h>

#include "methods/contact.hpp"

namespace impinge::lab {
namespace {

// The engine, alive from the first surface to the last; ODE counts how often it is begun.
struct Engine {
  Engine() { dInitODE2(0); }
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;
  ~Engine() { dCloseODE(); }
};

// ODE reads the vertices and indices in place.
class Mesh {
 public:
  explicit Mesh(const TriangleMesh& mesh) : data_(dGeomTriMeshDataCreate()) {
    for (const Vec3& v : mesh.vertices) vertices_.insert(vertices_.end(), {v.x(), v.y(), v.z()});
    for (const Face& face : mesh.faces)
      for (const VertexIndex v : face) indices_.push_back(static_cast<dTriIndex>(v));
    if (mesh.faces.size() == 1)  // OPCODE makes no tree of one face, so it is given twice
      for (std::size_t k = 0; k < 3; ++k) indices_.push_back(indices_[k]);
    dGeomTriMeshDataBuildDouble(data_, vertices_.data(), 3 * sizeof(double),
                                static_cast<int>(mesh.vertices.size()), indices_.data(),
                                static_cast<int>(indices_.size()), 3 * sizeof(dTriIndex));
    geometry_ = dCreateTriMesh(nullptr, data_, nullptr, nullptr, nullptr);
  }
  Mesh(const Mesh&) = delete;
  Mesh& operator=(const Mesh&) = delete;
  ~Mesh() {
    dGeomDestroy(geometry_);
    dGeomTriMeshDataDestroy(data_);
  }

  dGeomID geometry() const { return geometry_; }

 private:
  Engine engine_;
  std::vector<double> vertices_;
  std::vector<dTriIndex> indices_;
  dTriMeshDataID data_;
  dGeomID geometry_ = nullptr;
};

Touch ode_touch(const BallSocketPair& pair) {
  return [ball = std::make_shared<const Mesh>(pair.ball),
          socket = std::make_shared<const Mesh>(pair.socket)](const Pose& pose) {
    dMatrix3 rotation = {};  // rows of four
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column) rotation[4 * row + column] = pose.rotation(row, column);
    dGeomSetRotation(ball->geometry(), rotation);
    dGeomSetPosition(ball->geometry(), pose.translation.x(), pose.translation.y(), pose.translation.z());
    dContactGeom contact;
    constexpr int kOneContact = 1;
    return dCollide(ball->geometry(), socket->geometry(),
                    kOneContact | static_cast<int>(CONTACTS_UNIMPORTANT), &contact, sizeof(dContactGeom)) > 0;
  };
}

}  // namespace

Method ode_method() {
  Method method;
  method.contact = [](const BallSocketPair& pair) {
    ContactCase one = touch_only("ode_collide", "ODE (OPCODE), touch", 2, pair, ode_touch);
    one.few = true;
    return std::vector{one};
  };
  method.steps = [](const BallSocketPair& pair) {
    ContactCase one = touch_only("ode_collide", "ODE", 2, pair, ode_touch);
    one.few = true;
    return std::vector{one};
  };
  return method;
}

}  // namespace impinge::lab
