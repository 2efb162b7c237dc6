// SPDX-License-Identifier: GPL-3.0-or-later
// The class Joint and its surfaces.
#include <algorithm>
#include <limits>

#include <pybind11/stl.h>

#include "joint/joint_document.hpp"
#include "python/arrays.hpp"
#include "python/joint_class.hpp"
#include "python/question_method.hpp"

namespace impinge::python {
namespace {

// Read access to one of the two surfaces as it was put together, which no shift of the ball replaces.
struct SurfaceView {
  SharedJoint joint;
  Surface of;
  const TriangleMesh& mesh() const { return joint->joint().bone(of).mesh; }
};

void bind_surface(py::module_& module) {
  py::class_<SurfaceView>(module, "Surface", "The mesh of the ball or of the socket, about Joint.centre.")
      .def_property_readonly(
          "vertices",
          [](const py::object& self) {
            return array_of<double>(self.cast<const SurfaceView&>().mesh().vertices, self);
          },
          "Shape (n, 3), mm, about Joint.centre.")
      .def_property_readonly(
          "faces",
          [](const py::object& self) {
            return array_of<std::uint32_t>(self.cast<const SurfaceView&>().mesh().faces, self);
          },
          "Shape (m, 3), places of the corners, as the mesh has them.")
      .def_property_readonly(
          "areas", [](const SurfaceView& view) { return array_of<double>(vertex_areas(view.mesh())); },
          "Shape (n,), mm^2 of the surface that belong to each vertex.")
      .def_property_readonly(
          "clock",
          [](const SurfaceView& view) {
            const auto& at = view.mesh().vertices;
            py::array_t<double> hours(static_cast<py::ssize_t>(at.size()));
            std::transform(at.begin(), at.end(), hours.mutable_data(), [&](const Vec3& x) {
              return view.joint->joint().hours(x).value_or(std::numeric_limits<double>::quiet_NaN());
            });
            return hours;
          },
          "Shape (n,), hours of each vertex on the clock of the socket's rim, as scanned; NaN without one.");
}

std::string described(const PoseJoint& joint) {
  return "<impinge.Joint of " + std::to_string(joint.joint().mesh(Surface::ball).vertices.size()) + " and " +
         std::to_string(joint.joint().mesh(Surface::socket).vertices.size()) + " vertices>";
}

void bind_facts(JointClass& joint) {
  const auto surface = [&joint](const char* name, Surface of) {
    joint.def_property_readonly(
        name,
        [of](const SharedJoint& self) {
          return SurfaceView{self, of};
        },
        "Its Surface.");
  };
  surface("ball", Surface::ball);
  surface("socket", Surface::socket);
  joint
      .def_property_readonly(
          "side", [](const PoseJoint& self) { return object_of(json_of(self.joint().side)); },
          "Of the body: left, right, or None.")
      .def_property_readonly(
          "axes", [](const PoseJoint& self) { return self.joint().joint.axes; },
          "Where +x, +y and +z of the meshes point, as RAS.")
      .def_property_readonly(
          "landmarks", [](const PoseJoint& self) { return object_of(json_of(self.joint().joint.frames)); },
          "A dict of degrees: pelvic_tilt_deg and the angles of the femur in the scan; None "
          "without landmarks.")
      .def_property_readonly(
          "summary",
          [](const PoseJoint& self) { return object_of(json_of(describe(self.joint(), self.names()))); },
          "A dict: what documents of the program have as `joint`, its meshes, parts, centre and warnings.")
      .def_property_readonly(
          "warnings", [](const PoseJoint& self) { return self.joint().joint.warnings; },
          "What may be wrong with the meshes: a list of lines.")
      .def_property_readonly(
          "centre",
          [](const PoseJoint& self) {
            const Vec3& c = self.joint().joint.centre;
            return py::array_t<double>(3, c.data());
          },
          "Shape (3,), mm, frame of the meshes: the centre of rotation.")
      .def_property_readonly(
          "fit",
          [](const PoseJoint& self) -> py::object {
            const auto& fit = self.joint().joint.fit;
            if (!fit) return py::none();
            return py::make_tuple(fit->radius, fit->rms);
          },
          "Radius and root mean square residual of the sphere that fits the ball, mm; None "
          "where the centre was given.")
      .def("cartilage_of_scan", &PoseJoint::cartilage_of_scan, py::call_guard<py::gil_scoped_release>(),
           "cartilage_of_scan(self)\n--\n\n"
           "The smallest gap as scanned, mm, rounded down to 0.01: a cartilage_mm that blocks nothing there, "
           "as `--cartilage scan` takes it.")
      .def(
          "ask",
          [](const py::object& self, const std::string& question, const py::kwargs& request) {
            const py::dict questions = self.attr("_questions");
            if (questions.contains(question)) return self.attr(questions[question.c_str()])(**request);
            throw std::invalid_argument("there is no question '" + question + "'; there are " +
                                        py::str(", ").attr("join")(questions).cast<std::string>());
          },
          py::arg("question"),
          "ask(self, question, **request)\n--\n\n"
          "The answer of `impinge QUESTION --json` as a dict: a question by its name, its request as "
          "keywords.")
      .def("__repr__", &described);
}

}  // namespace

void bind_joint(py::module_& module) {
  bind_surface(module);
  JointClass joint(
      module, "Joint",
      "A ball-and-socket joint of two meshes. Poses are angles of shape (n, 3) or (3,) in degrees "
      "(flexion, abduction, internal rotation; 0 in the pose of the scan), a text as "
      "\"flexion=90,internal_rotation=10\", or matrices of shape (n, 4, 4) or (n, 3, 4): x' = M x in "
      "the frame of the meshes, mm.");
  bind_making(joint);
  bind_pose_answers(joint);
  bind_questions(joint);
  bind_facts(joint);
}

}  // namespace impinge::python
