// SPDX-License-Identifier: GPL-3.0-or-later
// check_certificate FILE... BALL SOCKET [--ball-part FILE...] [--socket-part FILE...]: do certificates of
// `impinge certify` hold for these meshes (PLY or OBJ)? This is a second checker, written only from
// certificate_format.md, without any code of libcore. It prints one line per certificate; the exit code is 0
// if all hold, 1 if one does not, 2 for bad usage. Everything is decided in integers, without rounding:
// corners are relative to the centre, times a number that makes all of them whole.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iostream>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <random>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmpxx.h>

namespace {

using Integer = mpz_class;
using Fraction = mpq_class;
using Vec = std::array<Integer, 3>;
using Place = std::array<Fraction, 3>;
using Index = std::uint32_t;
using Face = std::array<Index, 3>;
using Faces = std::vector<Face>;
using Words = std::vector<std::string>;

void require(bool holds, const std::string& otherwise) {
  if (!holds) throw std::runtime_error(otherwise);
}

Vec operator+(const Vec& a, const Vec& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Vec operator-(const Vec& a, const Vec& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vec operator*(const Integer& s, const Vec& a) { return {s * a[0], s * a[1], s * a[2]}; }
Integer dot(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vec cross(const Vec& a, const Vec& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
int side(const Vec& a, const Vec& b, const Vec& c) { return sgn(dot(a, cross(b, c))); }
/// Lowest and highest side on which a line from 0 passes a face's edges; it meets the face if signs agree.
std::pair<int, int> sides(const Vec& line, const Vec& a, const Vec& b, const Vec& c) {
  return std::minmax({side(line, a, b), side(line, b, c), side(line, c, a)});
}

// ---- files ----

Words words_of(const std::string& line) {
  std::istringstream in(line);
  Words words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

Integer integer(const std::string& word) {
  const std::size_t minus = word.starts_with('-') ? 1 : 0;
  require(word.size() > minus && word.size() <= 60 &&
              word.find_first_not_of("0123456789", minus) == std::string::npos,
          "'" + word.substr(0, 60) + "' is no integer");
  return Integer(word, 10);
}

Fraction decimal(const std::string& word) {
  const auto end = std::min(word.find_first_of("eE"), word.size()), point = std::min(word.find('.'), end);
  std::string digits = word.substr(0, end), exponent = end < word.size() ? word.substr(end + 1) : "0";
  require(end <= 60 && exponent.size() <= 4, "'" + word.substr(0, 60) + "' is too long a number");
  if (point < end) digits.erase(point, 1);
  for (auto* text : {&digits, &exponent})
    if (text->starts_with('+') && !text->starts_with("+-")) text->erase(0, 1);
  const long power = integer(exponent).get_si() - static_cast<long>(point < end ? end - point - 1 : 0);
  Integer ten;
  mpz_ui_pow_ui(ten.get_mpz_t(), 10, static_cast<unsigned long>(std::abs(power)));
  return power < 0 ? Fraction(integer(digits)) / ten : Fraction(integer(digits) * ten);
}

Index count(const Fraction& number) {
  require(number.get_den() == 1 && number >= 0 && number <= 0x7fffffff, "a count or corner that can not be");
  return static_cast<Index>(number.get_num().get_ui());
}

struct Mesh {
  std::vector<Place> corners;
  Faces faces;
};

Mesh read_obj(std::istream& in) {
  Mesh mesh;
  for (std::string line; std::getline(in, line);) {
    const Words words = words_of(line.substr(0, line.find('#')) + " .");
    const auto corner = [&](std::size_t k) {
      return count(integer(words[k].substr(0, words[k].find('/'))) - 1);
    };
    require((words[0] != "v" || (words.size() > 4 && words.size() != 6)) &&
                (words[0] != "f" || words.size() == 5),
            "a face of not three corners, or a vertex of not three coordinates");
    if (words[0] == "v") mesh.corners.push_back({decimal(words[1]), decimal(words[2]), decimal(words[3])});
    if (words[0] == "f") mesh.faces.push_back({corner(1), corner(2), corner(3)});
  }
  return mesh;
}

/// The next number of a PLY file after its header.
Fraction next_number(std::istream& in, const std::string& type, const std::string& format) {
  static const std::map<std::string, int> types{
      {"char", -1},  {"uchar", 1},   {"short", -2},   {"ushort", 2},  {"int", -4},   {"uint", 4},
      {"float", 14}, {"double", 18}, {"int8", -1},    {"uint8", 1},   {"int16", -2}, {"uint16", 2},
      {"int32", -4}, {"uint32", 4},  {"float32", 14}, {"float64", 18}};
  require(types.contains(type), "unknown type of a number");
  const int kind = types.at(type),
            bytes = std::abs(kind) % 10;  // negative with a sign, above 10 with a point
  std::string word;
  if (format == "ascii") return in >> word, decimal(word);
  word.resize(static_cast<std::size_t>(bytes));
  require(bool(in.read(word.data(), bytes)), "the file ends early");
  if (format == "binary_little_endian") std::reverse(word.begin(), word.end());
  std::uint64_t bits = kind < 0 && word[0] < 0 ? ~std::uint64_t{0} : 0;
  for (const char byte : word) bits = bits << 8 | static_cast<unsigned char>(byte);
  if (kind < 10) return static_cast<double>(static_cast<std::int64_t>(bits));  // exact: 32 bits
  const double value =
      bytes == 8 ? std::bit_cast<double>(bits) : double{std::bit_cast<float>(static_cast<Index>(bits))};
  require(std::isfinite(value), "a number is not finite");
  return value;
}

Mesh read_ply(std::istream& in) {
  std::vector<Words>
      elements;  // name, count, and of each property: type of a list's length or "", type, name
  std::string line, format;
  while (std::getline(in, line) && words_of(line) != Words{"end_header"}) {
    const Words words = words_of(line + " .");
    if (words[0] == "format") format = words[1];
    if (words[0] == "element" && words.size() == 4) elements.push_back({words[1], words[2]});
    if (words[0] != "property" || elements.empty() || words.size() < 4) continue;
    const auto last = words.size() - 2;
    elements.back().insert(elements.back().end(),
                           {words.size() == 6 ? words[2] : "", words[last - 1], words[last]});
  }
  require(in && (format == "ascii" || format == "binary_little_endian" || format == "binary_big_endian"),
          "no PLY");
  Mesh mesh;
  for (const Words& e : elements) {
    require(e.size() > 2 && e[0] != "tristrips", "an element without numbers, or of strips");
    std::map<std::string, std::vector<Fraction>> row;
    std::vector<std::vector<Fraction>*> columns;
    for (std::size_t p = 4; p < e.size(); p += 3)
      columns.push_back(&row[e[p] == "vertex_index" ? "vertex_indices" : e[p]]);
    const auto &x = row["x"], &y = row["y"], &z = row["z"], &f = row["vertex_indices"];
    for (Integer left = integer(e[1]); left > 0; --left) {
      for (auto* column : columns) column->clear();
      for (std::size_t p = 2; p < e.size(); p += 3)
        for (Index k = e[p].empty() ? 1 : count(next_number(in, e[p], format)); k > 0; --k)
          columns[p / 3]->push_back(next_number(in, e[p + 1], format));
      require(e[0] != "face" || f.size() == 3, "a face has not three corners");
      require(e[0] != "vertex" || (x.size() == 1 && y.size() == 1 && z.size() == 1),
              "a vertex has not x, y and z");
      if (e[0] == "face") mesh.faces.push_back({count(f[0]), count(f[1]), count(f[2])});
      if (e[0] == "vertex") mesh.corners.push_back({x[0], y[0], z[0]});
    }
  }
  require((format == "ascii" ? in >> std::ws : in).peek() == EOF, "it goes on after its last element");
  return mesh;
}

// ---- bodies ----

struct Body {
  std::vector<Vec> corners;  ///< each once, times scale
  Integer scale = 1;
  Faces faces;
  std::vector<Faces>
      closed;  ///< of each file, each face once, none with two equal corners; empty if it is open
  std::vector<Index> pieces;     ///< the first corner of each
  std::vector<Vec> rest, moved;  ///< corners from the centre, each times one number of both bodies
};

bool two_equal(const Face& f) { return f[0] == f[1] || f[1] == f[2] || f[2] == f[0]; }

/// These faces as a closed file, or none.
Faces closed(const Faces& all) {
  std::set<Face> once;
  std::set<std::pair<Index, Index>> odd;  // edges
  for (Face f : all) {
    std::sort(f.begin(), f.end());
    if (two_equal(f) || !once.insert(f).second) continue;
    for (const auto& edge : {std::pair{f[0], f[1]}, {f[1], f[2]}, {f[0], f[2]}})
      if (!odd.insert(edge).second) odd.erase(edge);
  }
  return odd.empty() ? Faces(once.begin(), once.end()) : Faces{};
}

std::vector<Index> first_of_pieces(const Body& body) {
  std::vector<Index> up(body.corners.size()), firsts;
  std::iota(up.begin(), up.end(), 0U);
  const auto root = [&](Index v) {
    while (up[v] != v) v = up[v] = up[up[v]];
    return v;
  };
  for (const Face& f : body.faces)
    for (const Index v : f) up[root(v)] = root(f[0]);
  std::set<Index> seen;
  for (const Face& f : body.faces)
    if (seen.insert(root(f[0])).second) firsts.push_back(f[0]);
  return firsts;
}

Body read_body(const Words& names) {
  std::vector<Mesh> meshes;
  Body body;
  for (const auto& name : names) try {
      std::ifstream in(name, std::ios::binary);
      if (!in) throw std::invalid_argument(name + " cannot be read");
      meshes.push_back(name.ends_with(".obj") || name.ends_with(".OBJ") ? read_obj(in) : read_ply(in));
      require(!meshes.back().faces.empty(), "it has no faces");
      for (const Place& x : meshes.back().corners)
        for (const Fraction& value : x) body.scale = lcm(body.scale, value.get_den());
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(name + ": " + error.what());
    }
  std::map<Vec, Index> numbers;
  for (const auto& [corners, faces] : meshes) {
    std::vector<Index> number;
    for (const Place& x : corners) {
      Vec whole;
      for (std::size_t k = 0; k < 3; ++k) whole[k] = body.scale / x[k].get_den() * x[k].get_num();
      number.push_back(numbers.try_emplace(whole, numbers.size()).first->second);
      if (number.back() == body.corners.size()) body.corners.push_back(whole);
    }
    Faces all = faces;
    for (Face& f : all)
      for (Index& v : f) require(v < number.size(), "a face has a corner that is not there"), v = number[v];
    body.closed.push_back(closed(all));
    body.faces.insert(body.faces.end(), all.begin(), all.end());
  }
  body.pieces = first_of_pieces(body);
  return body;
}

constexpr auto kNotTold = "a point is on a surface, or each ray from it meets an edge";

/// Does a ray from p that meets no edge cross an odd number of these faces? None if it is not told.
std::optional<bool> is_odd(const Body& body, const Faces& faces, const Vec& p) {
  std::mt19937 random(1);  // NOLINT(*-msc51-cpp): the same each time
  Vec along{0, 0, 1};
  for (int ray = 0; ray < 20; ++ray) {
    bool odd = false, edge = false;
    for (const Face& f : faces) {
      const Vec &a = body.moved[f[0]], &b = body.moved[f[1]], &c = body.moved[f[2]];
      bool beside = false;  // the first ray
      for (std::size_t k = 0; k < 2 && ray == 0; ++k)
        beside = beside || (a[k] < p[k] && b[k] < p[k] && c[k] < p[k]) ||
                 (a[k] > p[k] && b[k] > p[k] && c[k] > p[k]);
      if (beside) continue;
      const auto [least, most] = sides(along, a - p, b - p, c - p);
      if (least < 0 && most > 0) continue;
      const int ahead = side(a - p, b - p, c - p);
      edge = edge || least != most || least == 0 || ahead == 0;
      odd ^= ahead == least;
    }
    if (!edge) return odd;
    for (Integer& x : along) x = static_cast<int>(random() % 4001) - 2000;
  }
  return {};
}

/// Is a piece of one body inside a closed file of the other?
bool one_inside(const Body& ball, const Body& socket) {
  const Faces& first = socket.closed[0];
  const auto bone_outside = is_odd(socket, first, {0, 0, 0});
  require(bone_outside.has_value(), kNotTold);
  bool told = true;
  for (const auto& [body, other] : {std::pair{&ball, &socket}, {&socket, &ball}})
    for (const Index v : body->pieces)
      for (const Faces& file : other->closed) {
        const auto odd = is_odd(*other, file, body->moved[v]);
        if (odd && *odd != (*bone_outside && &file == &first)) return true;
        told = told && odd.has_value();
      }
  require(told, kNotTold);
  return false;
}

/// Does an edge of a face meet another face, without lying in its plane?
bool edge_meets(const Body& edges, const Face& of, const Body& faces, const Face& f) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec &p = edges.moved[of[k]], along = edges.moved[of[(k + 1) % 3]] - p;
    const Vec a = faces.moved[f[0]] - p, b = faces.moved[f[1]] - p, c = faces.moved[f[2]] - p;
    const int from = side(a, b, c), to = side(a - along, b - along, c - along);
    const auto [least, most] = sides(along, a, b, c);
    if (from * to <= 0 && from != to && (least >= 0 || most <= 0)) return true;
  }
  return false;
}

// ---- the motion and the tree ----

struct Quaternion {
  Integer w;
  Vec v;
};
Quaternion operator*(const Quaternion& a, const Quaternion& b) {
  return {a.w * b.w - dot(a.v, b.v), a.w * b.v + b.w * a.v + cross(a.v, b.v)};
}
Integer norm(const Quaternion& q) { return q.w * q.w + dot(q.v, q.v); }
Quaternion inverse(const Quaternion& q) { return {q.w, Integer(-1) * q.v}; }
/// x in the rotation of q, times norm(q).
Vec turned(const Quaternion& q, const Vec& x) { return (q * Quaternion{0, x} * inverse(q)).v; }

struct HalfAngle {
  Integer c, s;
};
/// Sine of half the turn from a to b, times a positive number.
Integer sine(const HalfAngle& a, const HalfAngle& b) { return a.c * b.s - a.s * b.c; }

struct Plane {
  Vec n;  ///< sides by n.x - d
  Integer d;
};

int far_side(const Plane& plane, const Vec& x) {
  static Integer sum;  // static, so that its memory is used again
  sum = -plane.d;
  for (std::size_t k = 0; k < 3; ++k) mpz_addmul(sum.get_mpz_t(), plane.n[k].get_mpz_t(), x[k].get_mpz_t());
  return sgn(sum);
}

struct Node {
  HalfAngle from, to;
  Faces ball, socket;
};

/// Does a face belong to the first and to the second part of a cut?
using Cut = std::pair<bool, bool>;

template <class Sort>
void cut(const Faces& faces, Sort sort, Faces& first, Faces& second) {
  Faces one, two;
  for (const Face& f : faces) {
    const Cut parts = sort(f);
    if (parts.first) one.push_back(f);
    if (parts.second) two.push_back(f);
  }
  first.swap(one), second.swap(two);
}

/// Cuts faces by the sides of planes on which their corners lie.
auto by_planes(const Body& body, const std::vector<Plane>& planes) {
  return [&body, planes, known = std::vector<unsigned char>(body.corners.size())](const Face& f) mutable {
    unsigned both = 0;  // 1 first, 2 second
    for (const Index v : f) {
      for (std::size_t i = 0; i < planes.size() && (i > 0 || known[v] == 0); ++i) {
        const int far = far_side(planes[i], body.rest[v]);
        known[v] |= far < 0 ? 1 : far > 0 ? 2 : 3;
      }
      both |= known[v];
    }
    return Cut((both & 1) != 0, both > 1);
  };
}

/// Cuts faces by the sphere x.x = r2.
auto by_sphere(const Body& body, const Fraction& r2) {
  const Integer low = r2.get_num() / r2.get_den(), high = low + (r2.get_den() == 1 ? 0 : 1);
  const Integer three = Integer(3 * r2.get_num()) / r2.get_den();  // rounded as whole numbers need it
  return [&body, low, high, three](const Face& f) {
    const Vec &a = body.rest[f[0]], &b = body.rest[f[1]], &c = body.rest[f[2]];
    const auto square = [](const Vec& x) { return dot(x, x); };
    const auto [least, most] = std::minmax({square(a), square(b), square(c)});
    const auto longest = [&] { return std::max({square(b - a), square(c - b), square(a - c)}); };
    return Cut(least <= low || 3 * least - longest() <= three, most >= high);
  };
}

// ---- the certificate ----

class Certificate {
 public:
  Certificate(std::istream& in, Body& ball, Body& socket) : in_(in), ball_(ball), socket_(socket) {}

  /// What the certificate proves.
  std::string check() try {
    const Words kind = next("impinge", 3), files = next("files", 2), centre = next("centre", 3),
                shift = next("shift", 3);
    const bool clear = kind[3] == "clear";
    require(kind[1] == "certificate" && kind[2] == "2" && (clear || kind[3] == "contact"),
            "another kind or version");
    require(integer(files[1]) == ball_.closed.size() && integer(files[2]) == socket_.closed.size(),
            "not so many files");
    const Words outer = next("outer", 4), axis = next("axis", 3), inner = next("inner", 4);
    outer_ = {integer(outer[1]), vec(outer, 2)}, axis_ = vec(axis, 1),
    inner_ = {integer(inner[1]), vec(inner, 2)};
    require(norm(outer_) > 0 && norm(inner_) > 0 && dot(axis_, axis_) == 1,
            "a quaternion is 0, or the axis not of length 1");
    last_ = half_angle(next("last", 2)), unit_ = integer(next("unit", 1)[1]);
    require(unit_ > 0, "the unit is not above 0");
    place({decimal(centre[1]), decimal(centre[2]), decimal(centre[3])},
          {decimal(shift[1]), decimal(shift[2]), decimal(shift[3])});
    if (clear) check_tree();
    if (clear) require(!one_inside(ball_, socket_), "a piece of one body is inside the other");
    if (!clear) check_contact();
    next("end", 0);
    require(in_.peek() == EOF, "it goes on after its end");
    std::ostringstream told;
    told.precision(10);
    told << kind[3] << (last_.s == 0 ? " in a pose" : " on all of a motion");
    told << ": centre " << centre[1] << ' ' << centre[2] << ' ' << centre[3];
    told << " mm, shift " << shift[1] << ' ' << shift[2] << ' ' << shift[3] << " mm, quaternion";
    const Quaternion start = at({1, 0});
    for (const Integer& x : {start.w, start.v[0], start.v[1], start.v[2]})
      told << ' ' << x.get_d() / std::sqrt(norm(start).get_d());
    if (last_.s != 0) {
      told << ", then " << 360 / std::numbers::pi * std::atan2(last_.s.get_d(), last_.c.get_d())
           << " degrees about";
      for (const Integer& x : turned(outer_, axis_)) told << ' ' << x.get_d() / norm(outer_).get_d();
    }
    return told.str() + ", in the frame of the mesh files";
  } catch (const std::runtime_error& error) {
    throw std::runtime_error("line " + std::to_string(line_) + ": " + error.what());
  }

 private:
  Words next() {
    std::string line;
    require(bool(std::getline(in_, line)), "it ends early");
    ++line_;
    Words words = words_of(line);
    require(!words.empty(), "an empty line");
    return words;
  }
  Words next(const std::string& what, std::size_t numbers) {
    Words words = next();
    require(words[0] == what && words.size() == numbers + 1, "not '" + what + "' and what belongs to it");
    return words;
  }
  static Vec vec(const Words& words, std::size_t k) {
    return {integer(words[k]), integer(words[k + 1]), integer(words[k + 2])};
  }
  static HalfAngle half_angle(const Words& words) {
    HalfAngle h{integer(words[1]), integer(words[2])};
    require(h.s > 0 || (h.s == 0 && h.c > 0), "no half angle");
    return h;
  }
  [[nodiscard]] Quaternion at(const HalfAngle& h) const {
    return outer_ * Quaternion{h.c, h.s * axis_} * inner_;
  }

  /// Places both bodies at rest, relative to where the motion starts.
  void place(const Place& centre, const Place& shift) {
    scale_ = lcm(ball_.scale, socket_.scale);
    for (const Place* x : {&centre, &shift})
      for (const Fraction& value : *x) scale_ = lcm(scale_, value.get_den());
    const auto scaled = [&](const Place& x) {
      return Vec{Integer(x[0] * scale_), Integer(x[1] * scale_), Integer(x[2] * scale_)};
    };
    const Vec origin = scaled(centre);
    shift_ = scaled(shift);
    const Quaternion start = at({1, 0}), back = inverse(start);
    const Vec x = turned(back, {1, 0, 0}), y = turned(back, {0, 1, 0}), z = turned(back, {0, 0, 1});  // rows
    for (Body* body : {&ball_, &socket_}) {
      body->rest.clear(), body->moved.clear();
      for (const Vec& corner : body->corners) {
        const Vec r = Integer(scale_ / body->scale) * corner - origin;
        body->rest.push_back(r);
        body->moved.push_back(body == &socket_ ? norm(start) * r
                                               : Vec{dot(x, r), dot(y, r), dot(z, r)} + norm(start) * shift_);
      }
    }
  }

  /// The plane n.x = d as seen by the nine points of a face of the ball, expressed for its corners at rest.
  [[nodiscard]] std::vector<Plane> seen_at_rest(const Plane& plane, const Node& node) const {
    const Integer s = sine(node.from, node.to), c = node.from.c * node.to.c + node.from.s * node.to.s;
    require(c > 0, "a plane where the arc is not below 180 degrees");
    const Quaternion from = at(node.from), to = at(node.to);
    const Vec a = turned(inverse(from), plane.n), b = turned(inverse(to), plane.n);
    const Integer d = plane.d - dot(plane.n, shift_), ab = norm(from) * norm(to),
                  oi = norm(outer_) * norm(inner_);
    // The third is that of h + (a + b - 2 h) (1 + s^2 / c^2) / 2, times 2 c^2 ab oi; h is along the axis,
    // which I turned to e.
    const Vec ends = (c * c + s * s) * oi * (norm(to) * a + norm(from) * b);
    const Vec axis = 2 * s * s * ab * dot(plane.n, turned(outer_, axis_)) * turned(inverse(inner_), axis_);
    return {{a, norm(from) * d}, {b, norm(to) * d}, {ends - axis, 2 * c * c * ab * oi * d}};
  }

  void check_tree() {
    std::vector<Node> open{{{1, 0}, last_, ball_.faces, socket_.faces}};
    std::size_t held = ball_.faces.size() + socket_.faces.size();
    while (!open.empty()) {
      Node first = std::move(open.back());
      open.pop_back();
      held -= first.ball.size() + first.socket.size();
      const Words words = next();
      if (words == Words{"-"}) {
        require(first.ball.empty() || first.socket.empty(), "faces of both bodies are left");
        continue;
      }
      Node second = first;
      if (words[0] == "plane" && words.size() == 5) {
        const Plane plane{unit_ * vec(words, 1), scale_ * integer(words[4])};
        cut(first.ball, by_planes(ball_, seen_at_rest(plane, first)), first.ball, second.ball);
        cut(first.socket, by_planes(socket_, {plane}), first.socket, second.socket);
      } else if (words[0] == "sphere" && words.size() == 2) {
        const Integer r = scale_ * integer(words[1]);
        require(r > 0 && shift_ == Vec{0, 0, 0}, "a sphere without radius, or of a shifted ball");
        Fraction r2(r * r, unit_ * unit_);
        r2.canonicalize();
        cut(first.ball, by_sphere(ball_, r2), first.ball, second.ball);
        cut(first.socket, by_sphere(socket_, r2), first.socket, second.socket);
      } else {
        require(words[0] == "turn" && words.size() == 3, "no cut");
        first.to = second.from = half_angle(words);
        require(sine(first.from, first.to) >= 0 && sine(second.from, second.to) >= 0,
                "a turn beyond the arc");
      }
      held += first.ball.size() + first.socket.size() + second.ball.size() + second.socket.size();
      require(held < 100'000'000, "more faces at once than memory may hold");
      open.push_back(std::move(second));
      open.push_back(std::move(first));
    }
  }

  void check_contact() {
    require(last_.s == 0, "contact of a motion");
    const Words words = next();
    if (words == Words{"inside"}) return require(one_inside(ball_, socket_), "no piece is inside");
    require(words[0] == "cross" && words.size() == 3, "neither 'cross' nor 'inside'");
    const auto face = [](const Body& body, Integer left) {
      for (const Face& f : body.faces)
        if (!two_equal(f) && left-- == 0) return f;
      throw std::runtime_error("no such face");
    };
    const Face a = face(ball_, integer(words[1])), b = face(socket_, integer(words[2]));
    require(edge_meets(ball_, a, socket_, b) || edge_meets(socket_, b, ball_, a), "these faces do not cross");
  }

  std::istream& in_;
  Body &ball_, &socket_;
  Quaternion outer_, inner_;
  Vec axis_, shift_;
  HalfAngle last_;
  Integer unit_, scale_;
  int line_ = 0;
};

int run(const Words& words) {
  std::map<std::string, Words> names;
  std::string option;  // "": certificates, ball and socket
  for (const auto& word : words) word.starts_with("--") ? option = word : names[option].emplace_back(word);
  Words &files = names[""], &ball_files = names["--ball-part"], &socket_files = names["--socket-part"];
  if (files.size() < 3 || names.size() != 3)
    throw std::invalid_argument(
        "check_certificate FILE... BALL SOCKET [--ball-part FILE...] [--socket-part FILE...]");
  for (Words* of : {&socket_files, &ball_files}) of->insert(of->begin(), files.back()), files.pop_back();
  Body ball = read_body(ball_files), socket = read_body(socket_files);
  std::string meshes;
  for (const auto& [of, body] : {std::pair{&ball_files, &ball}, {&socket_files, &socket}})
    for (std::size_t i = 0; i < of->size(); ++i)
      meshes += (body == &ball ? "; ball " : "; socket ") + (*of)[i] +
                (body->closed[i].empty() ? " (open)" : " (closed)");
  int code = 0;
  for (const auto& name : files) try {
      std::ifstream in(name, std::ios::binary);
      if (!in) throw std::invalid_argument(name + " cannot be read");
      std::cout << Certificate(in, ball, socket).check() + meshes + "\n";
    } catch (const std::runtime_error& error) {
      std::cout << "not proven: " << name << ", " << error.what() << "\n";
      code = 1;
    }
  return code;
}

}  // namespace

int main(int count, char** words) {
  try {
    return run({words + 1, words + count});
  } catch (const std::invalid_argument& error) {
    std::cerr << error.what() << "\n";
    return 2;
  } catch (const std::exception& error) {
    std::cout << "not proven: " << error.what() << "\n";
    return 1;
  }
}
