// SPDX-License-Identifier: GPL-3.0-or-later
// Exchanges arrays with NumPy: views without copies, and loops without Python's lock.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include "files/stopwatch.hpp"
#include "sphere/direction.hpp"

namespace impinge::python {

namespace py = pybind11;

/// Any array; copied and converted if it is not one of doubles in C order.
using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;
/// Any array; copied and converted if it is not one of unsigned 32-bit integers in C order.
using Indices = py::array_t<std::uint32_t, py::array::c_style | py::array::forcecast>;

/// Rows of numbers as an array of shape (rows, columns), or (rows,) for one column: a copy, or a read-only
/// view if `owner` keeps them alive.
template <class Number, class Row>
py::array array_of(const std::vector<Row>& rows, const py::handle& owner = {}) {
  constexpr std::size_t kColumns = sizeof(Row) / sizeof(Number);
  std::vector<std::size_t> shape{rows.size()};
  if (kColumns > 1) shape.push_back(kColumns);
  py::array array(py::dtype::of<Number>(), shape, reinterpret_cast<const Number*>(rows.data()), owner);
  if (owner) py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

/// The points in an array of shape (n, 3) or (3,), one per row.
inline std::span<const Vec3> points_of(const Doubles& array) {
  static_assert(sizeof(Vec3) == 3 * sizeof(double));
  return {reinterpret_cast<const Vec3*>(array.data()), static_cast<std::size_t>(array.size()) / 3};
}

/// A point or vector as a tuple of three numbers.
inline py::tuple point_tuple(const Vec3& x) { return py::make_tuple(x.x(), x.y(), x.z()); }

/// Issues a line as a UserWarning; nothing if it is empty.
inline void warn(const std::string& line) {
  if (!line.empty() && PyErr_WarnEx(PyExc_UserWarning, line.c_str(), 1) != 0) throw py::error_already_set();
}

/// Checks about every 0.1 s whether the user has interrupted, and throws py::error_already_set if so. look()
/// must be called without Python's lock.
class InterruptWatch {
 public:
  void look() {
    constexpr double kPatience = 100.0;  // ms
    if ((worked_ms_ += watch_.lap_ms()) < kPatience) return;
    worked_ms_ = 0.0;
    const py::gil_scoped_acquire held;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  }

 private:
  Stopwatch watch_;
  double worked_ms_ = 0.0;
};

/// Calls work(k) for all k below `count` without Python's lock. It can be interrupted, see InterruptWatch.
template <class Work>
void without_lock(std::size_t count, const Work& work) {
  const py::gil_scoped_release released;
  InterruptWatch watch;
  for (std::size_t k = 0; k < count; ++k) {
    work(k);
    watch.look();
  }
}

}  // namespace impinge::python
